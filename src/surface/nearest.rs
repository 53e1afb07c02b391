//! The point of a surface nearest to a place in space, by looking at every triangle.

use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, TriMesh};

/// The nearest point and its distance; the first one of several. Cost O(n).
///
/// `None` if the place is not finite.
pub fn nearest_on_surface(mesh: &TriMesh<DVec3>, place: DVec3) -> Option<(BarycentricPoint, f64)> {
    let mut best: Option<(BarycentricPoint, f64)> = None;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let corners = corners.map(|v| mesh.vertices[v as usize]);
        let weights = nearest_in_triangle(corners, place);
        let point: DVec3 = corners.iter().zip(weights).map(|(&p, w)| w * p).sum();
        let distance = point.distance(place);
        if distance.is_finite() && best.is_none_or(|(_, least)| distance < least) {
            best = Some((BarycentricPoint { triangle: t as u32, weights }, distance));
        }
    }
    best
}

/// The boundary point nearest to a place: its edge `k → k+1` and the part of it, in `[0, 1)`. Cost O(m).
pub fn nearest_on_boundary(mesh: &TriMesh<DVec3>, place: DVec3) -> crate::outline::BoundaryPoint {
    let m = mesh.boundary_count as usize;
    let mut best = (f64::INFINITY, 0, 0.0);
    for k in 0..m {
        let (a, b) = (mesh.vertices[k], mesh.vertices[(k + 1) % m]);
        let along = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        let distance = a.lerp(b, along).distance_squared(place);
        if distance < best.0 {
            best = (distance, k, along);
        }
    }
    let (_, k, along) = best;
    let (k, fraction) = if along < 1.0 { (k, along) } else { ((k + 1) % m, 0.0) };
    crate::outline::BoundaryPoint { edge: k as u32, fraction }
}

/// The weights of the nearest point: of the foot on the plane if it is inside, else of the
/// nearest of the feet on the edges.
fn nearest_in_triangle([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let area = |u: DVec3, v: DVec3| (u - p).cross(v - p).dot(normal) / normal.length_squared();
    let inside = [area(b, c), area(c, a), area(a, b)];
    if inside.iter().all(|&w| w >= 0.0) {
        let sum: f64 = inside.iter().sum();
        return inside.map(|w| w / sum);
    }
    let foot = |u: DVec3, v: DVec3| {
        let t = ((p - u).dot(v - u) / (v - u).length_squared()).clamp(0.0, 1.0);
        (u.lerp(v, t).distance_squared(p), t)
    };
    let ((ab, s), (bc, t), (ca, r)) = (foot(a, b), foot(b, c), foot(c, a));
    if ab <= bc && ab <= ca {
        [1.0 - s, s, 0.0]
    } else if bc <= ca {
        [0.0, 1.0 - t, t]
    } else {
        [r, 0.0, 1.0 - r]
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn nearest_points_of_a_triangle_are_in_it_on_its_edges_and_at_its_corners() {
        let mesh = TriMesh {
            vertices: vec![DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0)],
            boundary_count: 3,
            triangles: vec![[0, 1, 2]],
            neighbours: vec![[u32::MAX; 3]],
        };
        let cases = [
            ([0.5, 0.5, 3.0], [0.5, 0.25, 0.25], 3.0),
            ([1.0, -2.0, 0.0], [0.5, 0.5, 0.0], 2.0),
            ([2.0, 2.0, 0.0], [0.0, 0.5, 0.5], 2.0_f64.sqrt()),
            ([-3.0, -4.0, 0.0], [1.0, 0.0, 0.0], 5.0),
            ([-1.0, 1.0, 0.0], [0.5, 0.0, 0.5], 1.0),
        ];
        for (place, weights, distance) in cases {
            let (found, least) = nearest_on_surface(&mesh, DVec3::from_array(place)).unwrap();
            assert!(found.weights.iter().zip(weights).all(|(a, b)| (a - b).abs() < 1e-15), "{place:?}: {found:?}");
            assert!((least - distance).abs() < 1e-15, "{place:?}: {least}");
        }
        assert!(nearest_on_surface(&mesh, DVec3::NAN).is_none());
        let on_loop = nearest_on_boundary(&mesh, DVec3::new(-1.0, 0.5, 0.0));
        assert_eq!((on_loop.edge, on_loop.fraction), (2, 0.75));
    }
}

//! The point of a triangle nearest to a point in space, and of a boundary loop nearest to a point or a ray.

use crate::geometry::{DVec2, DVec3, is_nearer, nearest_of_chain};
use crate::mesh::TriMesh;
use crate::outline::BoundaryPoint;

/// The boundary point nearest to a point: its edge `k → k+1` and the position on it, in `[0, 1)`. Cost O(m).
pub fn nearest_on_boundary(mesh: &TriMesh<DVec3>, place: DVec3) -> BoundaryPoint {
    let boundary = &mesh.vertices()[..mesh.boundary_count() as usize];
    BoundaryPoint::of_chain(nearest_of_chain(boundary.iter().copied(), place), boundary.len())
}

/// The boundary point at `along`, in `[0, 1]`, of the edge `k → k+1`.
fn boundary_point(k: usize, along: f64, m: usize) -> BoundaryPoint {
    let (k, fraction) = if along < 1.0 { (k, along) } else { ((k + 1) % m, 0.0) };
    BoundaryPoint::new(k as u32, fraction)
}

/// The boundary point that appears nearest to a ray from `origin`: the tangent of the angle between them is least.
///
/// Where the loop passes the ray several times, and more than once within the tangent `reach` of the nearest
/// passage, the passage nearest to `origin` is taken. `None` if the whole loop is behind
/// `origin`, or the ray is not finite or has no direction. Cost O(m).
pub fn nearest_on_boundary_to_ray(
    mesh: &TriMesh<DVec3>,
    origin: DVec3,
    direction: DVec3,
    reach: f64,
) -> Option<BoundaryPoint> {
    let view = ImagePlane::new(origin, direction)?;
    let m = mesh.boundary_count() as usize;
    let seen: Vec<_> = (0..m).map(|k| view.nearest(mesh.vertices()[k], mesh.vertices()[(k + 1) % m])).collect();
    let least = seen.iter().flatten().map(|seen| seen.tangent).min_by(f64::total_cmp)?;
    let tangent = |k: usize| seen[k % m].map_or(f64::INFINITY, |seen| seen.tangent);
    let is_passage = |k: usize| tangent(k) <= tangent(k + m - 1) && tangent(k) <= tangent(k + 1);
    let passages = (0..m).filter(|&k| is_passage(k)).filter_map(|k| seen[k].map(|seen| (k, seen)));
    let near = passages.filter(|(_, seen)| seen.tangent <= least + reach);
    let (k, Seen { along, .. }) = near.min_by(|(_, p), (_, q)| p.depth.total_cmp(&q.depth))?;
    Some(boundary_point(k, along, m))
}

/// The plane at depth 1 in front of an eye, with the ray as its origin.
struct ImagePlane {
    eye: DVec3,
    axes: [DVec3; 3],
}

/// A point of an edge in the image plane.
#[derive(Clone, Copy)]
struct Seen {
    /// The tangent of the angle to the ray.
    tangent: f64,
    depth: f64,
    /// The position on the edge in space, in `[0, 1]`.
    along: f64,
}

/// Edges that go behind the eye are cut off at this part of the depth of their end in front of it.
const NEAREST_DEPTH: f64 = 1e-6;

impl ImagePlane {
    fn new(eye: DVec3, direction: DVec3) -> Option<Self> {
        let ahead = direction.try_normalize().filter(|_| eye.is_finite())?;
        let (right, up) = ahead.any_orthonormal_pair();
        Some(Self { eye, axes: [right, up, ahead] })
    }

    /// The point of the edge `a → b` that appears nearest to the ray; `None` if the edge is behind the eye.
    fn nearest(&self, a: DVec3, b: DVec3) -> Option<Seen> {
        let [depth_a, depth_b] = [a, b].map(|p| (p - self.eye).dot(self.axes[2]));
        let deepest = depth_a.max(depth_b);
        if deepest.is_nan() || deepest <= 0.0 {
            return None;
        }
        // the part in front of the eye, from `start` to `end`
        let cut = NEAREST_DEPTH * deepest;
        let at_cut = (cut - depth_a) / (depth_b - depth_a);
        let (start, end) = (if depth_a < cut { at_cut } else { 0.0 }, if depth_b < cut { at_cut } else { 1.0 });
        let (p, near) = self.project(a.lerp(b, start), depth_a.max(cut));
        let (q, far) = self.project(a.lerp(b, end), depth_b.max(cut));
        let span = q - p;
        let across = (-p.dot(span) / span.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        // perspective: from the position in the image to that on the edge, whose ends are weighted by depth
        let part = across * near / (across * near + (1.0 - across) * far);
        let depth = near + part * (far - near);
        Some(Seen { tangent: p.lerp(q, across).length(), depth, along: (start + part * (end - start)).clamp(0.0, 1.0) })
    }

    fn project(&self, p: DVec3, depth: f64) -> (DVec2, f64) {
        let [right, up, _] = self.axes;
        (DVec2::new((p - self.eye).dot(right), (p - self.eye).dot(up)) / depth, depth)
    }
}

/// The weights of the nearest point: of the foot on the plane if it is inside, otherwise of the
/// nearest of the feet on the edges.
pub(super) fn nearest_in_triangle([a, b, c]: [DVec3; 3], p: DVec3) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    // not (u − p)×(v − p), which suffers more cancellation if p is far away
    let area = |u: DVec3, v: DVec3| (v - u).cross(p - u).dot(normal) / normal.length_squared();
    let inside = [area(b, c), area(c, a), area(a, b)];
    if inside.iter().all(|&w| w >= 0.0) {
        let sum: f64 = inside.iter().sum();
        return inside.map(|w| w / sum);
    }
    let foot = |u: DVec3, v: DVec3| {
        let t = ((p - u).dot(v - u) / (v - u).length_squared()).clamp(0.0, 1.0);
        (u.lerp(v, t), t)
    };
    let ((ab, s), (bc, t), (ca, r)) = (foot(a, b), foot(b, c), foot(c, a));
    if !is_nearer(bc, ab, p) && !is_nearer(ca, ab, p) {
        [1.0 - s, s, 0.0]
    } else if !is_nearer(ca, bc, p) {
        [0.0, 1.0 - t, t]
    } else {
        [r, 0.0, 1.0 - r]
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0)];

    fn mesh(vertices: Vec<DVec3>, boundary_count: u32) -> TriMesh<DVec3> {
        TriMesh::known_sound(vertices, boundary_count, vec![[0, 1, 2]], vec![[u32::MAX; 3]])
    }

    #[test]
    fn nearest_points_of_a_triangle_are_in_it_on_its_edges_and_at_its_corners() {
        let cases = [
            ([0.5, 0.5, 3.0], [0.5, 0.25, 0.25]),
            ([1.0, -2.0, 0.0], [0.5, 0.5, 0.0]),
            ([2.0, 2.0, 0.0], [0.0, 0.5, 0.5]),
            ([-3.0, -4.0, 0.0], [1.0, 0.0, 0.0]),
            ([-1.0, 1.0, 0.0], [0.5, 0.0, 0.5]),
        ];
        for (place, weights) in cases {
            let found = nearest_in_triangle(TRIANGLE, DVec3::from_array(place));
            assert!(found.iter().zip(weights).all(|(a, b)| (a - b).abs() < 1e-15), "{place:?}: {found:?}");
        }
        let on_loop = nearest_on_boundary(&mesh(TRIANGLE.to_vec(), 3), DVec3::new(-1.0, 0.5, 0.0));
        assert_eq!((on_loop.edge(), on_loop.fraction()), (2, 0.75));
    }

    #[test]
    fn from_far_away_the_nearest_boundary_point_is_the_outermost_one() {
        let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / 36.0;
        let ring: Vec<DVec3> = (0..36).map(|k| DVec3::new(angle(k).cos(), angle(k).sin(), 0.1)).collect();
        let mesh = mesh(ring.clone(), 36);
        for (edge, &vertex) in (0..).zip(&ring) {
            for distance in [1.5, 1e8, 1e16, 1e20, 1e100] {
                let found = nearest_on_boundary(&mesh, distance * vertex.with_z(0.0));
                assert_eq!((found.edge(), found.fraction()), (edge, 0.0), "{edge} from {distance:e}");
            }
        }
    }

    #[test]
    fn the_boundary_point_at_a_ray_is_the_one_that_is_seen_there() {
        let mesh = mesh(TRIANGLE.to_vec(), 3);
        let seen = |origin: [f64; 3], direction: [f64; 3]| {
            let [origin, direction] = [origin, direction].map(DVec3::from_array);
            nearest_on_boundary_to_ray(&mesh, origin, direction, 0.0)
        };
        // from above, the foot of the perpendicular
        let foot = seen([0.5, -1.0, 5.0], [0.0, 0.0, -2.0]).unwrap();
        assert_eq!((foot.edge(), foot.fraction()), (0, 0.25));
        // along the edge 0 → 1, half of the angle between its ends: tan(atan 1 / 2) is not the middle of the edge
        let eye = DVec3::new(2.0, 0.0, 2.0);
        let at = |x: f64| (DVec3::new(x, 0.0, 0.0) - eye).to_array();
        for x in [0.0, 0.3, 1.0, 1.9] {
            let point = seen(eye.to_array(), at(x)).unwrap();
            assert_eq!(point.edge(), 0, "{x}");
            assert!((point.fraction() - 0.5 * x).abs() < 1e-14, "{x}: {point:?}");
        }
        assert_eq!(seen([0.5, 0.5, 5.0], [0.0, 0.0, 1.0]), None);
        assert_eq!(seen([0.5, 0.5, 5.0], [0.0; 3]), None);
        assert_eq!(seen([f64::NAN; 3], [1.0; 3]), None);
        // an eye between the ends: only the part in front of it counts
        let half = seen([0.5, -1.0, 0.0], [1.0, 0.01, 0.0]).unwrap();
        assert_eq!(half.edge(), 1, "{half:?}");
    }

    #[test]
    fn of_two_passages_under_the_ray_the_nearer_one_is_taken() {
        // an elongated loop across the ray, its far side a little nearer to it
        let (near, far) = (1.0, -1.0);
        let corners = [[-1.0, 0.01, near], [1.0, 0.01, near], [1.0, 0.0, far], [-1.0, 0.0, far]];
        let mesh = mesh(corners.map(DVec3::from_array).to_vec(), 4);
        let picked = |reach| nearest_on_boundary_to_ray(&mesh, DVec3::new(0.1, 0.0, 9.0), -DVec3::Z, reach).unwrap();
        assert_eq!(picked(0.0).edge(), 2);
        assert_eq!(picked(0.01).edge(), 0);
        assert!((picked(0.01).fraction() - 0.55).abs() < 1e-15);
    }
}

//! A polygon in space cut into triangles, in the plane of its vector area (Newell's normal).
//!
//! A convex polygon becomes a fan; from any other, ears are cut off (Meisters 1975). A polygon
//! that crosses itself, or has no area, may have no ear: then the rest becomes a fan, whose
//! triangles are checked like all others.

use crate::geometry::{DVec2, DVec3};
use crate::mesh::polygon_triangles;

/// Sines of the smallest turn of an ear's tip; the second applies if the first leaves no ear. Vertices in the middle of
/// an edge turn by rounding only, 1e-7 to 1e-6 in files with six decimals, and would be the tips of triangles without
/// area; as an intended corner, 1e-5 is a centimeter on a kilometer.
const LEAST_TURNS: [f64; 2] = [1e-5, 1e-12];

/// Ears are cut off polygons with up to so many corners.
const MOST_EARS: usize = 1000;

/// Appends the `corners.len() − 2` triangles of a polygon with at least 3 corners. Cost O(k), O(k²) and rarely more if it is
/// not convex; of one with more than [`MOST_EARS`] corners O(k log k), if it is simple. One with a corner at no finite place
/// becomes a fan.
pub(super) fn triangulate(vertices: &[DVec3], corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    let points = projected(vertices, corners);
    let mut rest: Vec<usize> = (0..corners.len()).collect();
    if points.iter().all(|point| point.is_finite()) && !is_convex(&points) {
        if let Some(cut) = (corners.len() > MOST_EARS).then(|| polygon_triangles(&points).ok()).flatten() {
            triangles.extend(cut.into_iter().map(|triangle| triangle.map(|k| corners[k as usize])));
            return;
        }
        while rest.len() > 3 {
            let ear = |least: f64| (0..rest.len()).find(|&k| is_ear(&points, &rest, k, least));
            let Some(k) = LEAST_TURNS.into_iter().find_map(ear) else { break };
            let [a, b, c] = around(&rest, k);
            triangles.push([corners[a], corners[b], corners[c]]);
            rest.remove(k);
        }
    }
    let first = rest[0];
    triangles.extend(rest.windows(2).skip(1).map(|pair| [corners[first], corners[pair[0]], corners[pair[1]]]));
}

/// The corners in the plane orthogonal to the vector area Σ p_k × p_{k+1}, counter-clockwise.
fn projected(vertices: &[DVec3], corners: &[u32]) -> Vec<DVec2> {
    let origin = vertices[corners[0] as usize];
    let points: Vec<DVec3> = corners.iter().map(|&v| vertices[v as usize] - origin).collect();
    let next = points.iter().cycle().skip(1);
    let normal: DVec3 = points.iter().zip(next).map(|(p, q)| p.cross(*q)).sum();
    let normal = normal.try_normalize().unwrap_or(DVec3::Z);
    let (x, y) = normal.any_orthonormal_pair();
    let turned = if x.cross(y).dot(normal) > 0.0 { y } else { -y };
    points.iter().map(|p| DVec2::new(p.dot(x), p.dot(turned))).collect()
}

/// The sine of the angle between b − a and p − b: positive for a left turn.
fn turn(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let (along, on) = (b - a, p - b);
    let lengths = along.length() * on.length();
    if lengths > 0.0 { along.perp_dot(on) / lengths } else { 0.0 }
}

/// Whether every corner turns left. That includes polygons that wind twice, for which a fan is as good as any result.
fn is_convex(points: &[DVec2]) -> bool {
    let m = points.len();
    (0..m).all(|k| turn(points[k], points[(k + 1) % m], points[(k + 2) % m]) > LEAST_TURNS[0])
}

/// The corner at position `k` of the remaining polygon, between its two neighbors.
fn around(rest: &[usize], k: usize) -> [usize; 3] {
    let count = rest.len();
    [rest[(k + count - 1) % count], rest[k], rest[(k + 1) % count]]
}

/// Whether the corner turns left by more than `least`, with no other corner in its closed triangle or close to it.
fn is_ear(points: &[DVec2], rest: &[usize], k: usize, least: f64) -> bool {
    let [i, j, l] = around(rest, k);
    let [a, b, c] = [points[i], points[j], points[l]];
    let inside = |p: DVec2| [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| turn(from, to, p) >= -least);
    let other = |&&v: &&usize| ![i, j, l].contains(&v) && ![a, b, c].contains(&points[v]);
    turn(a, b, c) > least && !rest.iter().filter(other).any(|&v| inside(points[v]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(vertices: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
        let corner = |v: u32| vertices[v as usize];
        triangles.iter().map(|&[a, b, c]| 0.5 * (corner(b) - corner(a)).cross(corner(c) - corner(a)).length()).sum()
    }

    /// The points in a plane that is not parallel to any axis.
    fn lifted(points: &[[f64; 2]]) -> Vec<DVec3> {
        let (u, v) = (DVec3::new(2.0, 1.0, -2.0) / 3.0, DVec3::new(1.0, 2.0, 2.0) / 3.0);
        points.iter().map(|&[x, y]| DVec3::new(5.0, -3.0, 1.0) + x * u + y * v).collect()
    }

    #[test]
    fn triangles_cover_the_polygon_and_nothing_else() {
        let square = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let arrow = vec![[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
        let comb: Vec<[f64; 2]> = (0..20).map(|k| [f64::from(k), f64::from(k % 2) * 3.0 + 1.0]).collect();
        let comb: Vec<_> = [[0.0, 0.0]].into_iter().chain([[19.0, 0.0]]).chain(comb.into_iter().rev()).collect();
        for (polygon, expected) in [(square, 1.0), (arrow, 9.0), (comb, 2.5 * 19.0)] {
            for reversed in [false, true] {
                let mut vertices = lifted(&polygon);
                if reversed {
                    vertices.reverse();
                }
                let corners: Vec<u32> = (0..vertices.len() as u32).collect();
                let mut triangles = Vec::new();
                triangulate(&vertices, &corners, &mut triangles);
                assert_eq!(triangles.len(), corners.len() - 2);
                let found = area(&vertices, &triangles);
                assert!((found - expected).abs() < 1e-12 * expected, "{found} for {expected}");
            }
        }
    }

    #[test]
    fn a_corner_in_the_middle_of_an_edge_gives_no_triangle_without_area() {
        let corners = [0, 1, 2, 3, 4, 5, 6];
        for step in 0..200 {
            let rotation = glam::DQuat::from_euler(
                glam::EulerRot::XYZ,
                0.1 + 0.37 * f64::from(step),
                0.61 * f64::from(step),
                0.23 * f64::from(step),
            );
            let flat = [[0.0, 0.0], [0.3, 0.1], [0.9, 0.3], [2.4, 0.8], [2.0, 2.0], [1.0, 5.0 / 3.0], [-0.4, 1.2]];
            let exact: Vec<DVec3> = flat.iter().map(|&[x, y]| rotation * DVec3::new(x, y, 0.0)).collect();
            let in_file = exact.iter().map(|p| (p * 1e6).round() / 1e6).collect();
            for (vertices, rounding) in [(exact, 1e-12), (in_file, 1e-5)] {
                let mut triangles = Vec::new();
                triangulate(&vertices, &corners, &mut triangles);
                let least = triangles.iter().map(|&t| area(&vertices, &[t])).fold(f64::INFINITY, f64::min);
                let whole = area(&vertices, &triangles);
                assert!(
                    least > 1e-3 && (whole - 3.2).abs() < rounding,
                    "turn {step}: {least} of {whole}: {triangles:?}"
                );
            }
        }
    }

    #[test]
    fn polygons_have_any_number_of_corners() {
        let count = 2 * MOST_EARS as u32;
        let star = |k: u32| {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count);
            (if k.is_multiple_of(2) { 1.0 } else { 0.9 }) * DVec2::from_angle(angle)
        };
        let star: Vec<DVec2> = (0..count).map(star).collect();
        let expected: f64 = star.iter().zip(star.iter().cycle().skip(1)).map(|(p, q)| 0.5 * p.perp_dot(*q)).sum();
        let vertices = lifted(&star.iter().map(DVec2::to_array).collect::<Vec<_>>());
        let corners: Vec<u32> = (0..count).collect();
        let mut triangles = Vec::new();
        triangulate(&vertices, &corners, &mut triangles);
        assert_eq!(triangles.len(), corners.len() - 2);
        assert!((area(&vertices, &triangles) - expected).abs() < 1e-9, "{}", area(&vertices, &triangles));
    }

    #[test]
    fn a_polygon_without_area_still_gives_its_triangles() {
        let vertices = vec![DVec3::ZERO; 6];
        let mut triangles = Vec::new();
        triangulate(&vertices, &[0, 1, 2, 3, 4, 5], &mut triangles);
        assert_eq!(triangles.len(), 4);
    }
}

//! Filling holes: a fan around a new vertex in the middle of the loop; a loop of three becomes a triangle.
//!
//! Where a triangle of the fan would be flat or lie upside down, as in a hole that is not star-shaped, the loop's own
//! vertices are joined. A loop that is a simple polygon seen along its normal has the Delaunay triangulation of that
//! polygon (`flat_filling`), whatever its size. Any other one has, of the triangulations without flat or reversed triangles,
//! that whose triangles are nearest to equilateral (dynamic programming, as in Barequet and Sharir 1995), if it is not too
//! long for that. A loop that bounds no area, such as a slit whose vertices lie in a line, has no filling: that is an error
//! which names it.

use super::TopologyError;
use super::edges::ends;
use super::flat_filling::flat_filling;
use super::repair::{ADDED, RepairNote, Repaired};
use super::survey::{is_flat, report};
use crate::geometry::DVec3;

/// The most vertices of a loop that are joined by dynamic programming: at 512 it takes 22 million steps. Longer ones that
/// are no simple polygon from any side have a fan.
const MOST_JOINED: usize = 512;

/// Fills all `loops` but the first one. The new triangles come last. Errors: a loop that bounds no area.
pub(super) fn fill_holes(repaired: &mut Repaired, loops: &[Vec<u32>]) -> Result<(), TopologyError> {
    let Some(holes) = loops.get(1..).filter(|holes| !holes.is_empty()) else { return Ok(()) };
    let reports = holes.iter().map(|hole| report(&repaired.surface, hole)).collect();
    let before = repaired.surface.triangles.len();
    let (mut edges, mut flat) = (None, Vec::new());
    for hole in holes {
        if !fill(repaired, hole, &mut edges) {
            flat.push(hole);
        }
    }
    if let Some(hole) = flat.first() {
        let hole = report(&repaired.surface, hole);
        return Err(TopologyError::FlatHole { hole, count: flat.len() });
    }
    let triangles = repaired.surface.triangles.len() - before;
    repaired.triangle_origins.resize(before + triangles, ADDED);
    repaired.notes.push(RepairNote::FilledHoles { holes: reports, triangles });
    Ok(())
}

/// Fills one hole; false if it has no filling. The loop has the direction of its triangles, so the new triangles traverse
/// it backwards. `edges` are those of the surface, sorted, once they are needed.
fn fill(repaired: &mut Repaired, hole: &[u32], edges: &mut Option<Vec<[u32; 2]>>) -> bool {
    let places: Vec<DVec3> = hole.iter().map(|&v| repaired.surface.vertices[v as usize]).collect();
    let n = hole.len();
    let middle = places.iter().sum::<DVec3>() / n as f64;
    let fan: Vec<[DVec3; 3]> = (0..n).map(|k| [places[(k + 1) % n], places[k], middle]).collect();
    let normal: DVec3 = fan.iter().map(|&triangle| double_area(triangle)).sum();
    let is_upright = |triangle| !is_flat(triangle) && double_area(triangle).dot(normal) > 0.0;
    if let (&[a, b, c], &[p, q, r]) = (hole, places.as_slice()) {
        let is_sound = !is_flat([r, q, p]);
        if is_sound {
            repaired.surface.triangles.push([c, b, a]);
        }
        return is_sound;
    }
    if !fan.iter().all(|&triangle| is_upright(triangle)) {
        let edges = edges.get_or_insert_with(|| sorted_edges(&repaired.surface.triangles));
        let is_edge = |i: usize, j: usize| {
            let edge = [hole[i].min(hole[j]), hole[i].max(hole[j])];
            edges.binary_search(&edge).is_ok()
        };
        if let Some(filling) = flat_filling(&places, normal, &is_edge) {
            let first = repaired.surface.vertices.len() as u32;
            let number = |k: usize| if k < n { hole[k] } else { first + (k - n) as u32 };
            repaired.surface.triangles.extend(filling.triangles.iter().map(|corners| corners.map(number)));
            repaired.vertex_origins.resize(repaired.vertex_origins.len() + filling.added.len(), ADDED);
            repaired.surface.vertices.extend(filling.added);
            return true;
        }
        let is_fan_flat = fan.iter().any(|&triangle| is_flat(triangle));
        let joined = joined(&places, &is_upright, &is_edge);
        // a loop that is far from a plane has no upright side
        let joined = joined.or_else(|| self::joined(&places, &|t| is_fan_flat && !is_flat(t), &is_edge));
        match joined {
            Some(triangles) => {
                repaired.surface.triangles.extend(triangles.into_iter().map(|corners| corners.map(|k| hole[k])));
                return true;
            }
            None if is_fan_flat => return false,
            None => {}
        }
    }
    let number = repaired.surface.vertices.len() as u32;
    repaired.surface.vertices.push(middle);
    repaired.vertex_origins.push(ADDED);
    repaired.surface.triangles.extend((0..n).map(|k| [hole[(k + 1) % n], hole[k], number]));
    true
}

fn double_area([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// All edges, the smaller vertex first, in order.
fn sorted_edges(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let halves = 0..3 * triangles.len() as u32;
    let mut edges: Vec<[u32; 2]> =
        halves.map(|half| ends(triangles, half)).map(|[u, v]| [u.min(v), u.max(v)]).collect();
    edges.sort_unstable();
    edges
}

/// The triangulation of a closed chain, without other vertices, against its direction: all triangles are `allowed`, no
/// chord is an edge of the surface already, and the sum of [`stretch`] is least. `None` if there is none, or the chain is
/// long. Cost O(n³).
fn joined(
    places: &[DVec3],
    allowed: &dyn Fn([DVec3; 3]) -> bool,
    is_edge: &dyn Fn(usize, usize) -> bool,
) -> Option<Vec<[usize; 3]>> {
    let n = places.len();
    if n > MOST_JOINED {
        return None;
    }
    let corners = |i: usize, k: usize, j: usize| [places[j], places[k], places[i]];
    // the least cost of the part from i to j, and the third corner of the triangle at its chord
    let mut best = vec![(0.0_f64, 0_usize); n * n];
    for length in 2..n {
        for i in 0..n - length {
            let j = i + length;
            let is_chord = length < n - 1;
            best[i * n + j] = (f64::INFINITY, 0);
            if is_chord && is_edge(i, j) {
                continue;
            }
            for k in i + 1..j {
                let parts = best[i * n + k].0 + best[k * n + j].0;
                if parts < best[i * n + j].0 && allowed(corners(i, k, j)) {
                    let cost = parts + stretch(corners(i, k, j));
                    if cost < best[i * n + j].0 {
                        best[i * n + j] = (cost, k);
                    }
                }
            }
        }
    }
    if !best[n - 1].0.is_finite() {
        return None;
    }
    let (mut triangles, mut parts) = (Vec::with_capacity(n - 2), vec![(0, n - 1)]);
    while let Some((i, j)) = parts.pop() {
        if j > i + 1 {
            let k = best[i * n + j].1;
            triangles.push([j, k, i]);
            parts.extend([(i, k), (k, j)]);
        }
    }
    Some(triangles)
}

/// The sum of the squared edges over the area: least for equilateral triangles.
fn stretch([a, b, c]: [DVec3; 3]) -> f64 {
    (a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a)) / double_area([a, b, c]).length()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::surface::{Surface, SurfaceMesh};

    /// Cells of a grid of 7 × 7 in the plane without some, whose corners are `place` of their integers.
    fn without(cells: &[[u32; 2]], place: impl Fn(u32, u32) -> DVec3) -> Surface {
        let vertices = (0..64).map(|v| place(v % 8, v / 8)).collect();
        let kept = (0..49).map(|cell| [cell % 7, cell / 7]).filter(|cell| !cells.contains(cell));
        let triangles = kept.flat_map(|[i, j]| {
            let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| 8 * j + i);
            [[a, b, c], [a, c, d]]
        });
        Surface::new(vertices, triangles.collect())
    }

    fn flat_place(i: u32, j: u32) -> DVec3 {
        DVec3::new(f64::from(i), f64::from(j), 0.0)
    }

    /// The areas of the triangles that fill holes, with the sign of the plane's orientation.
    fn filled(surface: &Surface) -> Vec<f64> {
        let mesh = SurfaceMesh::repaired(surface).unwrap();
        let (given, mesh) = (mesh.given_triangles().len(), mesh.mesh());
        let corners = mesh.triangles()[given..].iter().map(|t| t.map(|v| mesh.vertices()[v as usize]));
        corners.map(|corners| 0.5 * double_area(corners).z).collect()
    }

    #[test]
    fn a_hole_that_is_not_star_shaped_is_filled_without_reversed_triangles() {
        let u_shape = [[2, 2], [2, 3], [2, 4], [3, 2], [4, 2], [4, 3], [4, 4]];
        let areas = filled(&without(&u_shape, flat_place));
        assert!(areas.iter().all(|&area| area > 1e-9), "{areas:?}");
        let sum: f64 = areas.iter().sum();
        assert!((sum - 7.0).abs() < 1e-12, "{sum}");
    }

    #[test]
    fn a_star_shaped_hole_has_a_fan() {
        let areas = filled(&without(&[[2, 2], [3, 2], [2, 3]], flat_place));
        let sum: f64 = areas.iter().sum();
        assert!(areas.len() == 8 && (sum - 3.0).abs() < 1e-12, "{areas:?}");
    }

    /// A cell pressed flat: its four corners lie in a line, two of them in this order.
    fn pressed(order: [f64; 2]) -> Surface {
        without(&[[2, 2]], move |i, j| {
            let on_line = |s: f64| DVec3::new(2.0 + s, 2.0 + 0.3 * s, 0.0);
            match (i, j) {
                (3, 2) => on_line(1.0),
                (2, 3) => on_line(order[0]),
                (3, 3) => on_line(order[1]),
                _ => flat_place(i, j),
            }
        })
    }

    #[test]
    fn a_hole_without_area_is_joined_or_refused_by_name() {
        assert!(SurfaceMesh::repaired(&pressed([0.3, 0.7])).is_ok());
        let Err(TopologyError::FlatHole { hole, count }) = SurfaceMesh::repaired(&pressed([0.7, 0.3])) else {
            panic!("it was filled")
        };
        assert_eq!((hole.vertices, count), (4, 1));
        assert!([18, 19, 26, 27].contains(&hole.first.index()), "{hole:?}");
    }

    #[test]
    fn a_crack_of_three_vertices_in_a_line_is_joined() {
        let mut surface = without(&[], flat_place);
        // the triangle below the edge from 18 to 20 over 19: its neighbors above have the vertex 19
        surface.triangles.retain(|t| !(t.contains(&19) && t.iter().all(|v| v / 8 <= 2)));
        surface.triangles.extend([[10, 11, 18], [11, 20, 18]]);
        let mesh = SurfaceMesh::repaired(&surface).unwrap();
        let area = |t: &[u32; 3]| 0.5 * double_area(t.map(|v| mesh.mesh().vertices()[v as usize])).z;
        let areas: Vec<f64> = mesh.mesh().triangles().iter().map(area).collect();
        assert!(areas.iter().all(|&area| area > 0.1) && (areas.iter().sum::<f64>() - 49.0).abs() < 1e-12, "{areas:?}");
    }
}

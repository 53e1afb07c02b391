//! Repairs of single triangles and vertices that leave the shape of the surface as it is: corners at one place are merged,
//! the long edge of a flat triangle is flipped, vertices that join fans of triangles are split, and a vertex in the middle of
//! a neighbor's edge becomes one of the neighbor's, inside and where the gap reaches the boundary.

use super::Surface;
use super::edges::{EdgeTable, NO_TWIN, ends};
use super::repair::{RepairNote, Repaired};
use super::survey::{is_flat, root, visit_fan};
use crate::geometry::DVec3;
use std::collections::{HashMap, HashSet};

/// Merges corners of a triangle that lie at one place.
pub(super) fn merge_coincident(repaired: &mut Repaired) {
    let surface = &repaired.surface;
    let mut into: Vec<u32> = (0..surface.vertices.len() as u32).collect();
    for &[a, b, c] in &surface.triangles {
        for [u, v] in [[a, b], [b, c], [c, a]] {
            if u != v && surface.vertices[u as usize] == surface.vertices[v as usize] {
                let [u, v] = [root(&mut into, u), root(&mut into, v)];
                into[u.max(v) as usize] = u.min(v);
            }
        }
    }
    merge(repaired, into);
}

/// Merges vertices of triangles that lie at one place.
pub(super) fn merge_places(repaired: &mut Repaired) {
    let surface = &repaired.surface;
    let mut into: Vec<u32> = (0..surface.vertices.len() as u32).collect();
    let mut first = HashMap::new();
    for &v in surface.triangles.as_flattened().iter().filter(|&&v| surface.vertices[v as usize].is_finite()) {
        let place = surface.vertices[v as usize] + DVec3::ZERO; // −0 and 0 are the same
        into[v as usize] = *first.entry(place.to_array().map(f64::to_bits)).or_insert(v);
    }
    merge(repaired, into);
}

/// Merges each vertex into another one, or into itself.
fn merge(repaired: &mut Repaired, mut into: Vec<u32>) {
    let count = (0..).zip(&into).filter(|(v, into)| v != *into).count();
    if count > 0 {
        for v in repaired.surface.triangles.as_flattened_mut() {
            *v = root(&mut into, *v);
        }
        repaired.notes.push(RepairNote::MergedVertices { count });
    }
}

/// How often flat triangles are looked for: one flip can leave the next one flat.
const PASSES: usize = 16;

/// Flips the longest edge of flat triangles, or drops those whose longest edge is on the boundary. The surface is oriented.
/// What would still be flat, or give two edges the same ends, stays.
pub(super) fn flip_flat(repaired: &mut Repaired) {
    let mut count = 0;
    for _ in 0..PASSES {
        let changed = flip_once(repaired);
        count += changed;
        if changed == 0 {
            break;
        }
    }
    if count > 0 {
        repaired.notes.push(RepairNote::FlippedFlat { count });
    }
}

fn flip_once(repaired: &mut Repaired) -> usize {
    let surface = &mut repaired.surface;
    let places = |corners: [u32; 3]| corners.map(|v| surface.vertices[v as usize]);
    let flat: Vec<usize> = (0..surface.triangles.len()).filter(|&t| is_flat(places(surface.triangles[t]))).collect();
    if flat.is_empty() {
        return 0;
    }
    let triangles = &mut surface.triangles;
    let twins = EdgeTable::new(triangles, surface.vertices.len()).twins();
    let sorted = |[u, v]: [u32; 2]| [u.min(v), u.max(v)];
    let mut edges: HashSet<[u32; 2]> = (0..twins.len() as u32).map(|half| sorted(ends(triangles, half))).collect();
    let mut touched = vec![false; triangles.len()];
    let mut dropped = vec![false; triangles.len()];
    let mut count = 0;
    for t in flat {
        let length = |half: u32| {
            let [u, v] = ends(triangles, half).map(|v| surface.vertices[v as usize]);
            u.distance_squared(v)
        };
        let halves = 3 * t as u32..3 * t as u32 + 3;
        let Some(half) = halves.max_by(|&a, &b| length(a).total_cmp(&length(b))) else { continue };
        let twin = twins[half as usize];
        if twin == NO_TWIN {
            dropped[t] = true;
            count += 1;
            continue;
        }
        let other = twin as usize / 3;
        let [a, b] = ends(triangles, half);
        let [c, d] = [half, twin].map(|half| triangles[half as usize / 3][half as usize % 3]);
        let new = [[c, a, d], [c, d, b]];
        let is_sound =
            c != d && !edges.contains(&sorted([c, d])) && !new.iter().any(|&corners| is_flat(places(corners)));
        if !touched[t] && !touched[other] && is_sound {
            (triangles[t], triangles[other]) = (new[0], new[1]);
            (touched[t], touched[other]) = (true, true);
            edges.insert(sorted([c, d]));
            count += 1;
        }
    }
    repaired.retain(|t, _| !dropped[t]);
    count
}

/// Gives each fan of triangles a vertex of its own where several meet in one.
pub(super) fn split_pinched(repaired: &mut Repaired) {
    let surface = &mut repaired.surface;
    let twins = EdgeTable::new(&surface.triangles, surface.vertices.len()).twins();
    let before = surface.vertices.len();
    let mut is_taken = vec![false; before];
    let mut visited = vec![false; twins.len()];
    for corner in 0..twins.len() {
        if visited[corner] {
            continue;
        }
        let vertex = surface.triangles[corner / 3][corner % 3];
        let is_first = !std::mem::replace(&mut is_taken[vertex as usize], true);
        let mut fan = Vec::new();
        visit_fan(&surface.triangles, &twins, corner, &mut visited, &mut |corner| fan.push(corner));
        if !is_first {
            let number = surface.vertices.len() as u32;
            surface.vertices.push(surface.vertices[vertex as usize]);
            for corner in fan {
                surface.triangles[corner / 3][corner % 3] = number;
            }
        }
    }
    let count = surface.vertices.len() - before;
    if count > 0 {
        let origins = repaired.vertex_origins.len() as u32..;
        repaired.vertex_origins.extend(origins.take(count));
        repaired.split.extend(&surface.vertices[before..]);
        repaired.notes.push(RepairNote::SplitVertices { count });
    }
}

/// Joins holes without area, which are left out of `loops`: the triangle at the longest edge is divided at the other
/// vertices, which lie on that edge. The first loop is no hole. Loops have the direction of their triangles.
pub(super) fn join_flat(repaired: &mut Repaired, loops: &mut Vec<Vec<u32>>) {
    let surface = &repaired.surface;
    let is_thin = |hole: &[u32]| {
        let places: Vec<DVec3> = hole.iter().map(|&v| surface.vertices[v as usize]).collect();
        let far = |from: DVec3| places.iter().copied().max_by(|p, q| p.distance(from).total_cmp(&q.distance(from)));
        let Some(b) = far(places[0]) else { return false };
        let a = far(b).unwrap_or(b);
        places.iter().all(|&p| p == a || p == b || is_flat([a, b, p]))
    };
    let mut is_hole_thin: Vec<bool> = loops.iter().map(|hole| is_thin(hole)).collect();
    if let Some(outline) = is_hole_thin.first_mut() {
        *outline = false;
    }
    if !is_hole_thin.contains(&true) {
        return;
    }
    let halves = 0..3 * surface.triangles.len() as u32;
    let mut edges: HashMap<[u32; 2], u32> = halves.map(|half| (ends(&surface.triangles, half), half)).collect();
    let mut thin = is_hole_thin.into_iter();
    let before = loops.len();
    loops.retain(|hole| !(thin.next() == Some(true) && join(repaired, hole, &mut edges)));
    if loops.len() < before {
        repaired.notes.push(RepairNote::Joined { count: before - loops.len() });
    }
}

/// Joins gaps without area that reach the boundary of the surface: both sides begin in one vertex of it. The surface is oriented.
pub(super) fn join_open(repaired: &mut Repaired) {
    let surface = &repaired.surface;
    let next = boundary_edges(surface);
    let is_pinched = |v: &u32| next.get(v).is_some_and(|ends| ends.len() > 1);
    let mut starts: Vec<u32> = next.keys().copied().collect();
    if !starts.iter().any(is_pinched) {
        return;
    }
    starts.sort_unstable();
    let edges = starts.iter().flat_map(|&a| next[&a].iter().map(move |&b| [a, b]));
    let gaps: Vec<Vec<u32>> = edges
        .filter(|edge| edge.iter().any(is_pinched))
        .filter_map(|edge| other_side(&surface.vertices, &next, edge))
        .collect();
    let halves = 0..3 * surface.triangles.len() as u32;
    let mut edges: HashMap<[u32; 2], u32> = halves.map(|half| (ends(&surface.triangles, half), half)).collect();
    let count = gaps.iter().filter(|gap| join(repaired, gap, &mut edges)).count();
    if count > 0 {
        repaired.notes.push(RepairNote::Joined { count });
    }
}

/// Where the boundary edges that begin at each vertex end.
fn boundary_edges(surface: &Surface) -> HashMap<u32, Vec<u32>> {
    let twins = EdgeTable::new(&surface.triangles, surface.vertices.len()).twins();
    let mut next: HashMap<u32, Vec<u32>> = HashMap::new();
    for (half, _) in (0..).zip(&twins).filter(|(_, twin)| **twin == NO_TWIN) {
        let [a, b] = ends(&surface.triangles, half);
        next.entry(a).or_default().push(b);
    }
    next
}

/// The boundary edge from a to b and the chain of boundary edges back from b to a whose vertices lie on it one after the other;
/// `None` if there is none.
fn other_side(places: &[DVec3], next: &HashMap<u32, Vec<u32>>, [a, b]: [u32; 2]) -> Option<Vec<u32>> {
    let place = |v: u32| places[v as usize];
    let along = |v: u32| (place(v) - place(a)).dot(place(b) - place(a));
    let is_between =
        |v: u32, before: u32| 0.0 < along(v) && along(v) < along(before) && is_flat([place(a), place(b), place(v)]);
    let mut gap = vec![a, b];
    let mut at = b;
    loop {
        let ends = next.get(&at)?;
        if gap.len() > 2 && ends.contains(&a) {
            return Some(gap);
        }
        at = ends.iter().copied().find(|&v| is_between(v, at))?;
        gap.push(at);
    }
}

/// Joins one hole; false if its vertices do not lie along its longest edge one after the other.
fn join(repaired: &mut Repaired, hole: &[u32], edges: &mut HashMap<[u32; 2], u32>) -> bool {
    let surface = &mut repaired.surface;
    let n = hole.len();
    let place = |v: u32| surface.vertices[v as usize];
    let length = |k: usize| place(hole[k]).distance_squared(place(hole[(k + 1) % n]));
    let Some(longest) = (0..n).max_by(|&j, &k| length(j).total_cmp(&length(k))) else { return false };
    let Some(&half) = edges.get(&[hole[longest], hole[(longest + 1) % n]]) else { return false };
    let divided = half as usize / 3;
    let apex = surface.triangles[divided][half as usize % 3];
    // against the loop's direction from the edge's first end to its last
    let chain: Vec<u32> = (0..n).map(|k| hole[(longest + n - k) % n]).collect();
    let parts: Vec<[u32; 3]> = chain.windows(2).map(|step| [apex, step[0], step[1]]).collect();
    let area = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(place);
        (b - a).cross(c - a)
    };
    let whole = area(surface.triangles[divided]);
    if parts.iter().any(|&corners| is_flat(corners.map(place)) || area(corners).dot(whole) <= 0.0) {
        return false;
    }
    let first = surface.triangles.len();
    surface.triangles[divided] = parts[0];
    surface.triangles.extend(&parts[1..]);
    let origin = repaired.triangle_origins[divided];
    repaired.triangle_origins.resize(surface.triangles.len(), origin);
    for t in [divided].into_iter().chain(first..surface.triangles.len()) {
        for half in 3 * t as u32..3 * t as u32 + 3 {
            edges.insert(ends(&surface.triangles, half), half);
        }
    }
    true
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::surface::{SurfaceMesh, TopologyError};

    /// Squares with their lower left corners at these points of a lattice, each cut from lower left to upper right.
    fn squares(at: &[(u32, u32)]) -> Surface {
        let number = |i: u32, j: u32| 8 * j + i;
        let vertices = (0..64).map(|k| DVec3::new(f64::from(k % 8), f64::from(k / 8), 0.0)).collect();
        let square = |&(i, j): &(u32, u32)| {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        Surface::new(vertices, at.iter().flat_map(square).collect())
    }

    fn notes(surface: &Surface) -> (SurfaceMesh, Vec<RepairNote>) {
        let mesh = SurfaceMesh::repaired(surface).unwrap();
        let notes = mesh.repairs().iter().filter(|note| !matches!(note, RepairNote::DroppedVertices { .. }));
        let notes = notes.cloned().collect();
        (mesh, notes)
    }

    #[test]
    fn a_vertex_in_a_neighbors_edge_becomes_one_of_the_neighbor() {
        let all: Vec<(u32, u32)> = (0..9).map(|k| (k % 3, k / 3)).collect();
        let mut surface = squares(&all);
        // the square at (1, 0) gets a vertex in the middle of its upper edge, which the one above does not have
        surface.vertices.push(DVec3::new(1.5, 1.0, 0.0));
        let upper = surface.triangles.iter().position(|corners| *corners == [1, 10, 9]).unwrap();
        surface.triangles[upper] = [1, 10, 64];
        surface.triangles.push([1, 64, 9]);
        let (mesh, notes) = notes(&surface);
        assert_eq!(notes, [RepairNote::Joined { count: 1 }]);
        assert!(mesh.triangle_origins().iter().all(|&origin| (origin as usize) < surface.triangles.len()));
        assert_eq!((mesh.mesh().triangles().len(), mesh.mesh().vertices().len()), (20, 17));
        // and with a flat triangle in the gap, as some programs fill it
        surface.triangles.push([10, 9, 64]);
        let (mesh, notes) = self::notes(&surface);
        assert_eq!(notes, [RepairNote::FlippedFlat { count: 1 }]);
        assert_eq!((mesh.mesh().triangles().len(), mesh.mesh().vertices().len()), (20, 17));
    }

    #[test]
    fn a_gap_that_reaches_the_boundary_is_joined_and_no_slit() {
        // the lower left square gets vertices in its upper edge, which the one above does not have
        let mut surface = squares(&[(0, 0), (1, 0), (0, 1), (1, 1)]);
        surface.vertices.extend([DVec3::new(0.25, 1.0, 0.0), DVec3::new(0.5, 1.0, 0.0)]);
        let upper = surface.triangles.iter().position(|corners| *corners == [0, 9, 8]).unwrap();
        surface.triangles[upper] = [0, 9, 65];
        surface.triangles.extend([[0, 65, 64], [0, 64, 8]]);
        let (mesh, notes) = notes(&surface);
        assert_eq!(notes, [RepairNote::Joined { count: 1 }]);
        let mesh = mesh.mesh();
        assert_eq!((mesh.triangles().len(), mesh.vertices().len(), mesh.boundary_count()), (12, 11, 8));
        // a real slit stays one
        surface.vertices[65].y = 1.0 - 1e-9;
        let (mesh, notes) = self::notes(&surface);
        assert_eq!(notes, [RepairNote::SplitVertices { count: 1 }]);
        assert_eq!(mesh.mesh().boundary_count(), 12);
    }

    #[test]
    fn parts_that_meet_in_a_line_with_other_vertices_are_joined() {
        // a column of two squares beside one of four half as high, whose corners are their own
        let mut surface = squares(&[(0, 0), (0, 1)]);
        let first = surface.vertices.len() as u32;
        surface.vertices.extend((0..10).map(|k| DVec3::new(f64::from(1 + k % 2), f64::from(k / 2) / 2.0, 0.0)));
        let half = |k: u32| {
            let [a, b, c, d] = [0, 1, 3, 2].map(|corner| first + 2 * k + corner);
            [[a, b, c], [a, c, d]]
        };
        surface.triangles.extend((0..4).flat_map(half));
        let (mesh, notes) = notes(&surface);
        assert_eq!(notes, [RepairNote::MergedVertices { count: 3 }, RepairNote::Joined { count: 2 }]);
        let mesh = mesh.mesh();
        assert_eq!((mesh.triangles().len(), mesh.vertices().len(), mesh.boundary_count()), (14, 13, 10));
        // a part in another place stays one
        surface.vertices.iter_mut().skip(first as usize).for_each(|place| place.x += 0.1);
        let (_, notes) = self::notes(&surface);
        assert_eq!(notes, [RepairNote::KeptLargest { components: 2, dropped: 4 }]);
    }

    #[test]
    fn a_vertex_at_no_place_in_a_small_part_does_not_matter() {
        let mut junk = squares(&[(0, 0), (1, 0), (0, 1), (1, 1)]);
        junk.vertices.push(DVec3::NAN);
        junk.triangles.push([54, 55, 64]);
        let (_, notes) = notes(&junk);
        assert_eq!(notes, [RepairNote::KeptLargest { components: 2, dropped: 1 }]);
        junk.vertices[9] = DVec3::NAN;
        assert!(matches!(SurfaceMesh::repaired(&junk), Err(TopologyError::NotFinite { .. })));
    }

    #[test]
    fn corners_at_one_place_are_merged_and_flat_triangles_at_the_boundary_dropped() {
        let mut surface = squares(&[(0, 0), (1, 0)]);
        // the second square has a corner of its own at (1, 0), and a triangle without area between both
        surface.vertices.push(surface.vertices[1]);
        surface.triangles.iter_mut().skip(2).flatten().filter(|v| **v == 1).for_each(|v| *v = 64);
        surface.triangles.push([1, 64, 9]);
        let (mesh, notes) = notes(&surface);
        let expected = [RepairNote::MergedVertices { count: 1 }, RepairNote::DroppedTriangles { count: 1 }];
        assert_eq!((notes.as_slice(), mesh.mesh().triangles().len()), (&expected[..], 4));
        let mut surface = squares(&[(0, 0), (1, 0)]);
        surface.triangles.push([1, 0, 2]);
        let (mesh, notes) = self::notes(&surface);
        assert_eq!((notes, mesh.mesh().triangles().len()), (vec![RepairNote::FlippedFlat { count: 1 }], 4));
    }

    #[test]
    fn a_pinched_vertex_is_split_and_faults_of_small_parts_do_not_matter() {
        // a ring of squares that is open at one corner, where its ends touch
        let ring = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 3), (0, 1), (0, 2)];
        let surface = squares(&ring[..6]);
        let unused = 64 - 14;
        let open = SurfaceMesh::new(&surface).unwrap();
        assert_eq!(open.repairs(), [RepairNote::DroppedVertices { count: unused }]);
        let pinched = squares(&[(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 1)]);
        let (mesh, notes) = notes(&pinched);
        assert_eq!(notes, [RepairNote::SplitVertices { count: 1 }]);
        assert_eq!(mesh.mesh().triangles().len(), 14);
        // the new vertex follows those of the surface
        assert!(mesh.vertex_origins().contains(&64) && mesh.origin_positions().count() == 65);
        let mut junk = squares(&[(0, 0), (1, 0), (0, 1), (1, 1)]);
        junk.vertices.push(DVec3::new(6.0, 6.0, 1.0));
        junk.triangles.extend([[54, 55, 63], [54, 55, 62], [54, 55, 64]]);
        let (_, notes) = self::notes(&junk);
        assert_eq!(notes, [RepairNote::KeptLargest { components: 2, dropped: 3 }]);
    }
}

//! All faults of a surface that is no disk, each with its count and its first place.
//!
//! Faults are looked for in the order in which a repair mends them, each in what is left without those before it: triangles
//! that name a vertex twice, or have the corners of an earlier one, are left out. So no fault is listed that only follows from
//! another one. Loops and handles are those of the largest component, where they can be counted: it can be oriented, its edges
//! have two triangles at most, its vertices one fan.

use super::repair::{Repaired, drop_duplicates, edges_of, keep_largest, orient};
use super::survey::{
    Connectivity, check_areas, check_components, check_duplicates, check_edges, check_indices, check_orientation,
    check_places, check_repeats, check_vertices, components, connected, connectivity, fans, repeats,
};
use super::{Surface, TopologyError};

/// The connectivity of a disk. Errors: all faults, with the numbers that vertices and triangles had before the repair.
pub(super) fn disk_connectivity(repaired: &Repaired) -> Result<Connectivity, TopologyError> {
    let surface = &repaired.surface;
    let found = connectivity(surface).and_then(|found| found.check_disk(surface).map(|()| found));
    found.map_err(|first| repaired.before(TopologyError::joined(faults(surface)).unwrap_or(first)))
}

/// All faults of a surface. Cost O(n log d) for n triangles, d at a vertex.
fn faults(surface: &Surface) -> Vec<TopologyError> {
    if let Err(fault) = check_indices(surface) {
        return vec![fault];
    }
    let mut faults = of_triangles(surface);
    let mut rest = Repaired::untouched(surface.clone());
    rest.retain(|_, corners| !repeats(corners));
    let twice = check_duplicates(&rest.surface.triangles, &edges_of(&rest.surface));
    faults.extend(twice.err().map(|fault| rest.before(fault)));
    drop_duplicates(&mut rest);
    faults.extend(of_neighbors(&rest.surface).into_iter().map(|fault| rest.before(fault)));
    keep_largest(&mut rest);
    if orient(&mut rest).is_ok()
        && let Ok(found) = connected(&rest.surface)
    {
        faults.extend(found.faults_of_whole(&rest.surface).into_iter().map(|fault| rest.before(fault)));
    }
    faults
}

/// The faults of places and of triangles alone. Where areas underflow, all are 0, and none is a fault of its own.
fn of_triangles(surface: &Surface) -> Vec<TopologyError> {
    let places = check_places(surface).err();
    let is_tiny = matches!(places, Some(TopologyError::TooSmall { .. }));
    let flat = if is_tiny { None } else { check_areas(surface).err() };
    places.into_iter().chain(check_repeats(surface).err()).chain(flat).collect()
}

/// The faults of triangles that share edges or vertices, and of parts.
fn of_neighbors(surface: &Surface) -> Vec<TopologyError> {
    let Surface { vertices, triangles, .. } = surface;
    let edges = edges_of(surface);
    let twins = edges.twins();
    let (component, sizes) = components(&edges, triangles.len());
    let checks = [
        check_edges(triangles, &edges),
        check_orientation(triangles, &twins),
        check_vertices(&fans(triangles, &edges, &twins, vertices.len())),
        check_components(&component, &sizes),
    ];
    checks.into_iter().filter_map(Result::err).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec3;
    use crate::mesh::{TriangleId, VertexId};
    use crate::surface::SurfaceMesh;

    /// A row of squares, each cut along its diagonal; square k has the triangles 2k and 2k + 1.
    fn row(squares: u32) -> Surface {
        let vertices = (0..2 * squares + 2).map(|v| DVec3::new(f64::from(v / 2), f64::from(v % 2), 0.0)).collect();
        let square = |k: u32| [[2 * k, 2 * k + 2, 2 * k + 3], [2 * k, 2 * k + 3, 2 * k + 1]];
        Surface::new(vertices, (0..squares).flat_map(square).collect())
    }

    fn listed(surface: &Surface) -> Vec<TopologyError> {
        match SurfaceMesh::new(surface).unwrap_err() {
            TopologyError::Several { faults } => faults,
            one => panic!("one fault only: {one}"),
        }
    }

    #[test]
    fn every_kind_of_fault_is_listed_with_its_count_and_first_place() {
        let mut surface = row(20);
        let add = |surface: &mut Surface, place: [f64; 3]| {
            surface.vertices.push(place.into());
            surface.vertices.len() as u32 - 1
        };
        let astray = add(&mut surface, [f64::NAN, 0.0, 0.0]);
        let above = [0.0, 1.0, 2.0].map(|x| add(&mut surface, [x, 0.5, 1.0]));
        let middle = add(&mut surface, [0.5, 0.0, 0.0]);
        let far = [[0.0, 9.0, 0.0], [1.0, 9.0, 0.0], [0.0, 8.0, 0.0]].map(|place| add(&mut surface, place));
        surface.triangles.extend([
            [38, 41, astray],         // 40: at no place, with the edge of triangle 38
            [4, 4, 6],                // 41: names a vertex twice
            [0, middle, 2],           // 42: flat
            [1, 0, 3],                // 43: has the corners of triangle 1
            [8, 11, above[0]],        // 44: a third one at the edge of triangles 8 and 9
            [20, above[1], above[2]], // 45: shares a vertex only
            [far[0], far[2], far[1]], // 46: apart
        ]);
        surface.triangles[30].swap(0, 1);
        let at = |t: u32| TriangleId::new(t);
        let corners = |corners: [u32; 3]| corners.map(VertexId::new);
        let expected = [
            TopologyError::NotFinite { vertex: VertexId::new(astray), count: 1 },
            TopologyError::RepeatedCorner { triangle: at(41), corners: corners([4, 4, 6]), count: 1 },
            TopologyError::Degenerate { triangle: at(42), corners: corners([0, middle, 2]), count: 1 },
            TopologyError::Duplicates { triangle: at(43), corners: corners([1, 0, 3]), other: at(1), count: 1 },
        ];
        let found = listed(&surface);
        assert_eq!(found[..4], expected);
        let [edges, orientation, pinched, parts] = &found[4..] else { panic!("{found:?}") };
        assert!(matches!(edges, TopologyError::NonManifoldEdge { count: 2, .. }), "{edges}");
        let TopologyError::Orientation { triangles, count: 2, .. } = orientation else { panic!("{orientation}") };
        assert!(triangles.contains(&at(30)), "{orientation}");
        assert_eq!(*pinched, TopologyError::NonManifoldVertex { vertex: VertexId::new(20), fans: 2, count: 1 });
        // the third triangles at edges belong to the row
        assert_eq!(*parts, TopologyError::Components { triangles: vec![43, 1, 1], first: at(45) });
        let text = SurfaceMesh::new(&surface).unwrap_err().to_string();
        assert!(text.starts_with("the surface has 8 kinds of faults: (1) vertex 42 is at no finite place"), "{text}");
        let places = SurfaceMesh::new(&surface).unwrap_err().places(&surface);
        assert!(places.edges.len() >= 3 * 5 + 2 + 2 && places.vertices.contains(&20), "{places:?}");
    }

    #[test]
    fn a_fault_alone_is_itself_and_what_follows_from_it_is_no_other() {
        // all triangles of a square twice: no edge is said to have four
        let mut surface = row(2);
        surface.triangles.extend(surface.triangles.clone());
        let error = SurfaceMesh::new(&surface).unwrap_err();
        assert!(matches!(error, TopologyError::Duplicates { count: 4, .. }), "{error}");
        // the ends of an edge of three triangles have several fans
        let mut surface = row(4);
        surface.vertices.push(DVec3::Z);
        surface.triangles.push([2, 3, 10]);
        let error = SurfaceMesh::new(&surface).unwrap_err();
        assert!(matches!(error, TopologyError::NonManifoldEdge { count: 1, .. }), "{error}");
    }

    #[test]
    fn loops_are_those_of_the_largest_part_and_numbers_those_of_the_surface() {
        // a triangle apart, then a closed band of squares, one triangle of which is turned
        let mut surface = row(6);
        for (k, place) in surface.vertices.iter_mut().enumerate() {
            let angle = std::f64::consts::TAU * (k / 2) as f64 / 6.0;
            *place = DVec3::new(angle.cos(), angle.sin(), (k % 2) as f64);
        }
        surface.triangles.iter_mut().flatten().for_each(|v| *v %= 12);
        surface.vertices.extend([DVec3::Z * 9.0, DVec3::Z * 8.0]);
        surface.triangles.insert(0, [12, 13, 14]);
        surface.vertices.push(DVec3::X * 9.0);
        surface.triangles[5].swap(1, 2);
        let found = listed(&surface);
        let [TopologyError::Orientation { triangles, .. }, TopologyError::Components { first, .. }, loops] = &*found
        else {
            panic!("{found:?}")
        };
        assert!(triangles.contains(&TriangleId::new(5)) && *first == TriangleId::new(0), "{found:?}");
        let TopologyError::Loops { loops } = loops else { panic!("{loops}") };
        let firsts: Vec<VertexId> = loops.iter().map(|found| found.first).collect();
        assert_eq!(firsts, [0, 1].map(VertexId::new));
    }
}

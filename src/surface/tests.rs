//! Broken surfaces give the error that names the fault, and repairs report what they change.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use super::repair::ADDED;
use super::*;
use crate::mesh::{TriMesh, TriangleId, VertexId};

/// A grid of k×k squares, each cut along the same diagonal.
fn grid(k: u32) -> Surface {
    let place = |v: u32| DVec3::new(f64::from(v % (k + 1)), f64::from(v / (k + 1)), 0.0);
    let vertices = (0..(k + 1) * (k + 1)).map(place).collect();
    let square = |q: u32| {
        let a = q / k * (k + 1) + q % k;
        [[a, a + 1, a + k + 2], [a, a + k + 2, a + k + 1]]
    };
    Surface::new(vertices, (0..k * k).flat_map(square).collect())
}

fn error(surface: &Surface) -> TopologyError {
    SurfaceMesh::new(surface).unwrap_err()
}

fn tetrahedron() -> Surface {
    let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    Surface::new(vertices, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
}

/// A torus of p×q squares.
fn torus(p: u32, q: u32) -> Surface {
    let angle = |k: u32, n: u32| std::f64::consts::TAU * f64::from(k) / f64::from(n);
    let place = |v: u32| {
        let ((s, c), (t, d)) = (angle(v / q, p).sin_cos(), angle(v % q, q).sin_cos());
        DVec3::new((2.0 + d) * c, (2.0 + d) * s, t)
    };
    let at = |i: u32, j: u32| (i % p) * q + j % q;
    let square = |k: u32| {
        let (i, j) = (k / q, k % q);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    Surface::new((0..p * q).map(place).collect(), (0..p * q).flat_map(square).collect())
}

#[test]
fn a_grid_is_a_disk_with_its_boundary_first() {
    let disk = SurfaceMesh::new(&grid(3)).unwrap();
    assert_eq!(disk.vertex_origins(), [0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4, 5, 6, 9, 10]);
    let flat = TriMesh::known_sound(
        disk.mesh().vertices().iter().map(|p| p.truncate()).collect(),
        12,
        disk.mesh().triangles().to_vec(),
        disk.mesh().neighbours().to_vec(),
    );
    assert_eq!(flat.check_invariants(), Ok(()));
    for v in (0..16).map(VertexId::new) {
        assert_eq!(disk.origin_of(disk.number_of(v).unwrap()), Some(v));
    }
    let turned = Surface { triangles: grid(3).triangles.iter().map(|&[a, b, c]| [a, c, b]).collect(), ..grid(3) };
    assert_eq!(SurfaceMesh::new(&turned).unwrap().vertex_origins()[..4], [0, 4, 8, 12]);
}

#[test]
fn bad_values_are_named() {
    assert_eq!(error(&Surface::default()), TopologyError::Empty);
    let mut surface = grid(2);
    surface.triangles[3][1] = 77;
    assert_eq!(
        error(&surface),
        TopologyError::IndexOutOfRange { triangle: TriangleId::new(3), vertex: VertexId::new(77), vertices: 9 }
    );
    let mut surface = grid(2);
    surface.vertices[5].y = f64::NAN;
    assert_eq!(error(&surface), TopologyError::NotFinite { vertex: VertexId::new(5), count: 1 });
    surface.vertices[5].y = 1.1e75;
    surface.vertices[7].x = f64::NEG_INFINITY;
    assert_eq!(error(&surface), TopologyError::NotFinite { vertex: VertexId::new(5), count: 2 });
    let mut surface = grid(2);
    surface.vertices.iter_mut().for_each(|p| *p *= 1e-72);
    assert!(matches!(error(&surface), TopologyError::TooSmall { .. }));
}

#[test]
fn triangles_without_area_are_named() {
    let mut surface = grid(2);
    surface.vertices[4] = surface.vertices[0].lerp(surface.vertices[1], 0.5);
    let flat =
        TopologyError::Degenerate { triangle: TriangleId::new(0), corners: [0, 1, 4].map(VertexId::new), count: 1 };
    assert_eq!(error(&surface), flat);
    assert_eq!(flat.to_string(), "triangle 0 [0, 1, 4] has no area: merge its corners or drop it");
    let mut surface = grid(2);
    surface.triangles.push([3, 4, 4]);
    assert_eq!(
        error(&surface),
        TopologyError::RepeatedCorner { triangle: TriangleId::new(8), corners: [3, 4, 4].map(VertexId::new), count: 1 }
    );
    let repaired = SurfaceMesh::repaired(&surface).unwrap();
    assert_eq!(repaired.repairs(), [RepairNote::DroppedTriangles { count: 1 }]);
}

#[test]
fn triangles_with_the_same_corners_are_named_and_dropped() {
    let clean = SurfaceMesh::new(&grid(3)).unwrap();
    let doubled = grid(3).triangles;
    let turned: Vec<_> = doubled.iter().map(|&[a, b, c]| [b, a, c]).collect();
    let cycled: Vec<_> = doubled.iter().map(|&[a, b, c]| [c, a, b]).collect();
    for others in [&cycled[7..8], &turned[7..8], &[cycled[7], turned[7], turned[7]], &turned, &cycled] {
        let mut surface = grid(3);
        let first = surface.triangles.len() as u32;
        surface.triangles.extend(others);
        let other = TriangleId::new(if others.len() > 3 { 0 } else { 7 });
        let (corners, count) = (others[0].map(VertexId::new), others.len());
        let expected = TopologyError::Duplicates { triangle: TriangleId::new(first), corners, other, count };
        assert_eq!(error(&surface), expected);
        let repaired = SurfaceMesh::repaired(&surface).unwrap();
        assert_eq!(repaired.repairs(), [RepairNote::DroppedDuplicates { count }]);
        assert_eq!((repaired.mesh(), repaired.triangle_origins()), (clean.mesh(), clean.triangle_origins()));
    }
}

#[test]
fn edges_and_vertices_that_are_no_manifold_are_named() {
    let mut surface = grid(2);
    surface.vertices.push(DVec3::Z);
    surface.triangles.push([0, 4, 9]);
    let expected = TopologyError::NonManifoldEdge {
        edge: [0, 4].map(VertexId::new),
        triangles: [0, 1, 8].map(TriangleId::new).to_vec(),
        count: 1,
    };
    assert_eq!(error(&surface), expected);
    assert_eq!(
        expected.to_string(),
        "the edge from vertex 0 to 4 has more than two triangles, [0, 1, 8]: delete all but two"
    );
    assert_eq!(SurfaceMesh::repaired(&surface).unwrap_err(), expected);
    let mut surface = grid(2);
    surface.vertices.extend([DVec3::Z, DVec3::new(1.0, 0.0, 1.0)]);
    surface.triangles.push([4, 9, 10]);
    let pinched = TopologyError::NonManifoldVertex { vertex: VertexId::new(4), fans: 2, count: 1 };
    let parts = TopologyError::Components { triangles: vec![8, 1], first: TriangleId::new(8) };
    assert_eq!(error(&surface), TopologyError::Several { faults: vec![pinched, parts] });
}

#[test]
fn turned_triangles_are_named_and_turned_back() {
    let mut surface = grid(3);
    let straight = surface.clone();
    for t in [4, 5, 9] {
        surface.triangles[t].swap(1, 2);
    }
    let TopologyError::Orientation { triangles, count, .. } = error(&surface) else { panic!("{}", error(&surface)) };
    assert!([4, 5, 9].iter().any(|&t| triangles.contains(&TriangleId::new(t))), "{triangles:?}");
    assert!(count > 2, "{count}");
    let repaired = SurfaceMesh::repaired(&surface).unwrap();
    assert_eq!(repaired.repairs(), [RepairNote::Oriented { count: 3 }]);
    assert_eq!(repaired.vertex_origins(), SurfaceMesh::new(&straight).unwrap().vertex_origins());
}

#[test]
fn a_moebius_strip_has_one_side() {
    let vertices = (0..10).map(|k| DVec3::new(f64::from(k / 2), f64::from(k % 2), f64::from(k * k % 7))).collect();
    let square = |k: u32| {
        let (a, b) = (2 * k, 2 * k + 1);
        let (c, d) = if k < 4 { (a + 2, b + 2) } else { (1, 0) };
        [[a, c, b], [b, c, d]]
    };
    let strip = Surface::new(vertices, (0..5).flat_map(square).collect());
    assert!(matches!(error(&strip), TopologyError::OneSided { .. }));
    assert!(matches!(SurfaceMesh::repaired(&strip), Err(TopologyError::OneSided { .. })));
}

#[test]
fn parts_and_loose_vertices_are_counted_and_dropped() {
    let mut surface = grid(2);
    surface.vertices.extend([DVec3::Z, DVec3::ONE, DVec3::new(1.0, 0.0, 1.0), DVec3::NEG_X]);
    surface.triangles.insert(0, [9, 10, 11]);
    assert_eq!(error(&surface), TopologyError::Components { triangles: vec![8, 1], first: TriangleId::new(0) });
    let repaired = SurfaceMesh::repaired(&surface).unwrap();
    let expected = [RepairNote::KeptLargest { components: 2, dropped: 1 }, RepairNote::DroppedVertices { count: 4 }];
    assert_eq!(repaired.repairs(), expected);
    assert_eq!((repaired.triangle_origins()[0], repaired.number_of(VertexId::new(12))), (1, None));
}

#[test]
fn vertices_in_no_triangle_are_dropped_wherever_they_are() {
    let mut surface = grid(2);
    surface.vertices.extend([DVec3::Z, DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e300)]);
    let plain = SurfaceMesh::new(&grid(2)).unwrap();
    for disk in [SurfaceMesh::new(&surface).unwrap(), SurfaceMesh::repaired(&surface).unwrap()] {
        assert_eq!(disk.repairs(), [RepairNote::DroppedVertices { count: 4 }]);
        assert_eq!((disk.mesh(), disk.vertex_origins()), (plain.mesh(), plain.vertex_origins()));
        // they keep their numbers, at a finite place
        let positions: Vec<DVec3> = disk.origin_positions().collect();
        assert_eq!(positions[..10], surface.vertices[..10]);
        assert_eq!(positions[10..], [positions[0]; 3]);
    }
}

#[test]
fn loops_and_handles_are_counted() {
    assert_eq!(error(&tetrahedron()), TopologyError::Closed { genus: 0 });
    assert_eq!(error(&torus(8, 6)), TopologyError::Closed { genus: 1 });
    let mut open = torus(8, 6);
    open.triangles.remove(0);
    assert_eq!(error(&open), TopologyError::Genus { genus: 1 });
    // a second hole, not adjacent to the first
    open.triangles.remove(40);
    let TopologyError::Several { faults } = error(&open) else { panic!("{}", error(&open)) };
    assert!(
        matches!(&*faults, [TopologyError::Genus { genus: 1 }, TopologyError::Loops { loops }] if loops.len() == 2)
    );
    assert_eq!(SurfaceMesh::repaired(&open).unwrap_err(), TopologyError::Genus { genus: 1 });
    let mut surface = grid(4);
    // the two squares in the middle of the second row
    surface.triangles.retain(|t| ![[6, 7, 12], [6, 12, 11], [7, 8, 13], [7, 13, 12]].contains(t));
    let TopologyError::Loops { loops } = error(&surface) else { panic!("{}", error(&surface)) };
    let expected = [(16, 16.0, 0), (6, 6.0, 6)];
    let expected = expected.map(|(vertices, length, v)| LoopReport { vertices, length, first: VertexId::new(v) });
    assert_eq!(loops, expected);
    // a hole that touches the boundary in a vertex pinches it
    surface.triangles.retain(|t| *t != [17, 18, 23]);
    assert_eq!(error(&surface), TopologyError::NonManifoldVertex { vertex: VertexId::new(23), fans: 2, count: 1 });
}

#[test]
fn any_boundary_loop_can_be_the_outline() {
    let mut surface = grid(4);
    surface.triangles.retain(|t| ![[6, 7, 12], [6, 12, 11], [7, 8, 13], [7, 13, 12]].contains(t));
    for (outline, vertices, filled) in [(0, 16, 6), (1, 6, 16)] {
        let mesh = SurfaceMesh::repaired_around(&surface, outline).unwrap();
        assert_eq!(mesh.mesh().boundary_count(), vertices);
        let [RepairNote::FilledHoles { holes, .. }] = mesh.repairs() else { panic!("{:?}", mesh.repairs()) };
        assert_eq!(holes.iter().map(|hole| hole.vertices).collect::<Vec<_>>(), [filled]);
    }
    assert_eq!(SurfaceMesh::repaired_around(&surface, 0), SurfaceMesh::repaired(&surface));
    let Err(TopologyError::NoLoop { asked: 3, loops }) = SurfaceMesh::repaired_around(&surface, 2) else {
        panic!("there are two loops")
    };
    assert_eq!(loops.len(), 2);
}

#[test]
fn the_holes_are_the_other_loops_and_the_given_triangles_are_a_prefix() {
    let mut surface = grid(5);
    surface.triangles.retain(|t| ![[7, 8, 14], [7, 14, 13], [21, 22, 28]].contains(t));
    let Err(TopologyError::Loops { loops }) = SurfaceMesh::new(&surface) else { panic!("it has three loops") };
    assert_eq!(SurfaceMesh::new(&grid(5)).unwrap().holes(), [[0; 0]; 0]);
    for outline in 0..3 {
        let disk = SurfaceMesh::repaired_around(&surface, outline).unwrap();
        let origins =
            |chain: &[u32]| -> Vec<u32> { chain.iter().map(|&v| disk.vertex_origins()[v as usize]).collect() };
        let report = |chain: &[u32]| LoopReport {
            vertices: chain.len(),
            length: disk.loop_length(chain),
            first: VertexId::new(*origins(chain).iter().min().unwrap()),
        };
        let mut others = loops.clone();
        others.remove(outline);
        assert_eq!(disk.holes().iter().map(|hole| report(hole)).collect::<Vec<_>>(), others, "outline {outline}");
        // each edge of a hole is one of a given triangle, in its direction
        for hole in disk.holes() {
            for (k, &u) in hole.iter().enumerate() {
                let v = hole[(k + 1) % hole.len()];
                let has_edge = |t: &[u32; 3]| (0..3).any(|i| (t[i], t[(i + 1) % 3]) == (u, v));
                assert!(disk.given_triangles().iter().any(has_edge), "outline {outline}: {u} → {v}");
            }
        }
        let given: Vec<_> =
            disk.given_triangles().iter().map(|t| t.map(|v| disk.vertex_origins()[v as usize])).collect();
        assert_eq!(given, surface.triangles, "outline {outline}");
    }
}

#[test]
fn holes_are_filled_and_marked() {
    let mut surface = grid(5);
    // a square hole, and a triangular one
    surface.triangles.retain(|t| ![[7, 8, 14], [7, 14, 13], [21, 22, 28]].contains(t));
    let before = surface.triangles.len();
    let repaired = SurfaceMesh::repaired(&surface).unwrap();
    let [RepairNote::FilledHoles { holes, triangles: 5 }] = repaired.repairs() else {
        panic!("{:?}", repaired.repairs())
    };
    assert_eq!(holes.iter().map(|l| l.vertices).collect::<Vec<_>>(), [4, 3]);
    assert_eq!(repaired.triangle_origins()[before..], [ADDED; 5]);
    assert_eq!(repaired.vertex_origins().iter().filter(|&&v| v == ADDED).count(), 1);
    let flat = TriMesh::known_sound(
        repaired.mesh().vertices().iter().map(|p| p.truncate()).collect(),
        repaired.mesh().boundary_count(),
        repaired.mesh().triangles().to_vec(),
        repaired.mesh().neighbours().to_vec(),
    );
    assert_eq!(flat.check_invariants(), Ok(()));
}

#[test]
fn every_preset_is_a_disk() {
    for preset in SurfacePreset::ALL {
        let disk = SurfaceMesh::new(&preset.surface(60).unwrap()).unwrap();
        assert!(disk.mesh().boundary_count().abs_diff(60) <= 3, "{preset}: {}", disk.mesh().boundary_count());
        assert!(disk.mesh().interior_count() > 50 && disk.repairs().is_empty());
        assert_eq!(preset.name().parse(), Ok(preset));
    }
}

#[test]
fn the_middle_of_a_grid_is_farthest_from_its_boundary() {
    let disk = SurfaceMesh::new(&grid(8)).unwrap();
    let found = farthest_from_boundary(disk.mesh());
    let corners = disk.mesh().triangles()[found.triangle().index()].map(|v| disk.mesh().vertices()[v as usize]);
    let place: DVec3 = corners.iter().zip(found.weights()).map(|(&p, w)| w * p).sum();
    assert_eq!(place, DVec3::new(4.0, 4.0, 0.0));
}

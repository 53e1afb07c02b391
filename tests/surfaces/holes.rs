//! Holes are filled without overlaps, whatever their shape and size.

use riemap::geometry::DVec3;
use riemap::surface::{Surface, SurfaceMesh, read_surface};

/// The area vectors of the triangles that fill holes.
fn filling(mesh: &SurfaceMesh) -> Vec<DVec3> {
    let (given, mesh) = (mesh.given_triangles().len(), mesh.mesh());
    let corners = mesh.triangles()[given..].iter().map(|t| t.map(|v| mesh.vertices()[v as usize]));
    corners.map(|[a, b, c]| 0.5 * (b - a).cross(c - a)).collect()
}

/// Seen along the filling's normal, which points up, all triangles are upright; returns their area as it is seen from above.
fn upright_area(mesh: &SurfaceMesh) -> f64 {
    let areas = filling(mesh);
    let sum: DVec3 = areas.iter().sum();
    let least = areas.iter().map(|area| area.dot(sum.normalize())).fold(f64::INFINITY, f64::min);
    assert!(least > 0.0 && sum.z > 0.0, "an area of {least}, in all {sum}");
    sum.z
}

/// A grid of `size` × `size` cells in the plane, or bent, without those for which `is_hole` holds.
fn grid_without(size: u32, is_hole: impl Fn(u32, u32) -> bool, place: impl Fn(f64, f64) -> DVec3) -> Surface {
    let row = size + 1;
    let vertices = (0..row * row).map(|v| place(f64::from(v % row), f64::from(v / row))).collect();
    let kept = (0..size * size).map(|cell| [cell % size, cell / size]).filter(|&[i, j]| !is_hole(i, j));
    let triangles = kept.flat_map(|[i, j]| {
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| row * j + i);
        [[a, b, c], [a, c, d]]
    });
    let (vertices, triangles): (Vec<DVec3>, Vec<[u32; 3]>) = (vertices, triangles.collect());
    // without the vertices inside of the hole
    let mut number = vec![None; vertices.len()];
    let mut used = Vec::new();
    let corners = triangles.into_iter().map(|t| {
        t.map(|v| {
            *number[v as usize].get_or_insert_with(|| {
                used.push(vertices[v as usize]);
                used.len() as u32 - 1
            })
        })
    });
    let triangles = corners.collect();
    Surface::new(used, triangles)
}

/// A U and a spiral whose loops have from a dozen to a thousand vertices: the filling has the hole's area, and every
/// triangle of it is upright, in the plane and on a bent sheet.
#[test]
fn holes_of_any_length_and_shape_are_filled_without_overlaps() {
    let u_shape = |k: u32| {
        move |i: u32, j: u32| {
            let (i, j) = (i.wrapping_sub(1), j.wrapping_sub(1));
            i < 3 * k && j < 3 * k && (i < k || i >= 2 * k || j < k)
        }
    };
    let comb = |k: u32| move |i: u32, j: u32| i > 0 && i <= 3 * k && j > 0 && j <= 3 * k && (j == 1 || i % 2 == 1);
    for k in [1, 5, 16, 17, 40, 81] {
        let size = 3 * k + 2;
        let holes: [&dyn Fn(u32, u32) -> bool; 2] = [&u_shape(k), &comb(k)];
        for (shape, is_hole) in holes.into_iter().enumerate() {
            for bend in [0.0, 0.3 / f64::from(size)] {
                let surface = grid_without(size, is_hole, |x, y| DVec3::new(x, y, bend * (x * x - x * y)));
                // the hole's loop may be longer than the square around
                let around = |outline| SurfaceMesh::repaired_around(&surface, outline).unwrap();
                let is_square = |mesh: &SurfaceMesh| {
                    let boundary = &mesh.mesh().vertices()[..mesh.mesh().boundary_count() as usize];
                    boundary.iter().any(|p| p.x == 0.0)
                };
                let mesh = (0..2).map(around).find(is_square).unwrap();
                let sum = upright_area(&mesh);
                let cells = (0..size * size).filter(|c| is_hole(c % size, c / size)).count();
                println!("{shape}, k = {k}, bend {bend:.3}: area {sum} of {cells}");
                assert!((sum - cells as f64).abs() < 1e-9 * sum, "{sum}, not {cells}");
            }
        }
    }
}

/// Loops of 256 and 257 vertices around a U: once the one was joined and the other one a fan with overlaps.
#[test]
fn a_vertex_more_changes_no_method() {
    for name in ["uhole_loop256.obj", "uhole_loop257.obj"] {
        let path = format!("{}/tests/data/surfaces/{name}", env!("CARGO_MANIFEST_DIR"));
        let surface = read_surface(name, &std::fs::read(path).unwrap()).unwrap();
        let mesh = SurfaceMesh::repaired(&surface).unwrap();
        let signed = |chain: &[u32]| -> f64 {
            let place = |k: usize| mesh.mesh().vertices()[chain[k % chain.len()] as usize];
            (0..chain.len()).map(|k| 0.5 * place(k).cross(place(k + 1)).z).sum()
        };
        // holes are traversed clockwise
        let hole: f64 = mesh.holes().iter().map(|hole| -signed(hole)).sum();
        let sum = upright_area(&mesh);
        println!("{name}: area {sum} in a hole of {hole}");
        assert!((sum - hole).abs() < 1e-9 * hole, "{sum} and {hole}");
    }
}

//! Splits ears, so that no sharp corner is without an interior neighbor.
//!
//! An ear is a triangle with two boundary edges: the sharp convex corner between
//! them has boundary neighbors only. There ψ is 0, and where the boundary map
//! takes the corner to a straight stretch, the ear's image is a segment, Q = ∞.
//! Splitting the ear's third edge at its midpoint gives the corner an interior
//! neighbor; Lawson's flips make all edges Delaunay again, so that the
//! cotangent weights stay non-negative.

use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec2;

/// Cosine of the largest corner angle whose ear is split, 120°: at a blunter corner the midpoint of
/// the third edge would lie closer to the corner than half a boundary edge.
const BLUNT: f64 = -0.5;

/// Splits every ear with a sharp corner. The number of triangles stays `m + 2n − 2`.
pub(super) fn split_ears(mesh: &mut TriMesh) {
    for t in 0..mesh.triangles.len() as u32 {
        if let Some([i, j]) = sharp_ear(mesh, t) {
            let parts = split(mesh, t, i, j);
            restore_delaunay(mesh, parts);
        }
    }
}

/// For a sharp ear, the corner opposite to its inner edge: its index in the ear and in the triangle across.
fn sharp_ear(mesh: &TriMesh, t: u32) -> Option<[usize; 2]> {
    let neighbours = mesh.neighbours[t as usize];
    let mut inner = (0..3).filter(|&i| neighbours[i] != NO_TRIANGLE);
    let (Some(i), None) = (inner.next(), inner.next()) else { return None };
    let [c, a, b] = positions(mesh, t as usize, i);
    let sharp = (a - c).normalize_or_zero().dot((b - c).normalize_or_zero()) > BLUNT;
    let j = mesh.neighbours[neighbours[i] as usize].iter().position(|&s| s == t)?;
    sharp.then_some([i, j])
}

/// The corners of triangle `t`, from corner `i` on.
fn positions(mesh: &TriMesh, t: usize, i: usize) -> [DVec2; 3] {
    std::array::from_fn(|k| mesh.vertices[mesh.triangles[t][(i + k) % 3] as usize])
}

/// The cotangent of the angle under which `p` sees the edge.
fn cotangent(p: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    (a - p).dot(b - p) / (a - p).perp_dot(b - p).abs()
}

/// Inserts a vertex p at the midpoint of the edge (a, b) between the ear `t` = (c, a, b)
/// and `s` = (w, b, a): four triangles (c, a, p), (c, p, b), (w, b, p), (w, p, a).
/// Returns the last two.
fn split(mesh: &mut TriMesh, t: u32, i: usize, j: usize) -> [u32; 2] {
    let s = mesh.neighbours[t as usize][i];
    let corner = |t: u32, k: usize| mesh.triangles[t as usize][k % 3];
    let ([c, a, b], w) = ([corner(t, i), corner(t, i + 1), corner(t, i + 2)], corner(s, j));
    let beyond = |t: u32, k: usize| mesh.neighbours[t as usize][k % 3];
    let ([bc, ca], [aw, wb]) = ([beyond(t, i + 1), beyond(t, i + 2)], [beyond(s, j + 1), beyond(s, j + 2)]);
    let p = mesh.vertices.len() as u32;
    let (t2, s2) = (mesh.triangles.len() as u32, mesh.triangles.len() as u32 + 1);
    mesh.vertices.push(0.5 * (mesh.vertices[a as usize] + mesh.vertices[b as usize]));
    mesh.triangles[t as usize] = [c, a, p];
    mesh.neighbours[t as usize] = [s2, t2, ca];
    mesh.triangles[s as usize] = [w, b, p];
    mesh.neighbours[s as usize] = [t2, s2, wb];
    mesh.triangles.extend([[c, p, b], [w, p, a]]);
    mesh.neighbours.extend([[s, bc, t], [t, aw, s]]);
    replace_neighbour(mesh, bc, t, t2);
    replace_neighbour(mesh, aw, s, s2);
    [s, s2]
}

/// Lawson's flips of the edges opposite to the newest vertex, until all are Delaunay.
fn restore_delaunay(mesh: &mut TriMesh, parts: [u32; 2]) {
    let p = mesh.vertices.len() as u32 - 1;
    let mut pending = parts.to_vec();
    while let Some(t) = pending.pop() {
        let Some(k) = mesh.triangles[t as usize].iter().position(|&v| v == p) else { continue };
        let outer = mesh.neighbours[t as usize][k];
        if outer == NO_TRIANGLE {
            continue;
        }
        let Some(l) = mesh.neighbours[outer as usize].iter().position(|&n| n == t) else { continue };
        let [here, x, y] = positions(mesh, t as usize, k);
        let there = positions(mesh, outer as usize, l)[0];
        if cotangent(here, [x, y]) + cotangent(there, [x, y]) < 0.0 {
            flip(mesh, [t, outer], k, l);
            pending.extend([t, outer]);
        }
    }
}

/// Flips the edge (x, y) between `t` = (p, x, y) and `o` = (q, y, x) to (p, q):
/// `t` becomes (p, x, q) and `o` becomes (p, q, y).
fn flip(mesh: &mut TriMesh, [t, o]: [u32; 2], k: usize, l: usize) {
    let corner = |t: u32, k: usize| mesh.triangles[t as usize][k % 3];
    let beyond = |t: u32, k: usize| mesh.neighbours[t as usize][k % 3];
    let ([p, x, y], q) = ([corner(t, k), corner(t, k + 1), corner(t, k + 2)], corner(o, l));
    let ([yp, px], [xq, qy]) = ([beyond(t, k + 1), beyond(t, k + 2)], [beyond(o, l + 1), beyond(o, l + 2)]);
    mesh.triangles[t as usize] = [p, x, q];
    mesh.neighbours[t as usize] = [xq, o, px];
    mesh.triangles[o as usize] = [p, q, y];
    mesh.neighbours[o as usize] = [qy, yp, t];
    replace_neighbour(mesh, xq, o, t);
    replace_neighbour(mesh, yp, t, o);
}

/// Replaces the neighbor `old` of triangle `t` (if it is one) by `new`.
fn replace_neighbour(mesh: &mut TriMesh, t: u32, old: u32, new: u32) {
    if let Some(neighbours) = mesh.neighbours.get_mut(t as usize) {
        neighbours.iter_mut().filter(|n| **n == old).for_each(|n| *n = new);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::mesh::{Sizing, mesh_domain};

    #[test]
    fn corner_of_a_square_gets_an_interior_neighbour() {
        let side = |a: DVec2, b: DVec2| (0..10).map(move |k| a.lerp(b, f64::from(k) / 10.0));
        let [a, b, c, d] = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let boundary: Vec<DVec2> = side(a, b).chain(side(b, c)).chain(side(c, d)).chain(side(d, a)).collect();
        for sizing in [Sizing::Uniform, Sizing::Graded(0.15)] {
            let mesh = mesh_domain(&boundary, sizing).unwrap().0;
            assert_eq!(mesh.check_invariants(), Ok(()));
            assert_eq!(mesh.triangles.len(), 40 + 2 * mesh.interior_count() - 2);
            for corner in [0, 10, 20, 30] {
                let seen = mesh.triangles.iter().filter(|t| t.contains(&corner)).flatten().any(|&v| v >= 40);
                assert!(seen, "{sizing:?}: corner {corner} has boundary neighbours only");
            }
        }
    }

    #[test]
    fn two_ears_on_one_edge_are_both_split() {
        let boundary = [DVec2::ZERO, DVec2::X, DVec2::new(1.0, 1.1), DVec2::Y];
        let mut mesh = TriMesh {
            vertices: boundary.to_vec(),
            boundary_count: 4,
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            neighbours: vec![[NO_TRIANGLE, 1, NO_TRIANGLE], [NO_TRIANGLE, NO_TRIANGLE, 0]],
        };
        split_ears(&mut mesh);
        assert_eq!((mesh.triangles.len(), mesh.interior_count()), (4, 1));
        assert_eq!(mesh.check_invariants(), Ok(()));
    }
}

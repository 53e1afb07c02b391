//! Final numbering: vertices and triangles in a coherent order, neighbors filled in.

use super::MeshError;
use super::planar::Interior;
use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec2;

/// Builds the mesh of `boundary` and `interior`.
///
/// Triangles start with their smallest vertex and are sorted by it, so those at
/// the boundary come first, in the boundary's order. Interior points that belong to no
/// triangle are dropped. Cost O(n).
pub(super) fn assemble(boundary: &[DVec2], interior: Interior) -> Result<TriMesh, MeshError> {
    let m = boundary.len();
    let mut used = vec![false; m + interior.points.len()];
    interior.triangles.iter().flatten().for_each(|&v| used[v as usize] = true);
    let mut number: Vec<u32> = (0..used.len() as u32).collect();
    let mut vertices = boundary.to_vec();
    for &k in interior.order.iter().filter(|&&k| used[m + k as usize]) {
        number[m + k as usize] = vertices.len() as u32;
        vertices.push(interior.points[k as usize]);
    }
    let triangles = sorted(interior.triangles, &number, vertices.len());
    let neighbours = neighbours_of(&triangles, vertices.len());
    let mesh = TriMesh { vertices, boundary_count: m as u32, triangles, neighbours };
    check_disk(&mesh)?;
    Ok(mesh)
}

/// Renumbers, rotates the smallest vertex to the front and sorts by it.
fn sorted(mut triangles: Vec<[u32; 3]>, number: &[u32], vertex_count: usize) -> Vec<[u32; 3]> {
    let mut start = vec![0u32; vertex_count + 1];
    for t in &mut triangles {
        let [a, b, c] = t.map(|v| number[v as usize]);
        *t = if a < b && a < c {
            [a, b, c]
        } else if b < c {
            [b, c, a]
        } else {
            [c, a, b]
        };
        start[t[0] as usize + 1] += 1;
    }
    accumulate(&mut start);
    let mut sorted = vec![[0; 3]; triangles.len()];
    for t in triangles {
        let place = &mut start[t[0] as usize];
        sorted[*place as usize] = t;
        *place += 1;
    }
    sorted
}

fn accumulate(counts: &mut [u32]) {
    for k in 1..counts.len() {
        counts[k] += counts[k - 1];
    }
}

/// For each triangle the triangles across the edges opposite to its corners.
///
/// Half-edges are grouped by their smaller vertex, and matched within a group.
/// Cost O(n) for bounded degrees, O(n log n) at worst.
pub(crate) fn neighbours_of(triangles: &[[u32; 3]], vertex_count: usize) -> Vec<[u32; 3]> {
    let ends = |half: u32| {
        let (t, i) = (&triangles[half as usize / 3], half as usize % 3);
        (t[(i + 1) % 3], t[(i + 2) % 3])
    };
    let halves = 0..3 * triangles.len() as u32;
    let mut start = vec![0u32; vertex_count + 1];
    for (u, v) in halves.clone().map(ends) {
        start[u.min(v) as usize + 1] += 1;
    }
    accumulate(&mut start);
    let mut grouped = vec![(0u32, 0u32); halves.len()];
    let mut place = start.clone();
    for half in halves {
        let (u, v) = ends(half);
        let slot = &mut place[u.min(v) as usize];
        grouped[*slot as usize] = (u.max(v), half);
        *slot += 1;
    }
    let mut neighbours = vec![[NO_TRIANGLE; 3]; triangles.len()];
    for w in start.windows(2) {
        let group = &mut grouped[w[0] as usize..w[1] as usize];
        group.sort_unstable();
        for pair in group.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            let (a, b) = (pair[0].1 as usize, pair[1].1 as usize);
            neighbours[a / 3][a % 3] = (b / 3) as u32;
            neighbours[b / 3][b % 3] = (a / 3) as u32;
        }
    }
    neighbours
}

/// Checks the triangles at the boundary and their number, which rounding may have made inconsistent.
fn check_disk(mesh: &TriMesh) -> Result<(), MeshError> {
    let m = mesh.boundary_count;
    let at_boundary = mesh.triangles.iter().take_while(|t| t[0] < m);
    let bad = at_boundary.into_iter().find(|&&t| mesh.orientation(t) <= 0.0);
    let expected = m as usize + 2 * mesh.interior_count() - 2;
    if bad.is_none() && mesh.triangles.len() == expected {
        return Ok(());
    }
    let place = mesh.vertices[bad.map_or(0, |t| t[0] as usize)];
    Err(MeshError::TooThin { x: place.x, y: place.y })
}

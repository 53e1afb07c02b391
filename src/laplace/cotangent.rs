//! Assembly of the cotangent Laplacian with Dirichlet boundary (appendix A).
//!
//! Off-diagonal entries are −½(cot α + cot β), α and β the angles opposite to the
//! edge; the diagonal makes the rows of [L̂ L̄] sum to zero. On a Delaunay mesh
//! every off-diagonal entry is ≤ 0: L̂ is an M-matrix. The edges of a planar mesh
//! are Delaunay by exact predicates, so a weight that comes out negative is the
//! rounding of a needle's cotangent, and is taken as 0.

use super::LaplaceError;
use crate::geometry::DVec2;
use crate::mesh::{NO_TRIANGLE, TriMesh};
use sprs::CsMatI;

/// An edge whose two cotangents cancel to this relative size belongs to four
/// cocircular vertices: its exact weight is 0. Observed: lattice seeds give
/// |w| ≤ 3e-16 relative; the smallest real weights of refined meshes exceed 1e-9.
const COCIRCULAR: f64 = 1e-13;

/// The blocks of the cotangent Laplacian that belong to the interior vertices.
#[derive(Debug, Clone)]
pub struct DirichletLaplacian {
    /// L̂, n×n, symmetric; the upper triangle by columns, rows ascending.
    pub interior: CsMatI<f64, u32>,
    /// L̄, n×m, by columns (one per boundary vertex), rows ascending.
    pub coupling: CsMatI<f64, u32>,
}

impl DirichletLaplacian {
    /// Assembles L̂ and L̄ of `mesh`. Cost O(triangles).
    pub fn assemble(mesh: &TriMesh) -> Result<Self, LaplaceError> {
        let edges = weighted_edges(mesh);
        if let Some(&(a, _, _)) = edges.iter().find(|(_, _, weight)| !weight.is_finite()) {
            let DVec2 { x, y } = mesh.vertices[a as usize];
            return Err(LaplaceError::Degenerate { x, y });
        }
        let (m, n) = (mesh.boundary_count as usize, mesh.interior_count());
        let mut diagonal = vec![0.0; n];
        let (mut interior, mut coupling) = (Vec::with_capacity(edges.len() + n), Vec::new());
        for &(a, b, w) in &edges {
            // a < b, so b is the interior one if either is
            let Some(j) = (b as usize).checked_sub(m) else { continue };
            diagonal[j] += w;
            if let Some(i) = (a as usize).checked_sub(m) {
                diagonal[i] += w;
                interior.push((i as u32, j as u32, -w));
            } else {
                coupling.push((j as u32, a, -w));
            }
        }
        interior.extend(diagonal.iter().enumerate().map(|(i, &d)| (i as u32, i as u32, d)));
        Ok(Self { interior: by_columns(n, n, &interior)?, coupling: by_columns(n, m, &coupling)? })
    }
}

/// Every edge `(a, b, weight)` once, `a < b`; the weight is ½(cot α + cot β).
fn weighted_edges(mesh: &TriMesh) -> Vec<(u32, u32, f64)> {
    let mut edges = Vec::with_capacity(mesh.triangles.len() * 3 / 2 + mesh.boundary_count as usize);
    for (t, (corners, neighbours)) in mesh.triangles.iter().zip(&mesh.neighbours).enumerate() {
        for i in 0..3 {
            let other = neighbours[i];
            if other != NO_TRIANGLE && other < t as u32 {
                continue;
            }
            let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            let here = cotangent_at(mesh, corners[i], a, b);
            let there = match mesh.triangles.get(other as usize) {
                Some(corners) => opposite(corners, a, b).map_or(0.0, |c| cotangent_at(mesh, c, b, a)),
                None => 0.0,
            };
            let sum = here + there;
            let cancelled = sum.abs() <= COCIRCULAR * (here.abs() + there.abs()) && sum.is_finite();
            let weight = if cancelled || sum < 0.0 && sum.is_finite() { 0.0 } else { 0.5 * sum };
            edges.push((a.min(b), a.max(b), weight));
        }
    }
    edges
}

/// The corner of a triangle that is neither `a` nor `b`.
fn opposite(corners: &[u32; 3], a: u32, b: u32) -> Option<u32> {
    corners.iter().copied().find(|&c| c != a && c != b)
}

/// The cotangent of the angle at `c` in the counter-clockwise triangle `(c, a, b)`.
fn cotangent_at(mesh: &TriMesh, c: u32, a: u32, b: u32) -> f64 {
    let at = |v: u32| mesh.vertices[v as usize];
    let (u, v): (DVec2, DVec2) = (at(a) - at(c), at(b) - at(c));
    u.dot(v) / u.perp_dot(v)
}

/// A compressed-column matrix from entries `(row, column, value)`, no two at one place.
fn by_columns(rows: usize, columns: usize, entries: &[(u32, u32, f64)]) -> Result<CsMatI<f64, u32>, LaplaceError> {
    let starts = |key: &dyn Fn(&(u32, u32, f64)) -> u32, count: usize| {
        let mut starts = vec![0_u32; count + 1];
        for entry in entries {
            starts[key(entry) as usize + 1] += 1;
        }
        for k in 0..count {
            starts[k + 1] += starts[k];
        }
        starts
    };
    // two stable counting sorts: by row, then by column
    let mut next = starts(&|e| e.0, rows);
    let mut by_row = vec![(0, 0, 0.0); entries.len()];
    for entry in entries {
        by_row[next[entry.0 as usize] as usize] = *entry;
        next[entry.0 as usize] += 1;
    }
    let pointers = starts(&|e| e.1, columns);
    let mut next = pointers.clone();
    let (mut indices, mut values) = (vec![0; entries.len()], vec![0.0; entries.len()]);
    for (row, column, value) in by_row {
        let place = next[column as usize] as usize;
        (indices[place], values[place]) = (row, value);
        next[column as usize] += 1;
    }
    CsMatI::try_new_csc((rows, columns), pointers, indices, values)
        .map_err(|(_, _, _, error)| LaplaceError::Structure(error.to_string()))
}

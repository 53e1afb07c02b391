//! Assembly of the cotangent Laplacian with Dirichlet boundary (appendix A).
//!
//! Off-diagonal entries are −½(cot α + cot β), α and β the angles opposite to the
//! edge; the diagonal makes the rows of [L̂ L̄] sum to zero. On a Delaunay mesh
//! every off-diagonal entry is ≤ 0: L̂ is an M-matrix. The edges of a planar mesh
//! are Delaunay by exact predicates, so a negative computed weight is the
//! rounding of a needle's cotangent, and is set to 0. For surfaces the cotangents come from edge
//! lengths; where edges were not flipped to Delaunay, negative weights are kept.

use super::LaplaceError;
use crate::geometry::DVec2;
use crate::mesh::{IntrinsicMesh, TriMesh, VertexId};
use sprs::CsMatI;

/// An edge whose two cotangents cancel to this relative size belongs to four
/// cocircular vertices: its exact weight is 0. Observed: lattice seeds give
/// |w| ≤ 3e-16 relative; the smallest real weights of refined meshes exceed 1e-9.
const COCIRCULAR: f64 = 1e-13;

/// The blocks of the cotangent Laplacian that belong to the interior vertices.
#[derive(Debug, Clone)]
pub struct DirichletLaplacian {
    pub(super) interior: CsMatI<f64, u32>,
    pub(super) coupling: CsMatI<f64, u32>,
}

/// Triangles glued along their edges, with the cotangents of their angles.
trait Angles {
    fn triangles(&self) -> &[[u32; 3]];

    /// The triangle and corner across the edge opposite to corner `i`; `None` for a boundary edge.
    fn across(&self, t: usize, i: usize) -> Option<(usize, usize)>;

    /// The cotangent of the angle at corner `i`.
    fn cotangent(&self, t: usize, i: usize) -> f64;

    /// Whether the triangulation is Delaunay, so that negative weights are rounding errors.
    fn is_delaunay(&self) -> bool;
}

impl Angles for TriMesh {
    fn triangles(&self) -> &[[u32; 3]] {
        self.triangles()
    }

    fn across(&self, t: usize, i: usize) -> Option<(usize, usize)> {
        let other = self.neighbours()[t][i];
        let corners = self.triangles().get(other as usize)?;
        let (a, b) = (self.triangles()[t][(i + 1) % 3], self.triangles()[t][(i + 2) % 3]);
        Some((other as usize, corners.iter().position(|&c| c != a && c != b)?))
    }

    fn cotangent(&self, t: usize, i: usize) -> f64 {
        let [c, a, b] = [0, 1, 2].map(|k| self.vertices()[self.triangles()[t][(i + k) % 3] as usize]);
        let (u, v): (DVec2, DVec2) = (a - c, b - c);
        u.dot(v) / u.perp_dot(v)
    }

    fn is_delaunay(&self) -> bool {
        true
    }
}

impl Angles for IntrinsicMesh {
    fn triangles(&self) -> &[[u32; 3]] {
        self.triangles()
    }

    fn across(&self, t: usize, i: usize) -> Option<(usize, usize)> {
        self.across(t, i)
    }

    fn cotangent(&self, t: usize, i: usize) -> f64 {
        self.cotangent(t, i)
    }

    fn is_delaunay(&self) -> bool {
        self.is_delaunay()
    }
}

impl DirichletLaplacian {
    /// L̂, n×n, symmetric; the upper triangle by columns, rows ascending.
    pub fn interior(&self) -> &CsMatI<f64, u32> {
        &self.interior
    }

    /// L̄, n×m, by columns (one per boundary vertex), rows ascending.
    pub fn coupling(&self) -> &CsMatI<f64, u32> {
        &self.coupling
    }

    /// [`Self::coupling`] by value.
    pub(crate) fn into_coupling(self) -> CsMatI<f64, u32> {
        self.coupling
    }

    /// Assembles L̂ and L̄ of `mesh`. Cost O(triangles).
    pub fn assemble(mesh: &TriMesh) -> Result<Self, LaplaceError> {
        Self::of(mesh, mesh.boundary_count(), mesh.vertices().len(), &|a| {
            let DVec2 { x, y } = mesh.vertices()[a as usize];
            LaplaceError::Degenerate { x, y }
        })
    }

    /// As [`Self::assemble`], for a surface. If the mesh is not Delaunay, weights may be negative:
    /// L̂ is still positive definite, but no M-matrix.
    pub(crate) fn assemble_intrinsic(mesh: &IntrinsicMesh) -> Result<Self, LaplaceError> {
        Self::of(mesh, mesh.boundary_count(), mesh.vertex_count(), &|vertex| LaplaceError::DegenerateAt {
            vertex: VertexId::new(vertex),
        })
    }

    fn of(
        mesh: &impl Angles,
        boundary_count: u32,
        vertex_count: usize,
        degenerate: &dyn Fn(u32) -> LaplaceError,
    ) -> Result<Self, LaplaceError> {
        let edges = weighted_edges(mesh, boundary_count);
        if let Some(&(a, _, _)) = edges.iter().find(|(_, _, weight)| !weight.is_finite()) {
            return Err(degenerate(a));
        }
        let m = boundary_count as usize;
        let n = vertex_count - m;
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

/// Every edge `(a, b, weight)` once, `a < b`; the weight is ½(cot α + cot β). An edge that joins a vertex to
/// itself does not contribute to the Laplacian and is left out.
fn weighted_edges(mesh: &impl Angles, boundary_count: u32) -> Vec<(u32, u32, f64)> {
    let triangles = mesh.triangles();
    let mut edges = Vec::with_capacity(triangles.len() * 3 / 2 + boundary_count as usize);
    for (t, corners) in triangles.iter().enumerate() {
        for i in 0..3 {
            let across = mesh.across(t, i);
            let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            if across.is_some_and(|other| other < (t, i)) || a == b {
                continue;
            }
            let here = mesh.cotangent(t, i);
            let there = across.map_or(0.0, |(other, j)| mesh.cotangent(other, j));
            let sum = here + there;
            let cancelled = sum.abs() <= COCIRCULAR * (here.abs() + there.abs()) && sum.is_finite();
            let rounding = mesh.is_delaunay() && sum < 0.0 && sum.is_finite();
            edges.push((a.min(b), a.max(b), if cancelled || rounding { 0.0 } else { 0.5 * sum }));
        }
    }
    edges
}

/// A compressed-column matrix from entries `(row, column, value)`; entries at the same position are added
/// (an intrinsic triangulation may have several edges between two vertices).
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
    let pointers = add_repeated(&pointers, &mut indices, &mut values);
    CsMatI::try_new_csc((rows, columns), pointers, indices, values)
        .map_err(|(_, _, _, error)| LaplaceError::Structure(error.to_string()))
}

/// Adds the values of equal rows in each column; returns the new column pointers.
fn add_repeated(pointers: &[u32], indices: &mut Vec<u32>, values: &mut Vec<f64>) -> Vec<u32> {
    let (mut kept, mut shortened) = (0, Vec::with_capacity(pointers.len()));
    shortened.push(0);
    for pair in pointers.windows(2) {
        let start = kept;
        for k in pair[0] as usize..pair[1] as usize {
            if kept > start && indices[kept - 1] == indices[k] {
                values[kept - 1] += values[k];
            } else {
                (indices[kept], values[kept]) = (indices[k], values[k]);
                kept += 1;
            }
        }
        shortened.push(kept as u32);
    }
    indices.truncate(kept);
    values.truncate(kept);
    shortened
}

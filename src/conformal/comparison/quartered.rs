//! A surface with every triangle cut into four.

use super::super::{KernelMode, MeshedSurface, PrepareError, PreparedSide, Stage, SurfaceSettings, prepare_surface};
use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceMesh, TopologyError};
use std::collections::BTreeMap;

/// The surface with every triangle cut into four at the middles of its edges, in the order of the surface: at its corners, in
/// the middle. Vertices keep their numbers.
fn quartered(mesh: &SurfaceMesh) -> Surface {
    let mesh = mesh.mesh();
    let mut vertices: Vec<DVec3> = mesh.vertices().to_vec();
    let mut middles = BTreeMap::new();
    let mut triangles = Vec::with_capacity(4 * mesh.triangles().len());
    for &[a, b, c] in mesh.triangles() {
        let [p, q, r] = [(a, b), (b, c), (c, a)].map(|(u, v)| {
            *middles.entry((u.min(v), u.max(v))).or_insert_with(|| {
                vertices.push(vertices[u as usize].midpoint(vertices[v as usize]));
                (vertices.len() - 1) as u32
            })
        });
        triangles.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]);
    }
    Surface::new(vertices, triangles)
}

/// The same surface on a mesh with four times the triangles, prepared.
///
/// Errors: as [`prepare_surface`], and cutting at rounded middles could in principle make a triangle degenerate.
pub fn prepare_quartered(
    surface: &MeshedSurface,
    settings: SurfaceSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, QuarteredError> {
    let mesh = SurfaceMesh::new(&quartered(surface.surface()))?;
    Ok(prepare_surface(mesh, SurfaceSettings { kernel: KernelMode::Adjoint, ..settings }, progress)?)
}

/// Why a surface with four times the triangles could not be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuarteredError {
    /// The finer triangles are not a disk.
    #[error(transparent)]
    Topology(#[from] TopologyError),
    /// They could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
}

//! The planar mesher: constrained Delaunay refinement inside a sampled boundary.

use super::TriMesh;
use crate::geometry::DVec2;

/// How the size of the triangles varies over the domain.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sizing {
    /// Area at most h²/2, h the mean boundary edge length (the paper's); n = O(m²).
    Uniform,
    /// The size grows by this much per distance from the boundary; n = O(m log m).
    Graded(f64),
}

impl Default for Sizing {
    fn default() -> Self {
        Self::Graded(0.15)
    }
}

/// What the refinement did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RefineReport {
    /// Whether every triangle meets the limits (else the vertex budget ran out).
    pub complete: bool,
    /// How many interior vertices the refinement added to the seeds.
    pub added: usize,
}

/// Why a boundary could not be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The samples do not form a simple polygon (too few of them for this outline).
    #[error("the sampled boundary crosses itself near ({x}, {y}): use more samples")]
    SelfCrossing {
        /// Where.
        x: f64,
        /// Where.
        y: f64,
    },
}

/// Meshes the inside of the counter-clockwise polygon `boundary`.
///
/// The mesh's boundary vertices are exactly `boundary`, in order.
pub fn mesh_domain(boundary: &[DVec2], sizing: Sizing) -> Result<(TriMesh, RefineReport), MeshError> {
    let _ = sizing; // skeleton: a fan about the centroid
    let m = boundary.len() as u32;
    let mut vertices = boundary.to_vec();
    vertices.push(boundary.iter().sum::<DVec2>() / f64::from(m));
    let triangles = (0..m).map(|k| [k, (k + 1) % m, m]).collect();
    let neighbours = (0..m).map(|k| [(k + 1) % m, (k + m - 1) % m, u32::MAX]).collect();
    Ok((TriMesh { vertices, boundary_count: m, triangles, neighbours }, RefineReport { complete: true, added: 1 }))
}

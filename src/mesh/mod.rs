//! Triangle meshes of a domain: made by [`mesh_domain`], searched by [`locate`].

mod assemble;
mod ears;
mod error;
mod graded;
mod hex_lattice;
mod level_grid;
mod locate;
mod nearest;
mod planar;
mod row_spans;
mod tri_mesh;
mod triangulate;

pub use error::MeshError;
pub use locate::{BarycentricPoint, locate};
pub use nearest::nearest_inside;
pub use planar::{MAX_INTERIOR, RefineReport, Sizing, mesh_domain};
pub use tri_mesh::{BrokenInvariant, NO_TRIANGLE, TriMesh};

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

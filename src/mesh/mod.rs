//! Triangle meshes of a domain: made by [`mesh_domain`], searched by [`locate`];
//! triangulations of surfaces by edge lengths: `IntrinsicMesh`.

mod assemble;
mod disk_walk;
mod ears;
mod error;
mod graded;
mod hex_lattice;
mod ids;
mod intrinsic;
mod intrinsic_delaunay;
mod level_grid;
mod locate;
mod nearest;
mod planar;
mod row_spans;
mod tri_mesh;
mod triangulate;

#[cfg(feature = "io")]
pub(crate) use assemble::neighbours_of;
pub(crate) use disk_walk::DiskLayout;
pub use error::MeshError;
pub use ids::{TriangleId, VertexId};
pub(crate) use intrinsic::IntrinsicMesh;
pub use intrinsic_delaunay::FlipReport;
pub use locate::{BarycentricPoint, locate};
pub use nearest::nearest_inside;
pub use planar::{MAX_INTERIOR, RefineReport, Sizing, mesh_domain};
pub(crate) use tri_mesh::NO_TRIANGLE;
pub use tri_mesh::{BrokenInvariant, TriMesh};
pub(crate) use triangulate::polygon_triangles;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

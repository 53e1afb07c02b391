//! Triangle meshes of a domain: made by [`mesh_domain`], searched by [`locate`].

mod locate;
mod planar;
mod tri_mesh;

pub use locate::{BarycentricPoint, locate};
pub use planar::{MeshError, RefineReport, Sizing, mesh_domain};
pub use tri_mesh::{NO_TRIANGLE, TriMesh};

//! Surfaces: triangle meshes in space, from files or formulas, made ready to be parameterized.
//!
//! | step | file |
//! |---|---|
//! | bytes → [`Surface`] (feature `io`) | `read` |
//! | what a reader did, and where in the file | `note` |
//! | what its connectivity is, and what keeps it from being a disk | `survey`, `duplicates`, `topology_error` |
//! | repairs that are safe, each told | `repair`, `fill` |
//! | boundary loop first, interior after | `disk` |
//! | the default interior point | `farthest` |
//! | the point under a ray, the point nearest to a place | `tree`, `nearest` |
//! | surfaces by formula | `preset`, `head` |
//!
//! Positions are [`DVec3`]; the map needs only the lengths of the edges.

mod disk;
mod duplicates;
mod edges;
mod farthest;
mod fill;
mod head;
mod nearest;
mod note;
mod orient;
mod preset;
#[cfg(feature = "io")]
mod read;
mod repair;
mod survey;
#[cfg(test)]
mod tests;
mod topology_error;
mod tree;
#[cfg(test)]
mod tree_tests;

pub use disk::SurfaceMesh;
pub use farthest::{at_vertex, farthest_from_boundary};
pub use nearest::{nearest_on_boundary, nearest_on_boundary_to_ray};
pub use note::{Place, SurfaceNote};
pub use preset::{SurfacePreset, UnknownSurfacePreset};
#[cfg(feature = "io")]
pub use read::{
    ENDINGS, Fault, Item, MAX_BYTES, MAX_CORNERS, MAX_TRIANGLES, SurfaceError, Unsupported, names_format, read_surface,
};
pub(crate) use repair::ADDED;
pub use repair::RepairNote;
pub use survey::{MAX_COORDINATE, MIN_EXTENT};
pub use topology_error::{LISTED, LoopReport, TopologyError};
pub use tree::SurfaceTree;

use crate::geometry::DVec3;

/// Triangles in space, as a file gives them: nothing is known about their connectivity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    /// The positions, finite, in the file's order.
    pub vertices: Vec<DVec3>,
    /// Vertex triples; polygons of the file are cut into consecutive triangles.
    pub triangles: Vec<[u32; 3]>,
    /// What was done to the file's contents.
    pub notes: Vec<SurfaceNote>,
}

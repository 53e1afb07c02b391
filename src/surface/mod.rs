//! Surfaces: triangle meshes in space, from files or formulas, made ready to be parameterized.
//!
//! | step | file |
//! |---|---|
//! | bytes → [`Surface`] | `read` |
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
mod orient;
mod preset;
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
pub use preset::{SurfacePreset, UnknownSurfacePreset};
pub use read::{ENDINGS, MAX_BYTES, MAX_CORNERS, MAX_TRIANGLES, Place, SurfaceError, names_format, read_surface};
pub use repair::{ADDED, RepairNote, Repaired, repair};
pub use topology_error::{LoopReport, TopologyError};
pub use tree::SurfaceTree;

use crate::counted::counted;
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

/// What a reader did that its user should know.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SurfaceNote {
    /// Polygons were cut into triangles.
    #[error("{}", counted!(*polygons, "1 polygon was cut into triangles", "{polygons} polygons were cut into triangles"))]
    Triangulated {
        /// How many.
        polygons: usize,
        /// How many faces the file has.
        faces: usize,
    },
    /// Vertices at exactly the same place were made one (formats that repeat them).
    #[error("{before} corners at {after} places were made {after} vertices")]
    Welded {
        /// How many the file has.
        before: usize,
        /// How many are left.
        after: usize,
    },
    /// The file goes on after all that it counts at its beginning.
    #[error("{place}: more follows than the file says it has; it was passed over")]
    Surplus {
        /// Where it begins.
        place: Place,
    },
}

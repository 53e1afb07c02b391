//! Surfaces: triangle meshes in space, from files or formulas, prepared for parameterization.
//!
//! | step | file |
//! |---|---|
//! | bytes → [`Surface`] (feature `io`) | `read` |
//! | changes made by a reader, positions in files | `note` |
//! | connectivity, and reasons why a surface is not a disk | `survey`, `duplicates`, `topology_error` |
//! | all faults of a surface at once | `diagnosis` |
//! | all places of a fault, for a picture | `faults` |
//! | safe repairs, each reported | `repair`, `fill`, `flat_filling` |
//! | numbering: boundary loop first, interior after | `disk` |
//! | the filled boundary loops, and the triangles without their filling | `holes` |
//! | the default interior point | `farthest` |
//! | the point under a ray, the point nearest to a given one | `tree`, `nearest` |
//! | surfaces by formula | `preset`, `head` |
//!
//! Positions are [`DVec3`]; the map needs only the lengths of the edges.

mod diagnosis;
mod disk;
mod duplicates;
mod edges;
mod farthest;
mod faults;
mod fill;
mod flat_filling;
mod head;
mod holes;
mod mend;
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
pub use faults::Faults;
pub use nearest::{nearest_on_boundary, nearest_on_boundary_to_ray};
pub use note::{Place, SurfaceNote};
pub use preset::{SurfacePreset, UnknownSurfacePreset};
#[cfg(feature = "io")]
pub use read::{
    ENDINGS, Fault, Item, MAX_BYTES, PackedGltf, SurfaceError, SurfaceFormat, Unsupported, check_size, names_format,
    packed, read_surface, read_surface_beside,
};
#[cfg(feature = "io")]
pub(crate) use read::{
    Element, Encoding, GlbChunks, GltfPart, ObjCorner, ObjFile, ObjLine, PlyFile, PlyValue, Property, Scalar, Shape,
    container, decoded, distinct, vertex_color,
};
pub use repair::RepairNote;
pub use survey::{MAX_COORDINATE, MIN_EXTENT};
#[cfg(feature = "io")]
pub(crate) use survey::{is_sound, repeats};
#[cfg(feature = "io")]
pub(crate) use topology_error::Bracketed;
pub use topology_error::{LISTED, LoopReport, TopologyError};
pub use tree::SurfaceTree;

use crate::geometry::DVec3;
use crate::mesh::VertexId;

/// Triangles in space as a file gives them; their connectivity is unchecked.
///
/// Only [`SurfaceMesh::new`] and [`SurfaceMesh::repaired`] check: indices out of range, positions that are not
/// finite and every reason why a surface is not a disk are found there.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    notes: Vec<SurfaceNote>,
    /// Of each vertex of the file the one into which it was merged, if any was.
    merged: Option<Vec<u32>>,
}

impl Surface {
    /// A surface from positions and vertex triples (indices into `vertices`, counted from 0), without notes.
    pub fn new(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self { vertices, triangles, notes: Vec::new(), merged: None }
    }

    /// The same surface with the notes of its reader in place of those it had.
    #[must_use]
    pub fn with_notes(self, notes: Vec<SurfaceNote>) -> Self {
        Self { notes, ..self }
    }

    /// The positions in the file's order, as read; [`SurfaceMesh`] rejects those that are not finite.
    pub fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Vertex triples; the triangles of one polygon of the file are consecutive.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The index of the vertex of number `number` in the file, counted from 0: that into which it was merged.
    pub fn vertex_in_file(&self, number: u32) -> Option<u32> {
        match &self.merged {
            Some(merged) => merged.get(number as usize).copied(),
            None => ((number as usize) < self.vertices.len()).then_some(number),
        }
    }

    /// The number of vertices of the file.
    pub fn count_in_file(&self) -> usize {
        self.merged.as_ref().map_or(self.vertices.len(), Vec::len)
    }

    /// The fault with the numbers that vertices have in the file, the first of those that were merged.
    fn in_file(&self, fault: TopologyError) -> TopologyError {
        let Some(merged) = &self.merged else { return fault };
        let mut first: Vec<Option<u32>> = vec![None; self.vertices.len()];
        for (number, &vertex) in (0..).zip(merged) {
            first[vertex as usize].get_or_insert(number);
        }
        let number = |v: VertexId| first.get(v.index()).copied().flatten().map_or(v, VertexId::new);
        fault.renumbered(&number, &|triangle| triangle)
    }

    /// Changes that the reader made to the file's contents.
    pub fn notes(&self) -> &[SurfaceNote] {
        &self.notes
    }
}

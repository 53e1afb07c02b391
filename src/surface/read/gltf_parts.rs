//! The triangles of a GLB file by primitives, for writing it again with other texture coordinates.

use super::gltf::{Document, Primitive};
use super::gltf_buffers::Buffers;
use super::{GlbChunks, Item, Place, SurfaceError};
use crate::surface::survey::repeats;

/// Triangles of a document: those of a mesh's primitive, placed by a node.
#[derive(Debug)]
pub(crate) struct GltfPart {
    /// The index of the mesh, and that of the primitive in it.
    pub primitive: [usize; 2],
    /// The number of its vertices.
    pub vertices: usize,
    /// Vertex triples as in the file, counted from the part's first vertex.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the node turns triangles over.
    pub is_mirrored: bool,
}

impl GltfPart {
    /// The corners of a triangle so that it is not turned over, and back.
    pub(crate) fn upright(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        if self.is_mirrored { [a, c, b] } else { [a, b, c] }
    }
}

impl GlbChunks<'_> {
    /// The parts of the default scene in the order in which a surface is read from them. Errors: a buffer is in another file.
    pub(crate) fn parts(&self) -> Result<Vec<GltfPart>, SurfaceError> {
        let missing = |name: &str, item| SurfaceError::missing(Place::Part(name.to_owned()), item);
        let document: Document =
            serde_json::from_slice(self.document).map_err(|_| missing("the document", Item::JsonChunk))?;
        let buffers = Buffers::new(&document, self.buffer, &mut |_| None)?;
        let mut parts = Vec::new();
        for (node, transform) in document.placed_nodes()? {
            let Some(mesh) = document.nodes[node].mesh else { continue };
            let found = document.meshes.get(mesh).ok_or_else(|| missing("meshes", Item::Mesh(mesh)))?;
            for (k, primitive) in found.primitives.iter().enumerate().filter(|(_, found)| has_triangles(found)) {
                let position = primitive.attributes.position.ok_or_else(|| missing("meshes", Item::Position))?;
                let vertices = buffers.points(position)?.len();
                let indices = match primitive.indices {
                    Some(accessor) => buffers.indices(accessor)?,
                    None => (0..vertices as u32).collect(),
                };
                let (triangles, is_mirrored) = (triangles(primitive, &indices), transform.determinant() < 0.0);
                parts.push(GltfPart { primitive: [mesh, k], vertices, triangles, is_mirrored });
            }
        }
        Ok(parts)
    }
}

fn has_triangles(primitive: &Primitive) -> bool {
    primitive.mode.is_none_or(|mode| mode >= 4)
}

/// The triangles of a list, a strip or a fan.
fn triangles(primitive: &Primitive, indices: &[u32]) -> Vec<[u32; 3]> {
    let turned = |(k, &[a, b, c]): (usize, &[u32; 3])| if k.is_multiple_of(2) { [a, b, c] } else { [b, a, c] };
    match primitive.mode {
        Some(5) => indices.array_windows().enumerate().map(turned).filter(|corners| !repeats(corners)).collect(),
        Some(6) => {
            let around = indices.array_windows().skip(1).map(|&[b, c]| [indices[0], b, c]);
            around.filter(|corners| !repeats(corners)).collect()
        }
        _ => indices.as_chunks().0.to_vec(),
    }
}

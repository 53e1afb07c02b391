//! The parts of a surface file that an error can name.

use crate::counted::counted;

/// A missing part of a file. Names and counts are those of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Item {
    /// GLB: the version.
    #[error("the version")]
    Version,
    /// GLB: the length of the file.
    #[error("the length of the file")]
    FileLength,
    /// GLB: the length of a chunk.
    #[error("the length of a chunk")]
    ChunkLength,
    /// GLB: the type of a chunk.
    #[error("the type of a chunk")]
    ChunkType,
    /// GLB: the bytes of a chunk.
    #[error("{}", counted!(*length, "a chunk of 1 byte", "a chunk of {length} bytes"))]
    Chunk {
        /// Length of the chunk in bytes.
        length: usize,
    },
    /// GLB: the chunk with the document.
    #[error("the JSON chunk")]
    JsonChunk,
    /// glTF: a mesh that a node names.
    #[error("meshes[{0}]")]
    Mesh(usize),
    /// glTF: the default scene.
    #[error("the default scene")]
    DefaultScene,
    /// glTF: a node.
    #[error("the node")]
    Node,
    /// glTF: the positions of a primitive.
    #[error("the attribute POSITION")]
    Position,
    /// glTF: the content of a buffer.
    #[error("the data")]
    Data,
    /// glTF: an accessor.
    #[error("the accessor")]
    Accessor,
    /// glTF: a buffer view.
    #[error("the bufferView")]
    BufferView,
    /// glTF: a buffer.
    #[error("the buffer")]
    Buffer,
    /// glTF: the bytes of a buffer view.
    #[error("a part of the data that its bufferView describes")]
    ViewedData,
    /// glTF: an element of an accessor.
    #[error("element {index} of {count}")]
    Element {
        /// Index of the element, from 0.
        index: usize,
        /// Number of elements.
        count: usize,
    },
    /// OFF: the line of a vertex.
    #[error("a vertex")]
    Vertex,
    /// OFF: the line of a face.
    #[error("a face")]
    Face,
    /// OFF: the number of corners of a face.
    #[error("the number of corners")]
    CornerCount,
    /// OFF: a corner of a face.
    #[error("corner {index} of {count}")]
    Corner {
        /// Number of the corner, from 1.
        index: usize,
        /// Number of corners of the face.
        count: usize,
    },
    /// OFF: the first word.
    #[error("the keyword OFF")]
    OffKeyword,
    /// OFF: the number of vertices.
    #[error("the number of vertices")]
    VertexCount,
    /// OFF: the number of faces.
    #[error("the number of faces")]
    FaceCount,
    /// PLY: the length of a list.
    #[error("the length of a list")]
    ListLength,
    /// PLY: the value of a property.
    #[error("a property")]
    Property,
    /// PLY: the items of a list.
    #[error("a list")]
    List,
    /// PLY: the property of a coordinate in the header.
    #[error("the property {0} of the element vertex")]
    VertexProperty(&'static str),
    /// PLY: the value of a coordinate.
    #[error("a coordinate of a vertex")]
    VertexCoordinate,
    /// PLY: the property of a face's corner list in the header.
    #[error("the property vertex_indices of the element face")]
    FaceProperty,
    /// PLY: the value of a corner.
    #[error("a corner of a face")]
    FaceCorner,
    /// PLY: the number of elements.
    #[error("the number of elements")]
    ElementCount,
    /// PLY: the element that a property belongs to.
    #[error("the element of a property")]
    PropertyElement,
    /// PLY: the header's line `format`.
    #[error("the line format")]
    FormatLine,
    /// PLY: the header's last line.
    #[error("the line end_header")]
    HeaderEnd,
    /// PLY: a property's name.
    #[error("the name of a property")]
    PropertyName,
    /// Binary OFF: a coordinate, normal or color.
    #[error("a number of a vertex or of a color")]
    OffNumber,
    /// STL: the number of triangles.
    #[error("the number of triangles")]
    TriangleCount,
    /// STL: a triangle's normal.
    #[error("the normal of a triangle")]
    TriangleNormal,
    /// STL: a triangle's corner.
    #[error("a corner of triangle {triangle} of {count}")]
    TriangleCorner {
        /// Index of the triangle, from 0.
        triangle: usize,
        /// Number of triangles.
        count: usize,
    },
    /// STL: the bytes after a triangle's corners.
    #[error("the end of a triangle")]
    TriangleEnd,
    /// STL: the keyword that ends a loop of corners, or the surface.
    #[error("{0}")]
    Keyword(&'static str),
    /// OBJ, OFF, STL: the value of a coordinate.
    #[error("the coordinate {0} of a vertex")]
    Coordinate(&'static str),
}

/// A part of a format that is not supported.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unsupported {
    /// glTF or GLB of an unsupported version.
    #[error("version {0} of glTF")]
    Version(u32),
    /// A glTF extension that changes where positions or indices are stored.
    #[error("{0} (decode it: gltf-transform cp in.glb out.glb)")]
    Extension(String),
    /// glTF: a mesh whose shape morph targets change.
    #[error("morph targets with weights (apply them in the program that made them)")]
    Morphing,
    /// glTF: a buffer in a separate file.
    #[error("the separate file \"{0}\" (put it beside this one or drop both, use .glb, or embed it)")]
    SeparateFile(String),
    /// glTF: an embedded buffer with an encoding other than base 64.
    #[error("data that is not in base 64")]
    Encoding,
    /// OFF with another number of dimensions, with its keyword.
    #[error("a surface in 4 or n dimensions ({0})")]
    Dimensions(String),
}

//! The file formats of maps, other than pictures.

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileFormat {
    /// Vector graphics: outlines, lines of the pattern and edges of a planar map; the edges of a surface's layout.
    Svg,
    /// A table: the boundary correspondence of a planar map; a line for each vertex of a surface.
    Csv,
    /// Wavefront: positions, a `vt` for each, triangles.
    Obj,
    /// Stanford, ascii: positions with s and t, triangles.
    Ply,
    /// Binary glTF: one mesh with texture coordinates, in f32.
    Glb,
}

impl FileFormat {
    /// The formats of a surface with texture coordinates: all.
    pub const SURFACE: [Self; 5] = [Self::Obj, Self::Ply, Self::Glb, Self::Csv, Self::Svg];
    /// The formats of a planar map.
    pub const PLANAR: [Self; 3] = [Self::Svg, Self::Csv, Self::Obj];

    /// The file extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Csv => "csv",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Glb => "glb",
        }
    }

    /// The format with this extension, in upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::SURFACE.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

//! What maps can be written as, besides pictures.

/// A kind of file.
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
    /// Those of a surface with texture coordinates: all of them.
    pub const SURFACE: [Self; 5] = [Self::Obj, Self::Ply, Self::Glb, Self::Csv, Self::Svg];
    /// Those of a planar map.
    pub const PLANAR: [Self; 3] = [Self::Svg, Self::Csv, Self::Obj];

    /// The extension of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Csv => "csv",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Glb => "glb",
        }
    }

    /// By a file's extension, in either case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::SURFACE.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

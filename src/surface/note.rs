//! Changes that a reader of surfaces made to a file's contents, and positions in files.

use crate::counted::counted;

/// A position in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// A line of text, counted from 1.
    Line(usize),
    /// A byte, counted from 0.
    Byte(usize),
    /// A part of a glTF document, such as `accessors[3]`.
    Part(String),
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(offset) => write!(f, "byte {offset}"),
            Self::Part(part) => write!(f, "{part}"),
        }
    }
}

/// A change made by a reader that its user should know.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceNote {
    /// Polygons were cut into triangles.
    #[error("{}", counted!(*polygons, "1 polygon was cut into triangles", "{polygons} polygons were cut into triangles"))]
    Triangulated {
        /// Number of polygons.
        polygons: usize,
        /// Number of faces in the file.
        faces: usize,
    },
    /// Vertices at exactly the same position were merged (in formats that repeat them).
    #[error("{before} corners at {after} places were made {after} vertices")]
    Welded {
        /// Number of vertices in the file.
        before: usize,
        /// Number of vertices after merging.
        after: usize,
    },
    /// The file continues after everything that its counts announce.
    #[error("{place}: more follows than the file says it has; it was passed over")]
    Surplus {
        /// Where the surplus begins.
        place: Place,
    },
}

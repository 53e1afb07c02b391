//! What a reader of surfaces did to a file's contents, and where in the file.

use crate::counted::counted;

/// Where in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// A line of text, from 1.
    Line(usize),
    /// A byte, from 0.
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

/// What a reader did that its user should know.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
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

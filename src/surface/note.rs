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
    /// Vertices at the same position were merged, exactly or within a billionth of the surface's size.
    #[error("{before} corners at {after} places were made {after} vertices")]
    Welded {
        /// Number of vertices in the file.
        before: usize,
        /// Number of vertices after merging.
        after: usize,
    },
    /// Vertices at the position of others stay: merged, the surface would be no disk.
    #[error("{}", counted!(
        *vertices,
        "1 vertex stays apart from another one at the same place: joined, the surface would be no disk",
        "{vertices} vertices stay apart from others at the same places: joined, the surface would be no disk"
    ))]
    LeftApart {
        /// Number of vertices that merging would have removed.
        vertices: usize,
    },
    /// Faces with fewer than three corners were dropped.
    #[error("{}", counted!(
        *count,
        "1 face with fewer than 3 corners was dropped",
        "{count} faces with fewer than 3 corners were dropped"
    ))]
    DroppedFaces {
        /// Number of faces dropped.
        count: usize,
    },
    /// A text STL file does not end with the line `endsolid`.
    #[error("the last line, endsolid, is missing; if the file was cut off, so is the surface")]
    Unended,
    /// The file continues after everything that its counts announce.
    #[error("{place}: more follows than the file says it has; it was passed over")]
    Surplus {
        /// Where the surplus begins.
        place: Place,
    },
}

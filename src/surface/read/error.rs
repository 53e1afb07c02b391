//! Why a file is no surface, and where in it.

use super::faces::MAX_CORNERS;
use super::{Fault, Item, MAX_BYTES, MAX_TRIANGLES, Unsupported};
use crate::counted::counted;
use crate::surface::Place;

/// Why a file is no surface, and where in it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// More than [`MAX_BYTES`].
    #[error("the file has {bytes} bytes; surfaces up to {} MiB can be read", MAX_BYTES >> 20)]
    TooLarge {
        /// Its size.
        bytes: usize,
    },
    /// More than [`MAX_TRIANGLES`].
    #[error("{place}: more than {MAX_TRIANGLES} triangles")]
    TooManyTriangles {
        /// Where the first one too many is.
        place: Place,
    },
    /// Neither the extension nor the first bytes say what it is.
    #[error("\".{extension}\" is no surface format that is known: obj, ply, stl, off, gltf, glb")]
    UnknownFormat {
        /// The file's extension.
        extension: String,
    },
    /// Something else where a number was needed.
    #[error("{place}: \"{found}\" is not a number")]
    NotANumber {
        /// Where.
        place: Place,
        /// The text there, shortened.
        found: String,
    },
    /// A coordinate that is NaN or infinite.
    #[error("{place}: a coordinate of vertex {vertex} is not a finite number")]
    NotFinite {
        /// Where.
        place: Place,
        /// The vertex, from 0.
        vertex: usize,
    },
    /// Something is missing.
    #[error("{place}: {what} is missing")]
    Missing {
        /// Where.
        place: Place,
        /// What.
        what: Item,
    },
    /// A face names a vertex that does not exist.
    #[error("{}", counted!(
        *vertices,
        "{place}: a face names vertex {index}, but the file has 1 vertex",
        "{place}: a face names vertex {index}, but the file has {vertices} vertices"
    ))]
    IndexOutOfRange {
        /// Where.
        place: Place,
        /// As the file writes it.
        index: i64,
        /// How many there are.
        vertices: usize,
    },
    /// A face with fewer than 3 corners or more than [`MAX_CORNERS`].
    #[error("{}", counted!(
        *count,
        "{place}: a face has 1 corner; 3 to {MAX_CORNERS} are possible",
        "{place}: a face has {count} corners; 3 to {MAX_CORNERS} are possible"
    ))]
    Corners {
        /// Where.
        place: Place,
        /// How many it has.
        count: usize,
    },
    /// Not built as the format says.
    #[error("{place}: {fault}")]
    Malformed {
        /// Where.
        place: Place,
        /// What is wrong.
        fault: Fault,
    },
    /// A part of the format that is not read.
    #[error("{place}: {what} cannot be read")]
    Unsupported {
        /// Where.
        place: Place,
        /// What it is.
        what: Unsupported,
    },
    /// No face at all.
    #[error("the file has no faces")]
    NoTriangles,
}

impl SurfaceError {
    pub(super) fn missing(place: Place, what: Item) -> Self {
        Self::Missing { place, what }
    }

    pub(super) fn malformed(place: Place, fault: Fault) -> Self {
        Self::Malformed { place, fault }
    }

    pub(super) fn unsupported(place: Place, what: Unsupported) -> Self {
        Self::Unsupported { place, what }
    }
}

//! Why a file is not a surface, and where in the file.

use super::{Fault, Item, MAX_BYTES, Unsupported};
use crate::counted::counted;
use crate::surface::Place;

/// Why a file is not a surface, and where in the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// The file is larger than [`MAX_BYTES`].
    #[error("the file has {bytes} bytes; surfaces up to {} MiB can be read", MAX_BYTES >> 20)]
    TooLarge {
        /// Size of the file.
        bytes: usize,
    },
    /// The surface and its map take more memory than there is.
    #[error(
        "the surface has {triangles} triangles and {vertices} vertices, which take about {needed_mb} MB of memory; \
         {available_mb} MB are available"
    )]
    TooMuchMemory {
        /// The number of triangles.
        triangles: usize,
        /// The number of vertices.
        vertices: usize,
        /// The memory that the surface and its map take, in megabytes (10⁶ bytes).
        needed_mb: usize,
        /// The memory that there is.
        available_mb: usize,
    },
    /// Neither the extension nor the first bytes determine the format.
    #[error("\".{extension}\" is no surface format that is known: obj, ply, stl, off, gltf, glb")]
    UnknownFormat {
        /// The file's extension.
        extension: String,
    },
    /// The text where a number was expected is not one.
    #[error("{place}: \"{found}\" is not a number")]
    NotANumber {
        /// The place in the file.
        place: Place,
        /// The text there, shortened.
        found: String,
    },
    /// A required part of the file is missing.
    #[error("{place}: {what} is missing")]
    Missing {
        /// The place in the file.
        place: Place,
        /// The missing part.
        what: Item,
    },
    /// A face names a vertex that does not exist.
    #[error("{}", counted!(
        *vertices,
        "{place}: a face names vertex {index}, but the file has 1 vertex",
        "{place}: a face names vertex {index}, but the file has {vertices} vertices"
    ))]
    IndexOutOfRange {
        /// The place in the file.
        place: Place,
        /// The index as written in the file.
        index: i64,
        /// Number of vertices.
        vertices: usize,
    },
    /// The structure of the file does not agree with its format.
    #[error("{place}: {fault}")]
    Malformed {
        /// The place in the file.
        place: Place,
        /// The structural error.
        fault: Fault,
    },
    /// The file uses a part of the format that is not supported.
    #[error("{place}: {what} cannot be read")]
    Unsupported {
        /// The place in the file.
        place: Place,
        /// The unsupported part.
        what: Unsupported,
    },
    /// The file has no faces.
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

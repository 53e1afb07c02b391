//! What is built otherwise in a surface file than its format says.

use super::Item;
use crate::counted::counted;

/// What is not built as the format says. Words are those of the file, shortened.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Fault {
    /// The first bytes of a GLB file are others.
    #[error("a GLB file begins with glTF")]
    NotGlb,
    /// The document is not JSON, or not glTF: what its reader says.
    #[error("no glTF: {0}")]
    NotGltf(String),
    /// A node of glTF is its own descendant, or has two parents.
    #[error("the node stands twice in the tree")]
    NodeTwice,
    /// The corners of a glTF primitive are no triples.
    #[error("{}", counted!(*count, "1 corner is no triangle", "{count} corners are no whole number of triangles"))]
    CornerCount {
        /// How many there are.
        count: usize,
    },
    /// A glTF primitive of another mode than those of the standard.
    #[error("unknown mode {0}")]
    Mode(u32),
    /// The numbers of a glTF accessor are of another type.
    #[error("{found} of component type {component} where {needed} was needed")]
    AccessorType {
        /// The accessor's type.
        found: String,
        /// Its component type.
        component: u32,
        /// The type that was needed.
        needed: &'static str,
    },
    /// A character that base 64 does not have.
    #[error("no base 64: character {position} of the data does not belong")]
    Base64 {
        /// Where, from 0.
        position: usize,
    },
    /// The length of a PLY list is negative, broken or too large.
    #[error("a list of length {0}")]
    ListLength(f64),
    /// The first word of a PLY file is another.
    #[error("a PLY file begins with the word ply")]
    NotPly,
    /// A line of a PLY header begins with another word than those of the standard.
    #[error("unknown word {0}")]
    UnknownWord(String),
    /// A PLY encoding that does not exist.
    #[error("unknown format {0}")]
    UnknownFormat(String),
    /// A PLY type that does not exist.
    #[error("\"{0}\" is no type")]
    NoType(String),
    /// The length of a PLY list has a type with a fractional part.
    #[error("the length of a list is no whole number")]
    ListLengthType,
    /// A count is negative.
    #[error("{what} is {found}")]
    Count {
        /// Of what.
        what: Item,
        /// What stands there.
        found: String,
    },
}

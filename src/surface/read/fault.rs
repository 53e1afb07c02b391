//! Structural errors of a surface file: contents that do not agree with its format.

use super::Item;
use crate::counted::counted;

/// A structural error. Quoted words are those of the file, shortened.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// The file does not begin with the signature of GLB.
    #[error("a GLB file begins with glTF")]
    NotGlb,
    /// The document is not JSON, or not glTF, with its reader's message.
    #[error("no glTF: {0}")]
    NotGltf(String),
    /// A node of glTF is its own descendant, or has two parents.
    #[error("the node stands twice in the tree")]
    NodeTwice,
    /// The number of corners of a glTF primitive is not a multiple of 3.
    #[error("{}", counted!(*count, "1 corner is no triangle", "{count} corners are no whole number of triangles"))]
    CornerCount {
        /// Number of corners.
        count: usize,
    },
    /// The mode of a glTF primitive is not one of the standard.
    #[error("unknown mode {0}")]
    Mode(u32),
    /// A glTF accessor has the wrong type.
    #[error("{found} of component type {component} where {needed} was needed")]
    AccessorType {
        /// The accessor's type.
        found: String,
        /// The accessor's component type.
        component: u32,
        /// The required type.
        needed: &'static str,
    },
    /// A character that is not part of base 64.
    #[error("no base 64: character {position} of the data does not belong")]
    Base64 {
        /// Position of the character, from 0.
        position: usize,
    },
    /// The length of a PLY list is negative, fractional or too large.
    #[error("a list of length {0}")]
    ListLength(f64),
    /// The file does not begin with `ply`.
    #[error("a PLY file begins with the word ply")]
    NotPly,
    /// A line of a PLY header begins with a word that is not part of the standard.
    #[error("unknown word {0}")]
    UnknownWord(String),
    /// The PLY encoding is unknown.
    #[error("unknown format {0}")]
    UnknownFormat(String),
    /// The PLY type is unknown.
    #[error("\"{0}\" is no type")]
    NoType(String),
    /// The length of a PLY list has a type with a fractional part.
    #[error("the length of a list is no whole number")]
    ListLengthType,
    /// A count is negative.
    #[error("{what} is {found}")]
    Count {
        /// The counted part.
        what: Item,
        /// The text found.
        found: String,
    },
}

//! Indices of vertices and of triangles, as two types that cannot be confused.
//!
//! They are used where a function takes or returns an index. The arrays of a mesh hold bare `u32`, as the GPU and a
//! worker receive them, and loops over those arrays use bare numbers.

use std::fmt;

/// Defines an index type: a `u32` with the conversions that an index needs.
macro_rules! index_type {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
        #[serde(transparent)]
        pub struct $name(u32);

        impl $name {
            /// The index with this number, counted from 0.
            pub const fn new(number: u32) -> Self {
                Self(number)
            }

            /// The index as a `u32`.
            pub const fn number(self) -> u32 {
                self.0
            }

            /// The index as a `usize`, for arrays.
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}

index_type! {
    /// A vertex of a mesh or of a surface, by its position in the list of vertices.
    VertexId
}

index_type! {
    /// A triangle of a mesh or of a surface, by its position in the list of triangles.
    TriangleId
}

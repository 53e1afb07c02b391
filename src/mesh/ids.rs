//! Which vertex, which triangle: numbers of two kinds that are not to be mixed up.
//!
//! They are typed where a function takes or returns them. The arrays of a mesh hold bare `u32`, as the GPU and a
//! worker get them, and loops over those arrays use bare numbers.

use std::fmt;

/// A number of its own type, with what an index needs.
macro_rules! index_type {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
        #[serde(transparent)]
        pub struct $name(u32);

        impl $name {
            /// The `number`-th, from 0.
            pub const fn new(number: u32) -> Self {
                Self(number)
            }

            /// The number.
            pub const fn number(self) -> u32 {
                self.0
            }

            /// The number as an index into an array.
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
    /// A vertex of a mesh or of a surface, by its place in the list of vertices.
    VertexId
}

index_type! {
    /// A triangle of a mesh or of a surface, by its place in the list of triangles.
    TriangleId
}

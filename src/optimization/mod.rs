//! The best map of a family: of all conformal maps of one side onto another the one that minimizes a criterion.
//!
//! The maps have three degrees of freedom: f = g₂⁻¹ ∘ T ∘ g₁ with the sides' maps to the unit disk and a Möbius map T of the
//! disk. [`Optimization`] searches all of them in closed form, then improves the best ones, and at last measures the map
//! itself; what it returns are constraints (x₁, y₁) ↦ (x₂, y₂), with the [`Criterion`] before and after.
//!
//! | file | |
//! |---|---|
//! | `criterion` | what is minimized, measured on a map |
//! | `chart` | a side in the unit disk, with the scale of its map there |
//! | `family` | T ↔ constraints, and the criterion of T in closed form |
//! | `simplex`, `descent` | the downhill simplex, and over Möbius maps |
//! | `compass` | the compass search in the plane |
//! | `soundness` | which candidates are maps |
//! | `search` | scan, descents, polish, in steps with a deadline |
//! | `landscape` | the criterion as a function of x₁ |
//! | `region`, `statistics`, `symmetry` | where, and of what |

mod chart;
mod compass;
mod criterion;
mod descent;
mod family;
mod landscape;
mod region;
mod search;
mod simplex;
mod soundness;
mod statistics;
mod symmetry;

use crate::conformal::MapError;
pub use criterion::Criterion;
pub use landscape::{Landscape, Marks};
pub use region::{Dab, MOST_DABS, MOST_POLYGONS, Region};
pub use search::{Found, Least, Optimization};
pub use symmetry::SharedSymmetries;

/// Why there is no best map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OptimizeError {
    /// The map at the start, or from a side's default point, cannot be computed.
    #[error(transparent)]
    Map(#[from] MapError),
    /// No triangle lies in the region, or only such without an image.
    #[error("the region holds no triangle of the mesh: it lies outside of the source, or is smaller than a triangle")]
    EmptyRegion,
    /// The outlines share no symmetry.
    #[error("the outlines have no symmetry in common: no reflection each, and no rotation by the same angle")]
    NoSharedSymmetry,
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

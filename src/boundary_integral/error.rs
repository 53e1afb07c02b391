//! Why harmonic measure cannot be computed from the boundary.

use crate::geometry::DVec2;

/// Why harmonic measure cannot be computed from the boundary.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum BoundaryIntegralError {
    /// The boundary needs more unknowns than there is room for.
    #[error(
        "the boundary needs at least {needed} unknowns, more than the limit of {limit}: it has too many corners, or parts too close to each other"
    )]
    TooManyUnknowns {
        /// A lower bound of the number of unknowns.
        needed: usize,
        /// The largest number allowed.
        limit: usize,
    },
    /// The factor needs more memory than there is room for.
    #[error(
        "the factor of the boundary's equation needs more than {limit_mb} MB: too many parts of the boundary lie across from each other"
    )]
    TooMuchMemory {
        /// The largest size of a factor, in megabytes.
        limit_mb: usize,
    },
    /// Next to a corner the density is not resolved to any digit that is stated.
    #[error("the boundary is not resolved next to its corner ({}, {})", .at.x, .at.y)]
    CornerNotResolved {
        /// The corner.
        at: DVec2,
    },
    /// Splitting the panels found no end: parts of the boundary touch, or a formula is not smooth.
    #[error("the boundary cannot be resolved: parts of it touch, or a piece is not smooth")]
    NotResolved,
    /// The system of equations has no unique solution in floating point: the boundary crosses itself, or nearly so.
    #[error("the equations of the boundary have no solution: does the boundary cross itself?")]
    Singular,
    /// A point does not lie inside.
    #[error("({}, {}) is not inside the outline", .at.x, .at.y)]
    NotInside {
        /// The point.
        at: DVec2,
    },
}

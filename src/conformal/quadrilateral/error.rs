//! Why a quadrilateral cannot be mapped onto its rectangle.

use crate::boundary_integral::BoundaryIntegralError;
use crate::geometry::CurveError;

/// Why a quadrilateral cannot be mapped onto its rectangle. Marks are counted from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuadrilateralError {
    /// A mark is not a number.
    #[error("mark {mark} is not a finite fraction of the boundary's length")]
    NotFinite {
        /// The mark.
        mark: usize,
    },
    /// Two neighboring marks are one point of the boundary.
    #[error("marks {} and {} are the same point", .marks[0], .marks[1])]
    Coinciding {
        /// The marks.
        marks: [usize; 2],
    },
    /// The marks do not run counter-clockwise.
    #[error(
        "mark {mark} lies beyond mark {}: the marks are not in counter-clockwise cyclic order", .mark % 4 + 1
    )]
    Order {
        /// The first mark that the next one does not follow.
        mark: usize,
    },
    /// Two opposite sides are so far from each other that harmonic measure tells little of one of them from the other.
    #[error(
        "the side from mark {} to {} is too far from the side from mark {} to {}: the quadrilateral is \
             {length:.0} or more times as long as wide, and {} is the limit",
        .side + 1, .side + 2, .side + 3, (.side + 3) % 4 + 1, super::MOST_LENGTH
    )]
    TooLong {
        /// The first of the sides, 0 or 1.
        side: usize,
        /// The extremal distance between them, roughly.
        length: f64,
    },
    /// No point was found from which opposite sides have comparable harmonic measures.
    #[error(
        "no point was found that sees the sides from mark to mark apart: the quadrilateral is too narrow, or two marks are too close to each other"
    )]
    NoMiddle,
    /// The integral equation of the boundary cannot be solved.
    #[error(transparent)]
    BoundaryIntegral(#[from] BoundaryIntegralError),
    /// The rectangle is no curve.
    #[error(transparent)]
    Rectangle(#[from] CurveError),
}

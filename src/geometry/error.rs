//! Why a list of points is not a simple polygon, and where.
//!
//! Indices in the fields count from 0 in the given order; the messages, which
//! people read, count points from 1.

use glam::DVec2;

use super::validate::{MAX_COORDINATE, MAX_POINTS, MIN_EXTENT};

/// Why a list of points is not a simple polygon, and where.
///
/// Edge `k` runs from point `k` to point `k + 1` (cyclic), in the given order.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonError {
    /// Fewer than three points.
    #[error("an outline needs at least 3 points; this one has {count}")]
    TooFewPoints {
        /// Number of points given.
        count: usize,
    },
    /// More than [`MAX_POINTS`] points.
    #[error("an outline may have at most {MAX_POINTS} points; this one has {count}")]
    TooManyPoints {
        /// Number of points given.
        count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("point {} is not finite: ({}, {})", .index + 1, .at.x, .at.y)]
    NotFinite {
        /// Index of the point.
        index: usize,
        /// Its coordinates.
        at: DVec2,
    },
    /// A coordinate is too large to be squared and multiplied safely.
    #[error("point {} at ({:e}, {:e}) is too far out: coordinates up to {MAX_COORDINATE:e} can be used", .index + 1, .at.x, .at.y)]
    TooFarOut {
        /// Index of the point.
        index: usize,
        /// Its coordinates.
        at: DVec2,
    },
    /// All points lie in a box too small for the arithmetic.
    #[error("the outline is only {extent:e} across; it must be at least {MIN_EXTENT:e}")]
    TooSmall {
        /// The longer side of the bounding box.
        extent: f64,
    },
    /// Two points are the same.
    #[error("points {} and {} are the same: ({}, {})", .first + 1, .second + 1, .at.x, .at.y)]
    RepeatedPoint {
        /// Index of the earlier point.
        first: usize,
        /// Index of the later point.
        second: usize,
        /// Their common position.
        at: DVec2,
    },
    /// All points lie on one straight line.
    #[error("the outline encloses no area: all its points lie on one line")]
    ZeroArea,
    /// The boundary turns back onto itself at a point.
    #[error("the outline folds back onto itself at point {}, ({}, {})", .index + 1, .at.x, .at.y)]
    FoldsBack {
        /// Index of the tip of the fold.
        index: usize,
        /// Its position.
        at: DVec2,
    },
    /// Two edges cross in their interiors.
    #[error("the outline crosses itself near ({}, {}): the edge after point {} and the edge after point {}", .at.x, .at.y, .first + 1, .second + 1)]
    EdgesCross {
        /// The edge of smaller index.
        first: usize,
        /// The edge of larger index.
        second: usize,
        /// The crossing, rounded.
        at: DVec2,
    },
    /// An end of one edge lies on another edge.
    #[error("the outline touches itself at ({}, {}): the edge after point {} and the edge after point {}", .at.x, .at.y, .first + 1, .second + 1)]
    EdgesTouch {
        /// The edge of smaller index.
        first: usize,
        /// The edge of larger index.
        second: usize,
        /// The point of contact, a vertex.
        at: DVec2,
    },
}

impl PolygonError {
    /// The position of the fault; `None` if it has no single position.
    pub fn place(&self) -> Option<DVec2> {
        match *self {
            Self::RepeatedPoint { at, .. }
            | Self::FoldsBack { at, .. }
            | Self::EdgesCross { at, .. }
            | Self::EdgesTouch { at, .. } => Some(at),
            Self::TooFewPoints { .. }
            | Self::TooManyPoints { .. }
            | Self::NotFinite { .. }
            | Self::TooFarOut { .. }
            | Self::TooSmall { .. }
            | Self::ZeroArea => None,
        }
    }
}

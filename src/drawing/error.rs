//! Why a drawing is no outline, or a handle cannot go.

use crate::counted::counted;
use crate::geometry::PolygonError;

/// Why a drawing is no outline, or a change of one was not made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// The stroke is a dot.
    #[error("this stroke is too short for an outline: draw around the shape in one go")]
    TooShort,
    /// Fewer than three points were clicked.
    #[error("{}", counted!(
        *count,
        "an outline needs at least 3 points; 1 is set",
        "an outline needs at least 3 points; {count} are set"
    ))]
    TooFewPoints {
        /// How many there are.
        count: usize,
    },
    /// A handle cannot go, because no outline would be left.
    #[error("an outline keeps at least {least} handles: this one cannot go")]
    LastHandles {
        /// How many stay.
        least: usize,
    },
    /// What was drawn is no simple polygon.
    #[error(transparent)]
    Outline(#[from] PolygonError),
}

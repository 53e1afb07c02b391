//! The errors of drawing and reshaping.

use crate::counted::counted;
use crate::geometry::PolygonError;

/// Why a drawing is not an outline, or a change of an outline is impossible.
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
        /// The number of points.
        count: usize,
    },
    /// The handle cannot be removed, because too few would be left.
    #[error("an outline keeps at least {least} handles: this one cannot go")]
    LastHandles {
        /// The smallest number of handles.
        least: usize,
    },
    /// The drawing is not a simple polygon.
    #[error(transparent)]
    Outline(#[from] PolygonError),
}

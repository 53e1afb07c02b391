//! Messages for invalid points, polygons and drawings.

use crate::drawing::DrawingError;
use crate::geometry::{MAX_COORDINATE, MAX_POINTS, MIN_EXTENT, PolygonError};
use crate::language::{Message, key};
use crate::zipper::ZipperError;

impl From<&PolygonError> for Message {
    fn from(error: &PolygonError) -> Self {
        match error {
            PolygonError::TooFewPoints { count } => key::polygon_too_few_points(*count),
            PolygonError::TooManyPoints { count } => key::polygon_too_many_points(MAX_POINTS, *count),
            PolygonError::NotFinite { index, at } => key::polygon_not_finite(index + 1, at.x, at.y),
            PolygonError::TooFarOut { index, at } => key::polygon_too_far_out(
                index + 1,
                format!("{:e}", at.x),
                format!("{:e}", at.y),
                format!("{MAX_COORDINATE:e}"),
            ),
            PolygonError::TooSmall { extent } => {
                key::polygon_too_small(format!("{extent:e}"), format!("{MIN_EXTENT:e}"))
            }
            PolygonError::RepeatedPoint { first, second, at } => {
                key::polygon_repeated_point(first + 1, second + 1, at.x, at.y)
            }
            PolygonError::ZeroArea => key::polygon_zero_area().into(),
            PolygonError::FoldsBack { index, at } => key::polygon_folds_back(index + 1, at.x, at.y),
            PolygonError::EdgesCross { first, second, at } => {
                key::polygon_edges_cross(at.x, at.y, first + 1, second + 1)
            }
            PolygonError::EdgesTouch { first, second, at } => {
                key::polygon_edges_touch(at.x, at.y, first + 1, second + 1)
            }
        }
    }
}

impl From<&DrawingError> for Message {
    fn from(error: &DrawingError) -> Self {
        match error {
            DrawingError::TooShort => key::drawing_too_short().into(),
            DrawingError::TooFewPoints { count } => key::drawing_too_few_points(*count),
            DrawingError::LastHandles { least } => key::drawing_last_handles(*least),
            DrawingError::Outline(error) => error.into(),
        }
    }
}

impl From<&ZipperError> for Message {
    fn from(error: &ZipperError) -> Self {
        match error {
            ZipperError::TooFewPoints { count } => key::zipper_too_few_points(*count),
            ZipperError::NotFinite { index } => key::zipper_not_finite(*index),
            ZipperError::Repeated { index } => key::zipper_repeated(*index),
            ZipperError::PointOutside { x, y } => key::zipper_point_outside(*x, *y),
        }
    }
}

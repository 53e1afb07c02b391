//! Plane geometry: simple polygons, their symmetries, curves of smooth pieces, arc length, robust orientation.
//!
//! Points are [`glam::DVec2`]; polygons are closed without repeating the first
//! point, and counter-clockwise. Nothing here knows about meshes or maps.

mod curve;
mod edge_tree;
mod error;
mod nearness;
mod picture_placement;
mod pole;
mod polygon;
mod predicates;
mod sorting;
mod spline;
mod status;
mod sweep;
mod symmetry;
mod validate;

pub(crate) use curve::gauss_legendre;
pub use curve::{Curve, CurveError, CurvePoint, Jet, Junction, Piece};
pub use edge_tree::{EdgeTree, NearestPoint};
pub use error::PolygonError;
pub use glam::{DMat2, DVec2, DVec3};
pub(crate) use nearness::{ChainPoint, is_nearer, nearest_of_chain, nearest_of_polygon, pulled_back};
pub use picture_placement::{PICTURE_MIDDLE, PICTURE_SIZE, PICTURE_TURN, PictureFrame, PicturePlacement};
pub use polygon::{Bounds, SimplePolygon};
pub use predicates::{Side, on_segment, orientation, side};
pub(crate) use sorting::sort_by_number;
pub use spline::Spline;
pub use symmetry::{Axis, Rotations, SYMMETRY_TOLERANCE, Symmetries};
pub use validate::{MAX_COORDINATE, MAX_POINTS, MIN_EXTENT};

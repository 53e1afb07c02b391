//! Plane geometry: simple polygons, arc length, robust orientation.
//!
//! Points are [`glam::DVec2`]; polygons are closed without repeating the first
//! point, and counter-clockwise. Nothing here knows about meshes or maps.

mod polygon;

pub use glam::DVec2;
pub use polygon::{PolygonError, SimplePolygon};

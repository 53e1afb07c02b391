//! Outlines drawn by hand or reshaped by handles.
//!
//! Pure functions on lists of vertices in the plane. Their results need not be valid outlines:
//! [`crate::geometry::SimplePolygon`] checks whether they are, and reports
//! where they cross themselves.

mod carry;
mod curve;
mod error;
mod freehand;
mod handles;
mod hermite;
mod shape;
mod simplify;
mod smooth;

pub use carry::carried_fraction;
pub use curve::{closed_curve, curve_with_corners};
pub use error::DrawingError;
pub use freehand::freehand;
pub use shape::{Axis, Shape};
pub use simplify::{simplified, simplified_ring};

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

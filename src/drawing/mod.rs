//! Outlines by hand: drawn with the pointer, reshaped by a few handles.
//!
//! Everything here is a pure function on lists of vertices in the plane. What comes out
//! is not yet an outline: [`crate::geometry::SimplePolygon`] says whether it is one, and
//! where it crosses itself if it is none.

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

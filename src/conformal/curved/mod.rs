//! Harmonic measure of planar sides from the integral equation on their curves.
//!
//! The finite-element system stays: it extends the boundary map into the mesh, and its positive density continues the
//! measure where that falls below what the integral equation resolves.

mod accuracy;
mod arc_table;
mod boundary;
mod continued;
mod curve_map;
mod curve_measure;
mod equation;
mod error;
mod matching;
mod preparation;
mod sharp;

pub use accuracy::ErrorEstimate;
pub use boundary::CurveBoundary;
pub use curve_map::CurveMap;
pub(super) use curve_measure::{CurveMeasure, nearer};
pub use equation::BoundaryEquation;
#[cfg(feature = "io")]
pub(crate) use equation::FlatEquation;
pub use error::Unsharpened;
pub(super) use matching::match_sharply;
pub(super) use preparation::Outlined;
pub(super) use sharp::{SharpMeasure, Way};

/// The most unknowns of a side's integral equation in a map: the dense factor is then made in less than about a second
/// on one thread. The largest built-in outlines need less; a coast of 1,000 corners needs 16,000 and more.
pub const MAX_UNKNOWNS: usize = 3072;

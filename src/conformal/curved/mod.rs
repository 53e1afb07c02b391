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

/// The most unknowns of a side's integral equation in a map, whose factor is then made in about eight seconds on one thread.
/// The largest built-in outline has 2,400, a coast of 250 corners 12,300, a maple leaf of 601 corners 28,100.
pub const MAX_UNKNOWNS: usize = if cfg!(target_family = "wasm") { 24_576 } else { 65_536 };

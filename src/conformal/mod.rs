//! The conformal map: a prepared domain, Poisson kernels, harmonic measures, their matching, its extension.
//!
//! [`prepare`] does once per outline what takes milliseconds to seconds;
//! [`ConformalMap::update`] does what a drag needs, in a fraction of that.

mod domain;
mod map;

pub use domain::{DomainBuffers, PrepareError, PrepareSettings, PrepareTimings, PreparedDomain, Stage, prepare};
pub use map::{ConformalMap, Constraints, Direction, FrameTimings, MapError, Quality, Side};

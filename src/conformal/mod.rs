//! The conformal map: a prepared domain, Poisson kernels, harmonic measures, their matching, its extension.
//!
//! [`prepare`] does once per outline what takes milliseconds to seconds;
//! [`ConformalMap::update`] does what a drag needs, in a fraction of that:
//!
//! | step | file | paper |
//! |---|---|---|
//! | Poisson kernel ψ at x | `kernel` | (9), (10), (B.2), by the adjoint solve |
//! | harmonic measure ω̃ from y | `measure` | (11), (12) |
//! | boundary correspondence | `matching` | section 3.2, C.4, in a form that does not cancel |
//! | images of the vertices | `extension` | (14) |
//! | angle and area distortion | `distortion`, `histogram` | section 5.1 |

mod buffers;
mod distortion;
mod domain;
mod extension;
mod histogram;
mod kernel;
mod map;
mod matching;
mod measure;
mod stencil;

pub use buffers::DomainBuffers;
pub use distortion::{Quality, TriangleDistortion, triangle_distortions};
pub use domain::{PrepareError, PrepareSettings, PrepareTimings, PreparedDomain, Stage, prepare};
pub use extension::harmonic_extension;
pub use histogram::Histogram;
pub use kernel::{KernelScratch, harmonic_coordinates, poisson_kernel};
pub use map::{ConformalMap, Constraints, Direction, FrameTimings, MapError, Side};
pub use matching::{BoundaryCorrespondence, match_measures};
pub use measure::HarmonicMeasure;

//! Real-time conformal maps between outlines or surfaces.
//!
//! A conformal map `f: Ω₁ → Ω₂` is fixed by one pair of interior points and one
//! pair of boundary points. riemap finds it by matching the harmonic measure of
//! the two boundaries, as in "Real-Time Conformal Maps and Parameterizations".
//!
//! Dependencies between the modules run one way:
//! `geometry → outline, mesh → surface, laplace → conformal → session, export → figures → language → worker`, then
//! `render → model → offscreen → platform → cli, app`.
//! Ten modules are side branches: `boundary_integral` (harmonic measure from the boundary alone, invariants) and
//! `cauchy_integral` (an analytic function inside of a curve from its values on it) on the level of `mesh`; `drawing` (outlines drawn by hand) and `tiling` (regular tilings of the hyperbolic plane) on the level of `outline`; `projection` (map projections of least distortion) on that of `surface`; `zipper` (a map
//! through the disk, for comparison, without a mesh) on that of `conformal`; `closed_form` (the presets' maps that are
//! known exactly), `rational` (maps as formulas) and `optimization` (the best map of a family) on that of `session`; `family` (loops through all maps of one domain
//! onto another) on that of `export`.
//!
//! | feature | what it adds to the numerical core |
//! |---|---|
//! | `io` (default) | outlines and surfaces from files, sessions as links and files, exports, the worker's requests |
//! | `app` (default, implies `io`) | the window, the canvas, the command line |

/// The README's Rust examples, compiled and run as tests of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

pub mod boundary_integral;
pub mod cauchy_integral;
pub mod closed_form;
pub mod conformal;
mod counted;
pub mod drawing;
pub mod exact;
#[cfg(feature = "io")]
pub mod export;
pub mod family;
pub mod figures;
pub mod geometry;
#[cfg(feature = "io")]
pub mod language;
pub mod laplace;
pub mod mesh;
pub mod optimization;
pub mod outline;
pub mod projection;
pub mod rational;
pub mod session;
pub mod surface;
pub mod tiling;
#[cfg(feature = "io")]
mod utf16;
#[cfg(feature = "io")]
pub mod worker;
pub mod zipper;

#[cfg(feature = "app")]
pub mod app;
#[cfg(all(feature = "app", not(target_arch = "wasm32")))]
pub mod cli;
#[cfg(feature = "app")]
pub mod model;
#[cfg(feature = "app")]
pub mod offscreen;
#[cfg(feature = "app")]
pub mod platform;
#[cfg(feature = "app")]
pub mod render;

#[cfg(test)]
#[allow(dead_code, clippy::panic, clippy::unwrap_used, reason = "tests, which use a part of it")]
#[path = "../tests/support/data.rs"]
mod test_data;
#[cfg(test)]
#[path = "../tests/support/random.rs"]
mod test_random;

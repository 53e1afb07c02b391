//! Real-time conformal maps between two outlines.
//!
//! A conformal map `f: Ω₁ → Ω₂` is fixed by one pair of interior points and one
//! pair of boundary points. riemap finds it by matching the harmonic measure of
//! the two boundaries, as in "Real-Time Conformal Maps and Parameterizations".
//!
//! Dependencies between the modules run one way:
//! `geometry → outline, mesh → surface, laplace → conformal → session, worker, export → figures → render → app`.
//! `drawing`, outlines by hand, stands beside `outline`; `zipper`, a map through the disk for comparison, beside
//! `conformal`, and uses no mesh; `closed_form`, the presets' maps that are known exactly, beside `session`; `family`,
//! ways through all maps of one domain onto another, beside `export`.
//! Without the default feature `app` only the numerical core is built.

pub mod closed_form;
pub mod conformal;
mod counted;
pub mod drawing;
pub mod exact;
pub mod export;
pub mod family;
pub mod figures;
pub mod geometry;
pub mod laplace;
pub mod mesh;
pub mod outline;
pub mod session;
pub mod surface;
pub mod worker;
pub mod zipper;

#[cfg(feature = "app")]
pub mod app;
#[cfg(all(feature = "app", not(target_arch = "wasm32")))]
pub mod cli;
#[cfg(feature = "app")]
pub mod platform;
#[cfg(feature = "app")]
pub mod render;

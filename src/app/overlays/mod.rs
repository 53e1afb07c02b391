//! The overlays on the screen: controls and numbers in the panel, ticks, bars, paths and
//! grids over the pictures.
//!
//! Their state and computation are in [`crate::model::overlays`].

pub mod paint;
pub mod panel;
pub mod quadrilateral;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

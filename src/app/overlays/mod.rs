//! The overlays on the screen: controls and numbers in the panel, ticks, bars and paths over the pictures.
//!
//! Their state and computation are in [`crate::model::overlays`].

pub mod paint;
pub mod panel;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

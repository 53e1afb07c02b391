//! The overlays on the screen: controls and figures in the panel, lines and points over the pictures.
//!
//! Their state and their computation are [`crate::model::overlays`].

pub mod paint;
pub mod panel;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

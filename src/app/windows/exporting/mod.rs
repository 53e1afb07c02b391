//! Export of pictures, animations, vector graphics, tables and meshes.
//!
//! The window is in `window`, its form in `settings`; the files are made by [`crate::model::export`].

mod settings;
pub mod window;

pub use window::Exporter;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

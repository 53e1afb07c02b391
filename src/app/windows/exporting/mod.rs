//! Export of pictures, animations, vector graphics, tables, meshes and formulas.
//!
//! The window is in `window`, its form in `settings`, `formula` has what concerns a formula; the files are made by
//! [`crate::model::export`].

mod formula;
pub(super) mod progress;
mod settings;
pub mod window;

pub use window::Exporter;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

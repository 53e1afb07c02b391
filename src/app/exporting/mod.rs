//! Files that leave the app: pictures, animations, vector graphics, tables and meshes.
//!
//! | what | file |
//! |---|---|
//! | what a person wants | `wish` |
//! | the window | `window`, `settings` |
//! | numbers and vector graphics | `files` |
//! | pictures and animations, a frame's share at a time | `job` |
//! | what the app does with them | `app` |

mod app;
mod files;
mod job;
mod settings;
mod window;
mod wish;

pub use files::{FileWish, ReadyFile, file, panel};
pub use window::Exporter;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

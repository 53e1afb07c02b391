//! Files that leave the app: pictures, animations, vector graphics, tables and meshes.
//!
//! | what | file |
//! |---|---|
//! | the window | `window`, `settings` |
//! | what the app does with them | `app` |

mod settings;
pub mod window;

pub use window::Exporter;

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

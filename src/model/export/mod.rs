//! Files that leave the app: pictures, animations, vector graphics, tables, meshes and formulas.
//!
//! | what | file |
//! |---|---|
//! | the requested kind of file and its settings | `request` |
//! | numbers and vector graphics | `files` |
//! | the map as a formula, for its worker | `formula` |

pub mod files;
mod formula;
pub mod request;

pub use files::{FileRequest, ReadyFile, file, panel};

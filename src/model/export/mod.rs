//! Files that leave the app: pictures, animations, vector graphics, tables, meshes and formulas.
//!
//! | what | file |
//! |---|---|
//! | the requested kind of file and its settings | `request` |
//! | numbers and vector graphics | `files` |
//! | the map as a formula, for its worker | `formula` |
//! | the texture's picture for a GLB | `picture_base` |

pub mod files;
mod formula;
mod picture_base;
pub mod request;

pub use files::{FileRequest, ReadyFile, file, flattened, panel};

//! Files that leave the app: pictures, animations, vector graphics, tables and meshes.
//!
//! | what | file |
//! |---|---|
//! | the requested kind of file and its settings | `request` |
//! | numbers and vector graphics | `files` |

pub mod files;
pub mod request;

pub use files::{FileRequest, ReadyFile, file, panel};

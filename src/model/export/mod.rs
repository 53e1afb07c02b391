//! Files that leave the app: pictures, animations, vector graphics, tables and meshes.
//!
//! | what | file |
//! |---|---|
//! | the requested kind of file and its settings | `request` |
//! | numbers and vector graphics | `files` |
//! | pictures and animations, a frame's share at a time | `job` |

pub mod files;
pub mod job;
pub mod request;

pub use files::{FileRequest, ReadyFile, file, panel};

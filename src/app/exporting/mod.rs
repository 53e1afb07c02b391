//! Files that leave the app: pictures, animations, vector graphics, tables and meshes.

mod files;

pub use files::{FileWish, ReadyFile, file, formats, panel};

//! Converts the errors and notes of the rooms below to messages. Each variant has a key; a new variant needs one too.

mod conformal;
mod geometry;
mod mesh;
mod outline;
mod projection;
mod rational;
mod session;
mod surface;
mod surface_file;
mod tiling;

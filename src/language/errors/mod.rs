//! The errors and notes of the rooms below as messages: each variant has a key, which a new one needs too.

mod conformal;
mod geometry;
mod mesh;
mod outline;
mod session;
mod surface;
mod surface_file;

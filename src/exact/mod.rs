//! Closed forms used as reference solutions.

pub mod blob;
mod complex;
pub mod disk;
pub mod ellipse;
pub mod rectangle;
pub mod square;
pub mod vshape;

pub use complex::{Complex, complex, point};
pub(crate) use complex::{arg_sinh, sqrt};

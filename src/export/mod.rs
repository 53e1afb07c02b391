//! What leaves riemap as files, for the command line and the app alike. Pure: bytes out of maps.
//!
//! Surfaces with texture coordinates: file `flattened`. Maps between any two sides: files `numbers` (tables and meshes)
//! and `drawing` (vector graphics of what lies in the plane, with the lines of file `ruling`).

mod drawing;
mod flattened;
mod format;
mod numbers;
mod polylines;
mod ruling;

pub use drawing::{Panel, Part, Wire, panels, parts, svg};
pub use flattened::{Flattened, Placement};
pub use format::FileFormat;
pub use numbers::{boundary_csv, mapped_obj};
pub use polylines::Line;
pub use ruling::Ruling;

//! What leaves riemap as files, for the command line and the app alike. Pure: bytes out of maps.
//!
//! Surfaces with texture coordinates: file `flattened`. Planar maps: files `planar` (tables and meshes)
//! and `drawing` (vector graphics, with the lines of file `ruling`).

mod drawing;
mod flattened;
mod format;
mod planar;
mod polylines;
mod ruling;

pub use drawing::{Panel, Part, Wire, panels, svg};
pub use flattened::{Flattened, Placement};
pub use format::FileFormat;
pub use planar::{BOUNDARY_COLUMNS, boundary_csv, mapped_obj};
pub use polylines::Line;
pub use ruling::Ruling;

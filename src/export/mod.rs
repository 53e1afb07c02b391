//! What leaves riemap as files, for the command line and the app alike. Pure: bytes out of maps.

mod flattened;

pub use flattened::{Flattened, Placement, SurfaceFormat};

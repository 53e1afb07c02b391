//! One side of the model: the requested settings, the request in flight, the last good side, its user error.
//!
//! | what | file |
//! |---|---|
//! | a debounced request to the worker, tagged with its generation | `request` |
//! | the preparation of an outline or a surface | `preparation` |
//! | what is requested of an outline | `outline_request` |
//! | what is requested of a surface | `surface_request` |
//! | the files of surfaces that a person has opened | `surface_files` |
//! | a file or a text that the worker reads as an outline or a session | `opened_file` |
//! | the surface that is shown | `surface` |
//! | the integral equation of an outline | `sharpening` |
//! | all of them, and what is on its way to the side | `state` |
//! | an error beside the input that caused it, and its quick fix | `user_error` |

pub mod opened_file;
mod outline_request;
pub mod preparation;
pub mod request;
pub mod sharpening;
mod state;
mod surface;
mod surface_files;
mod surface_request;
pub mod user_error;

pub use outline_request::OutlineRequest;
pub use state::{ModelSide, Next};
pub use surface::SurfaceSide;
pub use surface_files::SurfaceFiles;
pub use surface_request::SurfaceRequest;

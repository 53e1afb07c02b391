//! One side of the model: the requested settings, the request in flight, the last good side, its user error.
//!
//! | what | file |
//! |---|---|
//! | a debounced request to the worker, tagged with its generation | `request` |
//! | the preparation of an outline | `preparation` |
//! | the preparation of a surface | `surface_preparation` |
//! | the surface that is shown | `surface` |
//! | both of them, and what is on its way to the side | `state` |
//! | an error beside the input that caused it, and its quick fix | `user_error` |

pub mod preparation;
pub mod request;
mod state;
mod surface;
mod surface_preparation;
pub mod user_error;

pub use state::ModelSide;
pub use surface::SurfaceSide;
pub use surface_preparation::{Arrival, SurfacePreparation};

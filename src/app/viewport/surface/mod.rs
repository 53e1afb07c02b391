//! The viewport of a surface in space.
//!
//! | what | file |
//! |---|---|
//! | the camera around it | `orbit` |
//! | gestures and dots | `viewport` |
//! | the boundary loops | `loops` |
//! | uploads | `gpu` |
//! | small pictures of the presets | `picture` |

pub mod gpu;
pub mod loops;
mod orbit;
mod picture;
pub mod viewport;

pub use orbit::OrbitView;
pub use picture::surface_picture;

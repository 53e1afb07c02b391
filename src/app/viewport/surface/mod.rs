//! The viewport of a surface in space.
//!
//! | what | file |
//! |---|---|
//! | the camera around it | `orbit` |
//! | gestures and dots | `viewport` |
//! | uploads | `gpu` |
//! | small pictures of the presets | `picture` |

pub mod gpu;
mod orbit;
mod picture;
pub mod viewport;

pub use orbit::OrbitView;
pub use picture::surface_picture;

//! The surface in the target's place: its preparation, its map, and how it is seen and dragged.
//!
//! | what | file |
//! |---|---|
//! | from a wish to a prepared surface | `preparation` |
//! | the surface and its map, as the model holds them | `side` |
//! | from where it is seen | `orbit` |
//! | gestures and dots in its viewport | `viewport` |
//! | uploads and the callback that draws it | `gpu` |
//! | its controls | `panel` |
//! | small pictures of the presets | `picture` |

pub mod gpu;
mod orbit;
pub mod panel;
mod picture;
mod preparation;
mod side;
pub mod viewport;

pub use orbit::OrbitView;
pub use picture::surface_picture;
pub use preparation::{Arrival, SurfacePreparation};
pub use side::{Advance, SurfaceSide};

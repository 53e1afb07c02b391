//! The surface in the target's place: its preparation, its map, and how it is seen and dragged.
//!
//! | what | file |
//! |---|---|
//! | from a wish to a prepared surface | `preparation` |
//! | the surface and its map, as the model holds them | `side` |
//! | small pictures of the presets | `picture` |

mod picture;
mod preparation;
mod side;

pub use picture::surface_picture;
pub use preparation::{Arrival, SurfacePreparation, Wish};
pub use side::SurfaceSide;

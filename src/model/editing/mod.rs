//! Outlines drawn or changed by hand: state and geometry, independent of the pointer.
//!
//! | content | file |
//! |---|---|
//! | an outline being drawn | `drawing` |
//! | the settings with which an outline is prepared while it is reshaped | `live` |
//! | an outline being reshaped | `reshaping` |
//! | the outline of the largest shape in a picture | `tracing` |

mod drawing;
mod live;
mod reshaping;
pub mod tracing;

pub use drawing::{Drawing, Pen};
pub use live::Reshaped;
pub use reshaping::{Change, Crossing, Hold, Reshaping};

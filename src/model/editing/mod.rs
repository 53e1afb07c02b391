//! Outlines that are made or changed by hand: state and geometry, without the pointer.
//!
//! | what | file |
//! |---|---|
//! | an outline that is being drawn | `drawing` |
//! | how an outline is prepared while it is being reshaped | `live` |
//! | an outline that is being reshaped | `reshaping` |
//! | the outline of the largest shape in a picture | `tracing` |

mod drawing;
mod live;
mod reshaping;
pub mod tracing;

pub use drawing::{Drawing, Pen};
pub use live::Reshaped;
pub use reshaping::{Change, Crossing, Hold, Reshaping};

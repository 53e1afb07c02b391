//! Pictures and films of a session that no window shows: what the model holds, drawn by wgpu.
//!
//! | what | file |
//! |---|---|
//! | domains and surfaces side by side, as a scene | `compose` |
//! | one picture of a session | `draw` |
//! | a picture or a film, a frame's share of work at a time | `job` |

pub mod compose;
mod draw;
pub mod job;

//! The guided tour and lessons: what is played (`course`), the tour's steps (`steps`), what they do by themselves
//! (`motions`), and the card with the words of a step (`card`).

pub mod card;
mod course;
mod motions;
pub mod steps;

use crate::session::Session;
pub use course::{Course, Stop};
pub use motions::Motions;

/// The tour or lesson in progress.
pub struct Tour {
    pub course: Course,
    /// The step that is shown, counted from 0.
    pub step: usize,
    /// The session from before.
    pub before: Session,
    /// Whether the random walks ran before.
    pub walked: bool,
    /// What the step does by itself.
    pub motions: Motions,
    /// Whether this waits until the user asks for it.
    pub is_waiting: bool,
}

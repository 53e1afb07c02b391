//! The guided tour: its steps (`steps`), what they do by themselves (`motions`), and the card with their words (`card`).

pub mod card;
mod motions;
mod steps;

use crate::session::Session;
pub use motions::Motions;
pub use steps::steps;

/// The tour in progress.
pub struct Tour {
    pub step: usize,
    /// The session from before the tour.
    pub before: Session,
    /// Whether the random walks ran before the tour.
    pub walked: bool,
    /// What the step does by itself.
    pub motions: Motions,
}

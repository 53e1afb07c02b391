//! What works beside the frames: the workers that prepare sides and measure, and the mailbox through which they answer.

use crate::platform::{Event, Mailbox, Preparer, StudyRunner};
use std::sync::mpsc;

/// The workers, and the two ends of the way back from them and from files and links.
pub struct Workers {
    pub preparer: Preparer,
    pub study_runner: StudyRunner,
    /// Where events for the app are posted; all of them arrive in `events`.
    pub mailbox: Mailbox,
    pub events: mpsc::Receiver<Event>,
}

impl Workers {
    /// Those of a preparer that posts into `mailbox`, whose other end is `events`.
    pub fn new(preparer: Preparer, mailbox: Mailbox, events: mpsc::Receiver<Event>) -> Self {
        Self { preparer, study_runner: StudyRunner::new(mailbox.clone()), mailbox, events }
    }
}

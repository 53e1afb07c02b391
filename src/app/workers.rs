//! The handles of the workers that prepare sides and run studies, and the channel of their responses.

use crate::platform::{Event, Mailbox, Preparer, StudyRunner};
use std::sync::mpsc;

/// The workers, and both ends of the channel on which they, files and links post events.
pub struct Workers {
    pub preparer: Preparer,
    pub study_runner: StudyRunner,
    /// The sending end; its receiver is `events`.
    pub mailbox: Mailbox,
    pub events: mpsc::Receiver<Event>,
}

impl Workers {
    /// Adds the study runner to a preparer that posts into `mailbox`; `events` is the receiver of `mailbox`.
    pub fn new(preparer: Preparer, mailbox: Mailbox, events: mpsc::Receiver<Event>) -> Self {
        Self { preparer, study_runner: StudyRunner::new(mailbox.clone()), mailbox, events }
    }
}

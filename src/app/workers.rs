//! The handles of the workers that prepare sides and run studies, and the channel of their responses.
//!
//! [`Workers::send_due`] is the one place that sends requests to the workers of the sides; `take_answer` in `incoming`
//! is the one that processes their responses.

use crate::model::Model;
use crate::platform::{Event, Mailbox, Preparer, StudyRunner};
use std::sync::mpsc;

/// The workers, and both ends of the channel on which they, files and links post events.
pub struct Workers {
    pub preparer: Preparer,
    pub study_runner: StudyRunner,
    /// For the invariants, so that a table under way does not delay them.
    pub invariants_runner: StudyRunner,
    /// For formulas, which can be cancelled.
    pub formula_runner: StudyRunner,
    /// The sending end; its receiver is `events`.
    pub mailbox: Mailbox,
    pub events: mpsc::Receiver<Event>,
}

impl Workers {
    /// Starts the workers, with a mailbox for their responses.
    pub fn start() -> Self {
        let (mailbox, events) = Mailbox::new();
        Self {
            preparer: Preparer::new(mailbox.clone()),
            study_runner: StudyRunner::new(mailbox.clone()),
            invariants_runner: StudyRunner::new(mailbox.clone()),
            formula_runner: StudyRunner::new(mailbox.clone()),
            mailbox,
            events,
        }
    }

    /// Sends the requests that are due at the time `now` to the workers of the sides; returns whether any was.
    pub fn send_due(&mut self, model: &mut Model, now: f64) -> bool {
        let requests = model.take_requests(now);
        let sends = !requests.is_empty();
        for (side, request) in requests {
            self.preparer.request(side, request);
        }
        sends
    }
}

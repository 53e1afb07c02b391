//! The page's side of the study worker, which starts with the first study.

use super::messages;
use super::worker_handle::{Heard, State, WorkerHandle};
use crate::platform::{Event, Mailbox};
use crate::worker::{Finding, Study};
use js_sys::Array;

/// Runs studies, one at a time.
pub struct StudyRunner {
    mailbox: Mailbox,
    worker: Option<WorkerHandle>,
}

impl StudyRunner {
    /// A runner whose findings are posted to `mailbox`.
    pub fn new(mailbox: Mailbox) -> Self {
        Self { mailbox, worker: None }
    }

    /// Starts a study; one that is running is superseded.
    pub fn begin(&mut self, study: Study) {
        if self.worker.as_ref().is_none_or(|worker| worker.state() != State::Idle) {
            let read = |message: &_| {
                let (study, finding) = messages::decode_finding(message)?;
                Some(Heard { event: Event::Found { study: Some(study), finding }, goes_on: false })
            };
            let died = |reason| Event::Found { study: None, finding: Finding::Failed(reason) };
            match WorkerHandle::start(&self.mailbox, read, died) {
                Ok(worker) => self.worker = Some(worker),
                Err(error) => self.mailbox.post(died(error.into())),
            }
        }
        let Some(worker) = &self.worker else { return };
        if let Err(reason) = worker.post(&messages::encode_study(&study), &Array::new()) {
            self.mailbox.post(Event::Found { study: Some(study), finding: Finding::Failed(reason.into()) });
        }
    }
}

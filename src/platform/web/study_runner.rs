//! The page's side of the study worker, which starts with the first study.

use super::messages;
use super::worker_handle::{Heard, State, WorkerHandle};
use crate::platform::{Event, Mailbox};
use crate::worker::{Finding, Study};
use js_sys::Array;
use std::cell::RefCell;
use std::rc::Rc;

/// Runs studies, one at a time.
pub struct StudyRunner {
    mailbox: Mailbox,
    worker: Option<WorkerHandle>,
    /// The study that the worker received last.
    running: Rc<RefCell<Option<Study>>>,
}

impl StudyRunner {
    /// A runner whose findings are posted to `mailbox`.
    pub fn new(mailbox: Mailbox) -> Self {
        Self { mailbox, worker: None, running: Rc::default() }
    }

    /// Terminates the worker; the next study starts another one.
    pub fn cancel(&mut self) {
        self.worker = None;
    }

    /// Starts a study; one that is running is superseded.
    pub fn begin(&mut self, study: Study) {
        self.running.replace(Some(study.clone()));
        if self.worker.as_ref().is_none_or(|worker| worker.state() != State::Idle) {
            self.worker = None;
            let running = Rc::clone(&self.running);
            let read = move |message: &_| {
                let finding = messages::decode_finding(message)?;
                let study = running.borrow().clone()?;
                Some(Heard { goes_on: finding.goes_on(), event: Event::Found { study, finding } })
            };
            let running = Rc::clone(&self.running);
            let first = study.clone();
            let died = move |reason| {
                let study = running.borrow().as_ref().unwrap_or(&first).clone();
                Event::Found { study, finding: Finding::Failed(reason) }
            };
            match WorkerHandle::start(&self.mailbox, read, died.clone()) {
                Ok(worker) => self.worker = Some(worker),
                Err(error) => self.mailbox.post(died(error.into())),
            }
        }
        let Some(worker) = &self.worker else { return };
        if let Err(reason) = worker.post(&messages::encode_study(&study), &Array::new()) {
            self.mailbox.post(Event::Found { study, finding: Finding::Failed(reason.into()) });
        }
    }
}

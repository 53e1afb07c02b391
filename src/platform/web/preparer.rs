//! The page's side of the workers that prepare, one for each subject.
//!
//! A request to a busy worker supersedes what it is doing: the worker is
//! terminated and another one takes its place (the module is compiled already).
//! A worker that dies is reported and replaced with the next request.

use super::messages;
use super::worker_handle::{Heard, State, WorkerHandle, describe};
use crate::conformal::Side;
use crate::platform::{Event, Mailbox};
use crate::worker::{Request, Response, Subject};

/// Runs preparations in workers.
pub struct Preparer {
    mailbox: Mailbox,
    workers: [Option<WorkerHandle>; Subject::COUNT],
}

impl Preparer {
    /// Answers go to `mailbox`. The domains' workers start at once, to be ready for the first
    /// request; the surfaces' when there is time, or with its first one.
    pub fn new(mailbox: Mailbox) -> Self {
        let mut preparer = Self { mailbox, workers: Default::default() };
        for side in Side::BOTH {
            preparer.ensure_idle(Subject::Domain(side));
        }
        preparer
    }

    /// Starts to carry out `request`, in place of what the subject's worker may be doing.
    #[allow(clippy::needless_pass_by_value, reason = "on the desktop it goes into a thread")]
    pub fn request(&mut self, subject: Subject, request: Request) {
        let Some(worker) = self.ensure_idle(subject) else { return };
        if let Err(reason) = worker.post(&messages::encode_request(&request)) {
            self.mailbox.post(Event::WorkerDied { subject, reason });
        }
    }

    /// Starts what has not been needed yet and lets it rehearse, now that there is time for it.
    pub fn warm(&mut self) {
        if self.workers[Subject::Surface.index()].is_none()
            && let Some(worker) = self.ensure_idle(Subject::Surface)
        {
            worker.rehearse();
        }
    }

    fn ensure_idle(&mut self, subject: Subject) -> Option<&WorkerHandle> {
        let slot = &mut self.workers[subject.index()];
        if slot.as_ref().is_none_or(|worker| worker.state() != State::Idle) {
            let read = move |message: &_| {
                let (generation, response) = messages::decode_response(message)?;
                let goes_on = matches!(response, Response::Progress(_));
                Some(Heard { event: Event::Worker { subject, generation, response }, goes_on })
            };
            let started = WorkerHandle::start(&self.mailbox, read, move |reason| Event::WorkerDied { subject, reason });
            *slot = started
                .map_err(|error| self.mailbox.post(Event::WorkerDied { subject, reason: describe(&error) }))
                .ok();
        }
        slot.as_ref()
    }
}

//! The page's side of the preparation workers, one for each side of the map.
//!
//! A request to a busy worker supersedes the running one: the worker is terminated and replaced by a
//! new one (the module is already compiled). A worker that dies is reported, and replaced with the next request.

use super::messages;
use super::worker_handle::{Heard, State, WorkerHandle};
use crate::conformal::{PerSide, Side};
use crate::platform::{Event, Mailbox};
use crate::worker::Request;

/// Runs preparations in workers.
pub struct Preparer {
    mailbox: Mailbox,
    workers: PerSide<Option<WorkerHandle>>,
    /// Whether a worker has rehearsed a surface.
    is_warm: bool,
}

impl Preparer {
    /// A preparer whose responses are posted to `mailbox`. The workers start at once, before the first request.
    pub fn new(mailbox: Mailbox) -> Self {
        let mut preparer = Self { mailbox, workers: PerSide::default(), is_warm: false };
        for side in Side::BOTH {
            preparer.ensure_idle(side);
        }
        preparer
    }

    /// Starts `request`; a request that the side's worker is working on is superseded.
    #[allow(clippy::needless_pass_by_value, reason = "on the desktop it goes into a thread")]
    pub fn request(&mut self, side: Side, request: Request) {
        let Some(worker) = self.ensure_idle(side) else { return };
        let (message, transfer) = messages::encode_request(&request);
        if let Err(reason) = worker.post(&message, &transfer) {
            let generation = Some(request.generation);
            self.mailbox.post(Event::WorkerDied { side, generation, reason: reason.into() });
        }
    }

    /// Whether a side's worker has said that it runs.
    pub fn has_started(&self, side: Side) -> bool {
        self.workers[side].as_ref().is_some_and(WorkerHandle::has_started)
    }

    /// Terminates a side's worker; the next request starts another one.
    pub fn stop(&mut self, side: Side) {
        self.workers[side] = None;
    }

    /// Sends a rehearsal of a surface to the target's worker, once; to be called when the app has nothing else to do.
    pub fn warm(&mut self) {
        if !std::mem::replace(&mut self.is_warm, true)
            && let Some(worker) = self.ensure_idle(Side::Target)
        {
            worker.rehearse();
        }
    }

    fn ensure_idle(&mut self, side: Side) -> Option<&WorkerHandle> {
        let slot = &mut self.workers[side];
        if slot.as_ref().is_none_or(|worker| worker.state() != State::Idle) {
            let read = move |message: &_| {
                let (generation, response) = messages::decode_response(message)?;
                let goes_on = response.goes_on();
                Some(Heard { event: Event::Worker { side, generation, response }, goes_on })
            };
            // a worker dies over the request in flight: one that was superseded is terminated and no longer heard
            let died = move |reason| Event::WorkerDied { side, generation: None, reason };
            let started = WorkerHandle::start(&self.mailbox, read, died);
            *slot = started.map_err(|error| self.mailbox.post(died(error.into()))).ok();
        }
        slot.as_ref()
    }
}

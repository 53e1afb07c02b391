//! What a worker is sent for: when it is to go, what it has in hand, and which of its answers count.
//!
//! A newer request supersedes the one under way: its generation is higher, and [`PendingRequest::take_in`] is the
//! one place where stale answers are dropped.

use crate::conformal::Stage;
use crate::worker::{Request, Response, Task};
use web_time::Instant;

/// How long controls must rest before a preparation starts, in seconds: a dragged slider gives a value
/// per frame (0.017 s), a person who waits for the result notices 0.3 s.
pub const SETTLE_SECONDS: f64 = 0.12;

/// A debounced, generation-tagged request to the worker for what `W` describes; stale responses are dropped.
#[derive(Debug)]
pub struct PendingRequest<W> {
    due: Option<f64>,
    generation: u64,
    running: Option<Running<W>>,
}

#[derive(Debug)]
struct Running<W> {
    since: Instant,
    in_flight: W,
    stage: Option<Stage>,
}

impl<W> Default for PendingRequest<W> {
    fn default() -> Self {
        Self { due: None, generation: 0, running: None }
    }
}

impl<W> PendingRequest<W> {
    /// A request is to be made: at the time `due`, in seconds.
    pub fn want(&mut self, due: f64) {
        self.due = Some(due);
    }

    /// A request is to be made at once.
    pub fn want_now(&mut self) {
        self.want(f64::NEG_INFINITY);
    }

    /// Nothing is wanted, and what is under way does not count.
    pub fn forget(&mut self) {
        (self.due, self.running) = (None, None);
    }

    /// When a request is to be made.
    pub fn due(&self) -> Option<f64> {
        self.due
    }

    /// Whether a request is to be made now, which is then up to the caller.
    pub fn take_due(&mut self, now: f64) -> bool {
        self.due.take_if(|due| *due <= now).is_some()
    }

    /// The request to send for `W`, in flight from now on.
    pub fn send(&mut self, in_flight: W, task: Task) -> Request {
        self.generation += 1;
        self.running = Some(Running { since: Instant::now(), in_flight, stage: None });
        Request { generation: self.generation, task }
    }

    /// Takes in an answer: a stage is remembered, a stale one dropped; what ends the request comes back.
    pub fn take_in(&mut self, generation: u64, response: Response) -> Option<Response> {
        let running = self.running.as_mut().filter(|_| generation == self.generation)?;
        let Response::Progress(stage) = response else { return Some(response) };
        running.stage = Some(stage);
        None
    }

    /// Whether what is under way is the request of this generation.
    pub fn awaits(&self, generation: u64) -> bool {
        self.running.is_some() && self.generation == generation
    }

    /// Nothing is under way any more; what was.
    pub fn end(&mut self) -> Option<W> {
        self.running.take().map(|running| running.in_flight)
    }

    /// What the worker has in hand.
    pub fn under_way(&self) -> Option<&W> {
        self.running.as_ref().map(|running| &running.in_flight)
    }

    /// Whether something is wanted or under way.
    pub fn is_busy(&self) -> bool {
        self.due.is_some() || self.running.is_some()
    }

    /// The stage that the worker is in.
    pub fn stage(&self) -> Option<Stage> {
        self.running.as_ref().and_then(|running| running.stage)
    }

    /// For how long the worker has had the request, in seconds.
    pub fn seconds_under_way(&self) -> Option<f64> {
        self.running.as_ref().map(|running| running.since.elapsed().as_secs_f64())
    }

    /// The generation of the last request.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// Makes answers up to `generation` stale, as when another worker answers from now on.
    pub fn skip_to(&mut self, generation: u64) {
        self.generation = self.generation.max(generation);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::worker::{Failure, rehearsal};

    #[test]
    fn only_answers_to_what_is_under_way_count_and_stages_are_kept() {
        let mut pending_request = PendingRequest::default();
        pending_request.want(1.0);
        assert!(!pending_request.take_due(0.5) && pending_request.is_busy());
        assert!(pending_request.take_due(1.0) && !pending_request.take_due(1.0) && !pending_request.is_busy());
        let failed = || Response::Failed(Failure::new("no"));
        let first = pending_request.send("first", rehearsal().task).generation;
        let second = pending_request.send("second", rehearsal().task).generation;
        assert!(pending_request.take_in(first, failed()).is_none() && pending_request.under_way() == Some(&"second"));
        assert!(pending_request.take_in(second, Response::Progress(Stage::Mesh)).is_none());
        assert_eq!(pending_request.stage(), Some(Stage::Mesh));
        assert!(pending_request.take_in(second, failed()).is_some() && pending_request.end() == Some("second"));
        assert!(pending_request.take_in(second, failed()).is_none(), "it was answered");
        pending_request.skip_to(9);
        assert_eq!(pending_request.send("third", rehearsal().task).generation, 10);
        pending_request.forget();
        assert!(!pending_request.is_busy() && pending_request.seconds_under_way().is_none());
    }
}

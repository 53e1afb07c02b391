//! A request to a worker: when it is due, whether it is in flight, and which responses belong to it.
//!
//! A side has one worker. All requests to it take their generation from the side's [`Generations`], so that a response
//! belongs to exactly one request; [`PendingRequest::take_in`] is the one place where stale responses are dropped.

use crate::conformal::Stage;
use crate::worker::{Request, Response, Task};
use web_time::Instant;

/// How long controls must rest before a preparation starts, in seconds: a dragged slider gives a value
/// per frame (0.017 s), a person who waits for the result notices 0.3 s.
pub const SETTLE_SECONDS: f64 = 0.12;

/// Numbers the requests to a side's worker, in ascending order and each once.
#[derive(Debug, Default)]
pub struct Generations(u64);

impl Generations {
    fn next(&mut self) -> u64 {
        self.0 += 1;
        self.0
    }
}

/// A debounced, generation-tagged request to the worker for what `W` describes; stale responses are dropped.
#[derive(Debug)]
pub struct PendingRequest<W> {
    due: Option<f64>,
    running: Option<Running<W>>,
}

#[derive(Debug)]
struct Running<W> {
    generation: u64,
    since: Instant,
    in_flight: W,
    stage: Option<Stage>,
}

impl<W> Default for PendingRequest<W> {
    fn default() -> Self {
        Self { due: None, running: None }
    }
}

impl<W> PendingRequest<W> {
    /// Makes a request due at the time `due`, in seconds.
    pub fn want(&mut self, due: f64) {
        self.due = Some(due);
    }

    /// Makes a request due at once.
    pub fn want_now(&mut self) {
        self.want(f64::NEG_INFINITY);
    }

    /// Cancels the request that is due; the response of one in flight will be dropped.
    pub fn forget(&mut self) {
        (self.due, self.running) = (None, None);
    }

    /// The time at which a request is due, if any.
    pub fn due(&self) -> Option<f64> {
        self.due
    }

    /// Whether a request is due at this time; the caller must then send it, as it is no longer due.
    pub fn take_due(&mut self, now: f64) -> bool {
        self.due.take_if(|due| *due <= now).is_some()
    }

    /// The request to send for `W`, in flight from now on.
    pub fn send(&mut self, in_flight: W, task: Task, generations: &mut Generations) -> Request {
        let generation = generations.next();
        self.running = Some(Running { generation, since: Instant::now(), in_flight, stage: None });
        Request { generation, task }
    }

    /// Takes over the request that `other` had in flight, for `in_flight`; no request is due any more.
    pub fn take_over<V>(&mut self, other: &PendingRequest<V>, in_flight: W) {
        if let Some(&Running { generation, since, stage, .. }) = other.running.as_ref() {
            (self.due, self.running) = (None, Some(Running { generation, since, in_flight, stage }));
        }
    }

    /// Accepts a response: stores a stage, drops a stale one, and returns the one that ends the request.
    pub fn take_in(&mut self, generation: u64, response: Response) -> Option<Response> {
        let running = self.running.as_mut().filter(|running| running.generation == generation)?;
        let Response::Progress(stage) = response else { return Some(response) };
        running.stage = Some(stage);
        None
    }

    /// Whether the request in flight has this generation.
    pub fn awaits(&self, generation: u64) -> bool {
        self.running.as_ref().is_some_and(|running| running.generation == generation)
    }

    /// Whether the request in flight is lost, given that the worker stopped during the request of this generation;
    /// `None` means during any.
    pub fn is_lost(&self, generation: Option<u64>) -> bool {
        self.running.as_ref().is_some_and(|running| generation.is_none_or(|lost| running.generation == lost))
    }

    /// Removes and returns the request in flight.
    pub fn end(&mut self) -> Option<W> {
        self.running.take().map(|running| running.in_flight)
    }

    /// The request in flight.
    pub fn under_way(&self) -> Option<&W> {
        self.running.as_ref().map(|running| &running.in_flight)
    }

    /// Whether a request is due or in flight.
    pub fn is_busy(&self) -> bool {
        self.due.is_some() || self.running.is_some()
    }

    /// The stage that the worker has reported last.
    pub fn stage(&self) -> Option<Stage> {
        self.running.as_ref().and_then(|running| running.stage)
    }

    /// For how long the worker has had the request, in seconds.
    pub fn seconds_under_way(&self) -> Option<f64> {
        self.running.as_ref().map(|running| running.since.elapsed().as_secs_f64())
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
        let mut generations = Generations::default();
        let first = pending_request.send("first", rehearsal().task, &mut generations).generation;
        let second = pending_request.send("second", rehearsal().task, &mut generations).generation;
        assert!(pending_request.take_in(first, failed()).is_none() && pending_request.under_way() == Some(&"second"));
        assert!(pending_request.take_in(second, Response::Progress(Stage::Mesh)).is_none());
        assert_eq!(pending_request.stage(), Some(Stage::Mesh));
        assert!(pending_request.take_in(second, failed()).is_some() && pending_request.end() == Some("second"));
        assert!(pending_request.take_in(second, failed()).is_none(), "it was answered");
        let mut other = PendingRequest::default();
        let third = other.send(3, rehearsal().task, &mut generations).generation;
        assert!(third > second && other.awaits(third) && !pending_request.awaits(third));
        pending_request.want_now();
        pending_request.take_over(&other, "fourth");
        assert!(pending_request.awaits(third) && pending_request.due().is_none());
        assert!(pending_request.is_lost(None) && pending_request.is_lost(Some(third)));
        assert!(!pending_request.is_lost(Some(second)), "its worker died when it was superseded");
        pending_request.forget();
        assert!(
            !pending_request.is_lost(None)
                && !pending_request.is_busy()
                && pending_request.seconds_under_way().is_none()
        );
    }
}

//! The handles of the workers that prepare sides and run studies, and the channel of their responses.
//!
//! [`Workers::send_due`] is the one place that sends requests to the workers of the sides; `take_answer` in `incoming`
//! is the one that processes their responses.
//!
//! A worker that dies or is silent for [`SILENCE_SECONDS`] is replaced, and the new one is sent the same request, once: a
//! request over which two workers died fails with a message.

use crate::conformal::{PerSide, Side};
use crate::model::Model;
use crate::platform::{Event, Mailbox, Preparer, StudyRunner};
use crate::worker::{Request, Response};
use std::sync::mpsc;
use web_time::Instant;

/// How long a worker may say nothing before it counts as hung, in seconds. Workers report every stage, and each percent of
/// a table; the longest silence is the factorization of the largest mesh that fits into a browser's memory, about 10 s on
/// a desktop and ten times as long on a phone. A worker that was terminated is noticed at once in other ways.
pub const SILENCE_SECONDS: f64 = 180.0;

/// How long a new worker may take until it says that it runs, in seconds: the program is compiled already; on a phone it
/// takes about one. It may be terminated before it can be noticed otherwise.
const START_SECONDS: f64 = 30.0;

/// A request that a worker has not finished.
struct Sent {
    request: Request,
    /// When the worker was last heard, or got the request.
    heard: Instant,
    /// Whether a worker has died over it.
    is_repeated: bool,
}

/// The workers, and both ends of the channel on which they, files and links post events.
pub struct Workers {
    pub preparer: Preparer,
    pub study_runner: StudyRunner,
    /// For the invariants, so that a table under way does not delay them.
    pub invariants_runner: StudyRunner,
    /// For symmetries.
    pub symmetry_runner: StudyRunner,
    /// For formulas, which can be cancelled.
    pub formula_runner: StudyRunner,
    /// For orthogonal grids.
    pub grid_runner: StudyRunner,
    /// For map projections, which can be cancelled.
    pub projection_runner: StudyRunner,
    /// The sending end; its receiver is `events`.
    pub mailbox: Mailbox,
    pub events: mpsc::Receiver<Event>,
    sent: PerSide<Option<Sent>>,
}

impl Workers {
    /// Starts the workers, with a mailbox for their responses.
    pub fn start() -> Self {
        let (mailbox, events) = Mailbox::new();
        Self {
            preparer: Preparer::new(mailbox.clone()),
            study_runner: StudyRunner::new(mailbox.clone()),
            invariants_runner: StudyRunner::new(mailbox.clone()),
            symmetry_runner: StudyRunner::new(mailbox.clone()),
            formula_runner: StudyRunner::new(mailbox.clone()),
            grid_runner: StudyRunner::new(mailbox.clone()),
            projection_runner: StudyRunner::new(mailbox.clone()),
            mailbox,
            events,
            sent: PerSide::default(),
        }
    }

    /// Sends the requests that are due at the time `now` to the workers of the sides; returns whether any was.
    pub fn send_due(&mut self, model: &mut Model, now: f64) -> bool {
        let requests = model.take_requests(now);
        let sends = !requests.is_empty();
        for (side, request) in requests {
            self.send(side, request, false);
        }
        sends
    }

    fn send(&mut self, side: Side, request: Request, is_repeated: bool) {
        self.sent[side] = Some(Sent { request: request.clone(), heard: Instant::now(), is_repeated });
        self.preparer.request(side, request);
    }

    /// Notes that a side's worker has responded.
    pub fn hear(&mut self, side: Side, generation: u64, response: &Response) {
        if let Some(sent) = self.sent[side].as_mut().filter(|sent| sent.request.generation == generation) {
            sent.heard = Instant::now();
            if !response.goes_on() {
                self.sent[side] = None;
            }
        }
    }

    /// Sends the request again over which a side's worker died, of this generation or any; returns whether it did. The
    /// second time it does not.
    pub fn repeat(&mut self, side: Side, generation: Option<u64>) -> bool {
        let is_of = |sent: &mut Sent| generation.is_none_or(|lost| sent.request.generation == lost);
        let Some(Sent { request, is_repeated, .. }) = self.sent[side].take_if(is_of) else { return false };
        if !is_repeated {
            self.send(side, request, true);
        }
        !is_repeated
    }

    /// The sides whose workers have been silent for too long, with the generations of their requests; those workers are
    /// stopped.
    pub fn stop_silent(&mut self) -> Vec<(Side, u64)> {
        let is_silent = |side: &Side| self.patience(*side).is_some_and(|left| left <= 0.0);
        let silent: Vec<Side> = Side::BOTH.into_iter().filter(is_silent).collect();
        for &side in &silent {
            self.preparer.stop(side);
        }
        silent.into_iter().filter_map(|side| Some((side, self.sent[side].as_ref()?.request.generation))).collect()
    }

    /// The seconds until a worker will have been silent for too long.
    pub fn silent_in(&self) -> Option<f64> {
        let left = Side::BOTH.into_iter().filter_map(|side| self.patience(side));
        left.reduce(f64::min).map(|left| left.max(0.0))
    }

    /// The seconds that a side's worker may still be silent; `None` if it has no request.
    fn patience(&self, side: Side) -> Option<f64> {
        let limit = if self.preparer.has_started(side) { SILENCE_SECONDS } else { START_SECONDS };
        Some(limit - self.sent[side].as_ref()?.heard.elapsed().as_secs_f64())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::session::Session;
    use crate::worker::Failure;

    #[test]
    fn a_request_is_sent_again_once_when_its_worker_died() {
        let (mut model, mut workers) = (Model::new(Session::default()), Workers::start());
        assert!(workers.send_due(&mut model, 0.0));
        let side = Side::Source;
        let generation = workers.sent[side].as_ref().unwrap().request.generation;
        assert!(!workers.repeat(side, Some(generation + 1)), "a superseded request is not sent again");
        assert!(workers.repeat(side, Some(generation)));
        assert!(!workers.repeat(side, None), "the second time it fails");
        assert!(!workers.repeat(side, None) && workers.sent[side].is_none());
    }

    #[test]
    fn a_response_ends_the_wait_and_silence_is_noticed() {
        let (mut model, mut workers) = (Model::new(Session::default()), Workers::start());
        workers.send_due(&mut model, 0.0);
        assert!(workers.stop_silent().is_empty());
        assert!(workers.silent_in().unwrap() > SILENCE_SECONDS - 60.0);
        let sent = workers.sent[Side::Target].as_mut().unwrap();
        let generation = sent.request.generation;
        sent.heard = sent.heard.checked_sub(std::time::Duration::from_mins(10)).unwrap();
        assert_eq!(workers.silent_in(), Some(0.0));
        assert_eq!(workers.stop_silent(), [(Side::Target, generation)]);
        workers.hear(Side::Target, generation, &Response::Progress(crate::conformal::Stage::Mesh));
        assert!(workers.stop_silent().is_empty(), "it has been heard");
        workers.hear(Side::Target, generation, &Response::Failed(Failure::new("no")));
        assert!(workers.sent[Side::Target].is_none());
    }
}

//! The preparation of an outline or a surface: what is requested, the request in flight, the last good side, user error.
//!
//! The panels show what is *wanted*; the map uses the last side that was *prepared*. A new request supersedes the one
//! under way ([`PendingRequest`]). After a failure the last good side stays and the message says why.
//!
//! A side has two of these, since it may need both at once: an outline waits, prepared, behind the surface in its
//! place, and each of them has its own message. What differs between the two is said by what they request
//! ([`Requested`]): an [`OutlineRequest`](super::OutlineRequest), or perhaps a
//! [`SurfaceRequest`](super::SurfaceRequest).

use crate::conformal::PreparedSide;
use crate::language::Message;
use crate::model::side::request::{Generations, PendingRequest};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::worker::{Failure, Request, Response, Task};
use std::sync::Arc;

/// What can be requested of a side's worker.
pub trait Requested: Clone {
    /// What is sent; `None` where nothing is requested.
    fn task(&self) -> Option<Task>;

    /// The request as it is sent now.
    #[must_use]
    fn sent(&self) -> Self {
        self.clone()
    }

    /// Whether the other one is of the same outline or surface, with whatever settings.
    fn is_of_same_shape(&self, other: &Self) -> bool;

    /// Whether it is soon done: to supersede it would cost a browser the worker with all that it has compiled.
    fn is_soon_done(&self) -> bool {
        false
    }

    /// Whether more follows when this is prepared.
    fn goes_on(&self) -> bool {
        false
    }

    /// What was noticed when it was read, before the worker was asked.
    fn notes(&self) -> Vec<Message> {
        Vec::new()
    }

    /// Nothing is due after what has come.
    fn settle(&mut self) {}

    /// What is remembered of it once it is prepared.
    #[must_use]
    fn kept(&self) -> Self {
        self.clone()
    }

    /// It could not be prepared: says why, and goes back to what is `good` but for what a quick fix needs.
    fn fail(&mut self, failure: Failure, good: Option<&Self>) -> UserError;

    /// What is said when the worker stopped.
    fn stopped(reason: Message) -> Message;
}

/// What an answer of the worker changed.
#[derive(Debug, PartialEq)]
pub enum Progress<R> {
    /// A stale answer, or one more stage.
    Nothing,
    /// What was requested is there.
    Ready {
        /// The request, as it was sent.
        request: R,
        /// Whether it is another outline or surface than before.
        is_new: bool,
    },
    /// It could not be prepared; the message is in [`Preparation::error`].
    Failed,
}

/// The last side that could be prepared, and from what.
#[derive(Debug, Clone)]
struct LastGood<R> {
    request: R,
    side: Arc<PreparedSide>,
}

/// Requested settings, request in flight, last good side, user error.
#[derive(Debug)]
pub struct Preparation<R> {
    pub(super) wanted: R,
    pub(super) pending_request: PendingRequest<R>,
    last_good: Option<LastGood<R>>,
    /// What to say about the last request, if it failed.
    pub error: Option<UserError>,
    /// Whether it is a preparation that has failed: another one that succeeds makes up for that.
    has_failed: bool,
    /// What was noticed when the last good side was read.
    pub notes: Vec<Message>,
}

impl<R: Requested> Preparation<R> {
    /// `wanted`, of which nothing is due yet.
    pub(super) fn of(wanted: R) -> Self {
        Self {
            wanted,
            pending_request: PendingRequest::default(),
            last_good: None,
            error: None,
            has_failed: false,
            notes: Vec::new(),
        }
    }

    /// The last good side alone: nothing else is wanted or under way.
    #[must_use]
    pub fn twin(&self) -> Self {
        let wanted = self.good().unwrap_or(&self.wanted).clone();
        Self { last_good: self.last_good.clone(), ..Self::of(wanted) }
    }

    /// The last good side.
    pub fn prepared(&self) -> Option<&Arc<PreparedSide>> {
        self.last_good.as_ref().map(|good| &good.side)
    }

    /// What the last good side was prepared from.
    pub(super) fn good(&self) -> Option<&R> {
        self.last_good.as_ref().map(|good| &good.request)
    }

    /// Whether something is wanted that is not there yet.
    pub fn is_busy(&self) -> bool {
        self.pending_request.is_busy() || self.wanted.goes_on()
    }

    /// What is with the worker.
    pub fn pending_request(&self) -> &PendingRequest<R> {
        &self.pending_request
    }

    /// Lets what is under way wait: the side's worker has something else to do first.
    pub fn postpone(&mut self) {
        if self.pending_request.end().is_some() {
            self.pending_request.want_now();
        }
    }

    /// Wants something else at the time `due`; what is under way is not wanted any more.
    pub(super) fn want(&mut self, wanted: R, due: f64) {
        self.forget_error();
        self.wanted = wanted;
        self.pending_request.end();
        self.pending_request.want(due);
    }

    /// Asks for the same once more.
    pub fn retry(&mut self) {
        self.forget_error();
        self.pending_request.want_now();
    }

    /// Whether what is under way is better waited for.
    fn is_soon_done(&self) -> bool {
        self.pending_request.under_way().is_some_and(R::is_soon_done)
    }

    /// When [`Self::take_request`] should be called again.
    pub fn due(&self) -> Option<f64> {
        self.pending_request.due().filter(|_| !self.is_soon_done())
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, now: f64, generations: &mut Generations) -> Option<Request> {
        if self.is_soon_done() || !self.pending_request.take_due(now) {
            return None;
        }
        self.pending_request.end();
        let sent = self.wanted.sent();
        let task = sent.task()?;
        Some(self.pending_request.send(sent, task, generations))
    }

    /// Takes in an answer of the worker; a stale one changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Progress<R> {
        match self.pending_request.take_in(generation, response) {
            Some(Response::Prepared(side, notes)) => self.finish(*side, notes),
            Some(Response::Failed(failure)) => {
                self.pending_request.end();
                if self.pending_request.due().is_some() {
                    return Progress::Nothing; // what is wanted by now is another thing
                }
                self.error = Some(self.wanted.fail(failure, self.last_good.as_ref().map(|good| &good.request)));
                self.has_failed = true;
                Progress::Failed
            }
            _ => Progress::Nothing,
        }
    }

    fn finish(&mut self, side: PreparedSide, read: Vec<Message>) -> Progress<R> {
        let Some(request) = self.pending_request.end() else { return Progress::Nothing };
        let is_new = self.good().is_none_or(|good| !good.is_of_same_shape(&request));
        if is_new {
            self.notes = request.notes().into_iter().chain(read).collect();
        }
        if std::mem::take(&mut self.has_failed) {
            self.error = None;
        }
        if self.pending_request.due().is_none() {
            self.wanted.settle();
        }
        self.last_good = Some(LastGood { request: request.kept(), side: Arc::new(side) });
        Progress::Ready { request, is_new }
    }

    /// The worker is gone; what it was doing is lost, nothing else.
    pub fn worker_died(&mut self, reason: &Message) {
        if self.pending_request.end().is_some() {
            let text = R::stopped(reason.clone());
            (self.error, self.has_failed) = (Some(UserError { text, quick_fix: Some(QuickFix::Retry) }), true);
        }
    }

    pub(super) fn forget_error(&mut self) {
        (self.error, self.has_failed) = (None, false);
    }
}

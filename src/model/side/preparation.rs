//! The preparation of an outline or a surface: what is requested, the request in flight, the last good side, user error.
//!
//! The panels show the *requested* settings (`wanted`); the map uses the last side that was *prepared*. A new request
//! supersedes the one in flight ([`PendingRequest`]). After a failure the last good side stays, with a user error.
//!
//! A side has two values of this type, one for its outline and one for its surface, because a session can need both at
//! once: the outline stays prepared behind the surface, and each has a user error of its own. What differs between
//! them is in the type of the request ([`Requested`]): [`OutlineRequest`](super::OutlineRequest), or an optional
//! [`SurfaceRequest`](super::SurfaceRequest).

use crate::conformal::PreparedSide;
use crate::language::Message;
use crate::model::side::request::{Generations, PendingRequest};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::worker::{Failure, Request, Response, Taken, Task};
use std::sync::Arc;

/// A request that a side's worker can be sent.
pub trait Requested: Clone {
    /// The task for the worker; `None` if nothing is requested.
    fn task(&self) -> Option<Task>;

    /// The request in the form in which it is sent.
    #[must_use]
    fn sent(&self) -> Self {
        self.clone()
    }

    /// Whether both requests are for the same outline or surface; settings are not compared.
    fn is_of_same_shape(&self, other: &Self) -> bool;

    /// Whether the preparation takes milliseconds: it is then waited for, because superseding it costs a browser the
    /// worker and the code compiled there.
    fn is_soon_done(&self) -> bool {
        false
    }

    /// Whether another request will follow this one.
    fn goes_on(&self) -> bool {
        false
    }

    /// The reader's notes, for a shape that was read before the request was sent.
    fn notes(&self) -> Vec<Message> {
        Vec::new()
    }

    /// Called when the response has arrived and no further request is due.
    fn settle(&mut self) {}

    /// The part of the request that is kept with the prepared side.
    #[must_use]
    fn kept(&self) -> Self {
        self.clone()
    }

    /// Reverts to the last `good` request, except for what a quick fix needs, and returns the user error.
    fn fail(&mut self, failure: Failure, good: Option<&Self>) -> UserError;

    /// The text of the user error when the worker stopped.
    fn stopped(reason: Message) -> Message;
}

/// What a response changed.
#[derive(Debug, PartialEq)]
pub enum Progress<R> {
    /// The response was stale, or reported a stage.
    Nothing,
    /// The requested side is prepared.
    Ready {
        /// The request in the form in which it was sent.
        request: R,
        /// Whether the outline or surface differs from the previous one.
        is_new: bool,
    },
    /// The preparation failed; the user error is `Preparation::error`.
    Failed,
}

/// The last side that was prepared, and its request.
#[derive(Debug, Clone)]
struct LastGood<R> {
    request: R,
    side: Arc<PreparedSide>,
    taken: Option<Taken>,
}

/// Requested settings, request in flight, last good side, user error.
#[derive(Debug)]
pub struct Preparation<R> {
    pub(super) wanted: R,
    pub(super) pending_request: PendingRequest<R>,
    last_good: Option<LastGood<R>>,
    /// What the points of the outline in preparation are taken for.
    coming_taken: Option<Taken>,
    /// The user error beside the side, about the last request or about a file.
    pub(in crate::model) error: Option<UserError>,
    /// Whether `error` is about a preparation: the next one that succeeds clears it.
    has_failed: bool,
    /// The reader's notes on the last good side.
    pub notes: Vec<Message>,
}

impl<R: Requested> Preparation<R> {
    /// A preparation of `wanted` without a request due.
    pub(super) fn of(wanted: R) -> Self {
        Self {
            wanted,
            pending_request: PendingRequest::default(),
            last_good: None,
            coming_taken: None,
            error: None,
            has_failed: false,
            notes: Vec::new(),
        }
    }

    /// A copy of the last good side, without any request.
    #[must_use]
    pub fn twin(&self) -> Self {
        let wanted = self.good().unwrap_or(&self.wanted).clone();
        Self { last_good: self.last_good.clone(), notes: self.notes.clone(), ..Self::of(wanted) }
    }

    /// Takes over the last good side of another preparation.
    pub(super) fn adopt(&mut self, other: &Self) {
        self.last_good.clone_from(&other.last_good);
        self.notes.clone_from(&other.notes);
    }

    /// The last good side.
    pub fn prepared(&self) -> Option<&Arc<PreparedSide>> {
        self.last_good.as_ref().map(|good| &good.side)
    }

    /// Replaces the last good side by another form of it, which belongs to the same request.
    pub(super) fn replace_prepared(&mut self, side: PreparedSide) {
        if let Some(good) = &mut self.last_good {
            good.side = Arc::new(side);
        }
    }

    /// What the points of the last good outline were taken for; `None` if it was prepared without its curve.
    pub fn taken(&self) -> Option<&Taken> {
        self.last_good.as_ref()?.taken.as_ref()
    }

    /// The request of the last good side.
    pub(super) fn good(&self) -> Option<&R> {
        self.last_good.as_ref().map(|good| &good.request)
    }

    /// Whether a request is due, in flight or to follow.
    pub fn is_busy(&self) -> bool {
        self.pending_request.is_busy() || self.wanted.goes_on()
    }

    /// The request due or in flight.
    pub fn pending_request(&self) -> &PendingRequest<R> {
        &self.pending_request
    }

    /// Makes the request in flight due again, because the side's worker is given another task first.
    pub fn postpone(&mut self) {
        if self.pending_request.end().is_some() {
            self.pending_request.want_now();
        }
    }

    /// Requests `wanted` at the time `due`; the request in flight becomes stale.
    pub(super) fn want(&mut self, wanted: R, due: f64) {
        self.forget_error();
        self.wanted = wanted;
        self.pending_request.end();
        self.pending_request.want(due);
    }

    /// Repeats the last request.
    pub fn retry(&mut self) {
        self.forget_error();
        self.pending_request.want_now();
    }

    /// Whether the request in flight is to be waited for.
    fn is_soon_done(&self) -> bool {
        self.pending_request.under_way().is_some_and(R::is_soon_done)
    }

    /// When [`Self::take_request`] is to be called next.
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
        self.coming_taken = None;
        Some(self.pending_request.send(sent, task, generations))
    }

    /// Accepts a response of the worker; a stale one changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Progress<R> {
        match self.pending_request.take_in(generation, response) {
            Some(Response::Taken(taken)) => {
                self.coming_taken = Some(*taken);
                Progress::Nothing
            }
            Some(Response::Prepared(side, notes)) => self.finish(*side, notes),
            Some(Response::Failed(failure)) => {
                self.pending_request.end();
                if self.pending_request.due().is_some() {
                    return Progress::Nothing; // another request has replaced it
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
        let taken = self.coming_taken.take();
        self.last_good = Some(LastGood { request: request.kept(), side: Arc::new(side), taken });
        Progress::Ready { request, is_new }
    }

    /// The worker stopped over the request of this generation, or over any: if that is the request in flight, it is lost
    /// and can be repeated.
    pub fn worker_died(&mut self, generation: Option<u64>, reason: &Message) {
        if self.pending_request.is_lost(generation) {
            self.pending_request.end();
            let text = R::stopped(reason.clone());
            (self.error, self.has_failed) =
                (Some(UserError { quick_fix: Some(QuickFix::Retry), ..UserError::new(text) }), true);
        }
    }

    pub(super) fn forget_error(&mut self) {
        (self.error, self.has_failed) = (None, false);
    }
}

//! The preparation of an outline: requested settings, request in flight, last good domain, user error.
//!
//! The panels show what is *wanted*; the map uses the last domain that was
//! *prepared*. A new request supersedes the one under way: its generation is
//! higher ([`PendingRequest`]). After a failure the last good domain stays and the message says why.

use crate::conformal::{MeshedDomain, PreparedSide};
use crate::language::{Message, key};
use crate::model::editing::Reshaped;
use crate::model::side::request::{PendingRequest, SETTLE_SECONDS};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::outline::OutlineNote;
use crate::session::{DomainSpec, OutlineSpec};
use crate::worker::{Request, Response, Task};
use std::sync::Arc;

/// What an answer of the worker changed.
#[derive(Debug)]
pub enum Progress {
    /// A stale answer, or one more stage.
    Nothing,
    /// The wanted domain is there.
    Ready {
        /// What it was prepared from.
        spec: DomainSpec,
        /// Whether its outline is another one than before.
        new_outline: bool,
        /// How the outline came from the one before, if a hand has reshaped that.
        reshaped: Option<Reshaped>,
    },
    /// It could not be prepared; the message is in [`Preparation::error`].
    Failed,
}

/// What is being prepared.
#[derive(Debug)]
pub struct InFlight {
    spec: DomainSpec,
    notes: Vec<OutlineNote>,
    reshaped: Option<Reshaped>,
}

/// The preparation of a side's outline: requested settings, request in flight, last good domain, user error.
#[derive(Debug)]
pub struct Preparation {
    wanted: DomainSpec,
    prepared_from: Option<DomainSpec>,
    pending_request: PendingRequest<InFlight>,
    domain: Option<Arc<PreparedSide>>,
    /// What to say about the last request, if it failed.
    pub error: Option<UserError>,
    /// Whether it is a preparation that has failed: another one that succeeds makes up for that.
    has_failed: bool,
    /// What was noticed when the outline was read.
    pub notes: Vec<OutlineNote>,
    incoming_notes: Vec<OutlineNote>,
    /// How the wanted outline came from the one before, until it is prepared as it is to stay.
    reshaped: Option<Reshaped>,
}

impl Preparation {
    /// Wants `spec`, at once.
    pub fn new(spec: DomainSpec) -> Self {
        let mut pending_request = PendingRequest::default();
        pending_request.want_now();
        Self {
            wanted: spec,
            prepared_from: None,
            pending_request,
            domain: None,
            error: None,
            has_failed: false,
            notes: Vec::new(),
            incoming_notes: Vec::new(),
            reshaped: None,
        }
    }

    /// The last good domain alone: nothing is wanted or under way.
    #[must_use]
    pub fn twin(&self) -> Self {
        let wanted = self.prepared_from.clone().unwrap_or_else(|| self.wanted.clone());
        let prepared_from = self.prepared_from.clone();
        Self {
            prepared_from,
            pending_request: PendingRequest::default(),
            domain: self.domain.clone(),
            ..Self::new(wanted)
        }
    }

    /// What the panels show.
    pub fn wanted(&self) -> &DomainSpec {
        &self.wanted
    }

    /// The last good domain.
    pub fn domain(&self) -> Option<&Arc<MeshedDomain>> {
        self.domain.as_ref()?.domain()
    }

    /// The last good domain, prepared.
    pub fn prepared(&self) -> Option<&Arc<PreparedSide>> {
        self.domain.as_ref()
    }

    /// Whether something is wanted that is not there yet.
    pub fn is_busy(&self) -> bool {
        self.pending_request.is_busy() || self.is_in_hand()
    }

    /// Whether the outline is being reshaped: what is prepared is coarse, and followed by more.
    pub fn is_in_hand(&self) -> bool {
        self.reshaped.is_some_and(|reshaped| reshaped.in_hand)
    }

    /// Whether a coarse preparation is under way: it is soon done, and to supersede it would cost
    /// a browser the worker with all that it has compiled.
    fn is_soon_done(&self) -> bool {
        self.pending_request
            .under_way()
            .and_then(|in_flight| in_flight.reshaped)
            .is_some_and(|reshaped| reshaped.in_hand)
    }

    /// What is with the worker.
    pub fn pending_request(&self) -> &PendingRequest<InFlight> {
        &self.pending_request
    }

    /// Makes answers up to `generation` stale: after a swap the sides' workers answer for each other.
    pub fn skip_to(&mut self, generation: u64) {
        self.pending_request.skip_to(generation);
    }

    /// Lets what is under way wait: the side's worker has something else to do first.
    pub fn postpone(&mut self) {
        if let Some(in_flight) = self.pending_request.end() {
            if self.pending_request.due().is_none() {
                self.incoming_notes = in_flight.notes;
            }
            self.pending_request.want_now();
        }
    }

    /// Wants another outline, at once.
    pub fn want_outline(&mut self, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        self.forget_error();
        self.wanted.outline = outline;
        self.incoming_notes = notes;
        self.pending_request.end();
        self.reshaped = None;
        self.pending_request.want_now();
    }

    /// Wants the outline in another form, as soon as the one under way is done.
    pub fn want_reshaped(&mut self, outline: OutlineSpec, reshaped: Reshaped) {
        self.forget_error();
        self.wanted.outline = outline;
        self.reshaped = Some(reshaped);
        self.pending_request.want_now();
    }

    /// Wants `spec`, at once; whether it has to be prepared.
    pub fn want_spec(&mut self, spec: &DomainSpec) -> bool {
        self.forget_error();
        let prepared = !self.is_busy() && self.prepared_from.as_ref() == Some(spec);
        self.wanted = spec.clone();
        self.reshaped = None;
        if prepared {
            return false;
        }
        self.incoming_notes = Vec::new();
        self.pending_request.end();
        self.pending_request.want_now();
        true
    }

    /// Wants another discretisation, once the request has rested.
    pub fn want_settings(&mut self, settings: crate::conformal::PrepareSettings, now: f64) {
        if settings != self.wanted.settings {
            self.forget_error();
            self.wanted.settings = settings;
            self.pending_request.want(now + SETTLE_SECONDS);
        }
    }

    /// Asks for the same once more.
    pub fn retry(&mut self) {
        self.forget_error();
        self.pending_request.want_now();
    }

    /// When [`Self::take_request`] should be called again.
    pub fn due(&self) -> Option<f64> {
        self.pending_request.due().filter(|_| !self.is_soon_done())
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, now: f64) -> Option<Request> {
        if self.is_soon_done() || !self.pending_request.take_due(now) {
            return None;
        }
        self.pending_request.end();
        let reshaped = self.reshaped;
        let settings = Reshaped::settings(reshaped, self.wanted.settings);
        let spec = DomainSpec { settings, ..self.wanted.clone() };
        let polygon = spec.outline.polygon();
        let in_flight = InFlight { spec, notes: std::mem::take(&mut self.incoming_notes), reshaped };
        Some(self.pending_request.send(in_flight, Task::Outline { polygon, settings }))
    }

    /// Takes in an answer of the worker; a stale one changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Progress {
        match self.pending_request.take_in(generation, response) {
            Some(Response::Prepared(domain, _)) => self.finish(*domain),
            Some(Response::Failed(failure)) => {
                self.pending_request.end();
                if self.pending_request.due().is_some() {
                    return Progress::Nothing; // what is wanted by now is another thing
                }
                self.fail(failure.text);
                Progress::Failed
            }
            _ => Progress::Nothing,
        }
    }

    /// The worker is gone; what it was doing is lost, nothing else.
    pub fn worker_died(&mut self, reason: &Message) {
        if self.pending_request.end().is_some() {
            let text = key::preparation_stopped(reason.clone());
            (self.error, self.has_failed) = (Some(UserError { text, quick_fix: Some(QuickFix::Retry) }), true);
        }
    }

    fn finish(&mut self, domain: PreparedSide) -> Progress {
        let Some(InFlight { spec, notes, reshaped }) = self.pending_request.end() else { return Progress::Nothing };
        let new_outline = self.prepared_from.as_ref().is_none_or(|old| old.outline != spec.outline);
        if new_outline {
            self.notes = notes;
        }
        if std::mem::take(&mut self.has_failed) {
            self.error = None;
        }
        if self.pending_request.due().is_none() {
            self.forget_reshaping();
        }
        self.domain = Some(Arc::new(domain));
        self.prepared_from = Some(spec.clone());
        Progress::Ready { spec, new_outline, reshaped }
    }

    /// What was reshaped is prepared as it is to stay, or not to be had; what is in hand goes on.
    fn forget_reshaping(&mut self) {
        self.reshaped = self.reshaped.filter(|reshaped| reshaped.in_hand);
    }

    fn forget_error(&mut self) {
        (self.error, self.has_failed) = (None, false);
    }

    /// Goes back to the last good outline; the settings stay as the person left them.
    fn fail(&mut self, message: Message) {
        (self.error, self.has_failed) = (Some(UserError::new(message)), true);
        self.forget_reshaping();
        if let Some(good) = &self.prepared_from {
            self.wanted.outline = good.outline.clone();
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
    use super::*;
    use crate::outline::{Preset, Sampling};
    use crate::session::Session;
    use crate::worker::{Failure, run};

    fn answers(request: &Request) -> Vec<(u64, Response)> {
        let mut all = Vec::new();
        run(request, &mut |generation, response| all.push((generation, response)));
        all
    }

    fn coarse() -> Preparation {
        let mut spec = Session::default().domain(crate::conformal::Side::Source).clone();
        spec.settings.sampling = Sampling::Uniform { count: 60, keep_corners: false };
        Preparation::new(spec)
    }

    fn prepared() -> Preparation {
        let mut side = coarse();
        let request = side.take_request(0.0).unwrap();
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        side
    }

    #[test]
    fn what_is_wanted_becomes_a_domain() {
        let mut side = coarse();
        let request = side.take_request(0.0).unwrap();
        assert!(side.pending_request().under_way().is_some() && side.domain().is_none());
        let last = answers(&request).into_iter().map(|(g, r)| side.accept(g, r)).last();
        assert!(matches!(last, Some(Progress::Ready { new_outline: true, .. })));
        assert!(side.domain().is_some() && !side.is_busy());
    }

    #[test]
    fn answers_to_a_superseded_request_change_nothing() {
        let mut side = coarse();
        let first = side.take_request(0.0).unwrap();
        side.want_outline(OutlineSpec::Preset(Preset::Star), Vec::new());
        let second = side.take_request(0.0).unwrap();
        assert!(second.generation > first.generation);
        for (generation, response) in answers(&first) {
            assert!(matches!(side.accept(generation, response), Progress::Nothing));
        }
        assert!(side.domain().is_none() && side.pending_request().under_way().is_some());
    }

    #[test]
    fn resolution_waits_until_the_slider_rests() {
        let mut side = coarse();
        side.take_request(0.0).unwrap();
        let mut settings = side.wanted().settings;
        settings.sampling = Sampling::Uniform { count: 80, keep_corners: false };
        side.want_settings(settings, 1.0);
        assert!(side.take_request(1.0).is_none());
        assert!(side.take_request(1.0 + SETTLE_SECONDS).is_some());
    }

    #[test]
    fn after_a_bad_outline_the_good_domain_and_its_outline_stay() {
        let mut side = prepared();
        let good = Arc::clone(side.domain().unwrap());
        side.want_outline(OutlineSpec::Preset(Preset::Star), Vec::new());
        let request = side.take_request(2.0).unwrap();
        assert!(matches!(side.accept(request.generation, Response::Failed(Failure::new("no"))), Progress::Failed));
        assert!(side.error.is_some());
        assert!(Arc::ptr_eq(&good, side.domain().unwrap()));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Gingerbread));
    }

    #[test]
    fn an_error_about_something_else_outlives_what_is_under_way() {
        let mut side = coarse();
        let request = side.take_request(0.0).unwrap();
        side.error = Some(UserError::new("another file: no".into()));
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        assert!(side.domain().is_some() && side.error.is_some());
        side.want_outline(OutlineSpec::Preset(Preset::Gingerbread), Vec::new());
        assert!(side.error.is_none());
        // and one about a preparation ends with the next that succeeds
        side.take_request(0.0).unwrap();
        let mut settings = side.wanted().settings;
        settings.sampling = Sampling::Uniform { count: 80, keep_corners: false };
        side.want_settings(settings, 1.0);
        side.worker_died(&"no memory".into());
        let request = side.take_request(f64::INFINITY).unwrap();
        assert!(side.error.is_some());
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        assert!(side.error.is_none());
    }

    #[test]
    fn what_fails_on_the_way_of_a_hand_does_not_take_back_where_it_ended() {
        let mut side = prepared();
        let reshaped = |in_hand| Reshaped { interior: None, anchor: 0.0, in_hand };
        side.want_reshaped(OutlineSpec::Preset(Preset::Star), reshaped(true));
        let under_way = side.take_request(0.0).unwrap();
        side.want_reshaped(OutlineSpec::Preset(Preset::Disk), reshaped(false));
        let failed = Response::Failed(Failure::new("too thin"));
        assert!(matches!(side.accept(under_way.generation, failed), Progress::Nothing));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Disk));
        assert!(side.error.is_none() && side.take_request(0.0).is_some());
    }

    #[test]
    fn a_dead_worker_is_reported_and_can_be_asked_again() {
        let mut side = coarse();
        side.take_request(0.0).unwrap();
        side.worker_died(&"out of memory".into());
        assert!(side.error.as_ref().unwrap().text.english().contains("out of memory") && !side.is_busy());
        side.retry();
        assert!(side.take_request(1.0).is_some() && side.error.is_none());
    }
}

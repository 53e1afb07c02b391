//! The request for an outline: the outline, how its inside is discretized, and how it was reshaped.

use crate::conformal::{MeshedDomain, PrepareSettings};
use crate::language::{Message, key};
use crate::model::editing::Reshaped;
use crate::model::side::preparation::{Preparation, Requested};
use crate::model::side::request::{PendingRequest, SETTLE_SECONDS};
use crate::model::side::user_error::UserError;
use crate::outline::OutlineNote;
use crate::session::{DomainSpec, OutlineSpec};
use crate::worker::{Failure, Task};
use std::sync::Arc;

/// An outline that is to be prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineRequest {
    /// The outline and its settings; coarser settings in the form that is sent during a drag.
    pub spec: DomainSpec,
    /// The reader's notes.
    pub(super) notes: Vec<OutlineNote>,
    /// How the outline was reshaped, until it is prepared with its final settings.
    pub reshaped: Option<Reshaped>,
}

impl From<DomainSpec> for OutlineRequest {
    fn from(spec: DomainSpec) -> Self {
        Self { spec, notes: Vec::new(), reshaped: None }
    }
}

impl OutlineRequest {
    fn is_in_hand(&self) -> bool {
        self.reshaped.is_some_and(|reshaped| reshaped.in_hand)
    }
}

impl Requested for OutlineRequest {
    fn task(&self) -> Option<Task> {
        Some(Task::Outline { outline: Box::new((&self.spec.outline).into()), settings: self.spec.settings })
    }

    fn sent(&self) -> Self {
        let mut sent = self.clone();
        sent.spec.settings = Reshaped::settings(self.reshaped, self.spec.settings);
        sent
    }

    fn is_of_same_shape(&self, other: &Self) -> bool {
        self.spec.outline == other.spec.outline
    }

    /// A coarse preparation takes milliseconds.
    fn is_soon_done(&self) -> bool {
        self.is_in_hand()
    }

    /// An outline that is being dragged is prepared again at the end of the drag.
    fn goes_on(&self) -> bool {
        self.is_in_hand()
    }

    fn notes(&self) -> Vec<Message> {
        // beside a picture nobody asks where y points
        self.notes.iter().filter(|note| **note != OutlineNote::Upwards).map(Message::from).collect()
    }

    /// The reshaping is finished unless the drag continues.
    fn settle(&mut self) {
        self.reshaped = self.reshaped.filter(|reshaped| reshaped.in_hand);
    }

    fn kept(&self) -> Self {
        self.spec.clone().into()
    }

    /// Reverts to the last good outline but keeps the settings.
    fn fail(&mut self, failure: Failure, good: Option<&Self>) -> UserError {
        self.settle();
        if let Some(good) = good {
            self.spec.outline = good.spec.outline.clone();
            self.notes = Vec::new();
        }
        UserError::new(failure.text)
    }

    fn stopped(reason: Message) -> Message {
        key::preparation_stopped(reason)
    }
}

impl Preparation<OutlineRequest> {
    /// Requests `spec` at once.
    pub fn new(spec: DomainSpec) -> Self {
        let mut preparation = Self::of(spec.into());
        preparation.pending_request.want_now();
        preparation
    }

    /// The requested outline and settings, which the panels show.
    pub fn wanted(&self) -> &DomainSpec {
        &self.wanted.spec
    }

    /// How the requested outline was reshaped, with its points; `None` for another outline.
    pub fn wanted_points(&self) -> Option<Reshaped> {
        self.wanted.reshaped
    }

    /// The last good domain.
    pub fn domain(&self) -> Option<&Arc<MeshedDomain>> {
        self.prepared()?.domain()
    }

    /// Whether the outline is being dragged: its preparations are coarse, and another one follows.
    pub fn is_in_hand(&self) -> bool {
        self.wanted.is_in_hand()
    }

    /// Requests another outline at once.
    pub fn want_outline(&mut self, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        let spec = DomainSpec { outline, settings: self.wanted.spec.settings };
        self.want(OutlineRequest { spec, notes, reshaped: None }, f64::NEG_INFINITY);
    }

    /// Takes over the request that parsed the requested outline: the worker is preparing it with `settings`.
    pub fn take_over<W>(&mut self, reading: &PendingRequest<W>, settings: PrepareSettings) {
        if self.pending_request.due().is_none() {
            return; // already prepared, and only hidden by a surface
        }
        let mut sent = self.wanted.clone();
        sent.spec.settings = settings;
        self.pending_request.take_over(reading, sent);
        if settings != self.wanted.spec.settings {
            self.pending_request.want_now();
        }
    }

    /// Requests a reshaped outline as soon as the request in flight is done.
    pub fn want_reshaped(&mut self, outline: OutlineSpec, reshaped: Reshaped) {
        self.forget_error();
        let spec = DomainSpec { outline, settings: self.wanted.spec.settings };
        self.wanted = OutlineRequest { spec, notes: Vec::new(), reshaped: Some(reshaped) };
        self.pending_request.want_now();
    }

    /// Requests `spec` at once; returns whether it has to be prepared.
    pub fn want_spec(&mut self, spec: &DomainSpec) -> bool {
        if !self.is_busy() && self.good().is_some_and(|good| good.spec == *spec) {
            self.forget_error();
            self.wanted = spec.clone().into();
            return false;
        }
        self.want(spec.clone().into(), f64::NEG_INFINITY);
        true
    }

    /// Requests other settings once they have not changed for [`SETTLE_SECONDS`].
    pub fn want_settings(&mut self, settings: PrepareSettings, now: f64) {
        if settings != self.wanted.spec.settings {
            self.forget_error();
            self.wanted.spec.settings = settings;
            self.pending_request.want(now + SETTLE_SECONDS);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
    use super::*;
    use crate::model::side::preparation::Progress;
    use crate::model::side::request::Generations;
    use crate::outline::{Preset, Sampling};
    use crate::session::Session;
    use crate::worker::{Request, Response, run};

    fn answers(request: &Request) -> Vec<(u64, Response)> {
        let mut all = Vec::new();
        run(request, &mut |generation, response| all.push((generation, response)));
        all
    }

    fn coarse() -> Preparation<OutlineRequest> {
        let mut spec = Session::default().domain(crate::conformal::Side::Source).clone();
        spec.settings.sampling = Sampling::Uniform { count: 60, keep_corners: false };
        Preparation::new(spec)
    }

    fn prepared() -> Preparation<OutlineRequest> {
        let mut side = coarse();
        let request = side.take_request(0.0, &mut Generations::default()).unwrap();
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        side
    }

    #[test]
    fn what_is_wanted_becomes_a_domain() {
        let mut generations = Generations::default();
        let mut side = coarse();
        let request = side.take_request(0.0, &mut generations).unwrap();
        assert!(side.pending_request().under_way().is_some() && side.domain().is_none());
        let last = answers(&request).into_iter().map(|(g, r)| side.accept(g, r)).last();
        assert!(matches!(last, Some(Progress::Ready { is_new: true, .. })));
        assert!(side.domain().is_some() && !side.is_busy());
    }

    #[test]
    fn answers_to_a_superseded_request_change_nothing() {
        let mut generations = Generations::default();
        let mut side = coarse();
        let first = side.take_request(0.0, &mut generations).unwrap();
        side.want_outline(OutlineSpec::Preset(Preset::Star), Vec::new());
        let second = side.take_request(0.0, &mut generations).unwrap();
        assert!(second.generation > first.generation);
        for (generation, response) in answers(&first) {
            assert!(matches!(side.accept(generation, response), Progress::Nothing));
        }
        assert!(side.domain().is_none() && side.pending_request().under_way().is_some());
    }

    #[test]
    fn resolution_waits_until_the_slider_rests() {
        let mut generations = Generations::default();
        let mut side = coarse();
        side.take_request(0.0, &mut generations).unwrap();
        let mut settings = side.wanted().settings;
        settings.sampling = Sampling::Uniform { count: 80, keep_corners: false };
        side.want_settings(settings, 1.0);
        assert!(side.take_request(1.0, &mut generations).is_none());
        assert!(side.take_request(1.0 + SETTLE_SECONDS, &mut generations).is_some());
    }

    #[test]
    fn after_a_bad_outline_the_good_domain_and_its_outline_stay() {
        let mut generations = Generations::default();
        let mut side = prepared();
        let good = Arc::clone(side.domain().unwrap());
        side.want_outline(OutlineSpec::Preset(Preset::Star), Vec::new());
        let request = side.take_request(2.0, &mut generations).unwrap();
        assert!(matches!(side.accept(request.generation, Response::Failed(Failure::new("no"))), Progress::Failed));
        assert!(side.error.is_some());
        assert!(Arc::ptr_eq(&good, side.domain().unwrap()));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Gingerbread));
    }

    #[test]
    fn an_error_about_something_else_outlives_what_is_under_way() {
        let mut generations = Generations::default();
        let mut side = coarse();
        let request = side.take_request(0.0, &mut generations).unwrap();
        side.error = Some(UserError::new("another file: no".into()));
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        assert!(side.domain().is_some() && side.error.is_some());
        side.want_outline(OutlineSpec::Preset(Preset::Gingerbread), Vec::new());
        assert!(side.error.is_none());
        // and one about a preparation ends with the next that succeeds
        side.take_request(0.0, &mut generations).unwrap();
        let mut settings = side.wanted().settings;
        settings.sampling = Sampling::Uniform { count: 80, keep_corners: false };
        side.want_settings(settings, 1.0);
        side.worker_died(None, &"no memory".into());
        let request = side.take_request(f64::INFINITY, &mut generations).unwrap();
        assert!(side.error.is_some());
        for (generation, response) in answers(&request) {
            side.accept(generation, response);
        }
        assert!(side.error.is_none());
    }

    #[test]
    fn what_fails_on_the_way_of_a_hand_does_not_take_back_where_it_ended() {
        let mut generations = Generations::default();
        let mut side = prepared();
        let reshaped = |in_hand| Reshaped { interior: None, anchor: 0.0, in_hand, turned: false };
        side.want_reshaped(OutlineSpec::Preset(Preset::Star), reshaped(true));
        let under_way = side.take_request(0.0, &mut generations).unwrap();
        side.want_reshaped(OutlineSpec::Preset(Preset::Disk), reshaped(false));
        let failed = Response::Failed(Failure::new("too thin"));
        assert!(matches!(side.accept(under_way.generation, failed), Progress::Nothing));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Disk));
        assert!(side.error.is_none() && side.take_request(0.0, &mut generations).is_some());
    }

    #[test]
    fn a_dead_worker_is_reported_and_can_be_asked_again() {
        let mut generations = Generations::default();
        let mut side = coarse();
        side.take_request(0.0, &mut generations).unwrap();
        side.worker_died(None, &"out of memory".into());
        assert!(side.error.as_ref().unwrap().text.english().contains("out of memory") && !side.is_busy());
        side.retry();
        assert!(side.take_request(1.0, &mut generations).is_some() && side.error.is_none());
    }
}

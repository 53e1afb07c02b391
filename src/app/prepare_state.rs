//! The preparation of one side: what is wanted, what is under way, what is there.
//!
//! The panels show what is *wanted*; the map uses the last domain that was
//! *prepared*. A new wish supersedes the one under way: its generation is
//! higher ([`Errand`]). After a failure the last good domain stays and the message says why.

use super::editing::Reshaped;
use super::errand::{Errand, SETTLE_SECONDS};
use super::trouble::{Remedy, Trouble};
use crate::conformal::PreparedDomain;
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
pub struct Wish {
    spec: DomainSpec,
    notes: Vec<OutlineNote>,
    reshaped: Option<Reshaped>,
}

/// One side's way from a wish to a prepared domain.
#[derive(Debug)]
pub struct Preparation {
    wanted: DomainSpec,
    prepared_from: Option<DomainSpec>,
    errand: Errand<Wish>,
    domain: Option<Arc<PreparedDomain>>,
    /// What to say about the last wish, if it failed.
    pub error: Option<Trouble>,
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
        let mut errand = Errand::default();
        errand.want_now();
        Self {
            wanted: spec,
            prepared_from: None,
            errand,
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
        Self { prepared_from, errand: Errand::default(), domain: self.domain.clone(), ..Self::new(wanted) }
    }

    /// What the panels show.
    pub fn wanted(&self) -> &DomainSpec {
        &self.wanted
    }

    /// The last good domain.
    pub fn domain(&self) -> Option<&Arc<PreparedDomain>> {
        self.domain.as_ref()
    }

    /// Whether something is wanted that is not there yet.
    pub fn is_busy(&self) -> bool {
        self.errand.is_busy() || self.is_in_hand()
    }

    /// Whether the outline is being reshaped: what is prepared is coarse, and followed by more.
    pub fn is_in_hand(&self) -> bool {
        self.reshaped.is_some_and(|reshaped| reshaped.in_hand)
    }

    /// Whether a coarse preparation is under way: it is soon done, and to supersede it would cost
    /// a browser the worker with all that it has compiled.
    fn is_soon_done(&self) -> bool {
        self.errand.under_way().and_then(|wish| wish.reshaped).is_some_and(|reshaped| reshaped.in_hand)
    }

    /// What is with the worker.
    pub fn errand(&self) -> &Errand<Wish> {
        &self.errand
    }

    /// Makes answers up to `generation` stale: after a swap the sides' workers answer for each other.
    pub fn skip_to(&mut self, generation: u64) {
        self.errand.skip_to(generation);
    }

    /// Wants another outline, at once.
    pub fn want_outline(&mut self, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        self.forget_error();
        self.wanted.outline = outline;
        self.incoming_notes = notes;
        self.errand.end();
        self.reshaped = None;
        self.errand.want_now();
    }

    /// Wants the outline in another form, as soon as the one under way is done.
    pub fn want_reshaped(&mut self, outline: OutlineSpec, reshaped: Reshaped) {
        self.forget_error();
        self.wanted.outline = outline;
        self.reshaped = Some(reshaped);
        self.errand.want_now();
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
        self.errand.end();
        self.errand.want_now();
        true
    }

    /// Wants another discretisation, once the wish has rested.
    pub fn want_settings(&mut self, settings: crate::conformal::PrepareSettings, now: f64) {
        if settings != self.wanted.settings {
            self.forget_error();
            self.wanted.settings = settings;
            self.errand.want(now + SETTLE_SECONDS);
        }
    }

    /// Asks for the same once more.
    pub fn retry(&mut self) {
        self.forget_error();
        self.errand.want_now();
    }

    /// When [`Self::take_request`] should be called again.
    pub fn due(&self) -> Option<f64> {
        self.errand.due().filter(|_| !self.is_soon_done())
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, now: f64) -> Option<Request> {
        if self.is_soon_done() || !self.errand.take_due(now) {
            return None;
        }
        self.errand.end();
        match self.wanted.outline.polygon() {
            Ok(polygon) => {
                let reshaped = self.reshaped;
                let settings = Reshaped::settings(reshaped, self.wanted.settings);
                let spec = DomainSpec { settings, ..self.wanted.clone() };
                let wish = Wish { spec, notes: std::mem::take(&mut self.incoming_notes), reshaped };
                Some(self.errand.send(wish, Task::Domain { polygon, settings }))
            }
            Err(error) => {
                self.fail(error.to_string());
                None
            }
        }
    }

    /// Takes in an answer of the worker; a stale one changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Progress {
        match self.errand.take_in(generation, response) {
            Some(Response::Domain(domain)) => self.finish(*domain),
            Some(Response::Failed(failure)) => {
                self.errand.end();
                if self.errand.due().is_some() {
                    return Progress::Nothing; // what is wanted by now is another thing
                }
                self.fail(failure.text);
                Progress::Failed
            }
            _ => Progress::Nothing,
        }
    }

    /// The worker is gone; what it was doing is lost, nothing else.
    pub fn worker_died(&mut self, reason: &str) {
        if self.errand.end().is_some() {
            let text = format!("The preparation stopped unexpectedly ({reason}). The map shown is the last one.");
            (self.error, self.has_failed) = (Some(Trouble { text, remedy: Some(Remedy::Retry) }), true);
        }
    }

    fn finish(&mut self, domain: PreparedDomain) -> Progress {
        let Some(Wish { spec, notes, reshaped }) = self.errand.end() else { return Progress::Nothing };
        let new_outline = self.prepared_from.as_ref().is_none_or(|old| old.outline != spec.outline);
        if new_outline {
            self.notes = notes;
        }
        if std::mem::take(&mut self.has_failed) {
            self.error = None;
        }
        if self.errand.due().is_none() {
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
    fn fail(&mut self, message: String) {
        (self.error, self.has_failed) = (Some(Trouble::new(message)), true);
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
        let mut spec = Session::default().source;
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
    fn a_wish_becomes_a_domain() {
        let mut side = coarse();
        let request = side.take_request(0.0).unwrap();
        assert!(side.errand().under_way().is_some() && side.domain().is_none());
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
        assert!(side.domain().is_none() && side.errand().under_way().is_some());
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
        side.want_outline(OutlineSpec::Points { name: "no area".into(), points: Vec::new() }, Vec::new());
        match side.take_request(2.0) {
            None => {}
            Some(request) => {
                side.accept(request.generation, Response::Failed(Failure::new(&"no")));
            }
        }
        assert!(side.error.is_some());
        assert!(Arc::ptr_eq(&good, side.domain().unwrap()));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Gingerbread));
    }

    #[test]
    fn an_error_about_something_else_outlives_what_is_under_way() {
        let mut side = coarse();
        let request = side.take_request(0.0).unwrap();
        side.error = Some(Trouble::new("another file: no".into()));
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
        side.worker_died("no memory");
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
        let failed = Response::Failed(Failure::new(&"too thin"));
        assert!(matches!(side.accept(under_way.generation, failed), Progress::Nothing));
        assert_eq!(side.wanted().outline, OutlineSpec::Preset(Preset::Disk));
        assert!(side.error.is_none() && side.take_request(0.0).is_some());
    }

    #[test]
    fn a_dead_worker_is_reported_and_can_be_asked_again() {
        let mut side = coarse();
        side.take_request(0.0).unwrap();
        side.worker_died("out of memory");
        assert!(side.error.as_ref().unwrap().text.contains("out of memory") && !side.is_busy());
        side.retry();
        assert!(side.take_request(1.0).is_some() && side.error.is_none());
    }
}

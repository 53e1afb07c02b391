//! The preparation of a surface: requested settings, request in flight, last good surface, user error.
//!
//! As for outlines (file `preparation`): a new request supersedes the one under way ([`PendingRequest`]), and after a failure
//! the last good surface stays and the message says why.

use crate::conformal::PreparedSide;
use crate::language::{Message, key};
use crate::model::names;
use crate::model::side::request::{PendingRequest, SETTLE_SECONDS};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::session::{SurfaceShape, SurfaceSpec};
use crate::worker::{Failure, Request, Response, SurfaceSource, Task};
use std::sync::Arc;

/// A surface that is wanted: what the session says of it, and its triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct InFlight {
    /// What the session will say.
    pub spec: SurfaceSpec,
    source: SurfaceSource,
}

/// A surface that has come.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrival {
    /// What the session says of it.
    pub spec: SurfaceSpec,
    /// Whether its triangles are others than before: its points are not those of the last one.
    pub is_new: bool,
}

/// The most bytes of opened files that are kept, to go back to.
const MOST_KEPT_BYTES: usize = 256 << 20;

/// The preparation of a side's surface: requested settings, request in flight, last good surface, user error.
#[derive(Debug, Default)]
pub struct SurfacePreparation {
    wanted: Option<InFlight>,
    pending_request: PendingRequest<InFlight>,
    /// What is there, and what it was prepared from.
    there: Option<(InFlight, Arc<PreparedSide>)>,
    /// What to say about the last request, if it failed.
    pub error: Option<UserError>,
    /// What was noticed when the surface was read.
    pub notes: Vec<Message>,
    /// The files that were opened, the last one at the end: undo goes back to them. No two have one name.
    files: Vec<(String, Arc<Vec<u8>>)>,
}

impl SurfacePreparation {
    /// The last good surface alone: nothing is wanted or under way.
    #[must_use]
    pub fn twin(&self) -> Self {
        let wanted = self.there.as_ref().map(|(in_flight, _)| in_flight.clone());
        Self { wanted, there: self.there.clone(), ..Self::default() }
    }

    /// What the panels show.
    pub fn wanted(&self) -> Option<&SurfaceSpec> {
        self.wanted.as_ref().map(|in_flight| &in_flight.spec)
    }

    /// The last good surface.
    pub fn surface(&self) -> Option<&Arc<PreparedSide>> {
        self.there.as_ref().map(|(_, surface)| surface)
    }

    /// The triangles of [`Self::surface`] as they were given.
    pub fn source(&self) -> Option<&SurfaceSource> {
        self.there.as_ref().map(|(in_flight, _)| &in_flight.source)
    }

    /// Whether something is wanted that is not there yet.
    pub fn is_busy(&self) -> bool {
        self.pending_request.is_busy()
    }

    /// What is with the worker.
    pub fn pending_request(&self) -> &PendingRequest<InFlight> {
        &self.pending_request
    }

    /// Whether a surface from a file is on its way.
    pub fn awaits_file(&self) -> bool {
        let is_file = |in_flight: &InFlight| matches!(in_flight.spec.shape, SurfaceShape::File { .. });
        self.pending_request.is_busy() && self.wanted.as_ref().is_some_and(is_file)
    }

    /// Wants a surface, at once; what is under way is not wanted any more.
    fn want(&mut self, in_flight: InFlight, due: f64) {
        self.error = None;
        self.wanted = Some(in_flight);
        self.pending_request.end();
        self.pending_request.want(due);
    }

    /// Wants a file that was opened. Another one of the same name is called anew: "head (2).obj".
    pub fn want_file(&mut self, name: &str, bytes: Vec<u8>) {
        let (name, bytes) = self.keep_file(name, bytes);
        let spec = SurfaceSpec { shape: SurfaceShape::File { name: name.clone() }, ..SurfaceSpec::default() };
        self.want(InFlight { spec, source: SurfaceSource::File { name, bytes } }, f64::NEG_INFINITY);
    }

    /// Wants what `spec` says, with the file that it names.
    pub fn want_file_of(&mut self, spec: SurfaceSpec, bytes: Vec<u8>) {
        let SurfaceShape::File { name } = &spec.shape else { return };
        let (name, bytes) = self.keep_file(&name.clone(), bytes);
        self.want(InFlight { spec, source: SurfaceSource::File { name, bytes } }, f64::NEG_INFINITY);
    }

    fn keep_file(&mut self, name: &str, bytes: Vec<u8>) -> (String, Arc<Vec<u8>>) {
        let numbered = |number: usize| match (number, name.rsplit_once('.')) {
            (1, _) => name.to_owned(),
            (_, Some((stem, ending))) => format!("{stem} ({number}).{ending}"),
            (_, None) => format!("{name} ({number})"),
        };
        let is_free = |name: &String| self.files.iter().all(|(known, there)| known != name || **there == bytes);
        let name = (1..=self.files.len() + 1).map(numbered).find(is_free).unwrap_or_else(|| name.to_owned());
        self.files.retain(|(known, _)| *known != name);
        let bytes = Arc::new(bytes);
        self.files.push((name.clone(), Arc::clone(&bytes)));
        let mut kept: usize = self.files.iter().map(|(_, bytes)| bytes.len()).sum();
        while kept > MOST_KEPT_BYTES && self.files.len() > 1 {
            kept -= self.files.remove(0).1.len();
        }
        (name, bytes)
    }

    /// Wants what `spec` says: at once, or after `now` when another resolution of a formula has rested. Whether
    /// it has to be prepared. A file's triangles must be here already.
    pub fn want_spec(&mut self, spec: &SurfaceSpec, now: f64) -> bool {
        if let Some((in_flight, _)) = self.there.as_ref().filter(|(in_flight, _)| in_flight.spec == *spec) {
            self.wanted = Some(in_flight.clone());
            self.pending_request.forget();
            self.error = None;
            return false;
        }
        if let Some(source) = self.source_of(&spec.shape) {
            let slides = self.wanted().is_some_and(|old| old.shape != spec.shape && old.shape.is_like(&spec.shape));
            let due = if slides { now + SETTLE_SECONDS } else { f64::NEG_INFINITY };
            self.want(InFlight { spec: spec.clone(), source }, due);
        } else if let SurfaceShape::File { name } = &spec.shape {
            self.pending_request.forget();
            self.error = Some(UserError::new(key::about(name, key::open_surface_file())));
        }
        true
    }

    fn source_of(&self, shape: &SurfaceShape) -> Option<SurfaceSource> {
        match shape {
            SurfaceShape::Preset { preset, boundary } => {
                Some(SurfaceSource::Preset { preset: *preset, boundary: *boundary })
            }
            SurfaceShape::File { name: wanted } => {
                let (name, bytes) = self.files.iter().find(|(name, _)| name == wanted)?;
                Some(SurfaceSource::File { name: name.clone(), bytes: Arc::clone(bytes) })
            }
        }
    }

    /// Does not want a surface any more; the one that is there is kept for the next time.
    pub fn give_up(&mut self) {
        self.pending_request.forget();
        self.error = None;
    }

    /// Closes the message: what could not be prepared is not wanted any more.
    pub fn dismiss(&mut self) {
        if self.error.take().is_some() && !self.is_busy() {
            self.wanted = self.there.as_ref().map(|(in_flight, _)| in_flight.clone());
        }
    }

    /// Does what the message offers.
    pub fn quick_fix(&mut self) {
        let quick_fix = self.error.take().and_then(|user_error| user_error.quick_fix);
        if let Some(in_flight) = &mut self.wanted {
            in_flight.spec.repair |= matches!(quick_fix, Some(QuickFix::RepairSurface));
            if quick_fix.is_some() {
                self.pending_request.want_now();
            }
        }
    }

    /// Makes answers up to `generation` stale: the side's worker has given them about its outline.
    pub fn skip_to(&mut self, generation: u64) {
        self.pending_request.skip_to(generation);
    }

    /// When [`Self::take_request`] should be called again.
    pub fn due(&self) -> Option<f64> {
        self.pending_request.due()
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, now: f64) -> Option<Request> {
        if !self.pending_request.take_due(now) {
            return None;
        }
        let in_flight = self.wanted.clone()?;
        let SurfaceSpec { repair, settings, .. } = in_flight.spec;
        let task = Task::Surface { source: in_flight.source.clone(), repair, settings };
        Some(self.pending_request.send(in_flight, task))
    }

    /// Takes in an answer of the worker; the surface, if it has come. A stale answer changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Option<Arrival> {
        match self.pending_request.take_in(generation, response)? {
            Response::Prepared(surface, notes) => {
                let in_flight = self.pending_request.end()?;
                let is_new = self.there.as_ref().is_none_or(|(old, _)| old.source != in_flight.source);
                let spec = in_flight.spec.clone();
                self.there = Some((in_flight, Arc::new(*surface)));
                self.notes = notes;
                self.error = None;
                Some(Arrival { spec, is_new })
            }
            Response::Failed(failure) => {
                self.pending_request.end();
                self.fail(&failure);
                None
            }
            Response::Progress(_) => None, // taken in before
        }
    }

    /// The worker is gone; what it was doing is lost, nothing else.
    pub fn worker_died(&mut self, reason: &Message) {
        if self.pending_request.end().is_some() {
            let text = key::surface_preparation_stopped(reason.clone());
            self.error = Some(UserError { text, quick_fix: Some(QuickFix::Retry) });
        }
    }

    /// The request stays while its message offers a quick fix.
    fn fail(&mut self, failure: &Failure) {
        let name = self.wanted.as_ref().map(|in_flight| names::surface_in_message(&in_flight.spec.shape));
        let text = failure.text.clone();
        let text = if let Some(name) = name { key::about(name, text) } else { text };
        let quick_fix = failure.repairable.then_some(QuickFix::RepairSurface);
        if quick_fix.is_none() {
            self.wanted = self.there.as_ref().map(|(in_flight, _)| in_flight.clone());
        }
        self.error = Some(UserError { text, quick_fix });
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::surface::SurfacePreset;
    use crate::worker::run;

    fn hemisphere() -> SurfaceSpec {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 24 };
        SurfaceSpec { shape, ..SurfaceSpec::default() }
    }

    fn answer(preparation: &mut SurfacePreparation, request: &Request) -> Option<Arrival> {
        let mut last = None;
        run(request, &mut |generation, response| last = preparation.accept(generation, response));
        last
    }

    #[test]
    fn a_wanted_surface_is_prepared_once() {
        let mut preparation = SurfacePreparation::default();
        assert!(preparation.want_spec(&hemisphere(), 0.0));
        let request = preparation.take_request(f64::INFINITY).unwrap();
        assert!(preparation.is_busy() && preparation.take_request(f64::INFINITY).is_none());
        assert_eq!(answer(&mut preparation, &request), Some(Arrival { spec: hemisphere(), is_new: true }));
        assert!(preparation.surface().is_some() && !preparation.is_busy());
        assert!(!preparation.want_spec(&hemisphere(), 0.0));
    }

    #[test]
    fn answers_to_a_superseded_request_change_nothing() {
        let mut preparation = SurfacePreparation::default();
        preparation.want_spec(&hemisphere(), 0.0);
        let first = preparation.take_request(f64::INFINITY).unwrap();
        preparation.want_file("a.obj", Vec::new());
        let second = preparation.take_request(f64::INFINITY).unwrap();
        assert_eq!(answer(&mut preparation, &first), None);
        assert!(preparation.surface().is_none());
        assert_eq!(answer(&mut preparation, &second), None);
        assert!(preparation.error.as_ref().unwrap().text.english().starts_with("a.obj: "));
    }

    #[test]
    fn what_is_under_way_is_not_taken_for_a_file_that_is_missing() {
        let mut preparation = SurfacePreparation::default();
        preparation.want_spec(&hemisphere(), 0.0);
        let request = preparation.take_request(f64::INFINITY).unwrap();
        let shape = SurfaceShape::File { name: "missing.obj".into() };
        assert!(preparation.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, 0.0));
        assert!(preparation.error.as_ref().unwrap().text.english().starts_with("missing.obj: "));
        assert_eq!(answer(&mut preparation, &request), None);
        assert!(preparation.surface().is_none() && preparation.error.is_some());
    }

    #[test]
    fn a_repair_that_is_offered_is_made_when_it_is_asked_for() {
        let mut preparation = SurfacePreparation::default();
        let loose = b"v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\n".to_vec();
        preparation.want_file("loose.obj", loose);
        let request = preparation.take_request(f64::INFINITY).unwrap();
        assert_eq!(answer(&mut preparation, &request), None);
        assert_eq!(preparation.error.as_ref().unwrap().quick_fix, Some(QuickFix::RepairSurface));
        preparation.quick_fix();
        let request = preparation.take_request(f64::INFINITY).unwrap();
        assert!(answer(&mut preparation, &request).unwrap().spec.repair);
        assert_eq!(preparation.surface().unwrap().surface().unwrap().surface().repairs().len(), 1);
    }

    #[test]
    fn a_file_that_is_not_here_is_asked_for() {
        let mut preparation = SurfacePreparation::default();
        let shape = SurfaceShape::File { name: "cow.obj".into() };
        assert!(preparation.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, 0.0));
        assert!(preparation.error.as_ref().unwrap().text.english().starts_with("cow.obj: ") && !preparation.is_busy());
    }

    #[test]
    fn files_of_one_name_stay_apart_and_can_be_gone_back_to() {
        let mut preparation = SurfacePreparation::default();
        for bytes in [b"1", b"2", b"1"] {
            preparation.want_file("a.obj", bytes.to_vec());
        }
        let name = |preparation: &SurfacePreparation| preparation.wanted().unwrap().shape.clone();
        assert_eq!(name(&preparation), SurfaceShape::File { name: "a.obj".into() });
        let second = SurfaceShape::File { name: "a (2).obj".into() };
        assert!(preparation.want_spec(&SurfaceSpec { shape: second.clone(), ..SurfaceSpec::default() }, 0.0));
        let Some(Task::Surface { source, .. }) = preparation.take_request(0.0).map(|request| request.task) else {
            unreachable!("a surface was wanted")
        };
        assert_eq!(source, SurfaceSource::File { name: "a (2).obj".into(), bytes: Arc::new(b"2".to_vec()) });
        assert_eq!(name(&preparation), second);
    }

    #[test]
    fn a_resolution_waits_until_the_slider_rests() {
        let mut preparation = SurfacePreparation::default();
        preparation.want_spec(&hemisphere(), 0.0);
        preparation.take_request(0.0).unwrap();
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 30 };
        preparation.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, 1.0);
        assert!(preparation.take_request(1.0).is_none() && preparation.is_busy());
        assert!(preparation.take_request(1.0 + SETTLE_SECONDS).is_some());
    }
}

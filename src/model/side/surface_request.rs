//! The request for a surface: its specification for the session, and the source of its triangles.

use crate::language::{Message, key};
use crate::model::names;
use crate::model::side::preparation::{Preparation, Requested};
use crate::model::side::request::SETTLE_SECONDS;
use crate::model::side::user_error::{QuickFix, UserError};
use crate::session::{SurfaceShape, SurfaceSpec};
use crate::worker::{Failure, SurfaceSource, Task};
use std::sync::Arc;

/// A surface that is to be prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceRequest {
    /// The specification for the session.
    pub spec: SurfaceSpec,
    /// The source of its triangles.
    pub(super) source: SurfaceSource,
}

impl Requested for Option<SurfaceRequest> {
    fn task(&self) -> Option<Task> {
        let SurfaceRequest { spec, source } = self.as_ref()?;
        let SurfaceSpec { repair, outline_loop, settings, .. } = *spec;
        Some(Task::Surface { source: source.clone(), repair, outline_loop, settings })
    }

    /// Whether the given triangles are the same.
    fn is_of_same_shape(&self, other: &Self) -> bool {
        let source = |request: &Self| request.as_ref().map(|request| request.source.clone());
        source(self) == source(other)
    }

    /// Keeps the request while its user error offers a repair.
    fn fail(&mut self, failure: Failure, good: Option<&Self>) -> UserError {
        let Failure { text, repairable, sketch } = failure;
        let name = self.as_ref().map(|request| names::surface_in_message(&request.spec.shape));
        let text = if let Some(name) = name { key::about(name, text) } else { text };
        if !repairable {
            *self = good.cloned().flatten();
        }
        UserError {
            quick_fix: repairable.then_some(QuickFix::RepairSurface),
            sketch: sketch.map(Arc::from),
            ..UserError::new(text)
        }
    }

    fn stopped(reason: Message) -> Message {
        key::surface_preparation_stopped(reason)
    }
}

/// No surface is requested.
impl Default for Preparation<Option<SurfaceRequest>> {
    fn default() -> Self {
        Self::of(None)
    }
}

impl Preparation<Option<SurfaceRequest>> {
    /// The requested surface, which the panels show.
    pub fn wanted(&self) -> Option<&SurfaceSpec> {
        self.wanted.as_ref().map(|request| &request.spec)
    }

    /// Whether a surface from a file is requested and not prepared yet.
    pub fn awaits_file(&self) -> bool {
        self.is_busy() && self.wanted().is_some_and(|spec| matches!(spec.shape, SurfaceShape::File { .. }))
    }

    /// Requests a surface with the triangles of `source`: at once, or [`SETTLE_SECONDS`] after `now` if only the
    /// resolution of a preset changes.
    pub fn want_surface(&mut self, spec: SurfaceSpec, source: SurfaceSource, now: f64) {
        let slides = self.wanted().is_some_and(|old| old.shape != spec.shape && old.shape.is_like(&spec.shape));
        let due = if slides { now + SETTLE_SECONDS } else { f64::NEG_INFINITY };
        self.want(Some(SurfaceRequest { spec, source }), due);
    }

    /// Whether the last good surface is the one that `spec` describes and was made of `source`. A file that is no longer
    /// kept has no source; its name alone decides.
    pub fn is_last_good(&self, spec: &SurfaceSpec, source: Option<&SurfaceSource>) -> bool {
        let is_of = |good: &SurfaceRequest| good.spec == *spec && source.is_none_or(|source| good.source == *source);
        self.good().and_then(Option::as_ref).is_some_and(is_of)
    }

    /// The source of the last good surface.
    pub fn source(&self) -> Option<&SurfaceSource> {
        self.good()?.as_ref().map(|request| &request.source)
    }

    /// Requests the last good surface if it is the one that `spec` describes; returns whether it is.
    pub fn want_last_good(&mut self, spec: &SurfaceSpec, source: Option<&SurfaceSource>) -> bool {
        let is_there = self.is_last_good(spec, source);
        if is_there {
            self.wanted = self.good().cloned().flatten();
            self.give_up();
        }
        is_there
    }

    /// Asks the person for the file of a surface, which is not at hand.
    pub fn ask_for_file(&mut self, name: &str) {
        self.pending_request.forget();
        self.error = Some(UserError::new(key::about(name, key::open_surface_file())));
    }

    /// Cancels the request; the last good surface is kept.
    pub fn give_up(&mut self) {
        self.pending_request.forget();
        self.forget_error();
    }

    /// Closes the user error and withdraws the request that failed.
    pub fn dismiss(&mut self) {
        if self.error.is_some() && !self.is_busy() {
            self.wanted = self.good().cloned().flatten();
        }
        self.forget_error();
    }

    /// Applies the quick fix of the user error.
    pub fn quick_fix(&mut self) {
        let quick_fix = self.error.take().and_then(|user_error| user_error.quick_fix);
        if let Some(request) = &mut self.wanted {
            request.spec.repair |= matches!(quick_fix, Some(QuickFix::RepairSurface));
            if quick_fix.is_some() {
                self.retry();
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::model::side::preparation::Progress;
    use crate::model::side::request::Generations;
    use crate::model::side::{SurfaceFiles, SurfaceSide};
    use crate::surface::SurfacePreset;
    use crate::worker::{NamedFile, Request, run};
    use std::sync::Arc;

    fn hemisphere() -> SurfaceSpec {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 24 };
        SurfaceSpec { shape, ..SurfaceSpec::default() }
    }

    /// The prepared surface, and whether it is new.
    fn answer(side: &mut SurfaceSide, request: &Request) -> Option<(SurfaceSpec, bool)> {
        let mut last = Progress::Nothing;
        run(request, &mut |generation, response| last = side.preparation.accept(generation, response));
        let Progress::Ready { request, is_new } = last else { return None };
        Some((request.unwrap().spec, is_new))
    }

    #[test]
    fn a_wanted_surface_is_prepared_once() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        assert!(side.want_spec(&hemisphere(), &SurfaceFiles::default(), 0.0));
        let request = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        assert!(side.preparation.is_busy() && side.preparation.take_request(f64::INFINITY, &mut generations).is_none());
        assert_eq!(answer(&mut side, &request), Some((hemisphere(), true)));
        assert!(side.preparation.prepared().is_some() && !side.preparation.is_busy());
        assert!(!side.want_spec(&hemisphere(), &SurfaceFiles::default(), 0.0));
    }

    #[test]
    fn answers_to_a_superseded_request_change_nothing() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        side.want_spec(&hemisphere(), &SurfaceFiles::default(), 0.0);
        let first = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        side.want_file(&SurfaceSpec::default(), SurfaceFiles::default().keep("a.obj", Vec::new()));
        let second = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        assert_eq!(answer(&mut side, &first), None);
        assert!(side.preparation.prepared().is_none());
        assert_eq!(answer(&mut side, &second), None);
        assert!(side.preparation.error.as_ref().unwrap().text.english().starts_with("a.obj: "));
    }

    #[test]
    fn what_is_under_way_is_not_taken_for_a_file_that_is_missing() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        side.want_spec(&hemisphere(), &SurfaceFiles::default(), 0.0);
        let request = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        let shape = SurfaceShape::File { name: "missing.obj".into() };
        assert!(side.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, &SurfaceFiles::default(), 0.0));
        assert!(side.preparation.error.as_ref().unwrap().text.english().starts_with("missing.obj: "));
        assert_eq!(answer(&mut side, &request), None);
        assert!(side.preparation.prepared().is_none() && side.preparation.error.is_some());
    }

    #[test]
    fn a_repair_that_is_offered_is_made_when_it_is_asked_for() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        let turned = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n".to_vec();
        side.want_file(&SurfaceSpec::default(), SurfaceFiles::default().keep("turned.obj", turned));
        let request = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        assert_eq!(answer(&mut side, &request), None);
        assert_eq!(side.preparation.error.as_ref().unwrap().quick_fix, Some(QuickFix::RepairSurface));
        side.preparation.quick_fix();
        let request = side.preparation.take_request(f64::INFINITY, &mut generations).unwrap();
        assert!(answer(&mut side, &request).unwrap().0.repair);
        assert_eq!(side.preparation.prepared().unwrap().surface().unwrap().surface().repairs().len(), 1);
    }

    #[test]
    fn a_file_that_is_not_here_is_asked_for() {
        let mut side = SurfaceSide::default();
        let shape = SurfaceShape::File { name: "cow.obj".into() };
        assert!(side.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, &SurfaceFiles::default(), 0.0));
        assert!(
            side.preparation.error.as_ref().unwrap().text.english().starts_with("cow.obj: ")
                && !side.preparation.is_busy()
        );
    }

    #[test]
    fn files_of_one_name_stay_apart_and_can_be_gone_back_to() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        let mut files = SurfaceFiles::default();
        for bytes in [b"1", b"2", b"1"] {
            side.want_file(&SurfaceSpec::default(), files.keep("a.obj", bytes.to_vec()));
        }
        let name = |side: &SurfaceSide| side.preparation.wanted().unwrap().shape.clone();
        assert_eq!(name(&side), SurfaceShape::File { name: "a.obj".into() });
        let second = SurfaceShape::File { name: "a (2).obj".into() };
        assert!(side.want_spec(&SurfaceSpec { shape: second.clone(), ..SurfaceSpec::default() }, &files, 0.0));
        let Some(Task::Surface { source, .. }) =
            side.preparation.take_request(0.0, &mut generations).map(|request| request.task)
        else {
            unreachable!("a surface was wanted")
        };
        assert_eq!(source, SurfaceSource::File(NamedFile { name: "a (2).obj".into(), bytes: Arc::new(b"2".to_vec()) }));
        assert_eq!(name(&side), second);
    }

    #[test]
    fn a_resolution_waits_until_the_slider_rests() {
        let (mut side, mut generations) = (SurfaceSide::default(), Generations::default());
        side.want_spec(&hemisphere(), &SurfaceFiles::default(), 0.0);
        side.preparation.take_request(0.0, &mut generations).unwrap();
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 30 };
        side.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }, &SurfaceFiles::default(), 1.0);
        assert!(side.preparation.take_request(1.0, &mut generations).is_none() && side.preparation.is_busy());
        assert!(side.preparation.take_request(1.0 + SETTLE_SECONDS, &mut generations).is_some());
    }
}

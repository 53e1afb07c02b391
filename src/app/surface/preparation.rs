//! The preparation of the surface: what is wanted, what is under way, what is there.
//!
//! As for outlines (`prepare_state`): a new wish supersedes the one under way, stale answers are
//! dropped by their generation, and after a failure the last good surface stays and the message says why.

use crate::app::trouble::{Remedy, Trouble};
use crate::conformal::{PreparedSurface, Stage};
use crate::session::{SurfaceShape, SurfaceSpec};
use crate::worker::{Failure, Request, Response, SurfaceSource, Task};
use std::sync::Arc;

/// A surface that is wanted: what the session says of it, and its triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Wish {
    /// What the session will say.
    pub spec: SurfaceSpec,
    source: SurfaceSource,
}

impl Wish {
    /// A surface from a file.
    pub fn file(name: String, bytes: Vec<u8>) -> Self {
        let shape = SurfaceShape::File { name };
        Self::of(SurfaceSpec { shape, ..SurfaceSpec::default() }, bytes)
    }

    /// What `spec` says, of triangles from a file.
    pub fn of(spec: SurfaceSpec, bytes: Vec<u8>) -> Self {
        let name = match &spec.shape {
            SurfaceShape::File { name } => name.clone(),
            SurfaceShape::Preset { preset, .. } => preset.name().to_owned(),
        };
        Self { spec, source: SurfaceSource::File { name, bytes: Arc::new(bytes) } }
    }
}

/// A surface that has come.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrival {
    /// What the session says of it.
    pub spec: SurfaceSpec,
    /// Whether its triangles are others than before: its points are not those of the last one.
    pub is_new: bool,
}

/// The way from a wish to a prepared surface.
#[derive(Debug, Default)]
pub struct SurfacePreparation {
    wanted: Option<Wish>,
    due: bool,
    generation: u64,
    running: Option<Running>,
    /// What is there, and what it was prepared from.
    there: Option<(Wish, Arc<PreparedSurface>)>,
    /// What to say about the last wish, if it failed.
    pub error: Option<Trouble>,
    /// What was noticed when the surface was read.
    pub notes: Vec<String>,
}

#[derive(Debug)]
struct Running {
    wish: Wish,
    stage: Option<Stage>,
}

impl SurfacePreparation {
    /// What the panels show.
    pub fn wanted(&self) -> Option<&SurfaceSpec> {
        self.wanted.as_ref().map(|wish| &wish.spec)
    }

    /// The last good surface.
    pub fn surface(&self) -> Option<&Arc<PreparedSurface>> {
        self.there.as_ref().map(|(_, surface)| surface)
    }

    /// The triangles of [`Self::surface`] as they were given.
    pub fn source(&self) -> Option<&SurfaceSource> {
        self.there.as_ref().map(|(wish, _)| &wish.source)
    }

    /// Whether something is wanted that is not there yet.
    pub fn is_busy(&self) -> bool {
        self.due || self.running.is_some()
    }

    /// The stage that the worker is in.
    pub fn stage(&self) -> Option<Stage> {
        self.running.as_ref().and_then(|running| running.stage)
    }

    /// Wants a surface, at once.
    pub fn want(&mut self, wish: Wish) {
        self.error = None;
        self.wanted = Some(wish);
        self.due = true;
    }

    /// Wants what `spec` says, at once; whether it has to be prepared. A file's triangles must be here already.
    pub fn want_spec(&mut self, spec: &SurfaceSpec) -> bool {
        if let Some((wish, _)) = self.there.as_ref().filter(|(wish, _)| wish.spec == *spec) {
            self.wanted = Some(wish.clone());
            (self.due, self.running, self.error) = (false, None, None);
            return false;
        }
        if let Some(source) = self.source_of(&spec.shape) {
            self.want(Wish { spec: spec.clone(), source });
        } else if let SurfaceShape::File { name } = &spec.shape {
            let text = "This surface travels as a file of its own: open that file here, or drop it.";
            self.error = Some(Trouble::new(format!("{name}: {text}")));
        }
        true
    }

    fn source_of(&self, shape: &SurfaceShape) -> Option<SurfaceSource> {
        match shape {
            SurfaceShape::Preset { preset, boundary } => {
                Some(SurfaceSource::Preset { preset: *preset, boundary: *boundary })
            }
            SurfaceShape::File { name: wanted } => {
                let known = [self.wanted.as_ref(), self.there.as_ref().map(|(wish, _)| wish)];
                let mut sources = known.into_iter().flatten().map(|wish| &wish.source);
                sources.find(|source| matches!(source, SurfaceSource::File { name, .. } if name == wanted)).cloned()
            }
        }
    }

    /// Does not want a surface any more; the one that is there is kept for the next time.
    pub fn give_up(&mut self) {
        (self.due, self.running, self.error) = (false, None, None);
        self.generation += 1;
    }

    /// Does what the message offers.
    pub fn remedy(&mut self) {
        let remedy = self.error.take().and_then(|trouble| trouble.remedy);
        if let Some(wish) = &mut self.wanted {
            wish.spec.repair |= matches!(remedy, Some(Remedy::RepairSurface));
            self.due = remedy.is_some();
        }
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self) -> Option<Request> {
        let wish = self.wanted.clone().filter(|_| std::mem::take(&mut self.due))?;
        self.generation += 1;
        let SurfaceSpec { repair, settings, .. } = wish.spec;
        let task = Task::Surface { source: wish.source.clone(), repair, settings };
        self.running = Some(Running { wish, stage: None });
        Some(Request { generation: self.generation, task })
    }

    /// Takes in an answer of the worker; the surface, if it has come. A stale answer changes nothing.
    pub fn accept(&mut self, generation: u64, response: Response) -> Option<Arrival> {
        let running = self.running.as_mut().filter(|_| generation == self.generation)?;
        match response {
            Response::Progress(stage) => running.stage = Some(stage),
            Response::Surface(surface, notes) => {
                let Running { wish, .. } = self.running.take()?;
                let is_new = self.there.as_ref().is_none_or(|(old, _)| old.source != wish.source);
                let spec = wish.spec.clone();
                self.there = Some((wish, Arc::new(*surface)));
                self.notes = notes;
                self.error = None;
                return Some(Arrival { spec, is_new });
            }
            Response::Failed(failure) => {
                self.running = None;
                self.fail(&failure);
            }
            Response::Domain(_) => {} // no answer to this request
        }
        None
    }

    /// The worker is gone; what it was doing is lost, nothing else.
    pub fn worker_died(&mut self, reason: &str) {
        if self.running.take().is_some() {
            let text = format!(
                "The preparation of the surface stopped unexpectedly ({reason}). If it is very large, there may be \
                 too little memory. The map shown is the last one."
            );
            self.error = Some(Trouble { text, remedy: Some(Remedy::Retry) });
        }
    }

    /// The wish stays while its message offers a remedy.
    fn fail(&mut self, failure: &Failure) {
        let name = self.wanted.as_ref().map(|wish| crate::app::words::surface(&wish.spec.shape)).unwrap_or_default();
        let text = format!("{name}: {}", failure.text);
        let remedy = failure.repairable.then_some(Remedy::RepairSurface);
        if remedy.is_none() {
            self.wanted = self.there.as_ref().map(|(wish, _)| wish.clone());
        }
        self.error = Some(Trouble { text, remedy });
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
    fn a_wish_becomes_a_surface_and_is_not_prepared_twice() {
        let mut preparation = SurfacePreparation::default();
        assert!(preparation.want_spec(&hemisphere()));
        let request = preparation.take_request().unwrap();
        assert!(preparation.is_busy() && preparation.take_request().is_none());
        assert_eq!(answer(&mut preparation, &request), Some(Arrival { spec: hemisphere(), is_new: true }));
        assert!(preparation.surface().is_some() && !preparation.is_busy());
        assert!(!preparation.want_spec(&hemisphere()));
    }

    #[test]
    fn answers_to_a_superseded_request_change_nothing() {
        let mut preparation = SurfacePreparation::default();
        preparation.want_spec(&hemisphere());
        let first = preparation.take_request().unwrap();
        preparation.want(Wish::file("a.obj".into(), Vec::new()));
        let second = preparation.take_request().unwrap();
        assert_eq!(answer(&mut preparation, &first), None);
        assert!(preparation.surface().is_none());
        assert_eq!(answer(&mut preparation, &second), None);
        assert!(preparation.error.as_ref().unwrap().text.starts_with("a.obj: "));
    }

    #[test]
    fn a_repair_that_is_offered_is_made_when_it_is_asked_for() {
        let mut preparation = SurfacePreparation::default();
        let loose = b"v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\n".to_vec();
        preparation.want(Wish::file("loose.obj".into(), loose));
        let request = preparation.take_request().unwrap();
        assert_eq!(answer(&mut preparation, &request), None);
        assert_eq!(preparation.error.as_ref().unwrap().remedy, Some(Remedy::RepairSurface));
        preparation.remedy();
        let request = preparation.take_request().unwrap();
        assert!(answer(&mut preparation, &request).unwrap().spec.repair);
        assert_eq!(preparation.surface().unwrap().surface.repairs.len(), 1);
    }

    #[test]
    fn a_file_that_is_not_here_is_asked_for() {
        let mut preparation = SurfacePreparation::default();
        let shape = SurfaceShape::File { name: "cow.obj".into() };
        assert!(preparation.want_spec(&SurfaceSpec { shape, ..SurfaceSpec::default() }));
        assert!(preparation.error.as_ref().unwrap().text.starts_with("cow.obj: ") && !preparation.is_busy());
    }
}

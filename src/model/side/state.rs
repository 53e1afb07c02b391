//! One side of the model: its two preparations, the file being parsed, and the parts of a session still to come.

use crate::conformal::{PerSide, Stage};
use crate::model::side::opened_file::Reading;
use crate::model::side::outline_request::OutlineRequest;
use crate::model::side::preparation::Preparation;
use crate::model::side::request::{Generations, PendingRequest};
use crate::model::side::{SurfaceFiles, SurfaceRequest, SurfaceSide};
use crate::session::{SidePoints, SideState, SurfaceSpec, SurfaceState};
use crate::worker::{Request, Task};

/// One side.
///
/// Invariants: `incoming_points` is `Some` only while the outline is being prepared; the side's worker has at most one
/// request, and every request has a generation of its own.
#[derive(Debug)]
pub struct ModelSide {
    generations: Generations,
    /// The opened file that the worker parses.
    pub reading: Reading,
    /// The outline's preparation.
    pub outline: Preparation<OutlineRequest>,
    /// The surface's preparation, and the surface that is shown.
    pub surface: SurfaceSide,
    /// The points of a session whose outline is being prepared.
    pub incoming_points: Option<SidePoints>,
    /// The state of a session's surface that is being prepared, or whose file is awaited.
    pub incoming_surface: Option<SurfaceState>,
    /// The points of the last map that could be made, of what stood here then.
    pub last_good: SidePoints,
    /// What is shown is new: its viewport is to fit it.
    pub refit: bool,
}

impl ModelSide {
    /// Wants the outline of a session's side.
    pub fn new(state: &SideState) -> Self {
        Self {
            generations: Generations::default(),
            reading: Reading::default(),
            outline: Preparation::new(state.domain.clone()),
            surface: SurfaceSide::default(),
            incoming_points: None,
            incoming_surface: None,
            last_good: state.points(),
            refit: true,
        }
    }

    /// Exchanges the two sides, for none of which a request is due or in flight. Each worker keeps counting on.
    pub fn swap(sides: &mut PerSide<Self>) {
        sides.swap();
        std::mem::swap(&mut sides.source.generations, &mut sides.target.generations);
    }

    /// Takes over the surface that `other` has prepared, if it is the one that `spec` describes and this side has another.
    pub fn take_over_surface(
        &mut self,
        other: &Preparation<Option<SurfaceRequest>>,
        spec: &SurfaceSpec,
        files: &SurfaceFiles,
    ) {
        let source = files.source(&spec.shape);
        let is_good = |side: &Preparation<_>| side.is_last_good(spec, source.as_ref());
        if is_good(other) && !is_good(&self.surface.preparation) {
            self.surface.preparation.adopt(other);
        }
    }

    /// What is prepared here, and nothing that is wanted or under way.
    #[must_use]
    pub fn twin(&self) -> Self {
        Self {
            generations: Generations::default(),
            reading: Reading::default(),
            outline: self.outline.twin(),
            surface: self.surface.twin(),
            incoming_points: None,
            incoming_surface: None,
            last_good: self.last_good,
            refit: true,
        }
    }

    /// Whether a session waits for the file of this name, for its surface here; a file that is being prepared is there.
    pub fn awaits_surface_file(&self, name: &str) -> bool {
        let preparation = &self.surface.preparation;
        let is_there = preparation.is_busy() && preparation.wanted().is_some_and(|spec| spec.shape.is_file(name));
        !is_there && self.incoming_surface.as_ref().is_some_and(|state| state.spec.shape.is_file(name))
    }

    /// The request for the side's worker that is due, if any: for a file, else for a surface, else for the outline,
    /// which waits until the worker is done with those. An outline that is being dragged waits until the picture
    /// `shows` the last one.
    pub fn take_request(&mut self, now: f64, shows: bool) -> Option<Request> {
        let Self { generations, reading, outline, surface, .. } = self;
        let surface = &mut surface.preparation;
        if let Some(request) = reading.take_request(outline.wanted().settings, generations) {
            outline.postpone();
            surface.postpone();
            return Some(request);
        }
        if reading.is_busy() {
            return None;
        }
        if let Some(request) = surface.take_request(now, generations) {
            outline.postpone();
            return Some(request);
        }
        if surface.pending_request().under_way().is_some() || (outline.is_in_hand() && !shows) {
            return None;
        }
        outline.take_request(now, generations)
    }

    /// Sends another task to the side's worker.
    pub fn send<W>(&mut self, request: &mut PendingRequest<W>, in_flight: W, task: Task) -> Request {
        request.send(in_flight, task, &mut self.generations)
    }

    /// When the next request will be due.
    pub fn due(&self) -> Option<f64> {
        if self.reading.is_busy() {
            return self.reading.is_due().then_some(f64::NEG_INFINITY);
        }
        let outline = self.outline.due().filter(|_| self.surface.preparation.pending_request().under_way().is_none());
        self.surface.preparation.due().into_iter().chain(outline).reduce(f64::min)
    }

    /// Whether a request of any kind is due, in flight or to follow.
    pub fn is_busy(&self) -> bool {
        self.reading.is_busy() || self.outline.is_busy() || self.surface.preparation.is_busy()
    }

    /// The stage of the request in flight and the seconds since it was sent, for the progress line; `None` during a
    /// drag, whose requests take milliseconds.
    pub fn under_way(&self) -> Option<(Option<Stage>, f64)> {
        let (reading, surface) = (self.reading.pending_request(), self.surface.preparation.pending_request());
        let outline = self.outline.pending_request();
        if reading.is_busy() {
            Some((reading.stage(), reading.seconds_under_way()?))
        } else if surface.is_busy() {
            Some((surface.stage(), surface.seconds_under_way()?))
        } else if self.outline.is_in_hand() {
            None
        } else {
            Some((outline.stage(), outline.seconds_under_way()?))
        }
    }
}

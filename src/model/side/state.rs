//! One side of the model: its two preparations, the file being parsed, and the parts of an opened session that are not
//! prepared yet.

use crate::conformal::{PerSide, Stage};
use crate::geometry::DVec2;
use crate::model::opening::OpenedParts;
use crate::model::side::opened_file::Reading;
use crate::model::side::outline_request::OutlineRequest;
use crate::model::side::preparation::Preparation;
use crate::model::side::request::{Generations, PendingRequest};
use crate::model::side::sharpening::Sharpening;
use crate::model::side::{SurfaceFiles, SurfaceRequest, SurfaceSide};
use crate::session::{SidePoints, SideState, SurfaceSpec, SurfaceState};
use crate::worker::{Request, Response, Task};

/// What replaces the outline or surface of a side once its preparation is complete.
#[derive(Debug, Default)]
pub enum Next {
    /// No replacement: an outline stays an outline, a surface a surface; another form of it may be in preparation.
    #[default]
    Same,
    /// An outline; the present surface is shown until the outline is prepared.
    Outline,
    /// A surface of an opened session, with its points. It is being prepared, or its file has not been opened yet.
    Surface(Box<SurfaceState>),
}

impl Next {
    /// The surface that replaces the side's shape.
    pub fn surface(&self) -> Option<&SurfaceState> {
        if let Self::Surface(state) = self { Some(state) } else { None }
    }

    /// As [`Self::surface`], to be changed.
    pub fn surface_mut(&mut self) -> Option<&mut SurfaceState> {
        if let Self::Surface(state) = self { Some(state) } else { None }
    }

    /// Returns the surface and resets the value to [`Self::Same`]; any other value is unchanged.
    pub fn take_surface(&mut self) -> Option<SurfaceState> {
        self.take_surface_if(|_| true)
    }

    /// As [`Self::take_surface`], but only a surface for which `is_it` is true.
    pub fn take_surface_if(&mut self, is_it: impl FnOnce(&SurfaceState) -> bool) -> Option<SurfaceState> {
        self.surface().filter(|state| is_it(state))?;
        if let Self::Surface(state) = std::mem::take(self) { Some(*state) } else { None }
    }

    /// Returns whether the value was [`Self::Outline`], which becomes [`Self::Same`].
    pub fn take_outline(&mut self) -> bool {
        let is_outline = matches!(self, Self::Outline);
        if is_outline {
            *self = Self::Same;
        }
        is_outline
    }
}

/// One side: its preparations and requests. The session, not this type, says whether it has an outline or a surface.
///
/// Invariants: `incoming_points` is `Some` only while the outline is being prepared; the side's worker has at most one
/// request, and every request has a generation of its own.
#[derive(Debug)]
pub struct ModelSide {
    generations: Generations,
    /// The opened file that the worker parses.
    pub reading: Reading,
    /// What else the file of the outline holds.
    pub(in crate::model) parts: Option<OpenedParts>,
    /// The outline's preparation.
    pub outline: Preparation<OutlineRequest>,
    /// The integral equation of the prepared outline.
    pub sharpening: Sharpening,
    /// The mesh that refines the map of this side's outline.
    pub mesh: PendingRequest<()>,
    /// The surface's preparation, and the surface that is shown.
    pub surface: SurfaceSide,
    /// The points of a session whose outline is being prepared.
    pub incoming_points: Option<SidePoints>,
    /// What replaces the present outline or surface.
    pub next: Next,
    /// The points of the last map that was computed without error, on the outline or the surface of that time.
    pub last_good: SidePoints,
    /// Whether the viewport must be fitted, because the outline or surface is new.
    pub refit: bool,
}

impl ModelSide {
    /// Requests the preparation of the outline of a session's side.
    pub fn new(state: &SideState) -> Self {
        Self {
            generations: Generations::default(),
            reading: Reading::default(),
            outline: Preparation::new(state.domain().clone()),
            parts: None,
            sharpening: Sharpening::default(),
            mesh: PendingRequest::default(),
            surface: SurfaceSide::default(),
            incoming_points: None,
            next: Next::Same,
            last_good: state.points(),
            refit: true,
        }
    }

    /// Exchanges the two sides. Precondition: no request of either is due or in flight, except for an integral equation
    /// and a mesh, which are requested again. Each side keeps the numbering of its worker's requests, so that no
    /// generation is used twice.
    pub fn swap(sides: &mut PerSide<Self>) {
        sides.swap();
        std::mem::swap(&mut sides.source.generations, &mut sides.target.generations);
        for side in [&mut sides.source, &mut sides.target] {
            side.sharpening.forget();
            side.mesh.forget();
        }
    }

    /// Takes over the surface that `other` has prepared, if it is the one that `spec` describes and this side has
    /// another.
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

    /// A copy of the prepared outline and surface, without requests.
    #[must_use]
    pub fn twin(&self) -> Self {
        Self {
            generations: Generations::default(),
            reading: Reading::default(),
            outline: self.outline.twin(),
            parts: None,
            sharpening: Sharpening::none(),
            mesh: PendingRequest::default(),
            surface: self.surface.twin(),
            incoming_points: None,
            next: Next::Same,
            last_good: self.last_good,
            refit: true,
        }
    }

    /// Whether the session's surface on this side needs the file of this name, which has not been opened: a file whose
    /// surface is in preparation has been.
    pub fn awaits_surface_file(&self, name: &str) -> bool {
        let preparation = &self.surface.preparation;
        let is_there = preparation.is_busy() && preparation.wanted().is_some_and(|spec| spec.shape.is_file(name));
        !is_there && self.next.surface().is_some_and(|state| state.spec.shape.is_file(name))
    }

    /// The request for the side's worker that is due, if any, as `take_preparation`, else for the integral
    /// equation of the outline, if its interior point is at `point`. Any other request supersedes the equation's
    /// and the mesh's.
    pub fn take_request(
        &mut self,
        now: f64,
        shows: bool,
        (point, is_at_rest): (Option<DVec2>, bool),
    ) -> Option<Request> {
        let request = self.take_preparation(now, shows);
        if request.is_some() {
            self.sharpening.forget();
            self.mesh.forget();
            return request;
        }
        let point = point.filter(|&point| self.is_equation_due(point, is_at_rest))?;
        self.mesh.forget();
        self.sharpening.send(&self.outline, point, &mut self.generations)
    }

    /// The request for the mesh of a refined map.
    pub fn request_mesh(&mut self, task: Task) -> Request {
        self.mesh.send((), task, &mut self.generations)
    }

    /// Whether the outline's integral equation is to be requested.
    pub fn is_equation_due(&self, point: DVec2, is_at_rest: bool) -> bool {
        !self.is_busy() && self.sharpening.is_due(&self.outline, point, is_at_rest)
    }

    /// Accepts a response about the integral equation; returns whether the prepared outline has one now.
    pub fn accept_equation(&mut self, generation: u64, response: Response) -> bool {
        let Some(side) = self.sharpening.accept(&self.outline, generation, response) else { return false };
        let is_sharp = side.equation().is_some();
        self.outline.replace_prepared(side);
        is_sharp
    }

    /// The request for the side's worker that is due, if any: for a file, else for a surface, else for the outline.
    /// The outline's request is sent after the other two are answered, and during a drag only if the picture `shows`
    /// the last prepared outline.
    fn take_preparation(&mut self, now: f64, shows: bool) -> Option<Request> {
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

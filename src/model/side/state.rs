//! One side of the model: its two preparations, and what of a session is on its way to it.

use crate::model::side::SurfaceSide;
use crate::model::side::preparation::Preparation;
use crate::session::{SidePoints, SideState, SurfaceState};
use crate::worker::Request;

/// One side.
///
/// Invariants: `incoming_points` are there only while the outline is being prepared; of the two preparations at most
/// one is with the side's worker, and no two of its requests have one generation.
#[derive(Debug)]
pub struct ModelSide {
    /// The outline's preparation.
    pub outline: Preparation,
    /// The surface's, and the surface that is shown.
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
            outline: Preparation::new(state.domain.clone()),
            surface: SurfaceSide::default(),
            incoming_points: None,
            incoming_surface: None,
            last_good: state.points(),
            refit: true,
        }
    }

    /// What is prepared here, and nothing that is wanted or under way.
    #[must_use]
    pub fn twin(&self) -> Self {
        Self {
            outline: self.outline.twin(),
            surface: self.surface.twin(),
            incoming_points: None,
            incoming_surface: None,
            last_good: self.last_good,
            refit: true,
        }
    }

    /// The request for this side's worker that is due, if any. A surface takes an outline's place: the outline is
    /// prepared when the worker is done with it. What is in a hand waits until it `shows`.
    pub fn take_request(&mut self, now: f64, shows: bool) -> Option<Request> {
        let Self { outline, surface, .. } = self;
        surface.preparation.skip_to(outline.pending_request().generation());
        if let Some(request) = surface.preparation.take_request(now) {
            outline.postpone();
            return Some(request);
        }
        if surface.preparation.pending_request().under_way().is_some() || (outline.is_in_hand() && !shows) {
            return None;
        }
        outline.skip_to(surface.preparation.pending_request().generation());
        outline.take_request(now)
    }

    /// When the next request will be due.
    pub fn due(&self) -> Option<f64> {
        let outline = self.outline.due().filter(|_| self.surface.preparation.pending_request().under_way().is_none());
        self.surface.preparation.due().into_iter().chain(outline).reduce(f64::min)
    }

    /// Whether something is being prepared.
    pub fn is_busy(&self) -> bool {
        self.outline.is_busy() || self.surface.preparation.is_busy()
    }
}

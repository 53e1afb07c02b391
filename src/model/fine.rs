//! The map on a mesh refined for it, which replaces the full one in the picture while nothing moves.
//!
//! [`Model::resolve_at_rest`] requests the mesh from the mapped side's worker; the map on it is the full map with more
//! boundary vertices ([`ResolvedBoundary`]). It is dropped as soon as a point, a setting or a side changes: what is
//! dragged is the full map. Where triangles still flip, a second mesh is requested for the measure on the first.

use crate::conformal::{ConformalMap, MapError, PreparedSide, ResolvedBoundary, Side};
use crate::laplace::Deadline;
use crate::model::Model;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::model::side::request::PendingRequest;
use crate::worker::{Request, Response, Task};
use std::sync::Arc;

/// The most vertices of a mesh that is refined in the app. The finding of the new boundary and the map on the new mesh
/// are computed within one frame: 7 to 70 ms between all built-in outlines at the default settings, of up to 10,000
/// vertices.
const MOST_VERTICES: usize = 20_000;

/// The refined map, and the mesh that is requested for the next one.
///
/// Invariant: map, wanted mesh and request belong to the full map that is shown.
#[derive(Debug, Default)]
pub struct Fine {
    map: Option<ConformalMap>,
    /// The mesh to request next.
    wanted: Option<Wanted>,
    request: PendingRequest<Wanted>,
    /// Whether the full map that is shown was considered.
    is_tried: bool,
    is_changed: bool,
    /// The number of refined maps so far.
    generation: u64,
    grid: DiskGrid,
}

/// A mesh for a resolved boundary.
#[derive(Debug)]
struct Wanted {
    /// The mapped side.
    side: Side,
    boundary: Arc<ResolvedBoundary>,
    /// The map whose measures are resolved; `None`: the full map.
    measured: Option<ConformalMap>,
}

impl Fine {
    /// The refined map.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.map.as_ref()
    }

    /// The refined map.
    pub fn map_mut(&mut self) -> Option<&mut ConformalMap> {
        self.map.as_mut()
    }

    /// The disk coordinates of the refined map, if [`Self::make_grid`] has computed them.
    pub fn grid(&self) -> &DiskGrid {
        &self.grid
    }

    /// Computes the disk coordinates of the refined map, if there is one (about 2 ms).
    pub fn make_grid(&mut self) {
        if let Some(map) = &self.map {
            self.grid.advance(map, self.generation, Deadline::NEVER);
        }
    }

    /// Drops map and request, because the full map changes; returns whether there was a map.
    pub fn retire(&mut self) -> bool {
        self.request.forget();
        (self.wanted, self.is_tried, self.is_changed) = (None, false, false);
        self.map.take().is_some()
    }

    /// Whether the map has been replaced since the last call.
    pub fn take_changed(&mut self) -> bool {
        std::mem::take(&mut self.is_changed)
    }

    /// Whether a mesh is to be requested.
    pub fn is_due(&self) -> bool {
        self.wanted.is_some()
    }

    /// Whether the request in flight is one to this side's worker.
    pub fn is_of(&self, side: Side) -> bool {
        self.request.under_way().is_some_and(|wanted| wanted.side == side)
    }

    /// Whether the response to this request is awaited.
    pub fn awaits(&self, generation: u64) -> bool {
        self.request.awaits(generation)
    }

    /// The worker stopped over the request of this generation, or over any: the full map stays.
    pub fn worker_died(&mut self, generation: Option<u64>) {
        if self.request.is_lost(generation) {
            self.request.forget();
        }
    }
}

impl Model {
    /// Requests a refined mesh for the map that is shown, if that is the full one, complete, between outlines, and was
    /// prepared with settings that are [refined](crate::conformal::PrepareSettings::is_refined), on meshes of at most
    /// `MOST_VERTICES`; at most once for each map. Returns whether a request is due.
    pub fn resolve_at_rest(&mut self) -> bool {
        if !self.shown.fine.is_tried && self.is_ready() && !self.is_draft() && self.abilities().compares_outlines() {
            self.shown.fine.is_tried = true;
            let map = self.shown.map.as_ref();
            let map = map.filter(|map| {
                let is_small = Side::BOTH.into_iter().all(|side| map.side(side).vertex_count() <= MOST_VERTICES);
                is_small && self.session.domain(map.mapped_side()).settings.is_refined()
            });
            self.shown.fine.wanted = map.and_then(|map| wanted(map, None));
        }
        self.shown.fine.is_due()
    }

    /// The request for a refined mesh, if one is due.
    pub(super) fn take_refinement(&mut self) -> Option<(Side, Request)> {
        let wanted = self.shown.fine.wanted.take()?;
        let side = wanted.side;
        let (coarse, settings) = (self.domain(side)?, self.session.domain(side).settings);
        let task = Task::Resampled { resampled: Box::new(wanted.boundary.resampled(coarse)), settings };
        Some((side, self.sides[side].send(&mut self.shown.fine.request, wanted, task)))
    }

    /// Accepts a response about a refined mesh. A mesh that cannot be made leaves the full map in the picture.
    pub(super) fn accept_refinement(&mut self, generation: u64, response: Response) {
        let Some(last) = self.shown.fine.request.take_in(generation, response) else { return };
        let Some(wanted) = self.shown.fine.request.end() else { return };
        if let (Response::Prepared(refined, _), Some(full)) = (last, &self.shown.map)
            && let Ok((map, again)) = refined_map(full, wanted, Arc::new(*refined))
        {
            let is_better = self.shown.fine.map.as_ref().is_none_or(|before| map.folds() < before.folds());
            if is_better {
                self.shown.fine.map = Some(map);
                self.shown.fine.generation += 1;
                self.shown.fine.is_changed = true;
            }
            self.shown.fine.wanted = again;
        }
    }
}

/// The request for the mesh on which the images of `map` are resolved.
fn wanted(map: &ConformalMap, measured: Option<ConformalMap>) -> Option<Wanted> {
    let boundary = ResolvedBoundary::of(measured.as_ref().unwrap_or(map))?;
    Some(Wanted { side: map.mapped_side(), boundary: Arc::new(boundary), measured })
}

/// The map on a refined mesh, and the mesh to request next: if this was the first one and triangles are flipped.
fn refined_map(
    full: &ConformalMap,
    Wanted { boundary, measured, .. }: Wanted,
    refined: Arc<PreparedSide>,
) -> Result<(ConformalMap, Option<Wanted>), MapError> {
    let is_first = measured.is_none();
    let map = measured.as_ref().unwrap_or(full).resolved(boundary, refined, full.settings())?;
    // a second pass that fails leaves the first one
    let again = if is_first && map.is_folded() { map.remeasured().ok().flatten() } else { None };
    let again = again.and_then(|measured| wanted(full, Some(measured)));
    Ok((map, again))
}

//! The map on a mesh refined for it, which replaces the full one while nothing moves.
//!
//! When the full map is at rest and sharpened, the mesh is requested from the mapped side's worker; the map on it is
//! computed within the time per frame ([`Refining`]). The request has the lowest priority: any other request to the
//! worker supersedes it, and it is made again when the worker is free. A mesh that cannot be refined stays, with the
//! reason. A copy of a model has no worker: it takes over the refined map of its original and makes no other.
//!
//! Invariant: the refined map, complete or not, belongs to the full map that is shown; it is dropped as soon as a
//! point, a setting or a side changes.

use crate::conformal::{ConformalMap, Refining, ResolveError, ResolvedBoundary, Side};
use crate::language::Message;
use crate::laplace::Deadline;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::model::{Changes, Model};
use crate::worker::{Request, Response, Task};

/// The refined map, or how far it is.
#[derive(Debug, Default)]
enum State {
    /// Not begun.
    #[default]
    Due,
    /// In progress.
    Refining(Box<Refining>),
    /// Complete.
    Refined(Box<ConformalMap>),
    /// There is none; with the reason, unless the map cannot have one.
    Stays(Option<Message>),
}

/// Where a refined map comes from.
#[derive(Debug, Default)]
enum Origin {
    /// The mapped side's worker.
    #[default]
    Worker,
    /// Another model, from which it was copied.
    Copy(Option<Box<ConformalMap>>),
}

/// The refined map.
#[derive(Debug, Default)]
pub struct Fine {
    state: State,
    origin: Origin,
    /// The number of refined maps so far.
    generation: u64,
    grid: DiskGrid,
}

impl Fine {
    /// That of a copy of the model.
    pub fn twin(&self) -> Self {
        let copy = self.map().map(|map| Box::new(map.copied()));
        Self { origin: Origin::Copy(copy), ..Self::default() }
    }

    /// Drops the map that was copied: every map of a copy is the full one.
    pub fn forget_copy(&mut self) {
        if matches!(self.origin, Origin::Copy(_)) {
            self.origin = Origin::Copy(None);
        }
    }

    /// The refined map.
    pub fn map(&self) -> Option<&ConformalMap> {
        if let State::Refined(map) = &self.state { Some(map) } else { None }
    }

    /// The refined map.
    pub fn map_mut(&mut self) -> Option<&mut ConformalMap> {
        if let State::Refined(map) = &mut self.state { Some(map) } else { None }
    }

    /// The disk coordinates of the refined map, if [`Self::make_grid`] has computed them.
    pub fn grid(&self) -> &DiskGrid {
        &self.grid
    }

    /// Computes the disk coordinates of the refined map, if there is one.
    pub fn make_grid(&mut self) {
        if let State::Refined(map) = &self.state {
            self.grid.advance(map, self.generation, Deadline::NEVER);
        }
    }

    /// Drops the map, because the full one changes; returns what that changes.
    pub fn retire(&mut self) -> Changes {
        let is_dropped = matches!(std::mem::take(&mut self.state), State::Refined(_));
        Changes { meshes: is_dropped, map: is_dropped, images: is_dropped }
    }

    fn refining(&self) -> Option<&Refining> {
        if let State::Refining(refining) = &self.state { Some(refining) } else { None }
    }

    /// Continues the refinement of `full` with a mesh, or without one.
    fn take_mesh(&mut self, full: &ConformalMap, mesh: Response) {
        let State::Refining(refining) = &mut self.state else { return };
        let taken = match mesh {
            Response::Prepared(mesh, _) => refining.take_mesh(full, *mesh),
            Response::Failed(failure) => return self.give_up_mesh(&failure.text),
            _ => return,
        };
        self.unless_failed(taken);
    }

    /// Continues without the mesh that was requested.
    fn give_up_mesh(&mut self, reason: &Message) {
        if let State::Refining(refining) = &mut self.state
            && !refining.go_on_without_mesh()
        {
            self.state = State::Stays(Some(reason.clone()));
        }
    }

    /// Continues a refinement in progress; returns whether a refined map is complete now.
    fn advance(&mut self, deadline: Deadline) -> bool {
        let State::Refining(refining) = &mut self.state else { return false };
        let advanced = refining.advance(deadline);
        self.unless_failed(advanced.map(|_| ()));
        if !self.refining().is_some_and(Refining::is_done) {
            return false;
        }
        let State::Refining(refining) = std::mem::take(&mut self.state) else { return false };
        self.state = refining.finish().map_or(State::Stays(None), |map| State::Refined(Box::new(map)));
        self.generation += 1;
        self.map().is_some()
    }

    /// Takes over the copied map, if it is the refinement of `full`; returns whether it is.
    fn take_copy(&mut self, full: &ConformalMap) -> bool {
        let Origin::Copy(copy) = &mut self.origin else { return false };
        let Some(map) = copy.take().filter(|map| map.is_refinement_of(full)) else { return false };
        (self.state, self.generation) = (State::Refined(map), self.generation + 1);
        true
    }

    fn unless_failed(&mut self, result: Result<(), ResolveError>) {
        if let Err(error) = result {
            self.state = State::Stays(Some(Message::from(&error)));
        }
    }
}

impl Model {
    /// Whether the map that is shown is to be refined when it rests: between outlines, with
    /// [settings](crate::conformal::PrepareSettings::is_refined) that ask for it.
    fn is_refinable(&self) -> bool {
        let Some(map) = &self.shown.map else { return false };
        let settings = self.session.domain(map.mapped_side()).settings;
        matches!(self.fine.origin, Origin::Worker) && self.abilities().compares_outlines() && settings.is_refined()
    }

    /// Whether the refined map is due or in progress, and not shown yet.
    pub fn is_refining(&self) -> bool {
        self.is_refinable() && matches!(self.fine.state, State::Due | State::Refining(_))
    }

    /// Why the map at rest is not refined although it is to be; `None` also before that is known.
    pub fn unrefined(&self) -> Option<&Message> {
        if let State::Stays(reason) = &self.fine.state { reason.as_ref() } else { None }
    }

    /// The area of the parts of a domain that the images do not cover, as a fraction; `None` before the map is refined.
    pub fn unresolved_area(&self) -> Option<f64> {
        self.map()?.resolution().map(ResolvedBoundary::unresolved_area)
    }

    /// Whether the refinement goes on in the next [`Self::refresh`].
    pub fn refines_in_refresh(&self) -> bool {
        self.fine.refining().is_some_and(|refining| refining.wanted().is_none())
    }

    /// Whether a mesh is to be requested: the map is at rest, sharpened, and not refined.
    pub(super) fn is_mesh_due(&self) -> bool {
        let changes = self.changed.sides || self.changed.points || self.under_way.is_moving || self.is_draft();
        let is_in_flight = |side: Side| self.sides[side].mesh.is_busy();
        !changes
            && self.is_refining()
            && self.is_sharp()
            && !self.refines_in_refresh()
            && !Side::BOTH.into_iter().any(is_in_flight)
    }

    /// The request for the mesh of a refinement, if it is due. O(m log m) when the refinement begins.
    pub(super) fn take_mesh_request(&mut self) -> Option<(Side, Request)> {
        if !self.is_mesh_due() {
            return None;
        }
        let map = self.shown.map.as_ref()?;
        if matches!(self.fine.state, State::Due) {
            let begun = Refining::new(map).map(Box::new);
            self.fine.state = begun.map_or(State::Stays(None), State::Refining);
        }
        let side = map.mapped_side();
        let resampled = Box::new(self.fine.refining()?.wanted()?.clone());
        let settings = self.session.domain(side).settings;
        Some((side, self.sides[side].request_mesh(Task::Mesh { resampled, settings })))
    }

    /// Accepts a response about the mesh that was requested.
    pub(super) fn accept_mesh(&mut self, side: Side, generation: u64, response: Response) {
        let Some(mesh) = self.sides[side].mesh.take_in(generation, response) else { return };
        self.sides[side].mesh.end();
        if let Some(full) = &self.shown.map {
            self.fine.take_mesh(full, mesh);
        }
    }

    /// The worker of a side stopped over the request of this generation, or over any.
    pub(super) fn mesh_is_lost(&mut self, side: Side, generation: Option<u64>, reason: &Message) {
        if self.sides[side].mesh.is_lost(generation) {
            self.sides[side].mesh.forget();
            self.fine.give_up_mesh(reason);
        }
    }

    /// Drops the refined map, complete or not.
    pub(super) fn retire_fine(&mut self) -> Changes {
        for side in Side::BOTH {
            self.sides[side].mesh.forget();
        }
        self.fine.retire()
    }

    /// Spends one frame's time on the refined map; a complete one is shown.
    pub(super) fn advance_fine(&mut self) -> Changes {
        let Some(full) = &self.shown.map else { return Changes::default() };
        let is_new = self.fine.take_copy(full) || self.fine.advance(Deadline::in_ms(self.update_ms));
        Changes { meshes: is_new, map: is_new, images: is_new }
    }
}

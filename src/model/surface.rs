//! Surfaces shown instead of outlines: commands, worker responses, and the positions of the points.

use crate::conformal::{MeshedSurface, Side};
use crate::geometry::DVec3;
use crate::language::{Message, key};
use crate::model::Model;
use crate::model::opening::Arrived;
use crate::model::side::preparation::Progress;
use crate::model::side::{ModelSide, Next, SurfaceSide};
use crate::session::{Command, Holes, SidePoints, SurfaceShape, SurfaceSpec, SurfaceState};
use crate::surface::RepairNote;
use crate::worker::{NamedFile, Response};
use std::sync::Arc;

impl Model {
    /// The surface shown instead of a side's outline, and its state in the session; `None` while the outline is shown.
    pub fn surface(&self, side: Side) -> Option<(&SurfaceSide, &SurfaceState)> {
        Some((&self.sides[side].surface, self.session.surface(side)?))
    }

    /// Builds the search tree of one shown surface that has none and is not too large; returns whether one was built.
    pub fn sort_surface_at_rest(&self) -> bool {
        Side::BOTH.into_iter().filter_map(|side| self.surface(side)).any(|(surface, _)| surface.sort_at_rest())
    }

    /// The preparation of a side's surface and its result, whether or not a surface is shown.
    pub fn surface_side(&self, side: Side) -> &SurfaceSide {
        &self.sides[side].surface
    }

    /// The position of the interior point on a side's surface; `None` until the surface is mapped.
    pub fn surface_point(&self, side: Side) -> Option<DVec3> {
        let (surface, state) = self.surface(side).filter(|_| self.shown.map.is_some())?;
        surface.place(state)
    }

    /// The position of the boundary point on a side's surface; `None` until the surface is mapped.
    pub fn surface_anchor(&self, side: Side) -> Option<DVec3> {
        let (surface, state) = self.surface(side).filter(|_| self.shown.map.is_some())?;
        surface.anchor_place(state)
    }

    /// The side for a surface file opened for or dropped over `side`: the other side if only that one waits for a file
    /// of this name, `side` otherwise.
    pub(super) fn side_for_surface(&self, side: Side, name: &str) -> Side {
        let awaits = |side: Side| self.sides[side].awaits_surface_file(name);
        if awaits(side.other()) && !awaits(side) { side.other() } else { side }
    }

    /// Requests the surface of a file that was opened or dropped, and removes the side's error message. If the session
    /// waits for a file of that name, its points are used, on the other side too.
    pub(super) fn want_surface_file(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        self.sides[side].next.take_outline();
        self.dismiss(side);
        let is_awaited = self.sides[side].awaits_surface_file(name);
        let file = self.surface_files.keep(name, bytes);
        // another file of the name that is already being prepared is a different surface
        let is_its_file = |state: &SurfaceState| is_awaited || state.spec.shape.is_file(&file.name);
        let awaiting = self.sides[side].next.take_surface().filter(is_its_file);
        if awaiting.is_none() {
            self.pinned.expect(None);
        }
        match awaiting {
            Some(state) => self.want_file_of_session(side, state, file.clone()),
            None => self.sides[side].surface.want_file(&SurfaceSpec::default(), file.clone()),
        }
        if self.sides[side.other()].awaits_surface_file(&file.name) {
            let awaiting = self.sides[side.other()].next.take_surface();
            self.open_surface(side.other(), awaiting);
        }
    }

    /// Requests the surface of a session whose triangles are in a file.
    pub fn open_surface_file(&mut self, side: Side, state: SurfaceState, bytes: Vec<u8>) {
        let SurfaceShape::File { name } = &state.spec.shape else { return };
        let file = self.surface_files.keep(name, bytes);
        self.want_file_of_session(side, state, file);
    }

    fn want_file_of_session(&mut self, side: Side, mut state: SurfaceState, file: NamedFile) {
        self.sides[side].surface.want_file(&state.spec, file.clone());
        state.spec.shape = SurfaceShape::File { name: file.name };
        self.sides[side].next = Next::Surface(Box::new(state));
    }

    /// Requests a surface for a side.
    pub(super) fn set_surface(&mut self, side: Side, spec: SurfaceSpec, now: f64) {
        self.stop_reading(side);
        self.sides[side].next = Next::Same;
        self.dismiss(side);
        self.want_surface(side, spec, now);
    }

    /// Requests another discretization of the current surface; returns whether `spec` is of that surface.
    pub(super) fn refine_surface(&mut self, side: Side, spec: SurfaceSpec, now: f64) -> bool {
        let ModelSide { surface, next, .. } = &self.sides[side];
        let stays = self.session.surface(side).is_some() && !matches!(next, Next::Outline);
        let wanted = surface.preparation.wanted().filter(|_| stays);
        let is_there = wanted.is_some_and(|wanted| wanted.is_like(&spec));
        if is_there {
            let incoming = self.sides[side].next.surface_mut();
            if let Some(incoming) = incoming.filter(|incoming| incoming.spec.is_like(&spec)) {
                // the point refers to a triangle, and another shape has other triangles
                incoming.point = incoming.point.filter(|_| incoming.spec.shape == spec.shape);
                incoming.spec = spec.clone();
            }
            self.want_surface(side, spec, now);
        }
        is_there
    }

    fn want_surface(&mut self, side: Side, spec: SurfaceSpec, now: f64) {
        if !self.sides[side].surface.want_spec(&spec, &self.surface_files, now) {
            let is_new = self.session.surface(side).is_none_or(|shown| shown.spec.shape != spec.shape);
            self.take_surface(side, spec, is_new);
        }
    }

    /// Shows a prepared surface, with the points of the session that waited for it, if any.
    fn take_surface(&mut self, side: Side, spec: SurfaceSpec, is_new: bool) {
        let incoming = self.sides[side].next.take_surface_if(|incoming| incoming.spec.shape.is_like(&spec.shape));
        let stays = self.session.surface(side).is_some_and(|shown| shown.spec.shape.is_like(&spec.shape));
        if is_new && !stays && incoming.is_none() {
            self.drop_region(side);
        }
        self.show_surface(side, spec, is_new);
        if let Some(incoming) = incoming {
            self.place_surface(side, incoming);
        }
    }

    /// Stores a prepared surface and its points in the session.
    fn place_surface(&mut self, side: Side, state: SurfaceState) {
        let (points, holes) = (state.points(), state.holes());
        self.session.apply(Command::SetSurface { side, surface: state.spec });
        self.session.apply(Command::SetHoles { side, holes });
        self.session.apply(Command::PlacePoints { side, points });
    }

    /// Sets what is painted of the filled holes of a side's surface; its meshes are uploaded with a new map.
    pub(super) fn set_holes(&mut self, side: Side, holes: Holes) {
        self.session.apply(Command::SetHoles { side, holes });
        if let Some(incoming) = self.sides[side].next.surface_mut() {
            incoming.holes = holes;
        }
        self.change_resolution();
    }

    /// The triangles of a side's surface that are painted: without the filling of holes that are shown open.
    pub fn painted<'a>(&self, side: Side, surface: &'a MeshedSurface) -> &'a [[u32; 3]] {
        match self.session.surface(side).map(SurfaceState::holes) {
            Some(Holes::Open) => surface.surface().given_triangles(),
            Some(Holes::Filled) | None => surface.mesh().triangles(),
        }
    }

    /// Removes a side's surface or cancels its preparation; the outline is shown again.
    pub(super) fn close_surface(&mut self, side: Side) {
        self.sides[side].next.take_surface();
        self.sides[side].surface.preparation.give_up();
        if self.session.surface(side).is_some() {
            self.session.apply(Command::CloseSurface(side));
            self.change_sides();
            self.sides[side].refit = true;
        }
    }

    /// Shows the surface of an opened session: at once if it is prepared already, or after its preparation.
    pub(super) fn open_surface(&mut self, side: Side, wanted: Option<SurfaceState>) {
        self.sides[side].next.take_outline();
        let Some(wanted) = wanted else { return self.close_surface(side) };
        if self.sides[side].surface.want_spec(&wanted.spec, &self.surface_files, f64::NEG_INFINITY) {
            self.sides[side].next = Next::Surface(Box::new(wanted));
            return;
        }
        let ModelSide { next, surface, refit, .. } = &mut self.sides[side];
        *next = Next::Same;
        *refit |= self.session.surface(side).is_none() || surface.is_outdated();
        surface.renew();
        self.place_surface(side, wanted);
        self.change_sides();
    }

    /// Handles a response about a side's surface.
    pub(super) fn accept_surface(&mut self, side: Side, generation: u64, response: Response) {
        let progress = self.sides[side].surface.preparation.accept(generation, response);
        let Progress::Ready { request: Some(request), is_new } = progress else { return };
        let is_another = self.session.surface(side).is_none_or(|shown| shown.spec != request.spec);
        if is_another && matches!(request.spec.shape, SurfaceShape::File { .. }) {
            self.opening.arrived = Some(Arrived::Surface);
        }
        self.take_surface(side, request.spec, is_new);
    }

    fn show_surface(&mut self, side: Side, spec: SurfaceSpec, is_new: bool) {
        let shown = self.session.surface(side);
        let is_finer = shown.is_some_and(|shown| shown.spec.shape.is_like(&spec.shape) && shown.spec != spec);
        let place = self.surface_point(side).filter(|_| is_finer && shown.is_some_and(|shown| shown.point.is_some()));
        if is_new && !is_finer {
            self.session.apply(Command::CloseSurface(side));
            self.sides[side].refit = true;
        }
        self.session.apply(Command::SetSurface { side, surface: spec });
        self.sides[side].surface.renew();
        if let (Some(place), Some(state)) = (place, self.session.surface(side)) {
            let interior = self.sides[side].surface.nearest(place);
            self.session
                .apply(Command::PlacePoints { side, points: SidePoints::Surface { interior, anchor: state.anchor } });
        }
        if is_finer { self.change_resolution() } else { self.change_sides() }
    }

    /// Whether the surfaces that are mapped in the picture are the present ones; while the map of another resolution is
    /// computed, they are not.
    pub(super) fn shows_present_surfaces(&self) -> bool {
        let is_present = |side: Side| {
            let present = self.surface(side).and_then(|(surface, _)| surface.prepared());
            let mapped = self.shown.map.as_ref().map(|map| map.side(side));
            present.is_none_or(|present| mapped.is_some_and(|mapped| Arc::ptr_eq(mapped, present)))
        };
        Side::BOTH.into_iter().all(is_present)
    }

    /// The surface that the picture of a side shows: that of the map, which may have another resolution than the present
    /// one, whose map is not complete; before there is a map, the present one.
    pub fn shown_surface(&self, side: Side) -> Option<&Arc<MeshedSurface>> {
        let present = self.surface(side)?.0.surface();
        self.map().and_then(|map| map.side(side).surface()).or(present)
    }

    /// The notes from reading a side's surface, its repairs, and the note of its map.
    pub fn surface_notes(&self, side: Side) -> Vec<Message> {
        let Some((surface, state)) = self.surface(side) else { return Vec::new() };
        let words = |repair: &RepairNote| match (repair, state.holes()) {
            (RepairNote::FilledHoles { .. }, Holes::Filled) => key::grey_in_colours(Message::from(repair)),
            (RepairNote::FilledHoles { .. }, Holes::Open) => key::open_in_picture(Message::from(repair)),
            _ => repair.into(),
        };
        let repairs = surface.surface().into_iter().flat_map(|surface| surface.surface().repairs());
        let map = self.map().and_then(|map| map.note(side)).map(|note| Message::from(&note));
        surface.preparation.notes.iter().cloned().chain(repairs.map(words)).chain(map).collect()
    }
}

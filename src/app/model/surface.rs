//! The model while a surface stands in the target's place: wishes, answers, and the map brought up to date.
//!
//! The planar map sleeps behind it and is made anew when the surface goes.

use super::{Changes, Model};
use crate::app::surface::{Advance, Arrival, SurfaceSide};
use crate::app::teaching::disk_grid::GridMap;
use crate::app::textured;
use crate::conformal::{Side, SurfaceConstraints, SurfaceMap, SurfaceMapError};
use crate::geometry::DVec3;
use crate::laplace::Deadline;
use crate::mesh::BarycentricPoint;
use crate::session::{Command, SurfaceShape, SurfaceSpec, SurfaceState};
use crate::surface::RepairNote;
use crate::worker::{Request, Response, Subject};
use std::sync::Arc;

impl Model {
    /// The surface and where its points are, while it stands in the target's place.
    pub fn surface(&self) -> Option<(&SurfaceSide, &SurfaceState)> {
        Some((&self.surface, self.session.surface.as_ref()?))
    }

    /// The map of the surface.
    pub fn surface_map(&self) -> Option<&SurfaceMap> {
        self.surface()?.0.map()
    }

    /// The surface's way to the screen; also while none is shown.
    pub fn surface_side(&self) -> &SurfaceSide {
        &self.surface
    }

    /// The interior point of the surface, where its handle is, once it is mapped.
    pub fn surface_point(&self) -> Option<DVec3> {
        let (side, state) = self.surface().filter(|(side, _)| side.map().is_some())?;
        side.place(state)
    }

    /// The boundary point of the surface, where its handle is, once it is mapped.
    pub fn surface_anchor(&self) -> Option<DVec3> {
        let (side, state) = self.surface().filter(|(side, _)| side.map().is_some())?;
        side.anchor_place(state)
    }

    /// Begins to prepare a surface that a person has opened or dropped; what was wrong with an outline for its place is
    /// past. If a session waits for the file of that name, it comes with the session's points.
    pub fn want_surface_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.surface.gives_way = false;
        self.dismiss(Subject::Domain(Side::Target));
        let is_awaited =
            |state: &SurfaceState| matches!(&state.spec.shape, SurfaceShape::File { name: awaited } if awaited == name);
        match self.incoming_surface.take().filter(is_awaited) {
            Some(state) => self.open_surface_file(state, bytes),
            None => self.surface.preparation.want_file(name, bytes),
        }
    }

    /// Takes the surface of a session, whose triangles come from a file.
    pub fn open_surface_file(&mut self, state: SurfaceState, bytes: Vec<u8>) {
        self.surface.preparation.want_file_of(state.spec.clone(), bytes);
        self.incoming_surface = Some(state);
    }

    /// Carries out a command about the surface, or begins to.
    pub(super) fn dispatch_surface(&mut self, command: Command, now: f64) {
        match command {
            Command::SetSurface(spec) => {
                self.incoming_surface = None;
                self.surface.gives_way = false;
                self.dismiss(Subject::Domain(Side::Target));
                self.want_surface(spec, now);
            }
            Command::RefineSurface(spec) => {
                let stays = self.session.surface.is_some() && !self.surface.gives_way;
                let wanted = self.surface.preparation.wanted().filter(|_| stays);
                if wanted.is_some_and(|wanted| wanted.is_like(&spec)) {
                    let incoming = self.incoming_surface.as_mut();
                    if let Some(incoming) = incoming.filter(|incoming| incoming.spec.is_like(&spec)) {
                        // a point is one of a triangle, and those may be others
                        incoming.point = incoming.point.filter(|_| incoming.spec.shape == spec.shape);
                        incoming.spec = spec.clone();
                    }
                    self.want_surface(spec, now);
                }
            }
            Command::CloseSurface => self.close_surface(),
            moved => {
                self.session.apply(moved);
                self.points_changed = true;
            }
        }
    }

    fn want_surface(&mut self, spec: SurfaceSpec, now: f64) {
        if !self.surface.preparation.want_spec(&spec, now) {
            let is_new = self.session.surface.as_ref().is_none_or(|shown| shown.spec.shape != spec.shape);
            self.take_surface(spec, is_new);
        }
    }

    /// Shows a surface that is there, with the points that a session has for it.
    fn take_surface(&mut self, spec: SurfaceSpec, is_new: bool) {
        let incoming = self.incoming_surface.take_if(|incoming| incoming.spec.shape.is_like(&spec.shape));
        self.show_surface(spec, is_new);
        if let Some(incoming) = incoming {
            self.session.surface = Some(incoming);
        }
    }

    /// Shows the outline again that the surface has hidden.
    pub(super) fn close_surface(&mut self) {
        self.incoming_surface = None;
        self.surface.preparation.give_up();
        if self.session.surface.is_some() {
            self.session.apply(Command::CloseSurface);
            self.domains_changed = true;
            self.refit[Side::Target as usize] = true;
        }
    }

    /// Takes the surface of a session that is opened: at once, or when it is prepared.
    pub(super) fn open_surface(&mut self, wanted: Option<SurfaceState>) {
        let Some(wanted) = wanted else { return self.close_surface() };
        self.surface.gives_way = false;
        if self.surface.preparation.want_spec(&wanted.spec, f64::NEG_INFINITY) {
            self.incoming_surface = Some(wanted);
        } else {
            self.session.surface = Some(wanted);
            self.domains_changed = true;
        }
    }

    pub(super) fn take_surface_request(&mut self, now: f64) -> Option<Request> {
        self.surface.preparation.take_request(now)
    }

    /// Takes in an answer of the surface's worker.
    pub fn accept_surface(&mut self, generation: u64, response: Response) {
        if let Some(Arrival { spec, is_new }) = self.surface.preparation.accept(generation, response) {
            self.take_surface(spec, is_new);
        }
    }

    fn show_surface(&mut self, spec: SurfaceSpec, is_new: bool) {
        let shown = self.session.surface.as_ref();
        let is_finer = shown.is_some_and(|shown| shown.spec.shape.is_like(&spec.shape) && shown.spec != spec);
        let place = self.surface_point().filter(|_| is_finer && shown.is_some_and(|shown| shown.point.is_some()));
        if is_new && !is_finer {
            self.session.surface = None;
            self.refit[Side::Target as usize] = true;
        }
        self.session.apply(Command::SetSurface(spec));
        self.surface.renew();
        if let (Some(place), Some(state)) = (place, &mut self.session.surface) {
            state.point = self.surface.nearest(place);
        }
        self.domains_changed = true;
    }

    /// Brings the surface's map up to date with session, domain and surface, or goes on with that.
    pub(super) fn refresh_surface(&mut self) -> Changes {
        let mut changes = Changes::default();
        if std::mem::take(&mut self.domains_changed) {
            self.put_plane_to_sleep();
            self.points_changed = true;
            if let Some(source) = self.domain(Side::Source).map(Arc::clone) {
                self.keep_points_inside();
                self.surface.begin(&source);
            }
        }
        if (std::mem::take(&mut self.points_changed) || self.surface.is_under_way())
            && let Some(constraints) = self.surface_constraints()
        {
            let deadline = Deadline::in_ms(self.update_ms);
            match self.surface.advance(&constraints, deadline) {
                Ok(Advance::Unfinished) => {}
                Ok(advance) => {
                    (changes.meshes, changes.map) = (advance == Advance::Replaced, true);
                    self.revision += 1;
                    self.settle_surface(None);
                }
                Err(error) => self.settle_surface(Some(error)),
            }
        }
        changes.images = changes.map;
        if changes.images {
            self.map_generation += 1;
            self.mesh_generation += u64::from(changes.meshes);
            self.count_images(changes.meshes);
        }
        self.follow_surface_pattern(&mut changes);
        changes
    }

    /// The planar map is made anew when the surface goes.
    fn put_plane_to_sleep(&mut self) {
        (self.map, self.next, self.pending) = (None, None, None);
        self.draft.retire();
        self.draft.forget();
    }

    /// The pattern of the disk needs coordinates of its own on both sides; until they are there, the old pattern stays.
    fn follow_surface_pattern(&mut self, changes: &mut Changes) {
        let home = textured::home(&self.session);
        let Some(map) = self.surface.map() else { return };
        if home.is_none() && !self.teaching.grid.is_of(self.revision) {
            let deadline = Deadline::in_ms(self.update_ms);
            if !self.teaching.grid.advance(GridMap::Surface(map), self.revision, deadline) {
                return;
            }
            changes.images = true;
        }
        changes.meshes |= std::mem::replace(&mut self.pattern_home, home) != home;
    }

    /// Whether the surface's map, or its pattern, is on its way.
    pub(super) fn is_surface_pending(&self) -> bool {
        let lacks_grid = textured::home(&self.session).is_none() && !self.teaching.grid.is_of(self.revision);
        self.session.surface.is_some() && (self.surface.is_under_way() || lacks_grid)
    }

    fn surface_constraints(&self) -> Option<SurfaceConstraints> {
        let (side, state) = self.surface()?;
        Some(SurfaceConstraints {
            source_point: self.interior(Side::Source)?,
            source_anchor: self.session.anchor[Side::Source as usize],
            surface_point: side.point(state)?,
            surface_anchor: state.anchor,
        })
    }

    fn settle_surface(&mut self, error: Option<SurfaceMapError>) {
        let Some(error) = error else {
            self.last_good_points = (self.session.interior, self.session.anchor);
            self.last_good_surface.clone_from(&self.session.surface);
            self.map_error = None;
            return;
        };
        if self.surface.is_stuck() {
            // the first map of a surface or over an outline: no points of before fit
            self.begin_at_the_middles();
        } else {
            (self.session.interior, self.session.anchor) = self.last_good_points;
            if let (Some(state), Some(good)) = (&mut self.session.surface, &self.last_good_surface) {
                (state.point, state.anchor) = (good.point, good.anchor);
            }
        }
        let side = if matches!(error, SurfaceMapError::Planar(_)) { Side::Source } else { Side::Target };
        self.map_error = Some((side, error.to_string()));
    }

    /// Tries once more with the default points, unless they were those that failed.
    fn begin_at_the_middles(&mut self) {
        let Some(state) = &mut self.session.surface else { return };
        let point = state.point.take();
        let interior = self.session.interior[Side::Source as usize].take();
        self.points_changed = point.is_some() || interior.is_some();
    }

    /// What was noticed when the surface was read, how it was repaired, and what is to be known of its map.
    pub fn surface_notes(&self) -> Vec<String> {
        let Some((side, _)) = self.surface() else { return Vec::new() };
        let words = |repair: &RepairNote| match repair {
            RepairNote::FilledHoles { .. } => format!("{repair}: grey in the colours of distortion"),
            _ => repair.to_string(),
        };
        let repairs = side.surface().into_iter().flat_map(|surface| &surface.surface.repairs);
        let map = side.map().and_then(SurfaceMap::note).map(|note| note.to_string());
        side.preparation.notes.iter().cloned().chain(repairs.map(words)).chain(map).collect()
    }

    /// Where the interior handle goes when the pointer's ray meets the surface at `found`.
    pub fn surface_point_near(&self, found: BarycentricPoint) -> Option<BarycentricPoint> {
        self.surface()?.0.interior_near(found)
    }
}

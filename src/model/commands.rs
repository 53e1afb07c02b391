//! The inputs of the model: commands, quick fixes; requests to the workers and their responses.

use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::Message;
use crate::model::Model;
use crate::model::editing::Reshaped;
use crate::model::side::preparation::Progress;
use crate::model::side::sharpening::Sharpening;
use crate::model::side::user_error::{QuickFix, UserError};
use crate::model::side::{ModelSide, Next, OutlineRequest};
use crate::outline::{Outline, OutlineNote};
use crate::session::{Command, DomainSpec, OutlineSpec, Session, SurfaceState, Touched};
use crate::worker::{Request, Response};

/// The distance from the boundary to which a point is moved, in sizes of the domain: nearer, the map
/// compresses nearly everything into a region too small to be seen.
const PUSH: f64 = 0.05;

impl Model {
    /// Carries out a command; one that needs a preparation takes effect when that is done. Returns the parts of the
    /// session that it touches, now or then; [`Touched::NOTHING`] if the command needs a surface and there is none.
    pub fn dispatch(&mut self, command: Command, now: f64) -> Touched {
        let touched = command.touches();
        if touched.touches(Touched::NEW_SHAPE) {
            self.pinned.expect(None);
        }
        match command {
            Command::SetOutline { side, outline } => {
                self.want_outline(side, outline, Vec::new());
            }
            // what is opened comes with its pins, and only when its outline is prepared
            whole @ (Command::PinOutline { .. } | Command::Continue) => self.open(&self.requested().and([whole])),
            Command::ReshapeOutline { side, outline, interior, anchor } => {
                self.reshape(side, outline, Reshaped { interior, anchor, in_hand: false, turned: false });
            }
            Command::SetSurface { side, surface } => self.set_surface(side, surface, now),
            Command::RefineSurface { side, surface } => {
                if !self.refine_surface(side, surface, now) {
                    return Touched::NOTHING;
                }
            }
            Command::SetHoles { side, holes } => self.set_holes(side, holes),
            Command::CloseSurface(side) => {
                self.close_surface(side);
                self.drop_region(side);
            }
            Command::SetSettings { side, settings } => self.side_mut(side).want_settings(settings, now),
            Command::Swap => self.swap(),
            Command::Open(session) => self.open(&session),
            Command::SetPins(pins) => self.set_pins(pins),
            Command::MovePin { pin, side, fraction } => return self.move_pin(pin, side, fraction),
            Command::MoveInterior { .. } | Command::MoveAnchor { .. } | Command::PlacePoints { .. } => {
                let touched = self.session.apply(command);
                if touched != Touched::NOTHING {
                    self.set_pins(None); // the points determine the map again
                }
                return touched;
            }
            Command::SetDirection(_)
            | Command::SetExtension(_)
            | Command::SetTexture(_)
            | Command::SetTextureSide(_)
            | Command::SetTextureScale(_)
            | Command::PlacePicture(_)
            | Command::SetTiling(_)
            | Command::SetColouring(_)
            | Command::SetWireframe(_)
            | Command::SetPlots(_)
            | Command::SetComparison(_)
            | Command::SetRegion(_)
            | Command::SetMarks { .. }
            | Command::MoveMark { .. }
            | Command::SetSymmetries(_) => {
                let touched = self.session.apply(command);
                self.changed.points |= touched.touches(Touched::POINTS | Touched::SETTINGS);
                return touched;
            }
        }
        touched
    }

    /// Opens another session: immediately except for its domains, which follow with their points when they are
    /// prepared.
    fn open(&mut self, session: &Session) {
        for side in Side::BOTH {
            self.stop_reading(side);
            let points = session.side(side).outline_points();
            let has_to_come = self.side_mut(side).want_spec(session.domain(side));
            self.sides[side].incoming_points = has_to_come.then_some(points);
            if !has_to_come {
                self.session.apply(Command::PlacePoints { side, points });
            }
        }
        let over_what_is_shown = session.over_sides_of(&self.session);
        self.session.apply(Command::Open(Box::new(over_what_is_shown)));
        let prepared = self.sides.as_ref().map(|side| side.surface.preparation.twin());
        for side in Side::BOTH {
            if let Some(SurfaceState { spec, .. }) = session.surface(side) {
                // undoing an exchange of the sides prepares no surface again
                self.sides[side].take_over_surface(&prepared[side.other()], spec, &self.surface_files);
            }
            self.open_surface(side, session.surface(side).cloned());
        }
        self.pinned.expect(session.pins().cloned());
        self.under_way.error = None;
        self.changed.points = true;
    }

    fn want_outline(&mut self, side: Side, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        self.stop_reading(side);
        self.replace_outline(side, outline, notes);
    }

    /// Starts preparing another outline, which will replace the side's outline or surface. A file that is being parsed
    /// is not canceled.
    pub(super) fn replace_outline(&mut self, side: Side, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        self.sides[side].next = Next::Same;
        self.sides[side].surface.preparation.give_up();
        if self.session.surface(side).is_some() && self.side(side).wanted().outline == outline {
            self.drop_region(side);
            return self.close_surface(side);
        }
        self.pinned.expect(None);
        self.sides[side].next = Next::Outline;
        self.sides[side].incoming_points = None;
        self.side_mut(side).error = None;
        self.side_mut(side).want_outline(outline, notes);
    }

    /// Starts preparing a reshaped outline, coarsely while it is being dragged.
    pub fn reshape(&mut self, side: Side, outline: OutlineSpec, reshaped: Reshaped) {
        self.sides[side].incoming_points = None;
        self.side_mut(side).want_reshaped(outline, reshaped);
    }

    /// Starts preparing an outline that was read, drawn or traced.
    pub fn want_loaded(&mut self, side: Side, outline: Outline) {
        let notes = outline.notes().to_vec();
        self.want_outline(side, outline.into(), notes);
    }

    /// The errors of a side's outline and of its surface.
    pub fn user_errors(&self, side: Side) -> impl Iterator<Item = &UserError> {
        let ModelSide { outline, surface, .. } = &self.sides[side];
        outline.error.iter().chain(&surface.preparation.error)
    }

    /// The notes from reading a side's outline and, if one is shown, its surface.
    pub fn notes(&self, side: Side) -> impl Iterator<Item = Message> {
        self.side(side).notes.iter().cloned().chain(self.surface_notes(side))
    }

    /// Whether a preparation for a side is in progress.
    pub fn is_preparing(&self, side: Side) -> bool {
        self.sides[side].is_busy() || self.opening.concerns(side)
    }

    /// Applies the quick fix of a side's user error. Returns what it touches: nothing if it only repeats a request.
    pub fn quick_fix(&mut self, side: Side) -> Touched {
        let ModelSide { outline, surface, .. } = &mut self.sides[side];
        if surface.preparation.error.as_ref().is_some_and(|user_error| user_error.quick_fix.is_some()) {
            surface.preparation.quick_fix();
            return Touched::NOTHING;
        }
        match outline.error.take().and_then(|user_error| user_error.quick_fix) {
            Some(QuickFix::Retry) => outline.retry(),
            Some(QuickFix::ReadAgain(opened)) => self.read_in_turn(side, opened),
            Some(QuickFix::Repaired(outline)) => {
                self.want_loaded(side, *outline);
                return Touched::ANOTHER_SHAPE;
            }
            Some(QuickFix::RepairSurface) | None => {}
        }
        Touched::NOTHING
    }

    /// Shows a user error beside a side, in place of the messages there.
    pub fn refuse(&mut self, side: Side, error: UserError) {
        self.dismiss(side);
        self.side_mut(side).error = Some(error);
    }

    /// Closes the messages about a side.
    pub fn dismiss(&mut self, side: Side) {
        self.sides[side].surface.preparation.dismiss();
        self.side_mut(side).error = None;
        self.under_way.error = self.under_way.error.take().filter(|(at, _)| *at != side);
        self.pinned.dismiss(side);
    }

    /// The requests that are due, at most one for each side; those for the sharpened and the refined map come last.
    pub fn take_requests(&mut self, now: f64) -> Vec<(Side, Request)> {
        self.read_on();
        // a dragged outline is prepared again only when the picture shows the last one; otherwise none would be shown
        let shows = !self.is_pending() && !self.changed.sides;
        let mut requests = Vec::new();
        for side in Side::BOTH {
            let at = (self.equation_point(side), !self.under_way.is_moving);
            requests.extend(self.sides[side].take_request(now, shows, at).map(|request| (side, request)));
            if !self.side(side).is_busy() {
                self.refuse_incoming(side);
            }
        }
        requests.extend(self.take_mesh_request());
        requests
    }

    /// The time at which the next request is due.
    pub fn next_due(&self) -> Option<f64> {
        let is_due = |side| {
            let is_due = |point| self.sides[side].is_equation_due(point, !self.under_way.is_moving);
            self.equation_point(side).is_some_and(is_due)
        };
        let is_due = self.can_read_on() || self.is_mesh_due() || Side::BOTH.into_iter().any(is_due);
        let file = is_due.then_some(f64::NEG_INFINITY);
        self.sides.iter().filter_map(|(_, side)| side.due()).chain(file).reduce(f64::min)
    }

    /// Processes a response of a side's worker. [`Self::take_arrived`] returns the file that it completed, if any.
    pub fn accept(&mut self, side: Side, generation: u64, response: Response) {
        if self.sides[side].reading.pending_request().awaits(generation) {
            return self.accept_read(side, generation, response);
        }
        if self.sides[side].surface.preparation.pending_request().awaits(generation) {
            return self.accept_surface(side, generation, response);
        }
        if self.sides[side].sharpening.awaits(generation) {
            if self.sides[side].accept_equation(generation, response) && self.session.surface(side).is_none() {
                self.change_sides();
            }
            return;
        }
        if self.sides[side].mesh.awaits(generation) {
            return self.accept_mesh(side, generation, response);
        }
        match self.side_mut(side).accept(generation, response) {
            Progress::Nothing => {}
            Progress::Failed => {
                self.refuse_incoming(side);
                self.sides[side].next.take_outline();
            }
            Progress::Ready { request: OutlineRequest { spec, reshaped: Some(reshaped), .. }, .. } => {
                self.take_reshaped(side, spec, reshaped);
            }
            Progress::Ready { request, is_new } => self.take_prepared(side, request.spec, is_new),
        }
    }

    /// Drops the points of a session whose outline was refused, and its pins.
    fn refuse_incoming(&mut self, side: Side) {
        if self.sides[side].incoming_points.take().is_some() {
            self.pinned.expect(None);
        }
    }

    /// The interior point for which a side's integral equation is factored; `None` for a surface.
    fn equation_point(&self, side: Side) -> Option<DVec2> {
        if self.session.surface(side).is_some() { None } else { self.interior(side) }
    }

    /// Whether a side's integral equation is due or under way: finite elements are shown for now, or an equation that
    /// does not resolve the interior point.
    pub fn is_sharpening(&self, side: Side) -> bool {
        let ModelSide { outline, sharpening, .. } = &self.sides[side];
        self.equation_point(side).is_some_and(|point| sharpening.is_wanted(outline, point))
    }

    /// Makes no more requests for integral equations: the sides keep those that they have.
    pub(super) fn end_sharpening(&mut self) {
        for side in Side::BOTH {
            self.sides[side].sharpening = Sharpening::none();
        }
    }

    /// Tells whether no point moves: an integral equation for another point and a refined mesh are requested only then.
    pub fn set_at_rest(&mut self, is_at_rest: bool) {
        self.under_way.is_moving = !is_at_rest;
    }

    /// Drops the region that was painted on a source that another shape has replaced; not before, since a shape may be
    /// refused.
    pub(super) fn drop_region(&mut self, side: Side) {
        if side == Side::Source {
            self.session.apply(Command::SetRegion(Vec::new()));
        }
    }

    /// Applies a prepared outline, with the points that a session has for it.
    fn take_prepared(&mut self, side: Side, spec: DomainSpec, is_new: bool) {
        if is_new && spec.outline != self.session.domain(side).outline {
            // a surface that was opened with the outline, or before it, stays
            let (anchor, outline) = (spec.outline.first_anchor(), spec.outline);
            if self.sides[side].incoming_points.is_none() && self.session.surface(side).is_none() {
                self.session.apply(Command::SetPins(None));
                self.drop_region(side);
            }
            self.session.apply(Command::ReshapeOutline { side, outline, interior: None, anchor });
        }
        if self.sides[side].next.take_outline() {
            self.session.apply(Command::CloseSurface(side));
            self.drop_region(side);
        }
        self.session.apply(Command::SetSettings { side, settings: spec.settings });
        if let Some(points) = self.sides[side].incoming_points.take() {
            self.session.apply(Command::PlacePoints { side, points });
        }
        if self.session.surface(side).is_none() {
            self.sides[side].refit |= is_new;
            self.change_sides();
        }
    }

    /// Applies a prepared reshaped outline. The view does not change, nor do the settings while the outline is dragged.
    fn take_reshaped(&mut self, side: Side, spec: DomainSpec, reshaped: Reshaped) {
        let Reshaped { interior, anchor, in_hand, turned } = reshaped;
        let interior = interior.and_then(|point| self.pushed_inside(side, point));
        self.carry_pins(side, &spec.outline, turned);
        self.carry_marks(side, &spec.outline, turned);
        self.session.apply(Command::ReshapeOutline { side, outline: spec.outline, interior, anchor });
        if !in_hand {
            self.session.apply(Command::SetSettings { side, settings: spec.settings });
        }
        self.change_sides();
    }

    /// The interior point of a reshaped side: if the outline no longer contains it, moved well inside,
    /// so that details of the map can be seen.
    fn pushed_inside(&self, side: Side, point: DVec2) -> Option<DVec2> {
        if self.interior_near(side, point)?.distance(point) == 0.0 {
            return Some(point);
        }
        let (low, high) = self.extent(side)?;
        Some(self.domain(side)?.nearest_inside(point, PUSH * (high - low).max_element()))
    }

    /// Handles the death of a side's worker over the request of this generation; `None`: over any that is in flight.
    /// [`Self::take_arrived`] returns the file that it was reading, if the message about it is not the side's.
    pub fn worker_died(&mut self, side: Side, generation: Option<u64>, reason: &Message) {
        if self.sides[side].reading.pending_request().is_lost(generation) {
            self.reader_died(side, reason);
        }
        self.sides[side].sharpening.worker_died(generation, reason);
        self.mesh_is_lost(side, generation, reason);
        self.side_mut(side).worker_died(generation, reason);
        self.sides[side].surface.preparation.worker_died(generation, reason);
    }

    fn swap(&mut self) {
        if Side::BOTH.into_iter().any(|side| self.is_preparing(side)) {
            return;
        }
        self.session.apply(Command::Swap);
        self.pinned.swap();
        self.overlay_state.invariants.swap();
        self.overlay_state.orthogonal_grids.swap();
        ModelSide::swap(&mut self.sides);
        for side in Side::BOTH {
            self.sides[side].refit = true;
        }
        self.change_sides();
    }
}

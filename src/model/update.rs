//! The update of the full map, within a time limit per frame; a coarse map replaces one that takes longer.
//!
//! The picture is always that of one complete map: the last full one, the draft, or the
//! new full one. With the direct solver, the draft is shown only from the second successive frame that was too short:
//! in the first one a browser may be compiling code that it runs for the first time.
//!
//! Surfaces differ from outlines in one respect here, [`Model::has_stand_in`]: there is no coarse substitute for their
//! map. Its update keeps the constraints that it started with until it is complete; then the next one takes the present
//! ones.

use crate::conformal::{ConformalMap, Constraints, InteriorPoint, MapError, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::laplace::{Deadline, SolverKind};
use crate::model::{Changes, Model, pattern};
use crate::session::{Command, SidePoints};
use std::sync::Arc;

impl Model {
    /// Whether a coarse map can replace the full one: only one between the same outlines.
    fn has_stand_in(&self) -> bool {
        self.abilities().compares_outlines()
    }

    /// Records that a side's surface has another resolution. The map of the former one stays in the picture until the map
    /// of the present one is complete.
    pub(super) fn change_resolution(&mut self) {
        self.changed.sides = true;
    }

    /// Records a change of a side's geometry. A map of other geometry is no longer shown, except between outlines.
    pub(super) fn change_sides(&mut self) {
        self.changed.sides = true;
        let fits = |map: &ConformalMap, side| {
            self.prepared(side).is_some_and(|standing| {
                let mapped = map.side(side);
                Arc::ptr_eq(mapped, standing) || !(mapped.is_surface() || standing.is_surface())
            })
        };
        if self.shown.map.as_ref().is_some_and(|map| !Side::BOTH.into_iter().all(|side| fits(map, side))) {
            self.shown.map = None;
        }
    }

    /// Starts the map of changed sides; returns whether the picture changes now.
    pub(super) fn take_sides(&mut self) -> bool {
        let retired = self.coarse.retire();
        self.coarse.forget();
        self.keep_points_inside();
        let next = self.prepared(Side::Source).zip(self.prepared(Side::Target));
        let next = next.map(|(source, target)| ConformalMap::unmapped(Arc::clone(source), Arc::clone(target)));
        self.under_way.restart(next);
        self.has_stand_in() && (retired || self.shown.map.is_none())
    }

    /// Continues a pending update: in a drag that is too fast for the full map, with the draft alone.
    pub(super) fn go_on(&mut self, dragging: bool) -> Changes {
        let mut changes = Changes::default();
        if dragging && self.is_slow() {
            changes |= self.follow_coarsely();
            if self.is_draft() {
                return changes;
            }
        }
        match self.advance() {
            Ok(true) => changes |= self.show_full(),
            Ok(false) => {
                self.under_way.unfinished += 1;
                if self.is_slow() {
                    changes |= self.follow_coarsely();
                }
            }
            Err(error) => changes |= self.give_up(&error),
        }
        changes
    }

    /// Spends one frame's time on the full map and, if the pattern needs them, its disk
    /// coordinates; returns whether both are complete.
    fn advance(&mut self) -> Result<bool, MapError> {
        let Some(wanted) = self.constraints() else { return Ok(true) };
        let asked = self.under_way.go_on(wanted, !self.has_stand_in());
        let Some(map) = self.under_way.next.as_mut().or(self.shown.map.as_mut()) else { return Ok(true) };
        let deadline = Deadline::in_ms(self.update_ms);
        if !map.advance(&asked.constraints, self.session.map_settings(), deadline)? {
            return Ok(false);
        }
        self.shown.map_revision = asked.revision;
        let needs_grid = pattern::needs_grid(&self.session);
        Ok(!needs_grid || self.overlay_state.grid.advance(map, self.shown.map_revision, deadline))
    }

    /// Whether the pattern needs disk coordinates that the full map does not have.
    pub(super) fn lacks_grid(&self) -> bool {
        let is_there = self.shown.map.is_some() && self.under_way.next.is_none();
        pattern::needs_grid(&self.session) && is_there && !self.overlay_state.grid.is_of(self.shown.map_revision)
    }

    /// Shows the full map, which is complete.
    fn show_full(&mut self) -> Changes {
        let has_caught_up = self.under_way.finish(self.constraints());
        let replaced = self.under_way.next.is_some();
        if let Some(mut map) = self.under_way.next.take() {
            if let Some(old) = self.shown.map.take() {
                map.adopt(old);
            }
            self.shown.map = Some(map);
        }
        let retired = self.coarse.retire();
        let shown = &mut self.shown;
        let Some(map) = &shown.map else { return Changes::default() };
        let turned = std::mem::replace(&mut shown.direction, map.direction()) != map.direction();
        let renewed = std::mem::replace(&mut shown.revision, shown.map_revision) != shown.map_revision;
        if has_caught_up {
            for side in Side::BOTH {
                self.sides[side].last_good = self.session.side(side).points();
            }
            self.note_good_pins();
        }
        self.under_way.error = None;
        let (meshes, map) = (replaced || retired || turned, replaced || retired || renewed);
        Changes { meshes, map, images: map }
    }

    /// Handles an error of the full map: the last good one stays.
    fn give_up(&mut self, error: &MapError) -> Changes {
        self.under_way.give_up();
        if self.under_way.next.is_none() {
            for side in Side::BOTH {
                self.session.apply(Command::PlacePoints { side, points: self.sides[side].last_good });
            }
            self.session.apply(Command::SetPins(self.pinned.last_good().cloned()));
            self.pinned.give_up();
            self.changed.points = false;
        } else if !self.has_stand_in() {
            self.begin_at_the_default_point(error.side());
        }
        self.under_way.error = Some((error.side(), Message::from(error)));
        let meshes = self.coarse.retire();
        Changes { meshes, map: meshes, images: meshes }
    }

    /// After the first map of a surface was rejected because of the point of a side: tries once more with that side's
    /// default point, unless this was the rejected one. The other side keeps its points.
    fn begin_at_the_default_point(&mut self, side: Side) {
        let (is_set, points) = match self.session.side(side).points() {
            SidePoints::Outline { interior, anchor } => {
                (interior.is_some(), SidePoints::Outline { interior: None, anchor })
            }
            SidePoints::Surface { interior, anchor } => {
                (interior.is_some(), SidePoints::Surface { interior: None, anchor })
            }
        };
        self.changed.points |= is_set;
        self.session.apply(Command::SetPins(None)); // they led to the point that was rejected
        self.session.apply(Command::PlacePoints { side, points });
    }

    /// Whether the full map is too slow for a drag. For the iterative solver one frame that was too short is sufficient
    /// evidence, for the direct one two are needed.
    fn is_slow(&self) -> bool {
        let is_iterative = |side| self.prepared(side).is_some_and(|prepared| prepared.solver_kind() == SolverKind::Pcg);
        let most = u32::from(!Side::BOTH.into_iter().any(is_iterative));
        self.has_stand_in() && self.under_way.unfinished > most
    }

    /// Updates the coarse map, unless it is up to date; if that fails, the last full one is shown.
    fn follow_coarsely(&mut self) -> Changes {
        if self.coarse.has_followed(self.under_way.revision) {
            return Changes::default();
        }
        let Some(constraints) = self.constraints() else { return Changes::default() };
        let before = self.coarse.map().map(ConformalMap::direction);
        let outlines = Side::BOTH.map(|side| &self.session.domain(side).outline);
        if self.coarse.follow(outlines, &constraints, self.session.map_settings()) {
            let meshes = before != Some(self.session.direction());
            return Changes { meshes, map: true, images: true };
        }
        let retired = self.coarse.retire();
        Changes { meshes: retired, map: retired, images: retired }
    }

    /// Whether the interior point of an outline may be here, though perhaps only with the equation that it awaits.
    fn may_be_at(&self, side: Side, point: DVec2) -> bool {
        let Some(prepared) = self.prepared(side) else { return false };
        let is_inside_curve =
            || self.session.domain(side).outline.curve().is_ok_and(|curve| curve.curve().contains(point));
        prepared.contains(point) || prepared.awaits_equation() && is_inside_curve()
    }

    /// Where the points of both sides are. A point that only the curve contains is moved into the mesh, until the
    /// equation on the curve is there.
    pub(super) fn constraints(&self) -> Option<Constraints> {
        let place = |side: Side| match (self.point(side)?, self.prepared(side)) {
            (InteriorPoint::Plane(x), Some(prepared)) if prepared.awaits_equation() && !prepared.contains(x) => {
                self.interior_near(side, x).map(InteriorPoint::from)
            }
            (point, _) => Some(point),
        };
        let of_side = |side| Some((place(side)?, self.session.side(side).points().anchor()));
        Some(Constraints::new(of_side(Side::Source)?, of_side(Side::Target)?))
    }

    /// Moves interior points that are outside into the domains: a point inside a polygon may lie outside a coarser one.
    pub(super) fn keep_points_inside(&mut self) {
        for side in Side::BOTH {
            if let Some(point) = self.session.side(side).interior
                && !self.may_be_at(side, point)
                && let Some(inside) = self.interior_near(side, point)
            {
                self.session.apply(Command::MoveInterior { side, point: inside.into() });
            }
        }
    }
}

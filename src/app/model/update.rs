//! The full map, a frame's share at a time; what takes longer lets a coarse one stand in.
//!
//! The picture is always that of one complete map: the last full one, the draft, or the
//! new full one. Only a direct map's second frame in a row that was too short lets the draft be
//! seen: a browser compiles what it runs for the first time.

use super::{Changes, Model};
use crate::app::teaching::disk_grid::GridMap;
use crate::app::textured;
use crate::conformal::{ConformalMap, Constraints, MapError, Side};
use crate::laplace::{Deadline, SolverKind};
use std::sync::Arc;

impl Model {
    /// Begins with the map of other domains; whether the picture changes at once.
    pub(super) fn take_domains(&mut self) -> bool {
        let retired = self.draft.retire();
        self.draft.forget();
        self.unfinished = 0;
        self.keep_points_inside();
        if let (Some(source), Some(target)) = (self.domain(Side::Source), self.domain(Side::Target)) {
            self.next = Some(ConformalMap::unmapped(Arc::clone(source), Arc::clone(target)));
        }
        retired || self.map.is_none()
    }

    /// Goes on with what is pending: in a drag that is too fast for the full map, with the draft alone.
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
                self.unfinished += 1;
                if self.is_slow() {
                    changes |= self.follow_coarsely();
                }
            }
            Err(error) => changes |= self.give_up(error),
        }
        changes
    }

    /// Spends a frame's share on the full map and, where the pattern needs them, its disk
    /// coordinates; whether all is there.
    fn advance(&mut self) -> Result<bool, MapError> {
        let Some(constraints) = self.constraints() else { return Ok(true) };
        let Some(map) = self.next.as_mut().or(self.map.as_mut()) else { return Ok(true) };
        self.pending = self.pending.map(|frames| frames + 1);
        let deadline = Deadline::in_ms(self.update_ms);
        if !map.advance(&constraints, self.session.map_settings(), deadline)? {
            return Ok(false);
        }
        self.map_revision = self.revision;
        let in_the_plane = textured::home(&self.session).is_some();
        Ok(in_the_plane || self.teaching.grid.advance(GridMap::Planar(map), self.map_revision, deadline))
    }

    /// Whether the pattern needs disk coordinates that the full map does not have.
    pub(super) fn lacks_grid(&self) -> bool {
        let wanted = textured::home(&self.session).is_none() && self.map.is_some() && self.next.is_none();
        wanted && !self.teaching.grid.is_of(self.map_revision)
    }

    /// The full map is complete: it is the one in the picture.
    fn show_full(&mut self) -> Changes {
        if self.pending.take() == Some(1) {
            self.unfinished = 0;
        }
        let replaced = self.next.is_some();
        if let Some(mut map) = self.next.take() {
            if let Some(old) = self.map.take() {
                map.adopt(old);
            }
            self.map = Some(map);
        }
        let retired = self.draft.retire();
        let Some(map) = &self.map else { return Changes::default() };
        let turned = std::mem::replace(&mut self.shown_direction, map.direction()) != map.direction();
        let renewed = std::mem::replace(&mut self.shown_revision, self.map_revision) != self.map_revision;
        self.settle(None);
        let (meshes, map) = (replaced || retired || turned, replaced || retired || renewed);
        Changes { meshes, map, images: map }
    }

    /// The full map could not be made: the last good one stays.
    fn give_up(&mut self, error: MapError) -> Changes {
        self.pending = None;
        if self.next.is_none() {
            (self.session.interior, self.session.anchor) = self.last_good_points;
        }
        self.settle(Some(error));
        let meshes = self.draft.retire();
        Changes { meshes, map: meshes, images: meshes }
    }

    fn settle(&mut self, error: Option<MapError>) {
        if error.is_none() {
            self.last_good_points = (self.session.interior, self.session.anchor);
        }
        self.map_error = error.map(|error| (side_of(&error), error.to_string()));
    }

    /// Whether the full map is too slow for a drag. One frame that was too short says so of the
    /// iterative solver only.
    fn is_slow(&self) -> bool {
        let is_iterative = |side| self.domain(side).is_some_and(|domain| domain.solver.kind() == SolverKind::Pcg);
        self.unfinished > u32::from(!Side::BOTH.into_iter().any(is_iterative))
    }

    /// Lets the coarse map follow, if it has not; where it cannot, the last full one is in the picture.
    fn follow_coarsely(&mut self) -> Changes {
        if std::mem::replace(&mut self.draft_revision, self.revision) == self.revision && self.is_draft() {
            return Changes::default();
        }
        let Some(constraints) = self.constraints() else { return Changes::default() };
        let before = self.draft.map().map(ConformalMap::direction);
        let outlines = Side::BOTH.map(|side| &self.session.domain(side).outline);
        if self.draft.follow(outlines, &constraints, self.session.map_settings()) {
            let meshes = before != Some(self.session.direction);
            return Changes { meshes, map: true, images: true };
        }
        let retired = self.draft.retire();
        Changes { meshes: retired, map: retired, images: retired }
    }

    fn constraints(&self) -> Option<Constraints> {
        let poles = [self.domain(Side::Source)?.pole, self.domain(Side::Target)?.pole];
        Some(self.session.constraints(poles))
    }

    /// A point that was set may lie outside a coarser polygon of the same outline.
    pub(super) fn keep_points_inside(&mut self) {
        for side in Side::BOTH {
            if let Some(point) = self.session.interior[side as usize]
                && let Some(inside) = self.interior_near(side, point)
            {
                self.session.interior[side as usize] = Some(inside);
            }
        }
    }
}

fn side_of(error: &MapError) -> Side {
    match error {
        MapError::PointOutside { side, .. }
        | MapError::AnchorNotFinite { side }
        | MapError::NotConverged { side, .. } => *side,
    }
}

//! Bringing the map up to date with session and domains, in full or, during a slow drag, coarsely.

use super::{Changes, Model, Refines};
use crate::app::teaching::walks::WalkAction;
use crate::app::teaching::{Situation, Teaching};
use crate::app::textured;
use crate::conformal::{ConformalMap, Constraints, MapError, Quality, Side, surface_distortions, triangle_distortions};
use crate::laplace::SolverKind;
use crate::session::Session;
use std::sync::Arc;
use web_time::Instant;

/// The quality is computed with every update when it takes less than this, else when the drag rests.
const CHEAP_QUALITY_MS: f64 = 1.0;

/// What a frame spends on an extension that is not complete: half of a frame at 60 Hz. The app
/// asks for another frame whenever images changed, and so goes on until it is.
const REFINE_MS: f64 = 8.0;

impl Model {
    /// Brings the map up to date with session and domains; `dragging`: a dot is held.
    pub fn refresh(&mut self, dragging: bool) -> Changes {
        if self.session.surface.is_some() {
            return self.refresh_surface();
        }
        let mut changes = Changes::default();
        if std::mem::take(&mut self.domains_changed) {
            changes.meshes = true;
            self.draft.forget();
            self.keep_points_inside();
            changes.map |= self.rebuild();
            self.points_changed = false;
        }
        if std::mem::take(&mut self.points_changed) {
            let full = self.draft.map().is_none();
            if dragging && self.is_slow() && self.follow_coarsely() {
                (changes.meshes, changes.map) = (full, true);
            } else {
                changes |= self.update();
            }
        }
        if !dragging && self.draft.map().is_some() {
            changes |= self.update();
        }
        let refined = self.refines == Refines::InRefresh && self.refine();
        changes.images = changes.map || refined;
        self.map_generation += u64::from(changes.map || changes.meshes);
        if changes.meshes || changes.images {
            self.mesh_generation += u64::from(changes.meshes);
            self.count_images(changes.meshes);
        }
        let home = textured::home(&self.session);
        changes.meshes |= std::mem::replace(&mut self.pattern_home, home) != home;
        let shown = self.draft.map().or(self.map.as_ref());
        if let (None, Some(map)) = (home, shown) {
            self.teaching.grid.update(&situation(map, &self.session, self.map_generation));
        }
        changes
    }

    /// When to refine an extension: at rest, where the picture has it from elsewhere.
    pub fn set_refines(&mut self, refines: Refines) {
        self.refines = refines;
    }

    /// Goes on with an extension that [`Self::refresh`] leaves alone.
    pub fn refine_at_rest(&mut self) -> Changes {
        let images = self.refines == Refines::AtRest && self.refine();
        if images {
            self.count_images(false);
        }
        Changes { images, ..Changes::default() }
    }

    /// How far the images are those of the extension that was asked for, from 0 to 1.
    pub fn extension_progress(&self) -> f64 {
        self.map.as_ref().map_or(1.0, ConformalMap::extension_progress)
    }

    /// Notes that images moved.
    pub(super) fn count_images(&mut self, another_mesh: bool) {
        self.generation += 1;
        self.quality_stale = true;
        // what the picture does not show is not worth a number
        let shown = self.refines == Refines::InRefresh || self.extension_progress() == 1.0;
        // Another mesh has other triangles: the old ones' distortions fit nothing any more.
        if another_mesh || (shown && self.quality_ms < CHEAP_QUALITY_MS) {
            self.measure();
        }
    }

    /// What teaches.
    pub fn teaching(&self) -> &Teaching {
        &self.teaching
    }

    /// Does something with the random walks.
    pub fn act_on_walks(&mut self, action: WalkAction) {
        self.teaching.walks.act(action);
    }

    /// Brings what teaches up to date at the time `now` (seconds); in how many seconds to come back, if at all.
    pub fn teach(&mut self, now: f64) -> Option<f64> {
        // A coarse map has boundaries of its own: what is shown waits for the full one.
        let map = self.map.as_ref().filter(|_| self.draft.map().is_none())?;
        let situation = situation(map, &self.session, self.map_generation);
        self.teaching.advance(&situation, self.session.comparison, now)
    }

    /// Whether [`Self::measure`] would tell something new.
    pub fn is_quality_stale(&self) -> bool {
        self.quality_stale
    }

    /// Measures the map's distortion.
    pub fn measure(&mut self) {
        let start = Instant::now();
        self.triangles.clear();
        let shown = self.draft.map().or(self.map.as_ref());
        self.quality = if let Some(map) = self.surface.map().filter(|_| self.session.surface.is_some()) {
            surface_distortions(&map.surface().surface.mesh, map.images(), &mut self.triangles);
            Some(Quality::summary(map.given(&self.triangles)))
        } else {
            shown.map(|map| {
                triangle_distortions(map.mapped_mesh(), map.images(), &mut self.triangles);
                Quality::summary(&self.triangles)
            })
        };
        self.measured = self.generation;
        self.quality_ms = start.elapsed().as_secs_f64() * 1e3;
        self.quality_stale = false;
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

    fn note_duration(&mut self, start: Instant) {
        let slow = start.elapsed().as_secs_f64() * 1e3 > self.slow_update_ms;
        self.slow_updates = if slow { self.slow_updates + 1 } else { 0 };
    }

    /// Whether the full map is too slow for a drag. One slow update says so of the iterative
    /// solver only: a browser compiles what it runs for the first time.
    fn is_slow(&self) -> bool {
        let is_iterative = |side| self.domain(side).is_some_and(|domain| domain.solver.kind() == SolverKind::Pcg);
        self.slow_updates > u32::from(!Side::BOTH.into_iter().any(is_iterative))
    }

    /// Lets the coarse map follow the points; whether it could.
    fn follow_coarsely(&mut self) -> bool {
        let Some(constraints) = self.constraints() else { return false };
        let outlines = Side::BOTH.map(|side| &self.session.domain(side).outline);
        self.draft.follow(outlines, &constraints, self.session.map_settings())
    }

    fn rebuild(&mut self) -> bool {
        let (Some(source), Some(target)) = (self.domain(Side::Source), self.domain(Side::Target)) else { return false };
        let Some(constraints) = self.constraints() else { return false };
        let (source, target) = (Arc::clone(source), Arc::clone(target));
        let start = Instant::now();
        let map = ConformalMap::new(source, target, &constraints, self.session.map_settings());
        self.note_duration(start);
        match map {
            Ok(mut map) => {
                if let Some(old) = self.map.take() {
                    map.adopt(old);
                }
                self.map = Some(map);
                self.settle(None);
                true
            }
            Err(error) => {
                self.settle(Some(error));
                false
            }
        }
    }

    /// Brings the full map up to date and shows it.
    fn update(&mut self) -> Changes {
        let retired = self.draft.retire();
        let (Some(constraints), Some(map)) = (self.constraints(), &mut self.map) else {
            return Changes { meshes: retired, ..Changes::default() };
        };
        let meshes = retired || map.direction() != self.session.direction;
        let start = Instant::now();
        let result = map.update(&constraints, self.session.map_settings());
        self.note_duration(start);
        let images = result.is_ok();
        if !images {
            (self.session.interior, self.session.anchor) = self.last_good_points;
        }
        self.settle(result.err());
        Changes { meshes, map: images, images }
    }

    /// Goes on with an extension that is not complete; whether images changed.
    fn refine(&mut self) -> bool {
        let Some(map) = &mut self.map else { return false };
        let incomplete = map.extension_progress() < 1.0;
        if incomplete {
            map.refine(REFINE_MS);
        }
        incomplete
    }

    fn settle(&mut self, error: Option<MapError>) {
        if error.is_none() {
            self.last_good_points = (self.session.interior, self.session.anchor);
        }
        self.map_error = error.map(|error| (side_of(&error), error.to_string()));
    }
}

fn situation<'a>(map: &'a ConformalMap, session: &Session, generation: u64) -> Situation<'a> {
    let constraints = session.constraints(Side::BOTH.map(|side| map.domain(side).pole));
    let points = Side::BOTH.map(|side| constraints.point(side));
    Situation { map, generation, points, anchors: session.anchor }
}

fn side_of(error: &MapError) -> Side {
    match error {
        MapError::PointOutside { side, .. }
        | MapError::AnchorNotFinite { side }
        | MapError::NotConverged { side, .. } => *side,
    }
}

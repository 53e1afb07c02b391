//! A frame of the model: the map is brought up to date (file `update`), refined, measured, and taught with.

use super::{Changes, Model, Refines};
use crate::app::teaching::walks::WalkAction;
use crate::app::teaching::{Situation, Teaching};
use crate::app::textured;
use crate::conformal::{ConformalMap, Quality, Side, advance_distortions, advance_surface_distortions};
use crate::laplace::Deadline;
use crate::session::{Colouring, Session};
use web_time::Instant;

/// The quality is computed with every update when it takes less than this, else when the drag rests.
const CHEAP_QUALITY_MS: f64 = 1.0;

/// Another mesh with more triangles is measured when the map rests: these take 10 ms.
const MEASURED_AT_ONCE: usize = 200_000;

/// What a frame spends on an extension that is not complete: half of a frame at 60 Hz. The app
/// asks for another frame whenever images changed, and so goes on until it is.
const REFINE_MS: f64 = 8.0;

impl Model {
    /// Brings the map up to date with session and domains, or goes on with that; `dragging`: a dot moves.
    pub fn refresh(&mut self, dragging: bool) -> Changes {
        if self.session.surface.is_some() {
            return self.refresh_surface();
        }
        let mut changes = Changes::default();
        if std::mem::take(&mut self.domains_changed) {
            changes.meshes = self.take_domains();
            self.points_changed = true;
        }
        if std::mem::take(&mut self.points_changed) {
            self.revision += 1;
            self.pending = Some(0);
        } else if self.pending.is_none() && self.lacks_grid() {
            self.pending = Some(0);
        }
        if self.pending.is_some() {
            changes |= self.go_on(dragging);
        }
        let refined = self.refines == Refines::InRefresh && self.refine();
        changes.images = changes.map || refined;
        self.map_generation += u64::from(changes.map || changes.meshes);
        if changes.meshes || changes.images {
            self.mesh_generation += u64::from(changes.meshes);
            self.count_images(changes.meshes);
        }
        changes.meshes |= self.follow_pattern();
        changes
    }

    /// The pattern in the picture lives where it is wanted, once there are coordinates; whether that is elsewhere.
    fn follow_pattern(&mut self) -> bool {
        let home = textured::home(&self.session);
        if home.is_none() {
            self.draft.make_grid();
        }
        let is_there = home.is_some() || self.is_draft() || !self.lacks_grid();
        is_there && std::mem::replace(&mut self.pattern_home, home) != home
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
        self.map().map_or(1.0, ConformalMap::extension_progress)
    }

    /// Notes that images moved.
    pub(super) fn count_images(&mut self, another_mesh: bool) {
        self.generation += 1;
        self.quality_stale = true;
        // what the picture does not show is not worth a number
        let shown = self.refines == Refines::InRefresh || self.extension_progress() == 1.0;
        // Another mesh has other triangles: the old ones' distortions fit nothing any more.
        if another_mesh && self.is_large() {
            self.triangles.clear();
            self.quality = None;
        } else if another_mesh || (shown && self.quality_ms < CHEAP_QUALITY_MS) {
            self.measure();
        }
    }

    /// Whether a frame is too short to measure the map, and the picture does not need it.
    fn is_large(&self) -> bool {
        let count = self.shown().map_or(0, |map| map.triangles.len());
        count > MEASURED_AT_ONCE && self.session.colouring == Colouring::Texture
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
        let map = self.map.as_ref().filter(|_| self.pending.is_none())?;
        let situation = situation(map, &self.session, self.map_generation);
        self.teaching.advance(&situation, self.session.comparison, now)
    }

    /// Whether [`Self::measure`] would tell something new.
    pub fn is_quality_stale(&self) -> bool {
        self.quality_stale
    }

    /// Measures the map's distortion.
    pub fn measure(&mut self) {
        self.measuring.clear();
        self.advance_measure(Deadline::NEVER);
    }

    /// Spends a frame's share on measuring the map's distortion, until it is not stale any more.
    pub fn measure_at_rest(&mut self) {
        if self.measuring_generation != self.generation {
            self.measuring.clear();
        }
        self.advance_measure(Deadline::in_ms(self.update_ms));
    }

    fn advance_measure(&mut self, deadline: Deadline) {
        let start = Instant::now();
        let spent = if self.measuring.is_empty() { 0.0 } else { self.quality_ms };
        self.measuring_generation = self.generation;
        let surface = self.surface.map().filter(|_| self.session.surface.is_some());
        let planar = self.draft.map().or(self.map.as_ref());
        let measuring = &mut self.measuring;
        let is_done = match (surface, planar) {
            (Some(map), _) => {
                advance_surface_distortions(&map.surface().surface.mesh, map.images(), measuring, deadline)
            }
            (None, Some(map)) => advance_distortions(map.mapped_mesh(), map.images(), measuring, deadline),
            (None, None) => true,
        };
        if is_done {
            std::mem::swap(&mut self.triangles, &mut self.measuring);
            self.measuring.clear();
            self.quality = match self.surface_map() {
                Some(map) => Some(Quality::summary(map.given(&self.triangles))),
                None => self.map().map(|_| Quality::summary(&self.triangles)),
            };
            self.measured = self.generation;
            self.quality_stale = false;
        }
        self.quality_ms = spent + start.elapsed().as_secs_f64() * 1e3;
    }

    /// Goes on with the extension in the picture if it is not complete; whether images changed.
    fn refine(&mut self) -> bool {
        let full = self.map.as_mut().filter(|_| self.pending.is_none());
        let Some(map) = self.draft.map_mut().or(full) else { return false };
        let incomplete = map.extension_progress() < 1.0;
        if incomplete {
            map.refine(REFINE_MS);
        }
        incomplete
    }
}

fn situation<'a>(map: &'a ConformalMap, session: &Session, generation: u64) -> Situation<'a> {
    let constraints = session.constraints(Side::BOTH.map(|side| map.domain(side).pole));
    let points = Side::BOTH.map(|side| constraints.point(side));
    Situation { map, generation, points, anchors: session.anchor }
}

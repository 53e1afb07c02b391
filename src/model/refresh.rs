//! A frame of the model: the map is updated (file `update`), refined and measured, and the overlays follow.

use crate::conformal::{ConformalMap, Extension, PerSide, Side};
use crate::laplace::Deadline;
use crate::model::overlays::walks::WalkAction;
use crate::model::overlays::{OverlayState, Situation};
use crate::model::pinned::Following;
use crate::model::{Changes, Model, Refines, pattern};
use crate::session::{Colouring, Session};

/// If the quality takes less than this, it is computed with every update, else when a drag rests.
const CHEAP_QUALITY_MS: f64 = 1.0;

/// A new mesh with more triangles is measured when the map rests; this number takes 10 ms.
const MEASURED_AT_ONCE: usize = 200_000;

/// The time per frame for an incomplete extension: half of a frame at 60 Hz. The app
/// requests another frame whenever images have changed, and so continues to the end.
const REFINE_MS: f64 = 8.0;

impl Model {
    /// Updates the map to session and domains, or continues an update; `dragging`: a dot is being moved.
    pub fn refresh(&mut self, dragging: bool) -> Changes {
        let mut changes = Changes::default();
        self.changed.points |= self.take_pins();
        if self.changed.sides || self.changed.points {
            changes |= self.retire_fine();
        }
        if std::mem::take(&mut self.changed.sides) {
            changes.meshes |= self.take_sides();
            self.changed.points = true;
        }
        if self.request_map() && self.under_way.is_pending() {
            changes |= self.go_on(dragging);
        }
        if !self.is_pending() && !dragging {
            changes |= self.advance_fine();
        }
        // exact images are those of the map at rest
        let is_moving = dragging || !self.is_sharp() || self.is_refining();
        let waits = self.session.extension() == Extension::Exact && is_moving;
        let refined = self.refines == Refines::InRefresh && !waits && self.refine();
        changes.images |= changes.map || refined;
        self.shown.map_generation += u64::from(changes.map || changes.meshes);
        if changes.meshes || changes.images {
            self.shown.mesh_generation += u64::from(changes.meshes);
            self.count_images(changes.meshes);
        }
        changes.meshes |= self.follow_pattern();
        if !self.is_pending() {
            self.estimate(dragging);
        }
        self.see_pins();
        changes
    }

    /// Requests the map of the points, once they follow from the pins; returns whether a map that is under way goes on: one
    /// of other sides does not while its points are searched for.
    fn request_map(&mut self) -> bool {
        if !self.changed.points {
            if !self.is_pending() && self.lacks_grid() {
                self.under_way.want();
            }
            return true;
        }
        let following = self.follow_pins();
        self.changed.points = following != Following::Done;
        if following == Following::Searching {
            return self.under_way.next.is_none();
        }
        self.under_way.revision += 1;
        self.under_way.want();
        true
    }

    /// Moves the pattern in the picture to its requested home, once the coordinates exist; returns whether it changed.
    fn follow_pattern(&mut self) -> bool {
        let home = pattern::home(&self.session);
        if home.is_none() {
            self.coarse.make_grid();
            self.fine.make_grid();
        }
        let has_grid = home.is_some() || self.is_draft() || !self.lacks_grid();
        let is_there = self.map().is_some() && self.shows_present_surfaces() && has_grid;
        is_there && std::mem::replace(&mut self.shown.pattern_home, home) != home
    }

    /// Sets when to refine an extension: at rest, if the picture evaluates it by other means.
    pub fn set_refines(&mut self, refines: Refines) {
        self.refines = refines;
    }

    /// Refines an extension that [`Self::refresh`] does not.
    pub fn refine_at_rest(&mut self) -> Changes {
        let images = self.refines == Refines::AtRest && self.refine();
        if images {
            self.count_images(false);
        }
        Changes { images, ..Changes::default() }
    }

    /// The fraction of the images that belong to the requested extension, from 0 to 1.
    pub fn extension_progress(&self) -> f64 {
        self.map().map_or(1.0, ConformalMap::extension_progress)
    }

    /// Counts a change of the images, and measures the distortion if that is cheap.
    pub(super) fn count_images(&mut self, another_mesh: bool) {
        self.shown.generation += 1;
        self.measurement.expire();
        // images that the picture does not show are not measured
        let shown = self.refines == Refines::InRefresh || self.extension_progress() == 1.0;
        // The distortions of the previous mesh's triangles do not belong to this one.
        if another_mesh && self.is_large() {
            self.measurement.clear();
        } else if another_mesh || (shown && self.measurement.milliseconds() < CHEAP_QUALITY_MS) {
            self.measure();
        }
    }

    /// Whether measuring the map takes longer than a frame, and the picture does not need it.
    fn is_large(&self) -> bool {
        let count = self.shown().map_or(0, |map| map.triangles.len());
        count > MEASURED_AT_ONCE && self.session.colouring() == Colouring::Texture
    }

    /// The state of the overlays.
    pub fn overlay_state(&self) -> &OverlayState {
        &self.overlay_state
    }

    /// Applies an action to the random walks.
    pub fn act_on_walks(&mut self, action: WalkAction) {
        self.overlay_state.walks.act(action);
    }

    /// Updates the overlays to the time `now` (seconds); returns in how many seconds to call again, if at all.
    pub fn advance_overlays(&mut self, now: f64) -> Option<f64> {
        // The coarse map has other boundaries, so the overlays wait for the full one.
        let map = self.shown.map.as_ref().filter(|_| !self.is_pending())?;
        let situation = situation(map, &self.session, self.shown.map_generation)?;
        self.overlay_state.advance(&situation, self.session.comparison(), now)
    }

    /// Whether [`Self::measure`] would give a new result.
    pub fn is_quality_stale(&self) -> bool {
        self.measurement.is_stale()
    }

    /// Measures the map's distortion.
    pub fn measure(&mut self) {
        self.measurement.restart();
        self.advance_measure(Deadline::NEVER);
    }

    /// Spends one frame's time on measuring the map's distortion; to be called until it is not stale.
    pub fn measure_at_rest(&mut self) {
        self.advance_measure(Deadline::in_ms(self.update_ms));
    }

    fn advance_measure(&mut self, deadline: Deadline) {
        let map = self.coarse.map().or(self.fine.map()).or(self.shown.map.as_ref());
        self.measurement.advance(map, self.shown.generation, deadline);
    }

    /// Refines the extension in the picture if it is incomplete; returns whether images changed.
    fn refine(&mut self) -> bool {
        let is_pending = self.is_pending();
        let full = self.shown.map.as_mut().filter(|_| !is_pending);
        let Some(map) = self.coarse.map_mut().or(self.fine.map_mut()).or(full) else { return false };
        let incomplete = map.extension_progress() < 1.0;
        if incomplete {
            map.refine(REFINE_MS);
        }
        incomplete
    }
}

fn situation<'a>(map: &'a ConformalMap, session: &Session, generation: u64) -> Option<Situation<'a>> {
    let domains = PerSide::new(map.domain(Side::Source)?, map.domain(Side::Target)?);
    let points = PerSide::from_fn(|side| session.side(side).interior.unwrap_or(domains[side].default_point()));
    Some(Situation { map, domains, generation, points, anchors: PerSide::from_fn(|side| session.side(side).anchor()) })
}

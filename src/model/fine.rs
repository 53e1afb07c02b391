//! The map on a mesh refined for it, which replaces the full one while nothing moves: in pictures and files of sessions
//! without a window.
//!
//! Invariant: the refined map belongs to the full map that is shown; it is dropped as soon as a point, a setting or a
//! side changes.

use crate::conformal::ConformalMap;
use crate::laplace::Deadline;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::model::{Changes, Model};

/// The refined map.
#[derive(Debug, Default)]
pub struct Fine {
    map: Option<ConformalMap>,
    /// The number of refined maps so far.
    generation: u64,
    grid: DiskGrid,
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

    /// Computes the disk coordinates of the refined map, if there is one.
    pub fn make_grid(&mut self) {
        if let Some(map) = &self.map {
            self.grid.advance(map, self.generation, Deadline::NEVER);
        }
    }

    fn set(&mut self, map: ConformalMap) {
        self.map = Some(map);
        self.generation += 1;
    }

    /// Drops the map, because the full one changes; returns what that changes.
    pub fn retire(&mut self) -> Changes {
        let is_dropped = self.map.take().is_some();
        Changes { meshes: is_dropped, map: is_dropped, images: is_dropped }
    }
}

impl Model {
    /// Refines the map that is shown, if that is the full one between outlines and the mapped side's settings are
    /// [refined](crate::conformal::PrepareSettings::is_refined); waits for it. A mesh that cannot be refined stays.
    pub(super) fn refine_mesh(&mut self) {
        if self.fine.map().is_some() || self.is_draft() || !self.is_ready() || !self.abilities().compares_outlines() {
            return;
        }
        let Some(map) = &self.shown.map else { return };
        let settings = self.session.domain(map.mapped_side()).settings;
        if !settings.is_refined() {
            return;
        }
        let Ok(Some(mut fine)) = map.refined(&settings, &mut |_| ()) else { return };
        fine.refine(f64::INFINITY);
        self.fine.set(fine);
        self.fine.make_grid();
        self.shown.map_generation += 1;
        self.shown.mesh_generation += 1;
        self.count_images(true);
    }
}

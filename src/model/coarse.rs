//! A coarse substitute for a map that is too slow to follow a drag.
//!
//! The coarse domains are prepared synchronously, from the same outlines, when they are first needed (about 10 ms):
//! in such a drag, or for outlines whose full map is not complete. The coarse map has a disk grid of
//! its own. The full map replaces it when it is complete.

use crate::conformal::{
    ConformalMap, Constraints, InteriorPoint, MapSettings, PrepareSettings, PreparedSide, Side, prepare,
};
use crate::laplace::Deadline;
use crate::mesh::Sizing;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::outline::Sampling;
use crate::session::OutlineSpec;
use std::sync::Arc;

/// Coarse enough for 2 ms a frame and 10 ms of preparation in a browser, fine enough to recognize the map.
const SETTINGS: PrepareSettings = PrepareSettings {
    sampling: Sampling::Adaptive { target: Some(250) },
    sizing: Sizing::Graded(0.25),
    kernel: crate::conformal::KernelMode::Adjoint,
    solver: crate::laplace::SolverKind::Direct,
};

/// The minimum distance of an interior point from the coarse boundary, in sizes of the domain.
const INSET: f64 = 0.004;

/// The coarse domains, kept while the outlines do not change, and the coarse map while it is shown.
#[derive(Debug, Default)]
pub struct Draft {
    domains: [Option<Arc<PreparedSide>>; 2],
    /// Whether a preparation of the domains was attempted.
    is_tried: bool,
    map: Option<ConformalMap>,
    /// The number of updates of the map.
    generation: u64,
    /// The revision that the map was last updated to, or could not be.
    revision: u64,
    grid: DiskGrid,
}

impl Draft {
    /// The coarse map, while it replaces the full one.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.map.as_ref()
    }

    /// The coarse map, while it replaces the full one.
    pub fn map_mut(&mut self) -> Option<&mut ConformalMap> {
        self.map.as_mut()
    }

    /// The disk coordinates of the coarse map, if [`Self::make_grid`] has computed them.
    pub fn grid(&self) -> &DiskGrid {
        &self.grid
    }

    /// Computes the disk coordinates of the coarse map, if there is one (about 2 ms).
    pub fn make_grid(&mut self) {
        if let Some(map) = &self.map {
            self.grid.advance(map, self.generation, Deadline::NEVER);
        }
    }

    /// Drops the domains and the map, because the outlines have changed.
    pub fn forget(&mut self) {
        *self = Self { generation: self.generation, revision: self.revision, ..Self::default() };
    }

    /// Drops the coarse map, because the full one is shown again; returns whether there was one.
    pub fn retire(&mut self) -> bool {
        self.map.take().is_some()
    }

    /// Whether the coarse map is shown and was updated to this revision, which is recorded as handled.
    pub fn has_followed(&mut self, revision: u64) -> bool {
        std::mem::replace(&mut self.revision, revision) == revision && self.map.is_some()
    }

    /// Updates the coarse map to `constraints`; false if that is not possible.
    pub fn follow(&mut self, outlines: [&OutlineSpec; 2], constraints: &Constraints, settings: MapSettings) -> bool {
        if !std::mem::replace(&mut self.is_tried, true) {
            self.domains = outlines.map(coarse);
        }
        self.generation += 1;
        let [Some(source), Some(target)] = &self.domains else { return false };
        let mut constraints = *constraints;
        for (side, domain) in Side::BOTH.into_iter().zip([source, target]) {
            constraints.points[side] = inside(domain, constraints.points[side]);
        }
        match &mut self.map {
            Some(map) => map.update(&constraints, settings).is_ok(),
            none => {
                *none = ConformalMap::new(Arc::clone(source), Arc::clone(target), &constraints, settings).ok();
                none.is_some()
            }
        }
    }
}

fn coarse(outline: &OutlineSpec) -> Option<Arc<PreparedSide>> {
    prepare(&outline.polygon(), &SETTINGS, &mut |_| ()).ok().map(Arc::new)
}

fn inside(side: &PreparedSide, point: InteriorPoint) -> InteriorPoint {
    let (Some(domain), InteriorPoint::Plane(x)) = (side.domain(), point) else { return point };
    let (low, high) = crate::model::bounds(domain.samples().points());
    domain.nearest_inside(x, INSET * (high - low).max_element()).into()
}

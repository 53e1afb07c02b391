//! A coarse stand-in for a map that is too slow to follow a drag.
//!
//! Prepared on the spot, from the same outlines, when it is first needed (about 10 ms):
//! in such a drag, or for outlines whose full map is not there yet. It has a disk grid of
//! its own. The full map takes its place when it is complete.

use crate::conformal::{
    ConformalMap, Constraints, InteriorPoint, MapSettings, PrepareSettings, PreparedSide, Side, prepare,
};
use crate::laplace::Deadline;
use crate::mesh::Sizing;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::outline::Sampling;
use crate::session::OutlineSpec;
use std::sync::Arc;

/// Few enough for 2 ms a frame and 10 ms of preparation in a browser, enough to know the map by.
const SETTINGS: PrepareSettings = PrepareSettings {
    sampling: Sampling::Adaptive { target: Some(250) },
    sizing: Sizing::Graded(0.25),
    kernel: crate::conformal::KernelMode::Adjoint,
    solver: crate::laplace::SolverKind::Direct,
};

/// The distance that an interior point keeps from the coarse boundary, in sizes of the domain.
const INSET: f64 = 0.004;

/// The coarse domains, as long as the outlines stay, and the map while it is shown.
#[derive(Debug, Default)]
pub struct Draft {
    domains: [Option<Arc<PreparedSide>>; 2],
    /// Whether the domains were prepared, or found not to be.
    is_tried: bool,
    map: Option<ConformalMap>,
    /// Counts what the map has followed.
    generation: u64,
    /// The revision of the map that it has followed, or could not.
    revision: u64,
    grid: DiskGrid,
}

impl Draft {
    /// The coarse map, while it stands in.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.map.as_ref()
    }

    /// The coarse map, while it stands in.
    pub fn map_mut(&mut self) -> Option<&mut ConformalMap> {
        self.map.as_mut()
    }

    /// The disk coordinates of the coarse map, once [`Self::make_grid`] has made them.
    pub fn grid(&self) -> &DiskGrid {
        &self.grid
    }

    /// Makes the disk coordinates of the coarse map, if it stands in (about 2 ms).
    pub fn make_grid(&mut self) {
        if let Some(map) = &self.map {
            self.grid.advance(map, self.generation, Deadline::NEVER);
        }
    }

    /// Other outlines: nothing of this fits any more.
    pub fn forget(&mut self) {
        *self = Self { generation: self.generation, revision: self.revision, ..Self::default() };
    }

    /// The full map is shown again; whether the coarse one was.
    pub fn retire(&mut self) -> bool {
        self.map.take().is_some()
    }

    /// Whether the coarse map stands in and has followed this revision; from now on it has, or could not.
    pub fn has_followed(&mut self, revision: u64) -> bool {
        std::mem::replace(&mut self.revision, revision) == revision && self.map.is_some()
    }

    /// Brings the coarse map to `constraints`; false where it cannot stand in.
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
    let (low, high) = crate::model::bounds(&domain.samples().points);
    domain.nearest_inside(x, INSET * (high - low).max_element()).into()
}

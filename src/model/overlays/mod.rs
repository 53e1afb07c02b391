//! The overlays: the way through the disk beside the map, random walks beside the measure, the grid of the disk.
//!
//! Work is dosed: whatever is asked here takes a fraction of a frame, and
//! the answer says when to ask again.

pub mod disk_comparison;
pub mod overlay;
pub mod walks;

use crate::conformal::{ConformalMap, MeshedDomain, Side};
use crate::geometry::DVec2;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::session::Comparison;
use disk_comparison::DiskComparison;
use overlay::Overlays;
use std::sync::Arc;
use walks::Walks;

/// The map on the screen and what it is made from.
#[derive(Debug, Clone, Copy)]
pub struct Situation<'a> {
    /// The map.
    pub map: &'a ConformalMap,
    /// Its domains.
    pub domains: [&'a Arc<MeshedDomain>; 2],
    /// Counts the map's changes.
    pub generation: u64,
    /// x₁, x₂.
    pub points: [DVec2; 2],
    /// y₁, y₂, as fractions of arc length.
    pub anchors: [f64; 2],
}

impl Situation<'_> {
    /// The side whose boundary vertices are mapped.
    pub fn mapped(&self) -> Side {
        self.map.mapped_side()
    }
}

/// The state of all of it.
#[derive(Debug, Default)]
pub struct OverlayState {
    /// The way through the disk.
    pub disk_comparison: DiskComparison,
    /// The walks from x₁.
    pub walks: Walks,
    /// The coordinates of the conformal pattern.
    pub grid: DiskGrid,
    overlays: Overlays,
}

impl OverlayState {
    /// Brings everything up to date at the time `now` (seconds); in how many seconds to come back, if at all.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let compared = self.disk_comparison.advance(situation, comparison, now);
        let walked = self.walks.advance(situation, now);
        // The panel and the plots were laid out before.
        let renewed = self.overlays.update(&self.disk_comparison, &self.walks).then_some(0.0);
        [compared, walked, renewed].into_iter().flatten().reduce(f64::min)
    }

    /// What the plots draw over the map's own curves.
    pub fn overlays(&self) -> &Overlays {
        &self.overlays
    }
}

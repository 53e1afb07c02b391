//! What teaches: the way through the disk beside the map, random walks beside the measure, the grid of the disk.
//!
//! Like the model it knows no egui and no GPU; `panel` and `paint` put it on the
//! screen. Work is dosed: whatever is asked here takes a fraction of a frame, and
//! the answer says when to ask again.

pub mod disk_grid;
pub mod overlay;
pub mod paint;
pub mod panel;
pub mod through_disk;
pub mod walks;

use crate::conformal::{ConformalMap, Side};
use crate::geometry::DVec2;
use crate::session::Comparison;
use disk_grid::DiskGrid;
use overlay::Overlays;
use through_disk::ThroughDisk;
use walks::Walks;

/// The map on the screen and what it is made from.
#[derive(Debug, Clone, Copy)]
pub struct Situation<'a> {
    /// The map.
    pub map: &'a ConformalMap,
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
        self.map.direction().mapped_side()
    }
}

/// The state of all of it.
#[derive(Debug, Default)]
pub struct Teaching {
    /// The way through the disk.
    pub through_disk: ThroughDisk,
    /// The walks from x₁.
    pub walks: Walks,
    /// The coordinates of the conformal pattern.
    pub grid: DiskGrid,
    overlays: Overlays,
}

impl Teaching {
    /// Brings everything up to date at the time `now` (seconds); in how many seconds to come back, if at all.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let compared = self.through_disk.advance(situation, comparison, now);
        let walked = self.walks.advance(situation, now);
        // The panel and the plots were laid out before.
        let renewed = self.overlays.update(&self.through_disk, &self.walks).then_some(0.0);
        [compared, walked, renewed].into_iter().flatten().reduce(f64::min)
    }

    /// What the plots draw over the map's own curves.
    pub fn overlays(&self) -> &Overlays {
        &self.overlays
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

//! Overlays: the map through the disk, random walks for the harmonic measure, and the disk's grid.
//!
//! Each call does work for a fraction of a frame and returns when to call again.

pub mod disk_comparison;
pub mod invariants;
pub mod orthogonal_grid;
pub mod overlay;
mod symmetry;
pub mod walks;

use crate::conformal::{ConformalMap, MeshedDomain, PerSide, Side};
use crate::geometry::DVec2;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::session::Comparison;
use disk_comparison::DiskComparison;
use invariants::InvariantsState;
use orthogonal_grid::GridState;
use overlay::Overlays;
use std::sync::Arc;
use symmetry::SymmetryState;
use walks::Walks;

/// The map on the screen and its inputs.
#[derive(Debug, Clone, Copy)]
pub struct Situation<'a> {
    /// The map.
    pub map: &'a ConformalMap,
    /// Its domains.
    pub domains: PerSide<&'a Arc<MeshedDomain>>,
    /// The generation of the map, increased with every change.
    pub generation: u64,
    /// x₁, x₂.
    pub points: PerSide<DVec2>,
    /// y₁, y₂, as fractions of arc length.
    pub anchors: PerSide<f64>,
}

impl Situation<'_> {
    /// The side whose boundary vertices are mapped.
    pub fn mapped(&self) -> Side {
        self.map.mapped_side()
    }
}

/// The state of all overlays.
#[derive(Debug, Default)]
pub struct OverlayState {
    /// The comparison with the map through the disk.
    pub disk_comparison: DiskComparison,
    /// The walks from x₁.
    pub walks: Walks,
    /// The conformal invariants of the sides.
    pub invariants: InvariantsState,
    /// The symmetries of the sides.
    pub symmetries: SymmetryState,
    /// The orthogonal grids of the sides.
    pub orthogonal_grids: GridState,
    /// The coordinates of the conformal pattern.
    pub grid: DiskGrid,
    overlays: Overlays,
}

impl OverlayState {
    /// Updates all overlays at the time `now` in seconds; returns the seconds until the next call is needed, if any.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let compared = self.disk_comparison.advance(situation, comparison, now);
        let walked = self.walks.advance(situation, now);
        // this frame's panel and plots have already been laid out, so another one is needed
        let renewed = self.overlays.update(&self.disk_comparison, &self.walks).then_some(0.0);
        [compared, walked, renewed].into_iter().flatten().reduce(f64::min)
    }

    /// The curves drawn over the map's own.
    pub fn overlays(&self) -> &Overlays {
        &self.overlays
    }
}

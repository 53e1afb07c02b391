//! The symmetries of an outline as a plain record, for `window.riemap.stats()` and for tests.

use crate::geometry::{Rotations, Symmetries};
use serde::Serialize;

/// The symmetries of an outline that are shown.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SymmetryStats {
    /// How many turns carry the outline onto itself; 0 for a circle, 1 where only that by 0 does.
    pub turns: u32,
    /// The angles of the axes, in degrees.
    pub axes: Vec<f64>,
    /// The largest deviation of all, in sizes of the outline.
    pub deviation: f64,
    /// The center, in the outline's coordinates.
    pub center: [f64; 2],
}

impl SymmetryStats {
    /// The record of these symmetries.
    pub fn of(Symmetries { center, rotations, axes, .. }: &Symmetries) -> Self {
        let (turns, deviation) = match *rotations {
            Rotations::Identity => (1, 0.0),
            Rotations::Order { order, deviation } => (order, deviation),
            Rotations::Circle { deviation } => (0, deviation),
        };
        Self {
            turns,
            axes: axes.iter().map(|axis| axis.direction.to_angle().to_degrees()).collect(),
            deviation: axes.iter().map(|axis| axis.deviation).fold(deviation, f64::max),
            center: center.to_array(),
        }
    }
}

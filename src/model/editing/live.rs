//! How an outline is prepared while it is being reshaped: coarsely, and so in every frame.

use crate::conformal::{KernelMode, PrepareSettings};
use crate::geometry::DVec2;
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::outline::Sampling;

/// Few enough for 7 ms of preparation on a desktop and 12 in a browser, enough to look like the map that comes.
const SAMPLES: u32 = 400;
/// As coarse as the eye allows: at 0.1 there are twice as many triangles.
const GROWTH: f64 = 0.2;

/// How a hand has reshaped an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reshaped {
    /// The side's interior point; where it is not inside any more, the nearest place there serves.
    pub interior: Option<DVec2>,
    /// Its boundary point, a fraction of the new outline's length.
    pub anchor: f64,
    /// Whether the hand still has it.
    pub in_hand: bool,
}

impl Reshaped {
    /// How to prepare an outline that is meant to be prepared as `wanted`.
    pub fn settings(reshaped: Option<Self>, wanted: PrepareSettings) -> PrepareSettings {
        if reshaped.is_none_or(|reshaped| !reshaped.in_hand) {
            return wanted;
        }
        let asked = match wanted.sampling {
            Sampling::Uniform { count, .. } => count,
            Sampling::Adaptive { target } => target.unwrap_or(SAMPLES),
        };
        PrepareSettings {
            sampling: Sampling::Adaptive { target: Some(asked.min(SAMPLES)) },
            sizing: Sizing::Graded(GROWTH),
            kernel: KernelMode::Adjoint,
            solver: SolverKind::Direct,
        }
    }
}

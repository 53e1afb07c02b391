//! The coarse settings with which an outline is prepared in every frame while it is reshaped.

use crate::conformal::{KernelMode, PrepareSettings};
use crate::geometry::DVec2;
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::outline::Sampling;

/// Few enough for 7 ms of preparation on a desktop and 12 ms in a browser, enough to resemble the final map.
const SAMPLES: u32 = 400;
/// As coarse as looks acceptable: 0.1 gives twice as many triangles.
const GROWTH: f64 = 0.2;

/// The points of an outline that was reshaped, and whether it still is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reshaped {
    /// The side's interior point; if it is no longer inside, the nearest point inside is used.
    pub interior: Option<DVec2>,
    /// The side's boundary point, as a fraction of the new outline's length.
    pub anchor: f64,
    /// Whether the drag is still going on.
    pub in_hand: bool,
    /// Whether the outline was turned over, so that its points run the other way around.
    pub turned: bool,
}

impl Reshaped {
    /// The settings to use for an outline whose requested settings are `wanted`.
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

//! What an update of a map goes through, in this order; between two stages, and within each, it can be interrupted.

use super::{FrameTimings, Side};
use web_time::Instant;

/// A part of an update.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// Kernel and measure of a side, the source first.
    Kernel(Side),
    /// The images of all vertices, once the measures are matched.
    Extension,
}

impl Stage {
    /// The first one.
    pub const FIRST: Self = Self::Kernel(Side::Source);

    /// The one after it.
    pub fn next(self) -> Option<Self> {
        match self {
            Self::Kernel(Side::Source) => Some(Self::Kernel(Side::Target)),
            Self::Kernel(Side::Target) => Some(Self::Extension),
            Self::Extension => None,
        }
    }

    /// Adds the time since `start` to what this stage took.
    pub fn add_time(self, timings: &mut FrameTimings, start: Instant) {
        let spent = start.elapsed().as_secs_f64() * 1e3;
        match self {
            Self::Kernel(_) => timings.kernel += spent,
            Self::Extension => timings.extend += spent,
        }
    }
}

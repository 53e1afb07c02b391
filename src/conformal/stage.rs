//! The stages of a map update, in order. An update can be interrupted between two stages and within each.

use super::{FrameTimings, Side};
use web_time::Instant;

/// A stage of an update.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// Kernel and measure of a side; the source comes first.
    Kernel(Side),
    /// The images of all vertices in the other domain, after the measures are matched.
    Extension,
    /// Between two surfaces: the positions of a side's vertices in the disk.
    Disk(Side),
    /// Between two surfaces: the images of all vertices on the other one, after the measures are matched.
    Location,
}

impl Stage {
    /// The stage that an update starts with.
    pub const FIRST: Self = Self::Kernel(Side::Source);

    /// The stage after this one; `through_disk`: the map is between two surfaces. `None` after the last.
    pub fn next(self, through_disk: bool) -> Option<Self> {
        match self {
            Self::Kernel(Side::Source) => Some(Self::Kernel(Side::Target)),
            Self::Kernel(Side::Target) if through_disk => Some(Self::Disk(Side::Source)),
            Self::Kernel(Side::Target) => Some(Self::Extension),
            Self::Disk(Side::Source) => Some(Self::Disk(Side::Target)),
            Self::Disk(Side::Target) => Some(Self::Location),
            Self::Extension | Self::Location => None,
        }
    }

    /// Adds the time since `start` to the duration of this stage.
    pub fn add_time(self, timings: &mut FrameTimings, start: Instant) {
        let spent = start.elapsed().as_secs_f64() * 1e3;
        match self {
            Self::Kernel(_) => timings.kernel += spent,
            Self::Extension | Self::Disk(_) | Self::Location => timings.extend += spent,
        }
    }
}

//! What an update of a map goes through, in this order; between two stages, and within each, it can be interrupted.

use super::{FrameTimings, Side};
use crate::laplace::Deadline;
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

/// A map that is updated stage by stage.
pub(super) trait Staged {
    /// An update that is under way.
    type Run;
    /// Why there is no map.
    type Error;

    /// Where an update is, and what it has taken.
    fn progress(run: &mut Self::Run) -> (&mut Stage, &mut FrameTimings);

    /// Begins with the stage of `run`, and adds the time.
    fn begin_stage(&mut self, run: &mut Self::Run);

    /// Goes on with it until it is done (true) or `deadline` is over.
    fn advance_stage(&mut self, run: &Self::Run, deadline: Deadline) -> Result<bool, Self::Error>;

    /// Goes on with the update until its last stage is done (true) or `deadline` is over.
    fn go_on(&mut self, run: &mut Self::Run, deadline: Deadline) -> Result<bool, Self::Error> {
        loop {
            let start = Instant::now();
            let is_done = self.advance_stage(run, deadline)?;
            let (stage, timings) = Self::progress(run);
            stage.add_time(timings, start);
            if !is_done {
                return Ok(false);
            }
            let Some(next) = stage.next() else { return Ok(true) };
            *stage = next;
            self.begin_stage(run);
            if deadline.is_over() {
                return Ok(false);
            }
        }
    }
}

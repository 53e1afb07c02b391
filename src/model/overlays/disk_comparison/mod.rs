//! Compares the map with the map through the disk on the same boundaries (sections 1.2 and 5.2), by one or two methods.
//!
//! *Fresh* disk maps cost O(m²) each: while something moves they use few samples, and at rest
//! the domain's own samples up to the cap, one side per call. *Precomputed* ones are
//! computed once per domain, for its pole. At most one large disk map is computed per call. Errors
//! are reported and do not affect riemap's map.
//!
//! A curve through few samples may exclude a point that the domain contains; the number of samples is then
//! doubled, up to all of them, before an error is reported.

pub mod found;
mod fresh;
mod precomputed;

pub use found::Found;

use crate::language::Message;
use crate::model::overlays::Situation;
use crate::session::{Comparison, DiskWay};
use crate::zipper::ZipperError;
use fresh::Fresh;
use precomputed::Precomputed;

/// Samples of a fresh map while something moves: 2 to 3 ms per side, natively.
pub const MOVING_SAMPLES: usize = 300;
/// Samples of a fresh map at rest, and of a precomputed map: 15 to 20 ms per side.
pub const RESTING_SAMPLES: usize = 800;

/// The state of the comparisons.
#[derive(Debug, Default)]
pub struct DiskComparison {
    fresh: Fresh,
    precomputed: Precomputed,
}

impl DiskComparison {
    /// The result of one method; `None` while there is none.
    pub fn found(&self, way: DiskWay) -> Option<&Found> {
        self.shown(way).found.as_ref()?.as_ref().ok()
    }

    /// The error of one method.
    pub fn error(&self, way: DiskWay) -> Option<&Message> {
        self.shown(way).found.as_ref()?.as_ref().err()
    }

    /// The results, by method.
    pub fn all_found(&self) -> impl DoubleEndedIterator<Item = (DiskWay, &Found)> {
        DiskWay::ALL.into_iter().filter_map(|way| Some((way, self.found(way)?)))
    }

    /// Increases with every change of the results.
    pub fn version(&self) -> u64 {
        self.fresh.shown.version + self.precomputed.shown.version
    }

    fn shown(&self, way: DiskWay) -> &Shown {
        match way {
            DiskWay::Fresh => &self.fresh.shown,
            DiskWay::Precomputed => &self.precomputed.shown,
        }
    }

    /// Updates the comparisons; returns the seconds until the next call is needed, if any.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let precomputed = if comparison.shows(DiskWay::Precomputed) {
            self.precomputed.advance(situation)
        } else {
            self.precomputed.clear();
            None
        };
        let fresh = if comparison.shows(DiskWay::Fresh) {
            // if the other method has more to do, it has just computed a large map
            self.fresh.advance(situation, now, precomputed.is_none())
        } else {
            self.fresh.clear();
            None
        };
        [precomputed, fresh].into_iter().flatten().reduce(f64::min)
    }
}

/// The result of one method, as shown.
#[derive(Debug, Default)]
struct Shown {
    found: Option<Result<Found, Message>>,
    version: u64,
}

impl Shown {
    fn set(&mut self, found: Result<Found, Message>) {
        self.found = Some(found);
        self.version += 1;
    }

    fn clear(&mut self) {
        self.version += u64::from(self.found.is_some());
        self.found = None;
    }
}

/// Whether the curve through the samples excludes the interior point.
fn is_refused<T>(result: &Result<T, ZipperError>) -> bool {
    matches!(result, Err(ZipperError::PointOutside { .. }))
}

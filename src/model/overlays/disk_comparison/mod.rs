//! The map through the disk beside riemap's own, on the same boundaries (sections 1.2 and 5.2), in one way or in both.
//!
//! *Fresh* maps cost O(m²) each: while something moves they are made of few samples,
//! and when it rests, one side per call, of the domain's own samples as far as the cap
//! allows. *Precomputed* ones are made once per domain, for its pole. Never more than one
//! large disk map per call. What fails is said; riemap's map does not care.
//!
//! A curve through few samples may leave out a point that the domain has: it is drawn through
//! twice as many then, up to all, before anything is said.

pub mod found;
mod fresh;
mod precomputed;

pub use found::Found;

use crate::geometry::DVec2;
use crate::language::Message;
use crate::model::overlays::Situation;
use crate::outline::BoundarySamples;
use crate::session::{Comparison, DiskWay};
use crate::zipper::ZipperError;
use fresh::Fresh;
use precomputed::Precomputed;

/// Samples of a fresh map while something moves: 2 to 3 ms for each side, natively.
pub const MOVING_SAMPLES: usize = 300;
/// And at rest, and of a precomputed map: 15 to 20 ms for each side.
pub const RESTING_SAMPLES: usize = 800;

/// The comparisons' state.
#[derive(Debug, Default)]
pub struct DiskComparison {
    fresh: Fresh,
    precomputed: Precomputed,
}

impl DiskComparison {
    /// What was found by one way; `None` while there is nothing to show.
    pub fn found(&self, way: DiskWay) -> Option<&Found> {
        self.shown(way).found.as_ref()?.as_ref().ok()
    }

    /// Why nothing was found.
    pub fn error(&self, way: DiskWay) -> Option<&Message> {
        self.shown(way).found.as_ref()?.as_ref().err()
    }

    /// What was found, by way.
    pub fn all_found(&self) -> impl DoubleEndedIterator<Item = (DiskWay, &Found)> {
        DiskWay::ALL.into_iter().filter_map(|way| Some((way, self.found(way)?)))
    }

    /// Counts up with every change of what is shown.
    pub fn version(&self) -> u64 {
        self.fresh.shown.version + self.precomputed.shown.version
    }

    fn shown(&self, way: DiskWay) -> &Shown {
        match way {
            DiskWay::Fresh => &self.fresh.shown,
            DiskWay::Precomputed => &self.precomputed.shown,
        }
    }

    /// Brings the comparisons up to date; in how many seconds to come back, if at all.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let precomputed = if comparison.shows(DiskWay::Precomputed) {
            self.precomputed.advance(situation)
        } else {
            self.precomputed.clear();
            None
        };
        let fresh = if comparison.shows(DiskWay::Fresh) {
            // what has more to do has just made a large map
            self.fresh.advance(situation, now, precomputed.is_none())
        } else {
            self.fresh.clear();
            None
        };
        [precomputed, fresh].into_iter().flatten().reduce(f64::min)
    }
}

/// What is to be seen of one way.
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

/// Whether the curve through the samples leaves the point out.
fn is_refused<T>(result: &Result<T, ZipperError>) -> bool {
    matches!(result, Err(ZipperError::PointOutside { .. }))
}

/// At most `most` of the samples, evenly chosen: denser where they were.
pub fn thinned(samples: &BoundarySamples, most: usize) -> BoundarySamples {
    let m = samples.len();
    if m <= most {
        return samples.clone();
    }
    let kept: Vec<usize> = (0..most).map(|k| k * m / most).collect();
    let points: Vec<DVec2> = kept.iter().map(|&k| samples.points[k]).collect();
    let edge_lengths = (0..most).map(|k| points[k].distance(points[(k + 1) % most])).collect();
    BoundarySamples { points, edge_lengths, fractions: kept.iter().map(|&k| samples.fractions[k]).collect() }
}

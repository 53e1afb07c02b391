//! Disk maps for the current interior points: from few samples while something moves, from many at rest.
//!
//! If the curve through the samples excludes the interior point, the samples are doubled: up to the cap at once,
//! beyond it only at rest, one map per call. Until this is settled, the previous result stays.

use crate::conformal::{MeshedDomain, PerSide, Side};
use crate::geometry::DVec2;
use crate::model::overlays::Situation;
use crate::model::overlays::disk_comparison::found::{Measured, compare};
use crate::model::overlays::disk_comparison::{MOVING_SAMPLES, RESTING_SAMPLES, Shown, is_refused};
use crate::zipper::DiskMeasure;
use std::sync::Arc;

/// How long nothing must have moved before large maps are computed, in seconds.
const REST_SECONDS: f64 = 0.15;

/// A side's measure and its inputs.
#[derive(Debug)]
struct Known {
    domain: Arc<MeshedDomain>,
    point: DVec2,
    anchor: f64,
    measured: Measured,
}

impl Known {
    /// Whether more of the domain's samples could include the interior point.
    fn is_undecided(&self) -> bool {
        is_refused(&self.measured.measure) && self.measured.samples.len() < self.domain.samples().len()
    }
}

/// The state of this method.
#[derive(Debug, Default)]
pub(super) struct Fresh {
    /// The generation of the last map that was compared.
    seen: Option<u64>,
    changed_at: f64,
    known: PerSide<Option<Known>>,
    pub(super) shown: Shown,
}

impl Fresh {
    pub(super) fn clear(&mut self) {
        self.shown.clear();
        (self.seen, self.known) = (None, PerSide::default());
    }

    /// As [`crate::model::overlays::disk_comparison::DiskComparison::advance`]; large maps are computed only if
    /// `large`.
    pub(super) fn advance(&mut self, situation: &Situation, now: f64, large: bool) -> Option<f64> {
        if self.seen.replace(situation.generation) != Some(situation.generation) {
            self.changed_at = now;
            for side in Side::BOTH {
                self.measure_moving(situation, side);
            }
            self.compare(situation);
        }
        let (side, samples) = Side::BOTH.into_iter().find_map(|side| Some((side, self.lacks(situation, side)?)))?;
        let rest = self.changed_at + REST_SECONDS - now;
        if rest > 0.0 || !large {
            return Some(rest.max(0.0));
        }
        self.measure(situation, side, samples);
        self.compare(situation);
        Some(0.0)
    }

    /// The measure of the current points, if it is known.
    fn present(&self, situation: &Situation, side: Side) -> Option<&Known> {
        self.known[side].as_ref().filter(|known| {
            Arc::ptr_eq(&known.domain, situation.domains[side])
                && (known.point, known.anchor) == (situation.points[side], situation.anchors[side])
        })
    }

    /// The number of samples to use at rest, if the measure has fewer.
    fn lacks(&self, situation: &Situation, side: Side) -> Option<usize> {
        let (present, all) = (self.present(situation, side), situation.domains[side].samples().len());
        let there = present.map_or(0, |known| known.measured.samples.len());
        let wanted = if present.is_some_and(Known::is_undecided) { 2 * there } else { RESTING_SAMPLES };
        (there < wanted.min(all)).then_some(wanted)
    }

    fn measure_moving(&mut self, situation: &Situation, side: Side) {
        if self.present(situation, side).is_some() {
            return;
        }
        let mut samples = MOVING_SAMPLES;
        self.measure(situation, side, samples);
        while samples < RESTING_SAMPLES && self.present(situation, side).is_some_and(Known::is_undecided) {
            samples = (2 * samples).min(RESTING_SAMPLES);
            self.measure(situation, side, samples);
        }
    }

    fn measure(&mut self, situation: &Situation, side: Side, most: usize) {
        let domain = Arc::clone(situation.domains[side]);
        let (point, anchor) = (situation.points[side], situation.anchors[side]);
        let samples = domain.samples().thinned(most);
        let measure = DiskMeasure::fresh(samples.points(), point, samples.at_fraction(anchor));
        self.known[side] = Some(Known { domain, point, anchor, measured: Measured { samples, measure } });
    }

    fn compare(&mut self, situation: &Situation) {
        let Some(known) = self.known.as_ref().map(Option::as_ref).both() else { return };
        if known.iter().all(|(_, known)| !known.is_undecided()) {
            self.shown.set(compare(situation, known.map(|known| &known.measured)));
        }
    }
}

//! How finite-element measure is distributed in the edges next to a corner.
//!
//! Next to a corner of interior angle θ the measure of an edge is distributed like r^(π/θ), as that of a domain with
//! such a corner is, instead of quadratically: where the other domain's limb goes into a re-entrant corner, the harmonic
//! extension with a wrong exponent would fold.

use crate::conformal::HarmonicMeasure;
use crate::geometry::DVec2;
use crate::outline::BoundarySamples;

/// A vertex is a corner if it turns by more than 30°, as in adaptive sampling.
const CORNER: f64 = std::f64::consts::FRAC_PI_6;

/// The most intervals without measure next to a corner that get a share: a tip of 10° has four.
const LONGEST_RUN: usize = 12;

/// Exponents π/θ are at most this, that of an angle of 9°; at the smallest, θ = 2π, 1/2.
const SHARPEST: f64 = 20.0;

/// The measure of an interval near a corner: like r^p in the distance r from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Corner {
    /// π/θ.
    power: f64,
    /// The distance from the corner to the interval, over the interval's length.
    offset: f64,
    /// Whether the corner lies after the interval.
    pub is_after: bool,
}

impl Corner {
    /// The share of the measure in the part `along` next to the corner.
    pub fn share(self, along: f64) -> f64 {
        let from = self.offset.powf(self.power);
        ((self.offset + along).powf(self.power) - from) / ((self.offset + 1.0).powf(self.power) - from)
    }

    /// The inverse of [`Self::share`].
    pub fn along(self, share: f64) -> f64 {
        let from = self.offset.powf(self.power);
        let to = (self.offset + 1.0).powf(self.power);
        ((from + share * (to - from)).powf(self.power.recip()) - self.offset).clamp(0.0, 1.0)
    }
}

/// The laws of the intervals next to corners. A sharp corner may have neighbors without measure, since they see no
/// interior vertex: what the first interval with a measure has is then distributed from the corner on, in `steps` too.
pub(super) fn corners(
    samples: &BoundarySamples,
    measure: &HarmonicMeasure,
    lengths: &[f64],
    steps: &mut [f64],
) -> Vec<Option<Corner>> {
    let m = samples.len();
    let mut corners = vec![None; m + 1];
    let is_whole = |j: usize| measure.span(j) == (0.0, 1.0);
    // knots and intervals around the boundary; that of the anchor is divided in two unless it is a vertex
    let around: Vec<usize> = (0..=m).filter(|&j| lengths[j] > 0.0).collect();
    let count = around.len();
    for (i, &j) in around.iter().enumerate().filter(|&(_, &j)| is_whole(j)) {
        let power = exponent(samples.points(), measure.vertex_at(j));
        if power == 1.0 {
            continue;
        }
        for is_after in [false, true] {
            // the intervals from the corner on, in this direction
            let run = (0..count.min(LONGEST_RUN))
                .map(|k| around[if is_after { i + 2 * count - 1 - k } else { i + k } % count]);
            let run: Vec<usize> = run.take_while(|&j| is_whole(j)).collect();
            let Some(last) = run.iter().position(|&j| steps[j] > 0.0) else { continue };
            let reach: f64 = run[..=last].iter().map(|&j| lengths[j]).sum();
            let whole = steps[run[last]];
            let mut passed = 0.0;
            for &j in &run[..=last] {
                let parts = [passed, passed + lengths[j]].map(|r: f64| (r / reach).powf(power));
                corners[j] = Some(Corner { power, offset: passed / lengths[j], is_after });
                steps[j] = whole * (parts[1] - parts[0]);
                passed += lengths[j];
            }
        }
    }
    corners
}

/// π over the interior angle at vertex `k` of a counter-clockwise polygon; 1 if it is not a corner.
pub(super) fn exponent(points: &[DVec2], k: usize) -> f64 {
    let m = points.len();
    let (before, at, after) = (points[(k + m - 1) % m], points[k], points[(k + 1) % m]);
    let turn = (at - before).angle_to(after - at);
    if turn.abs() <= CORNER {
        return 1.0;
    }
    (std::f64::consts::PI / (std::f64::consts::PI - turn)).clamp(0.5, SHARPEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_right_angle_has_exponent_two_and_a_re_entrant_one_two_thirds() {
        let points = [(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from);
        let exponents: Vec<f64> = (0..6).map(|k| exponent(&points, k)).collect();
        assert!((exponents[0] - 2.0).abs() < 1e-12 && (exponents[3] - 2.0 / 3.0).abs() < 1e-12, "{exponents:?}");
    }
}

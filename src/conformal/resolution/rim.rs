//! A boundary with its harmonic measure, counted from the anchor in both directions.
//!
//! [`HarmonicMeasure`] runs from 0 to 1: before its end it cannot tell steps below 1e-16 apart. Here points of the
//! second half are given by the measure that remains, so that both sides of a limb in which the anchor lies are
//! resolved alike. In the edges next to a corner of interior angle θ the measure is distributed like r^(π/θ), as that
//! of a domain with such a corner is, instead of quadratically: where the other domain's limb goes into a re-entrant
//! corner, the harmonic extension with a wrong exponent would fold.

use crate::conformal::HarmonicMeasure;
use crate::conformal::matching::inverse_quadratic;
use crate::geometry::DVec2;
use crate::outline::{BoundaryPoint, BoundarySamples};

/// A vertex is a corner if it turns by more than 30°, as in adaptive sampling.
const CORNER: f64 = std::f64::consts::FRAC_PI_6;

/// The most intervals without measure next to a corner that get a share: a tip of 10° has four.
const LONGEST_RUN: usize = 12;

/// Exponents π/θ are at most this, that of an angle of 9°; at the smallest, θ = 2π, 1/2.
const SHARPEST: f64 = 20.0;

/// A harmonic measure from the anchor: of what lies before a point, or `late`, in the second half, of what remains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Omega {
    late: bool,
    value: f64,
}

/// The boundary of a domain with the measure of its point. Knots and intervals are those of [`HarmonicMeasure`].
pub(super) struct Rim<'a> {
    pub samples: &'a BoundarySamples,
    pub measure: &'a HarmonicMeasure,
    /// The measure before each knot.
    before: Vec<f64>,
    /// The measure after each knot.
    after: Vec<f64>,
    /// The arc length before each knot.
    lengths: Vec<f64>,
    /// For each interval the law of a corner at or near one of its ends, if there is one.
    corners: Vec<Option<Corner>>,
}

/// The measure of an interval near a corner: like r^p in the distance r from it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Corner {
    /// π/θ.
    power: f64,
    /// The distance from the corner to the interval, over the interval's length.
    offset: f64,
    /// Whether the corner lies after the interval.
    is_after: bool,
}

impl Corner {
    /// The share of the measure in the part `along` next to the corner.
    fn share(self, along: f64) -> f64 {
        let from = self.offset.powf(self.power);
        ((self.offset + along).powf(self.power) - from) / ((self.offset + 1.0).powf(self.power) - from)
    }

    /// The inverse of [`Self::share`].
    fn along(self, share: f64) -> f64 {
        let from = self.offset.powf(self.power);
        let to = (self.offset + 1.0).powf(self.power);
        ((from + share * (to - from)).powf(self.power.recip()) - self.offset).clamp(0.0, 1.0)
    }
}

impl<'a> Rim<'a> {
    /// The rim of a domain; `None` if the measure is not that of a kernel.
    pub fn new(samples: &'a BoundarySamples, measure: &'a HarmonicMeasure) -> Option<Self> {
        let m = samples.len();
        let density = measure.density();
        if density.len() != m + 2 {
            return None;
        }
        let length = |j: usize| {
            let (from, to) = measure.span(j);
            samples.edge_lengths()[measure.vertex_at(j)] * (to - from)
        };
        let mut steps: Vec<f64> = (0..=m).map(|j| 0.5 * length(j) * (density[j] + density[j + 1])).collect();
        let lengths: Vec<f64> = (0..=m).map(length).collect();
        let corners = corners(samples, measure, &lengths, &mut steps);
        let running = |sum: &mut f64, add: f64| {
            *sum += add;
            Some(*sum)
        };
        let sums = |add: &dyn Fn(usize) -> f64| -> Vec<f64> {
            std::iter::once(0.0).chain((0..=m).scan(0.0, |sum, j| running(sum, add(j)))).collect()
        };
        let mut before = sums(&|j| steps[j]);
        let mut after = sums(&|j| steps[m - j]);
        after.reverse();
        let total = before[m + 1];
        if !(total.is_finite() && total > 0.0) {
            return None;
        }
        before.iter_mut().chain(&mut after).for_each(|value| *value /= total);
        let lengths = sums(&|j| lengths[j]);
        Some(Self { samples, measure, before, after, lengths, corners })
    }

    /// The extent of the domain.
    pub fn extent(&self) -> f64 {
        let ends = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = self.samples.points().iter().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
        (high - low).max_element()
    }

    /// The length of the boundary.
    pub fn length(&self) -> f64 {
        self.lengths[self.samples.len() + 1]
    }

    /// The vertices from the anchor on, with their knots; a vertex at the anchor comes first.
    pub fn vertices(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let m = self.samples.len();
        let at_anchor = self.measure.anchor().fraction() == 0.0;
        let first = at_anchor.then(|| (self.measure.vertex_at(0), 0));
        let others = (1..=m).filter(move |&j| j < m || !at_anchor).map(|j| (self.measure.vertex_at(j), j));
        first.into_iter().chain(others)
    }

    /// The arc length from the anchor to a knot.
    pub fn length_at(&self, knot: usize) -> f64 {
        self.lengths[knot]
    }

    /// The arc length from the anchor to a vertex.
    pub fn length_to(&self, vertex: usize) -> f64 {
        let knot = self.measure.knot_of(vertex);
        // a vertex at the anchor is the first knot
        if knot == self.samples.len() && self.measure.anchor().fraction() == 0.0 { 0.0 } else { self.lengths[knot] }
    }

    /// The length between two arc lengths from the anchor without the intervals that have no measure.
    pub fn measured_length(&self, from: f64, to: f64) -> f64 {
        let (first, last) = (self.interval_at(from).0, self.interval_at(to).0);
        let flat =
            (first..=last).filter(|&j| self.before[j] == self.before[j + 1] && self.after[j] == self.after[j + 1]);
        let covered = |j: usize| (self.lengths[j + 1].min(to) - self.lengths[j].max(from)).max(0.0);
        to - from - flat.map(covered).sum::<f64>()
    }

    /// The measure at a knot.
    pub fn at_knot(&self, knot: usize) -> Omega {
        let late = self.before[knot] > 0.5;
        Omega { late, value: if late { self.after[knot] } else { self.before[knot] } }
    }

    /// The interval that contains the arc length `s` from the anchor, and the fraction of it there.
    pub fn interval_at(&self, s: f64) -> (usize, f64) {
        let last = self.samples.len();
        let j = self.lengths.partition_point(|&before| before <= s).saturating_sub(1).min(last);
        let step = self.lengths[j + 1] - self.lengths[j];
        (j, if step > 0.0 { ((s - self.lengths[j]) / step).clamp(0.0, 1.0) } else { 0.0 })
    }

    /// The measure at the arc length `s` from the anchor.
    pub fn at(&self, s: f64) -> Omega {
        let (j, along) = self.interval_at(s);
        let share = self.share(j, along);
        let before = self.before[j] + (self.before[j + 1] - self.before[j]) * share;
        let after = self.after[j + 1] + (self.after[j] - self.after[j + 1]) * (1.0 - share);
        let late = before > 0.5;
        Omega { late, value: if late { after } else { before } }
    }

    /// The interval with the measure `omega` from the anchor and the fraction of it there; where the measure is flat,
    /// the end nearer to the anchor.
    pub fn place(&self, omega: Omega) -> (usize, f64) {
        let last = self.samples.len();
        if omega.late {
            let j = self.after.partition_point(|&after| after > omega.value).saturating_sub(1).min(last);
            let (rest, step) = (omega.value - self.after[j + 1], self.after[j] - self.after[j + 1]);
            (j, 1.0 - self.along(j, rest, step, true))
        } else {
            let j = self.before.partition_point(|&before| before < omega.value).saturating_sub(1).min(last);
            let (rest, step) = (omega.value - self.before[j], self.before[j + 1] - self.before[j]);
            (j, self.along(j, rest, step, false))
        }
    }

    /// The arc length from the anchor at a fraction of an interval.
    pub fn length_of(&self, (j, along): (usize, f64)) -> f64 {
        self.lengths[j] + along * (self.lengths[j + 1] - self.lengths[j])
    }

    /// The boundary point at a fraction of an interval.
    pub fn point(&self, (j, along): (usize, f64)) -> BoundaryPoint {
        if along >= 1.0 && j < self.samples.len() {
            return self.measure.point(j + 1, 0.0);
        }
        self.measure.point(j, along)
    }

    /// The share of the measure of interval `j` in its first `along`.
    fn share(&self, j: usize, along: f64) -> f64 {
        let density = self.measure.density();
        match self.corners[j] {
            Some(corner) if corner.is_after => 1.0 - corner.share(1.0 - along),
            Some(corner) => corner.share(along),
            None => {
                let (p, q) = (density[j], density[j + 1]);
                if p + q > 0.0 { (along * (2.0 * p + (q - p) * along) / (p + q)).clamp(0.0, 1.0) } else { along }
            }
        }
    }

    /// The part of interval `j`, from its start or `from_end`, in which `rest` of its measure `step` lies.
    fn along(&self, j: usize, rest: f64, step: f64, from_end: bool) -> f64 {
        if rest <= 0.0 || step <= 0.0 {
            return 0.0;
        }
        let share = (rest / step).min(1.0);
        let density = self.measure.density();
        match self.corners[j] {
            Some(corner) if corner.is_after == from_end => corner.along(share),
            Some(corner) => 1.0 - corner.along(1.0 - share),
            None if from_end => inverse_quadratic(rest, step, density[j + 1], density[j]),
            None => inverse_quadratic(rest, step, density[j], density[j + 1]),
        }
    }
}

/// The laws of the intervals next to corners. A sharp corner may have neighbors without measure, since they see no
/// interior vertex: what the first interval with a measure has is then distributed from the corner on, in `steps` too.
fn corners(
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
fn exponent(points: &[DVec2], k: usize) -> f64 {
    let m = points.len();
    let (before, at, after) = (points[(k + m - 1) % m], points[k], points[(k + 1) % m]);
    let turn = (at - before).angle_to(after - at);
    if turn.abs() <= CORNER {
        return 1.0;
    }
    (std::f64::consts::PI / (std::f64::consts::PI - turn)).clamp(0.5, SHARPEST)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn square() -> BoundarySamples {
        let points: Vec<DVec2> =
            [(0., 0.), (1., 0.), (2., 0.), (2., 1.), (2., 2.), (1., 2.), (0., 2.), (0., 1.)].map(DVec2::from).into();
        let fractions = (0..8).map(|k| f64::from(k) / 8.0).collect();
        BoundarySamples::checked(points, vec![1.0; 8], fractions).unwrap()
    }

    #[test]
    fn a_place_has_the_measure_that_led_to_it_on_both_halves() {
        let samples = square();
        let psi = [1e-12, 0.3, 1e-3, 0.2, 1e-9, 0.25, 1e-5, 0.1];
        for anchor in [BoundaryPoint::new(0, 0.0), BoundaryPoint::new(3, 0.25)] {
            let measure = HarmonicMeasure::new(&samples, &psi, anchor);
            let rim = Rim::new(&samples, &measure).unwrap();
            for k in 0..=800 {
                let s = f64::from(k) / 100.0;
                let again = rim.length_of(rim.place(rim.at(s)));
                // measures are told apart to 1e-16, places where the density is 1e-9 to 1e-7
                assert!((again - s).abs() < 1e-7, "{anchor:?}: {s} → {again}");
            }
            assert_eq!(rim.vertices().count(), 8);
            assert!((rim.length() - 8.0).abs() < 1e-15);
        }
    }

    #[test]
    fn measures_of_1e_30_before_the_end_are_told_apart() {
        let samples = square();
        let psi = [1e-30, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2e-30];
        let measure = HarmonicMeasure::new(&samples, &psi, BoundaryPoint::new(0, 0.0));
        let rim = Rim::new(&samples, &measure).unwrap();
        let places = [7.5, 7.9].map(|s| rim.length_of(rim.place(rim.at(s))));
        assert!((places[0] - 7.5).abs() < 1e-12 && (places[1] - 7.9).abs() < 1e-12, "{places:?}");
    }

    #[test]
    fn a_right_angle_has_exponent_two_and_a_re_entrant_one_two_thirds() {
        let points = [(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from);
        let exponents: Vec<f64> = (0..6).map(|k| exponent(&points, k)).collect();
        assert!((exponents[0] - 2.0).abs() < 1e-12 && (exponents[3] - 2.0 / 3.0).abs() < 1e-12, "{exponents:?}");
    }
}

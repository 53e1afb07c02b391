//! Counts of hits of random walks, in bins of equal arc length or of equal harmonic measure.
//!
//! By Kakutani's theorem the share of the hits in a part of the boundary tends to
//! its harmonic measure: counts in bins of equal arc length follow ψ, counts in bins of equal measure are uniform.

use super::HarmonicMeasure;
use crate::outline::{BoundaryPoint, BoundarySamples};

/// Counts of hits per bin, counter-clockwise from an anchor.
#[derive(Debug, Clone, PartialEq)]
pub struct HitCounts {
    /// The coordinate that is divided into equal bins: harmonic measure, or arc length as the measure of density 1.
    coordinate: HarmonicMeasure,
    expected: Vec<f64>,
    counts: Vec<u64>,
    total: u64,
}

impl HitCounts {
    /// `bins` (at least 1) parts of equal arc length of the sampled boundary, from the
    /// anchor of `measure`, which also gives the expected shares. O(m + bins log m).
    pub fn by_arc_length(samples: &BoundarySamples, measure: &HarmonicMeasure, bins: usize) -> Self {
        let bins = bins.max(1);
        let arc_length = HarmonicMeasure::new(samples, &vec![1.0; samples.len()], measure.anchor());
        // both have the same knots
        let knots = arc_length.at_knots();
        let ends = (0..=bins).map(|bin| {
            let s = bin as f64 / bins as f64;
            let j = (knots.partition_point(|&knot| knot < s)).clamp(1, knots.len() - 1) - 1;
            let length = knots[j + 1] - knots[j];
            measure.within(j, if length > 0.0 { (s - knots[j]) / length } else { 0.0 })
        });
        let ends: Vec<f64> = ends.collect();
        let expected = ends.windows(2).map(|w| w[1] - w[0]).collect();
        Self::new(arc_length, expected)
    }

    /// `bins` (at least 1) parts of equal harmonic measure, from the anchor of `measure`.
    pub fn by_measure(measure: &HarmonicMeasure, bins: usize) -> Self {
        let bins = bins.max(1);
        Self::new(measure.clone(), vec![1.0 / bins as f64; bins])
    }

    fn new(coordinate: HarmonicMeasure, expected: Vec<f64>) -> Self {
        let counts = vec![0; expected.len()];
        Self { coordinate, expected, counts, total: 0 }
    }

    /// Counts a hit. O(1).
    pub fn record(&mut self, hit: BoundaryPoint) {
        let bins = self.counts.len();
        let bin = (self.coordinate.at(hit) * bins as f64) as usize;
        self.counts[bin.min(bins - 1)] += 1;
        self.total += 1;
    }

    /// Sets all counts to 0.
    pub fn clear(&mut self) {
        self.counts.fill(0);
        self.total = 0;
    }

    /// The hits per bin.
    pub fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// The harmonic measure of each bin: the limit of its share of the hits. The sum is 1.
    pub fn expected(&self) -> &[f64] {
        &self.expected
    }

    /// The total number of hits.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Pearson's χ² = Σ (count − N p)²/(N p) over the bins with N p > 0: about `bins − 1`, with standard deviation
    /// √(2 bins), if the hits follow the measure. 0 without hits.
    pub fn chi_square(&self) -> f64 {
        let total = self.total as f64;
        let term = |(&count, &share): (&u64, &f64)| (count as f64 - total * share).powi(2) / (total * share);
        let filled = self.counts.iter().zip(&self.expected).filter(|&(_, &share)| total * share > 0.0);
        filled.map(term).sum()
    }
}

//! The rounds of a fit: AAA on the samples, a check between them, and more samples where the fit is wrong.

use super::aaa::Aaa;
use super::fit::{Cancelled, Goal, Precision};
use super::function::Rational;
use super::samples::{Boundary, Samples};
use num_complex::Complex64;

/// The share of the tolerance that AAA is to reach on the samples; the rest is for the points between them.
const SHARE: f64 = 0.3;
/// The share of the tolerance below which the points between need no further round.
const ENOUGH: f64 = 0.7;
/// Most rounds of adding samples; built-in pairs need 1 to 4.
const ROUNDS: usize = 4;
/// Points checked in each step between samples. Every other sample is a test point, so these are eight for each.
const CHECKED: usize = 4;
/// Points of the final check in each step: other ones, ten for each test point.
const FINALLY_CHECKED: usize = 5;
/// Samples added in a step where the fit is wrong.
const ADDED: usize = 2;
/// The error between the samples, in those at the samples, from which these are too few.
const WRONG: f64 = 4.0;
/// A round that does not bring the error below this share of the one before is the last.
const IMPROVED: f64 = 0.5;

/// A fit in the making.
pub struct Fitting<'a> {
    boundary: &'a dyn Boundary,
    pub(super) samples: Samples,
    /// Absolute.
    pub(super) tolerance: f64,
    most: usize,
    pub(super) precision: Precision,
}

impl<'a> Fitting<'a> {
    /// With samples for this goal.
    pub fn new(boundary: &'a dyn Boundary, goal: Goal) -> Self {
        let samples = Samples::new(boundary, goal.tolerance, goal.precision.epsilon());
        let tolerance = goal.tolerance * samples.extents[1];
        Self { boundary, samples, tolerance, most: goal.degree + 1, precision: goal.precision }
    }

    /// Half the larger side of the box around the values.
    pub fn extent(&self) -> f64 {
        self.samples.extents[1]
    }

    /// The largest distance between values at neighboring points that cannot be told apart; 0 if it is not longer than
    /// any step.
    pub fn jump(&self) -> f64 {
        let jump = self.samples.largest_jump();
        if jump > self.samples.longest_step() { jump } else { 0.0 }
    }

    /// The function of the best round. Each begins anew: the support points of a round that was wrong between its
    /// samples are those of poles with their own zeros.
    pub fn converge(&mut self, report: &mut dyn FnMut(f64) -> bool) -> Result<Rational, Cancelled> {
        let mut best: Option<(f64, Rational)> = None;
        let decades = (self.extent() / self.tolerance).ln();
        for _ in 0..ROUNDS {
            let mut aaa = Aaa::new(&self.samples, self.tolerance);
            let mut share = |error: f64| report((1.0 - (error / self.tolerance).max(1.0).ln() / decades).max(0.0));
            if !aaa.run(SHARE * self.tolerance, self.most, &mut share) {
                return Err(Cancelled);
            }
            let (function, fitted) = (aaa.function(), aaa.error());
            let errors = self.errors(&function);
            let error = errors.iter().copied().fold(0.0, larger);
            let before = best.as_ref().map_or(f64::INFINITY, |(least, _)| *least);
            if error < before {
                best = Some((error, function));
            }
            let is_fitted = error <= ENOUGH * self.tolerance || error < WRONG * fitted && error > IMPROVED * before;
            if is_fitted || self.jump() > 0.0 || !self.refine(&errors, fitted.max(SHARE * self.tolerance)) {
                break;
            }
        }
        Ok(best.map(|(_, function)| function).unwrap_or_default())
    }

    /// The largest error in each step between samples, in units in which rounding of z counts as the tolerance.
    fn errors(&self, function: &Rational) -> Vec<f64> {
        let of_step = |k: usize| {
            let points = self.samples.between(self.boundary, k, CHECKED);
            let error = points.iter().map(|p| (function.at(p.z) - p.value).norm()).fold(0.0, larger);
            error * self.tolerance / self.tolerance.max(self.samples.uncertainty(k))
        };
        (0..self.samples.points.len()).map(of_step).collect()
    }

    /// Adds samples where the error is larger than twice that at the samples; false if there are none to add.
    fn refine(&mut self, errors: &[f64], fitted: f64) -> bool {
        let before = self.samples.points.len();
        self.samples.insert(self.boundary, ADDED, |k, _, _| errors[k] > 2.0 * fitted);
        self.samples.points.len() > before
    }

    /// The largest error on the boundary.
    pub fn measured(&self, function: &Rational) -> f64 {
        let error = |[z, value]: [Complex64; 2]| match self.precision {
            Precision::Double => (function.at(z) - value).norm(),
            Precision::Single => (function.at_single(z) - value).norm(),
        };
        let between = |k: usize| self.samples.between(self.boundary, k, FINALLY_CHECKED);
        let checked = (0..self.samples.points.len()).flat_map(between).chain(self.samples.points.iter().copied());
        checked.map(|point| error([point.z, point.value])).fold(0.0, larger)
    }

    /// The largest error on the samples and between them, in the units of [`Self::errors`].
    pub(super) fn error(&self, function: &Rational) -> f64 {
        self.errors(function).into_iter().fold(0.0, larger)
    }
}

/// The larger of two errors: that of a value which is no number is infinite.
pub fn larger(most: f64, error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { most.max(error) }
}

//! The rounds of a fit: AAA on the samples, a check between them, more samples where the fit is wrong, and the removal of
//! poles that lie inside or cancel with a zero.

use super::aaa::Aaa;
use super::fit::{Cancelled, Goal, Precision};
use super::function::Rational;
use super::samples::{Boundary, Samples};
use num_complex::Complex64;

/// The share of the tolerance that AAA is to reach on the samples; the rest is for the points between them.
const SHARE: f64 = 0.3;
/// Most rounds of adding samples; built-in pairs need 1 to 4.
const ROUNDS: usize = 6;
/// Points checked in each step between samples. Every other sample is a test point, so these are eight for each.
const CHECKED: usize = 4;
/// Points of the final check in each step: other ones, ten for each test point.
const FINALLY_CHECKED: usize = 5;
/// Samples added in a step where the fit is wrong.
const ADDED: usize = 2;
/// A pole whose residue, over its distance from the samples, is below this share of the tolerance has a zero next to it
/// and no other effect.
const NO_EFFECT: f64 = 1e-3;
/// Rounds of removing poles one by one.
const CLEANINGS: usize = 6;
/// The share of the support points that is kept, again and again, where poles inside do not go otherwise.
const KEPT: f64 = 0.85;

/// Support points with their values.
type Supports = Vec<[Complex64; 2]>;

/// A fit in the making.
pub struct Fitting<'a> {
    boundary: &'a dyn Boundary,
    samples: Samples,
    /// Absolute.
    tolerance: f64,
    most: usize,
    precision: Precision,
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

    /// The support points of the best round. Each begins anew: the support points of a round that was wrong between its
    /// samples are those of poles with their own zeros.
    pub fn converge(&mut self, report: &mut dyn FnMut(f64) -> bool) -> Result<Supports, Cancelled> {
        let mut best: Option<(f64, Supports)> = None;
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
            if best.as_ref().is_none_or(|(least, _)| error < *least) {
                best = Some((error, aaa.supports().to_vec()));
            }
            if !self.refine(&errors, fitted.max(SHARE * self.tolerance)) {
                break;
            }
        }
        Ok(best.map(|(_, supports)| supports).unwrap_or_default())
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

    /// The function with these support points, less those next to poles inside or without effect, and its poles.
    pub fn without_bad_poles(
        &self,
        mut supports: Supports,
        contains: &dyn Fn(Complex64) -> bool,
    ) -> (Rational, Vec<Complex64>) {
        let mut round = 0;
        loop {
            let function = Aaa::new(&self.samples, self.tolerance).with_supports(&supports).function();
            let function = if self.precision == Precision::Single { function.rounded() } else { function };
            let poles = function.poles();
            let inside: Vec<Complex64> = poles.iter().copied().filter(|&pole| contains(pole)).collect();
            let mut bad = inside.clone();
            if round < CLEANINGS {
                bad.extend(poles.iter().filter(|&&pole| !contains(pole) && self.has_no_effect(&function, pole)));
            }
            if bad.is_empty() || supports.len() < 2 {
                return (function, poles);
            }
            if round < CLEANINGS {
                for pole in bad {
                    remove_nearest(&mut supports, pole);
                }
            } else {
                supports.truncate((KEPT * supports.len() as f64) as usize);
            }
            round += 1;
        }
    }

    /// Whether a pole has a zero so near to it that no sample is moved.
    fn has_no_effect(&self, function: &Rational, pole: Complex64) -> bool {
        let distance = self.samples.points.iter().map(|point| (point.z - pole).norm()).fold(f64::INFINITY, f64::min);
        function.residue(pole).norm() < NO_EFFECT * self.tolerance * distance
    }
}

/// Removes the support point nearest to `pole`, unless it is the last one.
fn remove_nearest(supports: &mut Supports, pole: Complex64) {
    let distance = |k: usize| (supports[k][0] - pole).norm();
    let nearest = (0..supports.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    if let Some(nearest) = nearest.filter(|_| supports.len() > 1) {
        supports.remove(nearest);
    }
}

/// The larger of two errors: that of a value which is no number is infinite.
pub fn larger(most: f64, error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { most.max(error) }
}

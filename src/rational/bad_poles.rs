//! Functions without poles inside, nor poles that cancel with a zero.
//!
//! The good poles stay where they are: with them and a support point less for each bad one the function interpolates as
//! before, which costs nothing where the bad poles are next to zeros of their own. Where they are not, those inside are
//! mirrored at the boundary, and the numerator is fitted again; its space then holds that of the good poles alone.

use super::fit::{Cancelled, Precision};
use super::fitting::Fitting;
use super::fixed_poles::{fitted, interpolated};
use super::function::Rational;
use num_complex::Complex64;

/// A pole whose residue, over its distance from the samples, is below this share of the tolerance has a zero next to it
/// and no other effect.
const NO_EFFECT: f64 = 1e-3;
/// An error without bad poles, in those with them, with which the numerator needs no fit.
const WORSE: f64 = 1.2;

impl Fitting<'_> {
    /// The function without its bad poles, and its poles. `go_on` is asked before every step.
    pub fn without_bad_poles(
        &self,
        mut function: Rational,
        contains: &dyn Fn(Complex64) -> bool,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<(Rational, Vec<Complex64>), Cancelled> {
        let mut can_mirror = true;
        while go_on() {
            if self.precision == Precision::Single {
                function = function.rounded();
            }
            let (inside, outside): (Vec<_>, Vec<_>) = function.poles().into_iter().partition(|&pole| contains(pole));
            let (idle, good): (Vec<_>, Vec<_>) =
                outside.into_iter().partition(|&pole| self.has_no_effect(&function, pole));
            if inside.is_empty() && idle.is_empty() {
                return Ok((function, good));
            }
            let mirrored: Vec<_> = inside.iter().map(|&pole| self.mirrored(pole)).collect();
            // once, so that the degree falls afterwards
            can_mirror = can_mirror && !mirrored.iter().any(|&pole| contains(pole));
            let mirrored = std::mem::take(&mut can_mirror).then_some(mirrored);
            function = self.with_good_poles(&function, &[inside, idle].concat(), good, mirrored);
        }
        Err(Cancelled)
    }

    /// The function without the bad poles, or if that is worse, with mirrored ones and another numerator.
    fn with_good_poles(
        &self,
        function: &Rational,
        bad: &[Complex64],
        good: Vec<Complex64>,
        mirrored: Option<Vec<Complex64>>,
    ) -> Rational {
        let support = without_nearest(function, bad);
        let removed = interpolated(&self.samples, support.clone(), &good);
        let error = self.error(&removed);
        if error <= WORSE * self.error(function) {
            return removed;
        }
        let fitted = match mirrored {
            Some(mirrored) => {
                let poles = [good, mirrored].concat();
                fitted(&self.samples, self.tolerance, function.support().to_vec(), &poles)
            }
            None => fitted(&self.samples, self.tolerance, support, &good),
        };
        if self.error(&fitted) < error { fitted } else { removed }
    }

    /// The mirror image of a point at the nearest sample.
    fn mirrored(&self, pole: Complex64) -> Complex64 {
        let distance = |point: &Complex64| (point - pole).norm();
        let points = self.samples.points.iter().map(|point| point.z);
        points.min_by(|a, b| distance(a).total_cmp(&distance(b))).map_or(pole, |nearest| 2.0 * nearest - pole)
    }

    /// Whether a pole has a zero so near to it that no sample is moved.
    fn has_no_effect(&self, function: &Rational, pole: Complex64) -> bool {
        let distance = self.samples.points.iter().map(|point| (point.z - pole).norm()).fold(f64::INFINITY, f64::min);
        function.residue(pole).norm() < NO_EFFECT * self.tolerance * distance
    }
}

/// The support points less those nearest to these poles, one for each; at least one is left.
fn without_nearest(function: &Rational, poles: &[Complex64]) -> Vec<Complex64> {
    let mut supports = function.support().to_vec();
    for pole in poles.iter().take(supports.len().saturating_sub(1)) {
        let distance = |k: &usize| (supports[*k] - pole).norm();
        if let Some(nearest) = (0..supports.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))) {
            supports.remove(nearest);
        }
    }
    supports
}

//! The AAA algorithm (Nakatsukasa, Sète and Trefethen, SIAM J. Sci. Comput. 40 (2018)) on test points and candidates.
//!
//! A step makes the candidates next to the worst test points support points: next to the worst one, and with rising
//! degree next to further local maxima of the error. The weights are the smallest right singular vector of the Loewner
//! matrix (F_j − f_k)/(Z_j − z_k). Support points and test points are disjoint, so the matrix grows by columns and
//! loses no row, and its QR factorization is extended, not remade. Rows whose value is known less well than the
//! tolerance, because z is rounded where f is steep, count less in proportion.

use super::function::Rational;
use super::least_squares::GrowingQr;
use super::samples::{Role, Sample, Samples};
use crate::geometry::sort_by_number;
use num_complex::Complex64;

/// Support points without halving the root of the mean square error, after which it will not fall. That of turkey → disk
/// halves with every 48. (The largest error is no measure: on cinquefoil → disk it stands still from 35 to 65 support
/// points, while poles gather in the notches.)
const PATIENCE: usize = 60;

/// A step adds one support point for so many that there are, besides the first: five notches want poles at once, and
/// fewer steps take less time. The degree rises by about that share.
const SUPPORTS_FOR_ONE: usize = 32;
/// The share of the largest error from which a local maximum is a place of a further support point.
const LARGE: f64 = 0.3;

/// The least number of test points for each support point.
const TESTS: usize = 3;

/// A fit that grows.
#[derive(Debug)]
pub struct Aaa<'a> {
    points: &'a [Sample],
    /// Indices of test points.
    tests: Vec<usize>,
    /// For each test point, the factor of its row, at most 1.
    factors: Vec<f64>,
    is_used: Vec<bool>,
    supports: Vec<[Complex64; 2]>,
    /// 1/(Z_j − z_k), by columns.
    cauchy: Vec<Vec<Complex64>>,
    qr: GrowingQr,
    weights: Vec<Complex64>,
    /// The errors at the test points, times the factors.
    errors: Vec<f64>,
}

impl<'a> Aaa<'a> {
    /// A fit without support points to these samples. `tolerance` is absolute.
    pub fn new(samples: &'a Samples, tolerance: f64) -> Self {
        let points = samples.points.as_slice();
        let tests: Vec<usize> = (0..points.len()).filter(|&k| points[k].role == Role::Test).collect();
        let factors = tests.iter().map(|&k| samples.factor(k, tolerance)).collect();
        let mean = tests.iter().map(|&k| points[k].value).sum::<Complex64>() / tests.len().max(1) as f64;
        let errors = tests.iter().map(|&k| (points[k].value - mean).norm()).collect();
        let is_used = points.iter().map(|point| point.role == Role::Test).collect();
        let (supports, cauchy, qr, weights) = Default::default();
        Self { points, tests, factors, is_used, supports, cauchy, qr, weights, errors }
    }

    /// The largest error at a test point, times its factor.
    pub fn error(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }

    /// The root of the mean square of these errors.
    fn mean_error(&self) -> f64 {
        (self.errors.iter().map(|error| error * error).sum::<f64>() / self.errors.len().max(1) as f64).sqrt()
    }

    /// The fit.
    pub fn function(&self) -> Rational {
        let (support, values) = self.supports.iter().map(|&[z, value]| (z, value)).unzip();
        Rational::new(support, values, self.weights.clone())
    }

    /// Steps until the error is at most `goal`, `most` support points are used, or nothing improves; leaves the best
    /// fit. `report` gets the error and returns whether to go on; returns false if it said no.
    pub fn run(&mut self, goal: f64, most: usize, report: &mut dyn FnMut(f64) -> bool) -> bool {
        let most = most.min(self.tests.len() / TESTS);
        let mut best = (self.error(), self.supports.len(), self.weights.clone(), self.errors.clone());
        let mut halved = (self.mean_error(), self.supports.len());
        while best.0 > goal && self.supports.len() < most && self.supports.len() <= halved.1 + PATIENCE {
            if !report(best.0) {
                return false;
            }
            if !self.step(most - self.supports.len()) {
                break;
            }
            let error = self.error();
            if error < best.0 {
                best = (error, self.supports.len(), self.weights.clone(), self.errors.clone());
            }
            let mean = self.mean_error();
            if mean < 0.5 * halved.0 {
                halved = (mean, self.supports.len());
            }
        }
        (self.weights, self.errors) = (best.2, best.3);
        self.supports.truncate(best.1);
        self.cauchy.truncate(best.1);
        self.qr.truncate(best.1);
        true
    }

    /// Adds the candidates next to the worst test points, at most so many; false if none is left.
    fn step(&mut self, most: usize) -> bool {
        let before = self.supports.len();
        let count = (1 + before / SUPPORTS_FOR_ONE).min(most);
        for test in self.worst(count) {
            if let Some(candidate) = self.nearest_candidate(self.tests[test]) {
                self.is_used[candidate] = true;
                let Sample { z, value, .. } = self.points[candidate];
                self.push([z, value]);
            }
        }
        self.solve();
        self.supports.len() > before
    }

    /// The local maxima of the error, up to so many, the largest first.
    fn worst(&self, count: usize) -> Vec<usize> {
        let (errors, tests) = (&self.errors, self.errors.len());
        let least = LARGE * self.error();
        let is_maximum = |&k: &usize| {
            let [before, after] = [errors[(k + tests - 1) % tests], errors[(k + 1) % tests]];
            errors[k] >= least && errors[k] > before && errors[k] >= after
        };
        let mut maxima: Vec<usize> = (0..tests).filter(is_maximum).collect();
        sort_by_number(&mut maxima, |&k| -errors[k]);
        maxima.truncate(count);
        if maxima.is_empty() {
            // an error that is the same everywhere
            maxima.extend((0..tests).max_by(|&a, &b| errors[a].total_cmp(&errors[b])));
        }
        maxima
    }

    /// The unused candidate the fewest points away.
    fn nearest_candidate(&self, from: usize) -> Option<usize> {
        let count = self.points.len();
        (1..=count / 2).flat_map(|d| [(from + d) % count, (from + count - d) % count]).find(|&k| !self.is_used[k])
    }

    fn push(&mut self, [z, value]: [Complex64; 2]) {
        // a test point on a support point has no row
        let inverse = |z: Complex64| if z == Complex64::ZERO { z } else { z.inv() };
        let cauchy: Vec<Complex64> = self.tests.iter().map(|&j| inverse(self.points[j].z - z)).collect();
        let entry = |((&j, c), factor): ((&usize, &Complex64), &f64)| (self.points[j].value - value) * c * factor;
        self.qr.push(self.tests.iter().zip(&cauchy).zip(&self.factors).map(entry).collect());
        self.cauchy.push(cauchy);
        self.supports.push([z, value]);
    }

    /// The weights and the errors for the present support points.
    fn solve(&mut self) {
        self.weights = self.qr.smallest();
        let mut numerator = vec![Complex64::ZERO; self.tests.len()];
        let mut denominator = numerator.clone();
        for ((column, weight), [_, value]) in self.cauchy.iter().zip(&self.weights).zip(&self.supports) {
            let product = weight * value;
            for ((c, n), d) in column.iter().zip(&mut numerator).zip(&mut denominator) {
                *n += product * c;
                *d += weight * c;
            }
        }
        for (k, &j) in self.tests.iter().enumerate() {
            let error = (self.points[j].value - numerator[k] / denominator[k]).norm() * self.factors[k];
            self.errors[k] = if error.is_finite() { error } else { f64::MAX };
        }
    }
}

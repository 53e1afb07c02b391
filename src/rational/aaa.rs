//! The AAA algorithm (Nakatsukasa, Sète and Trefethen, SIAM J. Sci. Comput. 40 (2018)) on test points and candidates.
//!
//! A step makes the candidate next to the worst test point a support point; the weights are the smallest right singular
//! vector of the Loewner matrix (F_j − f_k)/(Z_j − z_k). Support points and test points are disjoint, so the matrix
//! grows by a column a step and loses no row, and its QR factorization is extended, not remade. Rows whose value is
//! known less well than the tolerance, because z is rounded where f is steep, count less in proportion.

use super::function::Rational;
use super::least_squares::GrowingQr;
use super::samples::{Role, Sample, Samples};
use num_complex::Complex64;

/// Steps without halving the error after which it will not fall: the maximum of a converging fit stands still for up to
/// 15 steps while poles gather at another corner.
const PATIENCE: usize = 30;

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
        let before = |k: usize| (k + points.len() - 1) % points.len();
        let uncertainty = |k: usize| samples.uncertainty(k).max(samples.uncertainty(before(k)));
        let tests: Vec<usize> = (0..points.len()).filter(|&k| points[k].role == Role::Test).collect();
        let factors = tests.iter().map(|&k| tolerance / tolerance.max(uncertainty(k))).collect();
        let mean = tests.iter().map(|&k| points[k].value).sum::<Complex64>() / tests.len().max(1) as f64;
        let errors = tests.iter().map(|&k| (points[k].value - mean).norm()).collect();
        let is_used = points.iter().map(|point| point.role == Role::Test).collect();
        let (supports, cauchy, qr, weights) = Default::default();
        Self { points, tests, factors, is_used, supports, cauchy, qr, weights, errors }
    }

    /// Makes these pairs support points, without test points among them.
    pub fn with_supports(mut self, supports: &[[Complex64; 2]]) -> Self {
        for (k, point) in self.points.iter().enumerate() {
            self.is_used[k] |= supports.iter().any(|[z, _]| *z == point.z);
        }
        for &support in supports {
            self.push(support);
        }
        self.solve();
        self
    }

    /// The largest error at a test point, times its factor.
    pub fn error(&self) -> f64 {
        self.errors.iter().copied().fold(0.0, f64::max)
    }

    /// The support points with their values.
    pub fn supports(&self) -> &[[Complex64; 2]] {
        &self.supports
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
        let mut halved = (best.0, best.1);
        while best.0 > goal && self.supports.len() < most && self.supports.len() <= halved.1 + PATIENCE {
            if !report(best.0) {
                return false;
            }
            if !self.step() {
                break;
            }
            let error = self.error();
            if error < best.0 {
                best = (error, self.supports.len(), self.weights.clone(), self.errors.clone());
            }
            if error < 0.5 * halved.0 {
                halved = (error, self.supports.len());
            }
        }
        (self.weights, self.errors) = (best.2, best.3);
        self.supports.truncate(best.1);
        self.cauchy.truncate(best.1);
        self.qr.truncate(best.1);
        true
    }

    /// Adds the candidate next to the worst test point; false if none is left.
    fn step(&mut self) -> bool {
        let worst = (0..self.tests.len()).max_by(|&a, &b| self.errors[a].total_cmp(&self.errors[b]));
        let Some(candidate) = worst.and_then(|worst| self.nearest_candidate(self.tests[worst])) else { return false };
        self.is_used[candidate] = true;
        let Sample { z, value, .. } = self.points[candidate];
        self.push([z, value]);
        self.solve();
        true
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

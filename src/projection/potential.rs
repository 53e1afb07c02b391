//! The analytic function whose real part is harmonic with given boundary values: a polynomial and simple poles outside.
//!
//! Φ(z) = Σ a_k (z/R)^k + Σ c_j d_j/(z − q_j), fitted to the boundary values of Re Φ by least squares ("lightning
//! Laplace solver", Gopal & Trefethen, SIAM J. Numer. Anal. 57 (2019) 2074, here with poles beside arcs that are bisected
//! where the residual is large). By the maximum principle the largest residual on the boundary bounds the error of Re Φ
//! everywhere inside. Φ is analytic wherever it is evaluated, so that exp Φ is the derivative of an exactly conformal map.

use super::arcs::{Arc, Arcs};
use super::region::Region;
use crate::geometry::DVec2;
use faer::Mat;
use faer::linalg::solvers::SolveLstsq as _;
use num_complex::Complex64;

/// The degree of the polynomial.
const DEGREE: usize = 16;

/// The largest number of poles. The least squares of so many cost about a second.
const MOST_POLES: usize = 400;

/// Rounds of refinement.
const ROUNDS: usize = 16;

/// Points of an arc at which the function is fitted, and between which it is checked.
const FITTED: usize = 6;
const CHECKED: usize = 7;

/// The largest residual that is not refined, in the boundary values' largest magnitude.
const ENOUGH: f64 = 1e-9;

/// Arcs with this part of the largest residual are bisected.
const PART: f64 = 0.03;

/// The weight of the coefficients in the least squares: with values of magnitude 1 and residuals of 1e-9, coefficients up
/// to about 1e4 cost nothing, and dependent columns stay harmless.
const RIDGE: f64 = 1e-13;

/// A pole outside, with the distance from its arc as its unit.
#[derive(Debug, Clone, Copy)]
pub struct Pole {
    pub at: Complex64,
    pub unit: f64,
}

/// Φ.
#[derive(Debug, Clone)]
pub struct Potential {
    radius: f64,
    coefficients: Vec<Complex64>,
    /// Poles and residues.
    poles: Vec<(Complex64, Complex64)>,
}

/// A function with its largest deviation from the boundary values.
#[derive(Debug, Clone)]
pub struct Fitted {
    pub potential: Potential,
    pub residual: f64,
}

fn complex(p: DVec2) -> Complex64 {
    Complex64::new(p.x, p.y)
}

impl Potential {
    /// Φ(z).
    pub fn value(&self, z: DVec2) -> Complex64 {
        let z = complex(z);
        let w = z / self.radius;
        let polynomial = self.coefficients.iter().rev().fold(Complex64::ZERO, |sum, a| sum * w + a);
        polynomial + self.poles.iter().map(|(at, residue)| residue / (z - at)).sum::<Complex64>()
    }

    /// The same function plus a constant.
    #[must_use]
    pub fn plus(mut self, constant: Complex64) -> Self {
        self.coefficients[0] += constant;
        self
    }
}

/// Fits Re Φ to `values` on the boundary of a region.
pub fn fit(region: &Region, values: &dyn Fn(DVec2) -> f64) -> Fitted {
    let mut arcs = Arcs::new(region.polygon());
    let magnitude = region.polygon().vertices().iter().map(|&z| values(z).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let radius = region.polygon().vertices().iter().map(|z| z.length()).fold(0.0, f64::max);
    let mut poles: Vec<Pole> = arcs.leaves().iter().filter_map(|arc| arcs.pole(arc, region)).collect();
    let mut best: Option<Fitted> = None;
    for _ in 0..ROUNDS {
        let potential = least_squares(&arcs, &poles, radius, &|z| values(z) / magnitude, magnitude);
        let residual = |arc: &Arc| {
            let off = |z: DVec2| (potential.value(z).re - values(z)).abs();
            arcs.points(arc, CHECKED).map(off).fold(0.0, f64::max)
        };
        let residuals: Vec<f64> = arcs.leaves().iter().map(residual).collect();
        let worst = residuals.iter().copied().fold(0.0, f64::max);
        if best.as_ref().is_none_or(|best| worst < best.residual) {
            best = Some(Fitted { potential, residual: worst });
        }
        let room = MOST_POLES.saturating_sub(poles.len()) / 2;
        if worst <= ENOUGH * magnitude || room == 0 {
            break;
        }
        for arc in arcs.bisect(&residuals, (PART * worst).max(ENOUGH * magnitude), room) {
            poles.extend(arcs.pole(&arc, region));
        }
    }
    best.unwrap_or_else(|| Fitted {
        potential: Potential { radius, coefficients: vec![Complex64::ZERO], poles: Vec::new() },
        residual: magnitude,
    })
}

/// Minimizes Σ (Re Φ − values)² over the points of all arcs; the result is multiplied by `magnitude`.
fn least_squares(
    arcs: &Arcs<'_>,
    poles: &[Pole],
    radius: f64,
    values: &dyn Fn(DVec2) -> f64,
    magnitude: f64,
) -> Potential {
    let points: Vec<DVec2> = arcs.leaves().iter().flat_map(|arc| arcs.points(arc, FITTED)).collect();
    let unknowns = 2 * (DEGREE + poles.len()) + 1;
    let (m, n) = (points.len(), unknowns);
    let mut matrix = Mat::<f64>::zeros(m + n, n);
    for (i, &z) in points.iter().enumerate() {
        let z = complex(z);
        matrix[(i, 0)] = 1.0;
        let mut power = Complex64::ONE;
        let powers = (0..DEGREE).map(|_| {
            power *= z / radius;
            power
        });
        let terms = powers.chain(poles.iter().map(|pole| pole.unit / (z - pole.at)));
        for (k, term) in terms.enumerate() {
            matrix[(i, 2 * k + 1)] = term.re;
            matrix[(i, 2 * k + 2)] = -term.im;
        }
    }
    let ridge = RIDGE * (m as f64).sqrt();
    (0..n).for_each(|k| matrix[(m + k, k)] = ridge);
    let right = Mat::from_fn(m + n, 1, |i, _| points.get(i).map_or(0.0, |&z| values(z)));
    let x = matrix.qr().solve_lstsq(&right);
    let coefficient = |k: usize| magnitude * Complex64::new(x[(2 * k + 1, 0)], x[(2 * k + 2, 0)]);
    let mut coefficients = vec![Complex64::from(magnitude * x[(0, 0)])];
    coefficients.extend((0..DEGREE).map(coefficient));
    let residue = |(k, pole): (usize, &Pole)| (pole.at, pole.unit * coefficient(DEGREE + k));
    Potential { radius, coefficients, poles: poles.iter().enumerate().map(residue).collect() }
}

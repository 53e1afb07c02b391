//! The analytic function whose real part is harmonic with given boundary values: a polynomial and simple poles outside.
//!
//! Φ(z) = Σ a_k (z/R)^k + Σ c_j d_j/(z − q_j), fitted to the boundary values of Re Φ by least squares ("lightning
//! Laplace solver", Gopal & Trefethen, SIAM J. Numer. Anal. 57 (2019) 2074, here with poles beside arcs that are bisected
//! where the residual is large). By the maximum principle the largest residual on the boundary bounds the error of Re Φ
//! everywhere inside. Φ is analytic wherever it is evaluated, so that exp Φ is the derivative of an exactly conformal map.

use super::arcs::{Arcs, Pole};
use super::region::Region;
use crate::geometry::DVec2;
use faer::Mat;
use faer::linalg::solvers::SolveLstsq as _;
use num_complex::Complex64;
use rayon::prelude::*;

/// The degree of the polynomial.
const DEGREE: usize = 16;

/// The largest number of arcs, to which almost twice as many poles belong. The least squares of so many cost some seconds.
const MOST_ARCS: usize = 500;

/// Bisections of an arc in one round, toward its worst point.
const DEPTH: u32 = 2;

/// Rounds of refinement.
const ROUNDS: usize = 30;

/// Points of an arc at which the function is fitted, and between which it is checked.
const FITTED: usize = 10;
const CHECKED: usize = 11;

/// Rounds without a residual below this part of the least one before, after which no others follow.
const IDLE: u32 = 3;
const GAIN: f64 = 0.8;

/// The largest residual that is not refined, in the boundary values' largest magnitude.
const ENOUGH: f64 = 1e-6;

/// Arcs with this part of the largest residual are bisected.
const PART: f64 = 0.03;

/// The weight of the coefficients in the least squares, for values of magnitude 1. With 1e-13 nearly dependent columns
/// gave infinite coefficients, with 1e-11 the function oscillated by 1e-2 between the points of rough coasts; with 1e-8 it
/// does not, and residuals of 1e-7 are still reached.
const RIDGE: f64 = 1e-8;

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

/// Fits Re Φ to `values` on the boundary of a region. `progress` is called before each round with the share that is done
/// and returns whether to go on; `None` if it said no.
pub fn fit(
    region: &Region,
    values: &(dyn Fn(DVec2) -> f64 + Sync),
    progress: &mut dyn FnMut(f64) -> bool,
) -> Option<Fitted> {
    let mut arcs = Arcs::new(region);
    let magnitude = region.polygon().vertices().iter().map(|&z| values(z).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let radius = region.polygon().vertices().iter().map(|z| z.length()).fold(0.0, f64::max);
    let mut best: Option<Fitted> = None;
    let mut idle = 0;
    for _ in 0..ROUNDS {
        if !progress(best.as_ref().map_or(0.0, |best| share_done(best.residual / magnitude))) {
            return None;
        }
        let poles = arcs.poles(region);
        let potential = least_squares(&arcs, &poles, radius, &|z| values(z) / magnitude, magnitude);
        let off = |z: DVec2| Some((potential.value(z).re - values(z)).abs()).filter(|off| !off.is_nan());
        let residuals = arcs.leaves().par_iter().map(|arc| worst_of(arcs.points(arc, CHECKED).map(off)));
        let residuals: Vec<(f64, f64)> = residuals.collect();
        let worst = residuals.iter().map(|found| found.0).fold(0.0, f64::max);
        idle = if best.as_ref().is_some_and(|best| worst >= GAIN * best.residual) { idle + 1 } else { 0 };
        if best.as_ref().is_none_or(|best| worst < best.residual) {
            best = Some(Fitted { potential, residual: worst });
        }
        // at most half as many again in a round: the next one corrects what oscillates beside new poles
        let room = MOST_ARCS.saturating_sub(residuals.len()).min(residuals.len() / 2) / DEPTH as usize;
        if worst <= ENOUGH * magnitude || room == 0 || idle == IDLE {
            break;
        }
        let limit = (PART * worst).max(ENOUGH * magnitude);
        let mut chosen: Vec<usize> = (0..residuals.len()).filter(|&k| residuals[k].0 > limit).collect();
        chosen.sort_by(|&i, &j| residuals[j].0.total_cmp(&residuals[i].0));
        chosen.truncate(room);
        let chosen: Vec<(usize, f64)> = chosen.into_iter().map(|k| (k, residuals[k].1)).collect();
        arcs.bisect(&chosen, DEPTH);
    }
    best.or_else(|| Some(constant(region, values)))
}

/// How far a residual has come from 1 to [`ENOUGH`], on a logarithmic scale.
fn share_done(residual: f64) -> f64 {
    (residual.ln() / ENOUGH.ln()).clamp(0.0, 1.0)
}

/// The constant that is nearest to `values` on the boundary's vertices.
pub fn constant(region: &Region, values: &(dyn Fn(DVec2) -> f64 + Sync)) -> Fitted {
    let all = region.polygon().vertices().iter().map(|&z| values(z));
    let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let coefficients = vec![Complex64::from(0.5 * (low + high))];
    let potential = Potential { radius: 1.0, coefficients, poles: Vec::new() };
    Fitted { potential, residual: 0.5 * (high - low) }
}

/// The largest of the deviations at equally spaced points of an arc, and at what share of it; infinite if one is not a
/// number.
fn worst_of(deviations: impl Iterator<Item = Option<f64>>) -> (f64, f64) {
    let share = |k: usize| (k as f64 + 0.5) / CHECKED as f64;
    let found = deviations.enumerate().map(|(k, off)| (off.unwrap_or(f64::INFINITY), share(k)));
    found.fold((0.0, 0.5), |best, found| if found.0 > best.0 { found } else { best })
}

/// Minimizes Σ (Re Φ − values)² over the points of all arcs; the result is multiplied by `magnitude`.
fn least_squares(
    arcs: &Arcs<'_>,
    poles: &[Pole],
    radius: f64,
    values: &(dyn Fn(DVec2) -> f64 + Sync),
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

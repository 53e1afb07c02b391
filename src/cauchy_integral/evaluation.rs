//! The sums over the panels at one point.
//!
//! With S₀, S₁ = ∮ (1, F)/(ζ − z) dζ and T₀, T₁ = ∮ (1, F)/(ζ − z)² dζ: f = S₁/S₀ and f′ = (T₁ − f T₀)/S₀.

use super::panel::Panel;
use super::rule::NODES;
use super::{CauchyIntegral, Complex, Evaluation, complex, point};
use crate::geometry::DVec2;
use std::f64::consts::{PI, TAU};

/// Distance from the middle of a panel, in half chords, within which it is near. At this distance the rule's error is
/// below 3.2⁻³² = 7e-17, and the recursion of the moments loses at most 1.75¹⁵ = 4,400 units of the last place of the
/// highest, which has the least coefficient.
const NEAR: f64 = 1.75;

/// Rounding of ζ′ next to a panel.
const ROUNDING: f64 = 1e-9;

/// The sums S₀, S₁, T₀, T₁.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    s: [Complex; 2],
    t: [Complex; 2],
    /// Σ |S₀ of the panel| times its error.
    error: f64,
}

/// A near panel: its index, ζ′ of z, and the end offsets minus z.
#[derive(Debug, Clone, Copy)]
struct Near {
    index: usize,
    local: Complex,
    ends: [Complex; 2],
}

/// The moments ∫ ζ′ʲ/(ζ′ − z′) dζ′ over [−1, 1], from the first one.
fn moments(local: Complex, first: Complex) -> [Complex; NODES] {
    let mut moment = first;
    std::array::from_fn(|j| {
        let here = moment;
        let whole = if j % 2 == 0 { 2.0 / (j as f64 + 1.0) } else { 0.0 };
        moment = local * here + whole;
        here
    })
}

impl Sums {
    /// Adds a far panel, by its rule.
    fn add_far(&mut self, panel: &Panel, z: DVec2) {
        let relative = z - panel.base;
        let mut sums = [0.0; 8];
        for k in 0..NODES {
            let (x, y) = (panel.offsets[0][k] - relative.x, panel.offsets[1][k] - relative.y);
            let inverse = 1.0 / (x * x + y * y);
            let (p, q) = (x * inverse, -y * inverse);
            let (w, v) = (panel.weights[0][k], panel.weights[1][k]);
            let (a, b) = (w * p - v * q, w * q + v * p);
            let (f, g) = (panel.values[0][k], panel.values[1][k]);
            let (c, d) = (a * f - b * g, a * g + b * f);
            let terms = [a, b, c, d, a * p - b * q, a * q + b * p, c * p - d * q, c * q + d * p];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        let [a, b, c, d, e, f, g, h] = sums;
        self.add([Complex::new(a, b), Complex::new(c, d)], panel.error);
        self.t[0] += Complex::new(e, f);
        self.t[1] += Complex::new(g, h);
    }

    fn add(&mut self, s: [Complex; 2], error: f64) {
        self.s[0] += s[0];
        self.s[1] += s[1];
        self.error += s[0].norm() * error;
    }

    /// Adds S₀ and S₁ of a near panel: the moments of its polynomial.
    fn add_near(&mut self, panel: &Panel, near: &Near) {
        let moments = moments(near.local, (near.ends[1] / near.ends[0]).ln());
        let value = moments.iter().zip(&panel.powers).map(|(m, a)| m * a).sum();
        self.add([moments[0], value], panel.error);
    }
}

impl CauchyIntegral {
    /// f and f′ at z, which must lie inside of the curve, and not on it.
    pub fn evaluate(&self, z: DVec2) -> Evaluation {
        let (mut sums, mut near) = (Sums::default(), Vec::new());
        for (index, panel) in self.panels.iter().enumerate() {
            let ends = panel.ends.map(|end| end - complex(z - panel.base));
            let (middle, half) = (0.5 * (ends[0] + ends[1]), panel.half_chord());
            if middle.norm_sqr() > NEAR * NEAR * half.norm_sqr() {
                sums.add_far(panel, z);
            } else {
                let neighbor = Near { index, local: -middle / half, ends };
                sums.add_near(panel, &neighbor);
                near.push(neighbor);
            }
        }
        let behind = self.behind_chord(&near, sums.s[0]);
        if let Some(Near { index, local, .. }) = behind {
            let panel = &self.panels[index];
            let around = Complex::new(0.0, TAU);
            sums.s[0] += around;
            sums.s[1] += around * panel.polynomial(local)[0];
        }
        self.finish(z, &sums, &near, behind)
    }

    /// The panel between whose chord and itself z lies. The logarithm of the ratio of the ends then lacks 2πi, and the
    /// sum over all panels, 2πi inside, is 0.
    fn behind_chord(&self, near: &[Near], sum: Complex) -> Option<Near> {
        let depth = |near: &Near| near.local.im.abs() / (self.panels[near.index].height + f64::EPSILON);
        let is_before = |near: &&Near| near.local.re.abs() <= 1.0 + ROUNDING && near.local.im <= ROUNDING;
        let candidates = near.iter().filter(is_before).copied();
        (sum.im < PI).then(|| candidates.min_by(|a, b| depth(a).total_cmp(&depth(b)))).flatten()
    }

    /// f, f′ and the error from the sums; the near panels' parts of T₀ and T₁ are added here.
    fn finish(&self, z: DVec2, sums: &Sums, near: &[Near], behind: Option<Near>) -> Evaluation {
        let value = sums.s[1] / sums.s[0];
        let mut slope = sums.t[1] - value * sums.t[0];
        for (k, &Near { index, local, ends }) in near.iter().enumerate() {
            let panel = &self.panels[index];
            let is_behind = behind.is_some_and(|behind| behind.index == index);
            let turn = if is_behind { Complex::new(0.0, TAU) } else { Complex::ZERO };
            let moments = moments(local, (ends[1] / ends[0]).ln());
            let terms = (1..NODES).map(|j| j as f64 * panel.powers[j] * moments[j - 1]);
            let integral = terms.sum::<Complex>() + turn * panel.polynomial(local)[1];
            slope += integral / panel.half_chord();
            // what two near panels have in common at their joint cancels
            let [is_joined, joins] = self.joints(near, k);
            if !is_joined {
                slope += (panel.polynomial(-Complex::ONE)[0] - value) / ends[0];
            }
            if !joins {
                slope -= (panel.polynomial(Complex::ONE)[0] - value) / ends[1];
            }
        }
        let derivative = slope / sums.s[0];
        let rounding = f64::EPSILON * (self.magnitude + derivative.norm() * z.length());
        let of_quadrature = self.quadrature_error(sums.s[0], near, derivative.norm());
        let error = sums.error / sums.s[0].norm() + of_quadrature + rounding;
        Evaluation { value: point(self.center + value), derivative: point(derivative), error }
    }

    /// What the error of S₀, whose exact value is 2πi, says about that of f: δS (F − f)/S₀. A large one is due to the
    /// rounding of a joint next to z, where F − f is f′ times the distance.
    fn quadrature_error(&self, sum: Complex, near: &[Near], slope: f64) -> f64 {
        let whole = (sum / Complex::new(0.0, TAU) - Complex::ONE).norm();
        let joint = near.iter().flat_map(|near| near.ends).map(Complex::norm).fold(f64::INFINITY, f64::min);
        whole * self.extent.min(slope * joint)
    }

    /// Whether the panels before and after a near panel are near, too.
    fn joints(&self, near: &[Near], k: usize) -> [bool; 2] {
        let (index, count) = (near[k].index, self.panels.len());
        let is_near = |index: usize| near.binary_search_by_key(&index, |near| near.index).is_ok();
        [(index + count - 1) % count, (index + 1) % count].map(is_near)
    }
}

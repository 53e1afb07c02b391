//! Legendre series on a panel: from values at the Gauss nodes to coefficients, their values and integrals, and
//! interpolation to the two halves of a panel.

use crate::geometry::gauss_legendre;
use num_complex::Complex64;
use std::sync::OnceLock;

/// The number of nodes on a panel.
///
/// 12 nodes leave errors of 1e-11 inside of the panels next to a corner, 16 leave 1e-14 (square, L-shape); 20 cost
/// twice the time of 16 for the same panels.
pub const NODES: usize = 16;

/// Values or coefficients on one panel.
pub type Values = [f64; NODES];

/// The rule of a panel and its interpolation matrices.
#[derive(Debug)]
pub struct Rule {
    /// Nodes on [−1, 1], ascending.
    pub nodes: Values,
    /// Weights.
    pub weights: Values,
    /// `to_series[k][j]`: coefficient k from the value at node j.
    to_series: [Values; NODES],
    /// `halves[side][i][j]`: the value at node i of the left or right half from the value at node j of the whole.
    pub halves: [[Values; NODES]; 2],
    /// `from_left[i][j]`: the integral from −1 to node i from the value at node j.
    from_left: [Values; NODES],
}

/// (2k − 1)/k, (k − 1)/k and 1/(2k + 1).
const RECURRENCE: [[f64; 3]; NODES + 1] = {
    let mut all = [[0.0; 3]; NODES + 1];
    let mut k = 1;
    while k <= NODES {
        let n = k as f64;
        all[k] = [(2.0 * n - 1.0) / n, (n - 1.0) / n, 1.0 / (2.0 * n + 1.0)];
        k += 1;
    }
    all
};

/// P₀ … P_NODES at x.
pub fn polynomials(x: f64) -> [f64; NODES + 1] {
    let mut p = [1.0; NODES + 1];
    p[1] = x;
    for k in 2..=NODES {
        p[k] = RECURRENCE[k][0] * x * p[k - 1] - RECURRENCE[k][1] * p[k - 2];
    }
    p
}

/// P₀ … P₁₅ at a complex point.
pub fn complex_polynomials(z: Complex64) -> [Complex64; NODES] {
    let mut p = [Complex64::ONE; NODES];
    p[1] = z;
    for k in 2..NODES {
        p[k] = RECURRENCE[k][0] * z * p[k - 1] - RECURRENCE[k][1] * p[k - 2];
    }
    p
}

/// The parameter ρ ≥ 1 of the Bernstein ellipse through z: |z ± √(z² − 1)|, the larger one.
pub fn bernstein(z: Complex64) -> f64 {
    let rho = (z + (z * z - 1.0).sqrt()).norm();
    rho.max(rho.recip())
}

/// Up to this ρ the recurrence forwards loses at most ρ³⁰ = 66 roundings.
const FORWARDS: f64 = 1.15;

/// ∫ Pₖ(t)/(z − t) dt = 2 Qₖ(z), k = 0 … 16; for z in [−1, 1] the real part is the principal value.
///
/// Qₖ is the minimal solution of the recurrence of Pₖ: away from the interval it is run backwards (Miller's algorithm),
/// from where the other solution has died off.
pub fn second_kind(z: Complex64) -> [Complex64; NODES] {
    let first = ((z + 1.0) / (z - 1.0)).ln();
    let rho = bernstein(z);
    let mut q = [first; NODES];
    if rho <= FORWARDS {
        q[1] = z * first - 2.0;
        for k in 1..NODES - 1 {
            let n = k as f64;
            q[k + 1] = ((2.0 * n + 1.0) * z * q[k] - n * q[k - 1]) / (n + 1.0);
        }
        return q;
    }
    let start = NODES + (20.0 / rho.ln()).ceil() as usize;
    let (mut next, mut here) = (Complex64::ZERO, Complex64::from(f64::MIN_POSITIVE.sqrt()));
    for k in (1..=start).rev() {
        // here and next are proportional to Qₖ and Qₖ₊₁
        let n = k as f64;
        if k < NODES {
            q[k] = here;
        }
        (next, here) = (here, ((2.0 * n + 1.0) * z * here - (n + 1.0) * next) / n);
    }
    let scale = first / here;
    q[1..].iter_mut().for_each(|q| *q *= scale);
    q[0] = first;
    q
}

/// The values at x of Σ cₖ Pₖ and of its integral from −1.
pub fn series(coefficients: &Values, x: f64) -> (f64, f64) {
    let p = polynomials(x);
    let mut value = coefficients[0];
    let mut integral = coefficients[0] * (x + 1.0);
    for k in 1..NODES {
        value += coefficients[k] * p[k];
        integral += coefficients[k] * (p[k + 1] - p[k - 1]) * RECURRENCE[k][2];
    }
    (value, integral)
}

impl Rule {
    /// The rule; computed once.
    pub fn get() -> &'static Self {
        static RULE: OnceLock<Rule> = OnceLock::new();
        RULE.get_or_init(Self::new)
    }

    fn new() -> Self {
        let rule = gauss_legendre(NODES);
        let nodes: Values = std::array::from_fn(|k| rule[k].0);
        let weights: Values = std::array::from_fn(|k| rule[k].1);
        let at_nodes = nodes.map(polynomials);
        // the rule is exact for products of Pₖ and polynomials of the interpolating degree
        let to_series: [Values; NODES] =
            std::array::from_fn(|k| std::array::from_fn(|j| 0.5 * (2 * k + 1) as f64 * weights[j] * at_nodes[j][k]));
        let unit = |j: usize| -> Values { std::array::from_fn(|k| to_series[k][j]) };
        let halves = [-0.5, 0.5].map(|middle| {
            std::array::from_fn(|i| std::array::from_fn(|j| series(&unit(j), middle + 0.5 * nodes[i]).0))
        });
        let from_left = std::array::from_fn(|i| std::array::from_fn(|j| series(&unit(j), nodes[i]).1));
        Self { nodes, weights, to_series, halves, from_left }
    }

    /// The Legendre coefficients of the polynomial with these values at the nodes.
    pub fn coefficients(&self, values: &Values) -> Values {
        std::array::from_fn(|k| dot(&self.to_series[k], values))
    }

    /// Row k: Legendre coefficient k from the values at the nodes.
    pub fn to_series(&self) -> &[Values; NODES] {
        &self.to_series
    }

    /// The integrals from −1 to each node of the polynomial with these values at the nodes.
    pub fn integrals(&self, values: &Values) -> Values {
        std::array::from_fn(|i| dot(&self.from_left[i], values))
    }
}

fn dot(a: &Values, b: &Values) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The larger of the last two coefficients: how far a function is from being resolved.
pub fn last_two(coefficients: &Values) -> f64 {
    coefficients[NODES - 1].abs().max(coefficients[NODES - 2].abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_of_the_second_kind_are_integrals_of_polynomials() {
        let z = |x: f64, y: f64| Complex64::new(x, y);
        for z in [z(0.3, 0.05), z(1.1, 0.0), z(-0.2, -0.4), z(1.6, 0.1), z(0.0, 1.4), z(-1.01, 1e-3)] {
            let found = second_kind(z);
            // the interval in parts that are short against their distance from z
            let parts = 4000;
            let rule = gauss_legendre(NODES);
            for (k, q) in found.into_iter().enumerate() {
                let part = |i: i32| {
                    let value = |(x, w): &(f64, f64)| {
                        let t = -1.0 + (f64::from(2 * i + 1) + x) / f64::from(parts);
                        w / f64::from(parts) * polynomials(t)[k] / (z - t)
                    };
                    rule.iter().map(value).sum::<Complex64>()
                };
                let expected: Complex64 = (0..parts).map(part).sum();
                assert!((q - expected).norm() < 1e-13, "Q{k}({z}): {q}, expected {expected}");
            }
        }
    }

    #[test]
    fn a_smooth_function_is_interpolated_and_integrated() {
        let rule = Rule::get();
        let values = rule.nodes.map(|x| (2.0 * x + 0.3).sin());
        let coefficients = rule.coefficients(&values);
        for k in 0..=20 {
            let x = -1.0 + 0.1 * f64::from(k);
            let (value, integral) = series(&coefficients, x);
            // the coefficients beyond degree 15 sum up to 1.2e-13
            assert!((value - (2.0 * x + 0.3).sin()).abs() < 1e-12, "at {x}");
            let exact = 0.5 * ((-1.7_f64).cos() - (2.0 * x + 0.3).cos());
            assert!((integral - exact).abs() < 1e-13, "to {x}: {integral} for {exact}");
        }
        for (side, half) in rule.halves.iter().enumerate() {
            for (row, node) in half.iter().zip(rule.nodes) {
                let x = side as f64 - 0.5 + 0.5 * node;
                assert!((dot(row, &values) - (2.0 * x + 0.3).sin()).abs() < 1e-12);
            }
        }
        let integrals = rule.integrals(&values);
        assert!(rule.nodes.iter().zip(integrals).all(|(&x, i)| (series(&coefficients, x).1 - i).abs() < 1e-14));
    }
}

//! The Gauss–Legendre rule of the panels, and interpolation at its nodes: in Legendre polynomials of the parameter, and
//! in powers of the position.

use super::Complex;
use crate::geometry::gauss_legendre;
use std::sync::OnceLock;

/// Nodes of a panel. Next to a break point, panels are twice as long as their distance from it; an algebraic singularity
/// is then resolved to 5.8⁻¹⁶ = 6e-13 of what the function varies on the panel.
pub const NODES: usize = 16;

/// Values at the nodes of a panel.
pub type Values = [Complex; NODES];

/// The rule on [−1, 1].
#[derive(Debug)]
pub struct Rule {
    /// The nodes, ascending.
    pub nodes: [f64; NODES],
    pub weights: [f64; NODES],
    /// Row k takes values at the nodes to the coefficient of the Legendre polynomial of degree k.
    transform: [[f64; NODES]; NODES],
}

impl Rule {
    /// The rule, computed once.
    pub fn get() -> &'static Self {
        static RULE: OnceLock<Rule> = OnceLock::new();
        RULE.get_or_init(|| {
            let rule = gauss_legendre(NODES);
            let (nodes, weights) = (std::array::from_fn(|i| rule[i].0), std::array::from_fn(|i| rule[i].1));
            let mut transform = [[0.0; NODES]; NODES];
            for (i, &(x, weight)) in rule.iter().enumerate() {
                let (mut before, mut legendre) = (0.0, 1.0);
                for (k, row) in transform.iter_mut().enumerate() {
                    let k = k as f64;
                    row[i] = (k + 0.5) * weight * legendre;
                    (before, legendre) = (legendre, ((2.0 * k + 1.0) * x * legendre - k * before) / (k + 1.0));
                }
            }
            Self { nodes, weights, transform }
        })
    }

    /// The polynomial of the parameter with these values, at −1 and 1.
    pub fn ends(&self, values: &Values) -> [Complex; 2] {
        let coefficients = self.coefficients(values);
        let alternating = coefficients.iter().enumerate().map(|(k, c)| if k % 2 == 0 { *c } else { -c });
        [alternating.sum(), coefficients.iter().sum()]
    }

    /// The coefficients of the polynomial with these values, by Legendre polynomials of the parameter.
    pub fn coefficients(&self, values: &Values) -> Values {
        std::array::from_fn(|k| self.transform[k].iter().zip(values).map(|(t, v)| *t * v).sum())
    }
}

/// The nodes in the order of Newton's interpolation: each is farthest, by the product of the distances, from those
/// before it (Leja's order), so that divided differences do not lose digits.
fn leja_order() -> &'static [usize; NODES] {
    static ORDER: OnceLock<[usize; NODES]> = OnceLock::new();
    ORDER.get_or_init(|| {
        let nodes = &Rule::get().nodes;
        let mut order = [0; NODES];
        for k in 1..NODES {
            let product = |i: usize| order[..k].iter().map(|&j| (nodes[i] - nodes[j]).abs()).product::<f64>();
            order[k] = (0..NODES).max_by(|&a, &b| product(a).total_cmp(&product(b))).unwrap_or(0);
        }
        order
    })
}

/// The coefficients a_j of the polynomial Σ a_j ζʲ with these values at these positions, which lie about [−1, 1].
pub fn powers(positions: &Values, values: &Values) -> Values {
    let order = leja_order();
    let (z, mut a): (Values, Values) = (order.map(|i| positions[i]), order.map(|i| values[i]));
    for level in 1..NODES {
        for k in (level..NODES).rev() {
            a[k] = (a[k] - a[k - 1]) / (z[k] - z[k - level]);
        }
    }
    for level in (0..NODES - 1).rev() {
        for k in level..NODES - 1 {
            a[k] -= z[level] * a[k + 1];
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_on_a_bent_panel_is_right_next_to_it() {
        let rule = Rule::get();
        // an arc of 0.8 radians, its ends at −1 and 1
        let arc = |x: f64| Complex::new(0.0, 1.0) * (Complex::cis(0.4 * x) - 0.4_f64.cos()) / -(0.4_f64.sin());
        let position = |x: f64| -arc(-x).conj();
        let f = |z: Complex| (1.5 * z + 0.3).exp() / (z - Complex::new(0.2, 4.6));
        let positions = rule.nodes.map(position);
        let a = powers(&positions, &positions.map(f));
        for k in 0..=40 {
            let z = position(f64::from(k) / 20.0 - 1.0);
            let sum = a.iter().rev().fold(Complex::ZERO, |sum, a| sum * z + a);
            let error = (sum - f(z)).norm() / f(z).norm();
            assert!(error < 1e-12, "at {z}: {error:e}");
        }
    }

    #[test]
    fn coefficients_are_those_of_legendre_polynomials() {
        let rule = Rule::get();
        let values = rule.nodes.map(|x| Complex::new(1.5 * x * x - 0.5, x));
        for (k, c) in rule.coefficients(&values).iter().enumerate() {
            let exact = Complex::new(f64::from(k == 2), f64::from(k == 1));
            assert!((c - exact).norm() < 1e-14, "degree {k}: {c} for {exact}");
        }
    }
}

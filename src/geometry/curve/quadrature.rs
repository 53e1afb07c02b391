//! Gauss–Legendre rules on [−1, 1].
//!
//! Nodes by Newton's method on the Legendre polynomial from Tricomi's first guess; nodes and weights are right to
//! a few units of the last place for the sizes used here (up to 32).

use std::f64::consts::PI;
use std::sync::OnceLock;

/// The number of nodes of the rule for lengths and offsets.
pub(super) const NODES: usize = 16;

/// The Legendre polynomial P_n and its derivative at `x` in (−1, 1), by the three-term recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
    }
    let slope = n as f64 * (x * value - before) / (x * x - 1.0);
    (value, slope)
}

/// The nodes in ascending order, each with its weight; exact for polynomials of degree 2n − 1. `n` is at least 2.
pub(crate) fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let node = |k: usize| {
        // Tricomi 1950: the k-th zero lies near cos(π (k − ¼)/(n + ½))
        let mut x = (PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        for _ in 0..4 {
            let (value, slope) = legendre(n, x);
            x -= value / slope;
        }
        let (_, slope) = legendre(n, x);
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).rev().map(|k| if 2 * k + 1 == n { (0.0, node(k).1) } else { node(k) }).collect()
}

/// The rule of [`NODES`] nodes on [0, 1].
fn unit_rule() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss_legendre(NODES).into_iter().map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w)).collect())
}

/// ∫ f over [0, t], exact up to degree 31; relative accuracy is kept for every positive t.
pub(in crate::geometry) fn integral<T>(t: f64, f: impl Fn(f64) -> T) -> T
where
    T: std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    unit_rule().iter().map(|&(x, w)| f(t * x) * (t * w)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_for_polynomials() {
        for n in [2, 5, 12, 16, 20] {
            let rule = gauss_legendre(n);
            assert!(rule.windows(2).all(|pair| pair[0].0 < pair[1].0), "{n}: ascending");
            for degree in 0..2 * n {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree as i32)).sum();
                let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
                assert!((sum - exact).abs() < 4e-15, "{n} nodes, degree {degree}: {sum} for {exact}");
            }
        }
    }
}

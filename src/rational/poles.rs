//! The zeros of Σ w_k/(z − z_k) by the Ehrlich–Aberth iteration.
//!
//! They are the zeros of the polynomial p(z) = Σ w_k Π_{j≠k} (z − z_j), whose Newton step comes from the partial fractions
//! without forming p: p′/p = D′/D + Σ 1/(z − z_k) with D = Σ w_k/(z − z_k). All zeros are found at once; that none is
//! missing or found twice follows from p′/p = Σ 1/(z − p_j), which the tests check.

use num_complex::Complex64;

/// Most rounds; 20 to 60 suffice for degree 150.
const MOST_ROUNDS: usize = 400;
/// A step, relative to the distance from the nearest support point or to the size of the support, that is rounding.
const SETTLED: f64 = 1e-14;
/// Zeros farther away than this many sizes of the support are at infinity.
const FAR: f64 = 1e8;
/// The golden angle: start directions that no symmetry of the support repeats.
const GOLDEN: f64 = 2.399_963_229_728_653;

/// The finite zeros.
pub fn poles(support: &[Complex64], weights: &[Complex64]) -> Vec<Complex64> {
    let n = support.len();
    if n < 2 {
        return Vec::new();
    }
    let center = support.iter().sum::<Complex64>() / n as f64;
    let size = support.iter().map(|z| (z - center).norm()).fold(0.0, f64::max);
    let mut zeros: Vec<Complex64> = (1..n).map(|k| start(support, k)).collect();
    let mut is_settled = vec![false; n - 1];
    for _ in 0..MOST_ROUNDS {
        for k in 0..zeros.len() {
            if is_settled[k] {
                continue;
            }
            let Some((newton, clearance)) = newton_step(support, weights, zeros[k]) else {
                zeros[k] += size * 1e-3 * Complex64::from_polar(1.0, GOLDEN * k as f64);
                continue;
            };
            let repulsion: Complex64 = zeros
                .iter()
                .enumerate()
                .filter(|&(j, &z)| j != k && z != zeros[k])
                .map(|(_, z)| (zeros[k] - z).inv())
                .sum();
            let step = newton / (1.0 - newton * repulsion);
            if !step.is_finite() {
                is_settled[k] = true;
                continue;
            }
            zeros[k] -= step;
            let scale = clearance.min(size).max(f64::EPSILON * zeros[k].norm());
            is_settled[k] = step.norm() <= SETTLED * scale || (zeros[k] - center).norm() > 1e3 * FAR * size;
        }
        if is_settled.iter().all(|&settled| settled) {
            break;
        }
    }
    zeros.retain(|z| z.is_finite() && (z - center).norm() <= FAR * size);
    zeros
}

/// A place next to support point `k`, at half its distance from the nearest other one.
fn start(support: &[Complex64], k: usize) -> Complex64 {
    let own = support[k];
    let others = support.iter().enumerate().filter(|&(j, _)| j != k);
    let distance = others.map(|(_, z)| (z - own).norm()).fold(f64::INFINITY, f64::min);
    own + Complex64::from_polar(0.5 * distance, GOLDEN * k as f64)
}

/// p/p′ at z, and the distance of z from the nearest support point; `None` on a support point or where p′ vanishes.
fn newton_step(support: &[Complex64], weights: &[Complex64], z: Complex64) -> Option<(Complex64, f64)> {
    let (mut value, mut slope, mut sum) = (Complex64::ZERO, Complex64::ZERO, Complex64::ZERO);
    let mut clearance = f64::INFINITY;
    for (&point, &weight) in support.iter().zip(weights) {
        let difference = z - point;
        clearance = clearance.min(difference.norm());
        let inverse = difference.inv();
        value += weight * inverse;
        slope -= weight * inverse * inverse;
        sum += inverse;
    }
    let newton = value / (slope + value * sum);
    newton.is_finite().then_some((newton, clearance))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The partial fractions of Π (z − p_j) / Π (z − z_k).
    fn weights_of(support: &[Complex64], zeros: &[Complex64]) -> Vec<Complex64> {
        let weight = |&z: &Complex64| {
            let below: Complex64 = support.iter().filter(|&&other| other != z).map(|other| z - other).product();
            zeros.iter().map(|zero| z - zero).product::<Complex64>() / below
        };
        support.iter().map(weight).collect()
    }

    #[test]
    fn poles_are_the_zeros_that_the_weights_were_made_from() {
        let circle = |n: i32| (0..n).map(move |k| Complex64::from_polar(1.0, f64::from(k) * 2.0 / f64::from(n) * 3.1));
        let support: Vec<Complex64> = circle(12).collect();
        let zeros: Vec<Complex64> = circle(11).enumerate().map(|(k, z)| z * (1.02 + 0.2 * k as f64)).collect();
        let found = poles(&support, &weights_of(&support, &zeros));
        assert_eq!(found.len(), 11);
        for zero in zeros {
            let nearest = found.iter().map(|z| (z - zero).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{zero}: off by {nearest:e}");
        }
    }

    #[test]
    fn the_poles_of_a_polynomial_are_far_away() {
        // weights of polynomial interpolation: D = 1/Π (z − z_k), whose four zeros at infinity come back from rounding at
        // about ε^(−1/4)
        let support: Vec<Complex64> = (0..5).map(|k| Complex64::from_polar(1.0, 1.2 * f64::from(k))).collect();
        let nearest =
            poles(&support, &weights_of(&support, &[])).iter().map(|z| z.norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest > 500.0, "{nearest}");
    }
}

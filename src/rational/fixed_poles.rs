//! The best numerator for given poles, by linear least squares on all samples.
//!
//! The functions with the poles p_j and more support points z_k than poles are r(z) = Σ f_k ℓ_k(z) with
//! ℓ_k(z) = w_k/(z − z_k) / Σ w_i/(z − z_i), which is 1 at z_k and 0 at the other support points. Which support points
//! they are makes no difference but to rounding.

use super::function::{Rational, weights_of_poles};
use super::least_squares::GrowingQr;
use super::samples::{Sample, Samples};
use num_complex::Complex64;

/// The function with these poles and support points that has the values of `samples` at these: exactly at the support
/// points, which are among them, by `weights_of_poles`.
pub fn interpolated(samples: &Samples, support: Vec<Complex64>, poles: &[Complex64]) -> Rational {
    let value = |z: &Complex64| samples.points.iter().find(|point| point.z == *z).map(|point| point.value);
    let values = support.iter().map(|z| value(z).unwrap_or_default()).collect();
    let weights = weights_of_poles(&support, poles);
    Rational::new(support, values, weights)
}

/// The function with these poles and support points that has the least mean square error at the samples, each of which
/// counts by its [`Samples::factor`]. O(m n²) for m samples and n support points.
pub fn fitted(samples: &Samples, tolerance: f64, support: Vec<Complex64>, poles: &[Complex64]) -> Rational {
    let weights = weights_of_poles(&support, poles);
    let factors: Vec<f64> = (0..samples.points.len()).map(|k| samples.factor(k, tolerance)).collect();
    let sum =
        |z: Complex64| support.iter().zip(&weights).map(|(point, weight)| weight / (z - point)).sum::<Complex64>();
    let sums: Vec<Complex64> = samples.points.iter().map(|point| sum(point.z)).collect();
    let mut qr = GrowingQr::default();
    for (point, weight) in support.iter().zip(&weights) {
        let row = |((at, sum), factor): ((&Sample, &Complex64), &f64)| {
            if at.z == *point {
                Complex64::from(*factor)
            } else if sum.is_finite() {
                factor * weight / ((at.z - point) * sum)
            } else {
                // at another support point
                Complex64::ZERO
            }
        };
        qr.push(samples.points.iter().zip(&sums).zip(&factors).map(row).collect());
    }
    qr.push(samples.points.iter().zip(&factors).map(|(point, factor)| point.value * factor).collect());
    Rational::new(support, qr.least_squares(), weights)
}

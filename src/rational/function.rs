//! Rational functions in barycentric form.

use super::poles::poles;
use num_complex::{Complex32, Complex64};

/// Below this distance from a support point squares of it underflow; r is the value there.
const COINCIDING: f64 = 1e-150;
/// The square of that distance in single precision.
const COINCIDING_SINGLE: f32 = 1e-30;

/// z in single precision.
pub(super) fn rounded(z: Complex64) -> Complex64 {
    Complex64::new((z.re as f32).into(), (z.im as f32).into())
}

/// r(z) = Σ w_k f_k/(z − z_k) / Σ w_k/(z − z_k), of type (n − 1, n − 1) for n support points z_k.
///
/// At a support point r is the value f_k there, provided that w_k is not 0. Support points are distinct and finite.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rational {
    support: Vec<Complex64>,
    values: Vec<Complex64>,
    weights: Vec<Complex64>,
}

impl Rational {
    /// From support points, and the values and weights at them: three lists of one length.
    pub(super) fn new(support: Vec<Complex64>, values: Vec<Complex64>, weights: Vec<Complex64>) -> Self {
        debug_assert!(support.len() == values.len() && support.len() == weights.len(), "one of each");
        Self { support, values, weights }
    }

    /// The degree of numerator and denominator: one less than there are support points.
    pub fn degree(&self) -> usize {
        self.support.len().saturating_sub(1)
    }

    /// z_k.
    pub fn support(&self) -> &[Complex64] {
        &self.support
    }

    /// f_k.
    pub fn values(&self) -> &[Complex64] {
        &self.values
    }

    /// w_k.
    pub fn weights(&self) -> &[Complex64] {
        &self.weights
    }

    /// r(z). Not finite at a pole, and without support points. O(n).
    pub fn at(&self, z: Complex64) -> Complex64 {
        let (mut numerator, mut denominator) = (Complex64::ZERO, Complex64::ZERO);
        for ((&point, &value), &weight) in self.support.iter().zip(&self.values).zip(&self.weights) {
            let difference = z - point;
            if difference.norm() < COINCIDING {
                return value;
            }
            let term = weight / difference;
            numerator += term * value;
            denominator += term;
        }
        numerator / denominator
    }

    /// r(z) in single precision, as a shader computes it. Everything should be rounded: [`Self::rounded`].
    pub fn at_single(&self, z: Complex64) -> Complex64 {
        let single = |z: Complex64| Complex32::new(z.re as f32, z.im as f32);
        let (mut numerator, mut denominator) = (Complex32::ZERO, Complex32::ZERO);
        for ((&point, &value), &weight) in self.support.iter().zip(&self.values).zip(&self.weights) {
            let difference = single(z) - single(point);
            if difference.norm_sqr() < COINCIDING_SINGLE {
                return value;
            }
            let term = single(weight) / difference;
            numerator += term * single(value);
            denominator += term;
        }
        let value = numerator / denominator;
        Complex64::new(value.re.into(), value.im.into())
    }

    /// The function of support points, values and weights rounded to single precision.
    #[must_use]
    pub fn rounded(&self) -> Self {
        let [support, values, weights] =
            [&self.support, &self.values, &self.weights].map(|list| list.iter().copied().map(rounded).collect());
        Self { support, values, weights }
    }

    /// The poles in the finite plane: the zeros of the denominator, `degree` of them unless some lie at infinity. O(n²)
    /// for each of a few dozen iterations.
    pub fn poles(&self) -> Vec<Complex64> {
        poles(&self.support, &self.weights)
    }

    /// The residue at a simple pole.
    pub fn residue(&self, pole: Complex64) -> Complex64 {
        let (mut numerator, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        for ((&point, &value), &weight) in self.support.iter().zip(&self.values).zip(&self.weights) {
            let inverse = (pole - point).inv();
            numerator += weight * value * inverse;
            slope -= weight * inverse * inverse;
        }
        numerator / slope
    }
}

/// The weights for which a function with these support points has these poles, fewer than there are support points.
///
/// w_k = Π_j (z_k − p_j)/Π_{i≠k} (z_k − z_i), the residues of Π_j (z − p_j)/Π_k (z − z_k), scaled to the largest one.
pub(super) fn weights_of_poles(support: &[Complex64], poles: &[Complex64]) -> Vec<Complex64> {
    debug_assert!(poles.len() < support.len().max(1), "fewer poles than support points");
    let scaled: Vec<_> = (0..support.len()).map(|k| residue_of_ratio(support, k, poles)).collect();
    let largest = scaled.iter().map(|(_, exponent)| *exponent).max().unwrap_or(0);
    scaled.iter().map(|&(factor, exponent)| factor * f64::from(exponent - largest).exp2()).collect()
}

/// Π_j (z_k − p_j)/Π_{i≠k} (z_k − z_i) as a factor and an exponent of 2, which an f64 may not hold.
fn residue_of_ratio(support: &[Complex64], k: usize, poles: &[Complex64]) -> (Complex64, i32) {
    /// Products are rescaled beyond this exponent; a factor is far below 2^500.
    const LARGE: i32 = 256;
    let (mut product, mut exponent) = (Complex64::ONE, 0);
    let others = support.iter().enumerate().filter(|&(i, _)| i != k).map(|(_, z)| (support[k] - z).inv());
    let mut zeros = poles.iter().map(|pole| support[k] - pole);
    for inverse in others {
        product *= inverse * zeros.next().unwrap_or(Complex64::ONE);
        let size = product.re.abs().max(product.im.abs());
        for (is_beyond, power) in [(size > f64::from(LARGE).exp2(), LARGE), (size < f64::from(-LARGE).exp2(), -LARGE)] {
            if is_beyond {
                product *= f64::from(-power).exp2();
                exponent += power;
            }
        }
    }
    (product, exponent)
}

//! The blob of the paper's section 5.2: the image of the unit disk under an
//! elementary function,
//!
//! g⁻¹(z) = (4z² + 4z + 1)/40 + 50/(12z² + 25z + 25) − ((3 − 5i)/6) sin(11z/10) cos(z/2) + log((20z² − 45 + 36i)/30).
//!
//! The logarithm's argument stays in the upper half plane for |z| ≤ 1, so the
//! principal branch is continuous there. Because the disk is mapped to the
//! blob, harmonic measure seen from [`from_disk`]`(0)` is the angle over 2π.

use std::f64::consts::TAU;

use glam::DVec2;

use super::Complex;

/// g⁻¹(z) for `|z| ≤ 1`, the conformal map of the unit disk onto the blob.
pub fn from_disk(z: Complex) -> Complex {
    let real = Complex::from;
    let square = z.square();
    let polynomial = (1.0 / 40.0) * (4.0 * square + 4.0 * z + Complex::ONE);
    let rational = real(50.0) / (12.0 * square + 25.0 * z + real(25.0));
    let wave = (1.0 / 6.0) * (Complex::new(3.0, -5.0) * (1.1 * z).sin() * (0.5 * z).cos());
    let logarithm = ((1.0 / 30.0) * (20.0 * square + Complex::new(-45.0, 36.0))).ln();
    polynomial + rational - wave + logarithm
}

/// The boundary point with harmonic measure `omega`, counted counter-clockwise
/// from g⁻¹(1) and seen from g⁻¹(0).
pub fn boundary(omega: f64) -> DVec2 {
    from_disk(Complex::cis(TAU * omega)).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_given_points_of_the_disk_go_to_the_given_points_of_the_blob() {
        // 60-digit values, rounded.
        let one = from_disk(Complex::ONE) - Complex::new(1.019_500_793_516_213_7, 2.829_540_689_356_530_3);
        let zero = from_disk(Complex::ZERO) - Complex::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
        assert!(one.abs() < 1e-15, "{one:?}");
        assert!(zero.abs() < 1e-15, "{zero:?}");
    }

    #[test]
    fn the_map_is_analytic() {
        // Cauchy–Riemann by central differences of step 1e-5: error about 1e-10.
        let step = 1e-5;
        for k in 0..40 {
            let z = 0.025 * f64::from(k) * Complex::cis(0.7 * f64::from(k));
            let along = |d: Complex| (0.5 / step) * (from_disk(z + step * d) - from_disk(z - step * d));
            let (dx, dy) = (along(Complex::ONE), along(Complex::I));
            assert!((dy - Complex::I * dx).abs() < 1e-8, "at {z:?}");
            assert!(dx.abs() > 1e-3, "the derivative has no zero: {dx:?} at {z:?}");
        }
    }
}

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

use super::{Complex, point};
use crate::geometry::Jet;

/// g⁻¹(z) for `|z| ≤ 1`, the conformal map of the unit disk onto the blob.
pub fn from_disk(z: Complex) -> Complex {
    let real = Complex::from;
    let square = z * z;
    let polynomial = (1.0 / 40.0) * (4.0 * square + 4.0 * z + Complex::ONE);
    let rational = real(50.0) / (12.0 * square + 25.0 * z + real(25.0));
    let wave = (1.0 / 6.0) * (Complex::new(3.0, -5.0) * (1.1 * z).sin() * (0.5 * z).cos());
    let logarithm = ((1.0 / 30.0) * (20.0 * square + Complex::new(-45.0, 36.0))).ln();
    polynomial + rational - wave + logarithm
}

/// The derivative of g⁻¹; it has no zero in the closed disk.
fn derivative(z: Complex) -> Complex {
    let real = Complex::from;
    let square = z * z;
    let quadratic = 12.0 * square + 25.0 * z + real(25.0);
    let rational = -(50.0 * (24.0 * z + real(25.0)) / (quadratic * quadratic));
    let wave = 1.1 * ((1.1 * z).cos() * (0.5 * z).cos()) - 0.5 * ((1.1 * z).sin() * (0.5 * z).sin());
    let logarithm = 40.0 * z / (20.0 * square + Complex::new(-45.0, 36.0));
    0.1 * (2.0 * z + Complex::ONE) + rational - (1.0 / 6.0) * (Complex::new(3.0, -5.0) * wave) + logarithm
}

/// The second derivative of g⁻¹.
fn second_derivative(z: Complex) -> Complex {
    let real = Complex::from;
    let square = z * z;
    let quadratic = 12.0 * square + 25.0 * z + real(25.0);
    let slope = 24.0 * z + real(25.0);
    let rational = 50.0 * (2.0 * slope * slope - 24.0 * quadratic) / (quadratic * quadratic * quadratic);
    let wave = 1.46 * ((1.1 * z).sin() * (0.5 * z).cos()) + 1.1 * ((1.1 * z).cos() * (0.5 * z).sin());
    let inner = 20.0 * square + Complex::new(-45.0, 36.0);
    let logarithm = 40.0 / inner - 1600.0 * square / (inner * inner);
    real(0.2) + rational + (1.0 / 6.0) * (Complex::new(3.0, -5.0) * wave) + logarithm
}

/// Newton's method starts at the nearest of the images of the center and of points on four circles and 64 rays.
/// With these starts it converged for each of 2000 points spread over the disk up to |z| = 0.9999.
const START_RADII: [f64; 4] = [0.3, 0.6, 0.85, 0.97];
const START_RAYS: u32 = 64;
/// Five steps are enough except close to the boundary.
const NEWTON_STEPS: u32 = 60;
/// The value of |g⁻¹(z) − w| that counts as 0; |g⁻¹′| lies between 0.07 and 12, the blob's size is 8.
const RESIDUAL: f64 = 1e-13;

/// g(w), the inverse of [`from_disk`], for `w` inside the blob; `None` outside. By Newton's method.
pub fn to_disk(w: Complex) -> Option<Complex> {
    let residual = |z: Complex| from_disk(z) - w;
    let ray = |k: u32| Complex::cis(TAU * f64::from(k) / f64::from(START_RAYS));
    let starts = START_RADII.into_iter().flat_map(|radius| (0..START_RAYS).map(move |k| radius * ray(k)));
    let size = |z: &Complex| residual(*z).norm();
    let mut z = starts.chain([Complex::ZERO]).min_by(|a, b| size(a).total_cmp(&size(b)))?;
    for _ in 0..NEWTON_STEPS {
        let (now, mut step) = (residual(z), residual(z) / derivative(z));
        if now.norm() <= RESIDUAL {
            break;
        }
        // the function is known only in the closed disk
        while (z - step).norm() > 1.0 || residual(z - step).norm() > now.norm() {
            step = 0.5 * step;
            if step.norm() < f64::EPSILON {
                return None;
            }
        }
        z -= step;
    }
    (size(&z) <= RESIDUAL && z.norm() < 1.0).then_some(z)
}

/// The boundary point with harmonic measure `omega`, counted counter-clockwise
/// from g⁻¹(1) and seen from g⁻¹(0).
pub fn boundary(omega: f64) -> DVec2 {
    point(from_disk(Complex::cis(TAU * omega)))
}

/// [`boundary`] with its derivatives by `omega`.
pub fn boundary_jet(omega: f64) -> Jet {
    let z = Complex::cis(TAU * omega);
    // dz/dω = 2πi z
    let along = TAU * (Complex::I * z);
    let (first, second) = (derivative(z), second_derivative(z));
    Jet {
        position: boundary(omega),
        first: point(first * along),
        second: point(second * along * along - TAU * TAU * (first * z)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_given_points_of_the_disk_go_to_the_given_points_of_the_blob() {
        // 60-digit values, rounded
        let one = from_disk(Complex::ONE) - Complex::new(1.019_500_793_516_213_7, 2.829_540_689_356_530_3);
        let zero = from_disk(Complex::ZERO) - Complex::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
        assert!(one.norm() < 1e-15, "{one:?}");
        assert!(zero.norm() < 1e-15, "{zero:?}");
    }

    #[test]
    fn every_point_of_the_disk_is_found_again() {
        for k in 0..2000 {
            let radius = (f64::from(k) / 2000.0).sqrt().min(0.9999);
            let z = radius * Complex::cis(2.399_963 * f64::from(k));
            let found = to_disk(from_disk(z)).unwrap_or(Complex::new(f64::NAN, 0.0));
            // the residual over the least derivative
            assert!((found - z).norm() < 2e-12, "{z:?} → {found:?}");
        }
        let outwards = derivative(Complex::ONE);
        let beside = from_disk(Complex::ONE) + (1e-3 / outwards.norm()) * outwards;
        for outside in [Complex::new(-40.0, 0.0), beside, Complex::ZERO] {
            assert_eq!(to_disk(outside), None, "{outside:?}");
        }
    }

    #[test]
    fn the_map_is_analytic() {
        // Cauchy–Riemann by central differences of step 1e-5: error about 1e-10.
        let step = 1e-5;
        for k in 0..40 {
            let z = 0.025 * f64::from(k) * Complex::cis(0.7 * f64::from(k));
            let along = |d: Complex| (0.5 / step) * (from_disk(z + step * d) - from_disk(z - step * d));
            let (dx, dy) = (along(Complex::ONE), along(Complex::I));
            assert!((dy - Complex::I * dx).norm() < 1e-8, "at {z:?}");
            assert!((dx - derivative(z)).norm() < 1e-8, "at {z:?}: {dx:?}");
            assert!((0.07..12.0).contains(&dx.norm()), "the derivative has no zero: {dx:?} at {z:?}");
        }
    }

    #[test]
    fn the_derivatives_of_the_boundary_are_those_of_its_formula() {
        let step = 1e-5;
        for k in 0..100 {
            let omega = f64::from(k) / 100.0;
            let [a, here, b] = [omega - step, omega, omega + step].map(boundary_jet);
            let first = (b.position - a.position) / (2.0 * step);
            let second = (b.first - a.first) / (2.0 * step);
            // |z′| is below 80, |z″| below 4,000; central differences of order 2
            assert!(first.distance(here.first) < 1e-4, "ω = {omega}: {first} for {}", here.first);
            assert!(second.distance(here.second) < 1e-2, "ω = {omega}: {second} for {}", here.second);
        }
    }
}

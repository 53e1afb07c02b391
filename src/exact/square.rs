//! The square [−1, 1]² and the unit disk: the lemniscate sine.
//!
//! Schwarz–Christoffel takes the disk to the square by ∫ dζ/√(1 + ζ⁴). Turned by 45° its inverse is
//! sl, the inverse of ∫ dζ/√(1 − ζ⁴), whose square has the corners ±ϖ/2, ±iϖ/2; so with K = ϖ/√2 the
//! complete elliptic integral of k² = ½,
//!
//! g(z) = e^{−iπ/4} sl(e^{iπ/4} K z/2), g(0) = 0, g(1) = 1.
//!
//! Abramowitz & Stegun (1964): 16.4 (Jacobi's functions by the arithmetic-geometric
//! mean), 18.14 (lemniscatic case). sl = sd(√2 ·)/√2 and cl = cn(√2 ·), k² = ½.

use super::Complex;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, SQRT_2};

/// K(k) at k² = ½.
const QUARTER_PERIOD: f64 = 1.854_074_677_301_371_9;

/// Steps of the arithmetic-geometric mean of 1 and √½; c₄ is 3e-12, c₅ is 1e-24.
const STEPS: usize = 5;

/// Jacobi's sn, cn and dn of `u` at k² = ½.
fn jacobi(u: f64) -> [f64; 3] {
    let (mut a, mut b) = (1.0, FRAC_1_SQRT_2);
    let mut ratios = [0.0; STEPS];
    for ratio in &mut ratios {
        let (mean, half) = (0.5 * (a + b), 0.5 * (a - b));
        (a, b) = (mean, (a * b).sqrt());
        *ratio = half / a;
    }
    let last = f64::from(1 << STEPS) * a * u;
    let amplitude = ratios.iter().rev().fold(last, |phi, ratio| 0.5 * (phi + (ratio * phi.sin()).asin()));
    let (sn, cn) = amplitude.sin_cos();
    [sn, cn, (1.0 - 0.5 * sn * sn).sqrt()]
}

/// sl and cl of a real number.
fn lemniscate(x: f64) -> [f64; 2] {
    let [sn, cn, dn] = jacobi(SQRT_2 * x);
    [FRAC_1_SQRT_2 * sn / dn, cn]
}

/// g(z), the conformal map of the square onto the unit disk with g(0) = 0 and g(1) = 1, in the closed
/// square without its corners. By sl(x + iy) = (sl x + i cl x sl y cl y)/(cl y − i sl x sl y cl x).
pub fn to_disk(z: Complex) -> Complex {
    let eighth = Complex::new(FRAC_1_SQRT_2, FRAC_1_SQRT_2);
    let Complex { re: x, im: y } = (0.5 * QUARTER_PERIOD) * (eighth * z);
    let ([sl_x, cl_x], [sl_y, cl_y]) = (lemniscate(x), lemniscate(y));
    let sine = Complex::new(sl_x, cl_x * sl_y * cl_y) / Complex::new(cl_y, -sl_x * sl_y * cl_x);
    eighth.conj() * sine
}

/// The argument in `[0, 2π]` of g at the boundary point at the fraction `s` in `[0, 1]` of the perimeter,
/// counter-clockwise from 1.
///
/// At the argument φ from the middle of a side, |dz/dφ| is 1/√(2 cos 2φ) up to a factor; √2 sin φ is therefore
/// sn of the arc length from that middle, scaled so that half a side is K.
pub fn boundary_angle(s: f64) -> f64 {
    let side = (4.0 * s).round();
    let [sn, ..] = jacobi(2.0 * QUARTER_PERIOD * (4.0 * s - side));
    side * FRAC_PI_2 + (FRAC_1_SQRT_2 * sn).asin()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn jacobis_functions_solve_their_differential_equation() {
        // sn′ = cn dn; central differences of step 1e-5 are right to 1e-10.
        let step = 1e-5;
        for k in -40..=40 {
            let u = 0.1 * f64::from(k);
            let [_, cn, dn] = jacobi(u);
            let slope = (jacobi(u + step)[0] - jacobi(u - step)[0]) / (2.0 * step);
            assert!((slope - cn * dn).abs() < 1e-9, "at {u}: {slope} for {}", cn * dn);
        }
        let [sn, cn, dn] = jacobi(QUARTER_PERIOD);
        assert!((sn - 1.0).abs() < 1e-15 && cn.abs() < 1e-15 && (dn - FRAC_1_SQRT_2).abs() < 1e-15);
    }

    #[test]
    fn the_map_is_analytic_and_keeps_the_squares_symmetries() {
        assert_eq!(to_disk(Complex::ZERO), Complex::ZERO);
        let step = 1e-5;
        for k in 1..40 {
            let z = 0.024 * f64::from(k) * Complex::cis(1.9 * f64::from(k));
            let along = |d: Complex| (0.5 / step) * (to_disk(z + step * d) - to_disk(z - step * d));
            let (dx, dy) = (along(Complex::ONE), along(Complex::I));
            assert!((dy - Complex::I * dx).norm() < 1e-8, "Cauchy–Riemann at {z:?}");
            assert!((to_disk(Complex::I * z) - Complex::I * to_disk(z)).norm() < 1e-15, "a quarter turn at {z:?}");
            assert!((to_disk(z.conj()) - to_disk(z).conj()).norm() < 1e-15, "a reflection at {z:?}");
        }
    }

    #[test]
    fn the_boundary_goes_to_the_circle_by_its_angle() {
        for k in 0..400 {
            let s = f64::from(k) / 400.0;
            // a perimeter of 8, from (1, 0)
            let along = 8.0 * s;
            let z = match along {
                l if l < 1.0 => Complex::new(1.0, l),
                l if l < 3.0 => Complex::new(2.0 - l, 1.0),
                l if l < 5.0 => Complex::new(-1.0, 4.0 - l),
                l if l < 7.0 => Complex::new(l - 6.0, -1.0),
                l => Complex::new(1.0, l - 8.0),
            };
            let angle = boundary_angle(s);
            assert!((0.0..2.0 * PI).contains(&angle), "{angle}");
            if k % 100 == 50 {
                continue; // a corner: 0/0, but its angle is known
            }
            let error = (to_disk(z) - Complex::cis(angle)).norm();
            // 1/100 of a side from a corner, sl's denominator is 2e-2
            assert!(error < 1e-13, "s = {s}: {error:e}");
        }
        for k in 0..4 {
            let angle = boundary_angle(0.125 + 0.25 * f64::from(k));
            assert!((angle - (0.25 + 0.5 * f64::from(k)) * PI).abs() < 1e-7, "corner {k}: {angle}");
        }
        assert_eq!((boundary_angle(0.0), boundary_angle(1.0)), (0.0, 2.0 * PI));
    }
}

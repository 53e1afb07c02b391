//! Harmonic measure of a rectangle's sides from its center, by separation of variables.

use std::f64::consts::{FRAC_PI_2, PI};

/// The measure of the part of a side from its start to the share `u` in [0, 1] of its length. `ratio` is the length of
/// the adjacent sides over that of this one:
///
/// Σ (−1)ʲ 2 sin²(nπu/2) / (nπ cosh(nπ ratio/2)), n = 2j + 1.
///
/// Its absolute error is some 1e-16; for a side that is a short end (ratio ≥ 1), so is its relative error. The number
/// of terms is 12/ratio.
pub fn side_measure(ratio: f64, u: f64) -> f64 {
    let first = FRAC_PI_2 * ratio;
    let last = (first + DECAY).min(MOST);
    let (mut sum, mut n, mut sign) = (0.0, 1.0, 1.0);
    while n * first < last {
        let sine = (n * FRAC_PI_2 * u).sin();
        sum += sign * 2.0 * sine * sine / (n * PI * (n * first).cosh());
        n += 2.0;
        sign = -sign;
    }
    sum
}

/// cosh overflows beyond it, and the measure underflows.
const MOST: f64 = 700.0;
/// Terms smaller than the first one by the factor e^−38 = 3e-17 are left out.
const DECAY: f64 = 38.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::square;
    use std::f64::consts::TAU;

    #[test]
    fn ends_have_the_known_measures() {
        // Bornemann et al., The SIAM 100-Digit Challenge, problem 10; and the same series for 3×1
        for (ratio, both) in [(10.0, 3.837_587_979_251_226_1e-7), (3.0, 0.022_873_301_501_334_33)] {
            let found = 2.0 * side_measure(ratio, 1.0);
            assert!((found / both - 1.0).abs() < 1e-15, "{ratio}: {found} for {both}");
        }
    }

    #[test]
    fn the_sides_make_up_the_boundary() {
        for ratio in [0.1, 0.5, 1.0, 3.0] {
            let total = 2.0 * (side_measure(ratio, 1.0) + side_measure(1.0 / ratio, 1.0));
            assert!((total - 1.0).abs() < 1e-15, "{ratio}: {total}");
        }
    }

    #[test]
    fn the_square_is_that_of_the_elliptic_function() {
        for k in 0..=100 {
            let u = f64::from(k) / 100.0;
            // the elliptic function counts from the middle of a side, which is an eighth of the boundary before its end
            let angle = square::boundary_angle(0.125 + 0.25 * u) / TAU - 0.125;
            let found = side_measure(1.0, u);
            assert!((found - angle).abs() < 1e-15, "u = {u}: {found} for {angle}");
        }
    }
}

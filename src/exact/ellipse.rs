//! The ellipse seen from its center: the boundary values of its map to the disk as a series.
//!
//! The map of the ellipse with half axes a, b and foci ±c is √k sn(2K/π · arcsin(z/c)) with the nome p², where
//! p = (a − b)/(a + b). The Fourier series of log sn (Abramowitz & Stegun 1964, 16.23) gives the argument of the image
//! of a cos t + i b sin t:
//!
//! θ(t) = t + Σ (2/n) (−1)ⁿ pⁿ/(1 + p²ⁿ) sin 2nt.

/// The argument of the image of a cos `t` + i b sin `t` under the map to the unit disk that takes 0 to 0 and a to 1;
/// over 2π it is the harmonic measure from a. `ratio` is a/b > 0; `t` may be any angle. Right to rounding; the number
/// of terms grows with the ratio (73 for 4).
pub fn boundary_angle(ratio: f64, t: f64) -> f64 {
    let p = (ratio - 1.0) / (ratio + 1.0);
    let (mut sum, mut power, mut n) = (t, 1.0_f64, 0.0);
    while power.abs() > f64::EPSILON {
        power *= -p;
        n += 1.0;
        sum += 2.0 / n * power / (1.0 + power * power) * (2.0 * n * t).sin();
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Complex;
    use std::f64::consts::{FRAC_PI_2, TAU};

    /// ∫ zᵏ dω = 0 for every k ≥ 1, since the center is 0. θ′ by differences of order 4, right to 1e-10; the trapezoidal
    /// rule is exact here.
    #[test]
    fn moments_of_the_measure_are_those_of_the_center() {
        let (count, h) = (512, 1e-3);
        for ratio in [0.5, 1.0, 2.0, 4.0] {
            let theta = |t: f64| boundary_angle(ratio, t);
            let slope =
                |t: f64| (theta(t - 2.0 * h) - theta(t + 2.0 * h) + 8.0 * (theta(t + h) - theta(t - h))) / (12.0 * h);
            let mut moments = [Complex::ZERO; 4];
            for t in (0..count).map(|j| TAU * f64::from(j) / f64::from(count)) {
                let z = Complex::new(ratio * t.cos(), t.sin());
                let mut power = Complex::ONE;
                for moment in &mut moments {
                    power *= z;
                    *moment += slope(t) / f64::from(count) * power;
                }
            }
            for (k, moment) in moments.iter().enumerate() {
                assert!(moment.norm() < 1e-7, "ratio {ratio}, moment {}: {moment}", k + 1);
            }
        }
    }

    #[test]
    fn quarters_of_the_ellipse_have_equal_measure() {
        for k in 0..5 {
            let t = FRAC_PI_2 * f64::from(k);
            assert!((boundary_angle(4.0, t) - t).abs() < 1e-14);
        }
    }
}

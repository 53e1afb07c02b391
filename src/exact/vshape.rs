//! The V of the paper's section 1.2, on which crowding is extreme.
//!
//! g = h₁ ∘ h₂ maps it to the unit disk, with h₂(z) = (i/4)(1 − √(8iz − 7)),
//! h₁(u) = tanh(u artanh r)/r and r = 1 − e^{−12.5π}; g(−i) = 0, g(1 + i) = 1.
//! Near the tips |g| differs from 1 by 1e-17, so everything here is computed in
//! the strip coordinate c = a + ib = h₂(z) artanh r, where nothing is crowded:
//! |g| = 1 means cos 2b = κ cosh 2a with κ = (1 − r²)/(1 + r²).

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::{Complex, arg_sinh, complex, point, sqrt};
use crate::geometry::Jet;

/// ε = 1 − r = e^{−12.5π}.
fn epsilon() -> f64 {
    (-12.5 * PI).exp()
}

/// artanh r = ½ ln((2 − ε)/ε), half the length of the strip.
fn half_length() -> f64 {
    let epsilon = epsilon();
    0.5 * ((2.0 - epsilon) / epsilon).ln()
}

/// The strip coordinate c = h₂(z) artanh r.
fn strip(z: Complex) -> Complex {
    let root = sqrt(8.0 * (Complex::I * z) - Complex::from(7.0));
    (0.25 * half_length()) * (Complex::I * (Complex::ONE - root))
}

/// z = ((1 + 4iu)² + 7)/(8i), the inverse of h₂.
fn from_half_plane(u: Complex) -> Complex {
    let root = Complex::ONE + 4.0 * (Complex::I * u);
    -0.125 * (Complex::I * (root * root + Complex::from(7.0)))
}

/// g(z), the conformal map of the V onto the unit disk.
///
/// In the tips the result is only known to lie close to the circle; use
/// [`harmonic_measure`] there.
pub fn to_disk(z: Complex) -> Complex {
    (1.0 / (1.0 - epsilon())) * strip(z).tanh()
}

/// The boundary point with parameter `t`, taken modulo 4; counter-clockwise.
///
/// `t = 0` is the tip 1 + i and `t = 2` the other tip, −1 + i; the speed is
/// bounded away from 0. As a function of `t` it is only C¹ at `t = 1` and `t = 3`, in the middle of the V;
/// [`around_right_tip`] and [`around_left_tip`] are its analytic parts.
pub fn boundary(t: f64) -> DVec2 {
    let t = t.rem_euclid(4.0);
    match t {
        1.0..3.0 => place(2.0 - t, -1.0),
        0.0..1.0 => place(t, 1.0),
        _ => place(t - 4.0, 1.0),
    }
}

/// The boundary around the tip 1 + i, at `s = 0`, with derivatives by `s` in [−1, 1]; counter-clockwise.
pub fn around_right_tip(s: f64) -> Jet {
    jet(s, 1.0)
}

/// The boundary around the tip −1 + i, at `s = 0`, with derivatives by `s` in [−1, 1]; clockwise.
pub fn around_left_tip(s: f64) -> Jet {
    jet(s, -1.0)
}

/// 1 − T with T = tanh(2 artanh r).
fn one_minus_t() -> f64 {
    let r = 1.0 - epsilon();
    epsilon().powi(2) / (1.0 + r * r)
}

/// The boundary point at `s` from the tip of this side. With d = artanh r − |a| = s² artanh r, the equation of the
/// boundary reads sin² b = sinh d (e^{−d} − (1 − T) cosh d), where nothing cancels.
fn place(s: f64, side: f64) -> DVec2 {
    let half_length = half_length();
    let d = s * s * half_length;
    let b = (d.sinh() * ((-d).exp() - one_minus_t() * d.cosh())).max(0.0).sqrt().asin();
    let a = side * (1.0 - d / half_length);
    point(from_half_plane(Complex::new(a, b.copysign(s) / half_length)))
}

/// [`place`] with its derivatives by `s`.
///
/// g = sin b is odd in s, g² = G(d), G′ = e^{−2d} − (1 − T) cosh 2d; so g′ = λ G′ ρ with λ = artanh r and
/// ρ = s/g = (λ G/d)^{−½}, which is regular at the tip.
fn jet(s: f64, side: f64) -> Jet {
    let (length, k) = (half_length(), one_minus_t());
    let d = s * s * length;
    let decay = (-2.0 * d).exp();
    let [first, second] = [decay - k * (2.0 * d).cosh(), -2.0 * (decay + k * (2.0 * d).sinh())];
    let [mean, mean_slope] = mean_of_square(d);
    let rho = 1.0 / (length * mean).sqrt();
    let rho_slope = -(length * length) * mean_slope * s * rho * rho * rho;
    let sin = s / rho;
    let [sin_1, sin_2] = [length * first * rho, length * (2.0 * length * s * second * rho + first * rho_slope)];
    let cos = (1.0 - sin * sin).sqrt();
    let b_1 = sin_1 / cos;
    let b_2 = (sin_2 + sin * b_1 * b_1) / cos;
    let u = Complex::new(side * (1.0 - s * s), sin.asin() / length);
    let [u_1, u_2] = [Complex::new(-2.0 * side * s, b_1 / length), Complex::new(-2.0 * side, b_2 / length)];
    // z′(u) = 1 + 4iu
    let slope = Complex::ONE + 4.0 * (Complex::I * u);
    Jet {
        position: place(s, side),
        first: point(slope * u_1),
        second: point(slope * u_2 + 4.0 * (Complex::I * u_1 * u_1)),
    }
}

/// Below this d, G/d is summed as a power series: its derivative would cancel. The terms with 1 − T are below 1e-34.
const NEAR_TIP: f64 = 0.5;

/// G(d)/d and its derivative by d, with G = (1 − e^{−2d})/2 − ½ (1 − T) sinh 2d.
fn mean_of_square(d: f64) -> [f64; 2] {
    if d >= NEAR_TIP {
        let k = one_minus_t();
        let square = 0.5 * (-(-2.0 * d).exp_m1() - k * (2.0 * d).sinh());
        let slope = (-2.0 * d).exp() - k * (2.0 * d).cosh();
        return [square / d, (slope - square / d) / d];
    }
    // Σ (−2)^n d^n / (n + 1)!, by Horner's rule for the value and the slope together
    let (mut value, mut slope) = (0.0, 0.0);
    for n in (0..SERIES).rev() {
        let ratio = -2.0 / f64::from(n + 2);
        slope = ratio * (value + d * slope);
        value = 1.0 + ratio * d * value;
    }
    [value, slope]
}

/// Terms of the series: the first one left out is below 1/22! at d = ½.
const SERIES: u32 = 20;

/// Whether `x` is inside: cos 2b > κ cosh 2a.
pub fn contains(x: DVec2) -> bool {
    let Complex { re: a, im: b } = strip(complex(x));
    let r = 1.0 - epsilon();
    let kappa = epsilon() * (1.0 + r) / (1.0 + r * r);
    b.abs() < 0.5 * PI && (2.0 * b).cos() > kappa * (2.0 * a).cosh()
}

/// The harmonic measure, seen from the interior point `x`, of the boundary from
/// 1 + i counter-clockwise to the boundary point `y`; in `[0, 1)`.
///
/// The disk's measure is (2 arg(g(y) − g(x)) − arg g(y))/2π up to a constant;
/// in the strip that is `(2 arg sinh(c − c_x) − arg sinh 2c)/2π`. Absolute error
/// about 1e-15 as long as `y` and `x` are known to that.
pub fn harmonic_measure(x: DVec2, y: DVec2) -> f64 {
    let (from, to) = (strip(complex(x)), strip(complex(y)));
    let tip = Complex::from(half_length());
    let turn = |end: f64, start: f64| {
        let turn = (end - start).rem_euclid(TAU);
        // a rounding error below the start counts as the start, not as a full turn
        if TAU - turn < 1e-13 { 0.0 } else { turn }
    };
    let around_x = turn(arg_sinh(to - from), arg_sinh(tip - from));
    let around_middle = turn(arg_sinh(2.0 * to), arg_sinh(2.0 * tip));
    (2.0 * around_x - around_middle) / TAU
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_constraints_of_the_paper_hold() {
        assert!(to_disk(-Complex::I).norm() < 1e-15);
        assert!((to_disk(Complex::new(1.0, 1.0)) - Complex::ONE).norm() < 1e-15);
        assert_eq!(boundary(0.0), DVec2::new(1.0, 1.0));
        assert!(boundary(2.0).distance(DVec2::new(-1.0, 1.0)) < 1e-15);
    }

    #[test]
    fn the_boundary_is_the_preimage_of_the_circle() {
        for k in 0..4000 {
            let z = boundary(f64::from(k) / 1000.0);
            let radius = to_disk(complex(z)).norm();
            // tanh amplifies an error of b by at most 1; h₂ and its inverse add a few roundings.
            assert!((radius - 1.0).abs() < 2e-14, "t = {k}/1000: |g| − 1 = {:e}", radius - 1.0);
        }
    }

    #[test]
    fn the_inside_ends_at_the_boundary() {
        for k in 0..400 {
            let t = f64::from(k) / 100.0;
            let (y, along) = (boundary(t), boundary(t + 1e-6) - boundary(t - 1e-6));
            let inwards = 1e-6 * along.perp().normalize();
            assert!(contains(y + inwards) && !contains(y - inwards), "t = {t}");
        }
    }

    #[test]
    fn harmonic_measure_from_the_centre_is_the_angle() {
        let center = DVec2::new(0.0, -1.0);
        for k in 1..400 {
            let y = boundary(f64::from(k) / 100.0);
            let angle = to_disk(complex(y)).arg().rem_euclid(TAU) / TAU;
            let omega = harmonic_measure(center, y);
            // on the whole right arm the angle is close to 0 or 1, and may round to either
            let error = (omega - angle + 0.5).rem_euclid(1.0) - 0.5;
            assert!(error.abs() < 1e-14, "t = {k}/100: {omega} against {angle}");
        }
    }

    #[test]
    fn the_two_parts_are_the_boundary_with_its_derivatives() {
        let step = 1e-4;
        for k in 0..=200 {
            let s = f64::from(k) / 100.0 - 1.0;
            for (part, t) in [(around_right_tip as fn(f64) -> Jet, s), (around_left_tip, 2.0 - s)] {
                assert!(part(s).position.distance(boundary(t)) < 1e-15);
                let [a, here, b] = [s - step, s, s + step].map(part);
                // differences of order 2; the third derivatives are below 200
                let error = ((b.position - a.position) / (2.0 * step)).distance(here.first);
                assert!(error < 3e-7, "s = {s}: {error:e}");
                let error = ((b.first - a.first) / (2.0 * step)).distance(here.second);
                assert!(error < 3e-6, "s = {s}: {error:e}");
            }
        }
    }

    /// On both sides of d = ½ the power series and the closed form agree.
    #[test]
    fn the_series_at_the_tip_is_the_closed_form() {
        let [below, above] = [NEAR_TIP * (1.0 - 1e-15), NEAR_TIP].map(mean_of_square);
        assert!((below[0] - above[0]).abs() < 4e-16 && (below[1] - above[1]).abs() < 4e-15, "{below:?}, {above:?}");
    }
}

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
/// bounded away from 0. With d = artanh r − |a| = s², the equation of the boundary reads
/// sin² b = sinh d (e^{−d} − (1 − T) cosh d), T = tanh(2 artanh r), where nothing cancels.
pub fn boundary(t: f64) -> DVec2 {
    let t = t.rem_euclid(4.0);
    let half_length = half_length();
    // the distance from the quarter's tip
    let from_tip = if t <= 2.0 { t.min(2.0 - t) } else { (t - 2.0).min(4.0 - t) };
    let d = from_tip * from_tip * half_length;
    let r = 1.0 - epsilon();
    let one_minus_t = epsilon().powi(2) / (1.0 + r * r);
    let b = (d.sinh() * ((-d).exp() - one_minus_t * d.cosh())).max(0.0).sqrt().asin();
    let right = !(1.0..3.0).contains(&t);
    let a = if right { 1.0 - d / half_length } else { d / half_length - 1.0 };
    let b = if t <= 2.0 { b } else { -b } / half_length;
    point(from_half_plane(Complex::new(a, b)))
}

/// (1 − e^{−x})/x and its first two derivatives, x ≥ 0.
fn mean_decay(x: f64) -> [f64; 3] {
    if x < 0.5 {
        // Σ (−x)^k/(k + 1)! and its derivatives; 20 terms leave 1e-25
        let mut sums = [0.0; 3];
        let mut term = 1.0;
        for k in 0..20 {
            let k = f64::from(k);
            // `term` is (−1)^k x^k/(k + 1)!; its derivatives follow from the next two coefficients
            sums[0] += term;
            sums[1] -= term * (k + 1.0) / (k + 2.0);
            sums[2] += term * (k + 1.0) / (k + 3.0);
            term *= -x / (k + 2.0);
        }
        return sums;
    }
    let decay = (-x).exp();
    let mean = (1.0 - decay) / x;
    let slope = (decay - mean) / x;
    [mean, slope, -(decay + 2.0 * slope) / x]
}

/// sinh(x)/x and its first two derivatives up to 1 %, which is enough: it is multiplied by 1e-34.
fn mean_growth(x: f64) -> [f64; 3] {
    if x < 0.5 {
        return [1.0 + x * x / 6.0, x / 3.0, 1.0 / 3.0];
    }
    let mean = x.sinh() / x;
    let slope = (x.cosh() - mean) / x;
    [mean, slope, (x.sinh() - 2.0 * slope) / x]
}

/// The right arm with its derivatives by s in [−1, 1]: [`boundary`] at t = s, analytic in all of the interval.
///
/// sin b = s √(λ h) with λ = artanh r, h = (1 − e^{−x})/x − (1 − T) sinh(x)/x, x = 2λs².
pub fn right_arm(s: f64) -> Jet {
    arm(s, 1.0)
}

/// The left arm, the right one turned by 180° in the strip: [`boundary`] at t = 2 + s, s in [−1, 1].
pub fn left_arm(s: f64) -> Jet {
    arm(s, -1.0)
}

fn arm(s: f64, sign: f64) -> Jet {
    let length = half_length();
    let r = 1.0 - epsilon();
    let one_minus_t = epsilon().powi(2) / (1.0 + r * r);
    let x = 2.0 * length * s * s;
    let (decay, growth) = (mean_decay(x), mean_growth(x));
    let [h, by_x, by_x_twice]: [f64; 3] = std::array::from_fn(|k| decay[k] - one_minus_t * growth[k]);
    let rate = 4.0 * length * s;
    let [h1, h2] = [by_x * rate, by_x_twice * rate * rate + 4.0 * length * by_x];
    let root = (length * h).sqrt();
    let root1 = 0.5 * length * h1 / root;
    let root2 = (0.5 * length * h2 - root1 * root1) / root;
    let [q, q1, q2] = [s * root, root + s * root1, 2.0 * root1 + s * root2];
    let b = q.clamp(-1.0, 1.0).asin();
    let b1 = q1 / b.cos();
    let b2 = q2 / b.cos() + b1 * b1 * b.tan();
    let u = sign * Complex::new(1.0 - s * s, b / length);
    let u1 = sign * Complex::new(-2.0 * s, b1 / length);
    let u2 = sign * Complex::new(-2.0, b2 / length);
    // dz/du = 1 + 4iu
    let slope = Complex::ONE + 4.0 * (Complex::I * u);
    Jet {
        position: point(from_half_plane(u)),
        first: point(slope * u1),
        second: point(slope * u2 + 4.0 * (Complex::I * u1 * u1)),
    }
}

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
    fn the_arms_are_the_boundary_with_its_derivatives() {
        let step = 1e-5;
        for k in -19..20 {
            let s = 0.05 * f64::from(k);
            for (arm, middle) in [(right_arm as fn(f64) -> Jet, 0.0), (left_arm, 2.0)] {
                let (a, here, b) = (arm(s - step), arm(s), arm(s + step));
                assert!(here.position.distance(boundary(middle + s)) < 1e-15, "s = {s}");
                let first = (b.position - a.position) / (2.0 * step);
                let second = (b.first - a.first) / (2.0 * step);
                assert!(first.distance(here.first) < 1e-8, "s = {s}: {first} for {}", here.first);
                assert!(second.distance(here.second) < 1e-6, "s = {s}: {second} for {}", here.second);
            }
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
}

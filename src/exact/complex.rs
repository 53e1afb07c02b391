//! Complex numbers of [`num_complex`], and the functions that the closed forms need in addition.
//!
//! [`sqrt`] and [`arg_sinh`] replace `Complex::sqrt`, which computes the argument and loses digits near the
//! negative axis, and `z.sinh().arg()`, which overflows.

use glam::DVec2;

/// A complex number in double precision.
pub type Complex = num_complex::Complex64;

/// The point p as a complex number, `p.x + i p.y`.
pub fn complex(p: DVec2) -> Complex {
    Complex::new(p.x, p.y)
}

/// The complex number z as a point of the plane, `(re z, im z)`.
pub fn point(z: Complex) -> DVec2 {
    DVec2::new(z.re, z.im)
}

/// The root with non-negative real part; both parts are accurate relative to themselves.
///
/// `Complex::sqrt` halves the argument, and near the negative axis the cosine of that half cancels.
pub fn sqrt(z: Complex) -> Complex {
    if z == Complex::ZERO {
        return z;
    }
    // the larger of the two parts is computed without cancellation
    let larger = (0.5 * (z.norm() + z.re.abs())).sqrt();
    let smaller = 0.5 * z.im / larger;
    if z.re >= 0.0 { Complex::new(larger, smaller) } else { Complex::new(smaller.abs(), larger.copysign(z.im)) }
}

/// `arg sinh z` in `(−π, π]`, without overflow for any real part.
pub fn arg_sinh(z: Complex) -> f64 {
    z.im.sin().atan2(z.re.tanh() * z.im.cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_functions_satisfy_their_identities() {
        for (re, im) in [(0.3, 0.4), (-1.2, 0.7), (2.0, -1.5), (-0.5, -0.1), (0.0, 1.0), (-2.0, 0.0)] {
            let z = Complex::new(re, im);
            let root = sqrt(z);
            assert!((root * root - z).norm() < 1e-14 * (1.0 + z.norm()) && root.re >= 0.0, "sqrt {z}");
            assert!((arg_sinh(z) - z.sinh().arg()).abs() < 1e-14, "arg sinh {z}");
        }
    }

    #[test]
    fn roots_near_the_negative_axis_keep_all_digits_of_their_small_part() {
        // √(−1 + iδ) = δ/2 + i to the order δ²
        for delta in [1e-9, 1e-12, 1e-17, -1e-17] {
            let z = Complex::new(-1.0, delta);
            let (root, theirs) = (sqrt(z), z.sqrt());
            let error = |root: Complex| (2.0 * root.re / delta.abs() - 1.0).abs();
            assert!(error(root) < 1e-15 && root.im == 1.0_f64.copysign(delta), "√({z}) = {root}");
            assert!(error(theirs) > 1e-9, "num-complex keeps them too: √({z}) = {theirs}");
        }
        assert_eq!(sqrt(Complex::ZERO), Complex::ZERO);
    }

    #[test]
    fn the_argument_of_sinh_does_not_overflow() {
        // sinh z ≈ e^z/2 for large positive real parts, −e^{−z}/2 for large negative ones
        assert!((arg_sinh(Complex::new(800.0, 0.3)) - 0.3).abs() < 1e-15);
        assert!((arg_sinh(Complex::new(-800.0, 0.3)) - (std::f64::consts::PI - 0.3)).abs() < 1e-15);
        assert!(Complex::new(800.0, 0.3).sinh().re.is_infinite());
    }
}

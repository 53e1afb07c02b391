//! The rectangle of a modulus, as an outline of its own.

use super::{QuadrilateralError, check_length};
use crate::geometry::DVec2;

/// The corners of the rectangle onto which a quadrilateral of this modulus is mapped, corners on corners, in the order of the
/// marks: the side from corner 1 to 2 is at the bottom, those beside it are `modulus` times as long. The center is the
/// origin, the longer sides have length 2.
///
/// Errors: it is longer than [`MOST_LENGTH`](super::MOST_LENGTH), or the modulus is not positive.
pub fn rectangle_corners(modulus: f64) -> Result<[DVec2; 4], QuadrilateralError> {
    check_length(modulus)?;
    let half = DVec2::new(1.0, modulus) / modulus.max(1.0);
    Ok([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| half * DVec2::new(x, y)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::float_cmp, reason = "tests of exact numbers")]
mod tests {
    use super::*;
    use crate::conformal::MOST_LENGTH;

    #[test]
    fn its_sides_have_the_ratio_and_run_counter_clockwise_from_the_bottom() {
        for modulus in [1.0, 0.25, 8.0, MOST_LENGTH, MOST_LENGTH.recip()] {
            let [a, b, c, d] = rectangle_corners(modulus).unwrap();
            assert_eq!((b - a).y, 0.0);
            assert!((a.distance(d) / a.distance(b) - modulus).abs() < 1e-15 * modulus);
            assert!((b - a).perp_dot(c - b) > 0.0 && a + c == DVec2::ZERO && b + d == DVec2::ZERO);
            assert_eq!(a.distance(b).max(a.distance(d)), 2.0);
        }
    }

    #[test]
    fn extreme_moduli_are_refused_with_the_sides_that_are_too_far_apart() {
        for (modulus, far) in [(1e8, 0), (18.1, 0), (1e-8, 1), (f64::INFINITY, 0), (f64::MIN_POSITIVE, 1)] {
            let error = rectangle_corners(modulus).unwrap_err();
            assert!(matches!(error, QuadrilateralError::TooLong { side, .. } if side == far), "{modulus}: {error}");
        }
        for modulus in [0.0, -1.0, f64::NAN] {
            assert!(rectangle_corners(modulus).is_err(), "{modulus}");
        }
    }
}

//! Orientation of three points, decided exactly.
//!
//! The sign comes from Shewchuk's adaptive `orient2d` (crate `robust`): it is
//! the sign of the exact determinant as long as no product overflows or underflows,
//! which [`super::SimplePolygon`] rules out by the range of its coordinates.

use glam::DVec2;
use robust::{Coord, orient2d};

/// On which side of a directed line a point lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left: the three points turn counter-clockwise.
    Left,
    /// On the line.
    On,
    /// To the right: the three points turn clockwise.
    Right,
}

/// Twice the signed area of the triangle `abc`, positive counter-clockwise.
///
/// The sign is exact, zero included; the value is rounded.
pub fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let coord = |p: DVec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(c))
}

/// The side of the line from `a` to `b` on which `p` lies, exactly.
pub fn side(a: DVec2, b: DVec2, p: DVec2) -> Side {
    let turn = orientation(a, b, p);
    if turn > 0.0 {
        Side::Left
    } else if turn < 0.0 {
        Side::Right
    } else {
        Side::On
    }
}

/// Whether `p` lies on the closed segment `ab`, exactly.
pub fn on_segment(a: DVec2, b: DVec2, p: DVec2) -> bool {
    in_box(a, b, p) && side(a, b, p) == Side::On
}

/// Whether `p` lies in the closed box spanned by `a` and `b`.
pub(super) fn in_box(a: DVec2, b: DVec2, p: DVec2) -> bool {
    a.min(b).cmple(p).all() && p.cmple(a.max(b)).all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orientation_is_exact_where_the_rounded_determinant_is_not() {
        // Kettner et al.: (0.5 + i ulp, 0.5 + j ulp) against the line x = y.
        let (q, r) = (DVec2::splat(12.0), DVec2::splat(24.0));
        let ulp = f64::EPSILON / 2.0;
        for i in 0..64 {
            for j in 0..64 {
                let p = DVec2::new(0.5 + f64::from(i) * ulp, 0.5 + f64::from(j) * ulp);
                let expected = match i.cmp(&j) {
                    std::cmp::Ordering::Less => Side::Left,
                    std::cmp::Ordering::Equal => Side::On,
                    std::cmp::Ordering::Greater => Side::Right,
                };
                assert_eq!(side(q, r, p), expected, "p = 0.5 + ({i}, {j}) ulp");
            }
        }
    }

    #[test]
    fn a_segment_contains_its_ends_and_nothing_beyond() {
        let (a, b) = (DVec2::new(0.0, 0.0), DVec2::new(3.0, 1.5));
        assert!(on_segment(a, b, a) && on_segment(a, b, b) && on_segment(a, b, DVec2::new(1.0, 0.5)));
        assert!(!on_segment(a, b, DVec2::new(4.0, 2.0)));
        assert!(!on_segment(a, b, DVec2::new(1.0, 0.5 + 1e-15)));
    }
}

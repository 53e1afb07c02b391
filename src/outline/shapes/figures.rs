//! Gingerbread man, heart and hand.

use super::super::pen::{Drawn, Pen, rounded};
use super::mirrored;
use crate::geometry::DVec2;

/// Round head, stretched arms, sturdy legs.
///
/// The head is a polygon around a circle: rounding its corners with the circle's
/// radius gives the circle itself.
pub(in super::super) fn gingerbread() -> Drawn {
    const HEAD: f64 = 0.36;
    const MIDDLE: f64 = 0.60;
    let around = |degrees: f64, half_step: f64| {
        let p = super::polar(HEAD / half_step.to_radians().cos(), degrees);
        (p.x, MIDDLE + p.y, HEAD)
    };
    rounded(&mirrored(&[
        (0.0, MIDDLE + HEAD, 0.0),
        around(135.0, 45.0),
        around(205.0, 25.0),
        (-0.175, 0.225, 0.07),
        (-0.84, 0.26, 0.17),
        (-0.87, -0.095, 0.17),
        (-0.355, -0.105, 0.12),
        (-0.42, -0.45, 0.35),
        (-0.63, -0.90, 0.19),
        (-0.22, -1.03, 0.19),
        (0.0, -0.47, 0.09),
    ]))
}

/// Two Bézier curves on each side, with a cusp at the top and a tip at the bottom.
pub(in super::super) fn heart() -> Drawn {
    let p = DVec2::new;
    let mut pen = Pen::at(p(0.0, 0.52));
    pen.cubic(p(-0.10, 0.78), p(-0.30, 0.90), p(-0.50, 0.90));
    pen.cubic(p(-0.80, 0.90), p(-1.0, 0.66), p(-1.0, 0.36));
    pen.cubic(p(-1.0, -0.18), p(-0.38, -0.48), p(0.0, -0.94));
    pen.cubic(p(0.38, -0.48), p(1.0, -0.18), p(1.0, 0.36));
    pen.cubic(p(1.0, 0.66), p(0.80, 0.90), p(0.50, 0.90));
    pen.cubic(p(0.30, 0.90), p(0.10, 0.78), p(0.0, 0.52));
    pen.close()
}

/// A finger: root, tip (middle of the rounded end), width at the root and at the tip.
struct Finger {
    tip: DVec2,
    direction_degrees: f64,
    width: f64,
}

impl Finger {
    /// The corners of the tip, counter-clockwise (right side first).
    fn corners(&self) -> [(f64, f64, f64); 2] {
        let along = DVec2::from_angle(self.direction_degrees.to_radians());
        let half = 0.5 * self.width * along.perp();
        let radius = 0.49 * self.width;
        [self.tip - half, self.tip + half].map(|p| (p.x, p.y, radius))
    }
}

/// An open right hand seen from its back, the thumb to the left.
pub(in super::super) fn hand() -> Drawn {
    let finger =
        |x: f64, y: f64, direction_degrees: f64, width: f64| Finger { tip: DVec2::new(x, y), direction_degrees, width };
    let thumb = finger(-0.86, 0.12, 142.0, 0.205).corners();
    let index = finger(-0.38, 0.84, 107.0, 0.195).corners();
    let middle = finger(-0.02, 0.98, 92.0, 0.205).corners();
    let ring = finger(0.32, 0.88, 77.0, 0.195).corners();
    let little = finger(0.68, 0.57, 59.0, 0.172).corners();
    let top = (0.5 * (middle[0].0 + middle[1].0), 0.5 * (middle[0].1 + middle[1].1), 0.0);
    rounded(&[
        top,
        middle[1],
        (-0.135, 0.25, 0.035),
        index[0],
        index[1],
        (-0.36, 0.02, 0.16),
        thumb[0],
        thumb[1],
        (-0.36, -0.52, 0.35),
        (-0.27, -0.80, 0.30),
        (-0.29, -1.0, 0.09),
        (0.27, -1.0, 0.09),
        (0.25, -0.80, 0.30),
        (0.40, -0.42, 0.40),
        (0.42, -0.02, 0.40),
        little[0],
        little[1],
        (0.282, 0.125, 0.035),
        ring[0],
        ring[1],
        (0.090, 0.235, 0.035),
        middle[0],
    ])
}

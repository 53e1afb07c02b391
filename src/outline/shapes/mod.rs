//! The built-in outlines as curves and dense polygons on them, counter-clockwise, within [−1, 1]²
//! (the V and the blob as in the paper). Each starts where its default boundary
//! anchor should be, mostly at the top.

mod figures;
mod leaf;
mod turkey;

use std::f64::consts::{PI, TAU};

use super::pen::{Drawn, Fineness, Pen, SMOOTH, polar, straight};
use crate::exact;
use crate::geometry::{DVec2, Jet, Piece};
pub(super) use figures::{gingerbread, hand, heart};
pub(super) use leaf::maple_leaf;
pub(super) use turkey::turkey;

/// The unit circle e^{it} from t = 0, as in the paper's Figures 6 and 7.
pub(super) fn disk() -> Drawn {
    const COUNT: u32 = 1440;
    let points = (0..COUNT).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(COUNT))).collect();
    Drawn { points, pieces: vec![Piece::circular(DVec2::ZERO, 1.0, 0.0, TAU)] }
}

/// Four corners, and the middle of the top as the first point.
pub(super) fn square() -> Drawn {
    straight([(0.0, 0.9), (-0.9, 0.9), (-0.9, -0.9), (0.9, -0.9), (0.9, 0.9)].map(DVec2::from))
}

/// Three quarters of a square; the first point is the middle of the upper end.
pub(super) fn l_shape() -> Drawn {
    let corners = [(-0.9, 0.9), (-0.9, -0.9), (0.9, -0.9), (0.9, 0.0), (0.0, 0.0), (0.0, 0.9)];
    straight([(-0.45, 0.9)].into_iter().chain(corners).map(DVec2::from))
}

/// The pentagram's outline: the notches lie on the lines between the points.
pub(super) fn star() -> Drawn {
    let notch = (PI / 10.0).sin() / (3.0 * PI / 10.0).sin();
    straight((0..10).map(|k| polar(if k % 2 == 0 { 1.0 } else { notch }, 90.0 + 36.0 * f64::from(k))))
}

/// Five round lobes that meet in cusps, as in tracery.
pub(super) fn cinquefoil() -> Drawn {
    let cusp = 0.58;
    let (start, end) = (polar(cusp, 54.0), polar(cusp, 126.0));
    let center = DVec2::new(0.0, 0.62);
    // From the top of the first lobe to its cusp; then four whole lobes, then the rest.
    let half = (DVec2::Y).angle_to(end - center).rem_euclid(TAU);
    let whole = (start - center).angle_to(end - center).rem_euclid(TAU);
    let radius = center.distance(end);
    let mut pen = Pen::at(center + radius * DVec2::Y);
    pen.turn_around(center, half);
    for k in 1..5 {
        let spoke = DVec2::from_angle(TAU * f64::from(k) / 5.0);
        pen.turn_around(spoke.rotate(center), whole);
    }
    pen.turn_around(center, half);
    pen.close()
}

/// A corridor of constant width along r = 0.14 + 0.78 s/2.75 (s in turns), with round ends; the first point is the
/// middle of the outer end.
pub(super) fn spiral() -> Drawn {
    let end = corridor::center(corridor::TURNS);
    let mut pen = Pen::at(end + corridor::HALF_WIDTH * corridor::normal(corridor::TURNS).perp());
    pen.turn_around(end, PI / 2.0);
    let mut knots: Vec<f64> = (0..=11).map(|k| corridor::TURNS * f64::from(k) / 11.0).collect();
    knots.reverse();
    pen.formula(corridor::left_side, &knots, SMOOTH);
    pen.turn_around(corridor::center(0.0), PI);
    knots.reverse();
    pen.formula(corridor::right_side, &knots, SMOOTH);
    pen.turn_around(end, PI / 2.0);
    pen.close()
}

/// The spiral's middle line and sides.
mod corridor {
    use super::{DVec2, Jet, PI, TAU};

    pub const HALF_WIDTH: f64 = 0.072;
    pub const TURNS: f64 = 2.75;
    const PITCH: f64 = 0.78 / TURNS;

    fn angle(s: f64) -> f64 {
        TAU * s + PI / 2.0 - TAU * TURNS
    }

    pub fn center(s: f64) -> DVec2 {
        (0.14 + PITCH * s) * DVec2::from_angle(angle(s))
    }

    fn along(s: f64) -> DVec2 {
        PITCH * DVec2::from_angle(angle(s)) + TAU * (0.14 + PITCH * s) * DVec2::from_angle(angle(s)).perp()
    }

    /// The unit normal to the right of the middle line.
    pub fn normal(s: f64) -> DVec2 {
        -along(s).normalize().perp()
    }

    pub fn left_side(s: f64) -> Jet {
        side(s, -1.0)
    }

    pub fn right_side(s: f64) -> Jet {
        side(s, 1.0)
    }

    /// The middle line displaced by ±[`HALF_WIDTH`] along its normal N. With T the tangent of angle φ and θ′ = 2π,
    /// N′ = φ′ T and T′ = −φ′ N; φ = θ + arg(r′ + i θ′ r).
    fn side(s: f64, sign: f64) -> Jet {
        let (spoke, radius) = (DVec2::from_angle(angle(s)), 0.14 + PITCH * s);
        let (tangent, normal) = (along(s).normalize(), normal(s));
        let bend = 2.0 * PITCH * TAU * spoke.perp() - TAU * TAU * radius * spoke;
        let speed2 = PITCH * PITCH + TAU * TAU * radius * radius;
        let turn = TAU + TAU * PITCH * PITCH / speed2;
        let turn_slope = -2.0 * TAU * PITCH * PITCH * TAU * TAU * radius * PITCH / (speed2 * speed2);
        let width = sign * HALF_WIDTH;
        Jet {
            position: center(s) + sign * HALF_WIDTH * normal,
            first: along(s) + width * turn * tangent,
            second: bend + width * (turn_slope * tangent - turn * turn * normal),
        }
    }
}

/// For the paper's two outlines, whose exact harmonic measure is known: arc
/// lengths are right to 1e-5.
const FINE: Fineness = Fineness { turn: 0.012, deficit: 1.4e-7 };

pub(super) fn blob() -> Drawn {
    let mut pen = Pen::at(exact::blob::boundary(0.0));
    pen.formula(exact::blob::boundary_jet, &[0.0, 0.25, 0.5, 0.75, 1.0], FINE);
    pen.close()
}

pub(super) fn v_shape() -> Drawn {
    use exact::vshape::{around_left_tip, around_right_tip, boundary};
    let mut pen = Pen::at(boundary(0.0));
    pen.formula(around_right_tip, &[0.0, 1.0], FINE);
    pen.formula(around_left_tip, &[1.0, 0.0, -1.0], FINE);
    pen.formula(around_right_tip, &[-1.0, 0.0], FINE);
    pen.close()
}

/// The outline whose left half, from the top down, is `half`: (x, y, radius)
/// corners for [`super::pen::rounded`], those on the axis once.
fn mirrored(half: &[(f64, f64, f64)]) -> Vec<(f64, f64, f64)> {
    let right = half.iter().rev().filter(|c| c.0 != 0.0).map(|&(x, y, r)| (-x, y, r));
    half.iter().copied().chain(right).collect()
}

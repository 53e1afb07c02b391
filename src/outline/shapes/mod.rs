//! The built-in outlines as dense polygons, counter-clockwise, within [−1, 1]²
//! (the V and the blob as in the paper). Each starts where its default boundary
//! anchor should be, mostly at the top.

mod figures;
mod leaf;
mod turkey;

use std::f64::consts::{PI, TAU};

use super::pen::{Fineness, Pen, SMOOTH, closed_curve, polar};
use crate::exact::{self, Complex};
use crate::geometry::{DVec2, Jet, Piece};
pub(super) use figures::{gingerbread, hand, heart};
pub(super) use leaf::maple_leaf;
pub(super) use turkey::turkey;

/// The unit circle e^{it} from t = 0, as in the paper's Figures 6 and 7.
pub(super) fn disk() -> Vec<DVec2> {
    const COUNT: u32 = 1440;
    (0..COUNT).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(COUNT))).collect()
}

/// Four corners, and the middle of the top as the first point.
pub(super) fn square() -> Vec<DVec2> {
    [(0.0, 0.9), (-0.9, 0.9), (-0.9, -0.9), (0.9, -0.9), (0.9, 0.9)].map(DVec2::from).to_vec()
}

/// Three quarters of a square; the first point is the middle of the upper end.
pub(super) fn l_shape() -> Vec<DVec2> {
    [(-0.45, 0.9), (-0.9, 0.9), (-0.9, -0.9), (0.9, -0.9), (0.9, 0.0), (0.0, 0.0), (0.0, 0.9)].map(DVec2::from).to_vec()
}

/// The pentagram's outline: the notches lie on the lines between the points.
pub(super) fn star() -> Vec<DVec2> {
    let notch = (PI / 10.0).sin() / (3.0 * PI / 10.0).sin();
    (0..10).map(|k| polar(if k % 2 == 0 { 1.0 } else { notch }, 90.0 + 36.0 * f64::from(k))).collect()
}

/// Five round lobes that meet in cusps, as in tracery.
pub(super) fn cinquefoil() -> Pen {
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
    pen
}

/// The spiral's half width, its number of turns, the radius of its center line at s = 0, and by how much that grows in
/// a turn.
const HALF_WIDTH: f64 = 0.072;
const TURNS: f64 = 2.75;
const RADIUS: f64 = 0.14;
const PITCH: f64 = 0.78 / TURNS;

/// The spiral's wall at s turns: the center line (0.14 + PITCH s) e^{iθ}, θ = 2πs + θ₀, and `sign` half widths along
/// its normal. With w = PITCH + 2πi (0.14 + PITCH s), the center line has the derivative w e^{iθ} and the normal
/// −i e^{i(θ + arg w)}.
fn spiral_wall(s: f64, sign: f64) -> Jet {
    let radius = RADIUS + PITCH * s;
    let turn = TAU * s + PI / 2.0 - TAU * TURNS;
    let spoke = Complex::cis(turn);
    let w = Complex::new(PITCH, TAU * radius);
    let slope = w.im / PITCH;
    // the rate of θ + arg w, and its own rate; the slope's rate is 2π
    let rate = TAU + TAU / (1.0 + slope * slope);
    let bend = -2.0 * slope * TAU * TAU / (1.0 + slope * slope).powi(2);
    let normal = -Complex::I * Complex::cis(w.arg()) * spoke;
    let wall = sign * HALF_WIDTH * normal;
    Jet {
        position: exact::point(radius * spoke + wall),
        first: exact::point(w * spoke + Complex::I * rate * wall),
        second: exact::point((Complex::I * TAU * (w + PITCH)) * spoke + (Complex::I * bend - rate * rate) * wall),
    }
}

/// A corridor of constant width along r = 0.16 + 0.105 θ (θ in turns of 1/2π),
/// with round ends; the first point is the middle of the outer end.
pub(super) fn spiral() -> Pen {
    let angle = |s: f64| TAU * s + PI / 2.0 - TAU * TURNS;
    let center = |s: f64| (RADIUS + PITCH * s) * DVec2::from_angle(angle(s));
    let normal = |s: f64| {
        let along =
            PITCH * DVec2::from_angle(angle(s)) + TAU * (RADIUS + PITCH * s) * DVec2::from_angle(angle(s)).perp();
        -along.normalize().perp()
    };
    let side = |s: f64, sign: f64| center(s) + sign * HALF_WIDTH * normal(s);
    let end = center(TURNS);
    let mut pen = Pen::at(end + HALF_WIDTH * normal(TURNS).perp());
    pen.turn_around(end, PI / 2.0);
    let piece = |k: u32| TURNS * f64::from(k) / 11.0;
    for k in (0..11).rev() {
        pen.curve(piece(k + 1), piece(k), SMOOTH, |s| side(s, -1.0));
    }
    pen.record(Piece::Formula { function: |s| spiral_wall(s, -1.0), from: TURNS, to: 0.0 });
    pen.turn_around(center(0.0), PI);
    for k in 0..11 {
        pen.curve(piece(k), piece(k + 1), SMOOTH, |s| side(s, 1.0));
    }
    pen.record(Piece::Formula { function: |s| spiral_wall(s, 1.0), from: 0.0, to: TURNS });
    pen.turn_around(end, PI / 2.0);
    pen
}

/// For the paper's two outlines, whose exact harmonic measure is known: arc
/// lengths are right to 1e-5.
const FINE: Fineness = Fineness { turn: 0.012, deficit: 1.4e-7 };

pub(super) fn blob() -> Vec<DVec2> {
    closed_curve(FINE, exact::blob::boundary)
}

pub(super) fn v_shape() -> Vec<DVec2> {
    closed_curve(FINE, |s| exact::vshape::boundary(4.0 * s))
}

/// The outline whose left half, from the top down, is `half`: (x, y, radius)
/// corners for [`super::pen::rounded`], those on the axis once.
fn mirrored(half: &[(f64, f64, f64)]) -> Vec<(f64, f64, f64)> {
    let right = half.iter().rev().filter(|c| c.0 != 0.0).map(|&(x, y, r)| (-x, y, r));
    half.iter().copied().chain(right).collect()
}

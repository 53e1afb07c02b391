//! A turkey with its tail spread, facing left.

use super::super::pen::{Drawn, Pen, polar};
use crate::geometry::DVec2;

const FAN: DVec2 = DVec2::new(0.22, -0.06);
const FAN_RADIUS: f64 = 0.80;
const FEATHERS: u32 = 9;
/// The fan's first and last notch, in degrees.
const FAN_ENDS: [f64; 2] = [-28.0, 131.0];

/// Counter-clockwise from the top of the head.
pub(in super::super) fn turkey() -> Drawn {
    let p = DVec2::new;
    let mut pen = Pen::at(p(-0.655, 0.62));
    head_and_breast(&mut pen);
    legs(&mut pen);
    tail(&mut pen);
    // Back of the neck, up to the head.
    pen.line(p(-0.33, 0.16));
    pen.cubic(p(-0.40, 0.10), p(-0.46, 0.22), p(-0.49, 0.36));
    pen.cubic(p(-0.50, 0.52), p(-0.55, 0.62), p(-0.655, 0.62));
    pen.close()
}

fn head_and_breast(pen: &mut Pen) {
    let p = DVec2::new;
    pen.cubic(p(-0.73, 0.62), p(-0.775, 0.575), p(-0.785, 0.52));
    pen.line(p(-0.93, 0.455)).line(p(-0.785, 0.425));
    // The wattle.
    pen.cubic(p(-0.79, 0.36), p(-0.80, 0.30), p(-0.765, 0.255));
    pen.cubic(p(-0.73, 0.215), p(-0.695, 0.26), p(-0.69, 0.33));
    pen.cubic(p(-0.685, 0.22), p(-0.80, 0.0), p(-0.76, -0.22));
    pen.cubic(p(-0.72, -0.46), p(-0.46, -0.62), p(-0.20, -0.66));
}

fn legs(pen: &mut Pen) {
    let p = DVec2::new;
    pen.line(p(-0.19, -0.86)).line(p(-0.33, -0.97)).line(p(-0.02, -0.97)).line(p(-0.10, -0.86)).line(p(-0.09, -0.675));
    pen.line(p(0.13, -0.66));
    pen.line(p(0.15, -0.86)).line(p(0.04, -0.97)).line(p(0.35, -0.97)).line(p(0.24, -0.86)).line(p(0.24, -0.63));
    pen.cubic(p(0.50, -0.60), p(0.72, -0.56), FAN + polar(FAN_RADIUS, FAN_ENDS[0]));
}

fn tail(pen: &mut Pen) {
    let step = (FAN_ENDS[1] - FAN_ENDS[0]) / f64::from(FEATHERS);
    for k in 1..=FEATHERS {
        pen.bow(FAN + polar(FAN_RADIUS, FAN_ENDS[0] + step * f64::from(k)), 70f64.to_radians());
    }
}

//! Smooth closed curves through given points.
//!
//! Centripetal Catmull–Rom splines (Yuksel, Schaefer and Keyser 2011): unlike uniform
//! ones, they have no loops and no cusps inside a piece, however unevenly the points are spaced.

use super::hermite;
use crate::geometry::DVec2;

/// A larger turn (60°) of a simplified chain counts as a corner: on a circle as large as a
/// finger is wide the turns are below 50°, at the tips of a quickly drawn star above 90°.
const CORNER: f64 = std::f64::consts::FRAC_PI_3;

/// The [`closed_curve`] through the `points` of a simplified chain, with corners where they turn sharply.
pub fn curve_with_corners(points: &[DVec2]) -> Vec<DVec2> {
    let n = points.len();
    closed_curve(points, |k| {
        let (p, q, r) = (points[(k + n - 1) % n], points[k % n], points[(k + 1) % n]);
        (q - p).angle_to(r - q).abs() > CORNER
    })
}

/// The closed curve through `points` as a dense polygon; at points that are `corners` it may turn sharply.
/// Repeated neighbors are removed; fewer than three points are returned unchanged otherwise.
pub fn closed_curve(points: &[DVec2], corners: impl Fn(usize) -> bool) -> Vec<DVec2> {
    let mut distinct: Vec<(DVec2, bool)> = Vec::with_capacity(points.len());
    for (k, &point) in points.iter().enumerate() {
        match distinct.last_mut() {
            Some((last, corner)) if *last == point => *corner |= corners(k),
            _ => distinct.push((point, corners(k))),
        }
    }
    while distinct.len() > 1 && distinct.first().map(|p| p.0) == distinct.last().map(|p| p.0) {
        distinct.pop();
    }
    let n = distinct.len();
    if n < 3 {
        return distinct.into_iter().map(|(point, _)| point).collect();
    }
    let at = |k: usize| distinct[k % n].0;
    let mut curve = Vec::new();
    for k in 0..n {
        let [p, a, b, q] = [at(k + n - 1), at(k), at(k + 1), at(k + 2)];
        let [start, end] = derivatives(p, a, b, q);
        let smooth = |k: usize, derivative: DVec2| (!distinct[k % n].1).then_some(derivative);
        curve.push(a);
        curve.extend(hermite::inner_points(a, b, [smooth(k, start), smooth(k + 1, end)]));
    }
    curve
}

/// The derivatives at both ends of the piece from `a` to `b` over the unit interval: those of the
/// parabolas through three points each, whose parameters differ by the square roots of the distances.
fn derivatives(p: DVec2, a: DVec2, b: DVec2, q: DVec2) -> [DVec2; 2] {
    let [before, here, after] = [p.distance(a), a.distance(b), b.distance(q)].map(f64::sqrt);
    [
        here * ((a - p) / before - (b - p) / (before + here) + (b - a) / here),
        here * ((b - a) / here - (q - a) / (here + after) + (q - b) / after),
    ]
}

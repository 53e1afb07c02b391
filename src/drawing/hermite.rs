//! Cubic Hermite pieces, divided into chords.

use crate::geometry::DVec2;

/// The turn from chord to chord, in radians; the same as for curves in files.
const TURN: f64 = 0.04;

/// The maximal number of chords for one piece.
const MAX_CHORDS: f64 = 64.0;

/// The inner points of the cubic from `a` to `b` with these derivatives over the unit interval.
///
/// At an end without a derivative the second derivative is 0; without both the piece is straight
/// and has no inner points.
pub(super) fn inner_points(a: DVec2, b: DVec2, derivatives: [Option<DVec2>; 2]) -> Vec<DVec2> {
    let free = |other: DVec2| 0.5 * (3.0 * (b - a) - other);
    let [u, v] = match derivatives {
        [None, None] => return Vec::new(),
        [Some(u), None] => [u, free(u)],
        [None, Some(v)] => [free(v), v],
        [Some(u), Some(v)] => [u, v],
    };
    let control = [a, a + u / 3.0, b - v / 3.0, b];
    let legs = [control[1] - a, control[2] - control[1], b - control[2]];
    let turn = |p: DVec2, q: DVec2| if p == DVec2::ZERO || q == DVec2::ZERO { 0.0 } else { p.angle_to(q).abs() };
    let count = ((turn(legs[0], legs[1]) + turn(legs[1], legs[2])) / TURN).ceil().clamp(1.0, MAX_CHORDS);
    (1..count as u32).map(|k| bezier(control, f64::from(k) / count)).collect()
}

fn bezier([a, b, c, d]: [DVec2; 4], t: f64) -> DVec2 {
    let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
    ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
}

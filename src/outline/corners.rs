//! Corners of dense chains of points.

use std::f64::consts::PI;

use crate::geometry::DVec2;

/// A vertex is a corner if it turns by more than 30°. Hand-drawn outlines of 200 points turn by up to 20° where they are
/// meant to be smooth; a regular octagon, the bluntest figure usually drawn with corners, turns by 45°.
pub(super) const CORNER_TURN: f64 = PI / 6.0;
/// The cosine of [`CORNER_TURN`].
pub(super) const CORNER_COSINE: f64 = 0.866_025_403_784_438_6;

/// A smaller turn (2°) is no corner by comparison with its neighbors: smooth parts of the presets turn by 0.7°.
const LEAST_TURN: f64 = PI / 90.0;

/// A vertex that bends this many times more than the vertices around it is a corner. On ellipses up to 4:1 drawn with
/// 64 points, at distances that alternate by a factor of up to 4, the largest quotient is 1.7; of the presets' joints
/// that of 3.3° among turns of 0.7° is found, that of 0.8° is not.
const RATIO: f64 = 4.0;

/// The vertices of a closed chain at which it has a corner: where it turns by more than 30°, or by more than 2° and
/// four times more per length of its shorter edge than the median of the four vertices around. Cost O(n).
pub(super) fn corners(vertices: &[DVec2]) -> Vec<usize> {
    let n = vertices.len();
    let step = |k: usize| vertices[(k + 1) % n] - vertices[k % n];
    let turn = |k: usize| turn_between(step(k + n - 1), step(k)).abs();
    let bend: Vec<f64> = (0..n).map(|k| turn(k) / step(k + n - 1).length().min(step(k).length())).collect();
    let around = |k: usize| {
        let mut near = [n - 2, n - 1, 1, 2].map(|j| bend[(k + j) % n]);
        near.sort_unstable_by(f64::total_cmp);
        0.5 * (near[1] + near[2])
    };
    let is_corner = |&k: &usize| {
        let turn = turn(k);
        turn > CORNER_TURN || (turn > LEAST_TURN && n > 4 && bend[k] > RATIO * around(k))
    };
    (0..n).filter(is_corner).collect()
}

/// The vertices at which a polygon turns by more than 2°: all that a person draws with straight edges, and none of the
/// hundreds with which one approximates a curve.
pub(super) fn polygon_corners(vertices: &[DVec2]) -> impl Iterator<Item = DVec2> + '_ {
    let n = vertices.len();
    let step = move |k: usize| vertices[(k + 1) % n] - vertices[k % n];
    (0..n).filter(move |&k| turn_between(step(k + n - 1), step(k)).abs() > LEAST_TURN).map(|k| vertices[k])
}

/// The signed angle from one direction to another, with relative accuracy also near 0.
pub(super) fn turn_between(a: DVec2, b: DVec2) -> f64 {
    a.perp_dot(b).atan2(a.dot(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// `n` points of the ellipse with half axes 1 and `b`, at distances that alternate by the factor `r`.
    fn ellipse(n: u32, b: f64, r: f64) -> Vec<DVec2> {
        let at = |k: u32| 2.0 * TAU / f64::from(n) * (f64::from(k / 2) + f64::from(k % 2) * r / (1.0 + r));
        (0..n).map(at).map(|s| DVec2::new(s.cos(), b * s.sin())).collect()
    }

    #[test]
    fn smooth_outlines_have_no_corners_however_uneven_their_points() {
        for n in [64, 100, 200, 1000] {
            for b in [1.0, 0.5, 0.25] {
                for r in [1.0, 2.0, 4.0] {
                    assert!(corners(&ellipse(n, b, r)).is_empty(), "{n} points, {b}:1, distances 1:{r}");
                }
            }
        }
    }

    /// A heart-like curve with a kink of 4.6° or 0.6° at its first point; its edges turn by 0.6°.
    #[test]
    fn a_kink_of_a_few_degrees_is_a_corner_among_smaller_turns() {
        let kinked = |depth: f64| -> Vec<DVec2> {
            let at = |k: u32| TAU * f64::from(k) / 600.0;
            (0..600).map(at).map(|s| (1.0 + depth * (0.5 * s).sin()) * DVec2::from_angle(s)).collect()
        };
        assert_eq!(corners(&kinked(0.08)), [0]);
        assert!(corners(&kinked(0.01)).is_empty());
    }
}

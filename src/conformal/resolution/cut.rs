//! Chords that cut off the part of a domain that is not resolved.

use crate::geometry::{DVec2, Side, on_segment, side};

/// The largest number of vertices by which the ends of a cut are moved: the ends lie on the two sides of a channel
/// whose width is four samples, and need to be nearly opposite each other; more only where the channel bends.
const MOVES: usize = 40;

/// The numbers of vertices to add before and after the `steps` edges from `vertex` on, at most `room`, so that the
/// chord between the ends lies inside the counter-clockwise polygon `points`; none if there is no such chord.
/// Cost O(m) for each pair that is tried.
pub(super) fn cut(points: &[DVec2], vertex: usize, steps: usize, room: [usize; 2]) -> [usize; 2] {
    let m = points.len();
    let found = (0..=MOVES).flat_map(|moves| (0..=moves).map(move |before| [before, moves - before])).find(
        |&[before, after]| {
            let fits = before <= room[0] && after <= room[1] && steps + before + after + 2 <= m;
            fits && is_inside(points, (vertex + m - before) % m, (vertex + steps + after) % m)
        },
    );
    found.unwrap_or([0, 0])
}

/// Whether the chord between the vertices `i` and `j` lies strictly inside the polygon.
fn is_inside(points: &[DVec2], i: usize, j: usize) -> bool {
    let m = points.len();
    let (a, b) = (points[i], points[j]);
    let leaves_inward = |i: usize, b: DVec2| {
        let (before, at, after) = (points[(i + m - 1) % m], points[i], points[(i + 1) % m]);
        let [from_before, from_after] = [side(before, at, b) == Side::Left, side(at, after, b) == Side::Left];
        let is_convex = side(before, at, after) == Side::Left;
        if is_convex { from_before && from_after } else { from_before || from_after }
    };
    if !leaves_inward(i, b) || !leaves_inward(j, a) {
        return false;
    }
    let ends = |k: usize| k == i || k == j;
    (0..m).all(|k| {
        let (next, touches) = ((k + 1) % m, |k: usize| !ends(k) && on_segment(a, b, points[k]));
        if touches(k) {
            return false;
        }
        let (p, q) = (points[k], points[next]);
        ends(k) || ends(next) || side(a, b, p) == side(a, b, q) || side(p, q, a) == side(p, q, b)
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    /// A corridor of width 1 around a right angle, with vertices at distance 1/2.
    fn corridor() -> Vec<DVec2> {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (3.0, 4.0), (3.0, 1.0), (0.0, 1.0)].map(DVec2::from);
        let mut points = Vec::new();
        for k in 0..corners.len() {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            let parts = (2.0 * a.distance(b)).round() as usize;
            points.extend((0..parts).map(|i| a.lerp(b, i as f64 / parts as f64)));
        }
        points
    }

    #[test]
    fn a_chord_across_the_corridor_is_inside_and_one_around_the_corner_is_not() {
        let points = corridor();
        let at = |x: f64, y: f64| points.iter().position(|p| p.distance(DVec2::new(x, y)) < 1e-9).unwrap();
        assert!(is_inside(&points, at(1.0, 0.0), at(1.5, 1.0)));
        assert!(!is_inside(&points, at(1.0, 1.0), at(3.0, 3.0)), "outside");
        assert!(!is_inside(&points, at(1.0, 0.0), at(4.0, 3.0)), "crosses the corner");
        assert!(!is_inside(&points, at(1.0, 0.0), at(2.0, 0.0)), "along a side");
    }

    #[test]
    fn ends_are_moved_until_the_chord_is_inside() {
        let points = corridor();
        let m = points.len();
        let at = |x: f64, y: f64| points.iter().position(|p| p.distance(DVec2::new(x, y)) < 1e-9).unwrap();
        // the vertices from (4, 2) counter-clockwise to (2, 1), around the far end
        let (from, to) = (at(4.0, 2.0), at(2.5, 1.0));
        let [before, after] = cut(&points, from, to - from, [m, m]);
        assert!(is_inside(&points, from - before, (to + after) % m), "{before} {after}");
        assert!(before + after > 0, "the chord between (4, 2) and (2.5, 1) leaves the corridor");
    }
}

//! Turns a freehand stroke into a smooth closed outline with corners.
//!
//! If the ends cross, or the end runs past the beginning, the parts beyond are cut off. The rest is simplified by
//! Douglas and Peucker's algorithm and joined by a centripetal Catmull–Rom spline, with corners where the stroke turns
//! sharply.

use super::{DrawingError, curve_with_corners, simplified};
use crate::geometry::{DVec2, Side, side};

/// The part of a stroke, from either end, in which a crossing counts as an overshoot.
const TAIL: f64 = 0.25;

/// A stroke whose bounding box is smaller than this many tolerances in both directions is a dot.
const LEAST_SIZE: f64 = 8.0;

/// The outline of a stroke. `tolerance`: how inaccurate its points may be, one or two pixels.
///
/// The result crosses itself if the stroke does so other than near its ends. Errors:
/// the stroke is no larger than a few tolerances.
pub fn freehand(stroke: &[DVec2], tolerance: f64) -> Result<Vec<DVec2>, DrawingError> {
    let rough: Vec<DVec2> = simplified(stroke, 0.5 * tolerance).into_iter().map(|k| stroke[k]).collect();
    let cut = without_tails(&rough);
    let mut points: Vec<DVec2> = simplified(&cut, tolerance).into_iter().map(|k| cut[k]).collect();
    if let (Some(&first), Some(&last)) = (points.first(), points.last())
        && points.len() > 3
        && first.distance(last) < 4.0 * tolerance
    {
        points.pop();
    }
    let size = crate::geometry::Bounds::of(points.iter().copied()).size().max_element();
    if points.len() < 3 || size < LEAST_SIZE * tolerance {
        return Err(DrawingError::TooShort);
    }
    Ok(curve_with_corners(&points))
}

/// The part of the chain between the crossings of its beginning and its end; all of it if there are none.
fn without_tails(chain: &[DVec2]) -> Vec<DVec2> {
    let mut chain = chain.to_vec();
    // ends that run along each other may cross more than once
    while let Some((at, i, j)) = first_crossing_of_ends(&chain) {
        chain = [&[at], &chain[i + 1..=j]].concat();
    }
    end_near_beginning(&mut chain);
    chain
}

/// The end has run past the beginning if the stroke comes nearer to the beginning than its end, by this factor. An
/// overshoot of a twelfth of a circle has 0.2; an L, a V or half a circle has 0.7 or more.
const PASSES: f64 = 0.6;

/// Cuts off an end that runs past the beginning without crossing it, at the point nearest to the beginning.
fn end_near_beginning(chain: &mut Vec<DVec2>) {
    let lengths: Vec<f64> = chain.windows(2).map(|w| w[0].distance(w[1])).collect();
    let tails = edges_within(lengths.iter().rev(), TAIL * lengths.iter().sum::<f64>());
    let nearest = |j: usize| {
        let (a, d) = (chain[j], chain[j + 1] - chain[j]);
        let part = ((chain[0] - a).dot(d) / d.length_squared()).clamp(0.0, 1.0);
        (a + part * d, j)
    };
    let passes = (lengths.len() - tails..lengths.len()).map(nearest);
    let [first, last] = [chain.first(), chain.last()].map(|end| end.copied().unwrap_or_default());
    if let Some((at, j)) = passes.min_by(|(p, _), (q, _)| p.distance(first).total_cmp(&q.distance(first)))
        && at.distance(first) < PASSES * last.distance(first)
    {
        chain.truncate(j + 1);
        chain.push(at);
    }
}

/// The first crossing of an edge near the beginning with one near the end: the point and the edges.
fn first_crossing_of_ends(chain: &[DVec2]) -> Option<(DVec2, usize, usize)> {
    let lengths: Vec<f64> = chain.windows(2).map(|w| w[0].distance(w[1])).collect();
    let reach = TAIL * lengths.iter().sum::<f64>();
    let heads = edges_within(lengths.iter(), reach);
    let tails = edges_within(lengths.iter().rev(), reach);
    for i in 0..heads {
        for j in (lengths.len() - tails).max(i + 2)..lengths.len() {
            if let Some(at) = crossing([chain[i], chain[i + 1]], [chain[j], chain[j + 1]]) {
                return Some((at, i, j));
            }
        }
    }
    None
}

/// The number of leading edges that begin within the distance `reach`.
fn edges_within<'a>(lengths: impl Iterator<Item = &'a f64>, reach: f64) -> usize {
    let mut sum = 0.0;
    let begins_within = |length: &&f64| {
        let begins = sum;
        sum += **length;
        begins < reach
    };
    lengths.take_while(begins_within).count()
}

/// The point where two segments cross properly.
fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<DVec2> {
    let apart =
        |p, q, r, s| matches!((side(p, q, r), side(p, q, s)), (Side::Left, Side::Right) | (Side::Right, Side::Left));
    if !apart(a, b, c, d) || !apart(c, d, a, b) {
        return None;
    }
    let t = (c - a).perp_dot(d - c) / (b - a).perp_dot(d - c);
    Some(a.lerp(b, t.clamp(0.0, 1.0)))
}

//! The segments of a path as a dense polygon.
//!
//! Curves are cut into equal parameter steps, as many as needed for chords to deviate from the
//! curve by less than 1e-5 of the path's size (Wang's bound for Bézier
//! curves) and to turn by about 0.04 from one to the next.

use super::Segment;
use super::corners::turn_between;
use crate::geometry::{Bounds, DVec2, MAX_POINTS, Piece};

/// The distance of a chord from its curve, as a fraction of the path's size.
const FLATNESS: f64 = 1e-5;

/// The turn from chord to chord, in radians.
const TURN: f64 = 0.04;

/// The largest number of chords for one curve.
const MAX_CHORDS: f64 = 512.0;

/// Points nearer to each other, in sizes of the path, are one: the computed ends of arcs.
const SAME_POINT: f64 = 1e-14;

/// The points of a closed path, each segment of which begins where the one before it ends, without repeating
/// consecutive points or the first. The segments' ends are among them.
pub fn flattened(segments: &[Segment]) -> Vec<DVec2> {
    let Some(first) = segments.first() else { return Vec::new() };
    let all = segments.iter().flat_map(frame);
    let size = Bounds::of([first.start()].into_iter().chain(all)).size().max_element();
    let mut coarseness = 1.0;
    loop {
        let total: f64 = segments.iter().map(|segment| chord_count(segment, size, coarseness)).sum();
        // 64 times coarser means at most 8 chords a curve: if that is too many, so are the file's own segments.
        if total <= MAX_POINTS as f64 || coarseness >= 64.0 {
            return flattened_to(segments, size, coarseness);
        }
        coarseness *= 4.0;
    }
}

fn flattened_to(segments: &[Segment], size: f64, coarseness: f64) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = segments.first().map(Segment::start).into_iter().collect();
    let is_same = |p: DVec2, q: DVec2| p.distance(q) <= SAME_POINT * size;
    let mut push = |p: DVec2| {
        // A segment without length is no edge.
        if points.last().is_none_or(|&q| !is_same(p, q)) {
            points.push(p);
        }
    };
    for segment in segments {
        let count = chord_count(segment, size, coarseness);
        for k in 1..count as u32 {
            push(at(segment, f64::from(k) / count));
        }
        push(segment.end());
    }
    while let [first, .., last] = *points.as_slice()
        && is_same(first, last)
    {
        points.pop();
    }
    points
}

fn chord_count(segment: &Segment, size: f64, coarseness: f64) -> f64 {
    (chords(segment, size) / coarseness).ceil().max(1.0)
}

/// Points that frame the segment.
fn frame(segment: &Segment) -> [DVec2; 4] {
    match *segment {
        Segment::Line([a, b]) => [a, a, b, b],
        Segment::Cubic(control) => control,
        Segment::Arc { center, axes: [a, b], .. } => [center - a, center + a, center - b, center + b],
    }
}

fn at(segment: &Segment, t: f64) -> DVec2 {
    match *segment {
        Segment::Cubic([a, b, c, d]) => {
            let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
            ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
        }
        other => Piece::from(other).jet(t).position,
    }
}

/// The number of chords that the segment needs, not rounded. NaN, from coordinates that overflow, becomes the maximum;
/// the polygon check reports such coordinates.
fn chords(segment: &Segment, size: f64) -> f64 {
    match *segment {
        Segment::Line(_) => 1.0,
        Segment::Cubic([a, b, c, d]) => {
            let bend = (a - 2.0 * b + c).length().max((b - 2.0 * c + d).length());
            let flat = (0.75 * bend / (FLATNESS * size)).sqrt();
            let legs = [b - a, c - b, d - c];
            let turn = |u: DVec2, v: DVec2| {
                if u == DVec2::ZERO || v == DVec2::ZERO { 0.0 } else { turn_between(u, v).abs() }
            };
            flat.max((turn(legs[0], legs[1]) + turn(legs[1], legs[2])) / TURN).min(MAX_CHORDS)
        }
        Segment::Arc { axes: [a, b], from, to, .. } => {
            let sweep = (to - from).abs();
            // the sagitta of a chord over the angle θ is r θ²/8
            let flat = sweep * (a.length().max(b.length()) / (8.0 * FLATNESS * size)).sqrt();
            flat.max(sweep / TURN).min(MAX_CHORDS)
        }
    }
}

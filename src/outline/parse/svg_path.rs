//! The subpaths of an SVG path as segments, y upwards.
//!
//! `usvg` gives every path as lines and Bézier curves in single precision. Where the document has the same path as plain
//! numbers (`svg_exact`), those are taken instead, with its arcs; `usvg`'s transform is applied to them.

use glam::DAffine2;
use usvg::tiny_skia_path::{Path, PathSegment, Point};

use super::super::Segment;
use super::super::corners::turn_between;
use crate::geometry::DVec2;

/// A connected piece of a path.
#[derive(Debug, Clone)]
pub(super) struct Subpath {
    start: DVec2,
    segments: Vec<Segment>,
    closed_explicitly: bool,
}

impl Subpath {
    /// The subpaths of `path` in its own coordinates; those without a segment are left out.
    pub fn of(path: &Path) -> Vec<Self> {
        let place = |p: Point| DVec2::new(f64::from(p.x), f64::from(p.y));
        let mut subpaths: Vec<Self> = Vec::new();
        for segment in path.segments() {
            match segment {
                PathSegment::MoveTo(p) => subpaths.push(Self::at(place(p))),
                PathSegment::LineTo(p) => with_last(&mut subpaths, |s| s.line(place(p))),
                PathSegment::QuadTo(q, p) => with_last(&mut subpaths, |s| s.quadratic(place(q), place(p))),
                PathSegment::CubicTo(b, c, d) => {
                    with_last(&mut subpaths, |s| s.cubic(place(b), place(c), place(d)));
                }
                PathSegment::Close => with_last(&mut subpaths, Self::close),
            }
        }
        subpaths.retain(|s| !s.segments.is_empty());
        subpaths
    }

    pub fn at(start: DVec2) -> Self {
        Self { start, segments: Vec::new(), closed_explicitly: false }
    }

    pub fn start(&self) -> DVec2 {
        self.start
    }

    pub fn end(&self) -> DVec2 {
        self.segments.last().map_or(self.start, Segment::end)
    }

    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    pub fn line(&mut self, to: DVec2) {
        self.segments.push(Segment::Line([self.end(), to]));
    }

    pub fn cubic(&mut self, b: DVec2, c: DVec2, d: DVec2) {
        self.segments.push(Segment::Cubic([self.end(), b, c, d]));
    }

    pub fn quadratic(&mut self, control: DVec2, end: DVec2) {
        let third = 2.0 / 3.0;
        self.cubic(self.end().lerp(control, third), end.lerp(control, third), end);
    }

    pub fn push(&mut self, segment: Segment) {
        self.segments.push(segment);
    }

    pub fn close(&mut self) {
        self.closed_explicitly = true;
    }

    /// Whether it was closed explicitly.
    pub fn is_closed_explicitly(&self) -> bool {
        self.closed_explicitly
    }

    /// Whether the subpath was closed explicitly or ends where it starts.
    pub fn is_closed(&self) -> bool {
        self.closed_explicitly || self.end() == self.start
    }

    /// The closed chain of segments, transformed, y upwards; without those of no length, and lines no longer than rounding, as
    /// between the arcs of a pill.
    pub fn placed(&self, placement: DAffine2) -> Vec<Segment> {
        // SVG's y points down
        let upwards = |p: DVec2| DVec2::new(p.x, -p.y);
        let turn = |p: DVec2| upwards(placement.transform_vector2(p));
        let place = |p: DVec2| upwards(placement.transform_point2(p));
        let placed = |segment: &Segment| match *segment {
            Segment::Line(ends) => Segment::Line(ends.map(place)),
            Segment::Cubic(control) => Segment::Cubic(control.map(place)),
            Segment::Arc { center, axes, from, to } => {
                Segment::Arc { center: place(center), axes: axes.map(turn), from, to }
            }
        };
        let chain = self.closed_chain();
        let shortest = SAME_END * chain.iter().fold(0.0, |size: f64, s| size.max(s.end().abs().max_element()));
        chain.iter().filter(|segment| has_length(segment, shortest)).map(placed).map(straightened).collect()
    }

    /// The segments and the line back to the start. If that is no longer than rounding, the last segment ends there
    /// instead.
    fn closed_chain(&self) -> Vec<Segment> {
        let mut chain = self.segments.clone();
        let (start, gap) = (self.start, self.end() - self.start);
        let size = chain.iter().fold(0.0, |size: f64, s| size.max(s.end().abs().max_element()));
        if gap == DVec2::ZERO {
            return chain;
        }
        match chain.last_mut() {
            Some(Segment::Line([_, end]) | Segment::Cubic([.., end])) if gap.length() <= SAME_POINT * size => {
                *end = start;
            }
            Some(Segment::Arc { .. }) if gap.length() <= SAME_END * size => {}
            _ => chain.push(Segment::Line([self.end(), start])),
        }
        chain
    }
}

/// Ends nearer to the start, in largest coordinates, are the start: sums of steps in single precision.
const SAME_POINT: f64 = 2e-6;
/// The same for ends of arcs, which are computed in double precision and cannot be moved.
const SAME_END: f64 = 1e-13;

/// A drawing command before the first "move to" draws nothing; `tiny_skia_path` never yields one.
fn with_last(subpaths: &mut [Subpath], change: impl FnOnce(&mut Subpath)) {
    if let Some(last) = subpaths.last_mut() {
        change(last);
    }
}

fn has_length(segment: &Segment, shortest: f64) -> bool {
    match segment {
        Segment::Line([a, b]) => a.distance(*b) > shortest,
        Segment::Cubic([a, b, c, d]) => a != b || a != c || a != d,
        Segment::Arc { from, to, .. } => from != to,
    }
}

/// A cubic whose inner control points are its ends is the line between them; its parametrization would have no speed
/// at the ends.
fn straightened(segment: Segment) -> Segment {
    match segment {
        Segment::Cubic([a, b, c, d]) if b == a && c == d => Segment::Line([a, d]),
        other => other,
    }
}

/// Tangents of neighboring Bézier curves that differ by less, from rounding, become one.
///
/// With coordinates of single precision (6e-8 of the drawing's size) and handles of 1/50 of it, two tangents differ by
/// up to 6e-6; the bluntest joint meant as a corner that was seen, of the turkey, has 1.5e-2.
const ONE_TANGENT: f64 = 2e-5;

/// Turns the handles on both sides of each smooth joint into one direction: half of the way each, or beside a line or
/// an arc all of it.
pub(super) fn with_common_tangents(mut segments: Vec<Segment>) -> Vec<Segment> {
    let n = segments.len();
    for k in 0..n {
        let before = (k + n - 1) % n;
        let turn = match (out_of(&segments[before]), segments[k].direction()) {
            (Some(a), Some(b)) => turn_between(a, b),
            _ => continue,
        };
        if before == k || turn == 0.0 || turn.abs() > ONE_TANGENT {
            continue;
        }
        let is_cubic = [before, k].map(|j| matches!(segments[j], Segment::Cubic(_)));
        let (first, second) = match is_cubic {
            [true, true] => (0.5 * turn, -0.5 * turn),
            [true, false] => (turn, 0.0),
            [false, true] => (0.0, -turn),
            [false, false] => continue,
        };
        if let Segment::Cubic([.., c, d]) = &mut segments[before] {
            *c = *d + DVec2::from_angle(first).rotate(*c - *d);
        }
        if let Segment::Cubic([a, b, ..]) = &mut segments[k] {
            *b = *a + DVec2::from_angle(second).rotate(*b - *a);
        }
    }
    segments
}

/// The direction at the end, if it has one.
fn out_of(segment: &Segment) -> Option<DVec2> {
    segment.reversed().direction().map(|direction| -direction)
}

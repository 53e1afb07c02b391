//! The subpaths of an SVG path as dense polygons, y upwards.
//!
//! Curves are cut into equal parameter steps, as many as needed for chords to deviate from the
//! curve by less than 1e-5 of the subpath's size (Wang's bound for Bézier
//! curves) and to turn by about 0.04 from one to the next.

use usvg::Transform;
use usvg::tiny_skia_path::{Path, PathSegment, Point};

use crate::geometry::{Bounds, DVec2, MAX_POINTS};

/// The distance of a chord from its curve, as a fraction of the subpath's size.
const FLATNESS: f64 = 1e-5;

/// The turn from chord to chord, in radians.
const TURN: f64 = 0.04;

/// The largest number of chords for one curve.
const MAX_CHORDS: f64 = 512.0;

#[derive(Debug, Clone, Copy)]
enum Segment {
    Line(DVec2),
    Cubic([DVec2; 3]),
}

/// A connected piece of a path.
#[derive(Debug)]
pub(super) struct Subpath {
    start: DVec2,
    segments: Vec<Segment>,
    closed_explicitly: bool,
}

impl Subpath {
    /// The subpaths of `path`, transformed; those without a segment are left out.
    pub fn of(path: &Path, transform: Transform) -> Vec<Self> {
        let place = |p: Point| {
            let [x, y] = [p.x, p.y].map(f64::from);
            let [sx, kx, ky, sy, tx, ty] =
                [transform.sx, transform.kx, transform.ky, transform.sy, transform.tx, transform.ty].map(f64::from);
            // SVG's y points down.
            DVec2::new(sx * x + kx * y + tx, -(ky * x + sy * y + ty))
        };
        let mut subpaths: Vec<Self> = Vec::new();
        for segment in path.segments() {
            match segment {
                PathSegment::MoveTo(p) => subpaths.push(Self::at(place(p))),
                PathSegment::LineTo(p) => with_last(&mut subpaths, |s| s.segments.push(Segment::Line(place(p)))),
                PathSegment::QuadTo(q, p) => with_last(&mut subpaths, |s| s.quadratic(place(q), place(p))),
                PathSegment::CubicTo(b, c, d) => {
                    with_last(&mut subpaths, |s| s.segments.push(Segment::Cubic([b, c, d].map(place))));
                }
                PathSegment::Close => with_last(&mut subpaths, |s| s.closed_explicitly = true),
            }
        }
        subpaths.retain(|s| !s.segments.is_empty());
        subpaths
    }

    fn at(start: DVec2) -> Self {
        Self { start, segments: Vec::new(), closed_explicitly: false }
    }

    fn end(&self) -> DVec2 {
        self.segments.last().map_or(self.start, Segment::end)
    }

    fn quadratic(&mut self, control: DVec2, end: DVec2) {
        let third = 2.0 / 3.0;
        let inner = [self.end().lerp(control, third), end.lerp(control, third), end];
        self.segments.push(Segment::Cubic(inner));
    }

    /// Whether the subpath was closed explicitly or ends where it starts.
    pub fn is_closed(&self) -> bool {
        self.closed_explicitly || self.end() == self.start
    }

    /// The points, without repeating consecutive ones or the first.
    pub fn flatten(&self) -> Vec<DVec2> {
        let all = self.segments.iter().flat_map(Segment::points);
        let size = Bounds::of([self.start].into_iter().chain(all)).size().max_element();
        let mut coarseness = 1.0;
        loop {
            let points = self.flatten_to(size, coarseness);
            // 64 times coarser means at most 8 chords a curve: if that is too many, so are the file's own segments.
            if points.len() <= MAX_POINTS || coarseness >= 64.0 {
                return points;
            }
            coarseness *= 4.0;
        }
    }

    fn flatten_to(&self, size: f64, coarseness: f64) -> Vec<DVec2> {
        let mut points = vec![self.start];
        let mut push = |p: DVec2| {
            // A segment without length is no edge.
            if points.last() != Some(&p) {
                points.push(p);
            }
        };
        let mut from = self.start;
        for segment in &self.segments {
            if let Segment::Cubic(control) = segment {
                let count = (chords(from, control, size) / coarseness).ceil().max(1.0);
                for k in 1..count as u32 {
                    push(bezier(from, control, f64::from(k) / count));
                }
            }
            from = segment.end();
            push(from);
        }
        while points.len() > 1 && points.last() == points.first() {
            points.pop();
        }
        points
    }
}

impl Segment {
    fn end(&self) -> DVec2 {
        match *self {
            Self::Line(p) | Self::Cubic([.., p]) => p,
        }
    }

    fn points(&self) -> impl Iterator<Item = DVec2> + use<> {
        match *self {
            Self::Line(p) => [p, p, p],
            Self::Cubic(control) => control,
        }
        .into_iter()
    }
}

/// A drawing command before the first "move to" draws nothing; `tiny_skia_path` never yields one.
fn with_last(subpaths: &mut [Subpath], change: impl FnOnce(&mut Subpath)) {
    if let Some(last) = subpaths.last_mut() {
        change(last);
    }
}

fn bezier(a: DVec2, &[b, c, d]: &[DVec2; 3], t: f64) -> DVec2 {
    let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
    ab.lerp(bc, t).lerp(bc.lerp(cd, t), t)
}

/// The number of chords that the curve needs, not rounded.
fn chords(a: DVec2, &[b, c, d]: &[DVec2; 3], size: f64) -> f64 {
    let bend = (a - 2.0 * b + c).length().max((b - 2.0 * c + d).length());
    let flat = (0.75 * bend / (FLATNESS * size)).sqrt();
    let legs = [b - a, c - b, d - c];
    let turn = |u: DVec2, v: DVec2| if u == DVec2::ZERO || v == DVec2::ZERO { 0.0 } else { u.angle_to(v).abs() };
    let smooth = (turn(legs[0], legs[1]) + turn(legs[1], legs[2])) / TURN;
    // NaN, from coordinates that overflow, becomes the maximum; the polygon check reports such coordinates.
    flat.max(smooth).min(MAX_CHORDS)
}

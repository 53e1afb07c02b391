//! The boundary map between two curves as pairs of complex numbers, cut at the junctions of both.
//!
//! Next to a corner of the mapped curve offsets are taken on that curve; next to the preimage of a corner of the other
//! one, on the other: the relative distance from the corner is then exact. Where two corners are mapped to each other,
//! offsets are taken on the mapped curve. Breaks are ordered by their harmonic measure from the anchor, which both
//! curves share and which is accurate to 1e-300 next to the anchor; arcs that are too short for their curve's
//! coordinates to be told apart collapse to a point.

use super::samples::Boundary;
use crate::conformal::CurveMap;
use crate::geometry::{Curve, CurvePoint, DVec2, Junction, sort_by_number};
use num_complex::Complex64;

/// The share of the estimated error within which a junction and the preimage of a junction are one point: the estimate
/// of a measure is about 100 times its error, that of a point at a right angle 10 to 20 times.
const ONE_BREAK: f64 = 0.2;
/// The same for curves without an error, in perimeters.
const ROUNDING: f64 = 1e-12;
/// Bisections for the middle of an arc; the middle need not be exact.
const BISECTIONS: usize = 40;

/// One of the two curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum On {
    From,
    Onto,
}

/// A part of one piece of one curve.
#[derive(Debug, Clone, Copy)]
struct Span {
    start: CurvePoint,
    end: CurvePoint,
}

impl Span {
    /// The point at a share of the parameter, relatively exact next to the ends of the piece.
    fn at(&self, share: f64) -> CurvePoint {
        let between = |from: f64, to: f64| from + share * (to - from);
        let from_start = between(self.start.from_start(), self.end.from_start());
        let to_end = between(self.start.to_end(), self.end.to_end());
        let piece = self.start.piece();
        if from_start <= to_end { CurvePoint::new(piece, from_start) } else { CurvePoint::before_end(piece, to_end) }
    }

    /// The share at a point of the same piece, in [0, 1].
    fn share(&self, point: CurvePoint) -> f64 {
        let length = self.end.from_start() - self.start.from_start();
        if length > 0.0 { ((point.from_start() - self.start.from_start()) / length).clamp(0.0, 1.0) } else { 0.5 }
    }
}

/// A junction of either curve, or of both.
#[derive(Debug, Clone, Copy)]
struct Break {
    /// Order along the boundary: the half, and the measure from the anchor, negative if counted backwards.
    order: (u8, f64),
    from: CurvePoint,
    onto: CurvePoint,
    is_of_from: bool,
    is_of_onto: bool,
    is_singular: bool,
}

/// Half an arc between two breaks, from its break to its middle.
#[derive(Debug, Clone, Copy)]
struct Ray {
    on: On,
    span: Span,
    is_singular: bool,
    /// z and f(z) at the break.
    first: [DVec2; 2],
}

/// The boundary of a curve with its map.
#[derive(Debug)]
pub struct MatchedBoundary<'a> {
    map: CurveMap<'a>,
    inverse: CurveMap<'a>,
    rays: Vec<Ray>,
}

impl<'a> MatchedBoundary<'a> {
    /// The mapped curve of `map`, whose inverse is `inverse`.
    pub fn new(map: CurveMap<'a>, inverse: CurveMap<'a>) -> Self {
        let breaks = breaks(&map, &inverse);
        let mut matched = Self { map, inverse, rays: Vec::new() };
        let rays = (0..breaks.len()).flat_map(|k| matched.rays_of(&breaks, k)).collect();
        matched.rays = rays;
        matched
    }

    /// The largest estimated error of a value, at the breaks and in the middle of the rays.
    pub fn value_error(&self) -> f64 {
        let at = |ray: &Ray, share: f64| {
            let point = ray.span.at(share);
            self.map.error(if ray.on == On::From { point } else { self.inverse.image(point) })
        };
        self.rays.iter().flat_map(|ray| [at(ray, 0.0), at(ray, 0.5), at(ray, 1.0)]).fold(0.0, f64::max)
    }

    /// The two rays of the arc from break `k` to the next one.
    fn rays_of(&self, breaks: &[Break], k: usize) -> [Ray; 2] {
        let ends = [&breaks[k], &breaks[(k + 1) % breaks.len()]];
        let last = |is_own: fn(&Break) -> bool| {
            let count = breaks.len();
            (0..count).map(|back| &breaks[(k + count - back) % count]).find(|at| is_own(at))
        };
        let from_piece = last(|at| at.is_of_from).map_or(0, |at| at.from.piece());
        let onto_piece = last(|at| at.is_of_onto).map_or(0, |at| at.onto.piece());
        let [from, onto] = [
            span(from_piece, ends.map(|at| (at.from, at.is_of_from))),
            span(onto_piece, ends.map(|at| (at.onto, at.is_of_onto))),
        ];
        let on = ends.map(|at| if at.is_of_onto && !at.is_of_from { On::Onto } else { On::From });
        let middle = self.middle(on, from, onto);
        [0, 1].map(|k| {
            let (whole, middle) = if on[k] == On::From { (from, middle[0]) } else { (onto, middle[1]) };
            let start = if k == 0 { whole.start } else { whole.end };
            let places = [self.map.from_curve().position(ends[k].from), self.map.onto_curve().position(ends[k].onto)];
            Ray { on: on[k], span: Span { start, end: middle }, is_singular: ends[k].is_singular, first: places }
        })
    }

    /// A point of an arc, on both curves, such that either ray takes a large part of the curve that its offsets are on.
    fn middle(&self, on: [On; 2], from: Span, onto: Span) -> [CurvePoint; 2] {
        if on == [On::Onto; 2] {
            let middle = onto.at(0.5);
            return [clamped(self.inverse.image(middle), from), middle];
        }
        let image = |share: f64| clamped(self.map.image(from.at(share)), onto);
        let (mut low, mut high) = (0.0, 1.0);
        let mut share = 0.5;
        for _ in 0..if on == [On::From; 2] { 0 } else { BISECTIONS } {
            if share + onto.share(image(share)) > 1.0 {
                high = share;
            } else {
                low = share;
            }
            share = 0.5 * (low + high);
        }
        [from.at(share), image(share)]
    }
}

impl Boundary for MatchedBoundary<'_> {
    fn rays(&self) -> usize {
        self.rays.len()
    }

    fn is_singular(&self, ray: usize) -> bool {
        self.rays[ray].is_singular
    }

    fn pair(&self, ray: usize, offset: f64) -> [Complex64; 2] {
        let Ray { on, span, first, .. } = self.rays[ray];
        let places = match on {
            _ if offset == 0.0 => first,
            On::From => {
                let point = span.at(offset);
                [self.map.from_curve().position(point), self.map.onto_curve().position(self.map.image(point))]
            }
            On::Onto => {
                let point = span.at(offset);
                [self.map.from_curve().position(self.inverse.image(point)), self.map.onto_curve().position(point)]
            }
        };
        places.map(|place| Complex64::new(place.x, place.y))
    }
}

/// The junctions of both curves, in order; one that is mapped to another one only once.
fn breaks(map: &CurveMap<'_>, inverse: &CurveMap<'_>) -> Vec<Break> {
    let junctions = |curve: &Curve| -> Vec<(CurvePoint, bool)> {
        let is_singular = |junction: &Junction| *junction != Junction::Analytic;
        curve.junctions().iter().enumerate().map(|(k, at)| (CurvePoint::new(k, 0.0), is_singular(at))).collect()
    };
    let of_from = junctions(map.from_curve()).into_iter().map(|(from, is_singular)| {
        let (order, onto) = (order(map.measure_at(from)), map.image(from));
        Break { order, from, onto, is_of_from: true, is_of_onto: false, is_singular }
    });
    let of_onto = junctions(map.onto_curve()).into_iter().map(|(onto, is_singular)| {
        let (order, from) = (order(inverse.measure_at(onto)), inverse.image(onto));
        Break { order, from, onto, is_of_from: false, is_of_onto: true, is_singular }
    });
    let mut breaks: Vec<Break> = of_from.chain(of_onto).collect();
    // equal numbers keep their order
    sort_by_number(&mut breaks, |at| at.order.1);
    sort_by_number(&mut breaks, |at| at.order.0.into());
    let mut merged: Vec<Break> = Vec::new();
    for next in breaks {
        match merged.last_mut() {
            Some(last) if is_same(map, inverse, last, &next) => *last = joined(last, &next),
            _ => merged.push(next),
        }
    }
    if let [first, .., last] = merged.as_slice()
        && is_same(map, inverse, last, first)
    {
        merged[0] = joined(first, last);
        merged.pop();
    }
    merged
}

/// The place of a point in the order along the boundary from its two measures.
fn order((forward, backward): (f64, f64)) -> (u8, f64) {
    if backward <= 0.0 || forward <= backward {
        (0, if backward <= 0.0 { 0.0 } else { forward })
    } else {
        (1, -backward)
    }
}

/// Whether a junction of one curve and one of the other are mapped to each other, up to the error.
fn is_same(map: &CurveMap<'_>, inverse: &CurveMap<'_>, a: &Break, b: &Break) -> bool {
    let (of_from, of_onto) = if a.is_of_from { (a, b) } else { (b, a) };
    if !of_from.is_of_from || of_from.is_of_onto || !of_onto.is_of_onto || of_onto.is_of_from {
        return false;
    }
    let apart = |curve: &Curve, a: CurvePoint, b: CurvePoint| curve.position(a).distance(curve.position(b));
    let (from, onto) = (map.from_curve(), map.onto_curve());
    apart(from, a.from, b.from) <= ONE_BREAK * inverse.error(of_onto.onto) + ROUNDING * from.perimeter()
        && apart(onto, a.onto, b.onto) <= ONE_BREAK * map.error(of_from.from) + ROUNDING * onto.perimeter()
}

/// A junction of both curves.
fn joined(a: &Break, b: &Break) -> Break {
    let (of_from, of_onto) = if a.is_of_from { (a, b) } else { (b, a) };
    let is_singular = a.is_singular || b.is_singular;
    Break { onto: of_onto.onto, is_of_onto: true, is_singular, ..*of_from }
}

/// The part of a piece between two breaks, which are points of it or, if `true`, its ends.
fn span(piece: usize, [first, last]: [(CurvePoint, bool); 2]) -> Span {
    let whole = Span { start: CurvePoint::new(piece, 0.0), end: CurvePoint::before_end(piece, 0.0) };
    let own = |(point, is_end): (CurvePoint, bool), end: CurvePoint| if is_end { end } else { clamped(point, whole) };
    let (start, end) = (own(first, whole.start), own(last, whole.end));
    // by rounding a break may have come out behind the one before
    if end.from_start() < start.from_start() { Span { start, end: start } } else { Span { start, end } }
}

/// The point of a span at a point of its piece, or, by rounding, next to its piece: the end of the piece before or the
/// start of the next one.
fn clamped(point: CurvePoint, span: Span) -> CurvePoint {
    let piece = span.start.piece();
    if point.piece() != piece {
        return if point.to_end() < point.from_start() { span.start } else { span.end };
    }
    if point.from_start() < span.start.from_start() {
        span.start
    } else if point.from_start() > span.end.from_start() {
        span.end
    } else {
        point
    }
}

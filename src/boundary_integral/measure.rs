//! Harmonic measure along the curve: of pieces, of arcs between any two points, and from an anchor both ways.

use super::layout::Layout;
use super::peak::Peaks;
use super::span::{Beside, Span};
use super::spans::{self, spans, unresolved};
use super::system::System;
use crate::geometry::{Curve, CurvePoint};

/// The harmonic measure of the boundary, seen from one interior point; its total is 1.
#[derive(Debug, Clone)]
pub struct HarmonicMeasure {
    /// In the order of the curve.
    spans: Vec<Span>,
    /// The first span of each piece, and the number of spans.
    first: Vec<usize>,
    error: f64,
    floor: f64,
}

/// Rounding of sums over a thousand nodes: 8 units of the last place on the V.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// The accuracy of the identities: 1e-15 to 4e-14 on outlines whose measure is right to 1e-15.
const EVALUATED: f64 = 1e-13;
/// The estimate in indications: on the turkey and on points of the V the error is 1.1 to 1.6 times the largest one.
const SAFETY: f64 = 2.0;

impl HarmonicMeasure {
    /// From the transformed density of the interior problem, and the peaks of the panels near the point.
    pub(super) fn new(curve: &Curve, layout: &Layout, system: &System, solution: (&[f64], &Peaks)) -> Self {
        let (spans, first) = spans(curve, layout, system, solution);
        let total: f64 = spans.iter().map(|span| span.measure).sum();
        let unresolved = unresolved(curve, layout, &spans, solution);
        Self { spans, first, error: unresolved.max((total - 1.0).abs()).max(ROUNDING), floor: spans::ROUNDING }
    }

    /// Takes a residual of an identity into the error estimate.
    pub(super) fn with_residual(mut self, residual: f64) -> Self {
        self.error = self.error.max(residual);
        self.floor = self.floor.max(residual);
        self
    }

    /// An estimate of the error of ω that is left also where the density is almost nothing: rounding, and the residuals
    /// of the identities.
    pub fn floor(&self) -> f64 {
        self.floor
    }

    /// What the identities are violated by beyond the accuracy to which they are evaluated, and the most negative measure of
    /// a piece.
    pub(super) fn violation(&self) -> f64 {
        let residual = if self.floor > EVALUATED { self.floor } else { 0.0 };
        self.pieces().into_iter().fold(residual, |most, measure| most.max(-measure))
    }

    /// An estimate of the largest error of ω along the boundary: the residuals of ∫ dω = 1, ∫ z dω = x and
    /// ∫ log|z − a| dω = log|x − a|, and what the last coefficients of the panels leave open.
    /// Below 1e-12 it may be several times too small: on one of a hundred random stars it was, by a factor of four.
    pub fn error_estimate(&self) -> f64 {
        SAFETY * self.error
    }

    /// The measure of each piece of the curve.
    pub fn pieces(&self) -> Vec<f64> {
        let sum = |pair: &[usize]| self.spans[pair[0]..pair[1]].iter().map(|span| span.measure).sum();
        self.first.windows(2).map(sum).collect()
    }

    /// The points between which the density is one polynomial, or next to a corner one power, in the order of the curve.
    pub fn breaks(&self) -> Vec<CurvePoint> {
        self.spans.iter().map(Span::start).collect()
    }

    /// The index of the span that contains a point.
    fn span(&self, point: CurvePoint) -> usize {
        let piece = point.piece().min(self.first.len() - 2);
        let (first, end) = (self.first[piece], self.first[piece + 1]);
        let inside = self.spans[first..end].partition_point(|span| span.is_before(point));
        (first + inside).min(end - 1)
    }

    /// The measure of the arc from `a` counter-clockwise to `b`; small arcs keep their relative accuracy. 0 if both
    /// are one point.
    pub fn between(&self, a: CurvePoint, b: CurvePoint) -> f64 {
        let (first, last) = (self.span(a), self.span(b));
        let own = &self.spans[first];
        // where the density is almost nothing, its sign is that of an error: the order of points is not that of measures
        if first == last && !(b.from_start() < a.from_start() || b.to_end() > a.to_end()) {
            return own.between(a, b).max(0.0);
        }
        let ([_, after_a], [before_b, _]) = (own.parts(a), self.spans[last].parts(b));
        let count = self.spans.len();
        let spans_between = (last + count - first - 1) % count;
        let whole: f64 = (1..=spans_between).map(|k| self.spans[(first + k) % count].measure).sum();
        (after_a + whole + before_b).max(0.0)
    }

    /// The measure counted from a boundary point.
    pub fn from_anchor(&self, anchor: CurvePoint) -> AnchoredMeasure<'_> {
        AnchoredMeasure::new(self, anchor)
    }
}

/// Harmonic measure counted from an anchor, counter-clockwise and clockwise: each keeps its relative accuracy next to
/// the anchor.
#[derive(Debug, Clone)]
pub struct AnchoredMeasure<'a> {
    measure: &'a HarmonicMeasure,
    anchor: CurvePoint,
    /// The anchor's span.
    start: usize,
    /// The measure from the anchor to the beginning of segment k. Segments are the spans from the anchor on; the
    /// first one begins, and the last one ends, at the anchor.
    forward: Vec<f64>,
    /// The measure from the end of segment k on to the anchor.
    backward: Vec<f64>,
    /// The parts of the anchor's span before and after the anchor.
    around: [f64; 2],
    /// The sum of all steps: 1 up to the error.
    total: f64,
}

impl<'a> AnchoredMeasure<'a> {
    fn new(measure: &'a HarmonicMeasure, anchor: CurvePoint) -> Self {
        let (start, count) = (measure.span(anchor), measure.spans.len());
        let [before, after] = measure.spans[start].parts(anchor);
        let segment = |k: usize| match k {
            0 => after,
            _ if k == count => before,
            _ => measure.spans[(start + k) % count].measure,
        };
        let sums = |segments: &mut dyn Iterator<Item = usize>| {
            let mut sum = 0.0;
            let step = |k: usize| {
                let so_far = sum;
                // a tiny measure that rounding has made negative counts as none: ω does not decrease
                sum += segment(k).max(0.0);
                so_far
            };
            segments.map(step).collect::<Vec<f64>>()
        };
        let forward = sums(&mut (0..=count));
        let mut backward = sums(&mut (0..=count).rev());
        backward.reverse();
        let total = backward[0] + after.max(0.0);
        Self { measure, anchor, start, forward, backward, around: [before, after], total }
    }

    /// The measure next to the anchor, after and before it.
    pub fn beside_anchor(&self) -> [Beside; 2] {
        let (spans, count) = (&self.measure.spans, self.measure.spans.len());
        let own = &spans[self.start];
        let [before, after] = own.parts(self.anchor);
        let (next, last) = (&spans[(self.start + 1) % count], &spans[(self.start + count - 1) % count]);
        let after = if after == 0.0 { next.beside(next.start()) } else { own.beside(self.anchor) };
        let before = if before == 0.0 { last.beside(last.finish()) } else { own.beside(self.anchor) };
        let share = self.measure.floor / spans::ROUNDING;
        [after, before].map(|beside| Beside { error: share * beside.error, ..beside })
    }

    /// The segment that contains a point, and the measure of its parts before and after the point.
    fn segment(&self, point: CurvePoint) -> (usize, [f64; 2]) {
        let (measure, count) = (self.measure, self.measure.spans.len());
        let span = measure.span(point);
        let [before, after] = measure.spans[span].parts(point);
        if span != self.start {
            return ((span + count - self.start) % count, [before, after]);
        }
        // parts counted from the span's own end of the piece do not cancel there, where the anchor may be
        let is_behind = point.piece() == self.anchor.piece()
            && (point.from_start() < self.anchor.from_start() || point.to_end() > self.anchor.to_end());
        let own = &measure.spans[span];
        if is_behind {
            (count, [before, own.between(point, self.anchor)])
        } else {
            (0, [own.between(self.anchor, point), after])
        }
    }

    /// [`Self::forward`] and [`Self::backward`] of a point.
    pub fn both(&self, point: CurvePoint) -> [f64; 2] {
        let (k, [before, after]) = self.segment(point);
        [(self.forward[k] + before.max(0.0)) / self.total, (self.backward[k] + after.max(0.0)) / self.total]
    }

    /// The measure of the arc from the anchor counter-clockwise to the point.
    pub fn forward(&self, point: CurvePoint) -> f64 {
        self.both(point)[0]
    }

    /// The measure of the arc from the point counter-clockwise to the anchor: 1 less than the other, but with its own
    /// relative accuracy.
    pub fn backward(&self, point: CurvePoint) -> f64 {
        self.both(point)[1]
    }

    /// The point with the measure `forward` in [0, 1] behind it, counter-clockwise from the anchor.
    pub fn point_at(&self, forward: f64) -> CurvePoint {
        let wanted = forward.clamp(0.0, 1.0) * self.total;
        let k = self.forward.partition_point(|&sum| sum <= wanted).max(1) - 1;
        let own = self.within(k);
        // in the first segment, the measure counts from the anchor
        let offset = if k == 0 { self.around[0] } else { 0.0 };
        own.point(offset + (wanted - self.forward[k]), false)
    }

    /// The point with the measure `backward` in [0, 1] ahead of it, clockwise from the anchor.
    pub fn point_before(&self, backward: f64) -> CurvePoint {
        let wanted = backward.clamp(0.0, 1.0) * self.total;
        let k = self.backward.partition_point(|&sum| sum > wanted).min(self.backward.len() - 1);
        let own = self.within(k);
        let offset = if k + 1 == self.backward.len() { self.around[1] } else { 0.0 };
        own.point(offset + (wanted - self.backward[k]), true)
    }

    /// The span of a segment.
    fn within(&self, segment: usize) -> &Span {
        let spans = &self.measure.spans;
        &spans[(self.start + segment) % spans.len()]
    }
}

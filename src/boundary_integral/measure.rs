//! Harmonic measure along the curve: of pieces, of arcs between any two points, and from an anchor both ways.

use super::corner::{Compressed, Problem};
use super::layout::{Block, End, Layout};
use super::legendre::{NODES, Rule};
use super::span::{Beside, Rounding, Span};
use super::system::{System, gather};
use crate::geometry::{Curve, CurvePoint};
use faer::Mat;

/// The harmonic measure of the boundary, seen from one interior point; its total is 1.
#[derive(Debug, Clone)]
pub struct HarmonicMeasure {
    /// In the order of the curve.
    spans: Vec<Span>,
    /// The first span of each piece, and the number of spans.
    first: Vec<usize>,
    error: f64,
}

/// The bits of a density that the recursion into a corner shares between its two errors, see [`depth`].
const BITS: f64 = 53.0;

/// The levels after which the recursion into a corner ends, and the measure is a power of the distance.
///
/// Into a corner of less than π the density falls as 2^{−(e−1)} from level to level, e = π/α, but its rounding error does
/// not: after L levels it is 2^{(e−1)L − 53} of the density. The power leaves out the next mode, r^{2e}, or r^{e+1} of
/// curved legs, which is 2^{−eL} or 2^{−L} of it. The depth is that at which both are equal: in the square's corners
/// the measure is then right to 1e-10 of itself at every distance.
fn depth(exponent: f64, is_straight: bool) -> usize {
    let next_mode = if is_straight { exponent } else { exponent.min(1.0) };
    (BITS / ((exponent - 1.0).max(0.0) + next_mode)).ceil() as usize
}

/// The error that rounding leaves in the density times the perimeter. Where the true density is nothing, in the arms of
/// the V and the ends of rectangles of 10×1 and 40×1, it is found to be 2e-17 to 4e-15.
const ROUNDING: f64 = 4e-15;

/// The measure of both legs of a block with these true densities at its nodes, and their lengths.
fn leg_measures(curve: &Curve, block: &Block, density: &Mat<f64>) -> [(f64, f64); 2] {
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let rows = block.mesh.panels * NODES;
    [0, 1].map(|leg| {
        let panel = block.scales[leg] * curve.lengths()[pieces[leg]];
        let weight = |k: usize| 0.5 * panel * Rule::get().weights[k % NODES];
        let measure = (0..rows).map(|k| weight(k) * density[(leg * rows + k, 0)]).sum();
        (measure, panel * block.mesh.panels as f64)
    })
}

/// The spans of a block on both its legs, from the junction outwards. `least` is the density that rounding leaves.
fn block_spans(
    curve: &Curve,
    block: &Block,
    compressed: &Compressed,
    (exponent, least): (f64, f64),
    density: Mat<f64>,
) -> [Vec<Span>; 2] {
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let ends = [End::Finish, End::Start];
    let outer_panels = block.mesh.outer();
    let legs = leg_measures(curve, block, &(&compressed.matrix * &density));
    let rounding = legs.map(|(measure, length)| Rounding::Corner {
        relative: (least * length / measure.abs()).max(f64::EPSILON),
        measure,
    });
    let (mut spans, mut density, mut shrink) = ([Vec::new(), Vec::new()], density, 1.0);
    let is_straight = pieces.iter().all(|&piece| curve.pieces()[piece].is_straight());
    for level in 0..depth(exponent, is_straight) {
        let step = compressed.step(level);
        let outer = &step.outer * &density;
        for leg in 0..2 {
            let unit = block.scales[leg] * shrink;
            for (k, &(start, length)) in outer_panels.iter().enumerate().rev() {
                let row = (leg * outer_panels.len() + k) * NODES;
                let half = 0.5 * length * unit * curve.lengths()[pieces[leg]];
                let values = std::array::from_fn(|i| half * outer[(row + i, 0)]);
                let places = [start * unit, (start + length) * unit];
                spans[leg].push(Span::new(pieces[leg], ends[leg], places, &values, rounding[leg]));
            }
        }
        density = &step.inner * &density;
        shrink *= 0.5;
    }
    let rest = leg_measures(curve, block, &(&compressed.innermost * &density));
    for leg in 0..2 {
        let to = block.scales[leg] * shrink * block.mesh.panels as f64;
        spans[leg].push(Span::rest(pieces[leg], ends[leg], to, shrink * rest[leg].0, exponent, rounding[leg]));
    }
    spans.map(|mut list| {
        list.reverse();
        list
    })
}

impl HarmonicMeasure {
    /// From the transformed density of the interior problem.
    pub(super) fn new(curve: &Curve, layout: &Layout, system: &System, transformed: &[f64]) -> Self {
        let least = ROUNDING / curve.perimeter();
        let of_block = |(block, (rows, compressed)): (&Block, &(Vec<usize>, Compressed))| {
            let exponent = Problem::Interior.exponent(curve.junctions()[block.junction]);
            block_spans(curve, block, compressed, (exponent, least), gather(rows, transformed))
        };
        let mut of_blocks: Vec<[Vec<Span>; 2]> = layout.blocks.iter().zip(system.blocks()).map(of_block).collect();
        let mut spans = Vec::new();
        let mut first = vec![0; curve.pieces().len() + 1];
        for (index, panel) in layout.panels.iter().enumerate() {
            match (panel.block, panel.end) {
                (None, end) => {
                    let half = 0.5 * (panel.to - panel.from) * curve.lengths()[panel.piece];
                    let values = std::array::from_fn(|i| half * transformed[index * NODES + i]);
                    let rounding = Rounding::Density(half * least);
                    spans.push(Span::new(panel.piece, end, [panel.from, panel.to], &values, rounding));
                }
                // the first panel of a block's leg stands for all of the leg, the others find nothing left
                (Some(block), End::Start) => spans.append(&mut of_blocks[block][1]),
                (Some(block), End::Finish) => spans.extend(of_blocks[block][0].drain(..).rev()),
            }
            first[panel.piece + 1] = spans.len();
        }
        let total: f64 = spans.iter().map(|span| span.measure).sum();
        let unresolved = spans.iter().map(Span::unresolved).fold(0.0, f64::max);
        Self { spans, first, error: unresolved.max((total - 1.0).abs()).max(f64::EPSILON) }
    }

    /// Takes a residual of an identity into the error estimate.
    pub(super) fn with_residual(mut self, residual: f64) -> Self {
        self.error = self.error.max(residual);
        self
    }

    /// An estimate of the largest error of ω along the boundary: the residuals of ∫ dω = 1, ∫ z dω = x and
    /// ∫ log|z − a| dω = log|x − a|, and what the last coefficients of the panels leave open.
    pub fn error_estimate(&self) -> f64 {
        self.error
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
        let ([before_a, after_a], [before_b, _]) = (self.spans[first].parts(a), self.spans[last].parts(b));
        if first == last && before_b >= before_a {
            return before_b - before_a;
        }
        let count = self.spans.len();
        let spans_between = (last + count - first - 1) % count;
        let whole: f64 = (1..=spans_between).map(|k| self.spans[(first + k) % count].measure).sum();
        after_a + whole + before_b
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
        [after, before]
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
        let between = measure.spans[span].between(self.anchor, point).abs();
        let is_behind = point.piece() == self.anchor.piece()
            && (point.from_start() < self.anchor.from_start() || point.to_end() > self.anchor.to_end());
        if is_behind { (count, [before, between]) } else { (0, [between, after]) }
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

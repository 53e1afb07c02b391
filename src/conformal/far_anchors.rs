//! Further anchors, in parts of both boundaries that are far from both points.
//!
//! Measure is counted from the anchors, where 1e-16 is told apart. A part of a boundary with less than that is one place
//! of the other boundary, or the other boundary is resolved there. Where it is not either (two spirals of one shape
//! with both points at their outer ends), the constraints, rounded to f64, do not determine how the two parts
//! correspond. Of the maps that do not differ by more than the error of the measures, the one is taken that maps the
//! places of least density onto each other. From there measure is counted anew, both ways; values below
//! [`FarAnchor::limit`] are those of both parts, each by the nearest anchor. Within such a part others may be as far from
//! the new anchors; with finite elements the search goes on there, while the boundary integral leaves noise.
//!
//! The order along the boundary is kept up to the error of the measures where the parts end. Cost O(m) where there are
//! none, as nearly always, and O(m + panels) for each.

use super::curved::{SharpMeasure, Way, nearer};
use super::{HarmonicMeasure, PerSide, PreparedSide, Side};
use crate::outline::BoundaryPoint;

/// Intervals with less of the measure between them and the anchor are not resolved from there: sums of a thousand terms
/// have errors of a few units of the last place.
const FAR: f64 = 1e-15;

/// The least length of a far part, in perimeters: the legs of a sharp corner.
const LEAST_LENGTH: f64 = 1e-5;

/// The least length, in perimeters, of parts that are looked at.
const LONG: f64 = 1e-3;

/// Measures of parts that differ by more than this, or, of long ones, by the floors of the measures, are told apart,
/// however large the estimates of their errors are.
const MOST_ERROR: f64 = 1e-12;

/// The rounding of sums of finite elements.
const ROUNDING: f64 = 1e-14;

/// The largest measure that is counted from a far anchor, where it has three digits more than [`FAR`].
const LIMIT: f64 = 1e-12;

/// Near the main anchor measures have a relative error. Those above this one have an absolute one.
const NEAR: f64 = 1e-3;

/// The least limit in differences between both sides' measures at the far anchors: what the ends of the parts are
/// apart.
const LIMIT_IN_DIFFERENCES: f64 = 30.0;

/// The least limit in measures of the parts: a boundary integral that is not resolved may leave more than [`LIMIT`] to a
/// part, next to which it has few digits.
const LIMIT_IN_PARTS: f64 = 3.0;

/// The largest limit, in measures between the far anchor and the next one: nearer to that one, its own are better.
const MOST_LIMIT: f64 = 0.1;

/// The density, in those of the next vertices, of vertices to which finite elements give none: those next to a sharp
/// corner whose triangles have no interior vertex.
const EMPTY: f64 = 1e-2;

/// The most parts inside of others.
const DEPTH: usize = 4;

/// Corresponding anchors in far parts of both boundaries.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FarAnchor {
    /// The measures counted from there.
    pub measures: PerSide<HarmonicMeasure>,
    /// The measure up to which these are used, both ways.
    pub limit: f64,
}

impl FarAnchor {
    /// The same anchors on other samples of one side, which are at these places of the present ones, with their measure;
    /// `None` if the anchor is not among them.
    pub fn on_other_samples(
        &self,
        side: Side,
        samples: (&PreparedSide, &HarmonicMeasure),
        places: &[BoundaryPoint],
    ) -> Option<Self> {
        let anchor = self.measures[side].anchor();
        let knot = samples.1.knot_of(places.iter().position(|&place| place == anchor)?);
        let mut measures = self.measures.clone();
        measures[side] = from_knot(samples, knot, self.limit);
        Some(Self { measures, limit: self.limit })
    }

    /// Whether finite elements give a vertex's measure.
    pub fn is_continued(&self, side: Side, vertex: usize) -> bool {
        let measure = &self.measures[side];
        let knot = measure.knot_of(vertex);
        nearer(measure, knot).0 < self.limit && measure.sharp().is_some_and(|sharp| sharp.is_continued(knot))
    }
}

/// The far anchors of both sides' measures; those inside of others' parts come first.
pub(super) fn far_anchors(measures: PerSide<(&PreparedSide, &HarmonicMeasure)>) -> Vec<FarAnchor> {
    let mut found = Vec::new();
    search(&measures, f64::INFINITY, DEPTH, &mut found);
    found
}

/// Appends the far anchors that have less than `within` from the anchors of `sides`.
fn search(sides: &PerSide<(&PreparedSide, &HarmonicMeasure)>, within: f64, depth: usize, found: &mut Vec<FarAnchor>) {
    let parts = far_parts(sides.source);
    if parts.is_empty() || depth == 0 {
        return;
    }
    for pair in pairs(sides, &parts, &far_parts(sides.target)) {
        if pair.omega >= within {
            continue;
        }
        let measures = PerSide::from_fn(|side| from_knot(sides[side], pair.knots[side], pair.limit));
        let limit = measures.iter().map(|(_, measure)| continued(measure)).fold(pair.limit, f64::max);
        if limit < MOST_LIMIT * pair.omega {
            let inner = PerSide::from_fn(|side: Side| (sides[side].0, &measures[side]));
            search(&inner, limit, depth - 1, found);
            found.push(FarAnchor { measures, limit });
        }
    }
}

/// A far part of a boundary: a stretch that is not resolved from the anchor.
struct Stretch {
    /// The vertex of least density.
    knot: usize,
    /// The measure by finite elements.
    measure: f64,
    /// Whether it is long enough to be looked at.
    is_long: bool,
}

/// Knots of both sides' measures that correspond.
struct Pair {
    knots: PerSide<usize>,
    /// The smaller one of the measures from the anchor.
    omega: f64,
    limit: f64,
}

/// The far parts of both sides, in their order, whose measures from the anchor differ by no more than their errors.
fn pairs(sides: &PerSide<(&PreparedSide, &HarmonicMeasure)>, source: &[Stretch], target: &[Stretch]) -> Vec<Pair> {
    let sum = |of: fn(&SharpMeasure) -> f64| -> f64 {
        Side::BOTH.iter().filter_map(|&side| sides[side].1.sharp()).map(of).sum()
    };
    let (error, floor) = (sum(SharpMeasure::error), sum(SharpMeasure::floor));
    let mut pairs = Vec::new();
    let mut rest = target;
    for here in source {
        let [forward, backward] = both(sides.source.1, here.knot);
        let omega = forward.min(backward);
        let scale = (omega / NEAR).min(1.0);
        let difference = |there: &Stretch| {
            let there = both(sides.target.1, there.knot);
            if forward <= backward { (there[0] - forward).abs() } else { (there[1] - backward).abs() }
        };
        let Some(nearest) = (0..rest.len()).min_by(|&a, &b| difference(&rest[a]).total_cmp(&difference(&rest[b])))
        else {
            break;
        };
        let (difference, there) = (difference(&rest[nearest]), &rest[nearest]);
        let most = if here.is_long && there.is_long { MOST_ERROR.max(floor) } else { MOST_ERROR };
        if difference <= (error.min(most) + ROUNDING) * scale {
            let parts = LIMIT_IN_PARTS * here.measure.max(there.measure);
            let limit = (LIMIT * scale).max(LIMIT_IN_DIFFERENCES * difference).max(parts);
            pairs.push(Pair { knots: PerSide::new(here.knot, there.knot), omega, limit });
            rest = &rest[nearest + 1..];
        }
    }
    pairs
}

/// The measures from the anchor to a knot, counter-clockwise and clockwise.
fn both(measure: &HarmonicMeasure, knot: usize) -> [f64; 2] {
    let forward = measure.at_knots()[knot];
    [forward, measure.sharp().map_or(1.0 - forward, |sharp| sharp.backward()[knot])]
}

/// The far parts of a boundary: intervals with almost nothing of the finite-element density, which is positive at any
/// distance, and those for which the boundary integral leaves nothing.
fn far_parts((side, measure): (&PreparedSide, &HarmonicMeasure)) -> Vec<Stretch> {
    let (density, lengths, m) = (measure.density(), side.edge_lengths(), measure.vertex_count());
    let length = |j: usize| {
        let (from, to) = measure.span(j);
        lengths[measure.vertex_at(j)] * (to - from)
    };
    let [forward, backward] = measure.sums(lengths);
    let steps = measure.steps(lengths);
    let perimeter: f64 = lengths.iter().sum();
    let is_empty = |j: usize| {
        let backward = measure.sharp().map(SharpMeasure::backward);
        backward.is_some_and(|ahead| ahead[j] == ahead[j + 1] && measure.at_knots()[j] == measure.at_knots()[j + 1])
    };
    let mut parts = Vec::new();
    let mut along = 0.0;
    let mut part = None::<Stretch>;
    for j in 0..=m {
        let nearer = forward[j + 1].min(backward[m + 1 - j]);
        if j > 0 && j < m && (steps[j] <= FAR * nearer || is_empty(j)) {
            along += length(j);
            let Stretch { knot, measure, .. } = part.unwrap_or(Stretch { knot: j, measure: 0.0, is_long: false });
            // the end of the last interval too, where a corner may be
            let knot = if density[j + 1] < density[knot] { j + 1 } else { knot };
            part = Some(Stretch { knot, measure: measure + steps[j], is_long: along >= LONG * perimeter });
            continue;
        }
        parts.extend(part.take().filter(|_| along >= LEAST_LENGTH * perimeter));
        along = 0.0;
    }
    parts
}

/// The measure up to which finite elements continue, both ways.
fn continued(measure: &HarmonicMeasure) -> f64 {
    let from = |way| measure.sharp().map_or(0.0, |sharp| sharp.sharp_from(measure.at_knots(), way));
    Way::BOTH.map(from).into_iter().fold(0.0, f64::max)
}

/// Gives vertices without density [`EMPTY`] of that of the next ones: images next to a sharp corner stay apart.
fn fill(density: &mut [f64]) {
    let m = density.len();
    let Some(first) = density.iter().position(|&density| density > 0.0) else { return };
    let mut before = density[first];
    let mut k = 1;
    while k < m {
        let run = (k..m).take_while(|i| density[(first + i) % m] <= 0.0).count();
        let after = density[(first + k + run) % m];
        (k..k + run).for_each(|i| density[(first + i) % m] = EMPTY * before.min(after));
        before = after;
        k += run + 1;
    }
}

/// The measure of a side from one of its vertices, up to `limit` by finite elements.
fn from_knot((side, measure): (&PreparedSide, &HarmonicMeasure), knot: usize, limit: f64) -> HarmonicMeasure {
    let mut density = vec![0.0; measure.vertex_count()];
    for j in 1..=measure.vertex_count() {
        density[measure.vertex_at(j)] = measure.density()[j];
    }
    fill(&mut density);
    let mut anchored = HarmonicMeasure::default();
    anchored.set_along(side.edge_lengths(), &density, BoundaryPoint::new(measure.vertex_at(knot) as u32, 0.0));
    if let Some(sharp) = measure.sharp() {
        sharp.resampled(side, 0.0, Some(limit), &mut anchored);
    }
    anchored
}

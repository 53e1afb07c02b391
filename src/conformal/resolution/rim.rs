//! A boundary with its harmonic measure, counted from the anchor in both directions.
//!
//! [`HarmonicMeasure`] runs from 0 to 1: before its end it cannot tell steps below 1e-16 apart. Here points of the
//! second half are given by the measure that remains, so that both sides of a limb in which the anchor lies are
//! resolved alike. Places are lengths from the anchor: along the samples' polygon, or with a boundary integral along its
//! curve, in stations ([`crate::conformal::CurveBoundary`]); the two sides of a map need not be of one kind.

mod far;

use super::corner::corners;
use super::law::{CurveLaw, Interval, Law, Omega};
use crate::conformal::HarmonicMeasure;
use crate::conformal::curved::SharpMeasure;
use crate::geometry::DVec2;
use crate::outline::{BoundaryPoint, BoundarySamples};
use far::FarPart;

/// A part of the boundary that no edge is as long as.
const BEHIND: f64 = 0.9;

/// The boundary of a domain with the measure of its point. Knots and intervals are those of [`HarmonicMeasure`].
pub(super) struct Rim<'a> {
    pub samples: &'a BoundarySamples,
    measure: &'a HarmonicMeasure,
    /// The measure before and after each knot.
    before: Vec<f64>,
    after: Vec<f64>,
    /// The length from the anchor to each knot.
    lengths: Vec<f64>,
    /// The lengths of the samples' edges.
    edges: Vec<f64>,
    /// The part of the anchor's edge before it.
    anchor_share: f64,
    law: Law<'a>,
    /// Parts that are far from both points.
    far: Vec<FarPart<'a>>,
}

impl<'a> Rim<'a> {
    /// Without far anchors.
    fn near(samples: &'a BoundarySamples, measure: &'a HarmonicMeasure) -> Option<Self> {
        if measure.density().len() != samples.len() + 2 {
            return None;
        }
        match measure.sharp() {
            Some(sharp) => Some(Self::curved(samples, measure, sharp)),
            None => Self::finite(samples, measure),
        }
    }

    /// By the boundary integral.
    fn curved(samples: &'a BoundarySamples, measure: &'a HarmonicMeasure, sharp: &'a SharpMeasure) -> Self {
        let law = CurveLaw::new(sharp);
        let (m, perimeter) = (samples.len(), law.boundary().perimeter());
        let is_at_vertex = measure.anchor().fraction() == 0.0;
        // rounding may leave the vertices next to the anchor on its other side
        let length = |j: usize| match (j, law.length_to(measure.vertex_at(j))) {
            (0, _) => 0.0,
            _ if j > m || j == m && is_at_vertex => perimeter,
            (1, length) if length > BEHIND * perimeter => 0.0,
            (_, length) if j == m && length < (1.0 - BEHIND) * perimeter => perimeter,
            (_, length) => length,
        };
        let lengths: Vec<f64> = (0..=m + 1).map(length).collect();
        let station = |k: usize| law.boundary().station(law.boundary().points()[k % m]);
        let edge = |k: usize| (station(k + 1) - station(k)).rem_euclid(perimeter);
        let edges: Vec<f64> = (0..m).map(edge).collect();
        let (anchor, law) = (measure.anchor(), Law::Curve(law));
        let anchor_share = law.anchor_share(anchor, edges[anchor.edge() as usize]);
        let (before, after) = (measure.at_knots().to_vec(), sharp.backward().to_vec());
        Self { samples, measure, before, after, lengths, edges, anchor_share, law, far: Vec::new() }
    }

    /// By finite elements.
    fn finite(samples: &'a BoundarySamples, measure: &'a HarmonicMeasure) -> Option<Self> {
        let (m, density) = (samples.len(), measure.density());
        let length = |j: usize| {
            let (from, to) = measure.span(j);
            samples.edge_lengths()[measure.vertex_at(j)] * (to - from)
        };
        let mut steps: Vec<f64> = (0..=m).map(|j| 0.5 * length(j) * (density[j] + density[j + 1])).collect();
        let lengths: Vec<f64> = (0..=m).map(length).collect();
        let law = Law::Finite(corners(samples, measure, &lengths, &mut steps));
        let running = |sum: &mut f64, add: f64| {
            *sum += add;
            Some(*sum)
        };
        let sums = |add: &dyn Fn(usize) -> f64| -> Vec<f64> {
            std::iter::once(0.0).chain((0..=m).scan(0.0, |sum, j| running(sum, add(j)))).collect()
        };
        let mut before = sums(&|j| steps[j]);
        let mut after = sums(&|j| steps[m - j]);
        after.reverse();
        let total = before[m + 1];
        if !(total.is_finite() && total > 0.0) {
            return None;
        }
        before.iter_mut().chain(&mut after).for_each(|value| *value /= total);
        let (lengths, edges) = (sums(&|j| lengths[j]), samples.edge_lengths().to_vec());
        let anchor_share = measure.anchor().fraction();
        Some(Self { samples, measure, before, after, lengths, edges, anchor_share, law, far: Vec::new() })
    }

    /// The extent of the domain.
    pub fn extent(&self) -> f64 {
        super::extent(self.samples.points())
    }

    /// The length of the boundary.
    pub fn length(&self) -> f64 {
        self.lengths[self.samples.len() + 1]
    }

    /// Whether sample `k` is a corner of the curve; without a curve, none is.
    pub fn is_corner_of_curve(&self, k: usize) -> bool {
        match &self.law {
            Law::Curve(law) => law.boundary().curve().is_corner(law.boundary().points()[k]),
            Law::Finite(_) => false,
        }
    }

    /// The vertex at the anchor, if one is there.
    pub fn anchor_vertex(&self) -> Option<usize> {
        let anchor = self.measure.anchor();
        (anchor.fraction() == 0.0).then_some(anchor.edge() as usize)
    }

    /// The length of the edge from sample `k` on.
    pub fn edge(&self, k: usize) -> f64 {
        self.edges[k]
    }

    /// The vertices from the anchor on, with their knots; a vertex at the anchor comes first.
    pub fn vertices(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let m = self.samples.len();
        let first = self.anchor_vertex().map(|vertex| (vertex, 0));
        let others = (1..=m).filter(move |&j| j < m || first.is_none()).map(|j| (self.measure.vertex_at(j), j));
        first.into_iter().chain(others)
    }

    /// The length from the anchor to a knot.
    pub fn length_at(&self, knot: usize) -> f64 {
        self.lengths[knot]
    }

    /// The length from the anchor to a vertex.
    pub fn length_to(&self, vertex: usize) -> f64 {
        // a vertex at the anchor is the first knot
        if self.anchor_vertex() == Some(vertex) { 0.0 } else { self.lengths[self.measure.knot_of(vertex)] }
    }

    /// The length between two lengths from the anchor without the intervals that have no measure.
    pub fn measured_length(&self, from: f64, to: f64) -> f64 {
        let (first, last) = (self.interval_at(from), self.interval_at(to));
        let flat = (first..=last).filter(|&j| self.is_flat(j));
        let covered = |j: usize| (self.lengths[j + 1].min(to) - self.lengths[j].max(from)).max(0.0);
        to - from - flat.map(covered).sum::<f64>()
    }

    /// The measure at a knot.
    pub fn at_knot(&self, knot: usize) -> Omega {
        if let Some(k) = self.far_at(self.lengths[knot]) {
            let far = &self.far[k].rim;
            return Omega { far: Some(k), ..far.at_knot(far.measure.knot_of(self.measure.vertex_at(knot))) };
        }
        Omega::new(self.before[knot], self.after[knot])
    }

    fn interval(&self, j: usize) -> Interval {
        let pair = |values: &[f64]| [values[j], values[j + 1]];
        Interval { knot: j, lengths: pair(&self.lengths), before: pair(&self.before), after: pair(&self.after) }
    }

    /// The interval that contains the length `s` from the anchor.
    fn interval_at(&self, s: f64) -> usize {
        self.lengths.partition_point(|&before| before <= s).saturating_sub(1).min(self.samples.len())
    }

    /// The measure at the length `s` from the anchor.
    pub fn at(&self, s: f64) -> Omega {
        if let Some(k) = self.far_at(s) {
            let FarPart { rim, anchor, .. } = &self.far[k];
            return Omega { far: Some(k), ..rim.at((s - anchor).rem_euclid(self.length())) };
        }
        self.near_at(s)
    }

    /// The measure before the length `s` from the map's own anchor.
    pub fn before(&self, s: f64) -> f64 {
        self.near_at(s).forward()
    }

    fn near_at(&self, s: f64) -> Omega {
        self.law.at(self.measure, self.interval(self.interval_at(s)), s)
    }

    /// The length from the anchor to where the measure is `omega`; where that is flat, to the end nearer to the anchor.
    pub fn length_of(&self, omega: Omega) -> f64 {
        match omega.far.and_then(|k| self.far.get(k)) {
            Some(far) => far.anchor + far.rim.length_from(Omega { far: None, ..omega }),
            None => self.near_length_of(omega),
        }
    }

    /// As [`Self::length_of`], but negative before the anchor.
    fn length_from(&self, omega: Omega) -> f64 {
        self.near_length_of(omega) - if omega.late { self.length() } else { 0.0 }
    }

    fn near_length_of(&self, omega: Omega) -> f64 {
        let reached = if omega.late {
            self.after.partition_point(|&after| after > omega.value)
        } else {
            self.before.partition_point(|&before| before < omega.value)
        };
        let j = reached.saturating_sub(1).min(self.samples.len());
        self.law.length_of(self.measure, self.interval(j), omega)
    }

    /// The point of the samples' boundary at the length `s` from the anchor.
    pub fn point(&self, s: f64) -> BoundaryPoint {
        let last = self.samples.len();
        let j = self.interval_at(s);
        let vertex = self.measure.vertex_at(j);
        let from = if j == 0 { self.anchor_share } else { 0.0 };
        let to = if j == last { self.anchor_share } else { 1.0 };
        let along = (s - self.lengths[j]) / (self.lengths[j + 1] - self.lengths[j]);
        let share = from + (to - from) * if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
        if share >= 1.0 {
            return BoundaryPoint::new(((vertex + 1) % last) as u32, 0.0);
        }
        BoundaryPoint::new(vertex as u32, share)
    }

    /// The position of a point of the samples' boundary: on the curve, if there is one.
    pub fn position(&self, point: BoundaryPoint) -> DVec2 {
        match &self.law {
            Law::Curve(law) => law.boundary().curve().position(law.boundary().curved(point)),
            Law::Finite(_) => self.samples.position(point),
        }
    }

    /// The fraction of the boundary's length up to a point.
    pub fn fraction(&self, point: BoundaryPoint) -> f64 {
        match &self.law {
            Law::Curve(law) => law.boundary().fraction(law.boundary().curved(point)),
            Law::Finite(_) => self.samples.fraction_at(point),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

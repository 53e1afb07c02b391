//! The harmonic measure ω̃ of the boundary from an anchor y, equations (11) and (12).
//!
//! ω̃ is piecewise quadratic, the integral of the piecewise linear ψ; it runs from
//! exactly 0 to exactly 1. The anchor may lie inside an edge, which is then divided into two intervals.

use super::curved::SharpMeasure;
use super::matching::inverse_quadratic;
use crate::outline::{BoundaryPoint, BoundarySamples};

/// The harmonic measure along a boundary, counter-clockwise from its anchor.
///
/// Knot 0 is the anchor, knot j = 1 … m the vertex `edge + j` (mod m), knot m+1
/// the anchor again; interval j lies between the knots j and j+1, on edge `edge + j`.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicMeasure {
    anchor: BoundaryPoint,
    density: Vec<f64>,
    cumulative: Vec<f64>,
    sharp: Option<Box<SharpMeasure>>,
}

impl Default for HarmonicMeasure {
    fn default() -> Self {
        Self { anchor: BoundaryPoint::new(0, 0.0), density: Vec::new(), cumulative: Vec::new(), sharp: None }
    }
}

impl HarmonicMeasure {
    /// The measure with density `psi` (length m, ≥ 0) from `anchor`.
    pub fn new(samples: &BoundarySamples, psi: &[f64], anchor: BoundaryPoint) -> Self {
        let mut measure = Self::default();
        measure.set(samples, psi, anchor);
        measure
    }

    /// As [`Self::new`], in place. Returns the total before normalization: near 1,
    /// and 0 or not finite only for a density that is not a kernel.
    pub fn set(&mut self, samples: &BoundarySamples, psi: &[f64], anchor: BoundaryPoint) -> f64 {
        self.set_along(samples.edge_lengths(), psi, anchor)
    }

    /// As [`Self::set`], for a boundary given by the lengths of its edges alone.
    pub fn set_along(&mut self, edge_lengths: &[f64], psi: &[f64], anchor: BoundaryPoint) -> f64 {
        let m = psi.len();
        let (first, f) = (anchor.edge() as usize, anchor.fraction());
        let vertex = |j: usize| (first + j) % m;
        let at_anchor = (1.0 - f) * psi[first] + f * psi[vertex(1)];
        self.anchor = anchor;
        self.sharp = None;
        self.density.clear();
        self.density.push(at_anchor);
        self.density.extend((1..=m).map(|j| psi[vertex(j)]));
        self.density.push(at_anchor);
        self.cumulative.clear();
        self.cumulative.push(0.0);
        let mut sum = 0.0;
        for j in 0..=m {
            sum += self.step(edge_lengths, j);
            self.cumulative.push(sum);
        }
        for value in &mut self.cumulative {
            *value /= sum;
        }
        sum
    }

    /// The measure that has these values at the boundary's `m` vertices, made monotone; between them the density is
    /// that of `density`, scaled.
    pub(super) fn from_values(
        anchor: BoundaryPoint,
        m: usize,
        density: impl Fn(usize) -> f64,
        value: impl Fn(usize) -> f64,
    ) -> Self {
        let vertex = |j: usize| (anchor.edge() as usize + j) % m;
        let f = anchor.fraction();
        let at_anchor = (1.0 - f) * density(vertex(0)) + f * density(vertex(1));
        let mut measure = Self { anchor, density: vec![at_anchor], cumulative: vec![0.0], sharp: None };
        let mut before = 0.0f64;
        for j in 1..=m {
            // a vertex at the anchor is the last one
            before = if j == m && f == 0.0 { 1.0 } else { before.max(value(vertex(j)).min(1.0)) };
            measure.density.push(density(vertex(j)));
            measure.cumulative.push(before);
        }
        measure.density.push(at_anchor);
        measure.cumulative.push(1.0);
        measure
    }

    /// The integral of the density over interval `j`.
    fn step(&self, edge_lengths: &[f64], j: usize) -> f64 {
        let (from, to) = self.span(j);
        0.5 * edge_lengths[self.vertex_at(j)] * (to - from) * (self.density[j] + self.density[j + 1])
    }

    /// The measure of each interval by the density, as a share of the whole.
    pub(super) fn steps(&self, edge_lengths: &[f64]) -> Vec<f64> {
        let steps: Vec<f64> = (0..=self.vertex_count()).map(|j| self.step(edge_lengths, j)).collect();
        let total: f64 = steps.iter().sum();
        steps.into_iter().map(|step| step / total).collect()
    }

    /// The measure at the knots, summed from the anchor counter-clockwise and, from the last knot on, clockwise, so
    /// that both keep their relative accuracy.
    pub(super) fn sums(&self, edge_lengths: &[f64]) -> [Vec<f64>; 2] {
        let steps = self.steps(edge_lengths);
        let sums = |steps: &mut dyn Iterator<Item = &f64>| {
            let running = steps.scan(0.0, |sum, step| {
                *sum += step;
                Some(*sum)
            });
            std::iter::once(0.0).chain(running).collect::<Vec<f64>>()
        };
        [sums(&mut steps.iter()), sums(&mut steps.iter().rev())]
    }

    /// Replaces the values at the knots by those of the boundary integral.
    pub(super) fn sharpen(&mut self, forward: Vec<f64>, sharp: SharpMeasure) {
        self.cumulative = forward;
        self.sharp = Some(Box::new(sharp));
    }

    /// The measure from the boundary integral that the values at the knots are from; `None` of one by finite elements.
    pub(super) fn sharp(&self) -> Option<&SharpMeasure> {
        self.sharp.as_deref()
    }

    /// Whether the values at the knots are those of the integral equation on the boundary.
    pub fn is_sharp(&self) -> bool {
        self.sharp.is_some()
    }

    /// The number of boundary vertices, m.
    pub fn vertex_count(&self) -> usize {
        self.density.len().saturating_sub(2)
    }

    /// ω̃ at boundary vertex `k`, in `[0, 1]`; 0 at the anchor.
    pub fn at_vertex(&self, k: usize) -> f64 {
        match self.knot_of(k) {
            j if j == self.vertex_count() && self.anchor.fraction() == 0.0 => 0.0,
            j => self.cumulative[j],
        }
    }

    /// The boundary vertices, counter-clockwise from the anchor; a vertex at the anchor comes first.
    pub fn vertices(&self) -> impl Iterator<Item = usize> + '_ {
        let m = self.vertex_count();
        let first = usize::from(self.anchor.fraction() != 0.0);
        (first..m + first).map(move |j| (self.anchor.edge() as usize + j) % m)
    }

    /// The point at which the measure from the anchor is `omega`, in `[0, 1]`: [`Self::at`] of it is `omega`.
    /// Where the measure is flat, the first such point.
    pub fn point_at(&self, omega: f64) -> BoundaryPoint {
        let last = self.vertex_count();
        let reached = self.cumulative.partition_point(|&before| before < omega);
        let j = reached.saturating_sub(1).min(last);
        let step = self.cumulative[j + 1] - self.cumulative[j];
        self.point(j, inverse_quadratic(omega - self.cumulative[j], step, self.density[j], self.density[j + 1]))
    }

    /// The anchor.
    pub fn anchor(&self) -> BoundaryPoint {
        self.anchor
    }

    /// ω̃ from the anchor to the boundary point `point`, in `[0, 1]`.
    pub fn at(&self, point: BoundaryPoint) -> f64 {
        let (j, lambda) = self.place_of(point);
        self.within(j, lambda)
    }

    /// The interval that contains a boundary point, and the point's fraction of it.
    pub(super) fn place_of(&self, point: BoundaryPoint) -> (usize, f64) {
        let m = self.vertex_count();
        let before_anchor = point.edge() == self.anchor.edge() && point.fraction() < self.anchor.fraction();
        let j = if before_anchor { m } else { (point.edge() as usize + m - self.anchor.edge() as usize) % m };
        let (from, to) = self.span(j);
        (j, if to > from { (point.fraction() - from) / (to - from) } else { 0.0 })
    }

    /// The share of the measure of an interval before `lambda` of its length.
    pub(super) fn share(&self, j: usize, lambda: f64) -> f64 {
        let (p, q) = (self.density[j], self.density[j + 1]);
        let share = if p + q > 0.0 { lambda * (2.0 * p + (q - p) * lambda) / (p + q) } else { lambda };
        share.clamp(0.0, 1.0)
    }

    /// ω̃ in interval `j` at `lambda` of its length: the integral of a linear density.
    pub(super) fn within(&self, j: usize, lambda: f64) -> f64 {
        self.cumulative[j] + (self.cumulative[j + 1] - self.cumulative[j]) * self.share(j, lambda)
    }

    /// The knot of boundary vertex `k`, in `1 ..= m`.
    pub(super) fn knot_of(&self, k: usize) -> usize {
        let m = self.vertex_count();
        (k + 2 * m - self.anchor.edge() as usize - 1) % m + 1
    }

    /// The boundary vertex at knot `j`, `1 ≤ j ≤ m`.
    pub(super) fn vertex_at(&self, j: usize) -> usize {
        (self.anchor.edge() as usize + j) % self.vertex_count()
    }

    /// ω̃ at the knots, from 0 to 1, non-decreasing (length m+2).
    pub fn at_knots(&self) -> &[f64] {
        &self.cumulative
    }

    /// ψ at the knots (length m+2).
    pub(super) fn density(&self) -> &[f64] {
        &self.density
    }

    /// The point in interval `j` at the fraction `lambda` of its length.
    pub(super) fn point(&self, j: usize, lambda: f64) -> BoundaryPoint {
        let (from, to) = self.span(j);
        let fraction = (from + lambda * (to - from)).clamp(from, to).min(1.0 - f64::EPSILON);
        BoundaryPoint::new(self.vertex_at(j) as u32, fraction)
    }

    /// The part of its edge that interval `j` covers, as two fractions.
    pub(super) fn span(&self, j: usize) -> (f64, f64) {
        let f = self.anchor.fraction();
        let last = self.vertex_count();
        (if j == 0 { f } else { 0.0 }, if j == last { f } else { 1.0 })
    }
}

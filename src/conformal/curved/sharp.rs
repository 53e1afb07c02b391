//! The measure from the boundary integral at the knots of [`HarmonicMeasure`], counted from the anchor both ways.
//!
//! The computed density has an error of either sign, from rounding or, on curves of many corners and knots, from panels
//! that do not resolve it better. Where that leaves the density next to the anchor three digits or more, measures counted
//! from the anchor keep them at any distance, in corners too: both are summed from there. Around an anchor in a crowded
//! part of the boundary the positive finite-element density continues (file `continued`). Elsewhere steps below 1e-16
//! cannot be told apart in f64; there the measure stands still, unless the other boundary does so too: see
//! [`far anchors`](super::super::far_anchors).

use super::super::matching::inverse_quadratic;
use super::super::{HarmonicMeasure, PreparedSide};
use super::CurveBoundary;
use super::continued::{agreed, carry_on, least, ratio};
use crate::boundary_integral::{self, AnchoredMeasure};
use crate::geometry::{CurvePoint, Junction};
use crate::outline::BoundaryPoint;
use std::sync::Arc;

/// The largest error of the density next to the anchor, in densities, with which measures are counted from there.
const RESOLVED: f64 = 1e-3;
/// What Gauss's rule leaves on panels that are next to panels beyond a junction, and the identities do not see: 2e-13
/// inside of the square's sides, whose measures are right to 1e-15.
const NEAR_PARTS: f64 = 4e-13;

/// The rounding error of sums over all panels: up to 3e-15 is found where nothing else is left, on disk and blob.
const SUMMED: f64 = 6e-15;

/// The direction in which measure is counted from the anchor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// Counter-clockwise.
    Forward,
    /// Clockwise.
    Backward,
}

impl Way {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::Forward, Self::Backward];
}

/// The measure at the knots, both ways, and what it is made from.
#[derive(Debug, Clone)]
pub struct SharpMeasure {
    boundary: Arc<CurveBoundary>,
    swept: Arc<boundary_integral::HarmonicMeasure>,
    anchor: CurvePoint,
    /// The measure from the last knot back to each knot: 1 … 0.
    backward: Vec<f64>,
    /// The number of knots after the anchor, both ways, that finite elements continue.
    continued: [usize; 2],
    /// The measure of the panels, or of the corner's legs, next to the anchor, both ways.
    beside: [f64; 2],
}

impl PartialEq for SharpMeasure {
    fn eq(&self, other: &Self) -> bool {
        (self.anchor, &self.backward, self.continued) == (other.anchor, &other.backward, other.continued)
    }
}

impl SharpMeasure {
    /// The measure `swept` from the anchor of `finite`, the finite-element measure, whose values it replaces. `s` is
    /// the anchor's fraction of the length. Finite elements give the measures below `continued`; without it, if the
    /// density next to the anchor is not resolved, those below [`least`].
    pub fn set(
        side: &PreparedSide,
        (boundary, swept): (&Arc<CurveBoundary>, &Arc<boundary_integral::HarmonicMeasure>),
        s: f64,
        continued: Option<f64>,
        finite: &mut HarmonicMeasure,
    ) {
        let (at, m) = (finite.anchor(), finite.vertex_count());
        let anchor = if at.fraction() == 0.0 { boundary.points()[at.edge() as usize] } else { boundary.at_fraction(s) };
        let anchored = swept.from_anchor(anchor);
        let knot = |j: usize| boundary.points()[finite.vertex_at(j)];
        let mut measures = [vec![0.0; m + 2], vec![0.0; m + 2]];
        for j in 1..=m {
            let is_anchor = j == m && at.fraction() == 0.0;
            let [forward, backward] = &mut measures;
            [forward[j], backward[j]] = if is_anchor { [1.0, 0.0] } else { anchored.both(knot(j)) };
        }
        measures[0][m + 1] = 1.0;
        measures[1][0] = 1.0;
        // both run from the anchor on, whatever the sign of a density that is almost nothing
        measures[1].reverse();
        for measure in &mut measures {
            let mut most = 0.0_f64;
            for value in measure.iter_mut() {
                most = most.max(value.min(1.0));
                *value = most;
            }
        }
        let sums = finite.sums(side.edge_lengths());
        let beside = anchored.beside_anchor();
        let least = continued.unwrap_or_else(|| least(swept));
        let continued = Way::BOTH.map(|way| {
            if continued.is_none() && beside[way as usize].error <= RESOLVED {
                return 0;
            }
            let sums = &sums[way as usize];
            let least = agreed(&measures[way as usize], sums, least, swept.error_estimate());
            let ratio = || ratio(boundary, &anchored, (&*finite, sums), way, least);
            carry_on(&mut measures[way as usize], sums, least, ratio)
        });
        let [forward, mut backward] = measures;
        backward.reverse();
        let beside = beside.map(|beside| beside.measure.max(0.0));
        let (boundary, swept) = (Arc::clone(boundary), Arc::clone(swept));
        let sharp = Self { boundary, swept, anchor, backward, continued, beside };
        finite.sharpen(forward, sharp);
    }

    /// The same measure from the anchor at the fraction `s`, at the samples of `side`, other ones of the same curve.
    pub fn resampled(&self, side: &PreparedSide, s: f64, continued: Option<f64>, finite: &mut HarmonicMeasure) {
        if let Some(boundary) = side.curve_boundary() {
            Self::set(side, (boundary, &self.swept), s, continued, finite);
        }
    }

    /// The curve.
    pub fn boundary(&self) -> &CurveBoundary {
        &self.boundary
    }

    /// The anchor's point on the curve.
    pub fn anchor(&self) -> CurvePoint {
        self.anchor
    }

    /// The ends of the intervals on which the density is one polynomial, in the order of the curve.
    pub fn breaks(&self) -> Vec<CurvePoint> {
        self.swept.breaks()
    }

    /// The measure counted from the anchor.
    pub fn anchored(&self) -> AnchoredMeasure<'_> {
        self.swept.from_anchor(self.anchor)
    }

    /// An estimate of the largest error of ω along the boundary, apart from what finite elements continue.
    pub fn error(&self) -> f64 {
        let is_analytic = |junction: &Junction| *junction == Junction::Analytic;
        let has_parts = !self.boundary.curve().junctions().iter().all(is_analytic);
        self.swept.error_estimate().max(if has_parts { NEAR_PARTS } else { SUMMED })
    }

    /// The error that is left of measures where the density is almost nothing.
    pub fn floor(&self) -> f64 {
        self.swept.floor()
    }

    /// The measure of the panel, or of the corner's leg, next to the anchor.
    pub fn beside(&self, way: Way) -> f64 {
        self.beside[way as usize]
    }

    /// The measure from each knot on to the anchor, from 1 to 0.
    pub fn backward(&self) -> &[f64] {
        &self.backward
    }

    /// The numbers of knots after the anchor, forward and backward, that finite elements continue.
    pub fn continued(&self) -> [usize; 2] {
        self.continued
    }

    /// Whether finite elements continue the measure up to knot `j`, of `m` + 2.
    pub fn is_continued(&self, j: usize) -> bool {
        let last = self.backward.len() - 1;
        let [forward, backward] = self.continued;
        j <= forward && forward > 0 || j + backward >= last && backward > 0
    }

    /// The first measure, counted this way from the anchor, that the boundary integral gives; 0 if finite elements
    /// continue nothing.
    pub fn sharp_from(&self, forward: &[f64], way: Way) -> f64 {
        match (way, self.continued[way as usize]) {
            (_, 0) => 0.0,
            (Way::Forward, knots) => forward[knots + 1],
            (Way::Backward, knots) => self.backward[self.backward.len() - 2 - knots],
        }
    }
}

/// The point at the measure `omega` counted one way from the anchor, by interpolation between knots.
pub fn point_between_knots(measure: &HarmonicMeasure, backward: &[f64], omega: f64, way: Way) -> BoundaryPoint {
    if way == Way::Forward {
        return measure.point_at(omega);
    }
    let last = measure.vertex_count();
    let j = backward.partition_point(|&ahead| ahead > omega).clamp(1, last + 1) - 1;
    let (step, density) = (backward[j] - backward[j + 1], measure.density());
    let lambda = 1.0 - inverse_quadratic(omega - backward[j + 1], step, density[j + 1], density[j]);
    measure.point(j, lambda)
}

//! Harmonic measure along a curve as a function of the point, and its inverse, counted from the anchor both ways.
//!
//! Both directions are computed on their own: next to the anchor the measure counted from there keeps its relative
//! accuracy, and 1 less than the other one does not. Where finite elements continue the boundary integral, values
//! are interpolated between the samples.

use super::super::HarmonicMeasure;
use super::continued::AGREED;
use super::sharp::{SharpMeasure, Way, point_between_knots};
use crate::boundary_integral::AnchoredMeasure;
use crate::geometry::CurvePoint;

/// Stations next to the anchor, in perimeters, at which rounding may leave a point on its other side.
const BEHIND: f64 = 1e-14;

/// The relative error of the rate at which finite elements let measure decay along a channel. In the arms of the V, over
/// 23 decades, it is 1.3 % at the default samples.
const WRONG_RATE: f64 = 0.03;

/// A measure from the boundary integral, between points of its curve.
#[derive(Debug, Clone)]
pub struct CurveMeasure<'a> {
    measure: &'a HarmonicMeasure,
    sharp: &'a SharpMeasure,
    anchored: AnchoredMeasure<'a>,
    /// The measures, both ways, below which finite elements continue.
    sharp_from: [f64; 2],
}

impl<'a> CurveMeasure<'a> {
    /// `measure`, if it is from the boundary integral.
    pub fn new(measure: &'a HarmonicMeasure) -> Option<Self> {
        let sharp = measure.sharp()?;
        let sharp_from = Way::BOTH.map(|way| sharp.sharp_from(measure.at_knots(), way));
        Some(Self { measure, sharp, anchored: sharp.anchored(), sharp_from })
    }

    /// What the measure is made from.
    pub fn sharp(&self) -> &'a SharpMeasure {
        self.sharp
    }

    /// The first measure, counted this way from the anchor, that the boundary integral gives; 0 if finite elements
    /// continue nothing.
    pub fn sharp_from(&self, way: Way) -> f64 {
        self.sharp_from[way as usize]
    }

    /// The error of a measure counted from the anchor, apart from the [factor](Self::factor) of finite elements: on the
    /// panels next to the anchor, in proportion to the measure, and at least the floor where that is reached.
    pub fn error(&self, omega: f64, way: Way) -> f64 {
        let beside = self.sharp.beside(way);
        match self.sharp_from(way) {
            from if omega <= 0.0 || omega < from => 0.0,
            from if omega < beside => {
                let floor = if from > 0.0 { self.sharp.floor() } else { 0.0 };
                (self.sharp.error() * (omega / beside)).max(floor)
            }
            _ => self.sharp.error(),
        }
    }

    /// The factor by which a measure may be wrong that finite elements continue, [`AGREED`] and what [`WRONG_RATE`] adds;
    /// otherwise 1.
    pub fn factor(&self, omega: f64, way: Way) -> f64 {
        match self.sharp_from(way) {
            from if omega < from && omega > 0.0 => AGREED * (from / omega).powf(WRONG_RATE),
            _ => 1.0,
        }
    }

    /// The measures from the anchor counter-clockwise to the point, and from the point on to the anchor.
    pub fn at(&self, point: CurvePoint) -> [f64; 2] {
        let sharp = self.anchored.both(point);
        if self.sharp_from == [0.0; 2] {
            return sharp;
        }
        let (j, lambda) = self.measure.place_of(self.sharp.boundary().sampled(point));
        let (forward, backward) = (self.measure.at_knots(), self.sharp.backward());
        let share = self.measure.share(j, lambda);
        let last = backward.len() - 1;
        let [after, before] = self.sharp.continued();
        let is_after = after > 0 && j <= after;
        let is_before = before > 0 && j + 1 + before >= last;
        [
            if is_after { forward[j] + (forward[j + 1] - forward[j]) * share } else { sharp[0] },
            if is_before { backward[j + 1] + (backward[j] - backward[j + 1]) * (1.0 - share) } else { sharp[1] },
        ]
    }

    /// The smaller of the measures between the anchor and a point, and the way that it is counted.
    pub fn nearer(&self, point: CurvePoint) -> (f64, Way) {
        let [forward, backward] = self.at(point);
        if forward <= backward { (forward, Way::Forward) } else { (backward, Way::Backward) }
    }

    /// The point with the measure `omega` between the anchor and itself, counted one way.
    pub fn point(&self, omega: f64, way: Way) -> CurvePoint {
        if omega <= 0.0 {
            return self.sharp.anchor();
        }
        if omega < self.sharp_from[way as usize] {
            let point = point_between_knots(self.measure, self.sharp.backward(), omega, way);
            return self.sharp.boundary().curved(point);
        }
        match way {
            Way::Forward => self.anchored.point_at(omega),
            Way::Backward => self.anchored.point_before(omega),
        }
    }

    /// The length of the way from the anchor to a point, in stations: near 0 or the perimeter as the point was found.
    pub fn along(&self, point: CurvePoint, way: Way) -> f64 {
        let boundary = self.sharp.boundary();
        let (perimeter, anchor) = (boundary.perimeter(), boundary.station(self.sharp.anchor()));
        let along = (boundary.station(point) - anchor).rem_euclid(perimeter);
        match way {
            Way::Forward if along > perimeter * (1.0 - BEHIND) => 0.0,
            Way::Backward if along < perimeter * BEHIND => perimeter,
            _ => along,
        }
    }
}

/// The smaller of the measures from the anchor to knot `j`, and the way that it is counted.
pub fn nearer(measure: &HarmonicMeasure, j: usize) -> (f64, Way) {
    let forward = measure.at_knots()[j];
    let backward = measure.sharp().map_or(1.0 - forward, |sharp| sharp.backward()[j]);
    if forward <= backward { (forward, Way::Forward) } else { (backward, Way::Backward) }
}

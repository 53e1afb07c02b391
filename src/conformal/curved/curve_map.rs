//! The boundary map between the curves of two sides, at any point of either curve.
//!
//! The image of a point has the same harmonic measure from its anchor, counted in the way in which that is smaller.
//! The map preserves the order along the curves up to rounding, and, where parts with [far anchors] of their own end, up
//! to the errors of the measures. Where finite elements continue a measure, the image is interpolated there, and its
//! estimated error says so.
//!
//! [far anchors]: super::super::far_anchors

use super::super::{ConformalMap, HarmonicMeasure, Side};
use super::curve_measure::CurveMeasure;
use super::sharp::Way;
use crate::geometry::{Curve, CurvePoint};

/// The map from one side's curve onto the other's.
#[derive(Debug, Clone)]
pub struct CurveMap<'a> {
    from: CurveMeasure<'a>,
    onto: CurveMeasure<'a>,
    /// The map where both boundaries are far from both points, from anchors there, and the measures up to which it is
    /// used.
    far: Vec<(CurveMap<'a>, f64)>,
}

impl ConformalMap {
    /// The boundary map from the curve of side `from` to the other curve, whichever mesh is mapped; `None` unless both
    /// measures are from the integral equation. Cost O(panels) for each anchor.
    pub fn curve_map(&self, from: Side) -> Option<CurveMap<'_>> {
        let sides = [from, from.other()];
        let far = self.far.iter().map(|far| Some((CurveMap::new(sides.map(|side| &far.measures[side]))?, far.limit)));
        let far = far.collect::<Option<_>>()?;
        Some(CurveMap { far, ..CurveMap::new(sides.map(|side| self.measure(side)))? })
    }
}

/// Fractions of the length that differ by less are one place.
const SAME: f64 = 1e-9;

impl<'a> CurveMap<'a> {
    /// Without far anchors.
    fn new([from, onto]: [&'a HarmonicMeasure; 2]) -> Option<Self> {
        Some(Self { from: CurveMeasure::new(from)?, onto: CurveMeasure::new(onto)?, far: Vec::new() })
    }

    /// The curve that is mapped.
    pub fn from_curve(&self) -> &'a Curve {
        self.from.sharp().boundary().curve()
    }

    /// The curve that is mapped onto.
    pub fn onto_curve(&self) -> &'a Curve {
        self.onto.sharp().boundary().curve()
    }

    /// The anchor's image: the other curve's anchor.
    pub fn onto_anchor(&self) -> CurvePoint {
        self.onto.sharp().anchor()
    }

    /// The measures of a point of the mapped curve from the anchor, counter-clockwise and clockwise. They add up to 1;
    /// each keeps its relative accuracy next to the anchor.
    pub fn measure_at(&self, point: CurvePoint) -> (f64, f64) {
        let [forward, backward] = self.from.at(point);
        (forward, backward)
    }

    /// The image of a point of the mapped curve on the other one. O(log panels) for each anchor.
    pub fn image(&self, point: CurvePoint) -> CurvePoint {
        let map = self.nearest(point);
        let (omega, way) = map.from.nearer(point);
        map.onto.point(omega, way)
    }

    /// The map from the anchor in whose part the point lies: the nearest one, if there are several.
    fn nearest(&self, point: CurvePoint) -> &Self {
        let far = self.far.iter().map(|(far, limit)| (far, far.from.nearer(point).0, limit));
        let near = far.filter(|(_, omega, limit)| omega < limit).min_by(|a, b| a.1.total_cmp(&b.1));
        near.map_or(self, |(far, ..)| far)
    }

    /// The points between which the density of the mapped curve is one polynomial, in the order of the curve from its
    /// first point: the ends of the panels and, towards corners, of dyadic ones. From the last one to the corner the
    /// measure is a power of the distance, π/α.
    pub fn from_breaks(&self) -> Vec<CurvePoint> {
        self.from.sharp().breaks()
    }

    /// As [`Self::from_breaks`], on the curve that is mapped onto.
    pub fn onto_breaks(&self) -> Vec<CurvePoint> {
        self.onto.sharp().breaks()
    }

    /// An estimate of the error of [`Self::image`], in the units of the other side.
    ///
    /// Δω, the sum of both measures' errors, moves an image to where the other measure is ω ± Δω: next to a corner of
    /// angle α by Δω^(α/π), elsewhere by Δω over the density. The error is the longer one of the two arcs. The image of
    /// the anchor is exact, and errors next to it are in proportion to the measure. In a far part it is also the error
    /// from the map's own anchor: the far one's place is known up to that only.
    pub fn error(&self, point: CurvePoint) -> f64 {
        let error_from = |map: &Self| {
            let (omega, way) = map.from.nearer(point);
            map.error_of(omega, way)
        };
        let near = self.nearest(point);
        if std::ptr::eq(near, self) { error_from(self) } else { error_from(self).max(error_from(near)) }
    }

    /// The error of the image of a point with this measure.
    pub(super) fn error_of(&self, omega: f64, way: Way) -> f64 {
        let off = self.from.error(omega, way) + self.onto.error(omega, way);
        let factor = self.from.factor(omega, way) * self.onto.factor(omega, way);
        let boundary = self.onto.sharp().boundary();
        let image = self.onto.point(omega, way);
        let further = self.onto.point((factor * omega + off).min(1.0), way);
        let least = omega / factor;
        let nearer = if least >= off {
            self.onto.point(least - off, way)
        } else {
            self.onto.point(off - least, if way == Way::Forward { Way::Backward } else { Way::Forward })
        };
        let arc = |from: CurvePoint, to: CurvePoint| {
            let (from, to) = if way == Way::Forward { (from, to) } else { (to, from) };
            let turn = (boundary.fraction(to) - boundary.fraction(from)).rem_euclid(1.0);
            // points of one place may be in the opposite order; no two points are further apart than half a turn
            if turn > 1.0 - SAME { 0.0 } else { turn.min(0.5) * boundary.perimeter() }
        };
        self.rounding() + arc(image, further).max(arc(nearer, image))
    }

    /// The error of a measure that finite elements continue on either side.
    pub(super) fn continued_error(&self, omega: f64, way: Way) -> f64 {
        (self.from.factor(omega, way) * self.onto.factor(omega, way) - 1.0) * omega
    }

    /// The error of a position on the other curve that is known exactly.
    fn rounding(&self) -> f64 {
        let (sharp, boundary) = (self.onto.sharp(), self.onto.sharp().boundary());
        f64::EPSILON * boundary.curve().position(sharp.anchor()).length().max(boundary.perimeter())
    }
}

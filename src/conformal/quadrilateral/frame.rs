//! The strip coordinate of a long quadrilateral, seen from one point inside.
//!
//! Let c₀ … c₃ be the corners in order, the sides c₀c₁ and c₂c₃ far apart. X(s) = (1/π) log |s − c₀|/|s − c₂| of the disk
//! angles 2πω of boundary points is a cross ratio, and so the same from every point of view up to a constant; it is 0
//! at the point of view itself. From there it is right to the rounding of ω times e^{π|X|}, however long the
//! quadrilateral is. The arcs c₀c₂ and c₂c₀ are exchanged by half a turn, which takes X to −X.

use crate::boundary_integral::{AnchoredMeasure, HarmonicMeasure};
use crate::geometry::{Curve, CurvePoint, DVec2};
use std::f64::consts::PI;

/// The boundary, seen from one point.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    corners: [CurvePoint; 4],
    measure: &'a HarmonicMeasure,
    /// The measure counted from each corner.
    anchors: [AnchoredMeasure<'a>; 4],
    /// X of the point of view.
    pub center: f64,
}

/// The sign of X in the direction of an arc: the one from c₀ to c₂, or the one back.
pub fn sign(arc: usize) -> f64 {
    if arc == 0 { 1.0 } else { -1.0 }
}

fn chord(omega: f64) -> f64 {
    (PI * omega).sin()
}

impl<'a> Frame<'a> {
    pub fn new(corners: [CurvePoint; 4], measure: &'a HarmonicMeasure, center: f64) -> Self {
        Self { corners, measure, anchors: corners.map(|corner| measure.from_anchor(corner)), center }
    }

    /// The measure of the far side that an arc begins with.
    pub fn end(&self, arc: usize) -> f64 {
        self.measure.between(self.corners[2 * arc], self.corners[2 * arc + 1])
    }

    /// The measure of an arc: ½ from the middle line.
    pub fn arc(&self, arc: usize) -> f64 {
        self.measure.between(self.corners[2 * arc], self.corners[(2 * arc + 2) % 4])
    }

    /// X of a point of an arc.
    pub fn coordinate(&self, arc: usize, point: CurvePoint) -> f64 {
        let before = self.measure.between(self.corners[2 * arc], point);
        let after = self.measure.between(point, self.corners[(2 * arc + 2) % 4]);
        self.center + sign(arc) * (chord(before) / chord(after)).ln() / PI
    }

    /// The point of an arc with this X. Measure is counted from the end of the arc that is nearer.
    pub fn point(&self, arc: usize, coordinate: f64) -> CurvePoint {
        let along = sign(arc) * (coordinate - self.center);
        let ratio = (-PI * along.abs()).exp();
        let (sin, cos) = (PI * self.arc(arc)).sin_cos();
        let omega = (ratio * sin).atan2(1.0 + ratio * cos) / PI;
        if along <= 0.0 {
            self.anchors[2 * arc].point_at(omega)
        } else {
            self.anchors[(2 * arc + 2) % 4].point_before(omega)
        }
    }

    /// The point s beside the corner c₁ of the arc from c₀ to c₂ whose cross ratio |s − c₁||c₀ − c₂| / |s − c₂||c₀ − c₁| is
    /// `square`: towards c₂ if `is_forward`, or else towards c₀. Of the other arc, the same after half a turn.
    pub fn beside(&self, arc: usize, is_forward: bool, square: f64) -> CurvePoint {
        let [corner, finish] = [2 * arc + 1, (2 * arc + 2) % 4];
        let ratio = square * chord(self.end(arc)) / chord(self.arc(arc));
        let (sin, cos) = (PI * self.measure.between(self.corners[corner], self.corners[finish])).sin_cos();
        if is_forward {
            self.anchors[corner].point_at((ratio * sin).atan2(1.0 + ratio * cos) / PI)
        } else {
            self.anchors[corner].point_before((ratio * sin).atan2(1.0 - ratio * cos) / PI)
        }
    }

    /// The cross ratio of [`Self::beside`] of a point on the arc.
    pub fn square(&self, arc: usize, is_forward: bool, point: CurvePoint) -> f64 {
        let [corner, finish] = [self.corners[2 * arc + 1], self.corners[(2 * arc + 2) % 4]];
        let near = if is_forward { self.measure.between(corner, point) } else { self.measure.between(point, corner) };
        let far = self.measure.between(point, finish);
        chord(near) * chord(self.arc(arc)) / (chord(far) * chord(self.end(arc)))
    }

    /// The place inside with this X on the middle line, approximately: the mean of the boundary's places by harmonic measure
    /// from there, which is ½ sech π(X − X₀) dX on both arcs.
    pub fn place(&self, curve: &Curve, coordinate: f64) -> DVec2 {
        let place = |k: u32| {
            let share = (f64::from(k / 2) + 0.5) / f64::from(PLACES);
            let away = (0.5 * PI * share).tan().ln() / PI;
            curve.position(self.point(k as usize % 2, coordinate + away))
        };
        (0..2 * PLACES).map(place).sum::<DVec2>() / f64::from(2 * PLACES)
    }

    /// This frame with the center that makes X the same as in `other` at the points of both arcs with this X; and by how much
    /// these two differ.
    pub fn joined(mut self, other: &Self, coordinate: f64) -> (Self, f64) {
        let offsets = [0, 1].map(|arc| {
            let point = other.point(arc, coordinate);
            other.coordinate(arc, point) - self.coordinate(arc, point)
        });
        self.center += 0.5 * (offsets[0] + offsets[1]);
        (self, (offsets[0] - offsets[1]).abs())
    }
}

/// Places on each arc of which the mean is taken, equally spaced in measure.
const PLACES: u32 = 32;

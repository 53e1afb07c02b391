//! Matching with a measure from the boundary integral on the target's side: images lie on the target's curve.

use super::super::{BoundaryCorrespondence, HarmonicMeasure};
use super::sharp::{SharpMeasure, Way, point_between_knots};
use crate::boundary_integral::AnchoredMeasure;
use crate::geometry::CurvePoint;

/// Stations next to the anchor, in perimeters, at which rounding may leave a point on its other side.
const BEHIND: f64 = 1e-14;

/// The points of a target's curve at given measures from its anchor.
pub struct Inverse<'a> {
    measure: &'a HarmonicMeasure,
    sharp: &'a SharpMeasure,
    anchored: AnchoredMeasure<'a>,
    /// The measures, both ways, below which finite elements continue.
    sharp_from: [f64; 2],
}

impl<'a> Inverse<'a> {
    /// The inverse of a measure from the boundary integral.
    pub fn new(measure: &'a HarmonicMeasure, sharp: &'a SharpMeasure) -> Self {
        let sharp_from = Way::BOTH.map(|way| sharp.sharp_from(measure.at_knots(), way));
        Self { measure, sharp, anchored: sharp.anchored(), sharp_from }
    }

    /// The point with the measure `omega` between the anchor and itself, counted one way.
    pub fn at(&self, omega: f64, way: Way) -> CurvePoint {
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
    fn along(&self, point: CurvePoint, way: Way) -> f64 {
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

/// Matches `source` to the sharp measure `target` into `result`, in weakly cyclic order.
pub fn match_sharply(
    source: &HarmonicMeasure,
    target: &HarmonicMeasure,
    sharp: &SharpMeasure,
    result: &mut BoundaryCorrespondence,
) {
    let m = source.vertex_count();
    result.begin_exact(m, target.anchor(), sharp.anchor());
    let inverse = Inverse::new(target, sharp);
    let (mut furthest, mut last) = (0.0, sharp.anchor());
    for j in 1..=m {
        let vertex = source.vertex_at(j);
        let is_at_anchor = j == m && source.at_vertex(vertex) == 0.0;
        if is_at_anchor {
            last = sharp.anchor();
        } else {
            let (omega, way) = nearer(source, j);
            let point = inverse.at(omega, way);
            let along = inverse.along(point, way);
            // both ways meet, and finite elements join the boundary integral, up to rounding
            if along >= furthest {
                (furthest, last) = (along, point);
            }
        }
        result.set_exact(vertex, sharp.boundary().sampled(last), last, sharp.boundary().curve().position(last));
    }
}

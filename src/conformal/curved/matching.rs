//! Matching with a measure from the boundary integral on the target's side: images lie on the target's curve.

use super::super::{BoundaryCorrespondence, HarmonicMeasure};
use super::curve_measure::{CurveMeasure, nearer};

/// Matches `source` to the measure `target` of a curve, which runs from `target_anchor` on its samples, into `result`,
/// in weakly cyclic order.
pub fn match_sharply(source: &HarmonicMeasure, target: &CurveMeasure<'_>, result: &mut BoundaryCorrespondence) {
    let m = source.vertex_count();
    let (sharp, boundary) = (target.sharp(), target.sharp().boundary());
    result.begin_exact(m, boundary.sampled(sharp.anchor()), sharp.anchor());
    let (mut furthest, mut last) = (0.0, sharp.anchor());
    for j in 1..=m {
        let vertex = source.vertex_at(j);
        let is_at_anchor = j == m && source.at_vertex(vertex) == 0.0;
        if is_at_anchor {
            last = sharp.anchor();
        } else {
            let (omega, way) = nearer(source, j);
            let point = target.point(omega, way);
            let along = target.along(point, way);
            // both ways meet, and finite elements join the boundary integral, up to rounding
            if along >= furthest {
                (furthest, last) = (along, point);
            }
        }
        result.set_exact(vertex, boundary.sampled(last), last, boundary.curve().position(last));
    }
}

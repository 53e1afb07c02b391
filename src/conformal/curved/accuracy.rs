//! The error estimate of a map with both measures from the boundary integral.

use super::super::{ConformalMap, Side};
use super::matching::{Inverse, nearer};
use super::sharp::Way;
use crate::geometry::CurvePoint;

/// The relative error of measures that finite elements continue: their exponential decay along a channel has a slightly
/// wrong rate, so that nothing but the order of magnitude is claimed.
const CONTINUED: f64 = 1.0;

/// Estimates of the largest errors on the boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorEstimate {
    /// Of harmonic measure, the larger one of both sides.
    pub omega: f64,
    /// Of the images of the boundary vertices.
    pub image: f64,
    /// Of the image of each boundary vertex, in the units of the side that it lies on.
    pub points: Vec<f64>,
}

impl ConformalMap {
    /// An estimate of the errors; `None` unless both measures are from the boundary integral.
    ///
    /// Δω, the sum of both measures' errors, moves an image to where the target's measure is ω ± Δω: next to a corner
    /// of angle α by Δω^(α/π), elsewhere by Δω over the density. The error is the longer one of the two arcs. Cost O(m).
    pub fn error_estimate(&self) -> Option<ErrorEstimate> {
        let side = self.mapped_side();
        let (source, target) = (self.measure(side), self.measure(side.other()));
        let (from, onto) = (source.sharp()?, target.sharp()?);
        let inverse = Inverse::new(target, onto);
        let boundary = onto.boundary();
        let rounding = f64::EPSILON * boundary.curve().position(onto.anchor()).length().max(boundary.perimeter());
        let mut points = vec![0.0; source.vertex_count()];
        let mut omega = from.error().max(onto.error());
        for j in 1..=source.vertex_count() {
            let (measure, way) = nearer(source, j);
            let is_continued = from.is_continued(j) || measure < onto.sharp_from(target.at_knots(), way);
            let relative = if is_continued { CONTINUED * measure } else { 0.0 };
            omega = omega.max(relative);
            let off = from.error() + onto.error() + relative;
            let image = inverse.at(measure, way);
            let further = inverse.at((measure + off).min(1.0), way);
            let nearer = if measure >= off {
                inverse.at(measure - off, way)
            } else {
                inverse.at(off - measure, if way == Way::Forward { Way::Backward } else { Way::Forward })
            };
            let arc = |a: CurvePoint| {
                let apart = (boundary.fraction(a) - boundary.fraction(image)).abs();
                apart.min(1.0 - apart) * boundary.perimeter()
            };
            points[source.vertex_at(j)] = rounding + arc(further).max(arc(nearer));
        }
        let image = points.iter().copied().fold(0.0, f64::max);
        Some(ErrorEstimate { omega, image, points })
    }

    /// The share of a side's boundary where finite elements continue the measure of the boundary integral; 0 if they do
    /// nowhere, or everything is theirs.
    pub fn continued_share(&self, side: Side) -> f64 {
        let (measure, lengths) = (self.measure(side), self.side(side).edge_lengths());
        let Some(sharp) = measure.sharp() else { return 0.0 };
        let total: f64 = lengths.iter().sum();
        let length = |j: usize| {
            let (from, to) = measure.span(j);
            lengths[measure.vertex_at(j)] * (to - from)
        };
        let is_continued = |j: &usize| sharp.is_continued(*j) && sharp.is_continued(j + 1);
        (0..=measure.vertex_count()).filter(is_continued).map(length).fold(0.0, |sum, length| sum + length) / total
    }

    /// The fraction of the other curve's length at an image on it; 0 if its measure is from finite elements.
    pub fn image_fraction(&self, image: CurvePoint) -> f64 {
        let sharp = self.measure(self.mapped_side().other()).sharp();
        sharp.map_or(0.0, |sharp| sharp.boundary().fraction(image))
    }

    /// The number of boundary edges of the mapped mesh both of whose ends have one image in f64.
    pub fn coinciding_edges(&self) -> usize {
        let images = &self.images()[..self.mapped().boundary_count().min(self.images().len())];
        images.iter().zip(images.iter().cycle().skip(1)).filter(|(a, b)| a == b).count()
    }
}

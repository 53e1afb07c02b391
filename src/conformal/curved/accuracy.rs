//! The error estimate of a map with both measures from the boundary integral.

use super::super::{ConformalMap, Side};
use super::curve_measure::nearer;
use super::sharp::SharpMeasure;
use crate::geometry::CurvePoint;

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
    /// An estimate of the errors; `None` unless both measures are from the boundary integral, or the map was
    /// [compared](Self::compare_with) with one on finer meshes.
    /// That of images is [`super::CurveMap::error`], and on refined meshes the distance from [`super::CurveMap::image`].
    /// Cost O(m).
    pub fn error_estimate(&self) -> Option<ErrorEstimate> {
        if let Some(compared) = &self.compared {
            return Some(compared.estimate().clone());
        }
        let side = self.mapped_side();
        let (source, map) = (self.measure(side), self.curve_map(side)?);
        let mut points = vec![0.0; source.vertex_count()];
        let sharp = Side::BOTH.iter().filter_map(|&side| self.measure(side).sharp());
        let mut omega = sharp.map(SharpMeasure::error).fold(0.0, f64::max);
        for j in 1..=source.vertex_count() {
            let (measure, way) = nearer(source, j);
            omega = omega.max(map.continued_error(measure, way));
            let vertex = source.vertex_at(j);
            let place = self.mapped().curve_boundary().filter(|_| !self.far.is_empty());
            points[vertex] = match place {
                Some(boundary) => map.error(boundary.points()[vertex]),
                None => map.error_of(measure, way),
            };
        }
        if let (Some(_), Some(boundary)) = (self.resolution(), self.mapped().curve_boundary()) {
            // next to a part that is not resolved, images are those of the part's ends
            for ((error, image), &place) in points.iter_mut().zip(self.images()).zip(boundary.points()) {
                *error += image.distance(map.onto_curve().position(map.image(place)));
            }
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
        let is_far = |j: usize| {
            (1..=measure.vertex_count()).contains(&j)
                && self.far.iter().any(|far| far.is_continued(side, measure.vertex_at(j)))
        };
        let is_known = |j: usize| sharp.is_continued(j) || is_far(j);
        let is_continued = |j: &usize| is_known(*j) && is_known(j + 1);
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

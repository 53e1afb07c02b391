//! The error of a map with finite elements, estimated by comparison with the same map on finer meshes.
//!
//! Twice the samples, with interiors that are finer in proportion, and surfaces with every triangle cut into four. With
//! errors of order p the coarse error is the difference over 1 − 2^{−p}; p = 1.5 in the mean on graded meshes, less next
//! to corners. Sides with the integral equation are not refined: their own estimate counts. What the comparison does
//! not see: how far the triangles of a surface are from the surface that is meant.

mod pair;
mod quartered;

use super::curved::{CurveMeasure, Way};
use super::{
    BoundaryCorrespondence, ConformalMap, Constraints, ErrorEstimate, HarmonicMeasure, KernelMode, MapError, PerSide,
    Places, PrepareSettings, PreparedSide, Side, match_measures,
};
use crate::geometry::{CurvePoint, DVec3};
use crate::mesh::Sizing;
use crate::outline::{BoundaryPoint, MAX_SAMPLES, Sampling};
use pair::{Pair, point_on_finer};
pub use quartered::{QuarteredError, prepare_quartered};
use std::sync::Arc;

/// The coarse error in differences from the finer map: 1/(1 − 2^{−p}) is 1.6 for p = 1.5 and 2 for p = 1, and both maps
/// share a part of their error. With 2.5, 5 % of the maximal errors on the truth suite are not covered, by factors of
/// up to 1.4.
const COARSE: f64 = 4.0;
/// The difference of both maps changes its sign along the boundary: an estimate is the largest one of so many vertices
/// to either side.
const NEIGHBOURS: usize = 3;

impl PrepareSettings {
    /// Settings for a mesh to compare with one that has `m` samples: twice as many, and half the growth inwards. `None`
    /// beyond the largest number of samples.
    #[must_use]
    pub fn finer(self, m: usize) -> Option<Self> {
        let count = u32::try_from(2 * m).ok().filter(|&count| count <= MAX_SAMPLES)?;
        let sampling = match self.sampling {
            Sampling::Uniform { keep_corners, .. } => Sampling::Uniform { count, keep_corners },
            Sampling::Adaptive { .. } => Sampling::Adaptive { target: Some(count) },
        };
        let sizing = match self.sizing.at(m) {
            Sizing::Graded(growth) => Sizing::Graded(0.5 * growth),
            Sizing::Uniform => Sizing::Uniform,
        };
        Some(Self { sampling, sizing, kernel: KernelMode::Adjoint, ..self })
    }
}

/// What a comparison found.
#[derive(Debug, Clone)]
pub struct Differences {
    estimate: ErrorEstimate,
    /// The error of the inverse image of each boundary vertex of the other side.
    inverse: Vec<f64>,
}

impl Differences {
    /// The errors of the map.
    pub fn estimate(&self) -> &ErrorEstimate {
        &self.estimate
    }
}

/// A boundary measure at places of another mesh's boundary, and its inverse as positions.
struct Compared<'a> {
    measure: &'a HarmonicMeasure,
    curve: Option<CurveMeasure<'a>>,
    side: &'a PreparedSide,
}

impl<'a> Compared<'a> {
    fn of(map: &'a ConformalMap, side: Side) -> Self {
        let measure = map.measure(side);
        Self { measure, curve: CurveMeasure::new(measure), side: map.side(side) }
    }

    /// The smaller one of the measures at a point of the curve, or at a fraction of the boundary.
    fn nearer(&self, on_curve: Option<CurvePoint>, fraction: f64) -> (f64, Way) {
        if let (Some(curve), Some(point)) = (&self.curve, on_curve) {
            return curve.nearer(point);
        }
        let forward = self.measure.at(self.side.at_fraction(fraction));
        if forward <= 0.5 { (forward, Way::Forward) } else { (1.0 - forward, Way::Backward) }
    }

    /// The position in space of the point at a measure.
    fn place(&self, omega: f64, way: Way) -> DVec3 {
        if let Some(curve) = &self.curve {
            return curve.sharp().boundary().curve().position(curve.point(omega, way)).extend(0.0);
        }
        let forward = if way == Way::Forward { omega } else { 1.0 - omega };
        self.side.boundary_place(self.measure.point_at(forward))
    }
}

impl ConformalMap {
    /// The same map between finer sides; sides with the integral equation may be those of this map.
    ///
    /// Errors: as [`Self::new`]. `None` before the first update, and if a side is not this one's in finer form.
    pub fn on_finer(&self, finer: &PerSide<Arc<PreparedSide>>) -> Result<Option<Self>, MapError> {
        let constraint = |side: Side| {
            let (point, anchor) = self.sides[side].constraint()?;
            let own = self.side(side);
            if Arc::ptr_eq(own, &finer[side]) {
                return Some((point, anchor));
            }
            let pair = Pair { side: own, finer: &finer[side] };
            let anchor = if own.is_surface() { pair.fraction(own.at_fraction(anchor))? } else { anchor };
            Some((point_on_finer(point), anchor))
        };
        let [Some(source), Some(target)] = Side::BOTH.map(constraint) else { return Ok(None) };
        let [first, second] = [Side::Source, Side::Target].map(|side| Arc::clone(&finer[side]));
        Self::new(first, second, &Constraints::new(source, target), self.direction().into()).map(Some)
    }

    /// Keeps the estimate that comparison with `finer`, from [`Self::on_finer`], gives, until the map changes:
    /// [`Self::error_estimate`] then returns it. False if the maps cannot be compared.
    pub fn compare_with(&mut self, finer: &Self) -> bool {
        let estimate = self.differences_from(finer, PerSide::new(1, 1));
        self.compared = estimate.map(Box::new);
        self.compared.is_some()
    }

    /// An estimate of the error of the image of each boundary vertex of a side in the other one. `None` unless the map was
    /// [compared](Self::compare_with), or the side is the mapped one and both measures are from the boundary integral.
    pub fn boundary_errors(&self, from: Side) -> Option<Vec<f64>> {
        match &self.compared {
            Some(compared) if from != self.mapped_side() => Some(compared.inverse.clone()),
            None if from != self.mapped_side() => None,
            _ => self.error_estimate().map(|estimate| estimate.points),
        }
    }

    /// What comparison with `finer` gives, at the boundary vertices whose numbers are multiples of the stride.
    pub(super) fn differences_from(&self, finer: &Self, strides: PerSide<usize>) -> Option<Differences> {
        let (mapped, images) = (self.mapped_side(), self.image_places());
        let place = |k: usize| match images {
            Places::Plane(places) => places[k].extend(0.0),
            Places::Space(places) => places[k],
        };
        let (omega, points) = self.differences(finer, (mapped, strides[mapped]), &place)?;
        let other = mapped.other();
        let mut back = BoundaryCorrespondence::default();
        match_measures(self.measure(other), self.measure(mapped), &mut back);
        let place = |k: usize| match back.on_curve(k) {
            Some((_, position)) => position.extend(0.0),
            None => self.side(mapped).boundary_place(back.points()[k]),
        };
        let (omega_of_other, inverse) = self.differences(finer, (other, strides[other]), &place)?;
        let image = points.iter().copied().fold(0.0, f64::max);
        Some(Differences { estimate: ErrorEstimate { omega: omega.max(omega_of_other), image, points }, inverse })
    }

    /// The estimated errors of a side's measure, and of the images of its vertices, which are at these places.
    fn differences(
        &self,
        finer: &Self,
        (side, stride): (Side, usize),
        place: &dyn Fn(usize) -> DVec3,
    ) -> Option<(f64, Vec<f64>)> {
        let target = Compared::of(finer, side.other());
        let mut differences = Vec::new();
        let omega = self.largest_difference(finer, (side, stride), &mut |k, (omega, way)| {
            differences.push(COARSE * place(k).distance(target.place(omega, way)));
        })?;
        let m = differences.len();
        let around = |k: usize| (0..=2 * NEIGHBOURS).map(move |i| (k + m + i - NEIGHBOURS.min(m)) % m);
        Some((omega, (0..m).map(|k| around(k).map(|i| differences[i]).fold(0.0, f64::max)).collect()))
    }

    /// The estimated error of a side's measure at the vertices that `stride` divides; tells `each` vertex's measure in the
    /// finer map.
    fn largest_difference(
        &self,
        finer: &Self,
        (side, stride): (Side, usize),
        each: &mut dyn FnMut(usize, (f64, Way)),
    ) -> Option<f64> {
        let (own, there) = (Compared::of(self, side), Compared::of(finer, side));
        let pair = Pair { side: self.side(side), finer: finer.side(side) };
        let points = own.curve.as_ref().map(|curve| curve.sharp().boundary().points());
        let mut largest = 0.0_f64;
        for k in (0..own.measure.vertex_count()).step_by(stride) {
            let fraction = pair.fraction(BoundaryPoint::new(k as u32, 0.0))?;
            let (omega, way) = there.nearer(points.map(|points| points[k]), fraction);
            let forward = if way == Way::Forward { omega } else { 1.0 - omega };
            let apart = (own.measure.at_vertex(k) - forward).abs();
            // at the anchor 0 is 1
            largest = largest.max(apart.min(1.0 - apart));
            each(k, (omega, way));
        }
        Some(match &own.curve {
            Some(curve) if there.curve.is_some() => curve.sharp().error(),
            _ => COARSE * largest,
        })
    }
}

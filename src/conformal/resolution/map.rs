//! The map on the refined mesh: the boundary map is the known one, the extension is new.

use super::ResolvedBoundary;
use crate::conformal::far_anchors::{FarAnchor, far_anchors};
use crate::conformal::map_side::MapSide;
use crate::conformal::{
    BoundaryCorrespondence, ConformalMap, Constraints, HarmonicMeasure, MapError, MapSettings, PerSide, PreparedSide,
    Side,
};
use crate::laplace::Deadline;
use crate::outline::BoundaryPoint;
use std::sync::Arc;

impl ConformalMap {
    /// This map with the mapped mesh replaced by `refined`, whose boundary is that of `boundary`. The other side and the
    /// boundary map stay; the images of the vertices are still to be computed.
    ///
    /// Errors: as [`Self::update`].
    pub(super) fn resolved(
        &self,
        boundary: Arc<ResolvedBoundary>,
        refined: PreparedSide,
        settings: MapSettings,
    ) -> Result<Self, MapError> {
        let side = self.mapped_side();
        let refined = Arc::new(refined.with_curve_of(self.side(side), &boundary.places));
        let mut map = Self::unmapped(Arc::clone(&self.sides.source.prepared), Arc::clone(&self.sides.target.prepared));
        map.sides[side.other()] = self.sides[side.other()].copied();
        let kernel: Vec<f64> = boundary.places.iter().map(|&place| value_at(self.kernel(side), place)).collect();
        let measure = self.refined_measure(&boundary, &refined, &kernel);
        map.sides[side] = MapSide::with_measure(refined, side, &self.sides[side], kernel, measure)?;
        let mapped = Arc::clone(map.side(side));
        let on_refined = |far: &FarAnchor| far.on_other_samples(side, (&mapped, map.measure(side)), &boundary.places);
        map.far = self.far.iter().filter_map(on_refined).collect();
        self.set_images(&boundary, &mapped, &mut map.correspondence);
        map.settings = MapSettings { direction: self.settings.direction, ..settings };
        map.resolution = Some(boundary);
        Ok(map)
    }

    /// The far anchors of a map that keeps none; `None` if both measures are from the boundary integral.
    pub(super) fn far_of_finite_elements(&self) -> Option<Vec<FarAnchor>> {
        let sides = PerSide::from_fn(|side| (&**self.side(side), self.measure(side)));
        let is_kept = sides.iter().all(|(_, (_, measure))| measure.is_sharp());
        (!is_kept).then(|| far_anchors(sides))
    }

    /// The constraints of the last complete update; `None` before it.
    pub(in crate::conformal) fn constraints(&self) -> Option<Constraints> {
        let [source, target] = Side::BOTH.map(|side| self.sides[side].constraint());
        let (source, target) = (source?, target?);
        Some(Constraints { points: PerSide::new(source.0, target.0), anchors: PerSide::new(source.1, target.1) })
    }

    /// The measure at the vertices of the refined boundary, at which the finite-element density is `kernel`.
    fn refined_measure(&self, boundary: &ResolvedBoundary, refined: &PreparedSide, kernel: &[f64]) -> HarmonicMeasure {
        let side = self.mapped_side();
        let own = self.measure(side);
        let fraction = self.sides[side].constraint().map(|(_, anchor)| anchor.rem_euclid(1.0));
        if let (Some(sharp), Some(fraction)) = (own.sharp(), fraction) {
            let mut measure = HarmonicMeasure::default();
            measure.set_along(refined.edge_lengths(), kernel, refined.at_fraction(fraction));
            sharp.resampled(refined, fraction, None, &mut measure);
            return measure;
        }
        let anchor = refined.at_fraction(self.side(side).fraction_at(own.anchor()));
        HarmonicMeasure::from_values(anchor, kernel.len(), |k| kernel[k], |k| boundary.measures[k])
    }

    /// The images of the refined boundary: on the other side's curve, if its measure is from the boundary integral, and
    /// at the measure of the vertex, if both are. Images that already have that measure, as far as it is told apart,
    /// stay; so do the ends of cuts, and images for which the one at their measure would be out of order. Corners stay
    /// where the measure is theirs to its accuracy: at a right angle an error of 1e-13 would be one of 3e-7 in the place.
    fn set_images(&self, boundary: &ResolvedBoundary, refined: &PreparedSide, result: &mut BoundaryCorrespondence) {
        let side = self.mapped_side();
        let measure = self.measure(side.other());
        let Some(sharp) = measure.sharp() else {
            return result.set(boundary.images.clone());
        };
        result.begin_exact(boundary.images.len(), measure.anchor(), sharp.anchor());
        let maps = self.curve_map(side).zip(self.curve_map(side.other())).zip(refined.curve_boundary());
        for (k, &image) in boundary.images.iter().enumerate() {
            let known = sharp.boundary().curved(image);
            let exact = maps.as_ref().filter(|_| !boundary.is_at_cut(k)).and_then(|((map, inverse), places)| {
                let place = places.points()[k];
                let is_corner = sharp.boundary().curve().is_corner(known);
                let tolerance = if is_corner { ACCURACY } else { 8.0 * f64::EPSILON };
                let is_equal = are_indistinct(map.measure_at(place), inverse.measure_at(known), tolerance);
                if is_equal {
                    return None;
                }
                let point = map.image(place);
                let exact = sharp.boundary().sampled(point);
                boundary.is_in_order(k, exact).then_some((exact, point))
            });
            let (image, point) = exact.unwrap_or((image, known));
            result.set_exact(k, image, point, sharp.boundary().curve().position(point));
        }
    }

    /// Begins with the images of the vertices, from those of the boundary.
    pub(super) fn begin_resolved_extension(&mut self) {
        let side = self.mapped_side();
        let Some(domain) = self.sides[side.other()].prepared.domain().map(Arc::clone) else { return };
        let boundary = self.correspondence.images(domain.samples());
        self.sides[side].prepared.begin_extension(boundary, &mut self.extension_scratch);
    }

    /// Continues until all vertices have their images (true) or `deadline` has passed.
    pub(super) fn advance_resolved_extension(&mut self, deadline: Deadline) -> Result<bool, MapError> {
        let side = self.mapped_side();
        let prepared = &self.sides[side].prepared;
        let is_done = prepared.advance_extension(&mut self.extension_scratch, &mut self.images, deadline);
        is_done.map_err(|error| MapError::NotConverged { side, error })
    }
}

/// How accurate a measure is, relative to itself: that of the boundary integral.
const ACCURACY: f64 = 1e-11;

/// Whether two measures from the anchors, both ways, are equal up to this share of them, at least the rounding of their sums.
fn are_indistinct(here: (f64, f64), there: (f64, f64), tolerance: f64) -> bool {
    let (here, there) = if here.0 <= here.1 { (here.0, there.0) } else { (here.1, there.1) };
    (here - there).abs() <= tolerance * here
}

/// Values at the vertices of a closed chain, interpolated linearly.
fn value_at(values: &[f64], point: BoundaryPoint) -> f64 {
    let (k, t) = (point.edge() as usize, point.fraction());
    (1.0 - t) * values[k] + t * values[(k + 1) % values.len()]
}

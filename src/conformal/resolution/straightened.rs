//! Images next to a re-entrant corner of the other domain, extended in a coordinate in which the corner is straight.
//!
//! Where a limb of the mapped domain goes into a corner of interior angle α > π, images f decay like the power α/π of
//! the slowest harmonic function in the limb. The error of the harmonic extension of f contains that slowest one, and
//! far inside the limb it is larger than f: triangles flip there, however small their images are. The function
//! F = (f − corner)^(π/α) decays like the slowest one itself. Its boundary values are known too; where f is near to the
//! corner, its harmonic extension gives f = corner + F^(α/π).

use super::corner::exponent;
use crate::conformal::{ConformalMap, MapError, MeshedDomain, triangle_distortions};
use crate::geometry::{DVec2, sort_by_number};
use crate::laplace::Deadline;

/// A share of flipped triangles above which corners are straightened, and the refinement repeated: a tenth of what a
/// picture may have.
pub(super) const FOLDS: f64 = 1e-4;

/// The most corners that are straightened, those with the most flipped triangles.
const CORNERS: usize = 8;

/// The distance from the corner, in extents of the other domain, up to which images are replaced. There both extensions
/// agree to the error of either one, which is small against the triangles.
const REACH: f64 = 0.02;

/// A corner of the other domain.
#[derive(Debug)]
struct Corner {
    at: DVec2,
    /// The direction of the edge that begins there.
    outgoing: DVec2,
    /// α/π.
    power: f64,
}

impl Corner {
    /// Corner `k` of a counter-clockwise polygon; `None` if it is not re-entrant.
    fn new(points: &[DVec2], k: usize) -> Option<Self> {
        let power = exponent(points, k).recip();
        let outgoing = (points[(k + 1) % points.len()] - points[k]).normalize_or_zero();
        (power > 1.0 && outgoing != DVec2::ZERO).then_some(Self { at: points[k], outgoing, power })
    }

    /// F at the images of the boundary's vertices; `None` if none of these is the corner.
    fn straighten(&self, images: &[DVec2]) -> Option<Vec<DVec2>> {
        let m = images.len();
        let first = (0..m).find(|&k| images[k] == self.at && images[(k + 1) % m] != self.at)?;
        let mut values = vec![DVec2::ZERO; m];
        let (mut before, mut angle) = (self.outgoing, 0.0);
        for k in (1..m).map(|k| (first + k) % m) {
            let spoke = images[k] - self.at;
            if spoke != DVec2::ZERO {
                angle += before.angle_to(spoke);
                values[k] = spoke.length().powf(self.power.recip()) * DVec2::from_angle(angle / self.power);
                before = spoke;
            }
        }
        Some(values)
    }

    /// f from F.
    fn image(&self, value: DVec2) -> DVec2 {
        let radius = value.length().powf(self.power);
        let angle = if value == DVec2::ZERO { 0.0 } else { value.to_angle() };
        self.at + radius * self.outgoing.rotate(DVec2::from_angle(self.power * angle))
    }
}

/// The corners around which triangles of a map are flipped, one after the other.
#[derive(Debug)]
pub(super) struct Straightening {
    /// The distance from a corner up to which images are replaced.
    reach: f64,
    /// The number of flipped triangles.
    flipped: usize,
    corners: std::vec::IntoIter<Corner>,
}

impl Straightening {
    /// The corners of a map whose images are those of the extension.
    pub fn new(map: &ConformalMap) -> Self {
        let nothing = Self { reach: 0.0, flipped: 0, corners: Vec::new().into_iter() };
        let side = map.mapped_side();
        let (Some(mapped), Some(other)) = (map.domain(side), map.domain(side.other())) else { return nothing };
        let flips = flipped(mapped, &map.images);
        if flips.len() as f64 <= FOLDS * mapped.mesh().triangles().len() as f64 {
            return nothing;
        }
        let reach = REACH * super::extent(other.samples().points());
        let places = flips.iter().map(|&t| map.images[mapped.mesh().triangles()[t][0] as usize]);
        let corners = folded_corners(other.samples().points(), places, reach).into_iter();
        Self { reach, flipped: flips.len(), corners }
    }

    /// Replaces the images next to one more corner, if that leaves fewer flipped triangles; true after the last one.
    pub fn advance(&mut self, map: &mut ConformalMap) -> Result<bool, MapError> {
        let Some(corner) = self.corners.next() else { return Ok(true) };
        let side = map.mapped_side();
        let m = map.mapped().boundary_count();
        let Some(boundary) = corner.straighten(&map.images[..m]) else { return Ok(false) };
        let (prepared, scratch) = (&map.sides[side].prepared, &mut map.extension_scratch);
        let mut values = Vec::new();
        prepared.begin_extension(boundary.into_iter(), scratch);
        let is_done = prepared.advance_extension(scratch, &mut values, Deadline::NEVER);
        is_done.map_err(|error| MapError::NotConverged { side, error })?;
        let mut images = map.images.clone();
        for (image, value) in images.iter_mut().zip(values).skip(m) {
            let straightened = corner.image(value);
            if straightened.distance(corner.at) < self.reach {
                *image = straightened;
            }
        }
        let fewer = map.domain(side).map_or(self.flipped, |mapped| flipped(mapped, &images).len());
        if fewer < self.flipped {
            (map.images, self.flipped) = (images, fewer);
        }
        Ok(false)
    }
}

/// The flipped triangles.
fn flipped(mapped: &MeshedDomain, images: &[DVec2]) -> Vec<usize> {
    let distortions = triangle_distortions(mapped.mesh(), images);
    (0..distortions.len()).filter(|&t| distortions[t].flipped).collect()
}

/// The re-entrant corners that are the nearest ones, within `reach`, to most of these places.
fn folded_corners(points: &[DVec2], places: impl Iterator<Item = DVec2>, reach: f64) -> Vec<Corner> {
    let corners: Vec<Corner> = (0..points.len()).filter_map(|k| Corner::new(points, k)).collect();
    let mut counts = vec![0usize; corners.len()];
    for place in places {
        let distance = |k: &usize| corners[*k].at.distance_squared(place);
        let nearest = (0..corners.len()).min_by(|i, j| distance(i).total_cmp(&distance(j)));
        if let Some(k) = nearest.filter(|k| distance(k) < reach * reach) {
            counts[k] += 1;
        }
    }
    let mut found: Vec<(usize, Corner)> = counts.into_iter().zip(corners).filter(|(count, _)| *count > 0).collect();
    sort_by_number(&mut found, |(count, _)| -(*count as f64));
    found.into_iter().take(CORNERS).map(|(_, corner)| corner).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn the_l_shapes_corner_becomes_a_straight_line_and_back() {
        let points = [(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from);
        assert!(Corner::new(&points, 0).is_none());
        let corner = Corner::new(&points, 3).unwrap();
        assert!((corner.power - 1.5).abs() < 1e-12);
        let values = corner.straighten(&points).unwrap();
        // both edges at the corner lie on one line, everything else on one side of it
        assert!(values[4].y.abs() < 1e-15 && values[4].x > 0.0 && values[2].y.abs() < 1e-15 && values[2].x < 0.0);
        assert!([0, 1, 5].into_iter().all(|k| values[k].y > 0.1), "{values:?}");
        for (p, &value) in points.iter().zip(&values) {
            assert!(corner.image(value).distance(*p) < 1e-14, "{p}");
        }
    }
}

//! A region of the source: polygons in the plane, and strokes of a brush in the plane or in space.

use crate::geometry::{DVec3, SimplePolygon};

/// The most dabs of a brush in one region.
pub const MOST_DABS: usize = 4096;

/// The most polygons in one region.
pub const MOST_POLYGONS: usize = 1024;

/// One dab of a brush: a disk in the plane (z = 0), or the part of a surface within a distance in space.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Dab {
    /// Its middle; in the plane z = 0.
    pub middle: DVec3,
    /// Its radius, > 0.
    pub radius: f64,
}

impl Dab {
    /// The dab with numbers rounded to 32 bits, as links hold them.
    #[must_use]
    pub fn rounded(self) -> Self {
        Self { middle: self.middle.as_vec3().as_dvec3(), radius: f64::from(self.radius as f32) }
    }
}

/// The union of polygons and dabs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Region {
    polygons: Vec<SimplePolygon>,
    dabs: Vec<Dab>,
}

impl Region {
    /// The union of polygons in the plane.
    pub fn of_polygons(polygons: Vec<SimplePolygon>) -> Self {
        Self { polygons, dabs: Vec::new() }
    }

    /// The union of dabs.
    pub fn of_dabs(dabs: Vec<Dab>) -> Self {
        Self { polygons: Vec::new(), dabs }
    }

    /// Whether nothing was painted.
    pub fn is_empty(&self) -> bool {
        self.polygons.is_empty() && self.dabs.is_empty()
    }

    /// Whether a place of the source lies inside; the plane lies at z = 0, and polygons hold nothing else.
    pub fn contains(&self, place: DVec3) -> bool {
        let painted = |dab: &Dab| dab.middle.distance_squared(place) <= dab.radius * dab.radius;
        let inside = |polygon: &SimplePolygon| polygon.contains(place.truncate());
        self.dabs.iter().any(painted) || (place.z == 0.0 && self.polygons.iter().any(inside))
    }

    /// The share of a triangle that lies inside, in quarters: by its middle and the points half way to its corners.
    pub fn share(&self, corners: [DVec3; 3]) -> f64 {
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let places = [middle, 0.5 * (middle + corners[0]), 0.5 * (middle + corners[1]), 0.5 * (middle + corners[2])];
        0.25 * places.into_iter().filter(|&place| self.contains(place)).count() as f64
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::outline::Preset;

    #[test]
    fn a_place_is_inside_of_a_polygon_or_of_a_dab() {
        let square = SimplePolygon::try_from(vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]).unwrap();
        let far = Preset::Heart.outline().polygon().clone();
        let polygons = Region::of_polygons(vec![square, far]);
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        assert!(polygons.contains(at(0.5, 0.99, 0.0)) && !polygons.contains(at(0.5, 0.99, 0.1)));
        let dabs = Region::of_dabs(vec![Dab { middle: at(1.0, 2.0, 3.0), radius: 0.5 }]);
        assert!(dabs.contains(at(1.0, 2.0, 3.49)) && !dabs.contains(at(1.0, 2.0, 3.51)));
        assert!(Region::default().is_empty() && !dabs.is_empty());
    }

    #[test]
    fn the_share_of_a_triangle_is_in_quarters() {
        let dab = |radius: f64| Region::of_dabs(vec![Dab { middle: DVec3::ZERO, radius }]);
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let shares = [0.01, 0.3, 0.5, 2.0].map(|radius| dab(radius).share(corners));
        assert_eq!(shares, [0.0, 0.25, 0.5, 1.0]);
    }
}

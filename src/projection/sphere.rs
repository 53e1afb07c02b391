//! The unit sphere: longitude and latitude in degrees, and stereographic coordinates.

use crate::geometry::{DVec2, DVec3};

/// The point with this longitude and latitude, in degrees.
pub fn on_sphere(lon_lat: DVec2) -> DVec3 {
    let (longitude, latitude) = (lon_lat.x.to_radians(), lon_lat.y.to_radians());
    DVec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin())
}

/// Longitude in (−180, 180] and latitude of a point, in degrees.
pub fn lon_lat(p: DVec3) -> DVec2 {
    DVec2::new(p.y.atan2(p.x).to_degrees(), p.z.atan2(p.x.hypot(p.y)).to_degrees())
}

/// Stereographic coordinates about a center: |z| = tan(d/2) at the angular distance d, with the metric
/// λ |dz|, λ = 2/(1 + |z|²). The antipode of the center is at infinity.
#[derive(Debug, Clone, Copy)]
pub struct Stereographic {
    center: DVec3,
    east: DVec3,
    north: DVec3,
}

impl Stereographic {
    /// About this point, with north (at a pole: the meridian of 180° or 0°) along the imaginary axis.
    pub fn about(center: DVec3) -> Self {
        let center = center.normalize();
        let east = DVec3::Z.cross(center).try_normalize().unwrap_or(DVec3::Y);
        Self { center, east, north: center.cross(east) }
    }

    /// The center.
    pub fn center(&self) -> DVec3 {
        self.center
    }

    /// The coordinate z of a point.
    pub fn to_plane(self, p: DVec3) -> DVec2 {
        DVec2::new(p.dot(self.east), p.dot(self.north)) / (1.0 + p.dot(self.center))
    }

    /// The point with the coordinate z.
    pub fn to_sphere(self, z: DVec2) -> DVec3 {
        let square = z.length_squared();
        (2.0 * (z.x * self.east + z.y * self.north) + (1.0 - square) * self.center) / (1.0 + square)
    }

    /// The direction in which latitude grows, in the plane at z; any at the poles themselves.
    pub fn north_at(self, z: DVec2) -> DVec2 {
        let p = self.to_sphere(z);
        let north = DVec3::Z - p.z * p;
        // the differential of `to_plane` applied to `north`
        let part = DVec2::new(north.dot(self.east), north.dot(self.north)) - z * north.dot(self.center);
        part.try_normalize().unwrap_or(DVec2::Y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stereographic_coordinates_are_the_tangent_of_half_the_distance_and_return() {
        let frame = Stereographic::about(on_sphere(DVec2::new(170.0, -40.0)));
        for place in [[170.0, -10.0], [-175.0, -89.0], [20.0, 30.0], [170.0, -40.0]].map(DVec2::from_array) {
            let p = on_sphere(place);
            let z = frame.to_plane(p);
            let distance = p.angle_between(frame.center());
            assert!((z.length() - (0.5 * distance).tan()).abs() < 1e-7, "{place}: {z}");
            assert!(frame.to_sphere(z).distance(p) < 1e-13, "{place}");
            let later = frame.to_plane(on_sphere(place + DVec2::new(0.0, 1e-4)));
            assert!(frame.north_at(z).distance((later - z).normalize()) < 1e-4, "{place}");
        }
        assert!(lon_lat(on_sphere(DVec2::new(-123.0, 77.0))).distance(DVec2::new(-123.0, 77.0)) < 1e-12);
    }
}

//! Messages for regions of the sphere that have no projection.

use crate::language::{Message, Value, key};
use crate::projection::{Contact, LEAST_CLEARANCE, Place, ProjectionError};

impl From<Place> for Message {
    fn from(Place { ring, point }: Place) -> Self {
        key::point_of_ring(point, ring)
    }
}

impl From<&ProjectionError> for Message {
    fn from(error: &ProjectionError) -> Self {
        match error {
            ProjectionError::Latitude { place, latitude } => key::region_latitude(Self::from(*place), *latitude),
            ProjectionError::Longitude { place, longitude } => key::region_longitude(Self::from(*place), *longitude),
            ProjectionError::TooFewPoints { ring, points } => key::region_too_few_points(*ring, *points),
            ProjectionError::NoBoundary => key::region_no_boundary().into(),
            ProjectionError::NearlyWholeSphere { clearance } => {
                key::region_nearly_whole_sphere(Value::number(format!("{clearance:.2}")), LEAST_CLEARANCE)
            }
            ProjectionError::NotSimple { contact, at, first, second } => {
                let words = match contact {
                    Contact::Crosses => key::region_crosses,
                    Contact::Touches => key::region_touches,
                };
                let shown = |degrees: f64| (degrees * 1e4).round() / 1e4;
                words(shown(at.x), shown(at.y), Self::from(*first), Self::from(*second))
            }
            ProjectionError::Polygon(error) => key::region_no_polygon(Self::from(error)),
            ProjectionError::Cancelled => key::projection_cancelled().into(),
            ProjectionError::Mesh(error) => key::region_not_meshed(Self::from(error)),
        }
    }
}

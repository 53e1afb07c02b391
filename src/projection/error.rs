//! Why a region has no projection, and where.

use super::Place;
use crate::geometry::{DVec2, PolygonError};
use crate::mesh::MeshError;
use std::fmt;

/// How the boundary of a region fails to be simple.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// Two edges cross.
    Crosses,
    /// The boundary touches itself in a point.
    Touches,
}

impl fmt::Display for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Crosses => "crosses",
            Self::Touches => "touches",
        })
    }
}

/// Why a region has no projection, and where. Rings and points are counted from 1, in the file's order.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProjectionError {
    /// A latitude beyond the poles.
    #[error(
        "{place} has the latitude {latitude}°: latitudes are from −90° to 90° (a point is [longitude, latitude] in degrees; convert meters first)"
    )]
    Latitude {
        /// The point.
        place: Place,
        /// Its second number.
        latitude: f64,
    },
    /// A longitude beyond two turns.
    #[error(
        "{place} has the longitude {longitude}°: longitudes are from −180° to 180° (up to ±360° is accepted; convert meters first)"
    )]
    Longitude {
        /// The point.
        place: Place,
        /// Its first number.
        longitude: f64,
    },
    /// A ring with fewer than three points.
    #[error("ring {ring} has {points} different points in a row; a ring needs at least 3")]
    TooFewPoints {
        /// The ring.
        ring: usize,
        /// The number of its points that differ from the one before.
        points: usize,
    },
    /// Nothing is left but what the rings cover twice or not at all.
    #[error("the rings enclose no area, or the whole sphere")]
    NoBoundary,
    /// The part of the sphere outside the region is too small.
    #[error(
        "the region covers almost the whole sphere: no point is more than {clearance:.2}° outside, and {} is the limit",
        super::region::LEAST_CLEARANCE
    )]
    NearlyWholeSphere {
        /// The angular distance of the farthest point outside from the boundary.
        clearance: f64,
    },
    /// The boundary is not simple.
    #[error(
        "the boundary {contact} itself at longitude {}°, latitude {}°: the edge after {first} and the edge after {second}",
        shown(.at.x), shown(.at.y)
    )]
    NotSimple {
        /// What it does.
        contact: Contact,
        /// Longitude and latitude.
        at: DVec2,
        /// The beginning of the first edge.
        first: Place,
        /// The beginning of the second edge.
        second: Place,
    },
    /// The boundary in stereographic coordinates is no polygon for another reason.
    #[error("the boundary cannot be used: {0}")]
    Polygon(PolygonError),
    /// The computation was cancelled.
    #[error("the computation was canceled")]
    Cancelled,
    /// The region cannot be triangulated.
    #[error("the region cannot be triangulated: {0}")]
    Mesh(#[from] MeshError),
}

/// Degrees with as many digits as are of use: ten meters.
fn shown(degrees: f64) -> f64 {
    (degrees * 1e4).round() / 1e4
}

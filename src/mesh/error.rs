//! Why a boundary could not be meshed, and where.

use crate::geometry::{DVec2, orientation, sort_by_number};

/// Why a boundary could not be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum MeshError {
    /// The samples do not form a simple polygon (too few of them for this outline).
    #[error("the sampled boundary crosses itself near ({x}, {y}): use more samples")]
    SelfCrossing {
        /// x of the crossing, approximately.
        x: f64,
        /// y of the crossing, approximately.
        y: f64,
    },
    /// Two boundary points coincide.
    #[error("two boundary samples coincide at ({x}, {y})")]
    RepeatedPoint {
        /// x of the point.
        x: f64,
        /// y of the point.
        y: f64,
    },
    /// Fewer than three boundary points.
    #[error("a boundary needs at least 3 points; this one has {count}")]
    TooFewPoints {
        /// Number of points given.
        count: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("boundary point {index} is not finite")]
    NotFinite {
        /// Index of the point.
        index: usize,
    },
    /// The boundary encloses no positive area when it is traversed as given.
    #[error("the boundary is clockwise, or encloses no area")]
    NotCounterClockwise,
    /// All coordinates are 0, or they are too large or too small to compute with.
    #[error("the boundary's coordinates are all zero, or beyond 2^±300")]
    OutOfRange,
    /// The growth of the triangles is not in `[0.01, 1]`.
    #[error("the growth of the triangle size has to be between 0.01 and 1, not {grading}")]
    Grading {
        /// The requested growth.
        grading: f64,
    },
    /// The mesh would not fit into memory.
    #[error(
        "this mesh would have about {estimate:.2e} interior vertices; at most {limit} are made: use fewer samples, or graded triangles"
    )]
    TooManyVertices {
        /// Approximate number of interior vertices.
        estimate: f64,
        /// The largest number allowed.
        limit: usize,
    },
    /// Rounding made the triangulation inconsistent: features near the limit of `f64`.
    #[error("the boundary is too thin near ({x}, {y}) to be triangulated in double precision")]
    TooThin {
        /// x of the place.
        x: f64,
        /// y of the place.
        y: f64,
    },
}

impl MeshError {
    /// The error for a boundary edge between vertices `a` and `b` that could not be inserted: finds what it crosses.
    pub(super) fn of_crossing(boundary: &[DVec2], a: usize, b: usize) -> Self {
        let m = boundary.len();
        let (p, q) = (boundary[a % m], boundary[b % m]);
        let meets = |k: usize| {
            let next = (k + 1) % m;
            if [k, next].iter().any(|&v| v == a || v == b) {
                return None;
            }
            crossing(p, q, boundary[k], boundary[next])
        };
        let place = (0..m).find_map(meets).unwrap_or(0.5 * (p + q));
        Self::SelfCrossing { x: place.x, y: place.y }
    }

    /// The error for two boundary points that coincide: finds them.
    pub(super) fn of_repeated_point(boundary: &[DVec2]) -> Self {
        let mut sorted = boundary.to_vec();
        sort_by_number(&mut sorted, |point| point.y);
        sort_by_number(&mut sorted, |point| point.x);
        let place = sorted.windows(2).find(|w| w[0] == w[1]).map_or(boundary[0], |w| w[0]);
        Self::RepeatedPoint { x: place.x, y: place.y }
    }

    /// The error in the caller's coordinates, which had been multiplied by `scale`.
    pub(super) fn unscaled(self, scale: f64) -> Self {
        match self {
            Self::SelfCrossing { x, y } => Self::SelfCrossing { x: x / scale, y: y / scale },
            Self::RepeatedPoint { x, y } => Self::RepeatedPoint { x: x / scale, y: y / scale },
            Self::TooThin { x, y } => Self::TooThin { x: x / scale, y: y / scale },
            other => other,
        }
    }
}

/// Where the closed segments `pq` and `ab` meet, approximately.
fn crossing(p: DVec2, q: DVec2, a: DVec2, b: DVec2) -> Option<DVec2> {
    let (sa, sb) = (orientation(p, q, a), orientation(p, q, b));
    let (sp, sq) = (orientation(a, b, p), orientation(a, b, q));
    if sa == 0.0 && sb == 0.0 {
        let within = |x: DVec2| (x - p).dot(x - q) <= 0.0;
        return [a, b].into_iter().find(|&x| within(x));
    }
    if sa * sb > 0.0 || sp * sq > 0.0 {
        return None;
    }
    Some(a.lerp(b, (sa / (sa - sb)).clamp(0.0, 1.0)))
}

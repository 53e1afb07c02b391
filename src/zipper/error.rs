//! The errors of the geodesic algorithm.

/// Why the geodesic algorithm could not map a domain. Crowding is not an error: see
/// [`super::DiskMap::collapsed`].
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ZipperError {
    /// Fewer than three boundary points.
    #[error("at least 3 boundary points are needed, not {count}")]
    TooFewPoints {
        /// The number of points.
        count: usize,
    },
    /// A boundary point is not finite.
    #[error("boundary point {index} is not finite")]
    NotFinite {
        /// Its index.
        index: usize,
    },
    /// A boundary point equals the previous one.
    #[error("boundary point {index} repeats the one before it")]
    Repeated {
        /// Its index.
        index: usize,
    },
    /// The interior point is not to the left of the curve that the algorithm draws
    /// through the boundary points. That curve consists of hyperbolic geodesics and may deviate
    /// from the polygon if the boundary is coarse.
    #[error("the point ({x}, {y}) is not inside the curve through the boundary points")]
    PointOutside {
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
}

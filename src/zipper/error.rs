//! Why a boundary has no map to the disk.

/// Why the geodesic algorithm could not map a domain. Crowding is no error: see
/// [`super::DiskMap::collapsed`].
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ZipperError {
    /// Fewer than three boundary points.
    #[error("at least 3 boundary points are needed, not {count}")]
    TooFewPoints {
        /// How many there are.
        count: usize,
    },
    /// A boundary point is not finite.
    #[error("boundary point {index} is not finite")]
    NotFinite {
        /// Which one.
        index: usize,
    },
    /// A boundary point repeats the one before it.
    #[error("boundary point {index} repeats the one before it")]
    Repeated {
        /// Which one.
        index: usize,
    },
    /// The interior point is not to the left of the curve that the algorithm draws
    /// through the boundary points. That curve is made of hyperbolic geodesics: on a
    /// coarse boundary it strays from the polygon.
    #[error("the point ({x}, {y}) is not inside the curve through the boundary points")]
    PointOutside {
        /// Its position.
        x: f64,
        /// Its position.
        y: f64,
    },
}

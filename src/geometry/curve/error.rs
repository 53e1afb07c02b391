//! Why pieces do not make a closed curve, and where.
//!
//! Indices in the fields count from 0; the messages count pieces from 1.

use glam::DVec2;

/// Why pieces do not make a closed curve, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum CurveError {
    /// There is no piece.
    #[error("a curve needs at least one piece")]
    Empty,
    /// A piece has a coordinate or a derivative that is NaN or infinite.
    #[error("piece {} is not finite", .piece + 1)]
    NotFinite {
        /// Index of the piece.
        piece: usize,
    },
    /// A piece has no length.
    #[error("piece {} has no length", .piece + 1)]
    NoLength {
        /// Index of the piece.
        piece: usize,
    },
    /// The speed of a piece vanishes at one of its ends, so that the curve has no tangent there.
    #[error("piece {} has no tangent at its end at ({}, {})", .piece + 1, .at.x, .at.y)]
    NoTangent {
        /// Index of the piece.
        piece: usize,
        /// The end.
        at: DVec2,
    },
    /// A piece does not begin where the one before it ends.
    #[error("the curve is not closed: piece {} begins {gap:e} away from the end of the piece before it", .piece + 1)]
    Open {
        /// Index of the piece.
        piece: usize,
        /// The distance.
        gap: f64,
    },
    /// The curve runs clockwise.
    #[error("the curve runs clockwise")]
    Clockwise,
    /// Two pieces meet in an angle of 0 or 360 degrees.
    #[error("the curve has a cusp at ({}, {}), where piece {} begins", .at.x, .at.y, .piece + 1)]
    Cusp {
        /// Index of the piece that begins there.
        piece: usize,
        /// The cusp.
        at: DVec2,
    },
    /// A junction with different tangents on both sides was called analytic.
    #[error("pieces meet in an angle where piece {} begins: the curve is not analytic there", .piece + 1)]
    NotAnalytic {
        /// Index of the piece that begins there.
        piece: usize,
    },
}

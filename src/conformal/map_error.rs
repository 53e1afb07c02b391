//! The errors of a map, and the warnings about the images of a surface's boundary.

use super::Side;
use crate::boundary_integral::BoundaryIntegralError;
use crate::counted::counted;
use crate::laplace::NotConverged;
use crate::mesh::TriangleId;

/// Why a map could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// An interior point is not inside its (sampled) domain.
    #[error("the {side} point ({x}, {y}) is not inside the {side} outline as it is sampled")]
    PointOutside {
        /// Which domain.
        side: Side,
        /// The x coordinate of the point.
        x: f64,
        /// The y coordinate of the point.
        y: f64,
    },
    /// There is no such triangle of the surface, or the weights are negative or do not sum to 1.
    #[error("{}", counted!(
        *triangles,
        "({}, {}, {}) in triangle {triangle} is no point of the surface, which has 1 triangle",
        "({}, {}, {}) in triangle {triangle} is no point of the surface, which has {triangles} triangles",
        weights[0],
        weights[1],
        weights[2]
    ))]
    NoPoint {
        /// Which surface.
        side: Side,
        /// Which triangle.
        triangle: TriangleId,
        /// The weights at its corners.
        weights: [f64; 3],
        /// The number of triangles.
        triangles: usize,
    },
    /// The interior point of a surface lies on its boundary, where harmonic measure is a point mass.
    #[error("the surface point lies on the boundary of the surface; it must be inside")]
    OnBoundary {
        /// Which surface.
        side: Side,
    },
    /// A planar position was given for a surface, or a point of a surface for a planar domain.
    #[error("the {side} point is of the other kind: a place in the plane for a surface, or a surface's for an outline")]
    OtherKind {
        /// Which side.
        side: Side,
    },
    /// An anchor of a domain is not a number.
    #[error("the {side} anchor is not a finite fraction of the arc length")]
    AnchorNotFinite {
        /// Which domain.
        side: Side,
    },
    /// An anchor of a surface is not a number.
    #[error("the surface anchor is not a finite fraction of the length of the boundary loop")]
    LoopAnchorNotFinite {
        /// Which surface.
        side: Side,
    },
    /// A side's iterative solver did not converge; one with a complete factor has no such error.
    #[error("{side}: {error}")]
    NotConverged {
        /// Which side.
        side: Side,
        /// The solver's error.
        error: NotConverged,
    },
    /// The boundary integral gives no harmonic measure from the interior point.
    #[error("{side}: {error}")]
    BoundaryIntegral {
        /// Which side.
        side: Side,
        /// The reason.
        error: BoundaryIntegralError,
    },
}

impl MapError {
    /// The side that the error is about.
    pub fn side(&self) -> Side {
        match self {
            Self::PointOutside { side, .. }
            | Self::NoPoint { side, .. }
            | Self::OnBoundary { side }
            | Self::OtherKind { side }
            | Self::AnchorNotFinite { side }
            | Self::LoopAnchorNotFinite { side }
            | Self::NotConverged { side, .. }
            | Self::BoundaryIntegral { side, .. } => *side,
        }
    }
}

/// A warning about a surface under a map: boundary edges whose images (between two surfaces, in the unit disk) are
/// points in f64.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MapNote {
    /// Edges without harmonic measure.
    #[error("{}", counted!(
        *edges,
        "the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one",
        "the ends of {edges} boundary edges fall together: no inner way leads there from the surface point, or too long \
         a one"
    ))]
    NoMeasure {
        /// The number of edges.
        edges: usize,
    },
    /// Edges without harmonic measure, or the kernel has negative values so that the order of the boundary is lost.
    #[error("{}", counted!(
        *edges,
        "the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one, \
         or the kernel is negative there, as it may be without intrinsic Delaunay flips",
        "the ends of {edges} boundary edges fall together: no inner way leads there from the surface point, or too long \
         a one, or the kernel is negative there, as it may be without intrinsic Delaunay flips"
    ))]
    NegativeKernel {
        /// The number of edges.
        edges: usize,
    },
}

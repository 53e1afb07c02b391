//! Why a side stays with finite elements although the boundary integral was requested.

use crate::boundary_integral::BoundaryIntegralError;
use crate::geometry::CurveError;
use crate::mesh::MeshError;

/// Why a side stays with finite elements although the boundary integral was requested.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Unsharpened {
    /// The outline's points do not make a curve.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// The integral equation of the boundary is too large, or not resolved.
    #[error(transparent)]
    Integral(#[from] BoundaryIntegralError),
    /// The polygon's points do not follow the curve.
    #[error("the outline's points do not follow its curve")]
    Apart,
    /// The samples on the curve cannot be meshed.
    #[error("samples on the curve cannot be meshed: {0}")]
    Mesh(#[from] MeshError),
}

//! Extending the boundary map into the mesh: the choice, and the harmonic one, equation (14): L̂ ŵ = −L̄ w̄.

use super::PreparedDomain;
use crate::geometry::DVec2;
use crate::laplace::{Lanes, NotConverged};

/// How the boundary map is extended into the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Extension {
    /// f̃ of equation (14): discrete harmonic, interpolates the boundary. One solve.
    #[default]
    Harmonic,
    /// f̂ of equation (15): Cauchy's integral of the boundary images, holomorphic inside;
    /// replaces the images of the boundary vertices too. Cost O(m (m+n)).
    CauchyGreen,
}

/// Replaces the interior part of `values` (length m+n) by the discrete harmonic
/// extension of its boundary part `values[..m]`. Both coordinates are solved in
/// one sweep; `scratch` is reused, so repeated calls allocate nothing.
///
/// Errors: [`NotConverged`], of an iterative solver only; the interior is then unchanged.
pub fn harmonic_extension(
    domain: &PreparedDomain,
    values: &mut [DVec2],
    scratch: &mut Vec<Lanes<2>>,
) -> Result<(), NotConverged> {
    domain.system().extend(values, scratch)
}

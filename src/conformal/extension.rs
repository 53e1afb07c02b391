//! Extending the boundary map into the mesh: the options, and the harmonic one, equation (14): L̂ ŵ = −L̄ w̄.

use super::PreparedSide;
use crate::geometry::DVec2;
use crate::laplace::{Deadline, Lanes, NotConverged, SolveRun};

/// How the boundary map is extended into the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Extension {
    /// f̃ of equation (14): discrete harmonic, interpolates the boundary. One solve.
    #[default]
    Harmonic,
    /// f̂ of equation (15): Cauchy's integral of the boundary images, holomorphic inside;
    /// replaces the images of the boundary vertices too. Cost O(m (m+n)).
    CauchyGreen,
    /// The map itself by Cauchy's integral over the boundary's curves ([`super::InteriorMap`]): the images of interior
    /// vertices are exact. Needs measures from the integral equation on both sides; else the images are harmonic.
    Exact,
}

/// Working memory of an extension, with the progress of one that is interrupted; no allocation when it is reused.
#[derive(Debug, Clone, Default)]
pub(crate) struct ExtensionScratch {
    /// The boundary values.
    pub(super) boundary: Vec<DVec2>,
    pub(super) solution: Vec<Lanes<2>>,
    /// Whether the right-hand side has entries away from the boundary.
    pub(super) has_sources: bool,
    pub(super) run: SolveRun,
}

/// The discrete harmonic extension of `boundary` (length m) to all vertices (length m+n, the
/// boundary's first). Both coordinates are solved for in one sweep.
///
/// Errors: [`NotConverged`], from the iterative solver only.
pub fn harmonic_extension(
    side: &PreparedSide,
    boundary: impl Iterator<Item = DVec2>,
) -> Result<Vec<DVec2>, NotConverged> {
    let (mut scratch, mut values) = (ExtensionScratch::default(), Vec::new());
    side.begin_extension(boundary, &mut scratch);
    side.advance_extension(&mut scratch, &mut values, Deadline::NEVER)?;
    Ok(values)
}

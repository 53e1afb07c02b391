//! The geometry of a planar side: an outline, sampled and meshed.

use super::prepare::timed;
use super::{PrepareError, PrepareSettings, PrepareTimings, Resampled, Stage};
use crate::geometry::{DVec2, SimplePolygon};
use crate::mesh::{MeshError, RefineReport, Sizing, TriMesh, mesh_domain};
use crate::outline::{BoundarySamples, sample};

/// A planar domain, sampled and meshed.
///
/// The mesh's boundary vertices are the samples, in their order; the default point lies inside the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshedDomain {
    samples: BoundarySamples,
    mesh: TriMesh,
    refinement: RefineReport,
    default_point: DVec2,
}

impl MeshedDomain {
    /// Samples and meshes the inside of `polygon`.
    pub(super) fn new(
        polygon: &SimplePolygon,
        settings: &PrepareSettings,
        timings: &mut PrepareTimings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Self, PrepareError> {
        progress(Stage::Sample);
        let samples = timed(&mut timings.sample, || sample(polygon, settings.sampling))?;
        progress(Stage::Mesh);
        Ok(Self::of_samples(polygon, samples, settings.sizing, timings)?)
    }

    /// Meshes the inside of samples on, or next to, `polygon`.
    pub(super) fn of_samples(
        polygon: &SimplePolygon,
        samples: BoundarySamples,
        sizing: Sizing,
        timings: &mut PrepareTimings,
    ) -> Result<Self, MeshError> {
        let sizing = sizing.at(samples.len());
        let (mesh, refinement) = timed(&mut timings.mesh, || mesh_domain(samples.points(), sizing))?;
        let default_point = default_point(polygon, &mesh);
        Ok(Self { samples, mesh, refinement, default_point })
    }

    /// A domain meshed with other samples of its boundary, with the growth that belongs to its own ones.
    pub(super) fn resampled(
        resampled: &Resampled,
        sizing: Sizing,
        timings: &mut PrepareTimings,
    ) -> Result<Self, PrepareError> {
        let Resampled { samples, coarse_count, default_point } = resampled;
        let sizing = sizing.at(*coarse_count);
        let (mesh, refinement) = timed(&mut timings.mesh, || mesh_domain(samples.points(), sizing))?;
        Ok(Self { samples: samples.clone(), mesh, refinement, default_point: *default_point })
    }

    /// The domain from its parts, as they are after a transfer.
    #[cfg(feature = "io")]
    pub(super) fn from_parts(
        samples: BoundarySamples,
        mesh: TriMesh,
        refinement: RefineReport,
        default_point: DVec2,
    ) -> Self {
        Self { samples, mesh, refinement, default_point }
    }

    /// The boundary samples, `m` of them.
    pub fn samples(&self) -> &BoundarySamples {
        &self.samples
    }

    /// The mesh over the samples.
    pub fn mesh(&self) -> &TriMesh {
        &self.mesh
    }

    /// Whether the mesh meets its limits.
    pub fn refinement(&self) -> RefineReport {
        self.refinement
    }

    /// The default interior point: the pole of inaccessibility.
    pub fn default_point(&self) -> DVec2 {
        self.default_point
    }

    /// The point inside the domain nearest to `x` that is at least `inset` from the boundary,
    /// where the domain is wide enough: a dragged handle slides along the boundary.
    pub fn nearest_inside(&self, x: DVec2, inset: f64) -> DVec2 {
        crate::mesh::nearest_inside(&self.mesh, x, inset)
    }
}

/// The pole of inaccessibility, to a thousandth of the polygon's size.
pub(super) fn pole(polygon: &SimplePolygon) -> DVec2 {
    polygon.pole_of_inaccessibility(1e-3 * polygon.bounds().size().max_element())
}

/// The pole of inaccessibility of the polygon. On a very coarse sampling it may lie outside
/// the mesh; then the centroid of the largest triangle is used.
fn default_point(polygon: &SimplePolygon, mesh: &TriMesh) -> DVec2 {
    let pole = pole(polygon);
    if crate::mesh::locate(mesh, pole, None).is_some() {
        return pole;
    }
    let corners = |t: &[u32; 3]| t.map(|v| mesh.vertices()[v as usize]);
    let area = |t: &[u32; 3]| {
        let [a, b, c] = corners(t);
        (b - a).perp_dot(c - a)
    };
    let largest = mesh.triangles().iter().max_by(|s, t| area(s).total_cmp(&area(t)));
    largest.map_or(pole, |t| corners(t).iter().sum::<DVec2>() / 3.0)
}

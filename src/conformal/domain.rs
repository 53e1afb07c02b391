//! Everything about one domain that does not depend on the constraints.

use crate::geometry::{DVec2, SimplePolygon};
use crate::laplace::{DirichletLaplacian, Factor, LaplaceError, Ordering, RootPaths};
use crate::mesh::{MeshError, RefineReport, Sizing, TriMesh, mesh_domain};
use crate::outline::{BoundarySamples, Sampling, SamplingError, sample};
use sprs::CsMatI;
use web_time::Instant;

/// How a domain is discretised.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct PrepareSettings {
    /// How the boundary is sampled.
    pub sampling: Sampling,
    /// How the triangle size varies.
    pub sizing: Sizing,
}

/// A stage of the preparation, for progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Sampling the boundary.
    Sample,
    /// Triangulating.
    Mesh,
    /// Assembling the cotangent Laplacian.
    Assemble,
    /// Fill-reducing ordering.
    Order,
    /// Cholesky factorisation.
    Factor,
}

/// How long each stage took, in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
pub struct PrepareTimings {
    pub sample: f64,
    pub mesh: f64,
    pub assemble: f64,
    pub order: f64,
    pub factor: f64,
}

impl PrepareTimings {
    /// The whole preparation.
    pub fn total(&self) -> f64 {
        self.sample + self.mesh + self.assemble + self.order + self.factor
    }
}

/// Why a domain could not be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PrepareError {
    /// The boundary could not be sampled.
    #[error(transparent)]
    Sampling(#[from] SamplingError),
    /// The sampled boundary could not be meshed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The Laplacian could not be factored.
    #[error(transparent)]
    Laplace(#[from] LaplaceError),
}

/// A domain, sampled, meshed, assembled and factored.
#[derive(Debug, Clone)]
pub struct PreparedDomain {
    /// The boundary samples, `m` of them.
    pub samples: BoundarySamples,
    /// The mesh over them.
    pub mesh: TriMesh,
    /// Whether the mesh meets its limits.
    pub refinement: RefineReport,
    /// L̄ (n×m, by columns).
    pub coupling: CsMatI<f64, u32>,
    /// The factor of L̂.
    pub factor: Factor,
    /// The root paths of the boundary's neighbours in the factor.
    pub boundary_paths: RootPaths,
    /// The default interior point: the pole of inaccessibility.
    pub pole: DVec2,
    /// How long it took.
    pub timings: PrepareTimings,
}

/// Samples, meshes, assembles, orders and factors, reporting each stage before it starts.
pub fn prepare(
    polygon: &SimplePolygon,
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedDomain, PrepareError> {
    let mut timings = PrepareTimings::default();
    progress(Stage::Sample);
    let samples = timed(&mut timings.sample, || sample(polygon, settings.sampling))?;
    progress(Stage::Mesh);
    let (mesh, refinement) = timed(&mut timings.mesh, || mesh_domain(&samples.points, settings.sizing))?;
    progress(Stage::Assemble);
    let laplacian = timed(&mut timings.assemble, || DirichletLaplacian::assemble(&mesh))?;
    progress(Stage::Order);
    let ordering = timed(&mut timings.order, || Ordering::minimum_degree(&laplacian))?;
    progress(Stage::Factor);
    let factor = timed(&mut timings.factor, || Factor::new(&laplacian, ordering))?;
    let pole = default_point(polygon, &mesh);
    Ok(PreparedDomain::new(samples, mesh, refinement, laplacian.coupling, factor, pole, timings))
}

impl PreparedDomain {
    /// Bundles the parts; the root paths of the boundary follow from them.
    pub(super) fn new(
        samples: BoundarySamples,
        mesh: TriMesh,
        refinement: RefineReport,
        coupling: CsMatI<f64, u32>,
        factor: Factor,
        pole: DVec2,
        timings: PrepareTimings,
    ) -> Self {
        let mut boundary_paths = RootPaths::default();
        factor.root_paths(coupling.indices().iter().copied(), &mut boundary_paths);
        Self { samples, mesh, refinement, coupling, factor, boundary_paths, pole, timings }
    }

    /// The point inside the domain nearest to `x` that keeps the distance `inset`
    /// from the boundary where the domain is wide enough: a handle slides along the boundary.
    pub fn nearest_inside(&self, x: DVec2, inset: f64) -> DVec2 {
        crate::mesh::nearest_inside(&self.mesh, x, inset)
    }
}

/// The pole of inaccessibility of the polygon. On a very coarse sampling it may lie outside
/// the mesh; then the centroid of the largest triangle serves.
fn default_point(polygon: &SimplePolygon, mesh: &TriMesh) -> DVec2 {
    let pole = polygon.pole_of_inaccessibility(1e-3 * polygon.bounds().size().max_element());
    if crate::mesh::locate(mesh, pole, 0).is_some() {
        return pole;
    }
    let corners = |t: &[u32; 3]| t.map(|v| mesh.vertices[v as usize]);
    let area = |t: &[u32; 3]| {
        let [a, b, c] = corners(t);
        (b - a).perp_dot(c - a)
    };
    let largest = mesh.triangles.iter().max_by(|s, t| area(s).total_cmp(&area(t)));
    largest.map_or(pole, |t| corners(t).iter().sum::<DVec2>() / 3.0)
}

fn timed<T>(milliseconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *milliseconds = start.elapsed().as_secs_f64() * 1e3;
    result
}

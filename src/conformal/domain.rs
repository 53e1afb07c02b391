//! Everything about one domain that does not depend on the constraints.

use super::{HarmonicTable, TableError};
use crate::geometry::{DVec2, SimplePolygon};
use crate::laplace::{DirichletLaplacian, LaplaceError, Ordering, RootPaths, Solver, SolverKind};
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
    /// How the kernel is computed.
    #[serde(default)]
    pub kernel: KernelMode,
    /// How linear systems are solved.
    #[serde(default)]
    pub solver: SolverKind,
}

/// How the kernel at a point is computed; the numbers are the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KernelMode {
    /// By one adjoint solve for each new point.
    #[default]
    Adjoint,
    /// From a table of all harmonic coordinates, made in advance (the paper's way).
    Table,
}

/// What a preparation may take of the memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Memory {
    /// For the factor of L̂; above it the iterative solver serves.
    pub factor_bytes: u64,
    /// For the table of harmonic coordinates; above it the preparation is refused.
    pub table_bytes: u64,
}

impl Default for Memory {
    /// An eighth of what a browser can give to one page where addresses have 32 bits, else a
    /// quarter of a laptop's memory; for each side, and before a worker hands it over by copying.
    fn default() -> Self {
        let bytes = if usize::BITS == 32 { 512 << 20 } else { 4 << 30 };
        Self { factor_bytes: bytes, table_bytes: bytes }
    }
}

/// A stage of the preparation, for progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Reading a surface and checking what it is.
    Read,
    /// Sampling the boundary.
    Sample,
    /// Triangulating.
    Mesh,
    /// Assembling the cotangent Laplacian.
    Assemble,
    /// Fill-reducing ordering.
    Order,
    /// Cholesky factorisation, complete or incomplete.
    Factor,
    /// Solving for the table of harmonic coordinates.
    Table {
        /// How much of it is done.
        percent: u8,
    },
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
    pub table: f64,
}

impl PrepareTimings {
    /// The whole preparation.
    pub fn total(&self) -> f64 {
        self.sample + self.mesh + self.assemble + self.order + self.factor + self.table
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
    /// The table of harmonic coordinates could not be made.
    #[error(transparent)]
    Table(#[from] TableError),
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
    /// Solves with L̂.
    pub solver: Solver,
    /// The root paths of the boundary's neighbours in the solver.
    pub boundary_paths: RootPaths,
    /// The harmonic coordinates of all interior vertices, where they are wanted.
    pub table: Option<HarmonicTable>,
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
    prepare_within(Memory::default(), polygon, settings, progress)
}

/// As [`prepare`], with the memory that it may take. A factor that does not fit gives
/// way to the iterative solver (see [`Solver::kind`] of the result), a table that does not is an error.
pub fn prepare_within(
    memory: Memory,
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
    if settings.kernel == KernelMode::Table {
        HarmonicTable::check(mesh.interior_count(), samples.len(), memory)?;
    }
    let solver = solver_for(&laplacian, settings.solver, memory, &mut timings, progress)?;
    let mut table = None;
    if settings.kernel == KernelMode::Table {
        let mut tell = |percent| progress(Stage::Table { percent });
        let coordinates = || HarmonicTable::new(&solver, &laplacian.coupling, &mut tell);
        table = Some(timed(&mut timings.table, coordinates)?);
    }
    let pole = default_point(polygon, &mesh);
    Ok(PreparedDomain::new(samples, mesh, refinement, laplacian.coupling, solver, table, pole, timings))
}

/// The solver that is wanted; the iterative one too where the direct one does not fit.
pub(super) fn solver_for(
    laplacian: &DirichletLaplacian,
    wanted: SolverKind,
    memory: Memory,
    timings: &mut PrepareTimings,
    progress: &mut dyn FnMut(Stage),
) -> Result<Solver, LaplaceError> {
    if wanted == SolverKind::Direct {
        progress(Stage::Order);
        let ordering = timed(&mut timings.order, || Ordering::minimum_degree(laplacian));
        progress(Stage::Factor);
        let factor = |ordering| Solver::direct(laplacian, ordering, memory.factor_bytes);
        match timed(&mut timings.factor, || ordering.and_then(factor)) {
            Err(LaplaceError::TooLarge { .. }) => {}
            result => return result,
        }
    }
    progress(Stage::Factor);
    timed(&mut timings.factor, || Solver::pcg(laplacian))
}

impl PreparedDomain {
    /// Bundles the parts; the root paths of the boundary follow from them.
    #[allow(clippy::too_many_arguments, reason = "the parts of a domain, once")]
    pub(super) fn new(
        samples: BoundarySamples,
        mesh: TriMesh,
        refinement: RefineReport,
        coupling: CsMatI<f64, u32>,
        solver: Solver,
        table: Option<HarmonicTable>,
        pole: DVec2,
        timings: PrepareTimings,
    ) -> Self {
        let mut boundary_paths = RootPaths::default();
        solver.root_paths(coupling.indices().iter().copied(), &mut boundary_paths);
        Self { samples, mesh, refinement, coupling, solver, boundary_paths, table, pole, timings }
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

pub(super) fn timed<T>(milliseconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *milliseconds = start.elapsed().as_secs_f64() * 1e3;
    result
}

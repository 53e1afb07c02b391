//! Everything about one surface that does not depend on the constraints (section 4.3).
//!
//! A surface is prepared as a planar domain is, but for its geometry: the Laplacian comes from
//! edge lengths, by default of the intrinsic Delaunay triangulation of its vertices, so that
//! no weight is negative, ψ ≥ 0, and the matching keeps the order of the boundary.

use super::domain::{solver_for, timed};
use super::flat::SystemParts;
use super::kernel::KernelScratch;
use super::system::HarmonicSystem;
use super::{ExtensionScratch, HarmonicTable, KernelMode, Memory, PrepareError, PrepareTimings, Stage, unfold};
use crate::geometry::{DVec2, DVec3};
use crate::laplace::{Deadline, DirichletLaplacian, NotConverged, RootPaths, Solver, SolverKind};
use crate::mesh::{BarycentricPoint, FlipReport, IntrinsicMesh, TriMesh};
use crate::outline::BoundaryPoint;
use crate::surface::{SurfaceMesh, SurfaceTree, farthest_from_boundary};
use sprs::CsMatI;
use std::sync::OnceLock;

/// How a surface is discretised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct SurfaceSettings {
    /// Whether edges are flipped to the intrinsic Delaunay triangulation.
    pub intrinsic_delaunay: bool,
    /// How the kernel is computed.
    #[serde(default)]
    pub kernel: KernelMode,
    /// How linear systems are solved.
    #[serde(default)]
    pub solver: SolverKind,
}

impl Default for SurfaceSettings {
    fn default() -> Self {
        Self { intrinsic_delaunay: true, kernel: KernelMode::default(), solver: SolverKind::default() }
    }
}

/// A surface, flipped, assembled and factored.
#[derive(Debug, Clone)]
pub struct PreparedSurface {
    /// The surface: boundary loop first.
    pub surface: SurfaceMesh,
    /// The lengths of the boundary edges, `m` of them.
    pub edge_lengths: Vec<f64>,
    /// Where each boundary vertex lies: the fraction of the loop's length from the first one.
    pub fractions: Vec<f64>,
    /// L̄ (n×m, by columns).
    pub coupling: CsMatI<f64, u32>,
    /// Solves with L̂.
    pub solver: Solver,
    /// The root paths of the boundary's neighbours in the solver.
    pub boundary_paths: RootPaths,
    /// The harmonic coordinates of all interior vertices, where they are wanted.
    pub table: Option<HarmonicTable>,
    /// What the intrinsic Delaunay flips have done; without them, the negative weights that there are.
    pub flips: FlipReport,
    /// The default interior point: the vertex farthest from the boundary.
    pub centre: BarycentricPoint,
    /// How long it took; `mesh` is the flips and the default point.
    pub timings: PrepareTimings,
    tree: OnceLock<SurfaceTree>,
}

/// Flips, assembles, orders and factors, reporting each stage before it starts. The memory is as in [`super::prepare_within`].
pub fn prepare_surface(
    memory: Memory,
    surface: SurfaceMesh,
    settings: SurfaceSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSurface, PrepareError> {
    let mut timings = PrepareTimings::default();
    progress(Stage::Mesh);
    let (intrinsic, flips, centre) = timed(&mut timings.mesh, || {
        let mut intrinsic = IntrinsicMesh::of(&surface.mesh);
        let flips = if settings.intrinsic_delaunay { intrinsic.make_delaunay() } else { unflipped(&intrinsic) };
        (intrinsic, flips, farthest_from_boundary(&surface.mesh))
    });
    progress(Stage::Assemble);
    let laplacian = timed(&mut timings.assemble, || DirichletLaplacian::assemble_intrinsic(&intrinsic))?;
    drop(intrinsic);
    let m = surface.mesh.boundary_count as usize;
    if settings.kernel == KernelMode::Table {
        HarmonicTable::check(surface.mesh.interior_count(), m, memory)?;
    }
    let solver = solver_for(&laplacian, settings.solver, memory, &mut timings, progress)?;
    let mut table = None;
    if settings.kernel == KernelMode::Table {
        let mut tell = |percent| progress(Stage::Table { percent });
        table = Some(timed(&mut timings.table, || HarmonicTable::new(&solver, &laplacian.coupling, &mut tell))?);
    }
    let system = SystemParts { coupling: laplacian.coupling, solver, table };
    Ok(PreparedSurface::new(surface, system, flips, centre, timings))
}

fn unflipped(intrinsic: &IntrinsicMesh) -> FlipReport {
    let negative = intrinsic.negative_weights();
    FlipReport { flips: 0, negative_before: negative, negative_after: negative }
}

/// The lengths of the boundary edges, and the fraction of their sum before each.
fn along_boundary(mesh: &TriMesh<DVec3>) -> (Vec<f64>, Vec<f64>) {
    let boundary = &mesh.vertices[..mesh.boundary_count as usize];
    let next = boundary.iter().cycle().skip(1);
    let lengths: Vec<f64> = boundary.iter().zip(next).map(|(p, q)| p.distance(*q)).collect();
    let total: f64 = lengths.iter().sum();
    let before = lengths.iter().scan(0.0, |sum, length| Some(std::mem::replace(sum, *sum + length)));
    let fractions = before.map(|sum| sum / total).collect();
    (lengths, fractions)
}

impl PreparedSurface {
    /// Bundles the parts; lengths and root paths of the boundary follow from them.
    pub(super) fn new(
        surface: SurfaceMesh,
        system: SystemParts,
        flips: FlipReport,
        centre: BarycentricPoint,
        timings: PrepareTimings,
    ) -> Self {
        let SystemParts { coupling, solver, table } = system;
        let mut boundary_paths = RootPaths::default();
        solver.root_paths(coupling.indices().iter().copied(), &mut boundary_paths);
        let (edge_lengths, fractions) = along_boundary(&surface.mesh);
        let tree = OnceLock::new();
        Self { surface, edge_lengths, fractions, coupling, solver, boundary_paths, table, flips, centre, timings, tree }
    }

    pub(super) fn system(&self) -> HarmonicSystem<'_> {
        HarmonicSystem {
            edge_lengths: &self.edge_lengths,
            coupling: &self.coupling,
            solver: &self.solver,
            boundary_paths: &self.boundary_paths,
            table: self.table.as_ref(),
        }
    }

    /// The boundary point at fraction `s` of the loop's length (taken modulo 1).
    pub fn at_fraction(&self, s: f64) -> BoundaryPoint {
        BoundaryPoint::at_fraction(&self.fractions, s)
    }

    /// The inverse of [`Self::at_fraction`].
    pub fn fraction_at(&self, point: BoundaryPoint) -> f64 {
        point.fraction_in(&self.fractions)
    }

    /// For rays and nearest points; made when it is first asked for.
    pub fn tree(&self) -> &SurfaceTree {
        self.tree.get_or_init(|| SurfaceTree::new(&self.surface.mesh))
    }

    /// The tree, if somebody has asked for it: it takes a while for millions of triangles.
    pub fn tree_if_made(&self) -> Option<&SurfaceTree> {
        self.tree.get()
    }

    /// The place of a point of the boundary loop in space.
    pub fn boundary_position(&self, point: BoundaryPoint) -> DVec3 {
        let (m, edge) = (self.surface.mesh.boundary_count, point.edge);
        let [a, b] = [edge, (edge + 1) % m].map(|k| self.surface.mesh.vertices[k as usize]);
        a.lerp(b, point.fraction)
    }

    /// The place of a point in space.
    pub fn position(&self, point: BarycentricPoint) -> DVec3 {
        let corners = self.surface.mesh.triangles[point.triangle as usize];
        corners.iter().zip(point.weights).map(|(&v, w)| w * self.surface.mesh.vertices[v as usize]).sum()
    }
}

/// As [`super::poisson_kernel`], at a point of a surface: interpolated from the ring of vertices around
/// it where that is flat and interior, else linearly as in (10). Without intrinsic Delaunay flips values may be negative.
pub fn surface_kernel(
    surface: &PreparedSurface,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    psi: &mut Vec<f64>,
) -> Result<(), NotConverged> {
    begin_surface_kernel(surface, x, scratch);
    advance_surface_kernel(surface, x, scratch, psi, Deadline::NEVER).map(|_| ())
}

/// Begins with [`surface_kernel`].
pub(super) fn begin_surface_kernel(surface: &PreparedSurface, x: BarycentricPoint, scratch: &mut KernelScratch) {
    unfold::around(&surface.surface.mesh, x, &mut scratch.stencil, &mut scratch.places);
    surface.system().begin_kernel(scratch);
}

/// Goes on with it until it is in `psi` (true) or `deadline` is over (`psi` is then meaningless).
pub(super) fn advance_surface_kernel(
    surface: &PreparedSurface,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    psi: &mut Vec<f64>,
    deadline: Deadline,
) -> Result<bool, NotConverged> {
    let corners = surface.surface.mesh.triangles[x.triangle as usize];
    surface.system().advance_kernel([0, 1, 2].map(|i| (corners[i], x.weights[i])), scratch, psi, deadline)
}

/// As [`super::advance_extension`], on a surface.
pub fn advance_surface_extension(
    surface: &PreparedSurface,
    scratch: &mut ExtensionScratch,
    values: &mut Vec<DVec2>,
    deadline: Deadline,
) -> Result<bool, NotConverged> {
    surface.system().advance_extension(scratch, values, deadline)
}

//! The preparation of a side: its settings, stages, memory limits and the computation itself.

use super::curved::{BoundaryEquation, CurveBoundary, Outlined};
use super::domain::MeshedDomain;
use super::prepared_side::{PreparedSide, Sharpness, SideGeometry};
use super::surface::MeshedSurface;
use super::system::DirichletSystem;
use super::{HarmonicTable, Resampled, TableError};
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::laplace::{DirichletLaplacian, LaplaceError, Ordering, Solver, SolverKind};
use crate::mesh::{MeshError, Sizing};
use crate::outline::{Sampling, SamplingError};
use crate::surface::SurfaceMesh;
use std::sync::Arc;
use web_time::Instant;

/// How a domain is discretised.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
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

impl PrepareSettings {
    /// The settings with the direct solver and kernels by adjoint solves.
    pub const fn new(sampling: Sampling, sizing: Sizing) -> Self {
        Self { sampling, sizing, kernel: KernelMode::Adjoint, solver: SolverKind::Direct }
    }

    /// The same settings with another sampling.
    #[must_use]
    pub const fn with_sampling(self, sampling: Sampling) -> Self {
        Self { sampling, ..self }
    }

    /// The same settings with another sizing.
    #[must_use]
    pub const fn with_sizing(self, sizing: Sizing) -> Self {
        Self { sizing, ..self }
    }

    /// The same settings with another kernel method.
    #[must_use]
    pub const fn with_kernel(self, kernel: KernelMode) -> Self {
        Self { kernel, ..self }
    }

    /// The same settings with another solver.
    #[must_use]
    pub const fn with_solver(self, solver: SolverKind) -> Self {
        Self { solver, ..self }
    }

    /// Whether maps of the domain are [refined](super::ConformalMap::refined) at rest: with adaptive samples, graded
    /// triangles and not from a table. The paper's settings are kept as they are.
    pub const fn is_refined(&self) -> bool {
        let is_adaptive = matches!(self.sampling, Sampling::Adaptive { .. });
        is_adaptive && matches!(self.sizing, Sizing::Graded(_)) && !matches!(self.kernel, KernelMode::Table)
    }
}

/// How harmonic measure is computed. The first two give the same numbers, those of finite elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum KernelMode {
    /// By one adjoint solve for each new point.
    #[default]
    Adjoint,
    /// From a table of all harmonic coordinates, computed in advance (the paper's method).
    Table,
    /// From the integral equation on the boundary's curve, to ten digits and more, where it fits; else, and for what it
    /// does not resolve, as with [`Self::Adjoint`]. For outlines only.
    Integral,
}

/// The memory that a preparation may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Memory {
    /// For the factor of L̂; if it needs more, the iterative solver is used.
    pub factor_bytes: u64,
    /// For the table of harmonic coordinates; if it needs more, the preparation is refused.
    pub table_bytes: u64,
}

impl Memory {
    /// The same limits with another one for the factor.
    #[must_use]
    pub const fn with_factor_bytes(self, factor_bytes: u64) -> Self {
        Self { factor_bytes, ..self }
    }

    /// The same limits with another one for the table.
    #[must_use]
    pub const fn with_table_bytes(self, table_bytes: u64) -> Self {
        Self { table_bytes, ..self }
    }
}

impl Default for Memory {
    /// An eighth of what a browser can give to one page with 32-bit addresses, else a
    /// quarter of a laptop's memory; for each side, and before a worker copies it.
    fn default() -> Self {
        let bytes = if usize::BITS == 32 { 512 << 20 } else { 4 << 30 };
        Self { factor_bytes: bytes, table_bytes: bytes }
    }
}

/// A stage of the preparation, for progress reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Stage {
    /// Reading an outline or a surface and checking that it is valid.
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
    /// Factoring the boundary's integral equation.
    Integral,
    /// Solving for the table of harmonic coordinates.
    Table {
        /// The percentage that is done.
        percent: u8,
    },
}

/// How long each stage took, in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
#[non_exhaustive]
pub struct PrepareTimings {
    pub sample: f64,
    pub mesh: f64,
    pub assemble: f64,
    pub order: f64,
    pub factor: f64,
    pub table: f64,
    pub integral: f64,
}

impl PrepareTimings {
    /// The sum of two preparations, stage by stage.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            sample: self.sample + other.sample,
            mesh: self.mesh + other.mesh,
            assemble: self.assemble + other.assemble,
            order: self.order + other.order,
            factor: self.factor + other.factor,
            table: self.table + other.table,
            integral: self.integral + other.integral,
        }
    }

    /// The duration of the whole preparation.
    pub fn total(&self) -> f64 {
        self.sample + self.mesh + self.assemble + self.order + self.factor + self.table + self.integral
    }
}

/// Why a side could not be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
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
    /// The boundary integral was requested for a surface, which has no boundary curve in the plane.
    #[error("the integral kernel is for outlines: a surface is computed with finite elements")]
    IntegralOfSurface,
}

/// How a surface is discretised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
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

impl SurfaceSettings {
    /// The same settings with or without flips to the intrinsic Delaunay triangulation.
    #[must_use]
    pub const fn with_intrinsic_delaunay(self, intrinsic_delaunay: bool) -> Self {
        Self { intrinsic_delaunay, ..self }
    }

    /// The same settings with another kernel method.
    #[must_use]
    pub const fn with_kernel(self, kernel: KernelMode) -> Self {
        Self { kernel, ..self }
    }

    /// The same settings with another solver.
    #[must_use]
    pub const fn with_solver(self, solver: SolverKind) -> Self {
        Self { solver, ..self }
    }
}

impl Default for SurfaceSettings {
    fn default() -> Self {
        Self { intrinsic_delaunay: true, kernel: KernelMode::default(), solver: SolverKind::default() }
    }
}

/// The geometry to prepare, and its settings.
#[derive(Debug)]
#[non_exhaustive]
pub enum Unprepared<'a> {
    /// The inside of an outline.
    Outline {
        /// The outline.
        polygon: &'a SimplePolygon,
        /// How to discretise it.
        settings: &'a PrepareSettings,
    },
    /// The inside of an outline whose curve is known. Without [`KernelMode::Integral`] as the outline alone.
    Curve {
        /// Points of the curve, from its first one on.
        polygon: &'a SimplePolygon,
        /// The curve.
        curve: &'a Curve,
        /// Interior points that harmonic measure will be taken from: next to the boundary, only these are resolved.
        near: &'a [DVec2],
        /// How to discretize it.
        settings: &'a PrepareSettings,
    },
    /// A triangle mesh in space.
    Surface {
        /// The mesh, topologically a disk.
        surface: SurfaceMesh,
        /// How to discretise it.
        settings: SurfaceSettings,
    },
}

/// Samples, meshes, assembles, orders and factors; reports each stage before it starts.
pub fn prepare(
    polygon: &SimplePolygon,
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    prepare_within(Memory::default(), Unprepared::Outline { polygon, settings }, progress)
}

/// As [`prepare`], for an outline whose curve is known and, with [`KernelMode::Integral`], used: samples lie on it, and
/// harmonic measure is that of its inside. `near` are points from which harmonic measure will be taken.
pub fn prepare_curve(
    (polygon, curve): (&SimplePolygon, &Curve),
    near: &[DVec2],
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    prepare_within(Memory::default(), Unprepared::Curve { polygon, curve, near, settings }, progress)
}

/// As [`prepare_curve`] without the integral equation, which the side can be [given](PreparedSide::with_equation)
/// afterwards: until then harmonic measure is that of finite elements, on samples that lie on the curve.
/// [`PreparedSide::awaits_equation`] says whether there will be one.
pub fn prepare_on_curve(
    (polygon, curve): (&SimplePolygon, &Curve),
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    let unprepared = Unprepared::Curve { polygon, curve, near: &[], settings };
    finite_elements(Memory::default(), unprepared, progress).map(|(side, _)| side)
}

/// As [`prepare`], for a surface (section 4.3): its edges are flipped to the intrinsic Delaunay triangulation if
/// requested; the other stages are the same.
pub fn prepare_surface(
    surface: SurfaceMesh,
    settings: SurfaceSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    prepare_within(Memory::default(), Unprepared::Surface { surface, settings }, progress)
}

/// As [`prepare`] and [`prepare_surface`], within a memory limit. If the factor does not fit, the iterative
/// solver is used (see [`PreparedSide::solver_kind`]); a table that does not fit is an error.
pub fn prepare_within(
    memory: Memory,
    unprepared: Unprepared<'_>,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    let (side, boundary) = finite_elements(memory, unprepared, progress)?;
    let Some((boundary, near)) = boundary else { return Ok(side) };
    progress(Stage::Integral);
    let mut timings = side.timings();
    let equation = timed(&mut timings.integral, || BoundaryEquation::of(boundary, &near));
    Ok(side.with_equation(equation).with_timings(timings))
}

/// A curve with the samples on it, and the interior points to resolve.
type Unfactored = (CurveBoundary, Vec<DVec2>);

/// Prepares without the integral equation; with what that is to be made from, if it was requested and fits.
fn finite_elements(
    memory: Memory,
    unprepared: Unprepared<'_>,
    progress: &mut dyn FnMut(Stage),
) -> Result<(PreparedSide, Option<Unfactored>), PrepareError> {
    let mut timings = PrepareTimings::default();
    let (mut sharpness, mut unfactored) = (Sharpness::FiniteElements, None);
    let (geometry, laplacian, kernel, solver) = match unprepared {
        Unprepared::Outline { polygon, settings } | Unprepared::Curve { polygon, settings, .. } => {
            let (curve, near) = match unprepared {
                Unprepared::Curve { curve, near, .. } => (Some(curve), near),
                _ => (None, [].as_slice()),
            };
            let domain = if settings.kernel == KernelMode::Integral {
                let outlined = Outlined { polygon, curve };
                let (domain, boundary) = outlined.domain(settings, &mut timings, progress)?;
                sharpness =
                    boundary.as_ref().map_or_else(|reason| Sharpness::Stays(reason.clone()), |_| Sharpness::Awaited);
                unfactored = boundary.ok().map(|boundary| (boundary, outlined.near(near)));
                domain
            } else {
                MeshedDomain::new(polygon, settings, &mut timings, progress)?
            };
            progress(Stage::Assemble);
            let laplacian = timed(&mut timings.assemble, || DirichletLaplacian::assemble(domain.mesh()))?;
            (SideGeometry::Plane(Arc::new(domain)), laplacian, settings.kernel, settings.solver)
        }
        Unprepared::Surface { settings, .. } if settings.kernel == KernelMode::Integral => {
            return Err(PrepareError::IntegralOfSurface);
        }
        Unprepared::Surface { surface, settings } => {
            progress(Stage::Mesh);
            let flip = || MeshedSurface::flipped(surface, settings.intrinsic_delaunay);
            let (surface, intrinsic) = timed(&mut timings.mesh, flip);
            progress(Stage::Assemble);
            let laplacian = timed(&mut timings.assemble, || DirichletLaplacian::assemble_intrinsic(&intrinsic))?;
            (SideGeometry::Space(Arc::new(surface)), laplacian, settings.kernel, settings.solver)
        }
    };
    let side = factored(geometry, laplacian, Solving { kernel, solver, memory }, timings, progress)?;
    Ok((side.with_sharpness(sharpness), unfactored))
}

/// Meshes a domain with other samples of its boundary, then as [`prepare`].
pub(super) fn prepare_meshed(
    resampled: &Resampled,
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    let mut timings = PrepareTimings::default();
    progress(Stage::Mesh);
    let domain = MeshedDomain::resampled(resampled, settings.sizing, &mut timings)?;
    progress(Stage::Assemble);
    let laplacian = timed(&mut timings.assemble, || DirichletLaplacian::assemble(domain.mesh()))?;
    let solving = Solving { kernel: KernelMode::Adjoint, solver: settings.solver, memory: Memory::default() };
    factored(SideGeometry::Plane(Arc::new(domain)), laplacian, solving, timings, progress)
}

/// How to solve, and within which memory.
struct Solving {
    kernel: KernelMode,
    solver: SolverKind,
    memory: Memory,
}

/// Orders and factors, and makes the table if there is to be one.
fn factored(
    geometry: SideGeometry,
    laplacian: DirichletLaplacian,
    Solving { kernel, solver, memory }: Solving,
    mut timings: PrepareTimings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    let (n, m) = (geometry.interior_count(), geometry.boundary_count());
    if kernel == KernelMode::Table {
        HarmonicTable::check(n, m, memory)?;
    }
    let solver = solver_for(&laplacian, solver, memory, &mut timings, progress)?;
    let mut table = None;
    if kernel == KernelMode::Table {
        let mut tell = |percent| progress(Stage::Table { percent });
        let coordinates = || HarmonicTable::new(&solver, laplacian.coupling(), &mut tell);
        table = Some(timed(&mut timings.table, coordinates)?);
    }
    Ok(PreparedSide::new(geometry, DirichletSystem::new(laplacian.into_coupling(), solver, table), timings))
}

/// The requested solver, or the iterative one if the direct one does not fit.
fn solver_for(
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

pub(super) fn timed<T>(milliseconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *milliseconds = start.elapsed().as_secs_f64() * 1e3;
    result
}

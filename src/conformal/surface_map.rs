//! The conformal parameterization of a surface: kernels → measures → matching → extension.
//!
//! The parameter domain is the planar source, the surface the target, mapped backward
//! with the harmonic extension (section 4.3): every vertex of the surface gets its place
//! in the parameter domain, its texture coordinate. As in [`super::ConformalMap`], an update recomputes only
//! what a change touches, and can be interrupted.

use super::distortion::resolution;
use super::half::{Change, Half, on_boundary};
use super::measured::{Measured, Renewal};
use super::stage::{Stage, Staged};
use super::surface::{advance_surface_kernel, begin_surface_kernel};
use super::{
    BoundaryCorrespondence, Constraints, ExtensionScratch, FrameTimings, HarmonicMeasure, KernelScratch, MapError,
    PreparedDomain, PreparedSurface, Quality, Side, TriangleDistortion, match_measures, surface_distortions,
};
use crate::counted::counted;
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
use crate::mesh::BarycentricPoint;
use crate::surface::ADDED;
use std::sync::Arc;
use web_time::Instant;

/// `f(x₁) = x₂`, `f(y₁) = y₂` with x₂ and y₂ on the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceConstraints {
    /// `x₁`, inside the parameter domain.
    pub source_point: DVec2,
    /// `y₁`, as a fraction of the arc length of its outline.
    pub source_anchor: f64,
    /// `x₂`, inside the surface.
    pub surface_point: BarycentricPoint,
    /// `y₂`, as a fraction of the length of the boundary loop.
    pub surface_anchor: f64,
}

impl SurfaceConstraints {
    /// The planar side's, twice.
    fn planar(&self) -> Constraints {
        let (point, anchor) = (self.source_point, self.source_anchor);
        Constraints { source_point: point, target_point: point, source_anchor: anchor, target_anchor: anchor }
    }
}

/// Why there is no parameterization.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SurfaceMapError {
    /// The planar side's constraints.
    #[error(transparent)]
    Planar(#[from] MapError),
    /// No such triangle, or weights that are negative or do not sum to 1.
    #[error("{}", counted!(
        *triangles,
        "({}, {}, {}) in triangle {triangle} is no point of the surface, which has 1 triangle",
        "({}, {}, {}) in triangle {triangle} is no point of the surface, which has {triangles} triangles",
        weights[0],
        weights[1],
        weights[2]
    ))]
    NoPoint {
        /// Which triangle.
        triangle: u32,
        /// The weights of its corners.
        weights: [f64; 3],
        /// How many triangles there are.
        triangles: usize,
    },
    /// The interior point lies on the boundary, where harmonic measure is a point mass.
    #[error("the surface point lies on the boundary of the surface; it must be inside")]
    OnBoundary,
    /// The surface's anchor is not a number.
    #[error("the surface anchor is not a finite fraction of the length of the boundary loop")]
    AnchorNotFinite,
    /// The surface's iterative solver did not converge.
    #[error("surface: {0}")]
    NotConverged(#[from] NotConverged),
}

/// What is to be known of a parameterization: boundary edges whose images are points, as far as f64 tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SurfaceMapNote {
    /// They have no harmonic measure.
    #[error("{}", counted!(
        *edges,
        "the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one",
        "the ends of {edges} boundary edges fall together: no inner way leads there from the surface point, or too long \
         a one"
    ))]
    NoMeasure {
        /// How many.
        edges: usize,
    },
    /// They have no harmonic measure, or the kernel has negative values, and the order of the boundary is lost.
    #[error("{}", counted!(
        *edges,
        "the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one, \
         or the kernel is negative there, as it may be without intrinsic Delaunay flips",
        "the ends of {edges} boundary edges fall together: no inner way leads there from the surface point, or too long \
         a one, or the kernel is negative there, as it may be without intrinsic Delaunay flips"
    ))]
    NegativeKernel {
        /// How many.
        edges: usize,
    },
}

/// How far from 1 the weights of a point may sum.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// The conformal map from a surface to a planar domain under the current constraints.
#[derive(Debug)]
pub struct SurfaceMap {
    source: Half,
    surface: Arc<PreparedSurface>,
    point: Option<BarycentricPoint>,
    anchor: f64,
    measured: Measured,
    correspondence: BoundaryCorrespondence,
    images: Vec<DVec2>,
    timings: FrameTimings,
    /// The update that is under way.
    run: Option<Run>,
    /// What it has matched.
    coming: BoundaryCorrespondence,
    kernel_scratch: KernelScratch,
    extension_scratch: ExtensionScratch,
}

/// An update that is under way.
#[derive(Debug)]
pub(super) struct Run {
    constraints: SurfaceConstraints,
    planar: Constraints,
    change: Change,
    /// Of the surface.
    renewal: Renewal,
    stage: Stage,
    timings: FrameTimings,
}

impl SurfaceMap {
    /// The map under `constraints`.
    pub fn new(
        source: Arc<PreparedDomain>,
        surface: Arc<PreparedSurface>,
        constraints: &SurfaceConstraints,
    ) -> Result<Self, SurfaceMapError> {
        let mut map = Self::unmapped(source, surface);
        map.update(constraints)?;
        Ok(map)
    }

    /// No map yet: it has no images before its first [`Self::advance`] has come to its end.
    pub fn unmapped(source: Arc<PreparedDomain>, surface: Arc<PreparedSurface>) -> Self {
        Self {
            source: Half::new(source),
            surface,
            point: None,
            anchor: f64::NAN,
            measured: Measured::default(),
            correspondence: BoundaryCorrespondence::default(),
            images: Vec::new(),
            timings: FrameTimings::default(),
            run: None,
            coming: BoundaryCorrespondence::default(),
            kernel_scratch: KernelScratch::default(),
            extension_scratch: ExtensionScratch::default(),
        }
    }

    /// Recomputes what the change of constraints touches. After an error the map is unchanged.
    pub fn update(&mut self, constraints: &SurfaceConstraints) -> Result<(), SurfaceMapError> {
        self.advance(constraints, Deadline::NEVER).map(|_| ())
    }

    /// Goes on with [`Self::update`] until it is done (true) or `deadline` is over; as [`super::ConformalMap::advance`].
    pub fn advance(&mut self, constraints: &SurfaceConstraints, deadline: Deadline) -> Result<bool, SurfaceMapError> {
        let same = self.run.take().filter(|run| run.constraints == *constraints);
        let run = if same.is_some() { same } else { self.begin(constraints)? };
        let Some(mut run) = run else { return Ok(true) };
        let is_done = self.go_on(&mut run, deadline)?;
        if is_done {
            self.commit(&run);
        } else {
            self.run = Some(run);
        }
        Ok(is_done)
    }

    /// Checks and plans an update; `None` if it changes nothing.
    fn begin(&mut self, constraints: &SurfaceConstraints) -> Result<Option<Run>, SurfaceMapError> {
        let planar = constraints.planar();
        let change = self.source.plan(Side::Source, &planar)?;
        self.check(constraints)?;
        let kernel = self.point != Some(constraints.surface_point);
        let renewal = Renewal { kernel, measure: kernel || self.anchor != constraints.surface_anchor };
        if !change.renewal().measure && !renewal.measure {
            return Ok(None);
        }
        let (constraints, timings) = (*constraints, FrameTimings::default());
        let mut run = Run { constraints, planar, change, renewal, stage: Stage::FIRST, timings };
        self.begin_stage(&mut run);
        Ok(Some(run))
    }

    fn begin_extension(&mut self, run: &mut Run) {
        let start = Instant::now();
        let mapped = self.measured.coming_measure(run.renewal);
        match_measures(mapped, self.source.measured.coming_measure(run.change.renewal()), &mut self.coming);
        run.timings.matching += start.elapsed().as_secs_f64() * 1e3;
        let start = Instant::now();
        let boundary = self.coming.images(&self.source.domain.samples);
        self.surface.system().begin_extension(boundary, &mut self.extension_scratch);
        run.stage.add_time(&mut run.timings, start);
    }

    /// Shows what an update has come to; its images are there already.
    fn commit(&mut self, run: &Run) {
        self.source.commit(Side::Source, &run.planar, &run.change);
        self.measured.commit(run.renewal);
        std::mem::swap(&mut self.correspondence, &mut self.coming);
        (self.point, self.anchor) = (Some(run.constraints.surface_point), run.constraints.surface_anchor);
        self.timings = run.timings;
    }

    fn check(&self, constraints: &SurfaceConstraints) -> Result<(), SurfaceMapError> {
        let (BarycentricPoint { triangle, weights }, mesh) = (constraints.surface_point, &self.surface.surface.mesh);
        let sum: f64 = weights.iter().sum();
        let sound = weights.iter().all(|&w| w >= 0.0) && (sum - 1.0).abs() <= WEIGHT_TOLERANCE;
        if !sound || triangle as usize >= mesh.triangles.len() {
            return Err(SurfaceMapError::NoPoint { triangle, weights, triangles: mesh.triangles.len() });
        }
        if on_boundary(mesh, constraints.surface_point) {
            return Err(SurfaceMapError::OnBoundary);
        }
        if constraints.surface_anchor.is_finite() { Ok(()) } else { Err(SurfaceMapError::AnchorNotFinite) }
    }

    /// The parameter domain.
    pub fn source(&self) -> &Arc<PreparedDomain> {
        &self.source.domain
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<PreparedSurface> {
        &self.surface
    }

    /// The images of the surface's vertices in the parameter domain, in the order of its mesh.
    pub fn images(&self) -> &[DVec2] {
        &self.images
    }

    /// The images in the order of the surface as it was read; `None` for vertices that a repair has dropped.
    pub fn texture_coordinates(&self) -> Vec<Option<DVec2>> {
        let surface = &self.surface.surface;
        let number = |origin| surface.number_of(origin).map(|number| self.images[number as usize]);
        (0..surface.origin_count() as u32).map(number).collect()
    }

    /// The Poisson kernel ψ of the surface's interior point, per boundary vertex.
    pub fn kernel(&self) -> &[f64] {
        &self.measured.kernel
    }

    /// The harmonic measure of the surface's boundary, from its anchor.
    pub fn measure(&self) -> &HarmonicMeasure {
        &self.measured.measure
    }

    /// What is to be known of the map under the current constraints. Cost O(m).
    pub fn note(&self) -> Option<SurfaceMapNote> {
        let edges = self.collapsed_edges();
        let is_negative = self.kernel().iter().any(|&psi| psi < 0.0);
        let note =
            if is_negative { SurfaceMapNote::NegativeKernel { edges } } else { SurfaceMapNote::NoMeasure { edges } };
        (edges > 0).then_some(note)
    }

    /// How many boundary edges have ends whose images cannot be told apart.
    fn collapsed_edges(&self) -> usize {
        let boundary = &self.images[..self.correspondence.points.len().min(self.images.len())];
        let (next, smallest) = (boundary.iter().cycle().skip(1), resolution(boundary));
        boundary.iter().zip(next).filter(|(p, q)| p.distance(**q) <= smallest).count()
    }

    /// The harmonic measure of the parameter domain, from its anchor.
    pub fn source_measure(&self) -> &HarmonicMeasure {
        &self.source.measured.measure
    }

    /// The Poisson kernel of the parameter domain's interior point, per boundary vertex.
    pub fn source_kernel(&self) -> &[f64] {
        &self.source.measured.kernel
    }

    /// Where the boundary vertices of the surface go.
    pub fn correspondence(&self) -> &BoundaryCorrespondence {
        &self.correspondence
    }

    /// What the last update took.
    pub fn timings(&self) -> FrameTimings {
        self.timings
    }

    /// The distortion of every triangle that was not added by a repair, in the order of the mesh. Cost O(n).
    pub fn distortions(&self) -> Vec<TriangleDistortion> {
        let mut all = Vec::new();
        surface_distortions(&self.surface.surface.mesh, &self.images, &mut all);
        self.given(&all).copied().collect()
    }

    /// Of a value for each triangle of the mesh, those of triangles that no repair has added.
    pub fn given<'a, T>(&'a self, values: &'a [T]) -> impl Iterator<Item = &'a T> {
        let origins = &self.surface.surface.triangle_origins;
        values.iter().zip(origins).filter(|(_, origin)| **origin != ADDED).map(|(value, _)| value)
    }

    /// Angle distortion and flips of [`Self::distortions`]; shapes are those of the given triangles, not of the flipped ones.
    pub fn quality(&self) -> Quality {
        Quality::summary(&self.distortions())
    }
}

impl Staged for SurfaceMap {
    type Run = Run;
    type Error = SurfaceMapError;

    fn progress(run: &mut Run) -> (&mut Stage, &mut FrameTimings) {
        (&mut run.stage, &mut run.timings)
    }

    fn begin_stage(&mut self, run: &mut Run) {
        let start = Instant::now();
        match run.stage {
            Stage::Kernel(Side::Source) => self.source.begin(&run.change, &mut self.kernel_scratch),
            Stage::Kernel(Side::Target) if run.renewal.kernel => {
                begin_surface_kernel(&self.surface, run.constraints.surface_point, &mut self.kernel_scratch);
            }
            Stage::Kernel(Side::Target) => {}
            Stage::Extension => return self.begin_extension(run),
        }
        run.stage.add_time(&mut run.timings, start);
    }

    fn advance_stage(&mut self, run: &Run, deadline: Deadline) -> Result<bool, SurfaceMapError> {
        let Run { constraints, planar, change, renewal, .. } = run;
        match run.stage {
            Stage::Kernel(Side::Source) => {
                Ok(self.source.advance(Side::Source, planar, change, &mut self.kernel_scratch, deadline)?)
            }
            Stage::Kernel(Side::Target) => {
                let (surface, scratch) = (&self.surface, &mut self.kernel_scratch);
                let (point, coming) = (constraints.surface_point, &mut self.measured.coming_kernel);
                if renewal.kernel && !advance_surface_kernel(surface, point, scratch, coming, deadline)? {
                    return Ok(false);
                }
                if renewal.measure {
                    let anchor = surface.at_fraction(constraints.surface_anchor);
                    self.measured.set_measure(&surface.edge_lengths, anchor, *renewal);
                }
                Ok(true)
            }
            Stage::Extension => {
                let system = self.surface.system();
                Ok(system.advance_extension(&mut self.extension_scratch, &mut self.images, deadline)?)
            }
        }
    }
}

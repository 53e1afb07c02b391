//! The conformal parameterization of a surface: kernels → measures → matching → extension.
//!
//! The parameter domain is the planar source, the surface the target, mapped backward
//! with the harmonic extension (section 4.3): every vertex of the surface gets its place
//! in the parameter domain, its texture coordinate. As in [`super::ConformalMap`], an update recomputes only
//! what a change touches.

use super::half::{Half, on_boundary};
use super::{
    BoundaryCorrespondence, Constraints, FrameTimings, HarmonicMeasure, KernelScratch, MapError, PreparedDomain,
    PreparedSurface, Quality, Side, TriangleDistortion, match_measures, surface_distortions, surface_kernel,
};
use crate::geometry::DVec2;
use crate::laplace::{Lanes, NotConverged};
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
    #[error("({}, {}, {}) in triangle {triangle} is no point of the surface, which has {triangles} triangles",
        .weights[0], .weights[1], .weights[2])]
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

/// How far from 1 the weights of a point may sum.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// The conformal map from a surface to a planar domain under the current constraints.
#[derive(Debug)]
pub struct SurfaceMap {
    source: Half,
    surface: Arc<PreparedSurface>,
    point: Option<BarycentricPoint>,
    anchor: f64,
    kernel: Vec<f64>,
    measure: HarmonicMeasure,
    correspondence: BoundaryCorrespondence,
    images: Vec<DVec2>,
    /// Whether `images` are those of the constraints: not after a solver's error.
    is_complete: bool,
    timings: FrameTimings,
    kernel_scratch: KernelScratch,
    extension_scratch: Vec<Lanes<2>>,
}

impl SurfaceMap {
    /// The map under `constraints`.
    pub fn new(
        source: Arc<PreparedDomain>,
        surface: Arc<PreparedSurface>,
        constraints: &SurfaceConstraints,
    ) -> Result<Self, SurfaceMapError> {
        let mut map = Self {
            source: Half::new(source),
            surface,
            point: None,
            anchor: f64::NAN,
            kernel: Vec::new(),
            measure: HarmonicMeasure::default(),
            correspondence: BoundaryCorrespondence::default(),
            images: Vec::new(),
            is_complete: false,
            timings: FrameTimings::default(),
            kernel_scratch: KernelScratch::default(),
            extension_scratch: Vec::new(),
        };
        map.update(constraints)?;
        Ok(map)
    }

    /// Recomputes what the change of constraints touches. After an error the map is
    /// unchanged (after one of a solver, what the solve would have given is not).
    pub fn update(&mut self, constraints: &SurfaceConstraints) -> Result<(), SurfaceMapError> {
        let planar = constraints.planar();
        let change = self.source.plan(Side::Source, &planar)?;
        self.check(constraints)?;
        let moved = self.point != Some(constraints.surface_point);
        let anchored = self.anchor != constraints.surface_anchor;
        if !(change.is_some() || moved || anchored) && self.is_complete {
            return Ok(());
        }
        self.is_complete = false;
        let mut timings = FrameTimings::default();
        let start = Instant::now();
        self.source.apply(Side::Source, &planar, &change, &mut self.kernel_scratch)?;
        if moved {
            // only a kernel that is complete may be taken for that of its point
            self.point = None;
            surface_kernel(&self.surface, constraints.surface_point, &mut self.kernel_scratch, &mut self.kernel)?;
            self.point = Some(constraints.surface_point);
        }
        if moved || anchored {
            self.anchor = constraints.surface_anchor;
            self.measure.set_along(&self.surface.edge_lengths, &self.kernel, self.surface.at_fraction(self.anchor));
        }
        timings.kernel = start.elapsed().as_secs_f64() * 1e3;
        self.extend(&mut timings)?;
        self.is_complete = true;
        self.timings = timings;
        Ok(())
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

    fn extend(&mut self, timings: &mut FrameTimings) -> Result<(), SurfaceMapError> {
        let start = Instant::now();
        match_measures(&self.measure, &self.source.measure, &mut self.correspondence);
        timings.matching = start.elapsed().as_secs_f64() * 1e3;
        let start = Instant::now();
        self.images.clear();
        self.images.extend(self.correspondence.images(&self.source.domain.samples));
        self.images.resize(self.surface.surface.mesh.vertices.len(), DVec2::ZERO);
        self.surface.system().extend(&mut self.images, &mut self.extension_scratch)?;
        timings.extend = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
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
        &self.kernel
    }

    /// The harmonic measure of the surface's boundary, from its anchor.
    pub fn measure(&self) -> &HarmonicMeasure {
        &self.measure
    }

    /// The harmonic measure of the parameter domain, from its anchor.
    pub fn source_measure(&self) -> &HarmonicMeasure {
        &self.source.measure
    }

    /// The Poisson kernel of the parameter domain's interior point, per boundary vertex.
    pub fn source_kernel(&self) -> &[f64] {
        &self.source.kernel
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

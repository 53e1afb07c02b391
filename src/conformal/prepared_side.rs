//! All data of one side of a map that do not depend on the constraints.
//!
//! A side is a planar domain or a surface in space. Both are disks with a boundary whose edges have
//! lengths, and a factored Laplacian; they differ in how a point becomes weights of vertices and in the positions of
//! the vertices.

use super::curved::{BoundaryEquation, CurveBoundary, Unsharpened};
use super::map_side::on_boundary;
use super::system::DirichletSystem;
use super::{HarmonicTable, InteriorPoint, MeshedDomain, MeshedSurface, Places, PrepareTimings};
use crate::boundary_integral::BoundaryIntegral;
use crate::geometry::{DVec2, DVec3};
use crate::laplace::SolverKind;
use crate::mesh::locate;
use crate::outline::BoundaryPoint;
use std::sync::Arc;

/// The geometry of a side, with the positions of its vertices.
#[derive(Debug, Clone)]
pub enum SideGeometry {
    /// In the plane.
    Plane(Arc<MeshedDomain>),
    /// In space.
    Space(Arc<MeshedSurface>),
}

/// A planar domain or a surface, meshed, assembled and factored.
///
/// The unknowns of the system are the mesh's interior vertices, its boundary values belong to the `m` boundary
/// vertices.
#[derive(Debug, Clone)]
pub struct PreparedSide {
    geometry: SideGeometry,
    pub(super) system: Arc<DirichletSystem>,
    timings: PrepareTimings,
    sharpness: Sharpness,
}

/// Whether harmonic measure is that of the boundary's integral equation.
#[derive(Debug, Clone)]
pub(super) enum Sharpness {
    /// Finite elements were requested.
    FiniteElements,
    /// The samples lie on the curve, and the side is still to be given the factored equation.
    Awaited,
    /// The equation was requested, and there is none.
    Stays(Unsharpened),
    /// Harmonic measure is that of the equation.
    Integral(BoundaryEquation),
}

impl SideGeometry {
    /// The number of boundary vertices, `m`.
    pub fn boundary_count(&self) -> usize {
        match self {
            Self::Plane(domain) => domain.mesh().boundary_count() as usize,
            Self::Space(surface) => surface.mesh().boundary_count() as usize,
        }
    }

    /// The number of all vertices, `m + n`.
    pub fn vertex_count(&self) -> usize {
        match self {
            Self::Plane(domain) => domain.mesh().vertices().len(),
            Self::Space(surface) => surface.mesh().vertices().len(),
        }
    }

    /// The number of interior vertices, `n`.
    pub fn interior_count(&self) -> usize {
        self.vertex_count() - self.boundary_count()
    }

    /// The triangles of the mesh: counter-clockwise vertex triples.
    pub fn triangles(&self) -> &[[u32; 3]] {
        match self {
            Self::Plane(domain) => domain.mesh().triangles(),
            Self::Space(surface) => surface.mesh().triangles(),
        }
    }
}

impl PreparedSide {
    /// Combines the parts.
    pub(super) fn new(geometry: SideGeometry, system: DirichletSystem, timings: PrepareTimings) -> Self {
        Self { geometry, system: Arc::new(system), timings, sharpness: Sharpness::FiniteElements }
    }

    /// The same side with another kernel.
    pub(super) fn with_sharpness(self, sharpness: Sharpness) -> Self {
        Self { sharpness, ..self }
    }

    /// The same side with other timings.
    pub(super) fn with_timings(self, timings: PrepareTimings) -> Self {
        Self { timings, ..self }
    }

    /// Whether harmonic measure is that of the boundary's integral equation.
    #[cfg(feature = "io")]
    pub(super) fn sharpness(&self) -> &Sharpness {
        &self.sharpness
    }

    /// The same side with the integral equation of `coarse`, whose samples are among this side's; these lie at `places`
    /// of them.
    pub(super) fn with_curve_of(self, coarse: &Self, places: &[BoundaryPoint]) -> Self {
        let sharpness = match &coarse.sharpness {
            Sharpness::Integral(equation) => Sharpness::Integral(equation.resampled(places)),
            other => other.clone(),
        };
        self.with_sharpness(sharpness)
    }

    /// The same side with the factored equation of its boundary, or the reason why there is none; mesh and system are
    /// shared. An equation whose samples are not the side's is refused.
    #[must_use]
    pub fn with_equation(&self, equation: Result<BoundaryEquation, Unsharpened>) -> Self {
        let fits = |equation: &BoundaryEquation| self.domain().is_some_and(|domain| equation.is_of(domain));
        let sharpness = match equation {
            Ok(equation) if fits(&equation) => Sharpness::Integral(equation),
            // one for another interior point, which that point only costs digits
            Ok(_) | Err(_) if self.equation().is_some() => return self.clone(),
            Ok(_) => Sharpness::Stays(Unsharpened::Apart),
            Err(reason) => Sharpness::Stays(reason),
        };
        self.clone().with_sharpness(sharpness)
    }

    /// Whether the boundary integral was requested, and the side is still to be [given](Self::with_equation) its equation.
    pub fn awaits_equation(&self) -> bool {
        matches!(self.sharpness, Sharpness::Awaited)
    }

    /// The boundary's integral equation; `None` if harmonic measure is from finite elements.
    pub fn equation(&self) -> Option<&BoundaryEquation> {
        if let Sharpness::Integral(equation) = &self.sharpness { Some(equation) } else { None }
    }

    /// The boundary as a curve; `None` if harmonic measure is from finite elements.
    pub fn curve_boundary(&self) -> Option<&Arc<CurveBoundary>> {
        self.equation().map(BoundaryEquation::boundary)
    }

    /// The factored integral equation; `None` if harmonic measure is from finite elements.
    pub fn boundary_integral(&self) -> Option<&BoundaryIntegral> {
        self.equation().map(BoundaryEquation::integral)
    }

    /// Why harmonic measure is from finite elements although the boundary integral was requested.
    pub fn unsharpened(&self) -> Option<&Unsharpened> {
        if let Sharpness::Stays(reason) = &self.sharpness { Some(reason) } else { None }
    }

    /// The side's geometry.
    pub fn geometry(&self) -> &SideGeometry {
        &self.geometry
    }

    /// The planar domain; `None` for a surface.
    pub fn domain(&self) -> Option<&Arc<MeshedDomain>> {
        match &self.geometry {
            SideGeometry::Plane(domain) => Some(domain),
            SideGeometry::Space(_) => None,
        }
    }

    /// The surface; `None` for a planar domain.
    pub fn surface(&self) -> Option<&Arc<MeshedSurface>> {
        match &self.geometry {
            SideGeometry::Plane(_) => None,
            SideGeometry::Space(surface) => Some(surface),
        }
    }

    /// Whether the side is a surface.
    pub fn is_surface(&self) -> bool {
        self.surface().is_some()
    }

    /// The lengths of the boundary edges, `m` of them.
    pub fn edge_lengths(&self) -> &[f64] {
        match &self.geometry {
            SideGeometry::Plane(domain) => domain.samples().edge_lengths(),
            SideGeometry::Space(surface) => surface.edge_lengths(),
        }
    }

    /// The position of each boundary vertex as a fraction of the boundary's length from the first one, ascending from
    /// 0.
    pub fn fractions(&self) -> &[f64] {
        match &self.geometry {
            SideGeometry::Plane(domain) => domain.samples().fractions(),
            SideGeometry::Space(surface) => surface.fractions(),
        }
    }

    /// The boundary point at fraction `s` of the boundary's length (taken modulo 1).
    pub fn at_fraction(&self, s: f64) -> BoundaryPoint {
        BoundaryPoint::at_fraction(self.fractions(), s)
    }

    /// The inverse of [`Self::at_fraction`].
    pub fn fraction_at(&self, point: BoundaryPoint) -> f64 {
        point.fraction_in(self.fractions())
    }

    /// The number of boundary vertices, `m`.
    pub fn boundary_count(&self) -> usize {
        self.geometry.boundary_count()
    }

    /// The number of interior vertices, `n`.
    pub fn interior_count(&self) -> usize {
        self.geometry.interior_count()
    }

    /// The number of all vertices, `m + n`.
    pub fn vertex_count(&self) -> usize {
        self.geometry.vertex_count()
    }

    /// The triangles of the mesh: counter-clockwise vertex triples.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.geometry.triangles()
    }

    /// The positions of the vertices, the boundary's first.
    pub fn vertices(&self) -> Places<'_> {
        match &self.geometry {
            SideGeometry::Plane(domain) => Places::Plane(domain.mesh().vertices()),
            SideGeometry::Space(surface) => Places::Space(surface.mesh().vertices()),
        }
    }

    /// Whether the interior point of a map may be at `x` in the plane: inside of the curve, or of the mesh of a polygon.
    pub fn contains(&self, x: DVec2) -> bool {
        if let Some(boundary) = self.curve_boundary() {
            return boundary.curve().contains(x);
        }
        let Some(mesh) = self.domain().filter(|_| x.is_finite()).map(|domain| domain.mesh()) else { return false };
        locate(mesh, x, None).is_some_and(|found| !on_boundary(mesh, found))
    }

    /// The position of a boundary point in space; the plane lies at z = 0.
    pub fn boundary_place(&self, point: BoundaryPoint) -> DVec3 {
        match &self.geometry {
            SideGeometry::Plane(domain) => domain.samples().position(point).extend(0.0),
            SideGeometry::Space(surface) => surface.boundary_position(point),
        }
    }

    /// The default interior point: the pole of inaccessibility of a domain, the
    /// vertex of a surface farthest from its boundary.
    pub fn default_point(&self) -> InteriorPoint {
        match &self.geometry {
            SideGeometry::Plane(domain) => domain.default_point().into(),
            SideGeometry::Space(surface) => surface.centre().into(),
        }
    }

    /// How the side's Dirichlet problem is solved.
    pub fn solver_kind(&self) -> SolverKind {
        self.system.solver.kind()
    }

    /// The harmonic coordinates of all interior vertices, if they are stored.
    pub fn table(&self) -> Option<&HarmonicTable> {
        self.system.table.as_ref()
    }

    /// The duration of the preparation; for a surface, `mesh` covers the flips and the default point.
    pub fn timings(&self) -> PrepareTimings {
        self.timings
    }
}

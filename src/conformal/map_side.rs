//! One side of a map: its interior point, kernel, anchor and measure, recomputed as far as a change requires.
//!
//! A change is planned (which checks the constraints), begun, advanced and, together with the map's
//! whole update, committed; until then all accessors return the previous state.

use super::kernel::{KernelScratch, advance_kernel, begin_kernel};
use super::measured::{Measured, Renewal};
use super::subdivision::Cuts;
use super::{Constraints, HarmonicMeasure, InteriorPoint, MapError, MeshedDomain, PreparedSide, Side, SideGeometry};
use crate::boundary_integral::BoundaryIntegralError;
use crate::geometry::{DVec2, DVec3};
use crate::laplace::Deadline;
use crate::mesh::{BarycentricPoint, TriMesh, TriangleId, locate};
use std::sync::Arc;

/// The largest accepted deviation from 1 of the sum of a point's weights.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// The distance from the mesh's boundary, in its shortest edges, at which the finite-element measure of a point between
/// mesh and curve is taken.
const INSET: f64 = 0.1;

/// One side of a map.
#[derive(Debug)]
pub(super) struct MapSide {
    pub prepared: Arc<PreparedSide>,
    point: Option<InteriorPoint>,
    pub located: BarycentricPoint,
    anchor: f64,
    pub measured: Measured,
}

/// What a change of constraints makes necessary on one side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    pub located: Option<BarycentricPoint>,
    pub re_anchor: bool,
}

impl Change {
    /// What has to be recomputed.
    pub fn renewal(&self) -> Renewal {
        Renewal { kernel: self.located.is_some(), measure: self.located.is_some() || self.re_anchor }
    }
}

impl MapSide {
    pub fn new(prepared: Arc<PreparedSide>) -> Self {
        let located = BarycentricPoint::new(TriangleId::new(0), [1.0, 0.0, 0.0]);
        Self { prepared, point: None, located, anchor: f64::NAN, measured: Measured::default() }
    }

    /// The same side with the same constraints, without an update in progress.
    pub fn copied(&self) -> Self {
        Self {
            prepared: Arc::clone(&self.prepared),
            measured: Measured::known(self.measured.kernel.clone(), self.measured.measure.clone()),
            ..*self
        }
    }

    /// The side `known` on another mesh of the same domain, with its kernel and measure.
    pub fn with_measure(
        prepared: Arc<PreparedSide>,
        side: Side,
        known: &Self,
        kernel: Vec<f64>,
        measure: HarmonicMeasure,
    ) -> Result<Self, MapError> {
        let mut refined = Self { measured: Measured::known(kernel, measure), ..Self::new(prepared) };
        if let (Some(InteriorPoint::Plane(x)), SideGeometry::Plane(domain)) = (known.point, refined.prepared.geometry())
        {
            refined.located = refined.inside(side, domain, x)?;
        }
        (refined.point, refined.anchor) = (known.point, known.anchor);
        Ok(refined)
    }

    /// The side `finer` on the mesh of which its own is cut so often, with the measure at its vertices.
    pub fn on_own_mesh(
        own: &Arc<PreparedSide>,
        finer: &Self,
        (point, anchor): (InteriorPoint, f64),
        cuts: Cuts,
    ) -> Self {
        let m = own.boundary_count();
        let Measured { kernel, measure, .. } = &finer.measured;
        let Some(located) = point.on_surface() else { return finer.copied() };
        let kernel: Vec<f64> = (0..m).map(|k| kernel[cuts.vertex(k, m)]).collect();
        let from = cuts.coarser_on_boundary(measure.anchor());
        let measure = HarmonicMeasure::from_values(from, m, |k| kernel[k], |k| measure.at_vertex(cuts.vertex(k, m)));
        let measured = Measured::known(kernel, measure);
        Self { prepared: Arc::clone(own), point: Some(point), located, anchor, measured }
    }

    /// The interior point and the anchor of the last complete update; `None` before it.
    pub fn constraint(&self) -> Option<(InteriorPoint, f64)> {
        self.point.map(|point| (point, self.anchor))
    }

    /// Checks the constraints of this side and determines what they change; has no side effects.
    pub fn plan(&self, side: Side, constraints: &Constraints) -> Result<Change, MapError> {
        let (point, anchor) = (constraints.points[side], constraints.anchors[side]);
        let is_new = self.point != Some(point);
        let located = match (self.prepared.geometry(), point) {
            (SideGeometry::Plane(_), InteriorPoint::Plane(_)) if !anchor.is_finite() => {
                return Err(MapError::AnchorNotFinite { side });
            }
            (SideGeometry::Plane(domain), InteriorPoint::Plane(x)) if is_new => Some(self.inside(side, domain, x)?),
            (SideGeometry::Plane(_), InteriorPoint::Plane(_)) => None,
            (SideGeometry::Space(surface), InteriorPoint::Surface(point)) => {
                check(side, surface.mesh(), point)?;
                if !anchor.is_finite() {
                    return Err(MapError::LoopAnchorNotFinite { side });
                }
                is_new.then_some(point)
            }
            _ => return Err(MapError::OtherKind { side }),
        };
        Ok(Change { located, re_anchor: anchor != self.anchor })
    }

    /// Locates a point that must lie inside the domain; one inside of the curve that the mesh does not reach, at the
    /// nearest place of the mesh.
    fn inside(&self, side: Side, domain: &MeshedDomain, x: DVec2) -> Result<BarycentricPoint, MapError> {
        let found = if x.is_finite() { locate(domain.mesh(), x, Some(self.located.triangle())) } else { None };
        let inside = found.filter(|found| !on_boundary(domain.mesh(), *found));
        let Some(boundary) = self.prepared.curve_boundary() else {
            return inside.ok_or(MapError::PointOutside { side, x: x.x, y: x.y });
        };
        let outside = MapError::PointOutside { side, x: x.x, y: x.y };
        if !boundary.curve().contains(x) {
            return Err(outside);
        }
        let beside = || {
            let shortest = self.prepared.edge_lengths().iter().copied().fold(f64::INFINITY, f64::min);
            locate(domain.mesh(), domain.nearest_inside(x, INSET * shortest), None)
        };
        inside.or_else(beside).ok_or(outside)
    }

    /// Starts computing the kernel, if the change requires a new one.
    pub fn begin(&self, change: &Change, scratch: &mut KernelScratch) {
        if let Some(located) = change.located {
            begin_kernel(&self.prepared, located, scratch);
        }
    }

    /// Continues with kernel and measure as planned until they are complete (true) or `deadline` has passed.
    pub fn advance(
        &mut self,
        side: Side,
        constraints: &Constraints,
        change: &Change,
        scratch: &mut KernelScratch,
        deadline: Deadline,
    ) -> Result<bool, MapError> {
        if let Some(located) = change.located {
            let coming = &mut self.measured.coming_kernel;
            let is_there = advance_kernel(&self.prepared, located, scratch, coming, deadline);
            if !is_there.map_err(|error| MapError::NotConverged { side, error })? {
                return Ok(false);
            }
        }
        if let (Some(_), Some(equation), InteriorPoint::Plane(x)) =
            (change.located, self.prepared.equation(), constraints.points[side])
        {
            let swept = equation.harmonic_measure(x);
            let swept = swept.map_err(|error| match error {
                BoundaryIntegralError::NotInside { at } => MapError::PointOutside { side, x: at.x, y: at.y },
                error => MapError::BoundaryIntegral { side, error },
            })?;
            self.measured.coming_swept = Some(swept);
        }
        if change.renewal().measure {
            self.measured.set_measure(&self.prepared, constraints.anchors[side], change.renewal());
        }
        Ok(true)
    }

    /// Makes the planned results visible.
    pub fn commit(&mut self, side: Side, constraints: &Constraints, change: &Change) {
        self.measured.commit(change.renewal());
        (self.point, self.anchor) = (Some(constraints.points[side]), constraints.anchors[side]);
        self.located = change.located.unwrap_or(self.located);
    }
}

/// Checks that a point lies inside a surface.
fn check(side: Side, mesh: &TriMesh<DVec3>, point: BarycentricPoint) -> Result<(), MapError> {
    let (triangle, weights) = (point.triangle(), point.weights());
    let sum: f64 = weights.iter().sum();
    let sound = weights.iter().all(|&w| w >= 0.0) && (sum - 1.0).abs() <= WEIGHT_TOLERANCE;
    if !sound || triangle.index() >= mesh.triangles().len() {
        return Err(MapError::NoPoint { side, triangle, weights, triangles: mesh.triangles().len() });
    }
    if on_boundary(mesh, point) { Err(MapError::OnBoundary { side }) } else { Ok(()) }
}

/// Whether a located point lies on a boundary edge, where harmonic measure is a point mass.
pub(super) fn on_boundary<P>(mesh: &TriMesh<P>, point: BarycentricPoint) -> bool {
    let (triangle, weights) = (point.triangle(), point.weights());
    let corners = mesh.corners(triangle);
    let vertex = (0..3).any(|i| weights[i] == 1.0 && mesh.is_on_boundary(corners[i]));
    vertex || (0..3).any(|i| weights[i] == 0.0 && mesh.neighbour(triangle, i).is_none())
}

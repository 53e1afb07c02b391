//! One side of a map: its interior point, kernel, anchor and measure, renewed as far as a change asks.

use super::{Constraints, HarmonicMeasure, KernelScratch, MapError, PreparedDomain, Side, poisson_kernel};
use crate::geometry::DVec2;
use crate::mesh::{BarycentricPoint, NO_TRIANGLE, TriMesh, locate};
use std::sync::Arc;

/// One planar side of a map.
#[derive(Debug)]
pub(super) struct Half {
    pub domain: Arc<PreparedDomain>,
    pub point: DVec2,
    pub located: BarycentricPoint,
    pub anchor: f64,
    pub kernel: Vec<f64>,
    pub measure: HarmonicMeasure,
}

/// What a change of constraints asks of one side.
pub(super) struct Change {
    pub located: Option<BarycentricPoint>,
    pub re_anchor: bool,
}

impl Change {
    /// Whether anything changes.
    pub fn is_some(&self) -> bool {
        self.located.is_some() || self.re_anchor
    }
}

impl Half {
    pub fn new(domain: Arc<PreparedDomain>) -> Self {
        let located = BarycentricPoint { triangle: 0, weights: [1.0, 0.0, 0.0] };
        let (kernel, measure) = (Vec::new(), HarmonicMeasure::default());
        Self { domain, point: DVec2::NAN, located, anchor: f64::NAN, kernel, measure }
    }

    /// Checks the constraints of this side and finds what they change; changes nothing.
    pub fn plan(&self, side: Side, constraints: &Constraints) -> Result<Change, MapError> {
        let (x, anchor) = (constraints.point(side), constraints.anchor(side));
        if !anchor.is_finite() {
            return Err(MapError::AnchorNotFinite { side });
        }
        let re_anchor = anchor != self.anchor;
        if x == self.point {
            return Ok(Change { located: None, re_anchor });
        }
        let found = if x.is_finite() { locate(&self.domain.mesh, x, self.located.triangle) } else { None };
        let inside = found.filter(|found| !on_boundary(&self.domain.mesh, *found));
        let located = inside.ok_or(MapError::PointOutside { side, x: x.x, y: x.y })?;
        Ok(Change { located: Some(located), re_anchor })
    }

    /// Renews the kernel and the measure as planned.
    pub fn apply(
        &mut self,
        side: Side,
        constraints: &Constraints,
        change: &Change,
        scratch: &mut KernelScratch,
    ) -> Result<(), MapError> {
        if let Some(located) = change.located {
            // only a kernel that is complete may be taken for that of its point
            self.point = DVec2::NAN;
            poisson_kernel(&self.domain, located, scratch, &mut self.kernel)
                .map_err(|error| MapError::NotConverged { side, error })?;
            (self.located, self.point) = (located, constraints.point(side));
        }
        if change.is_some() {
            self.anchor = constraints.anchor(side);
            let anchor = self.domain.samples.at_fraction(self.anchor);
            self.measure.set(&self.domain.samples, &self.kernel, anchor);
        }
        Ok(())
    }
}

/// Whether a located point lies on a boundary edge, where harmonic measure is a point mass.
pub(super) fn on_boundary<P>(mesh: &TriMesh<P>, point: BarycentricPoint) -> bool {
    let corners = mesh.triangles[point.triangle as usize];
    let neighbours = mesh.neighbours[point.triangle as usize];
    let vertex = (0..3).any(|i| point.weights[i] == 1.0 && corners[i] < mesh.boundary_count);
    vertex || (0..3).any(|i| point.weights[i] == 0.0 && neighbours[i] == NO_TRIANGLE)
}

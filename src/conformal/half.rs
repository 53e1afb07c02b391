//! One side of a map: its interior point, kernel, anchor and measure, renewed as far as a change asks.
//!
//! A renewal is planned (which checks the constraints), begun, advanced and, with the map's
//! whole update, committed; until then all that is seen is what was there before.

use super::kernel::{advance_kernel, begin_kernel};
use super::measured::{Measured, Renewal};
use super::{Constraints, KernelScratch, MapError, PreparedDomain, Side};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use crate::mesh::{BarycentricPoint, NO_TRIANGLE, TriMesh, locate};
use std::sync::Arc;

/// One planar side of a map.
#[derive(Debug)]
pub(super) struct Half {
    pub domain: Arc<PreparedDomain>,
    pub point: DVec2,
    pub located: BarycentricPoint,
    pub anchor: f64,
    pub measured: Measured,
}

/// What a change of constraints asks of one side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    pub located: Option<BarycentricPoint>,
    pub re_anchor: bool,
}

impl Change {
    /// What becomes another one.
    pub fn renewal(&self) -> Renewal {
        Renewal { kernel: self.located.is_some(), measure: self.located.is_some() || self.re_anchor }
    }
}

impl Half {
    pub fn new(domain: Arc<PreparedDomain>) -> Self {
        let located = BarycentricPoint { triangle: 0, weights: [1.0, 0.0, 0.0] };
        Self { domain, point: DVec2::NAN, located, anchor: f64::NAN, measured: Measured::default() }
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

    /// Begins with the kernel, if another one is planned.
    pub fn begin(&self, change: &Change, scratch: &mut KernelScratch) {
        if let Some(located) = change.located {
            begin_kernel(&self.domain, located, scratch);
        }
    }

    /// Goes on with kernel and measure as planned until they are there (true) or `deadline` is over.
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
            let is_there = advance_kernel(&self.domain, located, scratch, coming, deadline);
            if !is_there.map_err(|error| MapError::NotConverged { side, error })? {
                return Ok(false);
            }
        }
        if change.renewal().measure {
            let samples = &self.domain.samples;
            let anchor = samples.at_fraction(constraints.anchor(side));
            self.measured.set_measure(&samples.edge_lengths, anchor, change.renewal());
        }
        Ok(true)
    }

    /// What was planned is there, and shown from now on.
    pub fn commit(&mut self, side: Side, constraints: &Constraints, change: &Change) {
        self.measured.commit(change.renewal());
        (self.point, self.anchor) = (constraints.point(side), constraints.anchor(side));
        self.located = change.located.unwrap_or(self.located);
    }
}

/// Whether a located point lies on a boundary edge, where harmonic measure is a point mass.
pub(super) fn on_boundary<P>(mesh: &TriMesh<P>, point: BarycentricPoint) -> bool {
    let corners = mesh.triangles[point.triangle as usize];
    let neighbours = mesh.neighbours[point.triangle as usize];
    let vertex = (0..3).any(|i| point.weights[i] == 1.0 && corners[i] < mesh.boundary_count);
    vertex || (0..3).any(|i| point.weights[i] == 0.0 && neighbours[i] == NO_TRIANGLE)
}

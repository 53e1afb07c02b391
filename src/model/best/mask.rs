//! The triangles of the source that lie in the painted region, for the picture.

use crate::conformal::{PreparedSide, Side, SideGeometry};
use crate::geometry::DVec3;
use crate::model::Model;
use crate::optimization::{Dab, Region};
use std::sync::{Arc, Weak};

/// A triangle belongs to the region if at least this share of it does.
const HALF: f64 = 0.5;

/// Which triangles belong to a region, and what that was computed for.
#[derive(Debug, Default)]
pub(super) struct Mask {
    side: Weak<PreparedSide>,
    region: Arc<Region>,
    triangles: Vec<bool>,
}

impl Mask {
    pub fn triangles(&self) -> &[bool] {
        &self.triangles
    }

    /// The region, if it is of these dabs.
    pub fn region(&self, dabs: &[Dab]) -> Option<&Arc<Region>> {
        Some(&self.region).filter(|region| region.dabs() == dabs)
    }

    fn new(side: &Arc<PreparedSide>, region: Arc<Region>) -> Self {
        let place = |v: u32| match side.geometry() {
            SideGeometry::Plane(domain) => domain.mesh().vertices()[v as usize].extend(0.0),
            SideGeometry::Space(surface) => surface.mesh().vertices()[v as usize],
        };
        let is_inside = |corners: &[u32; 3]| region.share(corners.map(place) as [DVec3; 3]) >= HALF;
        let triangles = side.triangles().iter().map(is_inside).collect();
        Self { side: Arc::downgrade(side), region, triangles }
    }
}

impl Model {
    /// The painted region, with the tree of its dabs: built once while it stays the same.
    pub(super) fn painted_region(&self) -> Arc<Region> {
        let dabs = self.session.region();
        self.best.mask.region(dabs).cloned().unwrap_or_else(|| Arc::new(Region::of_dabs(dabs.to_vec())))
    }

    /// Computes the mask anew if region or source have changed.
    pub(super) fn follow_region(&mut self) {
        let region = self.session.region();
        if region.is_empty() {
            self.best.mask = Mask::default();
            return;
        }
        let Some(side) = self.prepared(Side::Source) else { return };
        if self.best.mask.side.as_ptr() != Arc::as_ptr(side) || self.best.mask.region(region).is_none() {
            self.best.mask = Mask::new(side, self.painted_region());
        }
    }
}

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
    region: Vec<Dab>,
    triangles: Vec<bool>,
}

impl Mask {
    pub fn triangles(&self) -> &[bool] {
        &self.triangles
    }

    fn new(side: &Arc<PreparedSide>, region: &[Dab]) -> Self {
        let whole = Region::of_dabs(region.to_vec());
        let place = |v: u32| match side.geometry() {
            SideGeometry::Plane(domain) => domain.mesh().vertices()[v as usize].extend(0.0),
            SideGeometry::Space(surface) => surface.mesh().vertices()[v as usize],
        };
        let is_inside = |corners: &[u32; 3]| whole.share(corners.map(place) as [DVec3; 3]) >= HALF;
        let triangles = side.triangles().iter().map(is_inside);
        Self { side: Arc::downgrade(side), region: region.to_vec(), triangles: triangles.collect() }
    }
}

impl Model {
    /// Computes the mask anew if region or source have changed.
    pub(super) fn follow_region(&mut self) {
        let region = self.session.region();
        if region.is_empty() {
            self.best.mask = Mask::default();
            return;
        }
        let Some(side) = self.prepared(Side::Source) else { return };
        if self.best.mask.side.as_ptr() != Arc::as_ptr(side) || self.best.mask.region != region {
            self.best.mask = Mask::new(side, region);
        }
    }
}

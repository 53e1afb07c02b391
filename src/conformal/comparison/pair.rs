//! A side and the same side on a finer mesh: which places correspond.

use super::super::subdivision::Cuts;
use super::super::{InteriorPoint, PreparedSide};
use crate::mesh::VertexId;
use crate::outline::BoundaryPoint;

/// A side of the map and the same side on a finer mesh.
pub struct Pair<'a> {
    pub side: &'a PreparedSide,
    pub finer: &'a PreparedSide,
}

impl Pair<'_> {
    /// The number, in the finer mesh, of a vertex of the surface.
    fn number(&self, vertex: u32) -> Option<u32> {
        Some(self.finer.surface()?.surface().number_of(VertexId::new(vertex))?.index() as u32)
    }

    /// The fraction of the finer boundary at a point of the coarse one.
    pub fn fraction(&self, point: BoundaryPoint) -> Option<f64> {
        if self.side.surface().is_none() {
            return Some(self.side.fraction_at(point));
        }
        let start = self.finer.fractions()[self.number(point.edge())? as usize];
        let lengths = self.side.edge_lengths();
        let along = point.fraction() * lengths[point.edge() as usize] / lengths.iter().sum::<f64>();
        Some((start + along).rem_euclid(1.0))
    }
}

/// The interior point on a mesh whose triangles are cut into four.
pub fn point_on_finer(point: InteriorPoint) -> InteriorPoint {
    match point {
        InteriorPoint::Surface(point) => InteriorPoint::Surface(Cuts(1).finer(point)),
        plane @ InteriorPoint::Plane(_) => plane,
    }
}

//! A side and the same side on a finer mesh: which places correspond.

use super::super::{InteriorPoint, PreparedSide};
use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, TriangleId, VertexId};
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

    /// The interior point on the finer mesh.
    pub fn point(&self, point: InteriorPoint) -> Option<InteriorPoint> {
        let InteriorPoint::Surface(point) = point else { return Some(point) };
        let own = self.side.surface()?.mesh();
        let corners = own.triangles().get(point.triangle().index())?.map(|v| own.vertices()[v as usize]);
        let (corners, weights) = in_quarter(corners, point.weights());
        let finer = self.finer.surface()?.mesh();
        let found = finer.triangles().iter().enumerate().find_map(|(t, triangle)| {
            let place = |i: usize| finer.vertices()[triangle[i] as usize];
            let turn = (0..3).find(|&turn| (0..3).all(|i| place((i + turn) % 3) == corners[i]))?;
            let mut turned = [0.0; 3];
            (0..3).for_each(|i| turned[(i + turn) % 3] = weights[i]);
            Some(BarycentricPoint::new(TriangleId::new(t as u32), turned))
        });
        found.map(InteriorPoint::Surface)
    }
}

/// The quarter of a triangle that contains the point with these weights, and the point's weights there.
///
/// In the quarter at corner i, where λᵢ ≥ ½, the weights are 2λᵢ − 1 there and 2λ at the middles; in the middle one
/// 1 − 2λᵢ at the middle opposite to corner i.
fn in_quarter([a, b, c]: [DVec3; 3], w: [f64; 3]) -> ([DVec3; 3], [f64; 3]) {
    let middles = [b.midpoint(c), c.midpoint(a), a.midpoint(b)];
    match (0..3).find(|&i| w[i] >= 0.5) {
        Some(i) => {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            ([[a, b, c][i], middles[k], middles[j]], [2.0 * w[i] - 1.0, 2.0 * w[j], 2.0 * w[k]])
        }
        None => (middles, w.map(|w| 1.0 - 2.0 * w)),
    }
}

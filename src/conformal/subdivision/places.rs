//! Places of a mesh in the mesh with every triangle cut into four, some times over.
//!
//! Triangle t becomes the triangles 4t … 4t + 3: those at its corners, and the middle one. A boundary edge becomes two, so
//! that boundary vertex k is vertex 2k then; fractions of the boundary's length stay.

use crate::mesh::{BarycentricPoint, TriangleId};
use crate::outline::BoundaryPoint;

/// The part of a triangle that contains the point with these weights, and the weights there: part i at corner i, where
/// λᵢ ≥ ½, with its corners in the order of the triangle's and of the middles of the edges to them; part 3 between the
/// middles of ab, bc, ca.
fn in_part(w: [f64; 3]) -> (u32, [f64; 3]) {
    match (0..3).find(|&i| w[i] >= 0.5) {
        Some(i) => {
            let mut inside = w.map(|w| 2.0 * w);
            inside[i] -= 1.0;
            (i as u32, inside)
        }
        None => (3, [1.0 - 2.0 * w[2], 1.0 - 2.0 * w[0], 1.0 - 2.0 * w[1]]),
    }
}

/// The inverse of [`in_part`].
fn in_whole(part: u32, w: [f64; 3]) -> [f64; 3] {
    match part {
        3 => [0.5 * (w[0] + w[2]), 0.5 * (w[0] + w[1]), 0.5 * (w[1] + w[2])],
        corner => {
            let mut whole = w.map(|w| 0.5 * w);
            whole[corner as usize] += 0.5;
            whole
        }
    }
}

/// How often every triangle is cut into four.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cuts(pub u32);

impl Cuts {
    /// Own boundary vertices are every so many ones of the mesh that is cut.
    pub fn stride(self) -> usize {
        1 << self.0
    }

    /// The point of the surface in the mesh that is cut.
    pub fn finer(self, point: BarycentricPoint) -> BarycentricPoint {
        (0..self.0).fold(point, |point, _| {
            let (part, weights) = in_part(point.weights());
            BarycentricPoint::new(TriangleId::new(4 * point.triangle().number() + part), weights)
        })
    }

    /// The inverse of [`Self::finer`].
    pub fn coarser(self, point: BarycentricPoint) -> BarycentricPoint {
        (0..self.0).fold(point, |point, _| {
            let number = point.triangle().number();
            BarycentricPoint::new(TriangleId::new(number / 4), in_whole(number % 4, point.weights()))
        })
    }

    /// The number, in the mesh that is cut, of a vertex of a mesh with `boundary` boundary vertices.
    pub fn vertex(self, v: usize, boundary: usize) -> usize {
        if v < boundary { v << self.0 } else { (boundary << self.0) + v - boundary }
    }

    /// The boundary point in the mesh that is not cut.
    pub fn coarser_on_boundary(self, point: BoundaryPoint) -> BoundaryPoint {
        let pieces = 1 << self.0;
        let along = (f64::from(point.edge() % pieces) + point.fraction()) / f64::from(pieces);
        BoundaryPoint::new(point.edge() / pieces, along)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_found_again_and_lies_in_a_part() {
        let cuts = Cuts(3);
        for weights in [[0.2, 0.3, 0.5], [0.5, 0.5, 0.0], [0.0, 0.0, 1.0], [0.75, 0.125, 0.125], [0.3, 0.35, 0.35]] {
            let finer = cuts.finer(BarycentricPoint::new(TriangleId::new(7), weights));
            assert_eq!(finer.triangle().index() / 64, 7);
            assert!(finer.weights().iter().all(|&w| (-1e-15..=1.0 + 1e-15).contains(&w)), "{finer:?}");
            let back = cuts.coarser(finer);
            let off = back.weights().iter().zip(weights).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(back.triangle().index() == 7 && off < 1e-15, "{back:?}");
        }
    }

    #[test]
    fn boundary_points_keep_their_fraction_of_an_edge() {
        let point = Cuts(2).coarser_on_boundary(BoundaryPoint::new(4 * 5 + 3, 0.5));
        assert_eq!((point.edge(), point.fraction()), (5, 0.875));
        assert_eq!([Cuts(2).vertex(3, 10), Cuts(2).vertex(12, 10)], [12, 42]);
    }
}

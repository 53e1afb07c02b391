//! Folded parts of divided triangles made upright, where that can be done without changing the surface.
//!
//! At a reentrant corner C of the outline the third corner c of the triangle over the edge a b can be behind a C: that
//! part is clockwise. Then the edge c a, which is inside the surface, is divided too: its new vertex lies on it in space,
//! and in the plane in the kernel of the quadrangle a C c d, where d is the third corner of the triangle on the other
//! side. From a point of the kernel the whole quadrangle is seen, so that its four triangles are counter-clockwise. The
//! middle of a triangle with three corners on the boundary is moved into the kernel of the parts around it. Where the
//! kernel is empty the part stays folded. The surface in space stays the same.

use super::{AddedVertex, Divided, is_folded};
use crate::geometry::{DVec2, DVec3, orientation};
use crate::mesh::{TriMesh, VertexId};

/// The new vertex is at least this fraction of the edge in space away from its ends.
const LEAST_FRACTION: f64 = 0.01;

/// A divided mesh: images of all vertices, new vertices, triangles, and the parents of those beyond the mesh's own.
pub struct Parts<'a> {
    pub mesh: &'a TriMesh<DVec3>,
    pub images: Vec<DVec2>,
    pub added: Vec<AddedVertex>,
    pub triangles: Vec<[u32; 3]>,
    pub parents: Vec<u32>,
}

impl Parts<'_> {
    /// Makes folded parts of divided triangles upright; returns the number of those that stay folded.
    /// Cost O(n) for each of them.
    pub fn unfold(&mut self) -> usize {
        for k in self.folded() {
            // dividing an edge between two of them has made both upright
            let _ = !is_folded(self.corners(k)) || self.moves_middle(k) || self.divides_edge(k);
        }
        self.folded().len()
    }

    /// The parts that are clockwise in the plane.
    fn folded(&self) -> Vec<usize> {
        let own = self.mesh.triangles();
        let is_part = |k: &usize| own.get(*k).is_none_or(|whole| *whole != self.triangles[*k]);
        (0..self.triangles.len()).filter(is_part).filter(|&k| is_folded(self.corners(k))).collect()
    }

    fn corners(&self, k: usize) -> [DVec2; 3] {
        self.triangles[k].map(|v| self.images[v as usize])
    }

    /// Moves the last corner of part `k`, if it is the middle of a triangle, to where it sees all sides around it.
    fn moves_middle(&mut self, k: usize) -> bool {
        let middle = self.triangles[k][2] as usize;
        let is_middle = middle
            .checked_sub(self.mesh.vertices().len())
            .is_some_and(|new| matches!(self.added[new].divides, Divided::Triangle(_)));
        let around = || self.triangles.iter().filter(|part| part[2] as usize == middle);
        let sides: Vec<[DVec2; 2]> = around().map(|&[a, b, _]| [a, b].map(|v| self.images[v as usize])).collect();
        let Some(seen) = kernel_point(&sides).filter(|_| is_middle) else { return false };
        self.images[middle] = seen;
        true
    }

    /// Divides an edge of the mesh between part `k` and another triangle, if their quadrangle has a kernel.
    fn divides_edge(&mut self, k: usize) -> bool {
        (0..3).any(|side| {
            let [u, v, w] = [0, 1, 2].map(|i| self.triangles[k][(side + i) % 3]);
            let is_own = [u, v].iter().all(|&end| (end as usize) < self.mesh.vertices().len());
            let Some((other, d)) = is_own.then(|| self.behind([u, v])).flatten() else { return false };
            let ring = [w, u, d, v].map(|v| self.images[v as usize]);
            let sides = [0, 1, 2, 3].map(|i| [ring[i], ring[(i + 1) % 4]]);
            let Some(seen) = kernel_point(&sides) else { return false };
            let new = self.on_edge([u, v], seen);
            self.replace(k, [[w, u, new], [v, w, new]]);
            self.replace(other, [[u, d, new], [d, v, new]]);
            true
        })
    }

    /// The triangle with the edge from v to u, and its third corner.
    fn behind(&self, [u, v]: [u32; 2]) -> Option<(usize, u32)> {
        let third = |t: &[u32; 3]| (0..3).find(|&i| t[i] == v && t[(i + 1) % 3] == u).map(|i| t[(i + 2) % 3]);
        self.triangles.iter().enumerate().find_map(|(k, t)| Some((k, third(t)?)))
    }

    /// A new vertex on the edge with this image, its fraction that of the distances in the plane; returns its number.
    fn on_edge(&mut self, ends: [u32; 2], image: DVec2) -> u32 {
        let [from, to] = ends.map(|v| self.images[v as usize].distance(image));
        let fraction = (from / (from + to)).clamp(LEAST_FRACTION, 1.0 - LEAST_FRACTION);
        let [a, b] = ends.map(|v| self.mesh.vertices()[v as usize]);
        let divides = Divided::Edge { ends: ends.map(VertexId::new), fraction };
        self.added.push(AddedVertex { place: a.lerp(b, fraction), divides });
        self.images.push(image);
        (self.images.len() - 1) as u32
    }

    /// Replaces triangle `k` by two parts, the first in its place, the second at the end.
    fn replace(&mut self, k: usize, [first, second]: [[u32; 3]; 2]) {
        let own = self.mesh.triangles().len();
        self.parents.push(if k < own { k as u32 } else { self.parents[k - own] });
        self.triangles[k] = first;
        self.triangles.push(second);
    }
}

/// A point strictly to the left of all sides, in the middle of where such points are; `None` if there is none.
fn kernel_point(sides: &[[DVec2; 2]]) -> Option<DVec2> {
    let ends = || sides.iter().flatten();
    let low = ends().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = ends().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let mut kernel = vec![low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    for &side in sides {
        kernel = left_of(&kernel, side);
    }
    let middle = kernel.iter().sum::<DVec2>() / kernel.len() as f64;
    let sees_all = sides.iter().all(|&[a, b]| orientation(a, b, middle) > 0.0);
    (sees_all && !kernel.is_empty()).then_some(middle)
}

/// The part of a convex polygon to the left of the line from a to b.
fn left_of(polygon: &[DVec2], [a, b]: [DVec2; 2]) -> Vec<DVec2> {
    let height = |p: DVec2| (b - a).perp_dot(p - a);
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (&p, &q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (at, next) = (height(p), height(q));
        if at >= 0.0 {
            kept.push(p);
        }
        if (at < 0.0) != (next < 0.0) {
            kept.push(p.lerp(q, at / (at - next)));
        }
    }
    kept
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn sides(ring: &[[f64; 2]]) -> Vec<[DVec2; 2]> {
        let ring: Vec<DVec2> = ring.iter().copied().map(DVec2::from).collect();
        (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]).collect()
    }

    #[test]
    fn the_kernel_of_an_arrowhead_is_between_its_sides_and_a_crossed_ring_has_none() {
        let arrow = kernel_point(&sides(&[[0.0, 0.0], [2.0, 2.0], [0.0, 1.0], [-2.0, 2.0]])).unwrap();
        assert!(arrow.y > arrow.x.abs() && arrow.y < 1.0 - 0.5 * arrow.x.abs(), "{arrow}");
        assert_eq!(kernel_point(&sides(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]])), None);
        assert_eq!(kernel_point(&sides(&[[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]])), None, "clockwise");
    }
}

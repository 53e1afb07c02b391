//! The triangles of a surface without those that fill its holes, and the loops around these.
//!
//! A repaired surface with several boundary loops is a disk: one loop is its boundary, the others are filled. The filling
//! comes last among the triangles, so that the given ones are a prefix and keep their numbers.

use super::SurfaceMesh;
use super::edges::ends;
use super::survey::{chains, loop_length};
use crate::geometry::sort_by_number;

impl SurfaceMesh {
    /// The triangles that come from the surface as it was read, in its order.
    pub fn given_triangles(&self) -> &[[u32; 3]] {
        &self.mesh().triangles()[..self.given_count()]
    }

    /// Whether it has holes that were filled.
    pub fn has_holes(&self) -> bool {
        self.given_count() < self.mesh().triangles().len()
    }

    /// The boundary loops that were filled, as closed chains of the mesh's vertices in the direction of the given
    /// triangles, by falling length: the loops of the surface as repaired, in their order, without its outline. Cost O(n)
    /// for n triangles.
    pub fn holes(&self) -> Vec<Vec<u32>> {
        if !self.has_holes() {
            return Vec::new();
        }
        let (given, vertices) = (self.given_triangles(), self.mesh().vertices());
        let mut next = vec![None; vertices.len()];
        for (t, across) in (0..).zip(&self.mesh().neighbours()[..given.len()]) {
            // what is across the outline's edges is no triangle, and not in a hole
            let is_hole = |t: u32| (given.len()..self.mesh().triangles().len()).contains(&(t as usize));
            for half in (0..3).filter(|&i| is_hole(across[i as usize])).map(|i| 3 * t + i) {
                let [u, v] = ends(given, half);
                next[u as usize] = Some(v);
            }
        }
        let mut loops = chains(next);
        sort_by_number(&mut loops, |hole| -loop_length(vertices, hole));
        loops
    }

    /// The length of a closed chain of the mesh's vertices.
    pub fn loop_length(&self, vertices: &[u32]) -> f64 {
        loop_length(self.mesh().vertices(), vertices)
    }
}

//! The triangle mesh: boundary vertices first, counter-clockwise triangles, neighbours.

use crate::geometry::DVec2;

/// No neighbour: the edge is a boundary edge.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// A triangle mesh of a simply connected domain.
///
/// Vertices `0 … m−1` are the boundary, counter-clockwise and exactly the
/// samples; `m … m+n−1` are interior. There are `m + 2n − 2` triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct TriMesh<P = DVec2> {
    /// All vertices, boundary first.
    pub vertices: Vec<P>,
    /// `m`.
    pub boundary_count: u32,
    /// Counter-clockwise vertex triples.
    pub triangles: Vec<[u32; 3]>,
    /// `neighbours[t][i]` is the triangle across the edge opposite to corner `i`, or [`NO_TRIANGLE`].
    pub neighbours: Vec<[u32; 3]>,
}

impl<P> TriMesh<P> {
    /// The number of interior vertices, `n`.
    pub fn interior_count(&self) -> usize {
        self.vertices.len() - self.boundary_count as usize
    }
}

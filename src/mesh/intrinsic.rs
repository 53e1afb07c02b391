//! A triangulation given by its edge lengths alone.
//!
//! Its edges are shortest paths across the faces of a surface, so that it may have several
//! edges between the same two vertices, or an edge from a vertex to itself: triangles
//! are glued by half-edges, not by vertices. Half-edge `3t + i` is opposite to corner i of triangle t.

use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec3;

/// Marks a half-edge without a twin: a boundary edge.
pub(super) const NO_TWIN: u32 = u32::MAX;

/// A triangulation of a disk by edge lengths; vertices `0 … m−1` are the boundary.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct IntrinsicMesh {
    /// `m`.
    pub(super) boundary_count: u32,
    /// `m + n`.
    pub(super) vertex_count: usize,
    /// Counter-clockwise vertex triples; corners may coincide.
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) twins: Vec<[u32; 3]>,
    /// The lengths of the edges opposite to the corners.
    pub(super) lengths: Vec<[f64; 3]>,
    /// Twice the areas; stored because recomputing them from the lengths is less accurate.
    pub(super) double_areas: Vec<f64>,
    pub(super) delaunay: bool,
}

impl IntrinsicMesh {
    /// The triangulation whose edge lengths are those of a mesh in space. Cost O(n).
    pub fn of(mesh: &TriMesh<DVec3>) -> Self {
        let corners = |t: &[u32; 3]| t.map(|v| mesh.vertices[v as usize]);
        let lengths = mesh.triangles.iter().map(corners).map(|[a, b, c]| [b.distance(c), c.distance(a), a.distance(b)]);
        let areas = mesh.triangles.iter().map(corners).map(|[a, b, c]| (b - a).cross(c - a).length());
        Self {
            boundary_count: mesh.boundary_count,
            vertex_count: mesh.vertices.len(),
            triangles: mesh.triangles.clone(),
            twins: (0..mesh.triangles.len()).map(|t| [0, 1, 2].map(|i| twin(mesh, t, i))).collect(),
            lengths: lengths.collect(),
            double_areas: areas.collect(),
            delaunay: false,
        }
    }

    /// The number of boundary vertices, `m`; they come first.
    pub fn boundary_count(&self) -> u32 {
        self.boundary_count
    }

    /// The number of vertices, `m + n`.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Counter-clockwise vertex triples; corners may coincide.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Whether [`Self::make_delaunay`] finished: then no cotangent weight is negative beyond rounding.
    pub fn is_delaunay(&self) -> bool {
        self.delaunay
    }

    /// The triangle and corner across the edge opposite to corner `i`; `None` at the boundary.
    pub fn across(&self, triangle: usize, i: usize) -> Option<(usize, usize)> {
        let twin = self.twins[triangle][i] as usize;
        (twin != NO_TWIN as usize).then_some((twin / 3, twin % 3))
    }

    /// The cotangent of the angle at corner `i`: (b² + c² − a²) / 4A by the law of cosines.
    pub fn cotangent(&self, triangle: usize, i: usize) -> f64 {
        let [a, b, c] = [0, 1, 2].map(|k| self.lengths[triangle][(i + k) % 3]);
        // (b − c)² + 2bc − a², with (b − c)² − a² as a product
        let (small, large) = (b.min(c), b.max(c));
        (small * small + (large - a) * (large + a)) / (2.0 * self.double_areas[triangle])
    }

    /// The sum of the cotangents opposite to an inner edge, and the scale of its rounding; `None` at the boundary.
    pub(super) fn weight(&self, triangle: usize, i: usize) -> Option<(f64, f64)> {
        let (other, j) = self.across(triangle, i)?;
        let sum = self.cotangent(triangle, i) + self.cotangent(other, j);
        Some((sum, self.rounding_scale(triangle) + self.rounding_scale(other)))
    }

    /// (a² + b² + c²) / 4A: a cotangent is a difference of such terms, and is near 0 at a right angle.
    fn rounding_scale(&self, triangle: usize) -> f64 {
        self.lengths[triangle].iter().map(|length| length * length).sum::<f64>() / (2.0 * self.double_areas[triangle])
    }

    /// The area of the surface.
    #[cfg(test)]
    pub fn area(&self) -> f64 {
        0.5 * self.double_areas.iter().sum::<f64>()
    }

    /// Checks that twins are mutual, join the same vertices in opposite directions and have the
    /// same length, that areas are positive, and that the number of triangles is that of a disk. Cost O(n).
    #[cfg(test)]
    pub fn check_invariants(&self) -> bool {
        let ends = |t: usize, i: usize| [self.triangles[t][(i + 1) % 3], self.triangles[t][(i + 2) % 3]];
        let glued = |t: usize, i: usize| match self.across(t, i) {
            None => ends(t, i).iter().all(|&v| v < self.boundary_count),
            Some((s, j)) => {
                let [a, b] = ends(t, i);
                self.across(s, j) == Some((t, i)) && ends(s, j) == [b, a] && self.lengths[t][i] == self.lengths[s][j]
            }
        };
        let count = self.triangles.len();
        let euler = count + self.boundary_count as usize + 2 == 2 * self.vertex_count;
        euler && self.double_areas.iter().all(|&area| area > 0.0) && (0..count).all(|t| (0..3).all(|i| glued(t, i)))
    }
}

/// The half-edge across the edge opposite to corner `i`, or [`NO_TWIN`].
fn twin(mesh: &TriMesh<DVec3>, t: usize, i: usize) -> u32 {
    let other = mesh.neighbours[t][i];
    if other == NO_TRIANGLE {
        return NO_TWIN;
    }
    let (a, b) = (mesh.triangles[t][(i + 1) % 3], mesh.triangles[t][(i + 2) % 3]);
    let corners = mesh.triangles[other as usize];
    let j = (0..3).find(|&j| corners[(j + 1) % 3] == b && corners[(j + 2) % 3] == a);
    j.map_or(NO_TWIN, |j| 3 * other + j as u32)
}

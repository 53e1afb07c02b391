//! The triangle mesh: boundary vertices first, counter-clockwise triangles, neighbors.

use super::{TriangleId, VertexId};
use crate::geometry::{DVec2, orientation};

/// Marks a boundary edge in the neighbor arrays.
pub(crate) const NO_TRIANGLE: u32 = u32::MAX;

/// A triangle mesh of a simply connected domain.
///
/// Vertices `0 … m−1` are the boundary, counter-clockwise and exactly the samples; `m … m+n−1` are interior. Every
/// index in the arrays is in range, and m is at least 3. A domain or a surface that is a disk has `m + 2n − 2`
/// triangles: [`Self::check_invariants`].
#[derive(Debug, Clone, PartialEq)]
pub struct TriMesh<P = DVec2> {
    /// All vertices, boundary first.
    pub(super) vertices: Vec<P>,
    /// `m`.
    pub(super) boundary_count: u32,
    /// Counter-clockwise vertex triples.
    pub(super) triangles: Vec<[u32; 3]>,
    /// `neighbours[t][i]` is the triangle across the edge opposite to corner `i`, or [`NO_TRIANGLE`].
    pub(super) neighbours: Vec<[u32; 3]>,
}

impl<P> TriMesh<P> {
    /// From arrays whose indices are known to be in range; [`NO_TRIANGLE`] marks a boundary edge.
    pub(crate) fn known_sound(
        vertices: Vec<P>,
        boundary_count: u32,
        triangles: Vec<[u32; 3]>,
        neighbours: Vec<[u32; 3]>,
    ) -> Self {
        let mesh = Self { vertices, boundary_count, triangles, neighbours };
        debug_assert!(mesh.is_sound());
        mesh
    }

    /// Whether every index in the arrays is in range. Cost O(n).
    pub(crate) fn is_sound(&self) -> bool {
        (3..=self.vertices.len()).contains(&(self.boundary_count as usize))
            && self.triangles.len() == self.neighbours.len()
            && self.triangles.as_flattened().iter().all(|&v| (v as usize) < self.vertices.len())
            && self.neighbours.as_flattened().iter().all(|&t| t == NO_TRIANGLE || (t as usize) < self.triangles.len())
    }

    /// From arrays of unknown origin, such as a worker's message; `None` if an index is out of range. Cost O(n).
    #[cfg(feature = "io")]
    pub(crate) fn checked(
        vertices: Vec<P>,
        boundary_count: u32,
        triangles: Vec<[u32; 3]>,
        neighbours: Vec<[u32; 3]>,
    ) -> Option<Self> {
        Some(Self { vertices, boundary_count, triangles, neighbours }).filter(Self::is_sound)
    }

    /// All vertices, those of the boundary first.
    pub fn vertices(&self) -> &[P] {
        &self.vertices
    }

    /// The boundary's vertices, counter-clockwise.
    pub fn boundary(&self) -> &[P] {
        &self.vertices[..self.boundary_count as usize]
    }

    /// The number of boundary vertices, `m`.
    pub fn boundary_count(&self) -> u32 {
        self.boundary_count
    }

    /// The number of interior vertices, `n`.
    pub fn interior_count(&self) -> usize {
        self.vertices.len() - self.boundary_count as usize
    }

    /// Counter-clockwise triples of vertex numbers.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// As [`Self::triangles`].
    pub(crate) fn into_triangles(self) -> Vec<[u32; 3]> {
        self.triangles
    }

    /// For each triangle and corner the triangle across the opposite edge, or [`NO_TRIANGLE`].
    pub(crate) fn neighbours(&self) -> &[[u32; 3]] {
        &self.neighbours
    }

    /// The triangle across the edge of `triangle` opposite to its corner `i`; `None` at the boundary.
    pub fn neighbour(&self, triangle: TriangleId, i: usize) -> Option<TriangleId> {
        let across = self.neighbours[triangle.index()][i];
        (across != NO_TRIANGLE).then_some(TriangleId::new(across))
    }

    /// Whether the vertex is on the boundary.
    pub fn is_on_boundary(&self, vertex: VertexId) -> bool {
        vertex.number() < self.boundary_count
    }

    /// Whether the triangle has an edge on the boundary.
    pub fn is_at_boundary(&self, triangle: TriangleId) -> bool {
        self.neighbours[triangle.index()].contains(&NO_TRIANGLE)
    }

    /// The vertices at a triangle's corners.
    pub fn corners(&self, triangle: TriangleId) -> [VertexId; 3] {
        self.triangles[triangle.index()].map(VertexId::new)
    }
}

impl<P: Copy> TriMesh<P> {
    /// The positions of a triangle's corners.
    pub fn corner_places(&self, triangle: TriangleId) -> [P; 3] {
        self.triangles[triangle.index()].map(|v| self.vertices[v as usize])
    }
}

/// An invariant of [`TriMesh`] that does not hold, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BrokenInvariant {
    /// The number of triangles is not `m + 2n − 2`.
    #[error("{found} triangles where a disk has {expected}")]
    Euler {
        /// The number of triangles.
        found: usize,
        /// The expected number, `m + 2n − 2`.
        expected: usize,
    },
    /// A triangle is clockwise or has no area.
    #[error("triangle {0} is not counter-clockwise")]
    Orientation(TriangleId),
    /// The neighbor relation is not mutual at an edge of this triangle.
    #[error("triangle {0} and its neighbor do not share the edge that they claim to share")]
    Neighbour(TriangleId),
    /// A boundary edge `k → k+1` is in no triangle, or another edge has no neighbour.
    #[error("the triangles' open edges are not the boundary in order, at vertex {0}")]
    Boundary(VertexId),
    /// An interior vertex is in no triangle.
    #[error("vertex {0} is in no triangle")]
    Unused(VertexId),
    /// An interior edge has a negative cotangent weight.
    #[error("the edge of triangle {0} opposite to its corner {1} is not Delaunay")]
    Delaunay(TriangleId, u32),
}

impl TriMesh<DVec2> {
    /// Twice the triangle's signed area; the sign is exact.
    pub fn orientation(&self, triangle: [u32; 3]) -> f64 {
        let [a, b, c] = triangle.map(|v| self.vertices[v as usize]);
        orientation(a, b, c)
    }

    /// Checks everything that [`super::mesh_domain`] guarantees. Cost O(n).
    pub fn check_invariants(&self) -> Result<(), BrokenInvariant> {
        let m = self.boundary_count as usize;
        let expected = (m + 2 * self.interior_count()).saturating_sub(2);
        if self.triangles.len() != expected || self.neighbours.len() != expected {
            return Err(BrokenInvariant::Euler { found: self.triangles.len(), expected });
        }
        if let Some(t) = self.triangles.iter().position(|&t| self.orientation(t) <= 0.0) {
            return Err(BrokenInvariant::Orientation(TriangleId::new(t as u32)));
        }
        self.check_edges()?;
        let mut used = vec![false; self.vertices.len()];
        self.triangles.iter().flatten().for_each(|&v| used[v as usize] = true);
        used.iter().position(|used| !used).map_or(Ok(()), |v| Err(BrokenInvariant::Unused(VertexId::new(v as u32))))
    }

    /// Neighbors are mutual, edges without a neighbor are the boundary, all others are Delaunay.
    fn check_edges(&self) -> Result<(), BrokenInvariant> {
        let m = self.boundary_count;
        let mut open = vec![false; m as usize];
        for (t, (triangle, neighbours)) in self.triangles.iter().zip(&self.neighbours).enumerate() {
            let this = TriangleId::new(t as u32);
            for i in 0..3 {
                let (u, v) = (triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
                if neighbours[i] == NO_TRIANGLE {
                    if u >= m || v != (u + 1) % m || std::mem::replace(&mut open[u as usize], true) {
                        return Err(BrokenInvariant::Boundary(VertexId::new(u)));
                    }
                    continue;
                }
                let corner = self.corner_opposite(neighbours[i], v, u).ok_or(BrokenInvariant::Neighbour(this))?;
                if self.neighbours[neighbours[i] as usize][corner] != t as u32 {
                    return Err(BrokenInvariant::Neighbour(this));
                }
                let across = self.triangles[neighbours[i] as usize][corner];
                if self.cotangent(triangle[i], u, v) + self.cotangent(across, v, u) < -COTANGENT_TOLERANCE {
                    return Err(BrokenInvariant::Delaunay(this, i as u32));
                }
            }
        }
        open.iter().position(|open| !open).map_or(Ok(()), |u| Err(BrokenInvariant::Boundary(VertexId::new(u as u32))))
    }

    /// The corner of triangle `t` whose opposite edge runs from `u` to `v`.
    fn corner_opposite(&self, t: u32, u: u32, v: u32) -> Option<usize> {
        let triangle = self.triangles.get(t as usize)?;
        (0..3).find(|&i| triangle[(i + 1) % 3] == u && triangle[(i + 2) % 3] == v)
    }

    /// The cotangent of the angle at `apex` over the edge `uv`.
    fn cotangent(&self, apex: u32, u: u32, v: u32) -> f64 {
        let [p, a, b] = [apex, u, v].map(|v| self.vertices[v as usize]);
        (a - p).dot(b - p) / (a - p).perp_dot(b - p)
    }
}

/// A cotangent weight may be this far below zero by rounding: four cocircular points of
/// a triangle with an aspect ratio of 1e3 reach 1e-13, an edge that should be
/// flipped by a visible angle exceeds 1e-6.
const COTANGENT_TOLERANCE: f64 = 1e-9;

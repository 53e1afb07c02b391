//! A closed polygon by arc length.

use crate::geometry::DVec2;

/// The polygon's vertices with the arc length from the first one.
#[derive(Debug, Clone)]
pub(super) struct Arc<'a> {
    vertices: &'a [DVec2],
    /// `cumulative[k]` is the arc length at vertex `k`; one more entry than vertices.
    cumulative: Vec<f64>,
}

impl<'a> Arc<'a> {
    pub fn new(vertices: &'a [DVec2]) -> Self {
        let mut cumulative = Vec::with_capacity(vertices.len() + 1);
        let mut length = 0.0;
        cumulative.push(length);
        for (k, a) in vertices.iter().enumerate() {
            length += a.distance(vertices[(k + 1) % vertices.len()]);
            cumulative.push(length);
        }
        Self { vertices, cumulative }
    }

    pub fn length(&self) -> f64 {
        self.cumulative[self.vertices.len()]
    }

    pub fn vertices(&self) -> &'a [DVec2] {
        self.vertices
    }

    /// The arc length at vertex `k`.
    pub fn at_vertex(&self, k: usize) -> f64 {
        self.cumulative[k]
    }

    /// The edge that contains arc length `s`, for `0 ≤ s < length`.
    pub fn edge_at(&self, s: f64) -> usize {
        (self.cumulative.partition_point(|&c| c <= s).max(1) - 1).min(self.vertices.len() - 1)
    }

    /// The edge that contains arc length `s`, searched from `edge` on.
    pub fn advance(&self, mut edge: usize, s: f64) -> usize {
        while edge + 1 < self.vertices.len() && self.cumulative[edge + 1] <= s {
            edge += 1;
        }
        edge
    }

    /// The point at arc length `s`, for `0 ≤ s < length`; a vertex exactly where `s` is its arc length.
    pub fn point(&self, s: f64) -> DVec2 {
        self.point_on(self.edge_at(s), s)
    }

    /// The point at arc length `s` of edge `k`.
    pub fn point_on(&self, k: usize, s: f64) -> DVec2 {
        let (start, end) = (self.cumulative[k], self.cumulative[k + 1]);
        let t = if end > start { ((s - start) / (end - start)).clamp(0.0, 1.0) } else { 0.0 };
        self.vertices[k].lerp(self.vertices[(k + 1) % self.vertices.len()], t)
    }

    /// Whether the outline turns at vertex `k` by more than the angle (at most 90°) with this cosine.
    pub fn turns_beyond(&self, k: usize, cosine: f64) -> bool {
        let n = self.vertices.len();
        let (a, b, c) = (self.vertices[(k + n - 1) % n], self.vertices[k], self.vertices[(k + 1) % n]);
        let (before, after) = (b - a, c - b);
        let dot = before.dot(after);
        dot <= 0.0 || dot * dot < cosine * cosine * before.length_squared() * after.length_squared()
    }

    /// The vertices after the first one that turn beyond the angle with this cosine.
    pub fn sharp_vertices(&self, cosine: f64) -> Vec<usize> {
        (1..self.vertices.len()).filter(|&k| self.turns_beyond(k, cosine)).collect()
    }
}

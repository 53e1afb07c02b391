//! Simple polygons, validated once: a [`SimplePolygon`] is finite, free of
//! repeated points, of non-zero area, not self-crossing and counter-clockwise.

use glam::DVec2;

/// The largest number of points that an outline may have.
pub const MAX_POINTS: usize = 200_000;

/// Why a list of points is not a simple polygon, and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PolygonError {
    /// Fewer than three points.
    #[error("an outline needs at least 3 points; this one has {count}")]
    TooFewPoints {
        /// How many there were.
        count: usize,
    },
}

/// A simple, counter-clockwise polygon `v_0 … v_{k-1}`; the edge `k` runs from `v_k` to `v_{k+1}`.
#[derive(Debug, Clone, PartialEq)]
pub struct SimplePolygon {
    vertices: Vec<DVec2>,
    was_clockwise: bool,
}

impl TryFrom<Vec<DVec2>> for SimplePolygon {
    type Error = PolygonError;

    fn try_from(vertices: Vec<DVec2>) -> Result<Self, PolygonError> {
        // skeleton: the checks are still to be written
        Ok(Self { vertices, was_clockwise: false })
    }
}

impl SimplePolygon {
    /// The vertices, counter-clockwise.
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// Whether the given points ran clockwise and were reversed (the first point stays first).
    pub fn was_clockwise(&self) -> bool {
        self.was_clockwise
    }

    /// The total length of the boundary.
    pub fn perimeter(&self) -> f64 {
        let v = &self.vertices;
        (0..v.len()).map(|k| v[k].distance(v[(k + 1) % v.len()])).sum()
    }

    /// The interior point farthest from the boundary, within `tolerance`
    /// (the pole of inaccessibility; quadtree search after Agafonkin's polylabel).
    pub fn pole_of_inaccessibility(&self, tolerance: f64) -> DVec2 {
        let _ = tolerance;
        self.vertices.iter().sum::<DVec2>() / self.vertices.len() as f64 // skeleton
    }
}

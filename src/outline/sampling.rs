//! Boundary samples: `m` points on an outline, uniform in arc length or adaptive.

use crate::geometry::{DVec2, SimplePolygon};

/// How the boundary is sampled.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// `count` points, equally spaced in arc length from the outline's first point (the paper's).
    Uniform {
        /// The number of samples, `m`.
        count: u32,
        /// Whether the outline's corners are samples too.
        keep_corners: bool,
    },
    /// Denser at corners, high curvature and narrow channels.
    Adaptive {
        /// The number of samples aimed at; `None` takes what the outline needs.
        target: Option<u32>,
    },
}

impl Default for Sampling {
    fn default() -> Self {
        Self::Adaptive { target: None }
    }
}

/// Why an outline cannot be sampled as asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SamplingError {
    /// Fewer than three samples were asked for.
    #[error("at least 3 boundary samples are needed, not {count}")]
    TooFew {
        /// The number asked for.
        count: u32,
    },
}

/// `m` boundary samples, counter-clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundarySamples {
    /// The points `v_k`, `k = 0 … m−1`.
    pub points: Vec<DVec2>,
    /// `e_k = |v_{k+1} − v_k|`, cyclic.
    pub edge_lengths: Vec<f64>,
    /// Where each sample lies on the outline: the fraction of the outline's arc
    /// length from its first point, strictly increasing in `[0, 1)`, starting at 0.
    pub fractions: Vec<f64>,
}

/// A point on the sampled boundary: `(1 − fraction) v_edge + fraction v_{edge+1}`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryPoint {
    /// The edge, `0 … m−1`.
    pub edge: u32,
    /// The position inside it, in `[0, 1)`.
    pub fraction: f64,
}

impl BoundarySamples {
    /// The number of samples, `m`.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are none (never so for samples made by [`sample`]).
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The point `p` of the sampled boundary.
    pub fn position(&self, p: BoundaryPoint) -> DVec2 {
        let k = p.edge as usize;
        self.points[k].lerp(self.points[(k + 1) % self.points.len()], p.fraction)
    }

    /// The point at fraction `s` of the outline's arc length (taken modulo 1).
    pub fn at_fraction(&self, s: f64) -> BoundaryPoint {
        let s = s.rem_euclid(1.0);
        let k = self.fractions.partition_point(|&t| t <= s).saturating_sub(1);
        let next = self.fractions.get(k + 1).copied().unwrap_or(1.0);
        let fraction = ((s - self.fractions[k]) / (next - self.fractions[k])).clamp(0.0, 1.0 - f64::EPSILON);
        BoundaryPoint { edge: k as u32, fraction }
    }

    /// The fraction of the outline's arc length at `p`, the inverse of [`Self::at_fraction`].
    pub fn fraction_at(&self, p: BoundaryPoint) -> f64 {
        let k = p.edge as usize;
        let next = self.fractions.get(k + 1).copied().unwrap_or(1.0);
        self.fractions[k] + p.fraction * (next - self.fractions[k])
    }

    /// The boundary point nearest to `x`. Cost O(m).
    pub fn nearest(&self, x: DVec2) -> BoundaryPoint {
        let m = self.points.len();
        let mut best = (f64::INFINITY, BoundaryPoint { edge: 0, fraction: 0.0 });
        for k in 0..m {
            let (a, d) = (self.points[k], self.points[(k + 1) % m] - self.points[k]);
            let t = ((x - a).dot(d) / d.length_squared()).clamp(0.0, 1.0 - f64::EPSILON);
            let distance = (a + t * d).distance_squared(x);
            if distance < best.0 {
                best = (distance, BoundaryPoint { edge: k as u32, fraction: t });
            }
        }
        best.1
    }
}

/// Samples the boundary of `polygon`. The first sample is the polygon's first vertex.
pub fn sample(polygon: &SimplePolygon, sampling: Sampling) -> Result<BoundarySamples, SamplingError> {
    // skeleton: uniform only
    let count = match sampling {
        Sampling::Uniform { count, .. } => count,
        Sampling::Adaptive { target } => target.unwrap_or(500),
    };
    let v = polygon.vertices();
    let mut cumulative = vec![0.0];
    for k in 0..v.len() {
        cumulative.push(cumulative[k] + v[k].distance(v[(k + 1) % v.len()]));
    }
    let total = cumulative[v.len()];
    let fractions: Vec<f64> = (0..count).map(|j| f64::from(j) / f64::from(count)).collect();
    let points: Vec<DVec2> = fractions
        .iter()
        .map(|&s| {
            let t = s * total;
            let k = cumulative.partition_point(|&c| c <= t).saturating_sub(1).min(v.len() - 1);
            v[k].lerp(v[(k + 1) % v.len()], (t - cumulative[k]) / (cumulative[k + 1] - cumulative[k]))
        })
        .collect();
    let m = points.len();
    let edge_lengths = (0..m).map(|k| points[k].distance(points[(k + 1) % m])).collect();
    Ok(BoundarySamples { points, edge_lengths, fractions })
}

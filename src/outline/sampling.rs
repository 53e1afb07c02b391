//! Boundary samples: `m` points on an outline, uniform in arc length or adaptive.

mod adaptive;
mod arc;
mod chords;
mod spacing;
mod uniform;
mod width;

use crate::geometry::{ChainPoint, DVec2, SimplePolygon, nearest_of_polygon};
use arc::Arc;

/// How the boundary is sampled.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Sampling {
    /// `count` points, equally spaced in arc length from the outline's first point (the paper's).
    Uniform {
        /// The number of samples, `m`.
        count: u32,
        /// Whether the outline's corners are samples as well.
        keep_corners: bool,
    },
    /// Denser at corners, high curvature and narrow channels.
    Adaptive {
        /// The target number of samples; `None` lets the outline's shape decide.
        target: Option<u32>,
    },
}

impl Default for Sampling {
    fn default() -> Self {
        Self::Adaptive { target: None }
    }
}

/// Why an outline cannot be sampled as requested.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SamplingError {
    /// Fewer than three samples were asked for.
    #[error("at least 3 boundary samples are needed, not {count}")]
    TooFew {
        /// The requested number.
        count: u32,
    },
    /// More than [`MAX_SAMPLES`] samples were asked for.
    #[error("at most {limit} boundary samples are possible, not {count}")]
    TooMany {
        /// The requested number.
        count: u32,
        /// The limit.
        limit: u32,
    },
    /// The outline has more corners than the requested number of samples.
    #[error("the outline has {corners} corners: {count} samples are too few to keep them")]
    MoreCornersThanSamples {
        /// Number of corners (counting the first vertex).
        corners: usize,
        /// The requested number.
        count: u32,
    },
}

/// `m ≥ 3` boundary samples, counter-clockwise, made by [`sample`].
///
/// Invariants ([`Self::check_invariants`]): no two neighbors are equal, the edge lengths are the
/// distances of neighbors, and the fractions increase strictly from 0 to below 1.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundarySamples {
    points: Vec<DVec2>,
    edge_lengths: Vec<f64>,
    fractions: Vec<f64>,
}

/// A point on the sampled boundary: `(1 − fraction) v_edge + fraction v_{edge+1}`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryPoint {
    edge: u32,
    fraction: f64,
}

/// Points closer to a sample than this, relative to the edge, are that sample: rounding moves a sample by up to
/// 1e-10 of the shortest edges (200,000 samples), a pointer by more than 1e-6.
const SNAP: f64 = 1e-9;

impl BoundarySamples {
    /// From points, the lengths of their edges and their fractions; `None` if an invariant does not hold. Cost O(m).
    #[cfg(any(feature = "io", test))]
    pub(crate) fn checked(points: Vec<DVec2>, edge_lengths: Vec<f64>, fractions: Vec<f64>) -> Option<Self> {
        Some(Self { points, edge_lengths, fractions }).filter(|samples| samples.check_invariants().is_ok())
    }

    /// Points of a curve in its order at these fractions of its length; `None` if an invariant does not hold.
    pub(crate) fn on_curve(points: Vec<DVec2>, fractions: Vec<f64>) -> Option<Self> {
        let edge_lengths = cyclic_distances(&points);
        Some(Self { points, edge_lengths, fractions }).filter(|samples| samples.check_invariants().is_ok())
    }

    /// At most `most` of the samples, at least 3, evenly spaced in the list, so that they stay denser where they were.
    #[must_use]
    pub fn thinned(&self, most: usize) -> Self {
        let (m, most) = (self.len(), most.max(3));
        if m <= most {
            return self.clone();
        }
        let kept: Vec<usize> = (0..most).map(|k| k * m / most).collect();
        let points: Vec<DVec2> = kept.iter().map(|&k| self.points[k]).collect();
        let edge_lengths = cyclic_distances(&points);
        Self { points, edge_lengths, fractions: kept.iter().map(|&k| self.fractions[k]).collect() }
    }

    /// The number of samples, `m`.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no samples (never the case for samples made by [`sample`]).
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The points `v_k`, `k = 0 … m−1`.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// `e_k = |v_{k+1} − v_k|`, cyclic.
    pub fn edge_lengths(&self) -> &[f64] {
        &self.edge_lengths
    }

    /// The position of each sample: its arc length along the outline from the first point, divided by the perimeter;
    /// strictly increasing in `[0, 1)`, starting at 0.
    pub fn fractions(&self) -> &[f64] {
        &self.fractions
    }

    /// The point `p` of the sampled boundary.
    pub fn position(&self, p: BoundaryPoint) -> DVec2 {
        let k = p.edge as usize;
        self.points[k].lerp(self.points[(k + 1) % self.points.len()], p.fraction)
    }

    /// The point at fraction `s` of the outline's arc length (taken modulo 1).
    ///
    /// A point within 1e-9 of an edge from a sample is that sample, so that
    /// `at_fraction(fraction_at(p))` finds a sample again in spite of rounding.
    pub fn at_fraction(&self, s: f64) -> BoundaryPoint {
        BoundaryPoint::at_fraction(&self.fractions, s)
    }

    /// The fraction of the outline's arc length at `p`, the inverse of [`Self::at_fraction`].
    pub fn fraction_at(&self, p: BoundaryPoint) -> f64 {
        p.fraction_in(&self.fractions)
    }

    /// The boundary point nearest to `x`; the first sample if `x` is not finite. Cost O(m).
    pub fn nearest(&self, x: DVec2) -> BoundaryPoint {
        BoundaryPoint::of_chain(nearest_of_polygon(&self.points, x), self.points.len())
    }
}

impl BoundaryPoint {
    /// The point at the part `fraction`, in `[0, 1)`, of edge `0 ≤ edge < m`: an edge's end is the next edge's start.
    pub const fn new(edge: u32, fraction: f64) -> Self {
        debug_assert!(0.0 <= fraction && fraction < 1.0);
        Self { edge, fraction }
    }

    /// The edge, `0 … m−1`.
    pub const fn edge(self) -> u32 {
        self.edge
    }

    /// The position on the edge, in `[0, 1)`.
    pub const fn fraction(self) -> f64 {
        self.fraction
    }

    /// The boundary point for a point of a closed chain of `m` points; the chain's first point for `None`.
    pub(crate) fn of_chain(point: Option<ChainPoint>, m: usize) -> Self {
        let (edge, fraction) = match point {
            Some(ChainPoint { edge, along: 1.0, .. }) => ((edge + 1) % m, 0.0),
            Some(ChainPoint { edge, along, .. }) => (edge, along),
            None => (0, 0.0),
        };
        Self { edge: edge as u32, fraction }
    }

    /// The point at fraction `s` of the length (taken modulo 1) of a closed chain whose vertices lie at `fractions`.
    pub(crate) fn at_fraction(fractions: &[f64], s: f64) -> Self {
        let s = s.rem_euclid(1.0);
        let k = fractions.partition_point(|&t| t <= s).saturating_sub(1);
        let next = fractions.get(k + 1).copied().unwrap_or(1.0);
        let fraction = (s - fractions[k]) / (next - fractions[k]);
        match fraction {
            f if f < SNAP => Self { edge: k as u32, fraction: 0.0 },
            f if f > 1.0 - SNAP => Self { edge: ((k + 1) % fractions.len()) as u32, fraction: 0.0 },
            fraction => Self { edge: k as u32, fraction },
        }
    }

    /// The inverse of [`Self::at_fraction`].
    pub(crate) fn fraction_in(self, fractions: &[f64]) -> f64 {
        let k = self.edge as usize;
        let next = fractions.get(k + 1).copied().unwrap_or(1.0);
        fractions[k] + self.fraction * (next - fractions[k])
    }
}

/// The largest number of samples.
pub const MAX_SAMPLES: u32 = 200_000;

/// Samples the boundary of `polygon`. The first sample is the polygon's first vertex.
///
/// All samples lie on the polygon. Cost O(polygon vertices + samples), times a
/// small constant for adaptive sampling.
pub fn sample(polygon: &SimplePolygon, sampling: Sampling) -> Result<BoundarySamples, SamplingError> {
    let arc = Arc::new(polygon.vertices());
    let positions = match sampling {
        Sampling::Uniform { count, keep_corners } => {
            check_count(count)?;
            if keep_corners { uniform::with_corners(&arc, count)? } else { uniform::equal(&arc, count) }
        }
        Sampling::Adaptive { target } => {
            target.map_or(Ok(()), check_count)?;
            adaptive::positions(&arc, target)
        }
    };
    Ok(BoundarySamples::at(&arc, &positions))
}

fn check_count(count: u32) -> Result<(), SamplingError> {
    match count {
        0..3 => Err(SamplingError::TooFew { count }),
        3..=MAX_SAMPLES => Ok(()),
        _ => Err(SamplingError::TooMany { count, limit: MAX_SAMPLES }),
    }
}

/// The distance of each point from the next one, of the last from the first.
fn cyclic_distances(points: &[DVec2]) -> Vec<f64> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, &q)| p.distance(q)).collect()
}

impl BoundarySamples {
    /// The samples at increasing arc lengths, the first of which is 0.
    fn at(arc: &Arc, positions: &[f64]) -> Self {
        let mut edge = 0;
        let mut place = |s: f64| {
            edge = arc.advance(edge, s);
            arc.point_on(edge, s)
        };
        let points: Vec<DVec2> = positions.iter().map(|&s| place(s)).collect();
        let edge_lengths = cyclic_distances(&points);
        let fractions = positions.iter().map(|s| s / arc.length()).collect();
        Self { points, edge_lengths, fractions }
    }

    /// Checks what [`sample`] guarantees: equal lengths of the arrays, fractions
    /// strictly increasing from 0 to below 1, edges of positive length.
    pub fn check_invariants(&self) -> Result<(), BrokenSamples> {
        let m = self.points.len();
        if m < 3 || self.edge_lengths.len() != m || self.fractions.len() != m {
            return Err(BrokenSamples::Lengths);
        }
        let increasing = self.fractions[0] == 0.0 && self.fractions[m - 1] < 1.0;
        if !increasing || self.fractions.windows(2).any(|w| w[0] >= w[1]) {
            return Err(BrokenSamples::Fractions);
        }
        let wrong = (0..m).find(|&k| {
            let length = self.points[k].distance(self.points[(k + 1) % m]);
            length <= 0.0 || length != self.edge_lengths[k]
        });
        wrong.map_or(Ok(()), |k| Err(BrokenSamples::Edge(k as u32)))
    }
}

/// An invariant of [`BoundarySamples`] that does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BrokenSamples {
    /// Fewer than three samples, or arrays of different lengths.
    #[error("there are fewer than 3 samples, or the arrays differ in length")]
    Lengths,
    /// The fractions do not increase from 0 to below 1.
    #[error("the fractions do not increase strictly from 0 to below 1")]
    Fractions,
    /// An edge length is not the distance of its ends, or is 0.
    #[error("the length of edge {0} is zero or not the distance of its ends")]
    Edge(u32),
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

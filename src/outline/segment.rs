//! The segments of a path as plain data: lines, elliptic arcs and cubic Bézier curves.

use serde::{Deserialize, Serialize};

use crate::geometry::{DVec2, Piece};
use std::f64::consts::TAU;

/// A segment of a path; its numbers are those of the [`Piece`] of the same name.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Segment {
    /// The straight line between two points.
    Line([DVec2; 2]),
    /// center + axes₀ cos θ + axes₁ sin θ, with θ from `from` to `to`.
    Arc {
        /// The center.
        center: DVec2,
        /// Two conjugate half axes.
        axes: [DVec2; 2],
        /// θ at the beginning, in radians.
        from: f64,
        /// θ at the end.
        to: f64,
    },
    /// The cubic Bézier curve with these control points.
    Cubic([DVec2; 4]),
}

/// The sweep of an arc that one Bézier curve stands for, in radians.
const ARC_PART: f64 = std::f64::consts::FRAC_PI_8;

/// The most that an arc sweeps, in radians: a whole turn, and what rounding adds.
const WHOLE_TURN: f64 = TAU * (1.0 + 1e-6);

impl From<Segment> for Piece {
    fn from(segment: Segment) -> Self {
        match segment {
            Segment::Line(ends) => Self::Line(ends),
            Segment::Arc { center, axes, from, to } => Self::Arc { center, axes, from, to },
            Segment::Cubic(control) => Self::Cubic(control),
        }
    }
}

impl Segment {
    /// Whether it has finite numbers and, as an arc, passes no point twice.
    pub fn is_single(&self) -> bool {
        match self {
            Self::Line(points) => points.iter().all(|p| p.is_finite()),
            Self::Cubic(points) => points.iter().all(|p| p.is_finite()),
            Self::Arc { center, axes: [a, b], from, to } => {
                [center, a, b].iter().all(|p| p.is_finite()) && from.is_finite() && (to - from).abs() <= WHOLE_TURN
            }
        }
    }

    /// Its first point.
    pub fn start(&self) -> DVec2 {
        match *self {
            Self::Line([a, _]) | Self::Cubic([a, ..]) => a,
            Self::Arc { .. } => Piece::from(*self).jet(0.0).position,
        }
    }

    /// Its last point.
    pub fn end(&self) -> DVec2 {
        match *self {
            Self::Line([_, b]) | Self::Cubic([.., b]) => b,
            Self::Arc { .. } => Piece::from(*self).jet(1.0).position,
        }
    }

    /// The direction at the beginning: of a Bézier curve that of its first handle that is not retracted, or of its chord;
    /// `None` without length.
    #[cfg(feature = "io")]
    pub(super) fn direction(&self) -> Option<DVec2> {
        let first = match *self {
            Self::Cubic([a, b, c, d]) if is_retracted(a, b, c, d) => {
                if c == a {
                    d - a
                } else {
                    c - a
                }
            }
            other => Piece::from(other).jet(0.0).first,
        };
        (first != DVec2::ZERO).then_some(first)
    }

    /// The pieces of its curve: one, or where a Bézier curve has a retracted handle, with which its parametrization stops
    /// and its curvature is infinite, several that get shorter towards that end.
    pub(super) fn pieces(&self) -> Vec<Piece> {
        let Self::Cubic([a, b, c, d]) = *self else { return vec![(*self).into()] };
        match (is_retracted(a, b, c, d), is_retracted(d, c, b, a)) {
            (false, false) => vec![Piece::Cubic([a, b, c, d])],
            (true, true) => vec![Piece::Line([a, d])],
            (true, false) => graded([a, b, c, d]).into_iter().map(Piece::Cubic).collect(),
            (false, true) => {
                graded([d, c, b, a]).into_iter().rev().map(|[a, b, c, d]| Piece::Cubic([d, c, b, a])).collect()
            }
        }
    }

    /// Bézier curves along the segment: of arcs to 1e-8 of their radius. At least four, but one for a line, so that parts
    /// that meet are neighbors or cross.
    pub(super) fn cubics(&self) -> Vec<[DVec2; 4]> {
        let piece = Piece::from(*self);
        let parts = match *self {
            Self::Line([a, b]) => return vec![[a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b]],
            Self::Cubic(_) => 4,
            Self::Arc { from, to, .. } => ((to - from).abs() / ARC_PART).ceil().max(4.0) as u32,
        };
        let handle = match *self {
            // a part of the sweep θ has handles of 4/3 tan(θ/4) radii
            Self::Arc { from, to, .. } => {
                let part = (to - from) / f64::from(parts);
                4.0 / 3.0 * (0.25 * part).tan() / (to - from)
            }
            _ => 1.0 / (3.0 * f64::from(parts)),
        };
        let at = |k: u32| piece.jet(f64::from(k) / f64::from(parts));
        let part = |k: u32| {
            let [a, d] = [at(k), at(k + 1)];
            [a.position, a.position + handle * a.first, d.position - handle * d.first, d.position]
        };
        (0..parts).map(part).collect()
    }

    /// The same points in the opposite direction.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Line([a, b]) => Self::Line([b, a]),
            Self::Arc { center, axes, from, to } => Self::Arc { center, axes, from: to, to: from },
            Self::Cubic([a, b, c, d]) => Self::Cubic([d, c, b, a]),
        }
    }
}

/// Handles shorter than this, in sizes of their curve, are retracted: drawings have them to single precision.
const RETRACTED: f64 = 1e-6;

/// Whether the handle of a curve's end `a`, to `b`, has no length.
fn is_retracted(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    a.distance(b) <= RETRACTED * a.distance(c).max(a.distance(d))
}

/// The number of times by which the parameter is quartered towards a retracted handle. The rest is as long as 4⁻⁸ = 2e-5
/// handles and deviates by 4⁻¹² = 6e-8 of them from a curve with a handle: an area of 1e-12.
const QUARTERS: usize = 4;

/// A curve whose first handle is retracted as curves of which the first one, a tiny one, has a handle in the same direction.
fn graded(curve: [DVec2; 4]) -> Vec<[DVec2; 4]> {
    let mut rest = curve;
    let mut parts = Vec::with_capacity(QUARTERS + 1);
    for _ in 0..QUARTERS {
        let [first, second] = divided(rest, 0.25);
        parts.push(second);
        rest = first;
    }
    let [a, _, c, d] = rest;
    let third = a.distance(d) / 3.0;
    let forwards = if c == a { d - a } else { c - a };
    parts.push([a, a + third * forwards.normalize_or_zero(), d - third * (d - c).normalize_or_zero(), d]);
    parts.reverse();
    parts
}

/// Both parts of a curve, by de Casteljau's algorithm.
fn divided([a, b, c, d]: [DVec2; 4], t: f64) -> [[DVec2; 4]; 2] {
    let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
    let (abc, bcd) = (ab.lerp(bc, t), bc.lerp(cd, t));
    let middle = abc.lerp(bcd, t);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

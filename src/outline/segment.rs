//! The segments of a path as plain data: lines, elliptic arcs and cubic Bézier curves.

use serde::{Deserialize, Serialize};

use crate::geometry::{DVec2, Piece};

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

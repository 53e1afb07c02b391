//! Smooth pieces of curves: straight lines, elliptic arcs, cubic Bézier curves, curves by formula, and parts of cubic
//! splines, which are not analytic at their knots.
//!
//! Every piece is a function of t in [0, 1] with its first two derivatives. [`Piece::from_start`] gives the
//! offset z(t) − z(0) in a form that does not cancel for small t, which the corners of an integral equation need.

use glam::DVec2;

use super::quadrature::integral;
use crate::geometry::Spline;
use std::sync::Arc;

/// A point of a curve and its derivatives by the parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// z(t).
    pub position: DVec2,
    /// z′(t).
    pub first: DVec2,
    /// z″(t).
    pub second: DVec2,
}

impl Jet {
    /// The signed curvature (z′ × z″)/|z′|³: positive where the curve turns left.
    pub fn curvature(&self) -> f64 {
        let speed = self.first.length();
        self.first.perp_dot(self.second) / (speed * speed * speed)
    }
}

/// A smooth curve over t in [0, 1] with z′ ≠ 0; it should be analytic, closed interval included, or a spline.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Piece {
    /// The straight line from the first point to the second.
    Line([DVec2; 2]),
    /// center + axes₀ cos θ + axes₁ sin θ, θ from `from` to `to` in radians; a circle if the axes are equally
    /// long and perpendicular.
    Arc {
        /// The center.
        center: DVec2,
        /// Two conjugate half axes.
        axes: [DVec2; 2],
        /// θ at t = 0.
        from: f64,
        /// θ at t = 1.
        to: f64,
    },
    /// The cubic Bézier curve with these control points.
    Cubic([DVec2; 4]),
    /// `function` of its own parameter s = from + (to − from) t; its derivatives are those by s.
    Formula {
        /// The curve and its derivatives by s.
        function: fn(f64) -> Jet,
        /// s at t = 0.
        from: f64,
        /// s at t = 1.
        to: f64,
    },
    /// The part of a spline between two of its knots, t in proportion to the spline's parameter.
    Spline {
        /// The spline.
        spline: Arc<Spline>,
        /// The knot at t = 0.
        from: usize,
        /// The knot at t = 1, another one; the part runs backwards if it is the earlier one.
        to: usize,
    },
}

/// Up to this t, the offset of a formula is the integral of z′; beyond it, the difference z(t) − z(0) loses at most
/// 6 bits.
const NEAR_START: f64 = 1.0 / 64.0;

impl Piece {
    /// A circular arc around `center`, from the angle `from` to the angle `to` in radians.
    pub fn circular(center: DVec2, radius: f64, from: f64, to: f64) -> Self {
        Self::Arc { center, axes: [DVec2::new(radius, 0.0), DVec2::new(0.0, radius)], from, to }
    }

    /// Position and derivatives at t.
    pub fn jet(&self, t: f64) -> Jet {
        match *self {
            Self::Formula { function, from, to } => scaled(function(from + (to - from) * t), to - from),
            Self::Arc { center, axes: [a, b], from, to } => {
                let sweep = to - from;
                let (sin, cos) = (from + sweep * t).sin_cos();
                let spoke = a * cos + b * sin;
                Jet { position: center + spoke, first: sweep * (b * cos - a * sin), second: -sweep * sweep * spoke }
            }
            Self::Line([a, _]) | Self::Cubic([a, ..]) => {
                let offset = self.from_start(t);
                Jet { position: a + offset.position, ..offset }
            }
            Self::Spline { ref spline, from, to } => spline.jet_between([from, to], t),
        }
    }

    /// z(t) − z(0) as the position, with relative accuracy for every t (beyond the first interval of a spline, that of
    /// a difference of positions), and the derivatives at t.
    pub fn from_start(&self, t: f64) -> Jet {
        match *self {
            Self::Line([a, b]) => Jet { position: t * (b - a), first: b - a, second: DVec2::ZERO },
            Self::Arc { axes: [a, b], from, to, .. } => {
                // cos θ − cos θ₀ = −2 sin m sin h and sin θ − sin θ₀ = 2 cos m sin h, m the mean, h half the difference
                let half = 0.5 * (to - from) * t;
                let (sin, cos) = (from + half).sin_cos();
                Jet { position: 2.0 * half.sin() * (b * cos - a * sin), ..self.jet(t) }
            }
            Self::Cubic([a, b, c, d]) => {
                let [one, two, three] = [3.0 * (b - a), 3.0 * ((c - b) - (b - a)), (d - a) - 3.0 * (c - b)];
                Jet {
                    position: t * (one + t * (two + t * three)),
                    first: one + t * (2.0 * two + 3.0 * t * three),
                    second: 2.0 * two + 6.0 * t * three,
                }
            }
            Self::Formula { .. } => {
                let here = self.jet(t);
                let position = if t <= NEAR_START {
                    integral(t, |s| self.jet(s).first)
                } else {
                    here.position - self.jet(0.0).position
                };
                Jet { position, ..here }
            }
            Self::Spline { ref spline, from, to } => spline.offset_between([from, to], t),
        }
    }

    /// z(1 − u) − z(1) as the position, with relative accuracy for every u, and the derivatives by t at 1 − u.
    pub fn from_end(&self, u: f64) -> Jet {
        let back = self.reversed().from_start(u);
        Jet { first: -back.first, ..back }
    }

    /// The same points in the opposite direction.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line([a, b]) => Self::Line([b, a]),
            Self::Arc { center, axes, from, to } => Self::Arc { center, axes, from: to, to: from },
            Self::Cubic([a, b, c, d]) => Self::Cubic([d, c, b, a]),
            Self::Formula { function, from, to } => Self::Formula { function, from: to, to: from },
            Self::Spline { ref spline, from, to } => Self::Spline { spline: Arc::clone(spline), from: to, to: from },
        }
    }

    /// Whether this is a straight line by its kind.
    pub fn is_straight(&self) -> bool {
        matches!(self, Self::Line(_))
    }

    /// ∫ |z′| over [0, t], to about 14 digits for pieces without sharp bends.
    pub fn length_to(&self, t: f64) -> f64 {
        match *self {
            Self::Line([a, b]) => return t * a.distance(b),
            Self::Spline { ref spline, from, to } => return spline.length_between([from, to], t),
            _ => {}
        }
        let mut count = 1;
        let mut length = self.composite_length(t, count);
        while count < MOST_PARTS {
            count *= 2;
            let finer = self.composite_length(t, count);
            if (finer - length).abs() <= LENGTH_TOLERANCE * finer {
                return finer;
            }
            length = finer;
        }
        length
    }

    /// The t up to which the length is `length`, of `whole` in all, by Newton's method inside of a bracket.
    pub fn parameter_at(&self, length: f64, whole: f64) -> f64 {
        let (mut low, mut high, mut t) = (0.0, 1.0, (length / whole).clamp(0.0, 1.0));
        if self.is_straight() {
            return t;
        }
        for _ in 0..60 {
            let excess = self.length_to(t) - length;
            if excess > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let next = t - excess / self.jet(t).first.length();
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if (next - t).abs() <= f64::EPSILON {
                break;
            }
            t = next;
        }
        t
    }

    /// Points on the piece in order, its ends among them: those of a spline, or the ends of `parts` equal steps of t.
    pub(super) fn inscribed(&self, parts: u32) -> Vec<DVec2> {
        match *self {
            Self::Line(ends) => ends.to_vec(),
            Self::Spline { ref spline, from, to } if from <= to => spline.points()[from..=to].to_vec(),
            Self::Spline { ref spline, from, to } => spline.points()[to..=from].iter().rev().copied().collect(),
            _ => (0..=parts).map(|k| self.jet(f64::from(k) / f64::from(parts)).position).collect(),
        }
    }

    fn composite_length(&self, t: f64, count: u32) -> f64 {
        let width = t / f64::from(count);
        (0..count).map(|k| integral(width, |s| self.jet(f64::from(k) * width + s).first.length())).sum()
    }

    pub(super) fn is_finite(&self) -> bool {
        if let Self::Spline { spline, .. } = self {
            return spline.is_finite();
        }
        [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|t| {
            let Jet { position, first, second } = self.jet(t);
            position.is_finite() && first.is_finite() && second.is_finite()
        })
    }
}

/// The relative difference of two lengths, of n and 2n parts, at which the finer one is taken. The parts' rules are of
/// order 32, so the finer one is then right to rounding.
const LENGTH_TOLERANCE: f64 = 1e-13;
/// The most parts of the rule for lengths.
const MOST_PARTS: u32 = 256;

/// The derivatives by t of a function of s with ds/dt = `rate`.
fn scaled(jet: Jet, rate: f64) -> Jet {
    Jet { position: jet.position, first: rate * jet.first, second: rate * rate * jet.second }
}

//! A panel: nodes on a stretch of one piece, the values there, and the polynomial through them.
//!
//! Positions are stored relative to an end of the piece, so that differences from a point next to a corner do not
//! cancel.

use super::rule::{NODES, Rule, Values, powers};
use super::{BoundaryFunction, Complex, complex};
use crate::geometry::{Curve, CurvePoint, DVec2};

/// The end of a piece from which parameters are counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    Start,
    Finish,
}

/// The part of a piece between two parameters, 0 ≤ from < to, counted from one of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    pub piece: usize,
    pub end: End,
    pub from: f64,
    pub to: f64,
}

/// A point of a curve relative to an end of its piece.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    pub offset: Complex,
    /// The derivative by the piece's parameter, in the direction of the curve.
    pub along: Complex,
    pub point: CurvePoint,
}

impl Stretch {
    /// Both halves, in the order of the curve.
    pub fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        let (low, high) = (Self { to: middle, ..*self }, Self { from: middle, ..*self });
        if self.end == End::Start { [low, high] } else { [high, low] }
    }

    /// The position of the piece's end.
    fn base(&self, curve: &Curve) -> DVec2 {
        curve.pieces()[self.piece].jet(if self.end == End::Start { 0.0 } else { 1.0 }).position
    }

    /// The point at x in [−1, 1], in the direction of the curve.
    pub fn place(&self, curve: &Curve, x: f64) -> Place {
        let (piece, half) = (&curve.pieces()[self.piece], 0.5 * (self.to - self.from));
        let (jet, point) = match self.end {
            End::Start => {
                let t = self.from + half * (1.0 + x);
                (piece.from_start(t), CurvePoint::new(self.piece, t))
            }
            End::Finish => {
                let u = self.from + half * (1.0 - x);
                (piece.from_end(u), CurvePoint::before_end(self.piece, u))
            }
        };
        Place { offset: complex(jet.position), along: complex(jet.first), point }
    }
}

/// Nodes and values, before it is known whether they are enough.
#[derive(Debug, Clone)]
pub struct Sampled {
    pub stretch: Stretch,
    offsets: Values,
    /// dζ at the nodes.
    weights: Values,
    pub values: Values,
}

/// The last coefficients of a resolved function, of [`NODES`].
const LAST: usize = 3;

impl Sampled {
    /// Evaluates curve and function at the nodes of a stretch.
    pub fn new(curve: &Curve, stretch: Stretch, function: &dyn BoundaryFunction) -> Self {
        let (rule, half) = (Rule::get(), 0.5 * (stretch.to - stretch.from));
        let places = rule.nodes.map(|x| stretch.place(curve, x));
        Self {
            stretch,
            offsets: places.map(|place| place.offset),
            weights: std::array::from_fn(|i| half * rule.weights[i] * places[i].along),
            values: places.map(|place| complex(function.value(place.point))),
        }
    }

    /// The largest of the last coefficients of the values.
    pub fn tail(&self) -> f64 {
        tail(&self.values)
    }

    /// The largest of the last coefficients of the positions.
    pub fn tail_of_positions(&self) -> f64 {
        tail(&self.offsets)
    }

    /// The distance of the end of the piece from the origin, for the rounding of positions.
    pub fn distance_from_origin(&self, curve: &Curve) -> f64 {
        self.stretch.base(curve).length()
    }

    /// The length.
    pub fn length(&self) -> f64 {
        self.weights.iter().map(|weight| weight.norm()).sum()
    }

    /// By how much the values vary.
    pub fn variation(&self) -> f64 {
        self.values.iter().map(|value| (value - self.values[0]).norm()).fold(0.0, f64::max)
    }

    /// The change of the unit tangent from the first node to the last one.
    pub fn bend(&self) -> f64 {
        let [first, last] = [self.weights[0], self.weights[NODES - 1]].map(|weight| weight / weight.norm());
        (last - first).norm()
    }

    /// The largest error of the function at the first, a middle and the last node.
    pub fn function_error(&self, curve: &Curve, function: &dyn BoundaryFunction) -> f64 {
        let nodes = &Rule::get().nodes;
        let at = |k: usize| function.error(self.stretch.place(curve, nodes[k]).point);
        [0, NODES / 2, NODES - 1].into_iter().map(at).fold(0.0, f64::max)
    }
}

fn tail(values: &Values) -> f64 {
    let coefficients = Rule::get().coefficients(values);
    coefficients[NODES - LAST..].iter().map(|c| c.norm()).fold(0.0, f64::max)
}

/// A panel of the curve with the values of the function, relative to a center of all values.
#[derive(Debug, Clone)]
pub struct Panel {
    pub stretch: Stretch,
    /// The point that offsets are relative to.
    pub base: DVec2,
    /// The nodes' offsets, their weights dζ and the values: real parts, then imaginary parts.
    pub offsets: [[f64; NODES]; 2],
    pub weights: [[f64; NODES]; 2],
    pub values: [[f64; NODES]; 2],
    /// The offsets of both ends of the panel.
    pub ends: [Complex; 2],
    /// The values by powers of the position ζ′, −1 and 1 at the ends.
    pub powers: Values,
    /// The largest distance of the panel from its chord, in half chords.
    pub height: f64,
    /// The difference, at the ends, of the polynomials in the position and in the parameter: where F is resolved in the
    /// parameter, but has a singular point next to the panel that the parametrization has, too, only this is large.
    pub mismatch: f64,
    /// The error of the values.
    pub error: f64,
}

fn split(values: &Values) -> [[f64; NODES]; 2] {
    [values.map(|v| v.re), values.map(|v| v.im)]
}

impl Panel {
    /// Takes the samples as a panel, with values relative to `center`.
    pub fn new(curve: &Curve, sampled: &Sampled, center: Complex, error: f64) -> Self {
        let stretch = sampled.stretch;
        let ends = [-1.0, 1.0].map(|x| stretch.place(curve, x).offset);
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        let positions = sampled.offsets.map(|offset| (offset - middle) / half);
        let values = sampled.values.map(|value| value - center);
        let panel = Self {
            stretch,
            base: stretch.base(curve),
            offsets: split(&sampled.offsets),
            weights: split(&sampled.weights),
            values: split(&values),
            ends,
            powers: powers(&positions, &values),
            height: positions.iter().map(|z| z.im.abs()).fold(0.0, f64::max),
            mismatch: 0.0,
            error,
        };
        let at_ends = Rule::get().ends(&values);
        let difference = |k: usize| (panel.polynomial([-Complex::ONE, Complex::ONE][k])[0] - at_ends[k]).norm();
        Self { mismatch: difference(0).max(difference(1)), ..panel }
    }

    /// Σ a_j ζ′ʲ and its derivative by ζ′.
    pub fn polynomial(&self, z: Complex) -> [Complex; 2] {
        let step = |[value, slope]: [Complex; 2], a: &Complex| [value * z + a, slope * z + value];
        self.powers.iter().rev().fold([Complex::ZERO; 2], step)
    }

    /// Half of the chord from the first end to the last.
    pub fn half_chord(&self) -> Complex {
        0.5 * (self.ends[1] - self.ends[0])
    }

    /// The point ζ′ for a point of the plane.
    pub fn local(&self, z: DVec2) -> Complex {
        (complex(z - self.base) - 0.5 * (self.ends[0] + self.ends[1])) / self.half_chord()
    }
}

//! The boundary next to a junction: its two legs, each parametrized from the junction outwards.
//!
//! Densities are those by λ, the parameter of a piece times its length; so on every piece dω = σ dλ, where σ is of the
//! order of the density by arc length. In σ the equation reads σ ± k σ = |z′| g with the kernel
//! k(y, s) = (1/π) |z′(y)| n_y·(y − s)/|y − s|², which needs no normal of unit length.

use crate::geometry::{Curve, DVec2, Piece};
use std::f64::consts::FRAC_1_PI;

/// A quadrature node: a point with its outward normal and weight.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    /// The position relative to some base point that does not cancel in differences.
    pub offset: DVec2,
    /// The outward normal times |dz/dλ|.
    pub normal: DVec2,
    /// The kernel at coinciding points, |dz/dλ| κ/2π.
    pub diagonal: f64,
    /// The weight by λ.
    pub weight: f64,
}

/// k(y, s) without the weight, for the difference y − s.
pub fn kernel(normal: DVec2, difference: DVec2) -> f64 {
    FRAC_1_PI * normal.dot(difference) / difference.length_squared()
}

/// One of the two pieces that meet in a junction, from there outwards.
#[derive(Debug, Clone)]
pub struct Leg {
    piece: Piece,
    is_incoming: bool,
    /// The piece's length: dλ per unit of its parameter.
    pub length: f64,
    /// |dz/dλ| at the junction.
    pub speed: f64,
}

impl Leg {
    /// Legs of junction `k`: the end of the piece before it, and the start of piece `k`.
    pub fn both(curve: &Curve, k: usize) -> [Self; 2] {
        let count = curve.pieces().len();
        [((k + count - 1) % count, true), (k, false)].map(|(piece, is_incoming)| Self::new(curve, piece, is_incoming))
    }

    /// The start of a piece, or its end.
    pub fn new(curve: &Curve, piece: usize, is_incoming: bool) -> Self {
        let (given, length) = (&curve.pieces()[piece], curve.lengths()[piece]);
        let piece = if is_incoming { given.reversed() } else { given.clone() };
        let speed = piece.jet(0.0).first.length() / length;
        Self { piece, is_incoming, length, speed }
    }

    /// The straight leg from the origin to `end`, by arc length if that is of length 1.
    pub fn straight(end: DVec2, is_incoming: bool) -> Self {
        Self { piece: Piece::Line([DVec2::ZERO, end]), is_incoming, length: 1.0, speed: 1.0 }
    }

    /// A piece of length 1 by its parameter.
    #[cfg(test)]
    pub fn alone(piece: Piece) -> Self {
        let speed = piece.jet(0.0).first.length();
        Self { piece, is_incoming: false, length: 1.0, speed }
    }

    pub fn is_straight(&self) -> bool {
        self.piece.is_straight()
    }

    /// The node at the parameter `t` from the junction, with the weight `by_parameter` · dλ/dt.
    pub fn node(&self, t: f64, by_parameter: f64) -> Node {
        let jet = self.piece.from_start(t);
        let sign = if self.is_incoming { -1.0 } else { 1.0 };
        let along = sign / self.length * jet.first;
        // a line's κ is exactly 0
        let diagonal = 0.5 * FRAC_1_PI * along.length() * sign * jet.curvature();
        Node {
            offset: jet.position,
            normal: DVec2::new(along.y, -along.x),
            diagonal,
            weight: by_parameter * self.length,
        }
    }

    /// dz/dλ at t, in the direction away from the junction.
    pub fn outward(&self, t: f64) -> DVec2 {
        self.piece.from_start(t).first / self.length
    }
}

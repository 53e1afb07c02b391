//! Closed curves of smooth pieces between junctions.
//!
//! A [`Curve`] is closed, counter-clockwise and finite; its pieces have positive length and tangents at both ends,
//! and it has no cusps. That it does not cross itself is not checked.

mod error;
mod piece;
mod quadrature;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use glam::DVec2;

use super::SimplePolygon;
pub use error::CurveError;
pub use piece::{Jet, Piece};
pub(crate) use quadrature::gauss_legendre;
pub(super) use quadrature::integral;

/// How the curve passes from one piece to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Junction {
    /// With an angle.
    Corner {
        /// The interior angle in (0, 2π), not π.
        angle: f64,
    },
    /// With a common tangent; the curvature may jump.
    Smooth,
    /// As one analytic curve: only its parametrization is broken here.
    Analytic,
}

/// A point of a curve, at the parameter t of a piece. Both t and 1 − t are stored, so that points next to either end
/// keep their relative distance from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    piece: usize,
    from_start: f64,
    to_end: f64,
}

impl CurvePoint {
    /// The point at t, clamped to [0, 1], of piece `piece`.
    pub fn new(piece: usize, t: f64) -> Self {
        let t = t.clamp(0.0, 1.0);
        Self { piece, from_start: t, to_end: 1.0 - t }
    }

    /// The point at t = 1 − `u`, `u` clamped to [0, 1].
    pub fn before_end(piece: usize, u: f64) -> Self {
        let u = u.clamp(0.0, 1.0);
        Self { piece, from_start: 1.0 - u, to_end: u }
    }

    /// The point with these two parameters, t and 1 − t; `None` unless they are.
    #[cfg(feature = "io")]
    pub(crate) fn of_parts(piece: usize, from_start: f64, to_end: f64) -> Option<Self> {
        let is_sound = from_start >= 0.0 && to_end >= 0.0 && (from_start + to_end - 1.0).abs() <= f64::EPSILON;
        is_sound.then_some(Self { piece, from_start, to_end })
    }

    /// The index of the piece.
    pub fn piece(&self) -> usize {
        self.piece
    }

    /// t.
    pub fn from_start(&self) -> f64 {
        self.from_start
    }

    /// 1 − t.
    pub fn to_end(&self) -> f64 {
        self.to_end
    }
}

/// A closed, counter-clockwise curve of smooth pieces. Junction `k` is the point where piece `k` begins.
#[derive(Debug, Clone)]
pub struct Curve {
    pieces: Vec<Piece>,
    junctions: Vec<Junction>,
    lengths: Vec<f64>,
    extent: f64,
}

/// The largest gap between two pieces, in extents of the curve: rounding of an arc's end, not a fault of the input.
const GAP: f64 = 1e-12;
/// Tangents that differ by less count as one. Arcs and lines of formulas agree to 1e-15; coordinates of f32 to 1e-7,
/// which is then a corner, of almost 180 degrees.
const ONE_TANGENT: f64 = 1e-9;
/// Two lines that turn by less are one line.
const ONE_LINE: f64 = 1e-13;
/// Angles nearer to 0 or 2π are cusps. The narrowest tips of the built-in outlines have 0.5.
const CUSP: f64 = 1e-5;
/// The least speed at an end, in lengths of the piece: less is a vanishing derivative.
const LEAST_SPEED: f64 = 1e-6;

/// The points of a piece from which the nearest one to a place is looked for.
const STATIONS: usize = 64;

/// Fractions of the perimeter that differ by less are equal: next to a reentrant corner, 1e-16 of the length can be
/// 1e-8 of the harmonic measure, so a sum of lengths must not miss the corner by rounding.
const JUNCTION_ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Arcs whose centers and axes differ by less, in axes, belong to one ellipse.
const ONE_ELLIPSE: f64 = 1e-12;

impl Curve {
    /// Checks the pieces, each of which begins where the one before it ends, and derives the kinds of junctions.
    pub fn new(pieces: Vec<Piece>) -> Result<Self, CurveError> {
        if pieces.is_empty() {
            return Err(CurveError::Empty);
        }
        if let Some(piece) = pieces.iter().position(|piece| !piece.is_finite()) {
            return Err(CurveError::NotFinite { piece });
        }
        let lengths: Vec<f64> = pieces.iter().map(|piece| piece.length_to(1.0)).collect();
        check_lengths(&pieces, &lengths)?;
        let extent = lengths.iter().sum();
        let before = |k: usize| &pieces[(k + pieces.len() - 1) % pieces.len()];
        for (piece, next) in pieces.iter().enumerate() {
            let gap = before(piece).jet(1.0).position.distance(next.jet(0.0).position);
            if gap > GAP * extent {
                return Err(CurveError::Open { piece, gap });
            }
        }
        if area(&pieces) <= 0.0 {
            return Err(CurveError::Clockwise);
        }
        let junctions = (0..pieces.len()).map(|k| junction(before(k), k, &pieces[k])).collect::<Result<_, _>>()?;
        Ok(Self { pieces, junctions, lengths, extent })
    }

    /// The polygon's edges as lines.
    pub fn from_polygon(polygon: &SimplePolygon) -> Result<Self, CurveError> {
        Self::new(polygon.edges().map(|(a, b)| Piece::Line([a, b])).collect())
    }

    /// The same curve, said to be analytic at junction `k`, where only its formula or its parametrization changes.
    pub fn analytic_at(mut self, k: usize) -> Result<Self, CurveError> {
        match self.junctions.get_mut(k) {
            Some(Junction::Corner { .. }) => Err(CurveError::NotAnalytic { piece: k }),
            Some(junction) => {
                *junction = Junction::Analytic;
                Ok(self)
            }
            None => Ok(self),
        }
    }

    /// The pieces, in order.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The junctions; junction `k` is where piece `k` begins.
    pub fn junctions(&self) -> &[Junction] {
        &self.junctions
    }

    /// The lengths of the pieces.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// The length of the whole curve.
    pub fn perimeter(&self) -> f64 {
        self.extent
    }

    /// Whether a point is a corner of the curve.
    pub fn is_corner(&self, point: CurvePoint) -> bool {
        let junction = match point {
            _ if point.from_start() == 0.0 => point.piece(),
            _ if point.to_end() == 0.0 => (point.piece() + 1) % self.pieces.len(),
            _ => return false,
        };
        matches!(self.junctions[junction], Junction::Corner { .. })
    }

    /// The position of a point; of the last piece if its piece does not exist.
    pub fn position(&self, point: CurvePoint) -> DVec2 {
        self.pieces[point.piece.min(self.pieces.len() - 1)].jet(point.from_start).position
    }

    /// The point at a fraction of the perimeter from the start of piece 0, counter-clockwise; taken modulo 1. A
    /// fraction within rounding of a junction is that junction.
    pub fn point_at_fraction(&self, fraction: f64) -> CurvePoint {
        let mut rest = fraction.rem_euclid(1.0) * self.perimeter();
        let rounding = JUNCTION_ROUNDING * self.perimeter();
        for (k, &length) in self.lengths.iter().enumerate() {
            if rest <= rounding {
                return CurvePoint::new(k, 0.0);
            }
            if rest < length - rounding || (k + 1 == self.lengths.len() && rest < length) {
                return CurvePoint::new(k, self.pieces[k].parameter_at(rest, length));
            }
            rest -= length;
        }
        CurvePoint::new(0, 0.0)
    }

    /// The fraction of the perimeter at the point of the curve nearest to `x`, as far as it is seen from 64 points of each
    /// piece, of a spline from two between its points; a junction at `x` is hit exactly.
    pub fn fraction_nearest(&self, x: DVec2) -> f64 {
        let distance = |piece: &Piece, t: f64| piece.jet(t).position.distance(x);
        let mut best = (f64::INFINITY, 0, 0.0, 0.0);
        for (k, piece) in self.pieces.iter().enumerate() {
            let parts = if let Piece::Spline { from, to, .. } = piece { 2 * (to - from) } else { STATIONS };
            for t in (0..parts).map(|j| j as f64 / parts as f64) {
                let found = distance(piece, t);
                if found < best.0 {
                    best = (found, k, t, 1.0 / parts as f64);
                }
            }
        }
        let (mut least, k, mut t, mut step) = best;
        let piece = &self.pieces[k];
        while least > 0.0 && step > f64::EPSILON * t {
            let tried = [t + step, t - step].map(|t| (distance(piece, t.clamp(0.0, 1.0)), t.clamp(0.0, 1.0)));
            match tried.into_iter().find(|(found, _)| *found < least) {
                Some(better) => (least, t) = better,
                None => step *= 0.5,
            }
            if step < f64::MIN_POSITIVE {
                break;
            }
        }
        let before: f64 = self.lengths[..k].iter().sum();
        (before + piece.length_to(t)) / self.perimeter()
    }

    /// Whether `x` lies inside, by the winding number. Points within rounding of the curve may count either way.
    pub fn contains(&self, x: DVec2) -> bool {
        let turn = |piece: &Piece| winding(piece, x, [0.0, 1.0], [piece.jet(0.0), piece.jet(1.0)], 0);
        x.is_finite() && self.pieces.iter().map(turn).sum::<f64>() > PI
    }
}

/// Below this depth a part of a piece that is not small against its distance from x counts as passing through x.
const DEEPEST: u32 = 50;

/// The angle by which the part [a, b] of a piece turns around x. A part shorter than its distance from x turns by less
/// than π; the length is bounded by twice the larger speed at its ends.
fn winding(piece: &Piece, x: DVec2, [a, b]: [f64; 2], [from, to]: [Jet; 2], depth: u32) -> f64 {
    let middle = piece.jet(0.5 * (a + b));
    let speed = from.first.length().max(to.first.length()).max(middle.first.length());
    let is_short = 2.0 * speed * (b - a) < (from.position - x).length();
    if (is_short && depth >= 2) || piece.is_straight() || depth == DEEPEST {
        return (from.position - x).angle_to(to.position - x);
    }
    let half = 0.5 * (a + b);
    winding(piece, x, [a, half], [from, middle], depth + 1) + winding(piece, x, [half, b], [middle, to], depth + 1)
}

fn check_lengths(pieces: &[Piece], lengths: &[f64]) -> Result<(), CurveError> {
    for (piece, (curve, &length)) in pieces.iter().zip(lengths).enumerate() {
        if !(length > 0.0 && length.is_finite()) {
            return Err(CurveError::NoLength { piece });
        }
        for end in [curve.jet(0.0), curve.jet(1.0)] {
            if end.first.length() < LEAST_SPEED * length {
                return Err(CurveError::NoTangent { piece, at: end.position });
            }
        }
    }
    Ok(())
}

/// Parts of a curved piece for the sign of the area.
const AREA_PARTS: u32 = 64;

/// Twice the signed area, ∮ (z − z₀) × dz, by inscribed chords of each piece: enough for its sign.
fn area(pieces: &[Piece]) -> f64 {
    let origin = pieces[0].jet(0.0).position;
    let of_piece = |piece: &Piece| -> f64 {
        let places = piece.inscribed(AREA_PARTS);
        places.windows(2).map(|pair| (pair[0] - origin).perp_dot(pair[1] - origin)).sum()
    };
    pieces.iter().map(of_piece).sum()
}

/// The junction from `before` to `after`, which is piece `index`.
fn junction(before: &Piece, index: usize, after: &Piece) -> Result<Junction, CurveError> {
    let (end, start) = (before.jet(1.0), after.jet(0.0));
    // atan2, since an arccosine is off by 1e-8 near π
    let angle = start.first.perp_dot(-end.first).atan2(start.first.dot(-end.first)).rem_euclid(TAU);
    let turn = (angle - PI).abs();
    if !(CUSP..=TAU - CUSP).contains(&angle) {
        return Err(CurveError::Cusp { piece: index, at: start.position });
    }
    if turn > ONE_TANGENT {
        return Ok(Junction::Corner { angle });
    }
    let is_one_curve = match (before, after) {
        (Piece::Line(_), Piece::Line(_)) => turn <= ONE_LINE,
        (Piece::Spline { spline: a, to, .. }, Piece::Spline { spline: b, from, .. }) => Arc::ptr_eq(a, b) && to == from,
        (Piece::Arc { center: c, axes: a, .. }, Piece::Arc { center: d, axes: b, .. }) => {
            let size = ONE_ELLIPSE * (a[0].length() + a[1].length());
            c.distance(*d) <= size && a[0].distance(b[0]) <= size && a[1].distance(b[1]) <= size
        }
        _ => false,
    };
    Ok(if is_one_curve { Junction::Analytic } else { Junction::Smooth })
}

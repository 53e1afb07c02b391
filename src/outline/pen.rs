//! Draws curves as dense polygons: lines, arcs, Bézier curves, rounded corners; and records them as exact pieces.
//!
//! Smooth pieces turn by less than about [`TURN`] from edge to edge, so that the
//! polygon's own turning angles are a good estimate of curvature, and a corner
//! stands out from it by a factor of ten.

use crate::geometry::{Bounds, DVec2, Piece};

/// The turn from edge to edge on smooth curves, in radians.
pub(super) const TURN: f64 = 0.012;

/// How closely a polygon follows a smooth curve; a piece is bisected until it meets both limits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// The largest turn at the middle of a piece, in radians.
    pub turn: f64,
    /// The largest length × turn²: 48 times what the piece's two chords lack in length.
    pub deficit: f64,
}

/// Fine enough to look smooth; the length is not limited.
pub(super) const SMOOTH: Fineness = Fineness { turn: TURN, deficit: f64::INFINITY };

/// Points nearer to each other than this are one.
const SAME: f64 = 1e-12;

/// A growing chain of points, and the curve that they follow.
#[derive(Debug, Default)]
pub(super) struct Pen {
    points: Vec<DVec2>,
    pieces: Vec<Piece>,
}

impl Pen {
    /// A chain that consists of the point `p`.
    pub fn at(p: DVec2) -> Self {
        Self { points: vec![p], pieces: Vec::new() }
    }

    fn position(&self) -> DVec2 {
        self.points.last().copied().unwrap_or_default()
    }

    /// A straight edge to `p`; nothing is added if the pen is at `p` already.
    pub fn line(&mut self, p: DVec2) -> &mut Self {
        if let Some(&q) = self.points.last()
            && q.distance(p) > SAME
        {
            self.pieces.push(Piece::Line([q, p]));
        }
        self.step(p)
    }

    /// A further point of the piece that is being drawn.
    fn step(&mut self, p: DVec2) -> &mut Self {
        if self.points.last().is_none_or(|q| q.distance(p) > SAME) {
            self.points.push(p);
        }
        self
    }

    /// Records the exact piece of a curve that is drawn by [`Self::curve`].
    pub fn record(&mut self, piece: Piece) -> &mut Self {
        self.pieces.push(piece);
        self
    }

    /// Records an arc around `center` from the pen's position, by a signed angle.
    fn record_arc(&mut self, center: DVec2, angle: f64) {
        let spoke = self.position() - center;
        let from = spoke.to_angle();
        self.pieces.push(Piece::circular(center, spoke.length(), from, from + angle));
    }

    /// A cubic Bézier curve from the pen's position to `d` with inner control points `b` and `c`.
    pub fn cubic(&mut self, b: DVec2, c: DVec2, d: DVec2) -> &mut Self {
        let a = self.position();
        self.record(Piece::Cubic([a, b, c, d]));
        self.curve(0.0, 1.0, SMOOTH, |t| a.lerp(b, t).lerp(b.lerp(c, t), t).lerp(b.lerp(c, t).lerp(c.lerp(d, t), t), t))
    }

    /// A circular arc to `p` that leaves the chord by the angle `leave` to its
    /// right: positive bows outward on a counter-clockwise outline.
    pub fn bow(&mut self, p: DVec2, leave: f64) -> &mut Self {
        let a = self.position();
        if leave.abs() < 1e-9 {
            return self.line(p);
        }
        let chord = p - a;
        let center = a.midpoint(p) + chord.perp() / (2.0 * leave.tan());
        self.record_arc(center, 2.0 * leave);
        let steps = (2.0 * leave.abs() / TURN).ceil().max(2.0);
        for k in 1..steps as u32 {
            let spoke = DVec2::from_angle(2.0 * leave * f64::from(k) / steps);
            self.points.push(center + spoke.rotate(a - center));
        }
        self.step(p)
    }

    /// An arc around `center` from the pen's position, by a signed angle.
    pub fn turn_around(&mut self, center: DVec2, angle: f64) -> &mut Self {
        self.record_arc(center, angle);
        let spoke = self.position() - center;
        let steps = (angle.abs() / TURN).ceil().max(1.0);
        for k in 1..=steps as u32 {
            self.step(center + DVec2::from_angle(angle * f64::from(k) / steps).rotate(spoke));
        }
        self
    }

    /// The curve `f` over `[from, to]`, bisected until each piece is fine enough. Its start is the pen's position. The
    /// caller records its exact piece.
    pub fn curve(&mut self, from: f64, to: f64, fineness: Fineness, f: impl Fn(f64) -> DVec2) -> &mut Self {
        // At least 64 pieces: judged by its middle alone, an S-shaped curve can look straight.
        let at = |k: u32| from + (to - from) * f64::from(k) / 64.0;
        for k in 0..64 {
            let (s, t) = (at(k), at(k + 1));
            self.bisect([s, t], [f(s), f(t)], fineness, &f, 12);
        }
        self
    }

    fn bisect(
        &mut self,
        [s, t]: [f64; 2],
        [p, q]: [DVec2; 2],
        fineness: Fineness,
        f: &impl Fn(f64) -> DVec2,
        depth: u32,
    ) {
        let middle = s.midpoint(t);
        let m = f(middle);
        let turn = (m - p).angle_to(q - m).abs();
        if depth > 0 && (turn > fineness.turn || p.distance(q) * turn * turn > fineness.deficit) {
            self.bisect([s, middle], [p, m], fineness, f, depth - 1);
            self.bisect([middle, t], [m, q], fineness, f, depth - 1);
        } else {
            self.step(m).step(q);
        }
    }

    /// The closed chain, without a closing point equal to the first.
    pub fn close(mut self) -> Vec<DVec2> {
        while self.points.len() > 1 && self.points[0].distance(self.position()) <= SAME {
            self.points.pop();
        }
        self.points
    }

    /// The exact pieces of the closed curve.
    pub fn pieces(&self) -> Vec<Piece> {
        let mut pieces = self.pieces.clone();
        if let Some(&first) = self.points.first()
            && first.distance(self.position()) > SAME
        {
            pieces.push(Piece::Line([self.position(), first]));
        }
        pieces
    }
}

/// A closed polygon whose corners are rounded: each is a point and the radius
/// of the arc that replaces it, tangent to both edges (0 keeps the corner).
///
/// If the radii are too large for an edge, the arcs are shortened in proportion to fit.
pub(super) fn rounded(corners: &[(f64, f64, f64)]) -> Pen {
    let n = corners.len();
    let point = |k: usize| DVec2::new(corners[k % n].0, corners[k % n].1);
    // The length that each corner's arc takes from its edges.
    let reach = |k: usize| {
        let (p, q, r) = (point(k + n - 1), point(k), point(k + 1));
        corners[k % n].2 * (0.5 * (q - p).angle_to(r - q)).tan().abs()
    };
    let share = |k: usize, other: usize| {
        let length = point(k).distance(point(other));
        (length / (reach(k) + reach(other)).max(length)).min(1.0)
    };
    let mut pen = Pen::default();
    for k in 0..n {
        let (p, q, r) = (point(k + n - 1), point(k), point(k + 1));
        let cut = reach(k) * share(k, k + n - 1).min(share(k, k + 1));
        let turn = (q - p).angle_to(r - q);
        pen.line(q + cut * (p - q).normalize());
        if cut > 0.0 {
            pen.bow(q + cut * (r - q).normalize(), 0.5 * turn);
        }
    }
    pen
}

/// A smooth closed curve `f` of period 1.
pub(super) fn closed_curve(fineness: Fineness, f: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    let mut pen = Pen::at(f(0.0));
    for k in 0..4 {
        pen.curve(f64::from(k) / 4.0, f64::from(k + 1) / 4.0, fineness, &f);
    }
    pen.close()
}

/// The drawing moved and scaled so that it just fits into [−1, 1]². It contains no formulas.
pub(super) fn fitted(pen: Pen) -> Pen {
    let bounds = Bounds::of(pen.points.iter().copied());
    let scale = 2.0 / bounds.size().max_element();
    let moved = |p: DVec2| scale * (p - bounds.center());
    let piece = |piece: Piece| match piece {
        Piece::Line(points) => Piece::Line(points.map(moved)),
        Piece::Cubic(points) => Piece::Cubic(points.map(moved)),
        Piece::Arc { center, axes, from, to } => {
            Piece::Arc { center: moved(center), axes: axes.map(|axis| scale * axis), from, to }
        }
        Piece::Formula { .. } => piece,
    };
    Pen { points: pen.points.into_iter().map(moved).collect(), pieces: pen.pieces.into_iter().map(piece).collect() }
}

/// The point at `degrees` on the circle around the origin with `radius`.
pub(super) fn polar(radius: f64, degrees: f64) -> DVec2 {
    radius * DVec2::from_angle(degrees.to_radians())
}

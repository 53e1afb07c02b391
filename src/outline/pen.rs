//! Draws curves as dense polygons: lines, arcs, Bézier curves, formulas, rounded corners.
//!
//! Every stroke adds points to the polygon and a piece to the curve, so that the polygon's points lie on the curve.
//! Smooth pieces turn by less than about [`TURN`] from edge to edge, so that the
//! polygon's own turning angles are a good estimate of curvature, and a corner
//! stands out from it by a factor of ten.

use crate::geometry::{Bounds, DVec2, Jet, Piece};

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

/// A closed curve, and the polygon that samples it.
#[derive(Debug, Clone)]
pub(super) struct Drawn {
    /// The polygon's vertices, on the curve.
    pub points: Vec<DVec2>,
    /// The pieces, the first of which begins at the first vertex.
    pub pieces: Vec<Piece>,
}

/// A growing chain of points and the pieces that they sample.
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
        let from = self.points.last().copied();
        if self.point(p)
            && let Some(from) = from
        {
            self.pieces.push(Piece::Line([from, p]));
        }
        self
    }

    /// Adds a vertex, unless the pen is there already.
    fn point(&mut self, p: DVec2) -> bool {
        let is_new = self.points.last().is_none_or(|q| q.distance(p) > SAME_POINT);
        if is_new {
            self.points.push(p);
        }
        is_new
    }

    /// A cubic Bézier curve from the pen's position to `d` with inner control points `b` and `c`.
    pub fn cubic(&mut self, b: DVec2, c: DVec2, d: DVec2) -> &mut Self {
        let a = self.position();
        self.pieces.push(Piece::Cubic([a, b, c, d]));
        self.trace(0.0, 1.0, SMOOTH, |t| a.lerp(b, t).lerp(b.lerp(c, t), t).lerp(b.lerp(c, t).lerp(c.lerp(d, t), t), t))
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
        self.arc(center, a - center, 2.0 * leave);
        let steps = (2.0 * leave.abs() / TURN).ceil().max(2.0);
        for k in 1..steps as u32 {
            let spoke = DVec2::from_angle(2.0 * leave * f64::from(k) / steps);
            self.points.push(center + spoke.rotate(a - center));
        }
        self.point(p);
        self
    }

    /// An arc around `center` from the pen's position, by a signed angle.
    pub fn turn_around(&mut self, center: DVec2, angle: f64) -> &mut Self {
        let spoke = self.position() - center;
        self.arc(center, spoke, angle);
        let steps = (angle.abs() / TURN).ceil().max(1.0);
        for k in 1..=steps as u32 {
            self.point(center + DVec2::from_angle(angle * f64::from(k) / steps).rotate(spoke));
        }
        self
    }

    /// Records a circular arc that begins at `center + spoke`; an arc that continues the one before it prolongs that.
    fn arc(&mut self, center: DVec2, spoke: DVec2, angle: f64) {
        if let Some(Piece::Arc { center: old, axes, from, to }) = self.pieces.last_mut()
            && is_one_circle((*old, axes[0].length()), (center, spoke.length()))
            && (*to - *from) * angle > 0.0
        {
            *to += angle;
        } else {
            self.pieces.push(Piece::Arc { center, axes: [spoke, spoke.perp()], from: 0.0, to: angle });
        }
    }

    /// The curve `function` over all of `knots`, one piece, its points bisected from knot to knot as by
    /// [`Self::trace`]. Its start is the pen's position.
    pub fn formula(&mut self, function: fn(f64) -> Jet, knots: &[f64], fineness: Fineness) -> &mut Self {
        if let [from, .., to] = *knots {
            self.pieces.push(Piece::Formula { function, from, to });
        }
        for ends in knots.windows(2) {
            self.trace(ends[0], ends[1], fineness, |s| function(s).position);
        }
        self
    }

    /// The curve `f` over `[from, to]`, bisected until each piece is fine enough. Its start is the pen's position.
    fn trace(&mut self, from: f64, to: f64, fineness: Fineness, f: impl Fn(f64) -> DVec2) -> &mut Self {
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
            self.point(m);
            self.point(q);
        }
    }

    /// The closed chain, without a closing point equal to the first, and the closed curve.
    pub fn close(mut self) -> Drawn {
        if let Some(&first) = self.points.first() {
            self.line(first);
        }
        while self.points.len() > 1 && self.points[0].distance(self.position()) <= SAME_POINT {
            self.points.pop();
        }
        Drawn { points: self.points, pieces: self.pieces }
    }
}

/// Vertices nearer to each other are one: they differ by rounding, in outlines of size 2.
const SAME_POINT: f64 = 1e-12;

/// Whether two circles, each a center and a radius, differ by rounding only.
pub(super) fn is_one_circle((c, r): (DVec2, f64), (d, s): (DVec2, f64)) -> bool {
    c.distance(d) + (r - s).abs() <= SAME_POINT * r
}

/// A closed polygon whose corners are rounded: each is a point and the radius
/// of the arc that replaces it, tangent to both edges (0 keeps the corner).
///
/// If the radii are too large for an edge, the arcs are shortened in proportion to fit.
pub(super) fn rounded(corners: &[(f64, f64, f64)]) -> Drawn {
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
    pen.close()
}

/// The straight edges of a polygon.
pub(super) fn straight(points: impl IntoIterator<Item = DVec2>) -> Drawn {
    let mut pen = Pen::default();
    for point in points {
        pen.line(point);
    }
    pen.close()
}

/// The points and pieces moved and scaled alike so that the points just fit into [−1, 1]².
pub(super) fn fitted(drawn: Drawn) -> Drawn {
    let bounds = Bounds::of(drawn.points.iter().copied());
    let scale = 2.0 / bounds.size().max_element();
    let place = |p: DVec2| scale * (p - bounds.center());
    let pieces = drawn.pieces.into_iter().map(|piece| match piece {
        Piece::Line(ends) => Piece::Line(ends.map(place)),
        Piece::Cubic(control) => Piece::Cubic(control.map(place)),
        Piece::Arc { center, axes, from, to } => {
            Piece::Arc { center: place(center), axes: axes.map(|axis| scale * axis), from, to }
        }
        // a formula has no parameters that could move it; none of the fitted outlines has one
        other => other,
    });
    Drawn { points: drawn.points.into_iter().map(place).collect(), pieces: pieces.collect() }
}

/// The point at `degrees` on the circle around the origin with `radius`.
pub(super) fn polar(radius: f64, degrees: f64) -> DVec2 {
    radius * DVec2::from_angle(degrees.to_radians())
}

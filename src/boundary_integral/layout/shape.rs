//! The shape of one panel: where it lies, how long it is, and how well 16 nodes resolve it.

use super::{End, Panel};
use crate::boundary_integral::corner::Problem;
use crate::boundary_integral::leg::Leg;
use crate::boundary_integral::legendre::{NODES, Rule, last_two, series};
use crate::geometry::{Curve, DVec2, Jet, Piece};

/// The number of points of a panel that distances are taken from.
const POINTS: usize = 7;

/// The least sine of the angles at which two points face each other.
const FACING: f64 = 0.05;

/// The shape of a panel.
#[derive(Debug, Clone)]
pub struct Shape {
    points: [DVec2; POINTS],
    /// The outward normals there.
    normals: [DVec2; POINTS],
    center: DVec2,
    radius: f64,
    pub length: f64,
    resolution: Resolution,
}

/// How far a panel's polynomials are from the curve.
#[derive(Debug, Clone, Copy)]
enum Resolution {
    /// An analytic curve: the share of the last coefficients of z′.
    Tail(f64),
    /// A spline with knots inside of the panel: the largest difference of z′ at a knot, in speeds, and `NOISE` times
    /// what the spline itself leaves open.
    Spline { deviation: f64, noise: f64 },
}

impl Shape {
    pub fn of(curve: &Curve, panel: &Panel) -> Self {
        let piece = &curve.pieces()[panel.piece];
        let at = |t: f64| if panel.end == End::Start { t } else { 1.0 - t };
        let step = (panel.to - panel.from) / (POINTS - 1) as f64;
        let jets: [Jet; POINTS] = std::array::from_fn(|k| piece.jet(at(panel.from + step * k as f64)));
        let (points, normals) = (jets.map(|jet| jet.position), jets.map(|jet| -jet.first.perp().normalize_or_zero()));
        let center = points[POINTS / 2];
        let radius = points.iter().map(|p| p.distance(center)).fold(0.0, f64::max);
        // the cubic correction of inscribed chords is below 1 % here
        let length = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        Self { points, normals, center, radius, length, resolution: Resolution::of(curve, panel) }
    }

    /// Whether the panel's polynomials are too far from the curve: `tail` of an analytic one, `tolerance` of a spline.
    pub fn is_unresolved(&self, tail: f64, tolerance: f64) -> bool {
        match self.resolution {
            Resolution::Tail(share) => share > tail,
            Resolution::Spline { deviation, noise } => deviation > tolerance.max(noise),
        }
    }

    /// Whether the panel is too long, in distances from one of some interior points.
    pub fn is_long_beside(&self, near: &[DVec2], nearness: f64) -> bool {
        near.iter().any(|x| self.length > nearness * self.distance_to(*x))
    }

    /// Whether a part of the panel may lie within this distance of a point.
    pub fn may_be_within(&self, x: DVec2, distance: f64) -> bool {
        self.center.distance(x) <= self.radius + distance
    }

    /// A lower bound of the distance from any part of another panel.
    pub fn gap(&self, other: &Self) -> f64 {
        self.center.distance(other.center) - self.radius - other.radius
    }

    /// The distance across the side in which the problem lives: of points that face each other there.
    pub fn distance_across(&self, other: &Self, problem: Problem) -> f64 {
        let mut least = f64::INFINITY;
        for (p, m) in self.points.iter().zip(self.normals) {
            for (q, n) in other.points.iter().zip(other.normals) {
                let (difference, sign) = (*q - *p, problem.sign());
                let distance = difference.length();
                let is_facing = |towards: f64| sign * towards < -FACING * distance;
                if distance < least && is_facing(m.dot(difference)) && is_facing(-n.dot(difference)) {
                    least = distance;
                }
            }
        }
        least
    }

    /// The distance of a point from the polygon through the panel's points.
    pub fn distance_to(&self, x: DVec2) -> f64 {
        self.points.windows(2).map(|pair| distance_to_segment(x, pair[0], pair[1])).fold(f64::INFINITY, f64::min)
    }
}

fn distance_to_segment(x: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let t = ((x - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    x.distance(a + t * along)
}

/// What a spline leaves open of z′ between its knots, as a share of the jump of z‴ times the square of the interval:
/// √3/216 of it on equal intervals (Hall and Meyer 1976), twice that for uneven ones. Panels need not follow it further,
/// up to `MOST_NOISE`.
const NOISE: f64 = 0.016;
const MOST_NOISE: f64 = 1e-6;

impl Resolution {
    fn of(curve: &Curve, panel: &Panel) -> Self {
        let slopes = match &curve.pieces()[panel.piece] {
            Piece::Line(_) => return Self::Tail(0.0),
            _ => slopes(curve, panel),
        };
        Self::of_spline(curve, panel, &slopes).unwrap_or_else(|| Self::Tail(tail_of_slope(&slopes)))
    }

    /// `None` if it is no spline, or no knot lies inside of the panel.
    fn of_spline(curve: &Curve, panel: &Panel, slopes: &[DVec2; NODES]) -> Option<Self> {
        let &Piece::Spline { ref spline, from, to } = &curve.pieces()[panel.piece] else { return None };
        // measured from the panel's end of the piece
        let ends = if panel.end == End::Start { [from, to] } else { [to, from] };
        let rate = spline.span(ends) / curve.lengths()[panel.piece];
        let rule = Rule::get();
        let [x, y] = [0, 1].map(|i| rule.coefficients(&std::array::from_fn(|k| slopes[k][i])));
        let (mut deviation, mut noise) = (None::<f64>, 0.0_f64);
        for (t, knot) in spline.knots_between(ends, [panel.from, panel.to]) {
            let xi = 2.0 * (t - panel.from) / (panel.to - panel.from) - 1.0;
            let polynomial = DVec2::new(series(&x, xi).0, series(&y, xi).0);
            let slope = rate * spline.slope(knot);
            deviation = Some(deviation.unwrap_or(0.0).max(polynomial.distance(slope) / slope.length()));
            noise = noise.max(NOISE * spline.third_jump(knot) / spline.slope(knot).length());
        }
        deviation.map(|deviation| Self::Spline { deviation, noise: noise.min(MOST_NOISE) })
    }
}

/// dz/dλ at the nodes, in the direction from the panel's end of the piece.
fn slopes(curve: &Curve, panel: &Panel) -> [DVec2; NODES] {
    let leg = Leg::new(curve, panel.piece, panel.end == End::Finish);
    Rule::get().nodes.map(|x| leg.outward(panel.from + 0.5 * (panel.to - panel.from) * (1.0 + x)))
}

/// How far the tangent's last coefficients may be above those of z′. The tangent must be resolved as well: on the blob,
/// whose formula is slow where it bends, panels that resolve only z′ leave errors of 2e-4.
const TANGENT: f64 = 1e-3;

/// The share of the last Legendre coefficients in z′, and `TANGENT` times that in z′/|z′|.
fn tail_of_slope(slopes: &[DVec2; NODES]) -> f64 {
    let tangents = slopes.map(DVec2::normalize_or_zero);
    share_of_tail(slopes).max(TANGENT * share_of_tail(&tangents))
}

/// The larger of both coordinates' last coefficients, in shares of the largest vector.
fn share_of_tail(vectors: &[DVec2; NODES]) -> f64 {
    let rule = Rule::get();
    let largest = vectors.iter().map(|d| d.length()).fold(0.0, f64::max);
    let last = |coordinate: usize| last_two(&rule.coefficients(&std::array::from_fn(|k| vectors[k][coordinate])));
    last(0).max(last(1)) / largest
}

//! Conformal invariants of a domain, each with an error estimate.
//!
//! Every number is computed at two resolutions; the finer one's value is returned, and the difference is its error,
//! with an allowance for rounding, and for what a spline's points leave open of the boundary: moved outwards by δ(s), it
//! has log R and log c larger by 2π ∫ μ² δ ds (Hadamard's formula), μ the density of the measure from x or of equilibrium.
//!
//! | | |
//! |---|---|
//! | conformal radius | log R = ∫ log\|s − x\| dω_x(s) |
//! | capacity | see `capacity` |
//! | modulus | the cross ratio of four disk angles 2πω, then K′/K (`elliptic`) |
//! | hyperbolic distance | 2 artanh e^{−G}, Green's function G = ∫ log\|s − x₂\| dω_{x₁}(s) − log\|x₁ − x₂\| |

use super::capacity::{capacity, moved};
use super::elliptic::modulus;
use super::{BoundaryIntegral, BoundaryIntegralError, Settings};
use crate::geometry::{Curve, CurvePoint, DVec2, Piece};

/// A number with an estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// A bound of the error that is expected to hold; not negative.
    pub error: f64,
}

/// What is wanted of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct InvariantsRequest {
    point: DVec2,
    second_point: Option<DVec2>,
    marks: Option<[CurvePoint; 4]>,
}

impl InvariantsRequest {
    /// The invariants that `point` determines.
    pub fn new(point: DVec2) -> Self {
        Self { point, second_point: None, marks: None }
    }

    /// Also the hyperbolic distance to a second point.
    #[must_use]
    pub fn with_second_point(mut self, point: Option<DVec2>) -> Self {
        self.second_point = point;
        self
    }

    /// Also the modulus of the quadrilateral with these vertices, in counter-clockwise cyclic order.
    #[must_use]
    pub fn with_marks(mut self, marks: Option<[CurvePoint; 4]>) -> Self {
        self.marks = marks;
        self
    }
}

/// Conformal invariants.
#[derive(Debug, Clone, PartialEq)]
pub struct Invariants {
    /// The harmonic measure of each piece of the curve from the point.
    pub pieces: Vec<Estimate>,
    /// The harmonic measures of the arcs from mark to mark, the last one from the fourth mark to the first.
    pub arcs: Option<[Estimate; 4]>,
    /// |f′(0)| of the conformal map f from the unit disk with f(0) the point.
    pub conformal_radius: Estimate,
    /// The logarithmic capacity of the curve.
    pub capacity: Estimate,
    /// The extremal distance between the arc from mark 1 to 2 and the arc from mark 3 to 4, as seen from the point: of long
    /// quadrilaterals, and from points next to a mark, little is seen (`Quadrilateral` looks for points that see it).
    pub modulus: Option<Estimate>,
    /// The distance to the second point in the metric of curvature −1.
    pub hyperbolic_distance: Option<Estimate>,
    /// The numbers of unknowns of the coarser and the finer resolution.
    pub unknowns: [usize; 2],
}

impl Invariants {
    /// The measures of sides that consist of so many consecutive pieces each.
    pub fn of_sides(&self, counts: &[usize]) -> Vec<Estimate> {
        let mut rest = &self.pieces[..];
        let mut side = |&count: &usize| {
            let (pieces, after) = rest.split_at(count.min(rest.len()));
            rest = after;
            let sum = |of: fn(&Estimate) -> f64| pieces.iter().map(of).sum();
            Estimate { value: sum(|piece| piece.value), error: sum(|piece| piece.error) }
        };
        counts.iter().map(&mut side).collect()
    }
}

/// The numbers at one resolution.
struct Numbers {
    pieces: Vec<f64>,
    arcs: Option<[f64; 4]>,
    log_radius: f64,
    green: Option<f64>,
    /// What the points of a spline leave open.
    open: Open,
    /// What the measure violates its identities by.
    violation: f64,
    /// The places of the nodes.
    places: Vec<DVec2>,
}

/// Errors by what the points of splines leave open of the boundary; 0 without splines.
#[derive(Debug, Clone, Copy, Default)]
struct Open {
    measure: f64,
    log_radius: f64,
}

/// Rounding of sums of a thousand terms of order 1: on regular polygons, rectangles, ellipses and the L-shape the
/// logarithms are off by up to 11 units of rounding.
const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// The difference of two resolutions, this many times.
const SAFETY: f64 = 2.0;

/// Computes the invariants. Fails if a point is not inside, or if the curve needs too many unknowns.
pub fn invariants(curve: &Curve, request: &InvariantsRequest) -> Result<Invariants, BoundaryIntegralError> {
    let points: Vec<DVec2> = [Some(request.point), request.second_point].into_iter().flatten().collect();
    if let Some(&at) = points.iter().find(|x| !curve.contains(**x)) {
        return Err(BoundaryIntegralError::NotInside { at });
    }
    let settings = Settings::default().with_points(&points);
    let coarse = Numbers::compute(curve, request, &settings)?;
    let fine = Numbers::compute(curve, request, &settings.finer())?;
    // the distance between a point and the boundary is known to rounding of their coordinates
    let condition = points.iter().map(|x| 0.25 * curve.perimeter() / fine.distance(*x)).fold(1.0, f64::max);
    let (open, violation) = (fine.open, fine.violation);
    let beside = open.measure + violation;
    let radius = both(coarse.log_radius, fine.log_radius, condition).wider(open.log_radius + beside).exp();
    let measure = |a: f64, b: f64| measure(a, b).wider(beside).in_unit_interval();
    let pairs = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| measure(*a, *b)).collect::<Vec<_>>();
    let marked = coarse.arcs.zip(fine.arcs);
    Ok(Invariants {
        pieces: pairs(&coarse.pieces, &fine.pieces),
        arcs: marked.map(|(a, b)| std::array::from_fn(|k| measure(a[k], b[k]))),
        conformal_radius: radius,
        capacity: capacity(curve)?,
        modulus: marked.map(|(a, b)| modulus_of_both(a, b).wider(modulus_change(b, beside))),
        hyperbolic_distance: match request.second_point {
            Some(second) if second == request.point => Some(Estimate { value: 0.0, error: 0.0 }),
            _ => coarse
                .green
                .zip(fine.green)
                .map(|(a, b)| both(a, b, 1.0).wider(beside.max(open.log_radius)).hyperbolic(condition)),
        },
        unknowns: [coarse.places.len(), fine.places.len()],
    })
}

/// The finer of two logarithms, with their difference as error.
pub(super) fn both(coarse: f64, fine: f64, condition: f64) -> Estimate {
    Estimate { value: fine, error: SAFETY * (fine - coarse).abs() + ROUNDING * fine.abs().max(condition) }
}

/// Rounding of a harmonic measure, however small: 1e-17 to 5e-17 for the ends of the 10×1 rectangle.
const MEASURE_ROUNDING: f64 = 0.25 * f64::EPSILON;

/// As `both`, for a measure.
fn measure(coarse: f64, fine: f64) -> Estimate {
    let rounding = ROUNDING * fine.abs() + MEASURE_ROUNDING;
    Estimate { value: fine, error: SAFETY * (fine - coarse).abs() + rounding }
}

/// The [modulus](super::modulus) of the arcs at the finer of two resolutions; its error is the difference of both, and what
/// the errors of the arcs do to the finer one.
pub fn modulus_of_both(coarse: [f64; 4], fine: [f64; 4]) -> Estimate {
    let value = modulus(fine);
    let rounding = modulus_change(fine, MEASURE_ROUNDING);
    Estimate { value, error: SAFETY * (value - modulus(coarse)).abs() + rounding + ROUNDING * value }
}

/// How much an error of each arc's measure changes the modulus.
fn modulus_change(arcs: [f64; 4], error: f64) -> f64 {
    if error == 0.0 {
        return 0.0;
    }
    let value = modulus(arcs);
    let changed = |k: usize| {
        let mut moved = arcs;
        moved[k] += error;
        (modulus(moved) - value).abs()
    };
    (0..4).map(changed).sum()
}

impl Estimate {
    /// With a larger error.
    pub(super) fn wider(self, by: f64) -> Self {
        Self { error: self.error + by, ..self }
    }

    /// A measure: what rounding has left outside of [0, 1] counts as its error.
    fn in_unit_interval(self) -> Self {
        let value = self.value.clamp(0.0, 1.0);
        Self { value, error: self.error + (value - self.value).abs() }
    }

    pub(super) fn exp(self) -> Self {
        let value = self.value.exp();
        Self { value, error: value * self.error.exp_m1() }
    }

    /// 2 artanh e^{−G} = log coth(G/2) of Green's function G, which is proportional to the distance from the boundary next to it.
    fn hyperbolic(self, condition: f64) -> Self {
        let distance = |green: f64| -(0.5 * green).tanh().ln();
        let (value, error) = (distance(self.value), self.error + ROUNDING * condition * self.value.abs());
        // convex and decreasing in G: the larger error is towards 0
        let nearer = if self.value > error { distance(self.value - error) - value } else { f64::INFINITY };
        Self { value, error: nearer + ROUNDING * value }
    }
}

impl Numbers {
    fn compute(curve: &Curve, request: &InvariantsRequest, settings: &Settings) -> Result<Self, BoundaryIntegralError> {
        let x = request.point;
        let integral = BoundaryIntegral::prepare(curve, settings)?;
        let measure = integral.harmonic_measure(x)?;
        let swept = integral.swept(x);
        let arcs = request.marks.map(|marks| [0, 1, 2, 3].map(|k| measure.between(marks[k], marks[(k + 1) % 4])));
        Ok(Self {
            open: Open {
                measure: if has_splines(curve) { measure.error_estimate() } else { 0.0 },
                log_radius: moved(curve, (&integral.layout, &integral.system), &swept),
            },
            violation: measure.violation(),
            pieces: measure.pieces(),
            arcs,
            log_radius: integral.system.logarithm(&swept, x),
            green: request.second_point.map(|y| integral.system.logarithm(&swept, y) - x.distance(y).ln()),
            places: integral.system.places().collect(),
        })
    }

    fn distance(&self, x: DVec2) -> f64 {
        self.places.iter().map(|place| place.distance(x)).fold(f64::INFINITY, f64::min)
    }
}

pub(super) fn has_splines(curve: &Curve) -> bool {
    curve.pieces().iter().any(|piece| matches!(piece, Piece::Spline { .. }))
}

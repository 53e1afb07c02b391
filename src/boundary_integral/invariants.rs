//! Conformal invariants of a domain, each with an error estimate.
//!
//! Every number is computed at two resolutions; the finer one's value is returned, and the difference is its error,
//! with an allowance for rounding, and for what a spline's points leave open of the boundary: moved outwards by δ(s), it
//! has log R and log c larger by 2π ∫ μ² δ ds (Hadamard's formula), μ the density of the measure from x or of equilibrium.
//!
//! | | |
//! |---|---|
//! | conformal radius | log R = ∫ log\|s − x\| dω_x(s) |
//! | capacity | log c = ∫ log\|s − x\| dμ(s) for any x inside, μ the equilibrium measure, (½ I + K*) μ = 0, ∫ dμ = 1 |
//! | modulus | the cross ratio of four disk angles 2πω, then K′/K (`elliptic`) |
//! | hyperbolic distance | 2 artanh e^{−G}, Green's function G = ∫ log\|s − x₂\| dω_{x₁}(s) − log\|x₁ − x₂\| |

use super::elliptic::modulus;
use super::legendre::{NODES, Rule};
use super::peak::peaks;
use super::spans::left_open;
use super::{BoundaryIntegral, BoundaryIntegralError, MAX_UNKNOWNS, Problem, Settings, System};
use crate::geometry::{Curve, CurvePoint, DVec2, Piece};
use std::f64::consts::TAU;

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
    max_unknowns: usize,
}

impl InvariantsRequest {
    /// The invariants that `point` determines.
    pub fn new(point: DVec2) -> Self {
        Self { point, second_point: None, marks: None, max_unknowns: MAX_UNKNOWNS }
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

    /// The limit of the number of unknowns of the finer resolution.
    #[must_use]
    pub fn with_max_unknowns(mut self, max_unknowns: usize) -> Self {
        self.max_unknowns = max_unknowns;
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
    /// The extremal distance between the arc from mark 1 to 2 and the arc from mark 3 to 4.
    pub modulus: Option<Estimate>,
    /// The distance to the second point in the metric of curvature −1.
    pub hyperbolic_distance: Option<Estimate>,
    /// The numbers of unknowns of the coarser and the finer resolution.
    pub unknowns: [usize; 2],
}

/// The numbers at one resolution.
struct Numbers {
    pieces: Vec<f64>,
    arcs: Option<[f64; 4]>,
    log_radius: f64,
    log_capacity: f64,
    green: Option<f64>,
    /// What the points of a spline leave open.
    open: Open,
    /// The places of the nodes.
    places: Vec<DVec2>,
}

/// Errors by what the points of splines leave open of the boundary; 0 without splines.
#[derive(Debug, Clone, Copy, Default)]
struct Open {
    measure: f64,
    log_radius: f64,
    log_capacity: f64,
}

impl Open {
    /// From the measure at one resolution, and the charges of the measure and of equilibrium.
    fn new(integral: &BoundaryIntegral, measure: f64, [swept, equilibrium]: [&[f64]; 2]) -> Self {
        if !integral.curve.pieces().iter().any(|piece| matches!(piece, Piece::Spline { .. })) {
            return Self::default();
        }
        let lengths = integral.system.panel_lengths();
        let open: Vec<f64> = integral.layout.panels.iter().map(|panel| left_open(&integral.curve, panel)).collect();
        let moved = |charges: &[f64]| {
            let at = |(k, charge): (usize, &f64)| {
                let (panel, weight) = (k / NODES, 0.5 * Rule::get().weights[k % NODES]);
                charge * charge * open[panel] / (weight * lengths[panel])
            };
            TAU * charges.iter().enumerate().map(at).sum::<f64>()
        };
        Self { measure, log_radius: moved(swept) + measure, log_capacity: moved(equilibrium) + measure }
    }
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
    let settings = Settings::default().with_points(&points).with_max_unknowns(request.max_unknowns);
    let coarse = Numbers::compute(curve, request, &settings)?;
    let fine = Numbers::compute(curve, request, &settings.finer())?;
    // the distance between a point and the boundary is known to rounding of their coordinates
    let condition = points.iter().map(|x| 0.25 * curve.perimeter() / fine.distance(*x)).fold(1.0, f64::max);
    let open = fine.open;
    let radius = both(coarse.log_radius, fine.log_radius, condition).wider(open.log_radius).exp();
    let measure = |a: f64, b: f64| measure(a, b).wider(open.measure);
    let pairs = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| measure(*a, *b)).collect::<Vec<_>>();
    let marked = coarse.arcs.zip(fine.arcs);
    Ok(Invariants {
        pieces: pairs(&coarse.pieces, &fine.pieces),
        arcs: marked.map(|(a, b)| std::array::from_fn(|k| measure(a[k], b[k]))),
        conformal_radius: radius,
        capacity: both(coarse.log_capacity, fine.log_capacity, 1.0).wider(open.log_capacity).exp(),
        modulus: marked.map(|(a, b)| modulus_of_both(a, b).wider(modulus_change(b, open.measure))),
        hyperbolic_distance: match request.second_point {
            Some(second) if second == request.point => Some(Estimate { value: 0.0, error: 0.0 }),
            _ => coarse
                .green
                .zip(fine.green)
                .map(|(a, b)| both(a, b, 1.0).wider(open.measure.max(open.log_radius)).hyperbolic(condition)),
        },
        unknowns: [coarse.places.len(), fine.places.len()],
    })
}

/// The finer of two logarithms, with their difference as error.
fn both(coarse: f64, fine: f64, condition: f64) -> Estimate {
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
    fn wider(self, by: f64) -> Self {
        Self { error: self.error + by, ..self }
    }

    fn exp(self) -> Self {
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
        let exterior = System::new(curve, &integral.layout, Problem::Exterior);
        let equilibrium = exterior.charges(&exterior.equilibrium());
        let total: f64 = equilibrium.iter().sum();
        if !(total.is_finite() && total > 0.0) {
            return Err(BoundaryIntegralError::Singular);
        }
        let arcs = request.marks.map(|marks| [0, 1, 2, 3].map(|k| measure.between(marks[k], marks[(k + 1) % 4])));
        let green = |second: DVec2| integral.logarithmic_mean(x, second) - x.distance(second).ln();
        let swept =
            integral.system.charges(&integral.system.harmonic(x, &peaks(curve, &integral.layout, &integral.system, x)));
        let open = Open::new(
            &integral,
            measure.error_estimate(),
            [&swept, &equilibrium.iter().map(|q| q / total).collect::<Vec<f64>>()],
        );
        Ok(Self {
            pieces: measure.pieces(),
            open,
            arcs,
            log_radius: integral.logarithmic_mean(x, x),
            log_capacity: exterior.logarithm(&equilibrium, x) / total,
            green: request.second_point.map(green),
            places: integral.system.places().collect(),
        })
    }

    fn distance(&self, x: DVec2) -> f64 {
        self.places.iter().map(|place| place.distance(x)).fold(f64::INFINITY, f64::min)
    }
}

//! Harmonic measure along one interval of a piece: a Legendre series, or a power next to a corner.

use super::layout::End;
use super::legendre::{Rule, Values, series};
use super::peak::{Peak, PeakAt};
use crate::geometry::CurvePoint;
use std::sync::Arc;

/// The measure on the parameters [from, to] of a piece, counted from one of its ends.
#[derive(Debug, Clone)]
pub struct Span {
    pub piece: usize,
    pub end: End,
    pub from: f64,
    pub to: f64,
    pub measure: f64,
    shape: Shape,
    /// What the density exceeds the shape by, next to the interior point, and this at `from`.
    peak: Option<(Arc<Peak>, PeakAt)>,
    rounding: Rounding,
}

/// The error that rounding leaves in the density of a span.
#[derive(Debug, Clone, Copy)]
pub enum Rounding {
    /// Everywhere so much of dω/dξ.
    Density(f64),
    /// So much of the density itself: a corner's, whose leg has this measure in all.
    Corner { relative: f64, measure: f64 },
}

/// The measure next to a point, on one of its sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beside {
    /// The measure of the panel, or of the leg of a corner, that begins or ends at the point or contains it.
    pub measure: f64,
    /// The error of the density at the point, in densities: what rounding leaves, or the floor of all densities.
    pub error: f64,
}

#[derive(Debug, Clone)]
enum Shape {
    /// dω/dξ as a Legendre series, ξ from −1 at `from` to 1 at `to`.
    Series(Box<Values>),
    /// ω is proportional to this power of the parameter; `from` is 0.
    Power(f64),
}

/// Up to this ξ + 1, the differences of polynomials that integrate a series lose 6 bits and more.
const NEAR_END: f64 = 1.0 / 64.0;

/// The value at ξ = u − 1 of a series, and its integral from −1, right in proportion to itself.
fn up_to(coefficients: &Values, u: f64) -> (f64, f64) {
    let (value, integral) = series(coefficients, u - 1.0);
    if u > NEAR_END {
        return (value, integral);
    }
    let rule = Rule::get();
    let at = |(x, w): (&f64, f64)| w * series(coefficients, 0.5 * u * (1.0 + x) - 1.0).0;
    (value, 0.5 * u * rule.nodes.iter().zip(rule.weights).map(at).sum::<f64>())
}

/// Steps of Newton's method, or bisections, to a place in a span.
const MOST_STEPS: u32 = 100;
/// A step of Newton's method, in shares of place and measure, whose square is rounding.
const LAST_STEP: f64 = 1e-9;

impl Span {
    /// From the values of dω/dξ at the nodes.
    pub fn new(piece: usize, end: End, [from, to]: [f64; 2], values: &Values, rounding: Rounding) -> Self {
        let rule = Rule::get();
        let measure = values.iter().zip(rule.weights).map(|(v, w)| v * w).sum();
        Self {
            piece,
            end,
            from,
            to,
            measure,
            shape: Shape::Series(Box::new(rule.coefficients(values))),
            peak: None,
            rounding,
        }
    }

    /// The rest of a corner, [0, to], where ω is proportional to a power of the distance.
    pub fn rest(piece: usize, end: End, to: f64, measure: f64, exponent: f64, rounding: Rounding) -> Self {
        Self { piece, end, from: 0.0, to, measure, shape: Shape::Power(exponent), peak: None, rounding }
    }

    /// The measure next to a point of the span.
    pub fn beside(&self, point: CurvePoint) -> Beside {
        match (self.rounding, &self.shape) {
            (Rounding::Density(error), Shape::Series(coefficients)) => {
                let density = self.up_to(coefficients, self.along(self.parameter_of(point)).clamp(0.0, 2.0)).0;
                Beside { measure: self.measure, error: error / density.max(0.0) }
            }
            (Rounding::Density(_), Shape::Power(_)) => Beside { measure: self.measure, error: f64::EPSILON },
            (Rounding::Corner { relative, measure }, _) => Beside { measure, error: relative },
        }
    }

    /// The parameter of a point, counted from the span's own end of the piece.
    fn parameter_of(&self, point: CurvePoint) -> f64 {
        match self.end {
            End::Start => point.from_start(),
            End::Finish => point.to_end(),
        }
    }

    /// The place of a parameter in the span, ξ + 1, from 0 to 2.
    fn along(&self, parameter: f64) -> f64 {
        2.0 * (parameter - self.from) / (self.to - self.from)
    }

    /// With the peak of the panel that the span belongs to.
    #[must_use]
    pub fn with_peak(mut self, peak: Option<&Arc<Peak>>) -> Self {
        if let (Some(peak), Shape::Series(_)) = (peak, &self.shape) {
            let start = peak.at(self.from);
            self.measure += peak.between(&start, &peak.at(self.to));
            self.peak = Some((Arc::clone(peak), start));
        }
        self
    }

    /// The Legendre coefficients of dω/dξ, of spans without a peak.
    pub fn coefficients(&self) -> Option<&Values> {
        match &self.shape {
            Shape::Series(coefficients) if self.peak.is_none() => Some(coefficients),
            _ => None,
        }
    }

    /// dω/dξ at ξ = u − 1, and the measure up to there.
    fn up_to(&self, coefficients: &Values, u: f64) -> (f64, f64) {
        let (value, integral) = up_to(coefficients, u);
        let Some((peak, start)) = &self.peak else { return (value, integral) };
        let half = 0.5 * (self.to - self.from);
        let here = peak.at(self.from + half * u);
        (value + half * here.density, integral + peak.between(start, &here))
    }

    /// The first point, in the direction of the curve.
    pub fn start(&self) -> CurvePoint {
        match self.end {
            End::Start => CurvePoint::new(self.piece, self.from),
            End::Finish => CurvePoint::before_end(self.piece, self.to),
        }
    }

    /// The last point, in the direction of the curve.
    pub fn finish(&self) -> CurvePoint {
        match self.end {
            End::Start => CurvePoint::new(self.piece, self.to),
            End::Finish => CurvePoint::before_end(self.piece, self.from),
        }
    }

    /// Whether the span lies before the point, in the direction of the curve.
    pub fn is_before(&self, point: CurvePoint) -> bool {
        match self.end {
            End::Start => self.to < point.from_start(),
            End::Finish => self.from > point.to_end(),
        }
    }

    /// The measure of the span's part up to the parameter, counted from the span's own end of the piece.
    fn near_end(&self, parameter: f64) -> f64 {
        let value = match &self.shape {
            Shape::Series(coefficients) => {
                let u = self.along(parameter);
                if u >= 2.0 {
                    return self.measure;
                }
                self.up_to(coefficients, u.max(0.0)).1
            }
            Shape::Power(exponent) => self.measure * (parameter / self.to).clamp(0.0, 1.0).powf(*exponent),
        };
        // rounding may leave a density of either sign where the measure is almost nothing
        value.clamp(self.measure.min(0.0), self.measure.max(0.0))
    }

    /// The measure of the span before and after the point, in the direction of the curve.
    pub fn parts(&self, point: CurvePoint) -> [f64; 2] {
        let near = self.near_end(self.parameter_of(point));
        match self.end {
            End::Start => [near, self.measure - near],
            End::Finish => [self.measure - near, near],
        }
    }

    /// The measure between two points of the span, positive or negative.
    pub fn between(&self, a: CurvePoint, b: CurvePoint) -> f64 {
        let [a, b] = [a, b].map(|point| self.near_end(self.parameter_of(point)));
        if self.end == End::Start { b - a } else { a - b }
    }

    /// The point with this measure before it (`is_after` false) or after it in the span.
    pub fn point(&self, measure: f64, is_after: bool) -> CurvePoint {
        let is_near = is_after == (self.end == End::Finish);
        let near = if is_near { measure } else { self.measure - measure };
        let parameter = self.parameter(near.clamp(0.0, self.measure.max(0.0)));
        match self.end {
            End::Start => CurvePoint::new(self.piece, parameter),
            End::Finish => CurvePoint::before_end(self.piece, parameter),
        }
    }

    /// The parameter with this measure between it and the span's end of the piece.
    fn parameter(&self, near: f64) -> f64 {
        if self.measure <= 0.0 {
            return self.from;
        }
        let coefficients = match &self.shape {
            Shape::Power(exponent) => return self.to * (near / self.measure).powf(1.0 / exponent),
            Shape::Series(coefficients) => coefficients,
        };
        let (mut low, mut high) = (0.0, 2.0);
        let (mut u, mut last_step) = (2.0 * near / self.measure, 2.0);
        for _ in 0..MOST_STEPS {
            let (density, below) = self.up_to(coefficients, u);
            if below > near {
                high = u;
            } else {
                low = u;
            }
            let (before, newton) = (u, u - (below - near) / density);
            // steps that do not halve may go to and fro for ever
            let is_newton = newton >= low && newton <= high && (newton - u).abs() <= 0.5 * last_step;
            u = if is_newton { newton } else { 0.5 * (low + high) };
            last_step = (u - before).abs();
            // on a narrow peak a small step may be a large difference of measures
            let is_last = is_newton && last_step <= LAST_STEP * u && (below - near).abs() <= LAST_STEP * near;
            if is_last || last_step <= f64::EPSILON * u {
                break;
            }
        }
        self.from + 0.5 * (self.to - self.from) * u
    }
}

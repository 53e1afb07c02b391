//! Harmonic measure along one interval of a piece: a Legendre series, or a power next to a corner.

use super::layout::End;
use super::legendre::{Rule, Values, series};
use super::peak::Peak;
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
    /// What the density exceeds the shape by, next to the interior point, and the measure of that on the panel before
    /// `from`.
    peak: Option<(Arc<Peak>, f64)>,
}

#[derive(Debug, Clone)]
enum Shape {
    /// dω/dξ as a Legendre series, ξ from −1 at `from` to 1 at `to`.
    Series(Box<Values>),
    /// ω is proportional to this power of the parameter; `from` is 0.
    Power(f64),
}

/// Steps of Newton's method, or bisections, to a place in a span.
const MOST_STEPS: u32 = 100;

impl Span {
    /// From the values of dω/dξ at the nodes.
    pub fn new(piece: usize, end: End, [from, to]: [f64; 2], values: &Values) -> Self {
        let rule = Rule::get();
        let measure = values.iter().zip(rule.weights).map(|(v, w)| v * w).sum();
        Self { piece, end, from, to, measure, shape: Shape::Series(Box::new(rule.coefficients(values))), peak: None }
    }

    /// The rest of a corner, [0, to], where ω is proportional to a power of the distance.
    pub fn rest(piece: usize, end: End, to: f64, measure: f64, exponent: f64) -> Self {
        Self { piece, end, from: 0.0, to, measure, shape: Shape::Power(exponent), peak: None }
    }

    /// With the peak of the panel that the span belongs to.
    #[must_use]
    pub fn with_peak(mut self, peak: Option<&Arc<Peak>>) -> Self {
        if let (Some(peak), Shape::Series(_)) = (peak, &self.shape) {
            let before = peak.excess(self.from);
            self.measure += peak.excess(self.to) - before;
            self.peak = Some((Arc::clone(peak), before));
        }
        self
    }

    /// The Legendre coefficients of dω/dξ, of spans inside of a block and of those without a peak.
    pub fn coefficients(&self) -> Option<&Values> {
        match &self.shape {
            Shape::Series(coefficients) if self.peak.is_none() => Some(coefficients),
            _ => None,
        }
    }

    /// The first point, in the direction of the curve.
    pub fn start(&self) -> CurvePoint {
        match self.end {
            End::Start => CurvePoint::new(self.piece, self.from),
            End::Finish => CurvePoint::before_end(self.piece, self.to),
        }
    }

    /// Whether the span lies before the point, in the direction of the curve.
    pub fn is_before(&self, point: CurvePoint) -> bool {
        match self.end {
            End::Start => self.to < point.from_start(),
            End::Finish => self.from > point.to_end(),
        }
    }

    /// The part of the peak from the span's first parameter on.
    fn excess(&self, parameter: f64) -> f64 {
        self.peak.as_ref().map_or(0.0, |(peak, before)| peak.excess(parameter) - before)
    }

    /// The measure of the span's part up to the parameter, counted from the span's own end of the piece.
    fn near_end(&self, parameter: f64) -> f64 {
        let value = match &self.shape {
            Shape::Series(coefficients) => {
                let xi = 2.0 * (parameter - self.from) / (self.to - self.from) - 1.0;
                if xi >= 1.0 {
                    return self.measure;
                }
                series(coefficients, xi.max(-1.0)).1 + self.excess(parameter)
            }
            Shape::Power(exponent) => self.measure * (parameter / self.to).clamp(0.0, 1.0).powf(*exponent),
        };
        // rounding may leave a density of either sign where the measure is almost nothing
        value.clamp(self.measure.min(0.0), self.measure.max(0.0))
    }

    /// The measure of the span before and after the point, in the direction of the curve.
    pub fn parts(&self, point: CurvePoint) -> [f64; 2] {
        match self.end {
            End::Start => {
                let near = self.near_end(point.from_start());
                [near, self.measure - near]
            }
            End::Finish => {
                let near = self.near_end(point.to_end());
                [self.measure - near, near]
            }
        }
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
        let (mut low, mut high) = (-1.0, 1.0);
        let mut xi = 2.0 * near / self.measure - 1.0;
        for _ in 0..MOST_STEPS {
            let (mut density, mut below) = series(coefficients, xi);
            if let Some((peak, _)) = &self.peak {
                let parameter = self.at(xi);
                density += 0.5 * (self.to - self.from) * peak.density(parameter);
                below += self.excess(parameter);
            }
            if below > near {
                high = xi;
            } else {
                low = xi;
            }
            let next = xi - (below - near) / density;
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if (next - xi).abs() <= f64::EPSILON {
                break;
            }
            xi = next;
        }
        self.at(xi)
    }

    fn at(&self, xi: f64) -> f64 {
        self.from + 0.5 * (self.to - self.from) * (1.0 + xi)
    }
}

//! The division of a curve into panels on which a function is resolved.
//!
//! The curve is cut at its junctions, at the function's break points and in the middle of each piece, and bisected until
//! on each panel the last Legendre coefficients of the function are below rounding, or below the function's own errors.
//! Next to a break point that leads to panels whose lengths halve from one to the next.

use super::panel::{End, Panel, Sampled, Stretch};
use super::rule::NODES;
use super::{BoundaryFunction, CauchyIntegral, Complex};
use crate::geometry::{Curve, CurvePoint, sort_by_number};

/// The most panels. Presets need 200 to 1,500.
const MOST_PANELS: usize = 16_384;
/// Last coefficients that count as rounding, in extents of the values: those of computed values are 2e-16 of them.
const RESOLVED: f64 = 2e-15;
/// The same for positions, in lengths of a panel, beside the rounding of positions.
const RESOLVED_POSITIONS: f64 = 1e-13;
/// Two interpolations of the values differ by no more than this multiple of their errors, at the ends of a panel.
const MISMATCH: f64 = 64.0;
/// Values are not resolved below this multiple of their error.
const NOISE: f64 = 2.0;
/// The largest last coefficients that may be due to errors, relative to the variation of the values. Next to an
/// algebraic singular point they are above 1e-4 of it.
const NOISY: f64 = 1e-7;
/// What a bisection leaves at least of last coefficients that are due to errors.
const STANDSTILL: f64 = 0.25;
/// The largest change of the unit tangent along a panel; F is then as well resolved in position as in the parameter.
const MOST_BEND: f64 = 0.8;
/// A panel whose length times the variation of the function is below this, in extents of curve and function, is not
/// divided: 1e-9 away from it, what is not resolved there changes an integral by 1e-16.
const NEGLIGIBLE: f64 = 1e-25;
/// The shortest panel in terms of its distance from the end of the piece: parameters are only so exact.
const SHORTEST: f64 = 64.0 * f64::EPSILON;
/// The shortest panel of all, in parameters.
const LEAST: f64 = 1e-40;
/// Break points nearer than this to an end of a piece, in parameters, coincide with it.
const SAME_POINT: f64 = 1e-14;
/// A piece is cut in its middle unless there is a break point about there.
const MIDDLE: [f64; 2] = [0.45, 0.55];

/// A stretch to sample, and the tail on the stretch that it is a half of.
#[derive(Debug, Clone)]
struct Waiting {
    stretch: Stretch,
    parent_tail: f64,
}

/// The division of a curve, in progress.
#[derive(Debug, Clone)]
pub struct Division {
    curve: Curve,
    /// The stretches that are not resolved yet; the next one is the last.
    waiting: Vec<Waiting>,
    /// The values on the stretches that it began with, until [`Self::measure_values`] is complete.
    first: Vec<Complex>,
    is_measured: bool,
    center: Complex,
    extent: f64,
    magnitude: f64,
    panels: Vec<Panel>,
}

impl Division {
    /// Begins to divide a curve for a function that is not analytic at `breaks`.
    pub fn new(curve: &Curve, breaks: &[CurvePoint]) -> Self {
        let stretches: Vec<Stretch> = (0..curve.pieces().len()).flat_map(|k| stretches(k, breaks)).collect();
        let waiting = |stretch| Waiting { stretch, parent_tail: f64::INFINITY };
        Self {
            curve: curve.clone(),
            waiting: stretches.into_iter().rev().map(waiting).collect(),
            first: Vec::new(),
            is_measured: false,
            center: Complex::ZERO,
            extent: 0.0,
            magnitude: 0.0,
            panels: Vec::new(),
        }
    }

    /// Continues until the curve is divided (true) or `is_over` says so, which is asked after each stretch. All calls
    /// need the same function; the result does not depend on their number.
    pub fn advance(&mut self, function: &dyn BoundaryFunction, is_over: &mut dyn FnMut() -> bool) -> bool {
        if !self.is_measured && !self.measure_values(function, is_over) {
            return false;
        }
        while let Some(Waiting { stretch, parent_tail }) = self.waiting.pop() {
            let sampled = Sampled::new(&self.curve, stretch, function);
            let is_last = self.panels.len() + self.waiting.len() >= MOST_PANELS;
            if !self.take(function, &sampled, parent_tail, is_last) {
                let parent_tail = sampled.tail();
                self.waiting.extend(stretch.halves().into_iter().rev().map(|stretch| Waiting { stretch, parent_tail }));
            }
            if is_over() {
                break;
            }
        }
        self.waiting.is_empty()
    }

    /// Finds center and extent of the values; returns whether that is complete.
    fn measure_values(&mut self, function: &dyn BoundaryFunction, is_over: &mut dyn FnMut() -> bool) -> bool {
        while let Some(Waiting { stretch, .. }) = self.waiting.iter().nth_back(self.first.len() / NODES) {
            self.first.extend(Sampled::new(&self.curve, *stretch, function).values);
            if is_over() {
                return false;
            }
        }
        let first = std::mem::take(&mut self.first);
        self.center = first.iter().sum::<Complex>() / first.len() as f64;
        self.extent = first.iter().map(|value| (value - self.center).norm()).fold(0.0, f64::max);
        self.magnitude = self.center.norm() + self.extent;
        self.is_measured = true;
        true
    }

    /// The integral over the panels, once the curve is divided.
    pub fn finish(self) -> CauchyIntegral {
        let Self { curve, panels, center, magnitude, extent, .. } = self;
        CauchyIntegral { curve, panels, center, magnitude, extent }
    }

    /// Makes a panel of the samples if they are enough, or cannot be more.
    fn take(&mut self, function: &dyn BoundaryFunction, sampled: &Sampled, parent_tail: f64, is_last: bool) -> bool {
        let (tail, rounding, is_plain) = (sampled.tail(), self.rounding(sampled), self.is_plain(sampled));
        let is_small = is_plain && self.is_small(sampled);
        let is_final = is_last || is_small || is_shortest(sampled);
        if !is_final && !is_plain {
            return false;
        }
        let error = sampled.function_error(&self.curve, function);
        let noise = if is_noise(sampled, parent_tail) { tail } else { NOISE * error };
        if !is_final && tail > rounding.max(noise) {
            return false;
        }
        let panel = Panel::new(&self.curve, sampled, self.center, error + f64::EPSILON * self.magnitude);
        if !is_final && panel.mismatch > MISMATCH * rounding.max(noise) {
            return false;
        }
        let error = panel.error + tail + panel.mismatch / MISMATCH;
        self.panels.push(Panel { error, ..panel });
        true
    }

    /// The rounding of values, also by that of the parameters.
    fn rounding(&self, sampled: &Sampled) -> f64 {
        let Stretch { from, to, .. } = sampled.stretch;
        let of_parameters = if from == 0.0 { 0.0 } else { 4.0 * f64::EPSILON * to / (to - from) };
        RESOLVED * self.extent + f64::EPSILON * self.magnitude + of_parameters * sampled.variation()
    }

    /// Whether the panel's shape is resolved.
    fn is_plain(&self, sampled: &Sampled) -> bool {
        let rounding = 4.0 * f64::EPSILON * (self.curve.perimeter() + sampled.distance_from_origin(&self.curve));
        sampled.bend() <= MOST_BEND && sampled.tail_of_positions() <= RESOLVED_POSITIONS * sampled.length() + rounding
    }

    /// Whether what is not resolved on the panel does not matter.
    fn is_small(&self, sampled: &Sampled) -> bool {
        sampled.variation() * sampled.length() <= NEGLIGIBLE * self.extent * self.curve.perimeter()
    }
}

/// Whether the parameters of a half could not be told apart.
fn is_shortest(sampled: &Sampled) -> bool {
    let Stretch { from, to, .. } = sampled.stretch;
    to - from <= SHORTEST * from || to <= LEAST
}

/// Whether the last coefficients are due to errors of the values: small, and not less than before the last bisection,
/// which divides those of a resolved function by 1,000 and more.
fn is_noise(sampled: &Sampled, parent_tail: f64) -> bool {
    let tail = sampled.tail();
    tail <= NOISY * sampled.variation() && tail >= STANDSTILL * parent_tail
}

/// The stretches of a piece between its ends, its middle and the break points on it, in the order of the curve.
fn stretches(piece: usize, breaks: &[CurvePoint]) -> Vec<Stretch> {
    let is_inside =
        |point: &&CurvePoint| point.piece() == piece && point.from_start() > SAME_POINT && point.to_end() > SAME_POINT;
    let mut inner: Vec<CurvePoint> = breaks.iter().filter(is_inside).copied().collect();
    let [low, high] = MIDDLE;
    if !inner.iter().any(|point| (low..=high).contains(&point.from_start())) {
        inner.push(CurvePoint::new(piece, 0.5));
    }
    sort_by_number(&mut inner, |point| -point.to_end());
    sort_by_number(&mut inner, CurvePoint::from_start);
    inner.dedup_by(|a, b| a.from_start() == b.from_start() && a.to_end() == b.to_end());
    let ends = [CurvePoint::new(piece, 0.0), CurvePoint::before_end(piece, 0.0)];
    let cuts: Vec<CurvePoint> = ends[..1].iter().chain(&inner).chain(&ends[1..]).copied().collect();
    let between = |pair: &[CurvePoint]| {
        let [a, b] = [pair[0], pair[1]];
        if b.from_start() <= high {
            Stretch { piece, end: End::Start, from: a.from_start(), to: b.from_start() }
        } else {
            Stretch { piece, end: End::Finish, from: b.to_end(), to: a.to_end() }
        }
    };
    cuts.windows(2).map(between).filter(|stretch| stretch.to > stretch.from).collect()
}

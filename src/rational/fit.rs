//! Rational approximation on a boundary: AAA, points added where it is wrong between its points, poles inside removed.
//!
//! If r has no pole inside and f is analytic there, |f − r| is largest on the boundary, so an error that is measured
//! there holds inside too (maximum principle). It is measured on ten times as many points as were fitted.

use super::fitting::Fitting;
use super::function::{Rational, rounded};
use super::samples::Boundary;
use num_complex::Complex64;

/// What is to be reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// The error relative to the extent of the values: half the larger side of the box around them.
    pub tolerance: f64,
    /// The largest degree.
    pub degree: usize,
    /// The arithmetic in which the function will be evaluated.
    pub precision: Precision,
}

/// The arithmetic of an evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// f64.
    Double,
    /// f32: support points, values and weights are rounded, and the error is that of the rounded function in f32.
    Single,
}

impl Precision {
    /// The distance from 1 to the next number.
    pub(super) fn epsilon(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON,
            Self::Single => f32::EPSILON.into(),
        }
    }
}

/// A function with this error, in extents, or less, of which no digit is left without its poles inside, is fitted again to
/// a digit less: it has followed the rounding of the values next to a corner. A coarser fit is taken where it comes within a
/// digit of its tolerance; else the first one says that there is none.
const BROKEN: f64 = 0.01;

/// A boundary whose pairs are rounded to single precision.
struct Rounded<'a>(&'a dyn Boundary);

impl Boundary for Rounded<'_> {
    fn rays(&self) -> usize {
        self.0.rays()
    }

    fn is_singular(&self, ray: usize) -> bool {
        self.0.is_singular(ray)
    }

    fn pair(&self, ray: usize, offset: f64) -> [Complex64; 2] {
        self.0.pair(ray, offset).map(rounded)
    }
}

/// A rational function with what was measured of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    function: Rational,
    poles: Vec<Complex64>,
    error: f64,
    extent: f64,
    jump: f64,
}

/// The fit was cancelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("canceled")]
pub struct Cancelled;

impl Fit {
    /// Fits the map of a boundary. `contains` says whether a point lies inside; `report` gets the share of the digits
    /// that is reached, before every step, and 1 before poles inside are removed; it returns whether to go on.
    ///
    /// The error is not guaranteed to reach the goal: [`Self::error`] says what it is. No pole lies inside.
    pub fn new(
        boundary: &dyn Boundary,
        contains: &dyn Fn(Complex64) -> bool,
        goal: Goal,
        report: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Self, Cancelled> {
        let rounded = Rounded(boundary);
        let boundary = if goal.precision == Precision::Single { &rounded } else { boundary };
        let (first, converged) = Self::once(boundary, contains, goal, report)?;
        let mut tolerance = goal.tolerance;
        while first.digits() == 0 && converged <= BROKEN * first.extent && 10.0 * tolerance <= BROKEN {
            tolerance *= 10.0;
            let (fit, _) = Self::once(boundary, contains, Goal { tolerance, ..goal }, report)?;
            if fit.error <= 10.0 * tolerance * fit.extent {
                return Ok(fit);
            }
        }
        Ok(first)
    }

    /// A fit, and its error before poles inside were removed.
    fn once(
        boundary: &dyn Boundary,
        contains: &dyn Fn(Complex64) -> bool,
        goal: Goal,
        report: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(Self, f64), Cancelled> {
        let mut fitting = Fitting::new(boundary, goal);
        let function = fitting.converge(report)?;
        let converged = fitting.error(&function);
        let (function, poles) = fitting.without_bad_poles(function, contains, &mut || report(1.0))?;
        let error = fitting.measured(&function);
        Ok((Self { function, poles, error, extent: fitting.extent(), jump: fitting.jump() }, converged))
    }

    /// r.
    pub fn function(&self) -> &Rational {
        &self.function
    }

    /// Its poles, none of which lies inside.
    pub fn poles(&self) -> &[Complex64] {
        &self.poles
    }

    /// The largest error measured on the boundary, in the units of the values.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Half the larger side of the box around the values.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// The largest distance between values at points that the arithmetic cannot tell apart, if that is visible: 0.6 % of
    /// the extent or more. No function has an error below half of it. 0 if there is none.
    pub fn jump(&self) -> f64 {
        self.jump
    }

    /// The number of digits, relative to the extent.
    pub fn digits(&self) -> u32 {
        (self.extent / self.error.max(f64::EPSILON * self.extent)).log10().max(0.0).floor() as u32
    }
}

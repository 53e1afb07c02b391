//! A conformal map and its inverse as rational functions.

use super::fit::{Cancelled, Fit, Goal, Precision};
use super::fitting::larger;
use super::matched::MatchedBoundary;
use crate::conformal::{ConformalMap, PerSide, Side, Unsharpened};
use crate::geometry::{Curve, DVec2};
use num_complex::Complex64;

/// The largest degree: hand → disk needs 360 for eight digits, blob → disk 127 for twelve. Next to a notch whose outer
/// angle is β, poles stand in proportion to 1/β: in those of the cinquefoil, of 25°, 400 give an error of 2e-4, and eight
/// digits would need some 1200, by the capacity of the condenser between the sides of the notches.
pub const MAX_DEGREE: usize = 400;
/// The least and the largest number of digits that can be asked for: the boundary map has 13 to 15.
pub const DIGITS: std::ops::RangeInclusive<u32> = 1..=13;
/// The same in single precision, whose roundings add up to 1e-6.
pub const SINGLE_DIGITS: std::ops::RangeInclusive<u32> = 1..=5;
/// Points inside that are mapped there and back, at most.
const INSIDE: usize = 1000;

/// A map f between two outlines as rational functions, one for f and one for its inverse.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Formula {
    /// f. Without a digit only if the inverse has one.
    pub forward: Fit,
    /// The inverse of f. Without a digit only if f has one: where f crowds, doubles cannot name the points of the target.
    pub inverse: Fit,
    /// The largest distance of a point inside the source from its image's image under the inverse; and for the target,
    /// of a point inside it from the image of its image under the inverse. `None` if one function has no digit.
    pub there_and_back: PerSide<Option<f64>>,
    /// Estimates of the largest error of the boundary values that f, and its inverse, were fitted to.
    pub boundary_error: PerSide<f64>,
    /// Whether it is for evaluation in single precision.
    pub is_single: bool,
}

/// What one function of a formula reaches.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Reached {
    /// Its degree.
    pub degree: usize,
    /// The number of its poles in the finite plane, none of which lies inside.
    pub poles: usize,
    /// The number of digits; a function without a digit is left out of files.
    pub digits: u32,
    /// The largest error measured on the boundary.
    pub error: f64,
    /// An estimate of the largest error of the boundary values.
    pub boundary_error: f64,
    /// Whether that estimate is within the measured error or the digits that were asked for.
    pub is_boundary_exact: bool,
}

/// Why there is no formula.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FormulaError {
    /// The side is a surface.
    #[error("the {side} is a surface; a formula is for two outlines")]
    Surface {
        /// Which one.
        side: Side,
    },
    /// The boundary integral was requested for the side, but its harmonic measure is from finite elements, which have 2
    /// to 3 digits.
    #[error("the {side} has no exact boundary values: {reason}")]
    FiniteElements {
        /// Which one.
        side: Side,
        /// Why the boundary integral is not used.
        reason: Box<Unsharpened>,
    },
    /// The side was prepared for finite elements, or its map is not computed yet.
    #[error("the {side} has no exact boundary values: the boundary integral was not computed")]
    NoIntegral {
        /// Which one.
        side: Side,
    },
    /// Neither the map nor its inverse has even one digit.
    #[error(
        "no rational function of degree up to {MAX_DEGREE} has one digit: the map's error is {:.1e}, the inverse's {:.1e}",
        .errors.source, .errors.target
    )]
    NoDigit {
        /// The largest errors on the boundary, in the units of the other side.
        errors: PerSide<f64>,
    },
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl Formula {
    /// Fits the map and its inverse to `digits` digits, in [`DIGITS`]. `report` gets the share that is done, before every
    /// step of AAA, and returns whether to go on. Takes 1 to 10 s.
    ///
    /// The digits may not be reached: next to the preimage of a corner of angle α, values change by δ^(α/π) over a distance
    /// of δ, so that doubles resolve 1e-16^(α/π) there; and where f crowds, its inverse is as steep.
    /// [`Fit::digits`] says what is.
    pub fn new(map: &ConformalMap, digits: u32, report: &mut dyn FnMut(f64) -> bool) -> Result<Self, FormulaError> {
        Self::to(map, digits, Precision::Double, report)
    }

    /// The same in single precision, with at most 5 digits.
    pub fn single(map: &ConformalMap, digits: u32, report: &mut dyn FnMut(f64) -> bool) -> Result<Self, FormulaError> {
        Self::to(map, digits.min(*SINGLE_DIGITS.end()), Precision::Single, report)
    }

    /// The digits that it was made for, if so many were asked for.
    pub fn digits_at_most(&self, digits: u32) -> u32 {
        if self.is_single { digits.min(*SINGLE_DIGITS.end()) } else { digits }
    }

    /// What f (source) and its inverse (target) reach, if so many digits were asked for.
    pub fn reached(&self, digits: u32) -> PerSide<Reached> {
        let reached = |fit: &Fit, boundary_error: f64| Reached {
            degree: fit.function().degree(),
            poles: fit.poles().len(),
            digits: fit.digits(),
            error: fit.error(),
            boundary_error,
            is_boundary_exact: boundary_error <= fit.error().max(fit.extent() * 10f64.powi(-(digits as i32))),
        };
        let errors = &self.boundary_error;
        PerSide::new(reached(&self.forward, errors.source), reached(&self.inverse, errors.target))
    }

    fn to(
        map: &ConformalMap,
        digits: u32,
        precision: Precision,
        report: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Self, FormulaError> {
        for side in Side::BOTH {
            check(map, side)?;
        }
        let goal = Goal { tolerance: 0.1_f64.powi(digits as i32), degree: MAX_DEGREE, precision };
        let (forward, forward_error) = fitted(map, Side::Source, goal, &mut |done| report(0.5 * done))?;
        let (inverse, inverse_error) = fitted(map, Side::Target, goal, &mut |done| report(0.5 + 0.5 * done))?;
        if forward.digits() == 0 && inverse.digits() == 0 {
            return Err(FormulaError::NoDigit { errors: PerSide::new(forward.error(), inverse.error()) });
        }
        let there_and_back = PerSide::new(
            there_and_back(map, Side::Source, [&forward, &inverse]),
            there_and_back(map, Side::Target, [&inverse, &forward]),
        );
        let boundary_error = PerSide::new(forward_error, inverse_error);
        Ok(Self { forward, inverse, there_and_back, boundary_error, is_single: precision == Precision::Single })
    }
}

/// Checks that a side's measure is from the boundary integral.
fn check(map: &ConformalMap, side: Side) -> Result<(), FormulaError> {
    let prepared = map.side(side);
    if prepared.is_surface() {
        return Err(FormulaError::Surface { side });
    }
    if prepared.curve_boundary().is_some() {
        return Ok(());
    }
    Err(match prepared.unsharpened() {
        Some(reason) => FormulaError::FiniteElements { side, reason: Box::new(reason.clone()) },
        None => FormulaError::NoIntegral { side },
    })
}

/// The map of one side's curve, and the error of its values.
fn fitted(
    map: &ConformalMap,
    side: Side,
    goal: Goal,
    report: &mut dyn FnMut(f64) -> bool,
) -> Result<(Fit, f64), FormulaError> {
    let curves = map.curve_map(side).zip(map.curve_map(side.other()));
    let (curve_map, inverse) = curves.ok_or(FormulaError::NoIntegral { side })?;
    let curve = curve_map.from_curve();
    let boundary = MatchedBoundary::new(curve_map, inverse);
    let fit = Fit::new(&boundary, &|z| contains(curve, z), goal, report)?;
    Ok((fit, boundary.value_error()))
}

fn contains(curve: &Curve, z: Complex64) -> bool {
    curve.contains(DVec2::new(z.re, z.im))
}

/// The largest distance of a point inside of a side from where the first function and then the second take it; `None`
/// if one of them has no digit.
fn there_and_back(map: &ConformalMap, side: Side, [there, back]: [&Fit; 2]) -> Option<f64> {
    let domain = map.domain(side).filter(|_| there.digits() > 0 && back.digits() > 0)?;
    let mesh = domain.mesh();
    let inside = &mesh.vertices()[mesh.boundary_count() as usize..];
    let step = inside.len().div_ceil(INSIDE).max(1);
    let distance = |x: &DVec2| {
        let z = Complex64::new(x.x, x.y);
        (back.function().at(there.function().at(z)) - z).norm()
    };
    Some(inside.iter().step_by(step).map(distance).fold(0.0, larger))
}

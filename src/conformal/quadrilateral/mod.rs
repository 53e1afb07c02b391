//! Quadrilaterals: a domain with four marked boundary points, and its conformal map onto the rectangle of the same
//! modulus, corners to corners.
//!
//! There is one such map up to the rectangle's size, and no second outline is needed for it: harmonic measure takes the
//! outline to the circle, and Jacobi's sn² the circle to the rectangle (`side`). Both are known at every boundary point in
//! closed form or by the integral equation; the inverse map g: rectangle → domain inside is Cauchy's integral of its
//! boundary values over the rectangle (`boundary`, `map`, [`crate::cauchy_integral`]). The images of a lattice are an orthogonal
//! grid (`grid`). Everything is seen from the middle of the quadrilateral (`middle`), where nothing cancels, or of a long one
//! from points along it (`channel`).
//!
//! Everything is computed at two resolutions of the integral equation; the difference is the error. Source of the formulas:
//! Abramowitz & Stegun (1964), 16.18 and 16.27 to 16.38.

mod boundary;
mod channel;
mod error;
mod frame;
mod grid;
mod map;
mod marks;
mod middle;
mod rectangle;
mod side;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use crate::boundary_integral::{
    BoundaryIntegral, BoundaryIntegralError, Estimate, HarmonicMeasure, Settings, modulus, modulus_of_both,
};
use crate::geometry::{Curve, CurvePoint, DVec2, SimplePolygon};
use channel::Channel;
pub use error::QuadrilateralError;
pub use grid::{GridCells, MOST_CELLS, OrthogonalGrid};
pub use map::RectangleMap;
pub use marks::Marks;
use middle::{Found, turned};
pub use rectangle::rectangle_corners;

/// The largest extremal distance between opposite sides of a rectangle onto which an outline is mapped. With each unit the
/// measures of the short sides, and the places along the long ones, lose a factor of 5 of their accuracy: seen from the
/// middle, places in rectangles of lengths 10, 14, 17, 18, 20 and 22 are off by 4e-11, 2e-8, 2e-6, 5e-6, 3e-4 and 3e-3
/// widths. Grids have no such limit: they are seen from many points (`channel`).
pub const MOST_LENGTH: f64 = 18.0;

/// Measures of arcs below this one are rounding.
const LEAST: f64 = 1e-14;

/// The tolerance of the point of a polygon from which the middle is looked for, in sizes of the polygon.
const NEAR_POLE: f64 = 1e-3;

/// The most unknowns: several factors are made.
const MAX_UNKNOWNS: usize = super::MAX_UNKNOWNS / 4;

/// How the outline is divided.
fn settings() -> Settings {
    Settings::default().with_max_unknowns(MAX_UNKNOWNS)
}

/// A domain with four boundary points, its corners.
#[derive(Debug, Clone)]
pub struct Quadrilateral {
    curve: Curve,
    corners: [CurvePoint; 4],
    seen: Seen,
    modulus: Estimate,
}

/// What is seen of a quadrilateral, at a coarser and at a finer resolution of the equation.
#[derive(Debug, Clone)]
enum Seen {
    /// From the middle.
    Middle([Resolved; 2]),
    /// From points along a long one, in order from its side `turn` to the opposite one.
    Channel { turn: usize, measures: [Vec<HarmonicMeasure>; 2] },
}

/// The harmonic measure from the middle at one resolution.
#[derive(Debug, Clone)]
struct Resolved {
    measure: HarmonicMeasure,
    /// The measures of the sides.
    arcs: [f64; 4],
    modulus: f64,
}

impl Resolved {
    fn new(integral: &BoundaryIntegral, x: DVec2, corners: [CurvePoint; 4]) -> Result<Self, BoundaryIntegralError> {
        let measure = integral.harmonic_measure(x)?;
        let arcs = [0, 1, 2, 3].map(|k| measure.between(corners[k], corners[(k + 1) % 4]));
        Ok(Self { measure, arcs, modulus: modulus(arcs) })
    }
}

impl Quadrilateral {
    /// The quadrilateral with these corners; `inside` is any point inside, near the middle or not.
    ///
    /// Errors: two corners are one point of the curve; no way along the quadrilateral is found; the integral equation of the
    /// curve cannot be solved. Cost: that of three preparations of the equation or more.
    pub fn new(curve: &Curve, marks: Marks, inside: DVec2) -> Result<Self, QuadrilateralError> {
        Self::new_while(curve, marks, inside, &mut || true)?.ok_or(QuadrilateralError::NoMiddle)
    }

    /// As [`Self::new`]; `goes_on` is asked between the preparations, and `None` is returned once it says no.
    fn new_while(
        curve: &Curve,
        marks: Marks,
        inside: DVec2,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Self>, QuadrilateralError> {
        let corners = marks.fractions().map(|fraction| curve.point_at_fraction(fraction));
        if let Some(k) = (0..4).find(|&k| corners[k] == corners[(k + 1) % 4]) {
            return Err(QuadrilateralError::Coinciding { marks: [k + 1, (k + 1) % 4 + 1] });
        }
        let Some(found) = middle::middle(curve, corners, inside, goes_on)? else { return Ok(None) };
        if !goes_on() {
            return Ok(None);
        }
        let (x, coarse) = match found {
            Found::Middle(x, coarse) => (x, coarse),
            Found::Channel { turn, points } => return Self::long((curve, corners), turn, &points, goes_on),
        };
        check_length(modulus(above_rounding(coarse.arcs)))?;
        let settings = settings().with_points(&[x]).finer();
        let fine = Resolved::new(&BoundaryIntegral::prepare(curve, &settings)?, x, corners)?;
        let modulus = modulus_of_both(coarse.arcs, fine.arcs);
        Ok(Some(Self { curve: curve.clone(), corners, seen: Seen::Middle([coarse, fine]), modulus }))
    }

    /// A long quadrilateral, seen from these points along it.
    fn long(
        (curve, corners): (&Curve, [CurvePoint; 4]),
        turn: usize,
        points: &[DVec2],
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Self>, QuadrilateralError> {
        let measures = |settings: &Settings| -> Result<Vec<HarmonicMeasure>, BoundaryIntegralError> {
            let integral = BoundaryIntegral::prepare(curve, settings)?;
            points.iter().map(|&x| integral.harmonic_measure(x)).collect()
        };
        // points that are not named cost digits, which the error says, and far fewer unknowns
        let named = settings().with_points(points);
        let fits = BoundaryIntegral::check(curve, &named.clone().finer()).is_ok();
        let settings = if fits { named } else { settings() };
        let coarse = measures(&settings)?;
        if !goes_on() {
            return Ok(None);
        }
        let measures = [coarse, measures(&settings.finer())?];
        let [coarse, fine] = measures.each_ref().map(|measures| Channel::new(turned(corners, turn), measures));
        let length = Channel::estimate(&coarse, &fine);
        let modulus = if turn == 0 { length } else { reciprocal(length) };
        Ok(Some(Self { curve: curve.clone(), corners, seen: Seen::Channel { turn, measures }, modulus }))
    }

    /// As [`Self::new`], of an outline's curve, with the middle looked for from the pole of inaccessibility of its polygon.
    pub fn of_outline(outline: (&SimplePolygon, &Curve), marks: Marks) -> Result<Self, QuadrilateralError> {
        Self::of_outline_while(outline, marks, &mut || true)?.ok_or(QuadrilateralError::NoMiddle)
    }

    /// As [`Self::of_outline`]; `goes_on` is asked between the preparations, and `None` is returned once it says no.
    pub fn of_outline_while(
        (polygon, curve): (&SimplePolygon, &Curve),
        marks: Marks,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Self>, QuadrilateralError> {
        let tolerance = NEAR_POLE * polygon.bounds().size().max_element();
        Self::new_while(curve, marks, polygon.pole_of_inaccessibility(tolerance), goes_on)
    }

    /// The extremal distance between the sides from corner 1 to 2 and from corner 3 to 4: the length of the other two sides
    /// of the rectangle over that of these two.
    pub fn modulus(&self) -> Estimate {
        self.modulus
    }

    /// The corners.
    pub fn corners(&self) -> [DVec2; 4] {
        self.corners.map(|corner| self.curve.position(corner))
    }
}

/// The reciprocal of a positive number.
fn reciprocal(Estimate { value, error }: Estimate) -> Estimate {
    let nearer = if value > error { error / (value - error) } else { f64::INFINITY };
    Estimate { value: value.recip(), error: (nearer + f64::EPSILON) / value }
}

/// The measures of arcs, those below rounding replaced by it, and the largest one by what the others leave.
fn above_rounding(arcs: [f64; 4]) -> [f64; 4] {
    let mut arcs = arcs.map(|arc| arc.max(LEAST));
    let largest = (1..4).fold(0, |best, k| if arcs[k] > arcs[best] { k } else { best });
    arcs[largest] = 1.0 - (1..4).map(|k| arcs[(largest + k) % 4]).sum::<f64>();
    arcs
}

/// Errors: a quadrilateral of this modulus is too long, or the modulus is not positive.
fn check_length(modulus: f64) -> Result<(), QuadrilateralError> {
    let length = modulus.max(modulus.recip());
    if modulus > 0.0 && length <= MOST_LENGTH {
        return Ok(());
    }
    let side = usize::from(modulus < 1.0);
    Err(QuadrilateralError::TooLong { side, length })
}

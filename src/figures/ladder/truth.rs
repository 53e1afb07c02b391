//! What the errors of the ladder are measured against.
//!
//! | outline | exact harmonic measure |
//! |---|---|
//! | disk, V-shape | closed forms (sections 3.1 and 1.2 of the paper) |
//! | blob, z + 0.12 z⁵ | the parameter: images of the disk |
//! | ellipse, square, rectangle | series and elliptic functions (`exact`) |
//! | L-shape | at the corners only, by Schwarz–Christoffel integrals evaluated to 25 digits |
//! | rounded square, notch, clef, coast | none: the boundary integral with about twice the unknowns of the default |

use super::super::{ArcLength, FigureError};
use super::shape::LadderShape;
use crate::boundary_integral::{BoundaryIntegral, HarmonicMeasure, Settings};
use crate::exact::{complex, disk, ellipse, rectangle, square, vshape};
use crate::geometry::{Curve, CurvePoint, DVec2};
use std::f64::consts::TAU;

/// Harmonic measures from (½, ½) of the L-shape's sides, from (0, 0) counter-clockwise: the long sides, the arms' ends
/// and the inner sides.
const L_SIDES: [f64; 6] = {
    let [long, inner] = [0.394_497_233_238_905_2, 0.092_199_674_737_061_53];
    // half of the boundary is left of the diagonal; a printed value of the end is off by 1e-14
    let end = 0.5 - long - inner;
    [long, end, inner, inner, end, long]
};

/// The exact harmonic measure of an outline, counted from the start of its curve.
#[derive(Debug)]
pub struct Truth {
    shape: LadderShape,
    curve: Curve,
    arc: ArcLength,
    finer: Option<HarmonicMeasure>,
}

/// The kind of reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reference {
    /// Exact values along the boundary.
    Exact,
    /// Exact values at the corners only.
    Corners,
    /// A finer solution by the boundary integral.
    Finer,
}

impl Reference {
    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Corners => "exact-at-corners",
            Self::Finer => "finer-integral",
        }
    }
}

impl LadderShape {
    /// What its errors are measured against.
    pub fn reference(self) -> Reference {
        match self {
            Self::LShape => Reference::Corners,
            Self::RoundedSquare | Self::Notch | Self::Clef | Self::Coast => Reference::Finer,
            _ => Reference::Exact,
        }
    }
}

/// The first point of a curve, from which measures are counted.
pub fn start() -> CurvePoint {
    CurvePoint::new(0, 0.0)
}

/// The point at a parameter that runs through piece k from k to k + 1.
fn point_of(place: f64, pieces: usize) -> CurvePoint {
    let piece = (place as usize).min(pieces - 1);
    CurvePoint::new(piece, place - piece as f64)
}

/// Halvings of a piece: to the last bit of its parameter.
const HALVINGS: u32 = 54;
/// Newton steps to the foot of a point that is within 1e-5 of it; each squares the distance.
const NEWTON_STEPS: usize = 3;

impl Truth {
    /// The reference of an outline.
    pub fn new(shape: LadderShape) -> Result<Self, FigureError> {
        let curve = shape.curve()?;
        let finer = match shape.reference() {
            Reference::Finer => {
                let settings = Settings::default().with_points(&[shape.point()]).finer();
                Some(BoundaryIntegral::prepare(&curve, &settings)?.harmonic_measure(shape.point())?)
            }
            Reference::Exact | Reference::Corners => None,
        };
        let pieces = curve.pieces().len();
        let arc = ArcLength::coarse(|place| curve.position(point_of(place, pieces)), pieces as f64);
        Ok(Self { shape, curve, arc, finer })
    }

    /// The curve.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// ω in [0, 1) at a point of the curve; `None` where it is not known.
    pub fn omega(&self, at: CurvePoint) -> Option<f64> {
        let t = at.from_start();
        Some(match self.shape {
            LadderShape::Disk => disk::harmonic_measure(complex(self.shape.point()), TAU * t),
            LadderShape::Ellipse => ellipse::boundary_angle(4.0, TAU * t) / TAU,
            LadderShape::Square => square::boundary_angle(self.fraction(at)) / TAU,
            LadderShape::Blob | LadderShape::Quintic => t,
            LadderShape::VShape => vshape::harmonic_measure(self.shape.point(), self.curve.position(at)),
            LadderShape::Rectangle => {
                let ratio = |side: usize| if side.is_multiple_of(2) { 0.1 } else { 10.0 };
                let before: f64 = (0..at.piece()).map(|side| rectangle::side_measure(ratio(side), 1.0)).sum();
                before + rectangle::side_measure(ratio(at.piece()), t)
            }
            LadderShape::LShape if t == 0.0 => L_SIDES[..at.piece().min(L_SIDES.len())].iter().sum(),
            LadderShape::LShape => return None,
            LadderShape::RoundedSquare | LadderShape::Notch | LadderShape::Clef | LadderShape::Coast => {
                self.finer.as_ref()?.from_anchor(start()).forward(at)
            }
        })
    }

    /// The fraction of a polygon's perimeter.
    fn fraction(&self, at: CurvePoint) -> f64 {
        let lengths = self.curve.lengths();
        let before: f64 = lengths[..at.piece()].iter().sum();
        (before + at.from_start() * lengths[at.piece()]) / self.curve.perimeter()
    }

    /// The boundary point with the measure `omega` in [0, 1); `None` where it is not known.
    pub fn point(&self, omega: f64) -> Option<DVec2> {
        if let Some(finer) = &self.finer {
            return Some(self.curve.position(finer.from_anchor(start()).point_at(omega)));
        }
        let pieces = self.curve.pieces().len();
        let piece =
            (1..pieces).take_while(|&k| self.omega(CurvePoint::new(k, 0.0)).is_some_and(|w| w <= omega)).count();
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.omega(CurvePoint::new(piece, middle))? <= omega {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(self.curve.position(CurvePoint::new(piece, low)))
    }

    /// The point at a fraction of the perimeter: of a polygon exactly, of other curves up to 1e-7.
    pub fn at_fraction(&self, fraction: f64) -> CurvePoint {
        if self.shape.is_polygon() {
            return self.curve.point_at_fraction(fraction);
        }
        point_of(self.arc.parameter(fraction * self.arc.total()), self.curve.pieces().len())
    }

    /// The foot on the curve of a point of the polygon at this fraction of its length, which is up to 1e-5 that of the
    /// curve's.
    pub fn foot(&self, place: DVec2, fraction: f64) -> CurvePoint {
        let guess = self.at_fraction(fraction);
        let piece = &self.curve.pieces()[guess.piece()];
        if piece.is_straight() || guess.from_start() == 0.0 {
            return guess;
        }
        let mut t = guess.from_start();
        for _ in 0..NEWTON_STEPS {
            let jet = piece.jet(t);
            t = (t + (place - jet.position).dot(jet.first) / jet.first.length_squared()).clamp(0.0, 1.0);
        }
        CurvePoint::new(guess.piece(), t)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn measures_increase_from_0_to_1_and_are_inverted() {
        for shape in LadderShape::ALL {
            let truth = Truth::new(shape).unwrap();
            let pieces = truth.curve().pieces().len();
            let parts = if shape.reference() == Reference::Corners { 1 } else { 40 };
            let mut before = -1.0_f64;
            for k in 0..pieces * parts {
                let at = CurvePoint::new(k / parts, (k % parts) as f64 / parts as f64);
                let omega = truth.omega(at).unwrap();
                // steps in the V's other tip, and in bays, are below rounding
                let is_flat = shape == LadderShape::VShape || shape.has_many_corners();
                let least = if is_flat { before - 1e-15 } else { before.next_up() };
                assert!(omega >= least && omega < 1.0, "{shape:?}, {at:?}: {omega} after {before}");
                before = omega;
                // an error of 1e-16 of ω is a long way in the V's crowded tip, and 1e-5 at the rectangle's ends
                if !matches!(shape, LadderShape::LShape | LadderShape::VShape) && !shape.has_many_corners() {
                    let back = truth.point(omega).unwrap().distance(truth.curve().position(at));
                    assert!(back < 1e-4, "{shape:?}, {at:?}: {back:e} off");
                }
            }
            let first = truth.omega(start()).unwrap();
            assert!(first.abs() < 1e-15, "{shape:?}: {first}");
        }
    }

    #[test]
    fn the_sides_of_the_l_make_up_its_boundary() {
        assert!((L_SIDES.iter().sum::<f64>() - 1.0).abs() < 4e-15);
    }

    #[test]
    fn polygons_lie_on_their_curves() {
        for shape in LadderShape::ALL {
            let (truth, polygon) = (Truth::new(shape).unwrap(), shape.polygon().unwrap());
            let perimeter = polygon.perimeter();
            let mut along = 0.0;
            for (a, b) in polygon.edges() {
                let off = truth.curve().position(truth.foot(a, along / perimeter)).distance(a);
                assert!(off < 1e-9 * perimeter, "{shape:?}: {a} is {off:e} off");
                along += a.distance(b);
            }
        }
    }
}

//! The middle of a quadrilateral: the point from which opposite sides have equal harmonic measures.
//!
//! Seen from there, the disk is taken to itself by half a turn that exchanges opposite marks; no arc is larger than ½, and
//! the two short sides of a long quadrilateral are equally small. The value there of the coordinate z itself is its mean by
//! harmonic measure from the middle, which [`QuadrilateralSide`](super::side::QuadrilateralSide) carries over from any other
//! point: one step leads from there to the middle, except that measures below rounding hold it up.

use super::side::{self, QuadrilateralSide, SideEnd};
use super::{QuadrilateralError, Resolved};
use crate::boundary_integral::{BoundaryIntegral, Settings};
use crate::geometry::{Curve, CurvePoint, DVec2};
use std::f64::consts::PI;

/// Measures of arcs below this one are rounding.
const LEAST: f64 = 1e-14;
/// ρ of the sides at a point that counts as the middle. The next steps then cancel nothing yet.
const BALANCED: std::ops::RangeInclusive<f64> = 0.5..=2.0;
/// Steps. Each comes nearer by five widths of a long quadrilateral; those that are longer than 15 widths are refused.
const STEPS: usize = 16;
/// Places on each side of which the mean is taken, equally spaced in measure from the middle.
const PLACES: u32 = 32;
/// Halvings of a step that leads out of the curve.
const HALVINGS: usize = 8;

/// The middle of the quadrilateral with these corners, approximately, found from the point `start` inside; with the curve's
/// equation, which resolves it. Errors: the equation's; no middle was found.
pub fn middle(
    curve: &Curve,
    corners: [CurvePoint; 4],
    start: DVec2,
) -> Result<(DVec2, BoundaryIntegral), QuadrilateralError> {
    let prepare = |x: DVec2| BoundaryIntegral::prepare(curve, &Settings::default().with_points(&[x]));
    let (mut x, mut integral) = (start, prepare(start)?);
    for _ in 0..STEPS {
        let seen = Seen::new(Resolved::new(&integral, x, corners)?);
        if seen.is_balanced() {
            return Ok((x, integral));
        }
        let Some(next) = inside(curve, x, seen.middle(curve, corners)) else { break };
        x = next;
        if !integral.resolves(x) {
            integral = prepare(x)?;
        }
    }
    Err(QuadrilateralError::NoMiddle)
}

/// The end of the step from `x` to `wanted`, or of a part of it, that lies inside.
fn inside(curve: &Curve, x: DVec2, wanted: DVec2) -> Option<DVec2> {
    let shares = std::iter::successors(Some(1.0), |share| Some(0.5 * share)).take(HALVINGS);
    shares.map(|share| x.lerp(wanted, share)).find(|&place| place != x && curve.contains(place))
}

/// The quadrilateral as it is seen from a point, with arcs that are not less than rounding.
struct Seen {
    resolved: Resolved,
    sides: [QuadrilateralSide; 4],
    /// The measures of neighboring sides, seen from the middle.
    from_middle: [f64; 2],
}

impl Seen {
    fn new(resolved: Resolved) -> Self {
        let arcs = resolved.arcs.map(|arc| arc.max(LEAST));
        let sine = |omega: f64| (PI * omega).sin();
        let [near, far] = [sine(arcs[0]) * sine(arcs[2]), sine(arcs[1]) * sine(arcs[3])];
        // from the middle, the chords of opposite sides are equal and the diagonals are diameters
        let from_middle = [near, far].map(|product| (product / (near + far)).sqrt().min(1.0).asin() / PI);
        Self { resolved, sides: side::sides(arcs, 1.0), from_middle }
    }

    fn is_balanced(&self) -> bool {
        self.sides.iter().all(|side| BALANCED.contains(&side.balance()))
    }

    /// The mean of the boundary's places by harmonic measure from the middle.
    fn middle(&self, curve: &Curve, corners: [CurvePoint; 4]) -> DVec2 {
        let anchors = corners.map(|corner| self.resolved.measure.from_anchor(corner));
        let mean = |k: usize| {
            let gamma = PI * self.from_middle[k % 2];
            let place = |j: u32| {
                let share = (f64::from(j) + 0.5) / f64::from(PLACES);
                let [before, after] = [share, 1.0 - share].map(|share| (share * gamma).sin());
                let point = if before < after {
                    anchors[k].point_at(self.sides[k].measure_of(SideEnd::Start, before / after))
                } else {
                    anchors[(k + 1) % 4].point_before(self.sides[k].measure_of(SideEnd::Finish, after / before))
                };
                curve.position(point)
            };
            self.from_middle[k % 2] / f64::from(PLACES) * (0..PLACES).map(place).sum::<DVec2>()
        };
        (0..4).map(mean).sum()
    }
}

//! The middle of a quadrilateral: the point from which opposite sides have equal harmonic measures.
//!
//! Seen from there, the disk is taken to itself by half a turn that exchanges opposite marks; no arc is larger than ½, and
//! the two short sides of a long quadrilateral are equally small. The value there of the coordinate z itself is its mean by
//! harmonic measure from the middle, which [`QuadrilateralSide`](super::side::QuadrilateralSide) carries over from any other
//! point: one step leads from there to the middle, except that measures below rounding hold it up.

use super::channel::{LONG, points_of_view};
use super::side::{self, QuadrilateralSide, SideEnd};
use super::{LEAST, MOST_LENGTH, QuadrilateralError, Resolved, above_rounding};
use crate::boundary_integral::{BoundaryIntegral, modulus};
use crate::geometry::{Curve, CurvePoint, DVec2};
use std::f64::consts::{LN_2, PI};

/// ρ of the sides at a point that counts as the middle, as |log ρ|. The next steps then cancel nothing yet.
const BALANCED: f64 = LN_2;
/// Steps. Each comes nearer by four widths of a long quadrilateral.
const STEPS: usize = 8;
/// Places on each side of which the mean is taken, equally spaced in measure from the middle.
const PLACES: u32 = 32;
/// Halvings of a step that leads out of the curve.
const HALVINGS: usize = 8;
/// The least distance from a corner at which a beginning beside it is looked for, in perimeters: 2 to the minus this.
const NEAREST: i32 = 16;
/// The place of that beginning between the corner and the farthest point found inside: about the middle of a channel.
const WITHIN: f64 = 0.7;

/// From where a quadrilateral is seen.
pub enum Found {
    /// From about its middle, with the measure from there.
    Middle(DVec2, Resolved),
    /// From points along it, in order from the first to the third side; `turn`: from the second to the fourth.
    Channel { turn: usize, points: Vec<DVec2> },
}

/// The middle of the quadrilateral with these corners, approximately, found from the point `start` inside or from beside a
/// corner, whichever sees the sides more nearly alike; with the measure from there. Of a long one, points along it.
///
/// `goes_on` is asked between the preparations of the equation; `None` once it says no.
///
/// Errors: the equation's; no middle was found.
pub fn middle(
    curve: &Curve,
    corners: [CurvePoint; 4],
    start: DVec2,
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Option<Found>, QuadrilateralError> {
    let beside = corners.iter().filter_map(|&corner| beside(curve, corner));
    let starts: Vec<DVec2> = std::iter::once(start).chain(beside).collect();
    let integral = BoundaryIntegral::prepare(curve, &super::settings().with_points(&starts))?;
    let mut seen = Vec::new();
    for x in starts {
        seen.push((x, Seen::new(Resolved::new(&integral, x, corners)?)));
    }
    seen.sort_by(|a, b| {
        let [first, second] = [a, b].map(|(_, seen)| (seen.hides_a_side(), seen.imbalance()));
        first.0.cmp(&second.0).then(first.1.total_cmp(&second.1))
    });
    for (x, seen) in seen.iter().filter(|(_, seen)| seen.is_perhaps_long()) {
        if !goes_on() {
            return Ok(None);
        }
        let turn = usize::from(seen.modulus < 1.0);
        if let Some(points) = points_of_view((curve, turned(corners, turn)), &integral, *x)? {
            return Ok(Some(Found::Channel { turn, points }));
        }
    }
    // what a point sees that sees nothing of a side is a bound only
    let hidden = seen.iter().find(|(_, seen)| seen.hides_a_side());
    let error = hidden.map_or(QuadrilateralError::NoMiddle, |(_, seen)| seen.too_long());
    for (x, seen) in seen {
        match from_start(curve, corners, (x, seen), &integral, goes_on)? {
            Search::Ended(None) => {}
            Search::Ended(Some((x, resolved))) => return Ok(Some(Found::Middle(x, resolved))),
            Search::GivenUp => return Ok(None),
        }
    }
    Err(error)
}

/// The corners from another one on.
pub fn turned(corners: [CurvePoint; 4], turn: usize) -> [CurvePoint; 4] {
    std::array::from_fn(|k| corners[(k + turn) % 4])
}

/// The end of a search from one point.
enum Search {
    /// With the middle, if the steps led there.
    Ended(Option<(DVec2, Resolved)>),
    GivenUp,
}

/// The middle, found by steps from a point.
fn from_start(
    curve: &Curve,
    corners: [CurvePoint; 4],
    (mut x, mut seen): (DVec2, Seen),
    first: &BoundaryIntegral,
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<Search, QuadrilateralError> {
    let prepare = |x: DVec2| BoundaryIntegral::prepare(curve, &super::settings().with_points(&[x]));
    for _ in 0..STEPS {
        if !seen.hides_a_side() && seen.imbalance() <= BALANCED {
            return Ok(Search::Ended(Some((x, seen.resolved))));
        }
        if !goes_on() {
            return Ok(Search::GivenUp);
        }
        let Some(next) = inside(curve, x, seen.middle(curve, corners)) else { break };
        x = next;
        let resolved = if first.resolves(x) {
            Resolved::new(first, x, corners)?
        } else {
            Resolved::new(&prepare(x)?, x, corners)?
        };
        seen = Seen::new(resolved);
    }
    Ok(Search::Ended(None))
}

/// A point inside, at about half the width of the domain from a corner.
fn beside(curve: &Curve, corner: CurvePoint) -> Option<DVec2> {
    let count = curve.pieces().len();
    let tangent = |piece: usize, t: f64| curve.pieces()[piece].jet(t).first.normalize_or_zero();
    let after = tangent(corner.piece(), corner.from_start());
    let before = if corner.from_start() == 0.0 { tangent((corner.piece() + count - 1) % count, 1.0) } else { after };
    let (place, inwards) = (curve.position(corner), (before + after).perp().normalize_or_zero());
    let distances = (2..=NEAREST).rev().map(|k| curve.perimeter() * 0.5_f64.powi(k));
    let farthest = distances.take_while(|d| curve.contains(place + d * inwards)).last()?;
    Some(place + WITHIN * farthest * inwards).filter(|&x| curve.contains(x))
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
    modulus: f64,
}

impl Seen {
    fn new(resolved: Resolved) -> Self {
        let arcs = above_rounding(resolved.arcs);
        let sine = |omega: f64| (PI * omega).sin();
        let [near, far] = [sine(arcs[0]) * sine(arcs[2]), sine(arcs[1]) * sine(arcs[3])];
        let modulus = modulus(arcs);
        // from the middle, the chords of opposite sides are equal and the diagonals are diameters
        let from_middle = [near, far].map(|product| (product / (near + far)).sqrt().min(1.0).asin() / PI);
        Self { resolved, sides: side::sides(arcs, modulus), from_middle, modulus }
    }

    /// Whether the measure of a side is below rounding. The sides' ρ then say where to go, but not that the middle is
    /// near: sides of which nothing is seen look alike.
    fn hides_a_side(&self) -> bool {
        self.resolved.arcs.iter().any(|&arc| arc < LEAST)
    }

    /// Whether the quadrilateral may be a long one.
    fn is_perhaps_long(&self) -> bool {
        self.hides_a_side() || self.modulus.max(self.modulus.recip()) > 0.9 * LONG
    }

    /// The largest |log ρ| of the sides: 0 from the middle.
    fn imbalance(&self) -> f64 {
        self.sides.iter().map(|side| side.balance().ln().abs()).fold(0.0, f64::max)
    }

    /// The error that the sides which are farther from each other are too far.
    fn too_long(&self) -> QuadrilateralError {
        let length = self.modulus.max(self.modulus.recip()).max(MOST_LENGTH);
        QuadrilateralError::TooLong { side: usize::from(self.modulus < 1.0), length }
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

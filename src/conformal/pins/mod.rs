//! Maps given by three or more boundary pairs ("pins"): y₁, y₂, y₃ ↦ y₁′, y₂′, y₃′.
//!
//! Three pairs in the same order determine one conformal map, as a point and a boundary point do. A map carries the
//! harmonic measure of arcs seen from x₁ to that seen from f(x₁), so it suffices to find a point of each side from which
//! the three arcs between the pins have the same measures; with a pin as anchor on both sides these give the map. The
//! first point is taken where the arcs have about a third each: there is such a point (the image of the center of a disk
//! on which the pins are equidistant), and from it no arc is crowded. The second point solves two equations in two
//! unknowns, by Newton's method from the discrete harmonic functions of the arcs.
//!
//! More than three pairs are met in the sense of least squares (`fit`): the map found is written as one through three
//! pairs, of places that a third of the measure separates.
//!
//! | file | what |
//! |---|---|
//! | `order` | whether the pins run around both sides in one order |
//! | `view` | harmonic measure as seen from a point, by the side's own kernel |
//! | `arcs` | the arcs as discrete harmonic functions, and points where these have given values |
//! | `three` | the map through three pins: where it is seen from, and its anchor |
//! | `newton` | the point of a side that sees given measures |
//! | `slices` | the search, interrupted by deadlines |
//! | `start` | where Newton's method begins next to a short part of the boundary |
//! | `fit`, `moebius` | the map that misses more than three pins least |
//! | `images` | boundary pairs of a map that is there |
//!
//! On a surface measures are those of finite elements, of which maps seen from different points differ by their error. A
//! point that is given, or a side's default point, therefore stays if it sees every arc under a tenth or more.
//!
//! Not guaranteed: that a point is found where pins are so close to each other that no vertex of the mesh sees them apart
//! (an error says so). How well each pin is met is said by [`Pins::misses`].

mod arcs;
mod fit;
mod images;
mod newton;
mod order;
mod slices;
mod start;
mod three;
mod view;

use super::{ConformalMap, Constraints, InteriorPoint, MapError, PerSide, PreparedSide, Side};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
use crate::outline::BoundaryPoint;
use fit::Fit;
pub use slices::PinSearch;
use slices::Slices;
use three::Three;
use view::View;

/// The largest number of pins.
pub const MOST_PINS: usize = 64;

/// A pin is missed if the map is off by more than this share of the target's size: measures around it are below rounding.
const MISSED: f64 = 1e-3;

/// Triples of neighboring pins through which fits begin, beside those farthest from each other.
const MOST_BEGINNINGS: usize = 8;

/// Three boundary pairs or more: fractions of the length of the source's and of the target's boundary.
///
/// Invariant: they differ on each side and run around both in one order.
#[derive(Debug, Clone, PartialEq)]
pub struct Pins(Vec<PerSide<f64>>);

/// Why there is no map through the pins.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PinError {
    /// Fewer than three pairs, or more than [`MOST_PINS`].
    #[error("{count} boundary pairs are given: from three to {MOST_PINS} determine a map")]
    Count {
        /// The number of pairs.
        count: usize,
    },
    /// A fraction is not finite.
    #[error("pin {pin} has no place on the {side}'s boundary")]
    NotFinite {
        /// The pin, from 1.
        pin: usize,
        /// The side.
        side: Side,
    },
    /// Two pins are one place.
    #[error("pins {} and {} are one place of the {side}'s boundary: each pin needs its own", pins[0], pins[1])]
    Coinciding {
        /// The pins, from 1.
        pins: [usize; 2],
        /// The side.
        side: Side,
    },
    /// The pins run around the two boundaries in opposite directions.
    #[error(
        "pins {}, {} and {} run counter-clockwise around the {counter_clockwise} and clockwise around the other side: a \
             conformal map keeps the order", pins[0], pins[1], pins[2]
    )]
    Order {
        /// Three of the pins, from 1.
        pins: [usize; 3],
        /// The side around which they run counter-clockwise.
        counter_clockwise: Side,
    },
    /// No point of the side sees the arcs as the other side's point does.
    #[error(
        "no point of the {side} was found from which the arcs between the pins are seen as on the other side: two \
             pins may be too close to each other"
    )]
    NotFound {
        /// The side.
        side: Side,
    },
    /// One of three pins is not met.
    #[error(
        "the map misses pin {pin} by {miss:.1e}: seen from the points that see the pins apart, its surroundings have a \
             measure below rounding"
    )]
    Missed {
        /// The pin, from 1.
        pin: usize,
        /// The distance of its source's image from its target.
        miss: f64,
    },
    /// A side's linear system could not be solved.
    #[error("{side}: {error}")]
    NotConverged {
        /// The side.
        side: Side,
        /// The cause.
        error: NotConverged,
    },
    /// A point's kernel could not be computed.
    #[error(transparent)]
    Map(#[from] MapError),
}

impl PinError {
    /// The side that it is about; `None`: both.
    pub fn side(&self) -> Option<Side> {
        match self {
            Self::NotFinite { side, .. }
            | Self::Coinciding { side, .. }
            | Self::NotFound { side }
            | Self::NotConverged { side, .. } => Some(*side),
            Self::Map(error) => Some(error.side()),
            Self::Count { .. } | Self::Order { .. } | Self::Missed { .. } => None,
        }
    }
}

impl Pins {
    /// Pairs of fractions (taken modulo 1) that differ on each side and run around both in one order.
    pub fn new(pairs: impl IntoIterator<Item = PerSide<f64>>) -> Result<Self, PinError> {
        let pairs: Vec<PerSide<f64>> = pairs.into_iter().map(|pair| pair.map(|s| s.rem_euclid(1.0))).collect();
        if !(3..=MOST_PINS).contains(&pairs.len()) {
            return Err(PinError::Count { count: pairs.len() });
        }
        let not_finite = |(k, pair): (usize, &PerSide<f64>)| {
            pair.iter().find(|(_, s)| !s.is_finite()).map(|(side, _)| PinError::NotFinite { pin: k + 1, side })
        };
        if let Some(error) = pairs.iter().enumerate().find_map(not_finite) {
            return Err(error);
        }
        order::check(&pairs)?;
        Ok(Self(pairs))
    }

    /// The pairs.
    pub fn pairs(&self) -> &[PerSide<f64>] {
        &self.0
    }

    /// The constraints of the map through three pins, or of the one that misses more of them least (by the sum of squares):
    /// anchors at one of the pins, and points that see the arcs between the pins under the same measures. `near` are the
    /// points of a map nearby, such as the last one of a drag; without them the sides' default points stand in. [`PinSearch`]
    /// does the same in slices of time.
    ///
    /// Where a side's [equation](super::BoundaryEquation::resolves) does not resolve its point, the side is to be prepared
    /// anew with that point, and the constraints are to be computed again.
    pub fn constraints(
        &self,
        sides: PerSide<&PreparedSide>,
        near: Option<PerSide<InteriorPoint>>,
    ) -> Result<Constraints, PinError> {
        let near = near.unwrap_or(sides.map(PreparedSide::default_point));
        self.constraints_in(sides, near, &Slices::new(Deadline::NEVER))
    }

    /// [`Self::constraints`], found in steps of `slices`.
    fn constraints_in(
        &self,
        sides: PerSide<&PreparedSide>,
        near: PerSide<InteriorPoint>,
        slices: &Slices,
    ) -> Result<Constraints, PinError> {
        let triple = if self.0.len() == 3 { [0, 1, 2] } else { order::spread(&self.0) };
        let constraints = Three::new(triple.map(|k| self.0[k])).constraints(sides, near, slices)?;
        if self.0.len() == 3 {
            return Ok(constraints);
        }
        let fitted = self.fitted(sides, &constraints, slices)?;
        Three::new(fitted).constraints(sides, constraints.points, slices)
    }

    /// Three boundary pairs of the map that misses the pins least, as seen from the points of a map nearby.
    fn fitted(
        &self,
        sides: PerSide<&PreparedSide>,
        Constraints { points, anchors, .. }: &Constraints,
        slices: &Slices,
    ) -> Result<[PerSide<f64>; 3], PinError> {
        let view = |side| View::new((side, sides[side]), points[side], anchors[side], slices);
        let (source, target) = (view(Side::Source)?, view(Side::Target)?);
        let count = self.0.len();
        let neighbors = (0..count).map(|k| [k, (k + 1) % count, (k + 2) % count]);
        let triples: Vec<_> = std::iter::once(order::spread(&self.0)).chain(neighbors.take(MOST_BEGINNINGS)).collect();
        let fit = || {
            let best = Fit::new(&self.0, &source, &target).best(&triples)?;
            let first = source.omega(self.0[0].source);
            let thirds = [0.0, 1.0, 2.0].map(|k| first + k / 3.0);
            let from = source.fractions(thirds);
            let onto = target.fractions(thirds.map(|omega| best.omega(omega)));
            Some([0, 1, 2].map(|k| PerSide::new(if k == 0 { self.0[0].source } else { from[k] }, onto[k])))
        };
        slices.fit(fit).ok_or(PinError::NotFound { side: Side::Target })
    }

    /// The distance between the image of each pin's source and its target, in the target's units.
    pub fn misses(&self, map: &ConformalMap) -> Vec<f64> {
        self.0.iter().map(|&pair| miss(map, pair)).collect()
    }

    /// [`Self::misses`] of the map with the constraints of these pins. Errors: [`PinError::Missed`], one of three pins by
    /// more than a thousandth of the target's size.
    pub fn checked_misses(&self, map: &ConformalMap) -> Result<Vec<f64>, PinError> {
        let misses = self.misses(map);
        let target = map.side(Side::Target);
        let places = (0..target.boundary_count()).map(|k| target.boundary_place(BoundaryPoint::new(k as u32, 0.0)));
        let first = target.boundary_place(BoundaryPoint::new(0, 0.0));
        let size = places.map(|place| place.distance(first)).fold(0.0, f64::max);
        let missed =
            misses.iter().position(|&miss| miss.is_nan() || miss > MISSED * size).filter(|_| misses.len() == 3);
        match missed {
            Some(k) => Err(PinError::Missed { pin: k + 1, miss: misses[k] }),
            None => Ok(misses),
        }
    }
}

/// The distance between the image of a source's boundary point and the target's. A source within rounding of the anchor is
/// the anchor: in a crowded part their images may be far from each other.
fn miss(map: &ConformalMap, pair: PerSide<f64>) -> f64 {
    if let Some(curves) = map.curve_map(Side::Source) {
        let at = |side: Side| map.side(side).curve_boundary().map(|boundary| boundary.at_fraction(pair[side]));
        if let [Some(from), Some(onto)] = Side::BOTH.map(at) {
            let is_anchor = map.constraints().is_some_and(|known| order::is_same(known.anchors.source, pair.source));
            let image = if is_anchor { curves.onto_anchor() } else { curves.image(from) };
            let curve = curves.onto_curve();
            return curve.position(image).distance(curve.position(onto));
        }
    }
    let target = map.side(Side::Target);
    let image = map.image_by_samples(Side::Source, pair.source);
    target.boundary_place(image).distance(target.boundary_place(target.at_fraction(pair.target)))
}

/// The largest difference between two lists of measures.
fn difference(a: DVec2, b: DVec2) -> f64 {
    let d = a - b;
    d.x.abs().max(d.y.abs()).max((d.x + d.y).abs())
}

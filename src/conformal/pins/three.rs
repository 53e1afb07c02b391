//! The map through three pins.
//!
//! It is seen from a point of one side that sees the three arcs between the pins under comparable measures, so that no arc
//! is crowded, and from the point of the other side that sees the same measures. Where pins are close to each other, that
//! is first the point from which equal measures are seen on the side with the closer pins, which lies next to them.
//! The anchor is the first pin, or one whose surroundings are seen far less on some side: next to the anchor the smallest
//! measures keep their digits.

use super::arcs::Arcs;
use super::newton::{Found, Wanted};
use super::slices::Slices;
use super::view::View;
use super::{PinError, order, start};
use crate::conformal::{Constraints, InteriorPoint, MapError, PerSide, PreparedSide, Side};
use crate::geometry::DVec2;

/// Equal measures of the first two arcs, and so of the third.
const THIRDS: DVec2 = DVec2::splat(1.0 / 3.0);
/// The least measure of an arc from a point that need not be replaced.
const COMPARABLE: f64 = 0.1;
/// The largest difference of measures at a point nearby from which Newton's method begins.
const NEARBY: f64 = 0.2;

/// The least distance between two pins, as a share of the boundary's length, of a side that sees them from its middle.
const WIDE: f64 = 0.02;
/// The first pin is the anchor unless this share of its surroundings' density is more than another's.
const CROWDED: f64 = 1e-2;

/// Three pairs, counter-clockwise on both sides.
#[derive(Debug, Clone, Copy)]
pub struct Three([PerSide<f64>; 3]);

/// One side with the pins on it.
struct Marked<'a> {
    side: Side,
    prepared: &'a PreparedSide,
    marks: [f64; 3],
    slices: &'a Slices,
}

impl Three {
    /// The pairs, clockwise or counter-clockwise on both sides.
    pub fn new([a, b, c]: [PerSide<f64>; 3]) -> Self {
        let is_counter_clockwise = order::is_counter_clockwise([a, b, c].map(|pair| pair.source));
        Self(if is_counter_clockwise { [a, b, c] } else { [a, c, b] })
    }

    /// The constraints of the map through the pairs: that with the points `near`, if these see the arcs well. Found in
    /// steps of `slices`.
    pub fn constraints(
        &self,
        sides: PerSide<&PreparedSide>,
        near: PerSide<InteriorPoint>,
        slices: &Slices,
    ) -> Result<Constraints, PinError> {
        let marked = |side: Side| Marked { side, prepared: sides[side], marks: self.0.map(|pair| pair[side]), slices };
        let [source, target] = Side::BOTH.map(marked);
        let is_wide = source.least_gap().min(target.least_gap()) >= WIDE;
        let [free, other] = match freer([&source, &target], is_wide) {
            Side::Source => [&source, &target],
            Side::Target => [&target, &source],
        };
        if is_wide
            && let Some(first) = free.sees_well(near[free.side])
            && let Ok(second) = other.seeing(first.1.arcs(free.marks), near[other.side])
        {
            return Ok(self.between([free, other], [first, second]));
        }
        let first = free.middle()?;
        let second = other.seeing(first.1.arcs(free.marks), near[other.side])?;
        Ok(self.between([free, other], [first, second]))
    }

    /// The constraints with these points of a side and the other one.
    fn between(&self, [free, other]: [&Marked<'_>; 2], [first, second]: [Found<'_>; 2]) -> Constraints {
        let least = |k: usize| first.1.density(free.marks[k]).min(second.1.density(other.marks[k]));
        let crowded = [1, 2].into_iter().filter(|&k| least(k) < CROWDED * least(0));
        let anchor = crowded.min_by(|&j, &k| least(j).total_cmp(&least(k))).unwrap_or(0);
        let points = if free.side == Side::Source { [first.0, second.0] } else { [second.0, first.0] };
        Constraints { points: PerSide::from(points), anchors: self.0[anchor] }
    }
}

/// The side whose point is chosen first: the surface beside an outline, since points of a surface are those of its mesh
/// and the outline's point can adapt to them; else the side on which the pins are close to each other.
fn freer([source, target]: [&Marked<'_>; 2], is_wide: bool) -> Side {
    match (source.prepared.is_surface(), target.prepared.is_surface()) {
        (true, false) => Side::Source,
        (false, true) => Side::Target,
        _ if !is_wide && target.least_gap() < source.least_gap() => Side::Target,
        _ => Side::Source,
    }
}

impl<'a> Marked<'a> {
    fn view(&self, x: InteriorPoint) -> Result<View<'a>, MapError> {
        View::new((self.side, self.prepared), x, self.marks[0], self.slices)
    }

    fn wanted(&self, measures: DVec2) -> Wanted<'a> {
        let Self { side, prepared, marks, slices } = *self;
        Wanted { side, prepared, marks, measures, slices }
    }

    fn arcs(&self) -> Result<Arcs, PinError> {
        let arcs = Arcs::new(self.prepared, self.marks, self.slices);
        arcs.map_err(|error| PinError::NotConverged { side: self.side, error })
    }

    fn not_found(&self) -> PinError {
        PinError::NotFound { side: self.side }
    }

    /// The shortest distance between two marks along the boundary, as a share of its length.
    fn least_gap(&self) -> f64 {
        (0..3).map(|k| (self.marks[(k + 1) % 3] - self.marks[k]).rem_euclid(1.0)).fold(1.0, f64::min)
    }

    /// A point with the measures seen from it, if these are comparable.
    fn sees_well(&self, x: InteriorPoint) -> Option<Found<'a>> {
        let view = self.view(x).ok()?;
        let seen = view.arcs(self.marks);
        (seen.x.min(seen.y).min(1.0 - seen.x - seen.y) >= COMPARABLE).then_some((x, view))
    }

    /// The point that sees the arcs under equal measures; on a surface the vertex that sees them most nearly so.
    fn middle(&self) -> Result<Found<'a>, PinError> {
        let arcs = self.arcs()?;
        let vertex = self.slices.place(|| arcs.nearest(self.prepared, THIRDS)).ok_or(self.not_found())?;
        match vertex.in_plane() {
            Some(x) => self.found(THIRDS, [Some(x), start::beside_short_part(self.prepared, self.marks)]),
            None => Ok((vertex, self.view(vertex)?)),
        }
    }

    /// The point that sees these measures: found from one nearby, from finite elements, or next to a short part.
    fn seeing(&self, measures: DVec2, near: InteriorPoint) -> Result<Found<'a>, PinError> {
        let wanted = self.wanted(measures);
        if let InteriorPoint::Plane(x) = near
            && let Ok(Some(found)) = wanted.nearby(x, NEARBY)
        {
            return Ok(found);
        }
        let arcs = self.arcs()?;
        if self.prepared.is_surface() {
            return wanted.on_surface(&arcs)?.ok_or(self.not_found());
        }
        let from_mesh = self.slices.place(|| arcs.point(self.prepared, measures)).and_then(InteriorPoint::in_plane);
        self.found(measures, [from_mesh, start::beside_short_part(self.prepared, self.marks)])
    }

    /// The point of the plane that sees these measures, by Newton's method from the one of two places that sees them more
    /// nearly, or else from the other one.
    fn found(&self, measures: DVec2, starts: [Option<DVec2>; 2]) -> Result<Found<'a>, PinError> {
        let wanted = self.wanted(measures);
        let mut starts: Vec<(f64, DVec2)> =
            starts.into_iter().flatten().filter_map(|x| Some((wanted.off(x)?, x))).collect();
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.into_iter().find_map(|(_, x)| wanted.in_plane(x).ok().flatten()).ok_or(self.not_found())
    }
}

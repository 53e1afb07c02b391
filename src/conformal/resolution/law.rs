//! How the measure of a boundary is distributed between two knots: with finite elements or by the boundary integral.

use super::corner::Corner;
use crate::boundary_integral::AnchoredMeasure;
use crate::conformal::HarmonicMeasure;
use crate::conformal::curved::{CurveBoundary, SharpMeasure};
use crate::conformal::matching::inverse_quadratic;
use crate::outline::BoundaryPoint;

/// A harmonic measure from an anchor: of what lies before a point, or `late`, in the second half, of what remains.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Omega {
    /// Which far anchor; `None` from the map's own.
    pub far: Option<usize>,
    pub late: bool,
    pub value: f64,
}

impl Omega {
    /// The measure with `before` before and `after` after a point.
    pub fn new(before: f64, after: f64) -> Self {
        let late = before > 0.5;
        Self { far: None, late, value: if late { after } else { before } }
    }

    /// The measure before the point.
    pub fn forward(self) -> f64 {
        if self.late { 1.0 - self.value } else { self.value }
    }
}

/// The measure inside of the intervals between knots.
pub(super) enum Law<'a> {
    /// That of a density which is linear between knots, and next to corners a power. For each interval the law of a
    /// corner at or near one of its ends, if there is one.
    Finite(Vec<Option<Corner>>),
    /// That of the boundary integral along the curve.
    Curve(CurveLaw<'a>),
}

/// The measure of the boundary integral by the station from its anchor.
pub(super) struct CurveLaw<'a> {
    sharp: &'a SharpMeasure,
    anchored: AnchoredMeasure<'a>,
    /// The anchor's station.
    anchor: f64,
}

/// Steps between knots that are not told apart from 0: sums of the boundary integral have errors of a few 1e-16.
const NOISE: f64 = 4e-16;

impl<'a> CurveLaw<'a> {
    /// The law of a measure.
    pub fn new(sharp: &'a SharpMeasure) -> Self {
        Self { sharp, anchored: sharp.anchored(), anchor: sharp.boundary().station(sharp.anchor()) }
    }

    /// The curve.
    pub fn boundary(&self) -> &'a CurveBoundary {
        self.sharp.boundary()
    }

    /// The length of the way from the anchor to sample `k`, in stations.
    pub fn length_to(&self, k: usize) -> f64 {
        let boundary = self.boundary();
        (boundary.station(boundary.points()[k]) - self.anchor).rem_euclid(boundary.perimeter())
    }

    /// Whether finite elements continue the measure in the interval after knot `j`.
    fn is_continued(&self, j: usize) -> bool {
        self.sharp.is_continued(j) || self.sharp.is_continued(j + 1)
    }

    /// The measures before and after the point at `s` from the anchor.
    fn at(&self, s: f64) -> [f64; 2] {
        let point = self.boundary().at_station(self.anchor + s);
        [self.anchored.forward(point), self.anchored.backward(point)]
    }

    /// The length from the anchor to where the measure is `omega`, near `middle`.
    fn length_of(&self, omega: Omega, middle: f64) -> f64 {
        let point =
            if omega.late { self.anchored.point_before(omega.value) } else { self.anchored.point_at(omega.value) };
        let (s, perimeter) = (self.boundary().station(point) - self.anchor, self.boundary().perimeter());
        // the anchor is both the first and the last point
        s - perimeter * ((s - middle) / perimeter).round()
    }
}

/// An interval between two knots: its number, the lengths to its ends, and the measures before and after them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interval {
    pub knot: usize,
    pub lengths: [f64; 2],
    pub before: [f64; 2],
    pub after: [f64; 2],
}

impl Law<'_> {
    /// Whether the interval has no measure that can be told from none.
    pub fn is_flat(&self, Interval { knot, before, after, .. }: Interval) -> bool {
        let step = |[from, to]: [f64; 2]| to - from;
        match self {
            Self::Finite(_) => step(before) == 0.0 && step(after) == 0.0,
            Self::Curve(law) if law.is_continued(knot) => step(before) == 0.0 && step(after) == 0.0,
            Self::Curve(_) => step(before).abs() <= NOISE && step(after).abs() <= NOISE,
        }
    }

    /// The measure at the length `s` from the anchor, in this interval.
    pub fn at(&self, measure: &HarmonicMeasure, interval: Interval, s: f64) -> Omega {
        let Interval { knot, lengths: [from, to], before, after } = interval;
        let along = if to > from { ((s - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        let corner = match self {
            Self::Curve(law) if !law.is_continued(knot) => {
                let [forward, backward] = law.at(s);
                return Omega::new(forward.max(before[0]).min(before[1]), backward.max(after[1]).min(after[0]));
            }
            Self::Curve(_) => None,
            Self::Finite(corners) => corners[knot],
        };
        let share = match corner {
            Some(corner) if corner.is_after => 1.0 - corner.share(1.0 - along),
            Some(corner) => corner.share(along),
            None => measure.share(knot, along),
        };
        Omega::new(before[0] + (before[1] - before[0]) * share, after[1] + (after[0] - after[1]) * (1.0 - share))
    }

    /// The length from the anchor to where the measure is `omega`, in this interval.
    pub fn length_of(&self, measure: &HarmonicMeasure, interval: Interval, omega: Omega) -> f64 {
        let Interval { knot, lengths: [from, to], .. } = interval;
        let corner = match self {
            Self::Curve(law) if !law.is_continued(knot) => {
                return law.length_of(omega, 0.5 * (from + to)).max(from).min(to);
            }
            Self::Curve(_) => None,
            Self::Finite(corners) => corners[knot],
        };
        from + (to - from) * along(measure.density(), interval, omega, corner)
    }

    /// The curve's part of edge `k` before the anchor on it, if this is a measure along a curve.
    pub fn anchor_share(&self, anchor: BoundaryPoint, edge: f64) -> f64 {
        match self {
            Self::Curve(law) if anchor.fraction() > 0.0 => {
                let back = law.boundary().perimeter() - law.length_to(anchor.edge() as usize);
                (back / edge).clamp(0.0, 1.0)
            }
            _ => anchor.fraction(),
        }
    }
}

/// The part of the interval before the measure `omega`.
fn along(density: &[f64], interval: Interval, omega: Omega, corner: Option<Corner>) -> f64 {
    let Interval { knot, before, after, .. } = interval;
    let (rest, step) = if omega.late {
        (omega.value - after[1], after[0] - after[1])
    } else {
        (omega.value - before[0], before[1] - before[0])
    };
    if rest <= 0.0 || step <= 0.0 {
        return if omega.late { 1.0 } else { 0.0 };
    }
    let share = (rest / step).min(1.0);
    let part = match corner {
        Some(corner) if corner.is_after == omega.late => corner.along(share),
        Some(corner) => 1.0 - corner.along(1.0 - share),
        None if omega.late => inverse_quadratic(rest, step, density[knot + 1], density[knot]),
        None => inverse_quadratic(rest, step, density[knot], density[knot + 1]),
    };
    if omega.late { 1.0 - part } else { part }
}

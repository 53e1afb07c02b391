//! The map of the rectangle's boundary onto the outline.

use super::channel::Channel;
use super::middle::turned;
use super::side::{QuadrilateralSide, SideEnd, sides};
use super::{Quadrilateral, Resolved, Seen};
use crate::boundary_integral::AnchoredMeasure;
use crate::cauchy_integral::BoundaryFunction;
use crate::geometry::{Curve, CurvePoint, DVec2, Junction};
use std::cmp::Ordering;

/// The map of the rectangle's boundary onto the outline, by the measures of one resolution.
struct SideMaps<'a> {
    corners: [CurvePoint; 4],
    /// The measure counted from each corner.
    anchors: [AnchoredMeasure<'a>; 4],
    sides: [QuadrilateralSide; 4],
}

impl<'a> SideMaps<'a> {
    fn new(corners: [CurvePoint; 4], resolved: &'a Resolved) -> Self {
        let anchors = corners.map(|corner| resolved.measure.from_anchor(corner));
        Self { corners, anchors, sides: sides(resolved.arcs, resolved.modulus) }
    }

    /// The image of a point of the rectangle, whose piece k is the side from corner k to the next one. Measure is counted
    /// from the nearer end.
    fn image(&self, at: CurvePoint) -> CurvePoint {
        let (start, finish) = (at.piece(), (at.piece() + 1) % 4);
        let side = &self.sides[start];
        match at {
            _ if at.from_start() == 0.0 => self.corners[start],
            _ if at.to_end() == 0.0 => self.corners[finish],
            _ if at.from_start() <= at.to_end() => {
                self.anchors[start].point_at(side.measure(SideEnd::Start, at.from_start()))
            }
            _ => self.anchors[finish].point_before(side.measure(SideEnd::Finish, at.to_end())),
        }
    }

    /// The point of the rectangle that goes to a point of the outline, which is no corner of the quadrilateral.
    fn preimage(&self, point: CurvePoint) -> Option<CurvePoint> {
        let k = (0..4).find(|&k| is_between(self.corners[k], point, self.corners[(k + 1) % 4]))?;
        let [forward, backward] = [self.anchors[k].forward(point), self.anchors[(k + 1) % 4].backward(point)];
        let from_start = || self.sides[k].share(SideEnd::Start, forward).map(|t| CurvePoint::new(k, t));
        let from_finish = || self.sides[k].share(SideEnd::Finish, backward).map(|t| CurvePoint::before_end(k, t));
        from_start().or_else(from_finish)
    }
}

/// The map of the rectangle's boundary onto the outline, at one resolution.
#[allow(clippy::large_enum_variant, reason = "there are two of them at a time")]
enum Maps<'a> {
    Middle(SideMaps<'a>),
    /// Of a long quadrilateral whose first side is the side `turn`.
    Channel {
        turn: usize,
        corners: [CurvePoint; 4],
        channel: Channel<'a>,
    },
}

impl Maps<'_> {
    fn image(&self, at: CurvePoint) -> CurvePoint {
        match self {
            Self::Middle(sides) => sides.image(at),
            Self::Channel { turn, channel, .. } => channel.image(on_side(at, at.piece() + 4 - turn)),
        }
    }

    fn preimage(&self, point: CurvePoint) -> Option<CurvePoint> {
        match self {
            Self::Middle(sides) => sides.preimage(point),
            Self::Channel { turn, corners, channel } => {
                let side = (0..4).find(|&k| is_between(corners[k], point, corners[(k + 1) % 4]))?;
                let found = channel.preimage(side, point);
                Some(on_side(found, side + turn))
            }
        }
    }
}

/// The point of another side of the rectangle at the same share.
fn on_side(at: CurvePoint, side: usize) -> CurvePoint {
    if at.from_start() <= at.to_end() {
        CurvePoint::new(side % 4, at.from_start())
    } else {
        CurvePoint::before_end(side % 4, at.to_end())
    }
}

/// The order of two points along the curve from its first one.
fn order(a: CurvePoint, b: CurvePoint) -> Ordering {
    a.piece().cmp(&b.piece()).then(a.from_start().total_cmp(&b.from_start())).then(b.to_end().total_cmp(&a.to_end()))
}

/// Whether `b` is met strictly between `a` and `c` on the way from `a` counter-clockwise.
fn is_between(a: CurvePoint, b: CurvePoint, c: CurvePoint) -> bool {
    let is_behind = |p: CurvePoint, q: CurvePoint| order(p, q) == Ordering::Less;
    match (is_behind(a, b), is_behind(b, c), is_behind(c, a)) {
        (true, true, _) => true,
        (true, false, wraps) | (false, true, wraps) => wraps,
        (false, false, _) => false,
    }
}

/// The map of the rectangle's boundary onto the outline, and its error from two resolutions.
pub struct BoundaryMap<'a> {
    curve: &'a Curve,
    coarse: Maps<'a>,
    fine: Maps<'a>,
    /// The error of a position that is known exactly.
    rounding: f64,
}

/// The difference of two resolutions, this many times, as for the invariants.
const SAFETY: f64 = 2.0;

impl<'a> BoundaryMap<'a> {
    pub fn new(quadrilateral: &'a Quadrilateral) -> Self {
        let Quadrilateral { curve, corners, seen, .. } = quadrilateral;
        let [coarse, fine] = match seen {
            Seen::Middle(both) => both.each_ref().map(|resolved| Maps::Middle(SideMaps::new(*corners, resolved))),
            Seen::Channel { turn, measures } => measures.each_ref().map(|measures| {
                let (turn, corners) = (*turn, turned(*corners, *turn));
                Maps::Channel { turn, corners, channel: Channel::new(corners, measures) }
            }),
        };
        let rounding = f64::EPSILON * curve.position(corners[0]).length().max(curve.perimeter());
        Self { curve, coarse, fine, rounding }
    }

    /// The points of the rectangle that go to points where the outline is not analytic.
    pub fn breaks(&self) -> Vec<CurvePoint> {
        let junctions = self.curve.junctions().iter().enumerate();
        let broken = junctions.filter(|(_, kind)| **kind != Junction::Analytic);
        broken.filter_map(|(k, _)| self.fine.preimage(CurvePoint::new(k, 0.0))).collect()
    }
}

impl BoundaryFunction for BoundaryMap<'_> {
    fn value(&self, at: CurvePoint) -> DVec2 {
        self.curve.position(self.fine.image(at))
    }

    fn error(&self, at: CurvePoint) -> f64 {
        SAFETY * self.curve.position(self.coarse.image(at)).distance(self.value(at)) + self.rounding
    }
}

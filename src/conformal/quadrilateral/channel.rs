//! Long quadrilaterals: seen from many points along them, the frames (`frame`), because from any one point the far ends have
//! measures below rounding.
//!
//! With the strip coordinate X between the corners c₀ and c₂ and α = e^{πX(c₁)}, β = e^{πX(c₃)}, the rectangle
//! [0, 1] × [0, M] is at its end next to the side c₀c₁, and up to e^{−πM}, a half-strip: e^{πX} = α sin²(πu/2) on that
//! side, α sinh²(πv/2) and α cosh²(πv/2) at the height v beside it, α e^{πv}/4 farther away; at the other end the same
//! after half a turn. So e^{πM} = 16β/α: M = X(c₃) − X(c₁) + log 16/π, without any small number. X is carried from frame to
//! frame through the points between them, which both see well.

use super::QuadrilateralError;
use super::frame::{Frame, sign};
use crate::boundary_integral::{BoundaryIntegral, BoundaryIntegralError, Estimate, HarmonicMeasure};
use crate::geometry::{Curve, CurvePoint, DVec2};
use std::f64::consts::{LN_2, PI};

/// Quadrilaterals of at least this extremal distance between their ends are taken for long: e^{−πM} is 2e-14 and less.
pub const LONG: f64 = 10.0;

/// The step from one point of view to the next while the ends are looked for, in widths.
const STEP: f64 = 2.5;
/// The measure from which an end counts as seen: one that is a step and a half away has 5e-6.
const SEEN: f64 = 1e-6;
/// The distance of the outer points of view from the ends, in widths.
const BEFORE_END: f64 = 1.0;
/// The largest distance between points of view: halfway, digits lose e^{π} = 23.
const SPACING: f64 = 2.0;
/// The most steps: a limit only of what goes wrong, since the equation has 32 unknowns or more for each width.
const MOST_STEPS: usize = 4096;
/// Halvings of a step that leads out of the curve.
const HALVINGS: usize = 5;

/// A point of view and what is seen from there, before it has its place along the channel.
type View = (DVec2, HarmonicMeasure);

/// The points of view along a long quadrilateral, evenly spaced; `None` if it is none: it is shorter than [`LONG`], or no
/// way along it is found from `start`.
pub fn points_of_view(
    (curve, corners): (&Curve, [CurvePoint; 4]),
    integral: &BoundaryIntegral,
    start: DVec2,
) -> Result<Option<Vec<DVec2>>, QuadrilateralError> {
    let first = integral.harmonic_measure(start)?;
    let middle = Frame::new(corners, &first, 0.0).place(curve, 0.0);
    let middle = if curve.contains(middle) { middle } else { start };
    let origin = (middle, integral.harmonic_measure(middle)?);
    let Some(before) = march((curve, corners), integral, &origin, 0)? else { return Ok(None) };
    let Some(after) = march((curve, corners), integral, &origin, 1)? else { return Ok(None) };
    let views: Vec<View> = before.into_iter().rev().chain([origin]).chain(after).collect();
    let channel = Channel::new(corners, views.iter().map(|(_, measure)| measure));
    if channel.modulus.is_nan() || channel.modulus < LONG {
        return Ok(None);
    }
    let room = channel.modulus - 2.0 * BEFORE_END;
    let steps = (room / SPACING).ceil();
    let place = |k: usize| {
        let coordinate = channel.ends[0] + BEFORE_END + room * k as f64 / steps;
        let place = channel.frame(coordinate).place(curve, coordinate);
        curve.contains(place).then_some(place)
    };
    Ok((0..=steps as usize).map(place).collect())
}

/// The views from a point up to the end at which an arc begins, without the first one; `None` if no end is reached.
fn march(
    (curve, corners): (&Curve, [CurvePoint; 4]),
    integral: &BoundaryIntegral,
    origin: &View,
    arc: usize,
) -> Result<Option<Vec<View>>, BoundaryIntegralError> {
    let mut views: Vec<View> = Vec::new();
    for _ in 0..MOST_STEPS {
        let (x, measure) = views.last().unwrap_or(origin);
        let frame = Frame::new(corners, measure, 0.0);
        if frame.end(arc) >= SEEN {
            return Ok(Some(views));
        }
        let steps = std::iter::successors(Some(STEP), |step| Some(0.5 * step)).take(HALVINGS);
        let mut places = steps.map(|step| frame.place(curve, -sign(arc) * step));
        let Some(next) = places.find(|place| place != x && curve.contains(*place)) else { return Ok(None) };
        let measure = integral.harmonic_measure(next)?;
        views.push((next, measure));
    }
    Ok(None)
}

/// A long quadrilateral, seen at one resolution of the equation.
#[derive(Debug, Clone)]
pub struct Channel<'a> {
    corners: [CurvePoint; 4],
    /// In the order from c₀c₁ to c₂c₃.
    frames: Vec<Frame<'a>>,
    /// X of c₁ and of c₃.
    tips: [f64; 2],
    /// X of the rectangle's ends.
    ends: [f64; 2],
    /// The extremal distance between the sides c₀c₁ and c₂c₃.
    pub modulus: f64,
    /// The sum of the differences at the joints of frames.
    mismatch: f64,
}

impl<'a> Channel<'a> {
    /// From the measures seen from points along it.
    pub fn new(corners: [CurvePoint; 4], measures: impl IntoIterator<Item = &'a HarmonicMeasure>) -> Self {
        let (mut frames, mut mismatch): (Vec<Frame<'a>>, f64) = (Vec::new(), 0.0);
        for measure in measures {
            let frame = Frame::new(corners, measure, 0.0);
            let Some(last) = frames.last() else {
                frames.push(frame);
                continue;
            };
            // the distance, roughly, and then halfway
            let (rough, _) = frame.clone().joined(last, last.center + 0.5 * STEP);
            let (joined, difference) = frame.joined(last, 0.5 * (last.center + rough.center));
            mismatch += difference;
            frames.push(joined);
        }
        let tips = [&frames[0], &frames[frames.len() - 1]];
        let tips = [0, 1].map(|arc| tips[arc].coordinate(arc, corners[2 * arc + 1]));
        let ends = [tips[0] - 2.0 * LN_2 / PI, tips[1] + 2.0 * LN_2 / PI];
        Self { corners, frames, tips, ends, modulus: ends[1] - ends[0], mismatch }
    }

    /// The frame whose point of view is the nearest one.
    fn frame(&self, coordinate: f64) -> &Frame<'a> {
        let next = self.frames.partition_point(|frame| frame.center < coordinate);
        let pair = [next.max(1) - 1, next.min(self.frames.len() - 1)];
        let away = |k: usize| (self.frames[k].center - coordinate).abs();
        &self.frames[if away(pair[0]) <= away(pair[1]) { pair[0] } else { pair[1] }]
    }

    /// The frame that sees the end at which an arc begins.
    fn outer(&self, arc: usize) -> &Frame<'a> {
        &self.frames[if arc == 0 { 0 } else { self.frames.len() - 1 }]
    }

    /// The image of a point of the rectangle's boundary, whose pieces are the sides from corner to corner.
    pub fn image(&self, at: CurvePoint) -> CurvePoint {
        let (arc, start, finish) = (at.piece() / 2, at.from_start(), at.to_end());
        if start == 0.0 || finish == 0.0 {
            return self.corners[(at.piece() + usize::from(finish == 0.0)) % 4];
        }
        let sine = |share: f64| (0.5 * PI * share).sin();
        if at.piece() % 2 == 1 {
            let [from, to] = [start, finish].map(|share| share * self.modulus);
            if from < BEFORE_END {
                return self.outer(arc).beside(arc, true, (0.5 * PI * from).sinh().powi(2));
            }
            return self.at(arc, sign(arc) * self.ends[arc] + along([from, to]));
        }
        if start <= finish {
            self.at(arc, sign(arc) * self.tips[arc] + 2.0 * sine(start).ln() / PI)
        } else {
            self.outer(arc).beside(arc, false, sine(finish).powi(2))
        }
    }

    /// The point of an arc whose coordinate in the direction of the arc is this one.
    fn at(&self, arc: usize, along: f64) -> CurvePoint {
        let coordinate = sign(arc) * along;
        self.frame(coordinate).point(arc, coordinate)
    }

    /// The point of the rectangle's side that goes to a point of the outline between its ends; approximately, if the side
    /// is long and the point is far from its ends.
    pub fn preimage(&self, side: usize, point: CurvePoint) -> CurvePoint {
        let (arc, outer) = (side / 2, self.outer(side / 2));
        let share = |square: f64| square.sqrt().min(1.0).asin() / (0.5 * PI);
        if side.is_multiple_of(2) {
            let from_start = PI * sign(arc) * (outer.coordinate(arc, point) - self.tips[arc]);
            let from_start = share(from_start.exp());
            return if from_start <= 0.5 {
                CurvePoint::new(side, from_start)
            } else {
                CurvePoint::before_end(side, share(outer.square(arc, false, point)))
            };
        }
        let height = 2.0 * outer.square(arc, true, point).sqrt().asinh() / PI;
        if height <= BEFORE_END {
            return CurvePoint::new(side, height / self.modulus);
        }
        let nearest = self.nearest(arc, point);
        let to = height_below(sign(arc) * (self.ends[1 - arc] - nearest.coordinate(arc, point)), self.modulus);
        if to <= 0.5 * self.modulus {
            CurvePoint::before_end(side, to / self.modulus)
        } else {
            CurvePoint::new(side, 1.0 - to / self.modulus)
        }
    }

    /// The frame that sees a point of an arc best.
    fn nearest(&self, arc: usize, point: CurvePoint) -> &Frame<'a> {
        let away = |frame: &Frame<'a>| {
            let away = (frame.coordinate(arc, point) - frame.center).abs();
            if away.is_nan() { f64::INFINITY } else { away }
        };
        let best = self.frames.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        best.unwrap_or_else(|| self.outer(arc))
    }

    /// The modulus at the finer of two resolutions, `fine`, with its error: the difference of both, and what the joints of
    /// the frames leave open.
    pub fn estimate(coarse: &Self, fine: &Self) -> Estimate {
        let rounding = 32.0 * f64::EPSILON * fine.modulus + (-PI * fine.modulus).exp();
        let difference = (fine.modulus - coarse.modulus).abs();
        Estimate { value: fine.modulus, error: 2.0 * (difference + fine.mismatch) + rounding }
    }
}

/// The coordinate along a long side, from that of its rectangle's end, at these distances from both ends.
fn along([from, to]: [f64; 2]) -> f64 {
    from + 2.0 / PI * ((-PI * from).exp().ln_1p() - (-(-PI * to).exp_m1()).ln())
}

/// The distance `to` from the far end of a side of this length at which [`along`] is less by `below` than the length.
fn height_below(below: f64, length: f64) -> f64 {
    let (mut low, mut high) = (0.0, length);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if length - along([length - middle, middle]) <= below {
            low = middle;
        } else {
            high = middle;
        }
    }
}

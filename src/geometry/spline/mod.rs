//! Interpolating cubic splines by chord length: twice continuously differentiable curves through given points.
//!
//! The parameter between two points is their distance. On points of a smooth curve at distance h the position is
//! right to O(h⁴), the tangent to O(h³), the curvature to O(h²) (Floater 2006, on chord-length cubic splines).

use glam::DVec2;

mod slopes;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use super::Jet;
use super::curve::integral;
use slopes::Rows;

/// A curve of cubic polynomials through points, twice continuously differentiable by its parameter u, the sum of the
/// distances between the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// u at each point; the first is 0.
    knots: Vec<f64>,
    points: Vec<DVec2>,
    /// dz/du at each point.
    slopes: Vec<DVec2>,
    /// The length of the curve up to each point.
    arcs: Vec<f64>,
    /// What the points leave open of the position around each knot: |h⁴ z⁗|/384 (Hall and Meyer 1976), z⁗ by the jump
    /// of z‴.
    open: Vec<f64>,
}

impl Spline {
    /// The spline from the first to the last point: a line through two, a parabola through three, otherwise with the
    /// condition that the third derivative is continuous at the second and the last but one ("not a knot").
    ///
    /// `None` if there are fewer than two points, two neighbors are equal, or a point is not finite. Cost O(n).
    pub fn open(points: &[DVec2]) -> Option<Self> {
        let (knots, lengths, chords) = chords(points)?;
        let slopes = match *lengths.as_slice() {
            [] => return None,
            [_] => vec![chords[0]; 2],
            [a, b] => {
                let middle = (b * chords[0] + a * chords[1]) / (a + b);
                vec![2.0 * chords[0] - middle, middle, 2.0 * chords[1] - middle]
            }
            _ => Rows::open(&lengths, &chords).solved(),
        };
        Some(Self::with_slopes(knots, points.to_vec(), slopes))
    }

    /// The periodic spline through at least three points and back to the first. `None` as for [`Self::open`].
    pub fn closed(points: &[DVec2]) -> Option<Self> {
        let around: Vec<DVec2> = points.iter().chain(points.first()).copied().collect();
        let (knots, lengths, chords) = chords(&around)?;
        if points.len() < 3 {
            return None;
        }
        let mut slopes = Rows::closed_slopes(&lengths, &chords);
        slopes.push(slopes[0]);
        Some(Self::with_slopes(knots, around, slopes))
    }

    fn with_slopes(knots: Vec<f64>, points: Vec<DVec2>, slopes: Vec<DVec2>) -> Self {
        let mut spline = Self { knots, points, slopes, arcs: vec![0.0], open: Vec::new() };
        let mut length = 0.0;
        for k in 0..spline.points.len() - 1 {
            length += Local::new(&spline, k, true).length_to(1.0);
            spline.arcs.push(length);
        }
        let last = spline.points.len() - 1;
        let width = |k: usize| spline.span([k - 1, k]).max(spline.span([k, k + 1]));
        let at_knot = |k: usize| spline.third_jump(k) * width(k) / 384.0;
        // at an end, and at the knot next to it where nothing jumps, as at the third knot
        spline.open = (0..=last).map(|k| if last < 4 { 0.0 } else { at_knot(k.clamp(2, last - 2)) }).collect();
        spline
    }

    /// The number of points, with the first one again at the end of a closed spline.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no points; never.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Whether no derivative has overflowed.
    pub fn is_finite(&self) -> bool {
        self.slopes.iter().all(|slope| slope.is_finite()) && self.arcs.last().is_some_and(|length| length.is_finite())
    }

    /// The cubic polynomials as Bézier curves, one from each point to the next.
    pub fn cubics(&self) -> impl ExactSizeIterator<Item = [DVec2; 4]> + '_ {
        (0..self.points.len() - 1).map(|k| {
            let [a, d] = [self.points[k], self.points[k + 1]];
            let third = (self.knots[k + 1] - self.knots[k]) / 3.0;
            [a, a + third * self.slopes[k], d - third * self.slopes[k + 1], d]
        })
    }

    /// The points at the knots.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// dz/du at a knot.
    pub fn slope(&self, knot: usize) -> DVec2 {
        self.slopes[knot]
    }

    /// u from the first to the second knot; negative if that is the earlier one.
    pub fn span(&self, [from, to]: [usize; 2]) -> f64 {
        self.knots[to] - self.knots[from]
    }

    /// |z‴(k+) − z‴(k−)| h² at an inner knot k, the derivatives by u, h the longer one of the intervals beside it.
    pub fn third_jump(&self, k: usize) -> f64 {
        let widths = [self.span([k - 1, k]), self.span([k, k + 1])];
        let third = |side: usize| 6.0 * Local::new(self, k - 1 + side, true).three / widths[side].powi(3);
        (third(1) - third(0)).length() * widths[0].max(widths[1]).powi(2)
    }

    /// Position and derivatives by t = u/length at t in [0, 1].
    pub fn jet(&self, t: f64) -> Jet {
        self.jet_between([0, self.points.len() - 1], t)
    }

    /// Position and derivatives by t in [0, 1] of the part between two knots, t in proportion to u; backwards if the
    /// second knot is the earlier one.
    pub fn jet_between(&self, ends: [usize; 2], t: f64) -> Jet {
        let place = self.locate(ends, t);
        Jet { position: place.local.start + place.local.offset(place.v), ..place.jet() }
    }

    /// As [`Self::jet_between`], with the offset from the first knot as the position: with its relative accuracy up to
    /// the next knot, and as a difference of positions beyond.
    pub fn offset_between(&self, ends: [usize; 2], t: f64) -> Jet {
        let place = self.locate(ends, t);
        let from_start = place.local.start - self.points[ends[0]];
        Jet { position: from_start + place.local.offset(place.v), ..place.jet() }
    }

    /// The length of the part between two knots up to t.
    pub fn length_between(&self, ends: [usize; 2], t: f64) -> f64 {
        let place = self.locate(ends, t);
        let begin = if ends[0] <= ends[1] { place.interval } else { place.interval + 1 };
        (self.arcs[begin] - self.arcs[ends[0]]).abs() + place.local.length_to(place.v)
    }

    /// A bound of the distance that a smooth curve through the points may have from the part [low, high] of t.
    pub fn left_open(&self, [from, to]: [usize; 2], [low, high]: [f64; 2]) -> f64 {
        let at = |t: f64| self.knots[from] + t * self.span([from, to]);
        let (a, b) = (at(low).min(at(high)), at(low).max(at(high)));
        let first = self.knots.partition_point(|&knot| knot <= a).max(1) - 1;
        let end = (self.knots.partition_point(|&knot| knot < b) + 1).clamp(first + 1, self.knots.len());
        self.open[first..end].iter().copied().fold(0.0, f64::max)
    }

    /// The knots strictly inside of [low, high] of t of a part, as values of t, with their indices.
    pub fn knots_between(
        &self,
        [from, to]: [usize; 2],
        [low, high]: [f64; 2],
    ) -> impl Iterator<Item = (f64, usize)> + '_ {
        let span = self.knots[to] - self.knots[from];
        let at = move |t: f64| self.knots[from] + t * span;
        let (a, b) = (at(low).min(at(high)), at(low).max(at(high)));
        let first = self.knots.partition_point(|&knot| knot <= a);
        let end = self.knots.partition_point(|&knot| knot < b).max(first);
        (first..end).map(move |k| ((self.knots[k] - self.knots[from]) / span, k))
    }

    /// The interval at t of a part, and the place in it in the direction of the part.
    fn locate(&self, [from, to]: [usize; 2], t: f64) -> Place {
        let is_forward = from <= to;
        let span = (self.knots[to] - self.knots[from]).abs();
        let du = t.clamp(0.0, 1.0) * span;
        let first = if is_forward { from } else { from - 1 };
        let first_width = self.knots[first + 1] - self.knots[first];
        let interval = if du <= first_width {
            first
        } else {
            let u = if is_forward { self.knots[from] + du } else { self.knots[from] - du };
            let below = self.knots.partition_point(|&knot| knot <= u).max(1) - 1;
            below.clamp(from.min(to), from.max(to) - 1)
        };
        let h = self.knots[interval + 1] - self.knots[interval];
        let begin = if is_forward {
            self.knots[interval] - self.knots[from]
        } else {
            self.knots[from] - self.knots[interval + 1]
        };
        let local = Local::new(self, interval, is_forward);
        Place { interval, local, v: (du - begin) / h, rate: span / h }
    }
}

/// A place of a spline: an interval between two knots and v in [0, 1].
struct Place {
    interval: usize,
    local: Local,
    v: f64,
    /// dv/dt.
    rate: f64,
}

impl Place {
    /// The derivatives by t; the position is 0.
    fn jet(&self) -> Jet {
        let (v, local) = (self.v, &self.local);
        Jet {
            position: DVec2::ZERO,
            first: self.rate * local.velocity(v),
            second: self.rate * self.rate * (2.0 * local.two + 6.0 * v * local.three),
        }
    }
}

/// The polynomial of one interval, z = start + v (one + v (two + v three)) for v in [0, 1].
struct Local {
    start: DVec2,
    one: DVec2,
    two: DVec2,
    three: DVec2,
}

impl Local {
    fn new(spline: &Spline, k: usize, is_forward: bool) -> Self {
        let h = spline.knots[k + 1] - spline.knots[k];
        let ([a, d], [m, n]) = if is_forward {
            ([spline.points[k], spline.points[k + 1]], [h * spline.slopes[k], h * spline.slopes[k + 1]])
        } else {
            ([spline.points[k + 1], spline.points[k]], [-h * spline.slopes[k + 1], -h * spline.slopes[k]])
        };
        let rise = d - a;
        Self { start: a, one: m, two: 3.0 * rise - 2.0 * m - n, three: m + n - 2.0 * rise }
    }

    fn offset(&self, v: f64) -> DVec2 {
        v * (self.one + v * (self.two + v * self.three))
    }

    fn velocity(&self, v: f64) -> DVec2 {
        self.one + v * (2.0 * self.two + 3.0 * v * self.three)
    }

    fn length_to(&self, v: f64) -> f64 {
        integral(v, |s| self.velocity(s).length())
    }
}

/// The knots, the distances, and the chords divided by them.
type Chords = (Vec<f64>, Vec<f64>, Vec<DVec2>);

fn chords(points: &[DVec2]) -> Option<Chords> {
    let lengths: Vec<f64> = points.windows(2).map(|w| w[0].distance(w[1])).collect();
    if !lengths.iter().all(|&length| length > 0.0 && length.is_finite()) {
        return None;
    }
    let chords = points.windows(2).zip(&lengths).map(|(w, length)| (w[1] - w[0]) / *length).collect();
    let mut u = 0.0;
    let knots = std::iter::once(0.0).chain(lengths.iter().map(|length| {
        u += length;
        u
    }));
    Some((knots.collect(), lengths, chords))
}

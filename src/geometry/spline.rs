//! Interpolating cubic splines by chord length: twice continuously differentiable curves through given points.
//!
//! The parameter between two points is their distance. On points of a smooth curve at distance h the position is
//! right to O(h⁴), the tangent to O(h³), the curvature to O(h²) (Floater 2006, on chord-length cubic splines).

use glam::DVec2;

use super::Jet;

/// A curve of cubic polynomials through points, twice continuously differentiable by its parameter u, the sum of the
/// distances between the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// u at each point; the first is 0.
    knots: Vec<f64>,
    points: Vec<DVec2>,
    /// dz/du at each point.
    slopes: Vec<DVec2>,
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
        Some(Self { knots, points: points.to_vec(), slopes })
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
        Some(Self { knots, points: around, slopes })
    }

    /// The number of points, with the first one again at the end of a closed spline.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there are no points; never.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// The cubic polynomials as Bézier curves, one from each point to the next.
    pub fn cubics(&self) -> impl ExactSizeIterator<Item = [DVec2; 4]> + '_ {
        (0..self.points.len() - 1).map(|k| {
            let [a, d] = [self.points[k], self.points[k + 1]];
            let third = (self.knots[k + 1] - self.knots[k]) / 3.0;
            [a, a + third * self.slopes[k], d - third * self.slopes[k + 1], d]
        })
    }

    /// Position and derivatives by t = u/length at t in [0, 1].
    pub fn jet(&self, t: f64) -> Jet {
        let length = self.knots[self.knots.len() - 1];
        let u = t.clamp(0.0, 1.0) * length;
        let k = (self.knots.partition_point(|&knot| knot <= u).max(1) - 1).min(self.points.len() - 2);
        let h = self.knots[k + 1] - self.knots[k];
        let v = (u - self.knots[k]) / h;
        let (rise, [m, n]) = (self.points[k + 1] - self.points[k], [h * self.slopes[k], h * self.slopes[k + 1]]);
        // z = a + m v + (3 rise − 2 m − n) v² + (m + n − 2 rise) v³
        let (two, three) = (3.0 * rise - 2.0 * m - n, m + n - 2.0 * rise);
        let rate = length / h;
        Jet {
            position: self.points[k] + v * (m + v * (two + v * three)),
            first: rate * (m + v * (2.0 * two + 3.0 * v * three)),
            second: rate * rate * (2.0 * two + 6.0 * v * three),
        }
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

/// A tridiagonal system for the slopes: `lower[k] m_{k−1} + diagonal[k] m_k + upper[k] m_{k+1} = right[k]`.
struct Rows {
    lower: Vec<f64>,
    diagonal: Vec<f64>,
    upper: Vec<f64>,
    right: Vec<DVec2>,
}

/// Continuity of the second derivative between intervals of lengths a and b with chords p and q.
fn smooth_row([a, b]: [f64; 2], [p, q]: [DVec2; 2]) -> ([f64; 3], DVec2) {
    ([b, 2.0 * (a + b), a], 3.0 * (b * p + a * q))
}

impl Rows {
    /// The system with "not a knot" at both ends, for at least three intervals.
    fn open(lengths: &[f64], chords: &[DVec2]) -> Self {
        let n = lengths.len();
        // a is the outermost interval, b the next; p and q their chords
        let end = |a: f64, b: f64, p: DVec2, q: DVec2| ((3.0 * a + 2.0 * b) * b * p + a * a * q) / (a + b);
        let mut rows = Self {
            lower: vec![0.0],
            diagonal: vec![lengths[1]],
            upper: vec![lengths[0] + lengths[1]],
            right: vec![end(lengths[0], lengths[1], chords[0], chords[1])],
        };
        for k in 1..n {
            rows.push(smooth_row([lengths[k - 1], lengths[k]], [chords[k - 1], chords[k]]));
        }
        rows.lower.push(lengths[n - 1] + lengths[n - 2]);
        rows.diagonal.push(lengths[n - 2]);
        rows.upper.push(0.0);
        rows.right.push(end(lengths[n - 1], lengths[n - 2], chords[n - 1], chords[n - 2]));
        rows
    }

    /// The slopes of the periodic spline. The cyclic system is A + u vᵀ with a tridiagonal A, solved by the formula of
    /// Sherman and Morrison.
    fn closed_slopes(lengths: &[f64], chords: &[DVec2]) -> Vec<DVec2> {
        let n = lengths.len();
        let mut rows = Self { lower: vec![], diagonal: vec![], upper: vec![], right: vec![] };
        for k in 0..n {
            let before = (k + n - 1) % n;
            rows.push(smooth_row([lengths[before], lengths[k]], [chords[before], chords[k]]));
        }
        // the corner entries: row 0 has `top` at column n − 1, row n − 1 has `bottom` at column 0
        let (top, bottom) = (rows.lower[0], rows.upper[n - 1]);
        let gamma = -rows.diagonal[0];
        rows.diagonal[0] -= gamma;
        rows.diagonal[n - 1] -= top * bottom / gamma;
        let mut column = vec![DVec2::ZERO; n];
        column[0].x = gamma;
        column[n - 1].x = bottom;
        let right = std::mem::replace(&mut rows.right, column);
        let correction = rows.solved();
        rows.right = right;
        let mut slopes = rows.solved();
        let v = |x: &[DVec2]| x[0] + (top / gamma) * x[n - 1];
        let factor = v(&slopes) / (1.0 + v(&correction).x);
        for (slope, c) in slopes.iter_mut().zip(&correction) {
            *slope -= factor * c.x;
        }
        slopes
    }

    fn push(&mut self, ([lower, diagonal, upper], right): ([f64; 3], DVec2)) {
        self.lower.push(lower);
        self.diagonal.push(diagonal);
        self.upper.push(upper);
        self.right.push(right);
    }

    /// Elimination without exchange of rows; after the first row the system is diagonally dominant.
    fn solved(&self) -> Vec<DVec2> {
        let n = self.diagonal.len();
        let (mut pivots, mut x) = (self.diagonal.clone(), self.right.clone());
        for k in 1..n {
            let factor = self.lower[k] / pivots[k - 1];
            pivots[k] -= factor * self.upper[k - 1];
            let above = x[k - 1];
            x[k] -= factor * above;
        }
        for k in (0..n).rev() {
            let below = if k + 1 < n { self.upper[k] * x[k + 1] } else { DVec2::ZERO };
            x[k] = (x[k] - below) / pivots[k];
        }
        x
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn uneven(n: u32) -> impl Iterator<Item = f64> {
        (0..n).map(move |k| {
            let s = f64::from(k) / f64::from(n);
            s + 0.02 * (TAU * 3.0 * s).sin()
        })
    }

    /// At any distances, with every end condition.
    #[test]
    fn a_straight_line_is_reproduced() {
        let points: Vec<DVec2> = [0.0, 0.1, 0.15, 0.7, 1.0].map(|s| DVec2::new(1.0 + 2.0 * s, 3.0 - s)).to_vec();
        for count in 2..=5 {
            let spline = Spline::open(&points[..count]).unwrap();
            for k in 0..=20 {
                let jet = spline.jet(f64::from(k) / 20.0);
                let (a, d) = (points[0], points[count - 1] - points[0]);
                assert!(jet.position.distance(a + f64::from(k) / 20.0 * d) < 1e-14);
                assert!(jet.second.length() < 1e-12, "{count}: {}", jet.second);
            }
        }
    }

    /// The errors on unevenly spaced points of a circle: position of order 4, curvature of order 2.
    #[test]
    fn the_circle_is_approximated_with_the_stated_orders() {
        let errors = |n: u32| {
            let points: Vec<DVec2> = uneven(n).map(|s| DVec2::from_angle(TAU * s)).collect();
            let spline = Spline::closed(&points).unwrap();
            let jets: Vec<Jet> = (0..10 * n).map(|k| spline.jet(f64::from(k) / f64::from(10 * n))).collect();
            let worst = |error: fn(&Jet) -> f64| jets.iter().map(error).fold(0.0, f64::max);
            [worst(|jet| (jet.position.length() - 1.0).abs()), worst(|jet| (jet.curvature() - 1.0).abs())]
        };
        let [coarse, fine] = [errors(100), errors(200)];
        println!("{coarse:?}, {fine:?}");
        assert!((14.0..18.0).contains(&(coarse[0] / fine[0])), "position: {coarse:?}, {fine:?}");
        assert!((3.5..4.5).contains(&(coarse[1] / fine[1])), "curvature: {coarse:?}, {fine:?}");
        assert!(fine[0] < 4e-8 && fine[1] < 4e-4, "{fine:?}");
    }

    #[test]
    fn the_curve_passes_through_its_points_with_continuous_curvature() {
        let points: Vec<DVec2> =
            uneven(30).map(|s| (1.0 + 0.3 * (TAU * 2.0 * s).cos()) * DVec2::from_angle(TAU * s)).collect();
        for spline in [Spline::open(&points).unwrap(), Spline::closed(&points).unwrap()] {
            let cubics: Vec<[DVec2; 4]> = spline.cubics().collect();
            let length = spline.knots[spline.len() - 1];
            for (k, [a, b, _, _]) in cubics.iter().enumerate() {
                assert_eq!(*a, spline.points[k]);
                let jet = spline.jet(spline.knots[k] / length);
                assert!(jet.position.distance(*a) < 1e-15);
                let h = spline.knots[k + 1] - spline.knots[k];
                assert!((length * 3.0 / h * (*b - *a)).distance(jet.first) < 1e-11 * length);
            }
            for w in cubics.windows(2) {
                let second = |[p, q, r]: [DVec2; 3], h: f64| (p - 2.0 * q + r) / (h * h);
                let h = w.iter().map(|c| c[0].distance(c[3])).collect::<Vec<_>>();
                let [left, right] =
                    [second([w[0][1], w[0][2], w[0][3]], h[0]), second([w[1][0], w[1][1], w[1][2]], h[1])];
                assert!(left.distance(right) < 1e-10, "{left}, {right}");
            }
        }
        let closed = Spline::closed(&points).unwrap();
        let [start, end] = [closed.jet(0.0), closed.jet(1.0)];
        assert!(start.first.distance(end.first) < 1e-12 && start.second.distance(end.second) < 1e-9);
    }

    #[test]
    fn what_has_no_spline_is_refused() {
        let p = DVec2::new(0.3, 0.1);
        assert!(Spline::open(&[]).is_none() && Spline::open(&[p]).is_none() && Spline::open(&[p, p]).is_none());
        assert!(Spline::closed(&[p, DVec2::ZERO]).is_none());
        assert!(Spline::open(&[p, DVec2::NAN]).is_none());
    }
}

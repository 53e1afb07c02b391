//! The tridiagonal systems for a spline's slopes.

use glam::DVec2;

/// A tridiagonal system for the slopes: `lower[k] m_{k−1} + diagonal[k] m_k + upper[k] m_{k+1} = right[k]`.
pub(super) struct Rows {
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
    pub fn open(lengths: &[f64], chords: &[DVec2]) -> Self {
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
    pub fn closed_slopes(lengths: &[f64], chords: &[DVec2]) -> Vec<DVec2> {
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
    pub fn solved(&self) -> Vec<DVec2> {
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

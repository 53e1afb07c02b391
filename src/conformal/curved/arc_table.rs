//! Arc length along one piece of a curve, and its inverse, by a table.

use crate::geometry::{Piece, gauss_legendre};
use std::sync::OnceLock;

/// Cells of the table of a curved piece. A preset's piece bends by at most a full turn; a rule of 16 nodes on a 64th of
/// it is exact to rounding.
const CELLS: usize = 64;
/// Nodes of the rule on a cell.
const NODES: usize = 16;
/// Steps of Newton's method; 3 suffice on all presets.
const MOST_STEPS: u32 = 40;

/// The lengths of a piece up to the ends of equal cells of its parameter.
#[derive(Debug, Clone)]
pub struct ArcTable {
    piece: Piece,
    /// Length up to parameter k/CELLS; empty for a straight line, whose length is linear, and a spline, which knows it.
    ends: Vec<f64>,
    length: f64,
}

fn rule() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss_legendre(NODES))
}

impl ArcTable {
    /// The table of a piece of this length.
    pub fn new(piece: Piece, length: f64) -> Self {
        let mut table = Self { piece, ends: Vec::new(), length };
        // a spline has its own table
        if table.piece.is_straight() || matches!(table.piece, Piece::Spline { .. }) {
            return table;
        }
        let mut sum = 0.0;
        table.ends.push(0.0);
        for k in 0..CELLS {
            sum += table.integral(k as f64 / CELLS as f64, (k + 1) as f64 / CELLS as f64);
            table.ends.push(sum);
        }
        table.ends.iter_mut().for_each(|end| *end *= length / sum);
        table
    }

    /// ∫ |z′| over [from, to], inside of one cell.
    fn integral(&self, from: f64, to: f64) -> f64 {
        let half = 0.5 * (to - from);
        rule().iter().map(|(x, w)| half * w * self.piece.jet(from + half * (1.0 + x)).first.length()).sum()
    }

    /// The length up to parameter `t` in [0, 1].
    pub fn length_to(&self, t: f64) -> f64 {
        if t >= 1.0 {
            return self.length;
        }
        if self.ends.is_empty() {
            return self.piece.length_to(t);
        }
        let cell = ((t * CELLS as f64) as usize).min(CELLS - 1);
        self.ends[cell] + self.integral(cell as f64 / CELLS as f64, t)
    }

    /// The parameter up to which the length is `length`, in [0, 1].
    pub fn parameter_at(&self, length: f64) -> f64 {
        let share = (length / self.length).clamp(0.0, 1.0);
        if share <= 0.0 || share >= 1.0 {
            return share;
        }
        if self.ends.is_empty() {
            return self.piece.parameter_at(length, self.length);
        }
        let cell = self.ends.partition_point(|&end| end <= length).clamp(1, CELLS) - 1;
        let [from, to] = [cell, cell + 1].map(|k| k as f64 / CELLS as f64);
        let (mut low, mut high) = (from, to);
        let mut t = from + (to - from) * (length - self.ends[cell]) / (self.ends[cell + 1] - self.ends[cell]);
        for _ in 0..MOST_STEPS {
            let excess = self.ends[cell] + self.integral(from, t) - length;
            if excess > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let next = t - excess / self.piece.jet(t).first.length();
            let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            if (next - t).abs() <= 2.0 * f64::EPSILON {
                return next;
            }
            t = next;
        }
        t
    }
}

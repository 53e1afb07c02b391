//! Spacing in narrow channels: at most a quarter of the domain's width.
//!
//! The width at a point of the outline is the distance to the nearest other part
//! of it that faces the point across the inside. Parts that are also near along the
//! outline do not count: they belong to the same bend.

use super::spacing::Table;
use crate::geometry::DVec2;

/// Spacing per width. Across a channel of width w the harmonic measure decays like
/// exp(−πℓ/w); linear elements of size h get that rate wrong by about (πh/w)²/24:
/// 10 % at w/2, which changes the measure beyond a neck of length 1.5 w by half, and
/// 2.6 % at w/4 (an eighth). w/8 would double the samples of every corridor.
const PER_WIDTH: f64 = 0.25;

/// The other side is at least this many times farther along the outline than
/// across. A semicircular end has π/2, which must not count; two sides of a
/// right angle √2; a wedge of 40° has 2.7, and is narrow.
const DETOUR: f64 = 2.5;

/// Sides face each other when the line between them is within 72° of both normals.
const FACING: f64 = 0.3;

/// The width is measured at every fourth station, a quarter of the base spacing
/// apart; the gradation limit determines the others.
const EVERY: usize = 4;

/// Lowers `spacing`, given every `station` steps of the table, to a quarter of the width.
pub(super) fn limit_by_width(table: &Table, station: usize, base: f64, floor: f64, spacing: &mut [f64]) {
    let grid = Grid::new(table, 2 * station, base / PER_WIDTH);
    for (k, h) in spacing.iter_mut().enumerate().step_by(EVERY) {
        let width = grid.width(k * station, *h / PER_WIDTH);
        *h = h.min((PER_WIDTH * width).max(floor));
    }
}

/// The outline's pieces of `stride` steps, in square cells.
struct Grid<'a> {
    table: &'a Table,
    stride: usize,
    low: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    /// The pieces in cell `c` are `pieces[start[c] .. start[c+1]]`.
    start: Vec<u32>,
    pieces: Vec<Piece>,
}

/// A piece of the outline as a segment; it starts at step `first`.
#[derive(Clone, Copy, Default)]
struct Piece {
    a: DVec2,
    b: DVec2,
    first: usize,
}

/// A step of the outline with the inner normal at it.
struct From {
    i: usize,
    p: DVec2,
    normal: DVec2,
}

impl<'a> Grid<'a> {
    fn new(table: &'a Table, stride: usize, cell: f64) -> Self {
        let count = table.count.div_ceil(stride);
        let middle = |k: usize| table.at((k * stride + stride / 2) as isize);
        let low = (0..count).map(middle).fold(DVec2::INFINITY, DVec2::min);
        let high = (0..count).map(middle).fold(DVec2::NEG_INFINITY, DVec2::max);
        let size = ((high - low) / cell).floor();
        let (columns, rows) = (size.x as usize + 1, size.y as usize + 1);
        let mut grid =
            Self { table, stride, low, cell, columns, rows, start: vec![0; columns * rows + 2], pieces: Vec::new() };
        let cells: Vec<usize> = (0..count).map(|k| grid.cell_of(middle(k))).collect();
        for &c in &cells {
            grid.start[c + 2] += 1;
        }
        (2..grid.start.len()).for_each(|c| grid.start[c] += grid.start[c - 1]);
        grid.pieces = vec![Piece::default(); count];
        for (k, c) in cells.into_iter().enumerate() {
            let first = k * stride;
            let (a, b) = (table.at(first as isize), table.at((first + stride) as isize));
            grid.pieces[grid.start[c + 1] as usize] = Piece { a, b, first };
            grid.start[c + 1] += 1;
        }
        grid
    }

    fn position(&self, p: DVec2) -> (usize, usize) {
        let cell = ((p - self.low) / self.cell).floor();
        ((cell.x.max(0.0) as usize).min(self.columns - 1), (cell.y.max(0.0) as usize).min(self.rows - 1))
    }

    fn cell_of(&self, p: DVec2) -> usize {
        let (column, row) = self.position(p);
        row * self.columns + column
    }

    /// The distance across the inside at step `i`, or `limit` if it is larger.
    fn width(&self, i: usize, limit: f64) -> f64 {
        let at = |k: isize| self.table.at(k);
        let (p, k) = (at(i as isize), i as isize);
        let from = From { i, p, normal: (at(k + 1) - at(k - 1)).perp().normalize_or_zero() };
        // pieces are sorted into cells by their midpoints
        let reach = DVec2::splat(limit + 0.5 * self.stride as f64 * self.table.step);
        let ((c0, r0), (c1, r1)) = (self.position(p - reach), self.position(p + reach));
        let mut width = limit;
        for row in r0..=r1 {
            let (first, last) = (row * self.columns + c0, row * self.columns + c1);
            for piece in &self.pieces[self.start[first] as usize..self.start[last + 1] as usize] {
                width = self.across(&from, piece, width).unwrap_or(width);
            }
        }
        width
    }

    /// The distance from a step to a piece, if that is less than `limit` and across the inside.
    fn across(&self, from: &From, piece: &Piece, limit: f64) -> Option<f64> {
        let (along, edge) = (from.p - piece.a, piece.b - piece.a);
        // skips most pieces: those with both ends behind the normal's plane
        if -along.dot(from.normal) <= 0.0 && (piece.b - from.p).dot(from.normal) <= 0.0 {
            return None;
        }
        let t = (along.dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let offset = t * edge - along;
        let distance2 = offset.length_squared();
        if distance2 >= limit * limit {
            return None;
        }
        let (distance, n) = (distance2.sqrt(), self.table.count);
        let steps = (from.i + n - piece.first) % n;
        let around = steps.min(n - steps) as f64 * self.table.step;
        let other = edge.perp().normalize_or_zero();
        let opposite = around >= DETOUR * distance + self.stride as f64 * self.table.step
            && offset.dot(from.normal) > FACING * distance
            && -offset.dot(other) > FACING * distance;
        opposite.then_some(distance)
    }
}

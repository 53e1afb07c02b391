//! Outlines in few bits: 16 per coordinate, relative to the bounding box, as differences.
//!
//! A point is `low + (high − low) q / 65535` with integers `q`, so that an outline 2000 pixels high
//! moves by at most a sixtieth of a pixel. Stored are the steps from point to point, or, where that is
//! shorter (smooth outlines), the changes of the steps; both modulo 2¹⁶, so that any list of steps
//! decodes to a list of points.
//!
//! Guarantees: the result of [`Quantized::of`] is a simple polygon with the same bounding box, and
//! quantizing it again changes nothing. Points that round to their predecessor are dropped.

use super::envelope::{self, MAX_BYTES};
use super::{MAX_LENGTH, NotCarried};
use crate::geometry::{Bounds, DVec2, PolygonError, SimplePolygon};

/// The largest `q`.
const LAST: f64 = u16::MAX as f64;

/// The smallest size of a point before deflating: a byte for each of its two steps.
const LEAST_BYTES: usize = 2;
/// A bound on how many characters the steps can get shorter when they are deflated together with the rest of a
/// session: more than the rest alone takes. If they got shorter by more, an outline that just fits would be left out.
const SLACK: usize = 512;

/// A quantized outline, as it is written.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub(super) struct Quantized {
    low: [f64; 2],
    high: [f64; 2],
    /// Whether `steps` holds the changes of the steps.
    smooth: bool,
    steps: Vec<(i16, i16)>,
}

type Cell = [u16; 2];

impl Quantized {
    /// Quantizes a polygon. Errors: it is too long for any link, or after rounding it is no longer a simple polygon.
    /// The length is checked first, because that is cheaper.
    pub fn of(points: &[DVec2]) -> Result<Self, NotCarried> {
        if let Some(index) = points.iter().position(|p| !p.is_finite()) {
            return Err(NotCarried::NotSimple(PolygonError::NotFinite { index, at: points[index] }));
        }
        let bounds = Bounds::of(points.iter().copied());
        let cells = cells(points, bounds);
        let too_long = NotCarried::TooLong { points: cells.len() };
        if cells.len() > MAX_BYTES / LEAST_BYTES {
            return Err(too_long);
        }
        let [steps, changes] = [false, true].map(|smooth| differences(&cells, smooth));
        let smooth = length(&changes) < length(&steps);
        let steps = if smooth { changes } else { steps };
        if !may_fit(&steps) {
            return Err(too_long);
        }
        let on_grid: Vec<DVec2> = cells.iter().map(|&cell| place(cell, bounds)).collect();
        SimplePolygon::try_from(on_grid.clone()).map_err(NotCarried::NotSimple)?;
        let again = Bounds::of(on_grid.iter().copied());
        if again != bounds || self::cells(&on_grid, again) != cells {
            return Err(NotCarried::Inexact);
        }
        Ok(Self { low: bounds.min().to_array(), high: bounds.max().to_array(), smooth, steps })
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// The points, not checked in any way; none is NaN if the corners of the box are finite.
    pub fn points(&self) -> Vec<DVec2> {
        let bounds = Bounds::new(self.low.into(), self.high.into());
        let (mut step, mut at): (Cell, Cell) = ([0; 2], [0; 2]);
        let cells = self.steps.iter().map(|&(dx, dy)| {
            let written = [dx as u16, dy as u16];
            step = if self.smooth { sum(step, written) } else { written };
            at = sum(at, step);
            place(at, bounds)
        });
        cells.collect()
    }
}

fn sum(a: Cell, b: Cell) -> Cell {
    [0, 1].map(|k| a[k].wrapping_add(b[k]))
}

/// The nearest grid points, without cyclic repetitions.
fn cells(points: &[DVec2], bounds: Bounds) -> Vec<Cell> {
    let scaled = |p: &DVec2| {
        let q = (LAST * ((*p - bounds.min()) / bounds.size())).round();
        [q.x as u16, q.y as u16]
    };
    let mut cells: Vec<Cell> = points.iter().map(scaled).collect();
    cells.dedup();
    while cells.len() > 1 && cells.first() == cells.last() {
        cells.pop();
    }
    cells
}

/// The position of a grid point; exact at the corners of the box.
fn place(cell: Cell, bounds: Bounds) -> DVec2 {
    let q = DVec2::new(f64::from(cell[0]), f64::from(cell[1]));
    let inner = bounds.min() + bounds.size() * (q / LAST);
    DVec2::select(q.cmpeq(DVec2::splat(LAST)), bounds.max(), inner)
}

fn differences(cells: &[Cell], smooth: bool) -> Vec<(i16, i16)> {
    let (mut step, mut at): (Cell, Cell) = ([0; 2], [0; 2]);
    let written = cells.iter().map(|&cell| {
        let next = [0, 1].map(|k| cell[k].wrapping_sub(at[k]));
        let change = [0, 1].map(|k| next[k].wrapping_sub(step[k]));
        (at, step) = (cell, next);
        let [dx, dy] = if smooth { change } else { next };
        (dx as i16, dy as i16)
    });
    written.collect()
}

/// The number of bytes of the steps as postcard's variable-length integers, 7 bits each.
fn length(steps: &[(i16, i16)]) -> usize {
    let of = |step: i16| match step {
        -64..64 => 1,
        -8192..8192 => 2,
        _ => 3,
    };
    steps.iter().map(|&(dx, dy)| of(dx) + of(dy)).sum()
}

/// False if the steps alone are already too long for a link.
fn may_fit(steps: &[(i16, i16)]) -> bool {
    let packed = postcard::to_allocvec(steps).ok().and_then(|bytes| envelope::pack(&bytes));
    packed.is_some_and(|text| text.len() <= MAX_LENGTH + SLACK)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;

    #[test]
    fn every_preset_stays_simple_and_within_half_a_step() {
        for preset in Preset::ALL {
            let points = preset.outline().polygon().vertices().to_vec();
            let quantized = Quantized::of(&points).unwrap();
            let found = quantized.points();
            let half = 0.5 * Bounds::of(points.iter().copied()).size() / LAST;
            for p in &points {
                let near = |q: &DVec2| (*p - *q).abs().cmple(half * (1.0 + 1e-9)).all();
                assert!(found.iter().any(near), "{preset}: nothing is near {p}");
            }
            assert_eq!(Quantized::of(&found), Ok(quantized.clone()), "{preset}: the second time changes nothing");
            println!("{preset}: {} of {} points, smooth: {}", found.len(), points.len(), quantized.smooth);
        }
    }

    #[test]
    fn both_ways_of_writing_mean_the_same_points() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from);
        let cells = cells(&square, Bounds::of(square));
        for smooth in [false, true] {
            let steps = differences(&cells, smooth);
            let written = Quantized { low: [0.0; 2], high: [1.0, 2.0], smooth, steps };
            assert_eq!(written.points(), square, "smooth: {smooth}");
        }
    }

    /// A slit as wide as a millionth of the box closes on the grid.
    #[test]
    fn an_outline_that_the_grid_closes_is_refused() {
        let slit = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.000_001, 3.0), (2.0, 1.0), (2.0, 3.0), (0.0, 3.0)];
        let points = slit.map(DVec2::from).to_vec();
        assert!(SimplePolygon::try_from(points.clone()).is_ok());
        let found = Quantized::of(&points);
        assert!(
            matches!(
                found,
                Err(NotCarried::NotSimple(PolygonError::RepeatedPoint { .. } | PolygonError::FoldsBack { .. }))
            ),
            "{found:?}"
        );
    }

    #[test]
    fn points_nearer_than_the_grid_become_one() {
        let dense = [(0.0, 0.0), (1e-9, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1e-9)].map(DVec2::from);
        let found = Quantized::of(&dense).unwrap().points();
        assert_eq!(found, [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)].map(DVec2::from));
    }

    /// At 10¹² the spacing of the floating-point numbers is 1.2e-4, that of the grid 1.5e-5.
    #[test]
    fn where_the_numbers_are_coarser_than_the_grid_nothing_moves() {
        let house = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.625), (0.5, 1.0), (0.0, 0.625)];
        let points = house.map(|p| DVec2::from(p) + 1e12);
        assert_eq!(Quantized::of(&points).unwrap().points(), points);
    }

    /// A staircase of `n` steps deflates to almost nothing: only its number of points is too large.
    #[test]
    fn too_many_points_are_refused_by_their_number() {
        let staircase = |n: u32| -> Vec<DVec2> {
            let steps = (0..n).map(|k| DVec2::new(f64::from(k.div_ceil(2)), f64::from(k / 2)));
            steps.chain([DVec2::new(0.0, f64::from(n / 2))]).collect()
        };
        let limit = (MAX_BYTES / LEAST_BYTES) as u32;
        // the number of points, the first and the last step take a few more bytes
        assert!(Quantized::of(&staircase(limit - 8)).is_ok());
        let found = Quantized::of(&staircase(limit));
        assert_eq!(found, Err(NotCarried::TooLong { points: limit as usize + 1 }));
    }

    #[test]
    fn points_that_form_no_polygon_are_refused() {
        assert!(Quantized::of(&[]).is_err());
        assert!(Quantized::of(&[DVec2::NAN; 3]).is_err());
        assert!(Quantized::of(&[DVec2::ZERO, DVec2::X, 2.0 * DVec2::X]).is_err());
    }
}

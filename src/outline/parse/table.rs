//! Tables of points: two columns of numbers, as programs export them.
//!
//! Blank lines, text after `#`, and lines that begin with `%` are skipped; `>` begins a further outline, of which the
//! largest is taken. Lines of text before the first row of numbers are titles and headers, those after the last one
//! remarks. Of more than two columns an index (0…n−1 or 1…n) is skipped, then x and y are those that the header names, or
//! the first two; others are dropped, with a note unless they are constant. A line that is none of this is an error.

mod columns;
mod rows;

use super::ring::Ring;
use super::{OutlineError, OutlineNote};
use crate::geometry::DVec2;
use columns::Columns;
use rows::Row;

pub(super) use rows::number;

/// The outline of a table: of its parts the one of largest area.
pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let Table { parts, dropped } = table(text)?;
    let mut ring = Ring::largest_of(parts.into_iter().map(airfoil).collect()).ok_or(OutlineError::Empty)?;
    if dropped > 0 {
        ring.notes.push(OutlineNote::ColumnsDropped { columns: dropped });
    }
    Ok(ring.implicitly_closed())
}

/// All points, in the order of their lines; at least one.
pub(super) fn points(text: &str) -> Result<Vec<DVec2>, OutlineError> {
    table(text).map(|table| table.parts.concat())
}

struct Table {
    /// The points between lines that begin with `>`; at least one.
    parts: Vec<Vec<DVec2>>,
    /// The number of columns that were left out although they vary.
    dropped: usize,
}

fn table(text: &str) -> Result<Table, OutlineError> {
    let rows = rows::rows(text);
    let first = rows.iter().position(Row::is_numeric).unwrap_or(0);
    let (titles, rest) = rows.split_at(first);
    titles.iter().try_for_each(Row::check_title)?;
    let columns = rest.first().map_or(0, |row| row.fields.len());
    let end = rest.iter().rposition(|row| !row.is_remark_after(columns)).map_or(rest.len(), |last| last + 1);
    let rows = without_count(&rest[..end]);
    let numbers: Vec<Vec<f64>> = rows.iter().map(Row::numbers).collect::<Result<_, _>>()?;
    let width = numbers.first().ok_or(OutlineError::Empty)?.len().max(2);
    if let Some(k) = (0..rows.len()).find(|&k| numbers[k].len() != width || (width > 2 && rows[k].is_mixed)) {
        return Err(OutlineError::NumbersOnLine { line: rows[k].line, count: numbers[k].len() });
    }
    let names_two = titles.iter().all(|row| row.fields.len() <= 2);
    let mut digits = None;
    if width == 4 && rows.iter().all(|row| row.halves(&mut digits)) && names_two {
        // decimal commas between commas
        return Err(OutlineError::NumbersOnLine { line: rows[0].line, count: width });
    }
    let columns = Columns::of(&numbers, titles.last());
    let mut parts: Vec<Vec<DVec2>> = Vec::new();
    for (row, numbers) in rows.iter().zip(&numbers) {
        if parts.is_empty() || row.begins_part {
            parts.push(Vec::new());
        }
        if let Some(part) = parts.last_mut() {
            part.push(DVec2::new(numbers[columns.x], numbers[columns.y]));
        }
    }
    Ok(Table { parts, dropped: columns.dropped })
}

/// The rows without a first one that is nothing but the number of the others.
fn without_count<'a, 'b>(rows: &'a [Row<'b>]) -> &'a [Row<'b>] {
    match rows {
        [count, points @ ..] if count.single() == Some(points.len() as f64) => points,
        all => all,
    }
}

/// The points of an airfoil in Lednicer's order: its first row are the numbers of points on both sides, each of which runs
/// from the leading edge, x = 0, to the trailing one, x = 1. Other lists as they are.
fn airfoil(points: Vec<DVec2>) -> Vec<DVec2> {
    let [counts, sides @ ..] = points.as_slice() else { return points };
    let is_counted =
        counts.min_element() >= 2.0 && counts.fract() == DVec2::ZERO && counts.element_sum() == sides.len() as f64;
    if !is_counted {
        return points;
    }
    let (upper, lower) = sides.split_at(counts.x as usize);
    let is_side = |side: &[DVec2]| match side {
        [first, .., last] => first.x.abs() <= EDGE && (last.x - 1.0).abs() <= EDGE,
        _ => false,
    };
    if !is_side(upper) || !is_side(lower) {
        return points;
    }
    let lower = if upper.first() == lower.first() { &lower[1..] } else { lower };
    upper.iter().rev().chain(lower).copied().collect()
}

/// How far the edges of an airfoil may be from x = 0 and x = 1.
const EDGE: f64 = 0.05;

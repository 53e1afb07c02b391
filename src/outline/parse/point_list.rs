//! A list of points on one line: "0,0 2,0 1,3", as in the `points` of an SVG polygon.

use super::OutlineError;
use super::ring::Ring;
use super::table::number;
use crate::geometry::DVec2;

/// Whether `text` is one line that consists of numbers only, more than two of them.
pub(super) fn is_one(text: &str) -> bool {
    text.trim().lines().count() == 1
        && fields(text).nth(2).is_some()
        && fields(text).all(|(_, field)| field.parse::<f64>().is_ok())
}

/// Pairs of numbers, separated by commas, semicolons or blanks.
pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let numbers: Vec<f64> = fields(text).map(|field| number(field, 1)).collect::<Result<_, _>>()?;
    if !numbers.len().is_multiple_of(2) {
        return Err(OutlineError::OddNumbers { count: numbers.len() });
    }
    Ok(Ring::of(numbers.chunks_exact(2).map(DVec2::from_slice).collect()))
}

/// The fields with their columns, from 1.
fn fields(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let columns = text.trim().split([',', ';', ' ', '\t']).scan(1, |next, field| {
        let at = *next;
        *next += field.chars().count() + 1; // separators are one character each
        Some((at, field))
    });
    columns.filter(|(_, field)| !field.is_empty())
}

//! A list of points on one line: "0,0 2,0 1,3", as in the `points` of an SVG polygon.

use super::OutlineError;
use super::ring::Ring;
use super::table::number;
use crate::geometry::DVec2;

/// Whether `text` is one line with more numbers than one point has, and nothing but numbers.
pub(super) fn is_one(text: &str) -> bool {
    text.trim().lines().count() == 1
        && fields(text).count() > 2
        && fields(text).all(|(_, field)| field.parse::<f64>().is_ok())
}

/// Pairs of numbers, separated by commas, semicolons or blanks.
pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let numbers: Vec<f64> = fields(text).map(|field| number(field, 1)).collect::<Result<_, _>>()?;
    if !numbers.len().is_multiple_of(2) {
        return Err(OutlineError::OddNumbers { count: numbers.len() });
    }
    Ok(Ring::implicitly_closed(numbers.chunks_exact(2).map(DVec2::from_slice).collect()))
}

/// The fields with their columns, from 1.
fn fields(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let line = text.trim();
    let column = move |field: &str| 1 + line[..field.as_ptr() as usize - line.as_ptr() as usize].chars().count();
    line.split([',', ';', ' ', '\t']).filter(|field| !field.is_empty()).map(move |field| (column(field), field))
}

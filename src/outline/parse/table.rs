//! Tables: two numbers on a line, separated by spaces, a tab, a comma or a semicolon.
//!
//! Blank lines and `#` comments are skipped. The first other line may be a
//! header: two fields, each beginning with a letter and none of them a number.

use super::OutlineError;
use super::ring::Ring;
use crate::geometry::DVec2;

/// A field and its column, from 1.
type Field<'a> = (usize, &'a str);

pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    points(text).map(Ring::implicitly_closed)
}

/// All points, in the order of their lines; at least one.
pub(super) fn points(text: &str) -> Result<Vec<DVec2>, OutlineError> {
    let mut points = Vec::new();
    let mut first = true;
    for (content, line) in text.lines().zip(1..) {
        let content = content.split('#').next().unwrap_or_default();
        if content.trim().is_empty() {
            continue;
        }
        let fields = fields(content, line)?;
        if !(std::mem::take(&mut first) && is_header(&fields)) {
            points.push(point(&fields, line)?);
        }
    }
    if points.is_empty() { Err(OutlineError::Empty) } else { Ok(points) }
}

/// The fields of a line; an error where a comma or semicolon has no field before or after it.
fn fields(content: &str, line: usize) -> Result<Vec<Field<'_>>, OutlineError> {
    let mut fields: Vec<Field> = Vec::new();
    // Whether a separator was read and its next field is still missing.
    let mut open = true;
    let mut start = None;
    let columns = content.char_indices().chain([(content.len(), ' ')]);
    for ((offset, c), column) in columns.zip(1..) {
        let separates = c.is_whitespace() || c == ',' || c == ';';
        match start {
            None if !separates => start = Some((offset, column)),
            Some((from, at)) if separates => {
                fields.push((at, &content[from..offset]));
                (start, open) = (None, false);
            }
            _ => {}
        }
        if c == ',' || c == ';' {
            if open {
                return Err(OutlineError::MissingNumber { line, column });
            }
            open = true;
        }
    }
    if open { Err(OutlineError::MissingNumber { line, column: content.chars().count() + 1 }) } else { Ok(fields) }
}

fn is_header(fields: &[Field]) -> bool {
    let is_title = |field: &str| {
        let letters = field.trim_matches(['"', '\'']);
        letters.starts_with(|c: char| c.is_alphabetic()) && letters.parse::<f64>().is_err()
    };
    fields.len() == 2 && fields.iter().all(|(_, f)| is_title(f))
}

fn point(fields: &[Field], line: usize) -> Result<DVec2, OutlineError> {
    let numbers: Vec<f64> = fields.iter().map(|&field| number(field, line)).collect::<Result<_, _>>()?;
    match numbers.as_slice() {
        &[x, y] => Ok(DVec2::new(x, y)),
        other => Err(OutlineError::NumbersOnLine { line, count: other.len() }),
    }
}

pub(super) fn number((column, field): Field, line: usize) -> Result<f64, OutlineError> {
    match field.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(OutlineError::NumberOutOfRange { line, column }),
        Err(_) => Err(OutlineError::NotANumber { line, column, found: field.chars().take(20).collect() }),
    }
}

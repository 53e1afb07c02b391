//! Well-known text of simple features (OGC 06-103r4): `POLYGON ((x y, …), …)` and `MULTIPOLYGON (((x y, …)), …)`.

use super::ring::Ring;
use super::table::number;
use super::{OutlineError, OutlineNote};
use crate::geometry::DVec2;

/// Whether `text` begins as a polygon or several, maybe after `SRID=…;`.
pub(super) fn is_one(text: &str) -> bool {
    let text = text.trim_start();
    let text = if text.starts_with("SRID=") { text.split_once(';').map_or("", |(_, rest)| rest) } else { text };
    let head = text.split('(').next().unwrap_or_default().trim().to_ascii_uppercase();
    text.contains('(') && ["POLYGON", "MULTIPOLYGON"].contains(&head.split(' ').next().unwrap_or_default())
}

/// The outer ring of largest area; heights are left out.
pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let is_multiple = text.to_ascii_uppercase().contains("MULTIPOLYGON");
    // rings lie this deep in parentheses
    let ring_depth = if is_multiple { 3 } else { 2 };
    let (mut depth, mut start, mut holes) = (0, 0, 0);
    let mut rings: Vec<(Vec<DVec2>, usize)> = Vec::new();
    for (offset, c) in text.char_indices() {
        match c {
            '(' => {
                depth += 1;
                start = offset + 1;
                if depth == ring_depth - 1 {
                    holes = 0;
                }
            }
            ')' => {
                if depth == ring_depth && holes == 0 {
                    rings.push((points(text, start, offset)?, 0));
                    holes = 1;
                } else if depth == ring_depth
                    && let Some((_, holes)) = rings.last_mut()
                {
                    *holes += 1;
                }
                depth -= 1;
            }
            _ => {}
        }
    }
    let (chains, holes): (Vec<_>, Vec<_>) = rings.into_iter().unzip();
    let index = super::ring::largest(&chains).ok_or(OutlineError::NoPolygon { kind: None })?;
    let mut ring = Ring::largest_of(chains).ok_or(OutlineError::Empty)?;
    if holes[index] > 0 {
        ring.notes.push(OutlineNote::HolesIgnored { holes: holes[index] });
    }
    // the last point of a ring repeats its first, which is its form and no remark
    if ring.points.len() > 1 && ring.points.first() == ring.points.last() {
        ring.points.pop();
    }
    Ok(ring)
}

/// The points between two offsets of the text.
fn points(text: &str, start: usize, end: usize) -> Result<Vec<DVec2>, OutlineError> {
    let mut at = start;
    let mut points = Vec::new();
    for point in text[start..end].split(',') {
        let place = at + point.len() - point.trim_start().len();
        at += point.len() + 1;
        let numbers: Vec<Option<f64>> =
            point.split_whitespace().map(|field| field.parse().ok().filter(|x: &f64| x.is_finite())).collect();
        match *numbers.as_slice() {
            [Some(x), Some(y)] | [Some(x), Some(y), _] | [Some(x), Some(y), _, _] => points.push(DVec2::new(x, y)),
            _ => return Err(fault(text, place, point)),
        }
    }
    Ok(points)
}

/// What is wrong with the point that begins at an offset of the text.
fn fault(text: &str, place: usize, point: &str) -> OutlineError {
    let line = text[..place].matches('\n').count() + 1;
    let column = text[..place].rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    let fields = point.split_whitespace();
    let count = fields.clone().count();
    let fault = fields.map(|field| number((column, field), line)).find_map(Result::err);
    fault.unwrap_or(OutlineError::NumbersOnLine { line, count })
}

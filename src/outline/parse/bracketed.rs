//! Points in brackets, as programming languages print lists: "(0, 0), (2, 0)", "[[0. 0.]\n [2. 0.]]", "{{0, 0}, {2, 0}}".

use crate::geometry::DVec2;

const OPENING: [char; 3] = ['(', '[', '{'];
const CLOSING: [char; 3] = [')', ']', '}'];

/// The points, if the text is nothing but balanced brackets, of which the innermost hold two numbers each, and separators.
pub(super) fn points(text: &str) -> Option<Vec<DVec2>> {
    let mut points = Vec::new();
    let mut open = Vec::new();
    // where the innermost bracket begins that is open
    let mut start = None;
    for (at, c) in text.char_indices() {
        if let Some(kind) = OPENING.iter().position(|&opening| opening == c) {
            open.push(kind);
            start = Some(at + 1);
        } else if let Some(kind) = CLOSING.iter().position(|&closing| closing == c) {
            if open.pop() != Some(kind) {
                return None;
            }
            if let Some(from) = start.take() {
                points.push(point(&text[from..at])?);
            }
        } else if start.is_none() && !is_separator(c) {
            return None;
        }
    }
    (open.is_empty() && !points.is_empty()).then_some(points)
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || c == ',' || c == ';'
}

fn point(text: &str) -> Option<DVec2> {
    let mut numbers = text.split(is_separator).filter(|field| !field.is_empty()).map(str::parse::<f64>);
    let (x, y) = (numbers.next()?.ok()?, numbers.next()?.ok()?);
    let point = DVec2::new(x, y);
    (numbers.next().is_none() && point.is_finite()).then_some(point)
}

//! Points in brackets, as programming languages print lists: "(0, 0), (2, 0)", "[[0. 0.]\n [2. 0.]]", "{{0, 0}, {2, 0}}".

use crate::geometry::DVec2;

const OPENING: [char; 3] = ['(', '[', '{'];
const CLOSING: [char; 3] = [')', ']', '}'];

/// The points, if the text is nothing but one list in balanced brackets, of which the innermost hold two numbers each, and
/// separators.
pub(super) fn points(text: &str) -> Option<Vec<DVec2>> {
    let mut points = Vec::new();
    let mut open = Vec::new();
    // how many brackets are around all points, and whether the one next to them is closed
    let (mut depth, mut is_over) = (None, false);
    // where the innermost bracket begins that is open
    let mut start = None;
    for (at, c) in text.char_indices() {
        if let Some(kind) = OPENING.iter().position(|&opening| opening == c) {
            if start.is_some_and(|from: usize| !text[from..at].trim().is_empty()) {
                return None;
            }
            open.push(kind);
            start = Some(at + 1);
        } else if let Some(kind) = CLOSING.iter().position(|&closing| closing == c) {
            if open.pop() != Some(kind) {
                return None;
            }
            match start.take() {
                Some(from) if !is_over && *depth.get_or_insert(open.len()) == open.len() => {
                    points.push(point(&text[from..at])?);
                }
                Some(_) => return None,
                None => is_over = true,
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

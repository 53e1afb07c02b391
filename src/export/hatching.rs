//! Hatching of the parts of a domain that the images of a map do not cover.
//!
//! Lines at 45° across each part, from side to side; parts that are small against the distance of the lines get denser
//! ones, down to a tenth, and none below.

use crate::geometry::{Bounds, DVec2, sort_by_number};
use std::f64::consts::FRAC_1_SQRT_2;

/// Lines across the larger side of the whole drawing.
const LINES: f64 = 50.0;
/// Lines across a small part.
const LEAST_LINES: f64 = 4.0;
/// The smallest distance between lines, in that of [`LINES`].
const DENSEST: f64 = 0.1;

/// A point of a polygon's boundary: the number of the edge, and the position on it.
type End = (usize, DVec2);

/// The distance between lines in a drawing of this outline.
pub fn spacing(outline: &[DVec2]) -> f64 {
    let [low, high] = Bounds::of(outline.iter().copied()).corners();
    (high - low).max_element() / LINES
}

/// The segments of hatching inside of `polygon`, whose lines are at most `spacing` apart.
pub fn hatching(polygon: &[DVec2], spacing: f64) -> Vec<[DVec2; 2]> {
    segments(polygon, spacing).into_iter().map(|ends| ends.map(|(_, position)| position)).collect()
}

/// The segments, from line to line.
fn segments(polygon: &[DVec2], spacing: f64) -> Vec<[End; 2]> {
    let (along, across) = (DVec2::splat(FRAC_1_SQRT_2), DVec2::new(-FRAC_1_SQRT_2, FRAC_1_SQRT_2));
    let heights: Vec<f64> = polygon.iter().map(|p| p.dot(across)).collect();
    let (low, high) = heights.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)));
    let step = spacing.min((high - low) / LEAST_LINES).max(DENSEST * spacing);
    if !(step > 0.0 && step.is_finite()) {
        return Vec::new();
    }
    let mut segments = Vec::new();
    for line in (low / step).floor() as i64..=(high / step).floor() as i64 {
        // between multiples of the distance, so that no vertex of a lattice lies on a line
        let height = (line as f64 + 0.5) * step;
        let mut ends: Vec<End> = Vec::new();
        for (k, &a) in heights.iter().enumerate() {
            let next = (k + 1) % polygon.len();
            let b = heights[next];
            if (a > height) != (b > height) {
                ends.push((k, polygon[k].lerp(polygon[next], (height - a) / (b - a))));
            }
        }
        sort_by_number(&mut ends, |(_, p)| p.dot(along));
        segments.extend(ends.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
    }
    segments
}

/// A closed line that draws the outline and the hatching of `parts`: from a vertex of each part it goes around the
/// part's boundary, from one segment's end to the next one's, and back.
pub fn hatched(outline: &[DVec2], parts: &[Vec<DVec2>]) -> Vec<DVec2> {
    let spacing = spacing(outline);
    let mut ways: Vec<(usize, Vec<DVec2>)> = (parts.iter().filter(|part| part.len() > 2))
        .filter_map(|part| {
            let distance = |k: &usize| outline[*k].distance_squared(part[0]);
            let at = (0..outline.len()).min_by(|i, j| distance(i).total_cmp(&distance(j)))?;
            Some((at, way(part, spacing)))
        })
        .collect();
    sort_by_number(&mut ways, |(at, _)| *at as f64);
    let mut line = Vec::new();
    let mut ways = ways.into_iter().peekable();
    for (k, &p) in outline.iter().enumerate() {
        line.push(p);
        while let Some((_, way)) = ways.next_if(|(at, _)| *at == k) {
            line.extend(way);
            line.push(p);
        }
    }
    line
}

/// From the first vertex of a part across all segments of its hatching and back, along its boundary between them.
fn way(part: &[DVec2], spacing: f64) -> Vec<DVec2> {
    let count = part.len();
    // the edge that closes the part, and back
    let mut way = vec![part[0], part[count - 1], part[0]];
    let mut edge = 0;
    let go = |way: &mut Vec<DVec2>, from: usize, to: usize| {
        let ahead = (to + count - from) % count;
        if 2 * ahead <= count {
            way.extend((1..=ahead).map(|k| part[(from + k) % count]));
        } else {
            way.extend((0..count - ahead).map(|k| part[(from + count - k) % count]));
        }
    };
    for [(first, a), (last, b)] in segments(part, spacing) {
        go(&mut way, edge, first);
        way.extend([a, b]);
        edge = last;
    }
    go(&mut way, edge, 0);
    way.push(part[0]);
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    fn comb() -> Vec<DVec2> {
        [(0., 0.), (9., 0.), (9., 8.), (6., 8.), (6., 2.), (3., 2.), (3., 8.), (0., 8.)].map(DVec2::from).into()
    }

    #[test]
    fn segments_have_the_length_of_the_area_over_their_distance() {
        let polygon = comb();
        let segments = hatching(&polygon, 0.05);
        let length: f64 = segments.iter().map(|[a, b]| a.distance(*b)).sum();
        assert!((length * 0.05 - 54.0).abs() < 0.3, "{length}");
    }

    #[test]
    fn small_parts_have_denser_lines_and_empty_ones_none() {
        assert!(hatching(&[DVec2::ZERO, DVec2::X, DVec2::Y], 1.0).len() >= 3);
        assert!(hatching(&[], 1.0).is_empty() && hatching(&[DVec2::ZERO; 3], 1.0).is_empty());
    }

    /// Each step of the line lies on the outline, on the part's boundary, or on a segment of the hatching.
    #[test]
    fn the_line_draws_nothing_else() {
        let outline = comb();
        let part = vec![outline[1], outline[2], outline[3], outline[4]];
        let line = hatched(&outline, std::slice::from_ref(&part));
        assert_eq!(line.first(), Some(&outline[0]));
        let on = |polygon: &[DVec2], p: DVec2| {
            let mut edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
            edges.any(|(&a, &b)| p.distance(a) + p.distance(b) < a.distance(b) + 1e-9)
        };
        let segments = hatching(&part, spacing(&outline));
        assert!(segments.len() > 10, "{}", segments.len());
        for (&p, &q) in line.iter().zip(line.iter().cycle().skip(1)) {
            let middle = p.midpoint(q);
            let is_segment = segments.iter().any(|&[a, b]| on(&[a, b], middle));
            assert!(on(&outline, middle) || on(&part, middle) || is_segment, "{p} {q}");
        }
        let is_drawn = |[a, b]: [DVec2; 2]| line.windows(2).any(|w| w == [a, b]);
        assert!(segments.into_iter().all(is_drawn));
    }
}

//! A closed chain of points, before it is checked.

use super::super::Segment;
use super::{OutlineNote, Parts};
use crate::geometry::{Bounds, DVec2};

/// First and last points that differ by less, in sizes of the chain, are one: sin(2π) is not 0.
const SAME_POINT: f64 = 1e-9;

/// The chain found by a reader, with its notes.
#[derive(Debug, Default)]
pub(super) struct Ring {
    /// The name inside the file.
    pub name: Option<String>,
    pub points: Vec<DVec2>,
    pub notes: Vec<OutlineNote>,
    /// The path on which the points lie, if the format has one.
    pub segments: Vec<Segment>,
    /// What else the file holds.
    pub parts: Option<Parts>,
}

impl Ring {
    /// A chain of a format in which closing is implicit.
    pub fn of(points: Vec<DVec2>) -> Self {
        Self { points, ..Self::default() }.implicitly_closed()
    }

    /// The chain without a last point equal to the first up to rounding, which is dropped with a note.
    pub fn implicitly_closed(mut self) -> Self {
        if let [first, .., last] = *self.points.as_slice()
            && self.points.len() > 3
            && first.distance(last) <= SAME_POINT * Bounds::of(self.points.iter().copied()).size().max_element()
        {
            self.points.pop();
            self.notes.push(OutlineNote::ClosingPointDropped);
        }
        self
    }

    /// Drops points equal to the one before them, with a note. The points of a path have none.
    pub fn drop_repeated_points(&mut self) {
        let before = self.points.len();
        self.points.dedup();
        if self.points.len() < before {
            self.notes.push(OutlineNote::RepeatedPointsDropped { count: before - self.points.len() });
        }
    }

    /// The candidate of largest area, with a note if there were several.
    pub fn largest_of(candidates: Vec<Vec<DVec2>>) -> Option<Self> {
        let rings = candidates.len();
        let index = largest(&candidates)?;
        let points = candidates.into_iter().nth(index)?;
        let notes = if rings > 1 { vec![OutlineNote::LargestOf { rings }] } else { Vec::new() };
        Some(Self { points, notes, ..Self::default() })
    }
}

/// The index of the chain of largest area, the first among equals.
pub(super) fn largest<'a>(candidates: impl IntoIterator<Item = &'a Vec<DVec2>>) -> Option<usize> {
    let areas: Vec<f64> = candidates.into_iter().map(|c| area(c)).collect();
    (0..areas.len()).rev().max_by(|&i, &j| areas[i].total_cmp(&areas[j]))
}

/// The area inside a chain, used for comparison only; overflow is possible.
pub(super) fn area(points: &[DVec2]) -> f64 {
    signed_area(points).abs()
}

/// The area to the left of a closed chain.
pub(super) fn signed_area(points: &[DVec2]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    0.5 * edges(points).map(|[a, b]| (a - origin).perp_dot(b - origin)).sum::<f64>()
}

/// The edges of a closed chain.
pub(super) fn edges(points: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

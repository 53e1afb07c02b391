//! A closed chain of points, before it is checked.

use super::super::{Segment, flattened};
use super::OutlineNote;
use crate::geometry::DVec2;

/// The chain found by a reader, with its notes.
#[derive(Debug, Default)]
pub(super) struct Ring {
    /// The name inside the file.
    pub name: Option<String>,
    pub points: Vec<DVec2>,
    pub notes: Vec<OutlineNote>,
    /// The path on which the points lie, if the format has one.
    pub segments: Vec<Segment>,
}

impl Ring {
    /// A chain from a format in which closing is implicit: a last point equal
    /// to the first is dropped, with a note.
    pub fn implicitly_closed(mut points: Vec<DVec2>) -> Self {
        let mut notes = Vec::new();
        if points.len() > 3 && points.first() == points.last() {
            points.pop();
            notes.push(OutlineNote::ClosingPointDropped);
        }
        Self { points, notes, ..Self::default() }
    }

    /// The candidate of largest area, with a note if there were several.
    pub fn largest_of(candidates: Vec<Vec<DVec2>>) -> Option<Self> {
        let rings = candidates.len();
        let index = largest(&candidates)?;
        let points = candidates.into_iter().nth(index)?;
        let notes = if rings > 1 { vec![OutlineNote::LargestOf { rings }] } else { Vec::new() };
        Some(Self { points, notes, ..Self::default() })
    }

    /// The closed path of largest area, with a note if there were several.
    pub fn largest_path_of(mut paths: Vec<Vec<Segment>>) -> Option<Self> {
        let polygons: Vec<Vec<DVec2>> = paths.iter().map(|path| flattened(path)).collect();
        let index = largest(&polygons)?;
        Some(Self { segments: paths.swap_remove(index), ..Self::largest_of(polygons)? })
    }
}

/// The index of the chain of largest area, the first among equals.
pub(super) fn largest(candidates: &[Vec<DVec2>]) -> Option<usize> {
    let areas: Vec<f64> = candidates.iter().map(|c| area(c)).collect();
    (0..areas.len()).rev().max_by(|&i, &j| areas[i].total_cmp(&areas[j]))
}

/// The area inside a chain, used for comparison only; overflow is possible.
pub(super) fn area(points: &[DVec2]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    let wrapped = points.iter().zip(points.iter().cycle().skip(1));
    wrapped.map(|(&a, &b)| (a - origin).perp_dot(b - origin)).sum::<f64>().abs()
}

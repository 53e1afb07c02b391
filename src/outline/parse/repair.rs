//! Cuts off what makes a chain touch itself in its own vertices.
//!
//! Icons and coast lines often contain a repeated point, a tiny loop that comes
//! back to where it began, or a spike without width. Crossings are left alone:
//! there is no telling which side was meant.

use super::ring::area;
use crate::geometry::{DVec2, PolygonError, SimplePolygon};

/// Repairs at most; an outline that needs more has another fault.
const MAX_CUTS: usize = 200;

/// Removes repeated points with the smaller loop between them, and the tips of
/// spikes. Returns how many points were dropped.
pub(super) fn cut_loops_and_spikes(points: &mut Vec<DVec2>) -> usize {
    let before = points.len();
    for _ in 0..MAX_CUTS {
        match SimplePolygon::try_from(points.clone()) {
            Err(PolygonError::RepeatedPoint { first, second, .. }) => cut_smaller_loop(points, first, second),
            Err(PolygonError::FoldsBack { index, .. }) => drop(points.remove(index)),
            _ => break,
        }
    }
    before - points.len()
}

/// Points `first` and `second` are the same: of the two loops through them the larger stays.
fn cut_smaller_loop(points: &mut Vec<DVec2>, first: usize, second: usize) {
    let inner: Vec<DVec2> = points[first..second].to_vec();
    let mut outer = points[..first].to_vec();
    outer.extend_from_slice(&points[second..]);
    *points = if area(&inner) > area(&outer) { inner } else { outer };
}

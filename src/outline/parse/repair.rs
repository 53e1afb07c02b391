//! Removes loops and spikes with which a chain touches itself in its own vertices.
//!
//! Icons and coast lines often contain a repeated point, a tiny loop that returns
//! to its start, or a spike without width. Crossings are not repaired, since
//! it is unknown which side was meant.

use super::ring::area;
use crate::geometry::{DVec2, PolygonError, SimplePolygon};

/// The largest number of repairs; an outline that needs more is faulty in another way.
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

/// Points `first` and `second` coincide: keeps the larger of the two loops through them.
fn cut_smaller_loop(points: &mut Vec<DVec2>, first: usize, second: usize) {
    let inner: Vec<DVec2> = points[first..second].to_vec();
    let mut outer = points[..first].to_vec();
    outer.extend_from_slice(&points[second..]);
    *points = if area(&inner) > area(&outer) { inner } else { outer };
}

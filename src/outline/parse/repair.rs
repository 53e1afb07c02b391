//! Removes what makes a chain touch or cross itself, where it is small beside the rest.
//!
//! Icons and coast lines often contain a repeated point, a tiny loop that returns
//! to its start, a spike without width, or a knot where two strokes of a pen crossed. A crossing of which both loops are
//! large is not repaired, since it is unknown which side was meant.

use super::OutlineNote;
use super::ring::area;
use crate::geometry::{DVec2, PolygonError, SimplePolygon};

/// The largest number of repairs; an outline that needs more is faulty in another way.
const MAX_CUTS: usize = 200;

/// The largest area of a loop behind a crossing that is cut off, in areas of the rest.
const SMALL: f64 = 0.1;

/// Removes repeated points with the smaller loop between them, the tips of spikes, and small loops behind crossings.
/// What was cut off is said; `None` if nothing was.
pub(super) fn mend(points: &mut Vec<DVec2>) -> Option<OutlineNote> {
    let before = points.len();
    let (mut cuts, mut added) = (0, 0);
    while cuts < MAX_CUTS {
        match SimplePolygon::try_from(points.clone()) {
            Err(PolygonError::RepeatedPoint { first, second, .. }) => cut_smaller_loop(points, first, second),
            Err(PolygonError::FoldsBack { index, .. }) => drop(points.remove(index)),
            Err(PolygonError::EdgesTouch { first, second, at }) => added += join(points, [first, second], at),
            Err(PolygonError::EdgesCross { first, second, at }) => match without_knot(points, [first, second], at) {
                Some(rest) => {
                    *points = rest;
                    added += 1;
                }
                None => break,
            },
            _ => break,
        }
        cuts += 1;
    }
    (cuts > 0).then(|| OutlineNote::Repaired { dropped: (before + added).saturating_sub(points.len()) })
}

/// Points `first` and `second` coincide: keeps the larger of the two loops through them.
fn cut_smaller_loop(points: &mut Vec<DVec2>, first: usize, second: usize) {
    let inner: Vec<DVec2> = points[first..second].to_vec();
    let mut outer = points[..first].to_vec();
    outer.extend_from_slice(&points[second..]);
    *points = if area(&inner) > area(&outer) { inner } else { outer };
}

/// Makes a vertex, `at`, of the edge inside which another vertex lies; both then coincide. Returns the number of new points.
fn join(points: &mut Vec<DVec2>, edges: [usize; 2], at: DVec2) -> usize {
    let n = points.len();
    let inside = edges.into_iter().find(|&k| points[k] != at && points[(k + 1) % n] != at);
    if let Some(edge) = inside {
        points.insert(edge + 1, at);
    }
    usize::from(inside.is_some())
}

/// The larger of the loops on both sides of the crossing of two edges, if the other one is small.
fn without_knot(points: &[DVec2], [first, second]: [usize; 2], at: DVec2) -> Option<Vec<DVec2>> {
    let inner: Vec<DVec2> = [at].into_iter().chain(points[first + 1..=second].iter().copied()).collect();
    let outer: Vec<DVec2> =
        points[..=first].iter().copied().chain([at]).chain(points[second + 1..].iter().copied()).collect();
    let (small, large) = if area(&inner) > area(&outer) { (outer, inner) } else { (inner, outer) };
    (area(&small) <= SMALL * area(&large)).then_some(large)
}

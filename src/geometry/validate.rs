//! The checks that turn a list of points into a [`super::SimplePolygon`].
//!
//! The cheapest checks come first, and each error names the place. Coordinates
//! within ±[`MAX_COORDINATE`] and an extent of at least [`MIN_EXTENT`] make
//! every product in the exact predicates representable: no overflow or
//! underflow here, nor later in squared lengths and areas.

use glam::DVec2;

use super::PolygonError;
use super::predicates::{Side, side};
use super::sorting::sort_by_number;
use super::sweep::check_simple;

/// The largest number of points that an outline may have.
pub const MAX_POINTS: usize = 200_000;

/// The largest magnitude of a coordinate.
pub const MAX_COORDINATE: f64 = 1e30;

/// The smallest length of the longer side of an outline's bounding box.
pub const MIN_EXTENT: f64 = 1e-30;

/// Coordinates smaller than this are replaced by 0. If they were kept, differences could be
/// multiples of less than 2⁻¹⁹², and the mesher's predicates refuse values
/// below 2⁻¹⁴²; an outline at least 1e-30 across does not change visibly.
const NEGLIGIBLE: f64 = 1.0 / (1u128 << 126) as f64 / (1 << 14) as f64;

/// A valid list of points and its orientation.
#[derive(Debug)]
pub(super) struct Checked {
    /// The points, with negligible coordinates and negative zeros replaced by 0.
    pub points: Vec<DVec2>,
    /// Whether the points are clockwise.
    pub clockwise: bool,
}

/// Checks all invariants of a simple polygon except its orientation, which is reported.
pub(super) fn check(mut points: Vec<DVec2>) -> Result<Checked, PolygonError> {
    check_count(points.len())?;
    check_range(&points)?;
    for p in &mut points {
        // Adding 0 turns −0 into 0, so that equal coordinates have equal bits.
        *p = DVec2::select(p.abs().cmplt(DVec2::splat(NEGLIGIBLE)), DVec2::ZERO, *p) + DVec2::ZERO;
    }
    let order = lexicographic_order(&points);
    check_distinct(&points, &order)?;
    check_not_flat(&points)?;
    check_no_folds(&points)?;
    check_simple(&points, &order)?;
    let clockwise = is_clockwise(&points, order[0] as usize);
    Ok(Checked { points, clockwise })
}

fn check_count(count: usize) -> Result<(), PolygonError> {
    match count {
        0..3 => Err(PolygonError::TooFewPoints { count }),
        3..=MAX_POINTS => Ok(()),
        _ => Err(PolygonError::TooManyPoints { count }),
    }
}

fn check_range(points: &[DVec2]) -> Result<(), PolygonError> {
    let (mut low, mut high) = (points[0], points[0]);
    for (index, &at) in points.iter().enumerate() {
        if !at.is_finite() {
            return Err(PolygonError::NotFinite { index, at });
        }
        if at.abs().max_element() > MAX_COORDINATE {
            return Err(PolygonError::TooFarOut { index, at });
        }
        (low, high) = (low.min(at), high.max(at));
    }
    let extent = (high - low).max_element();
    // If all points coincide, the error about repeated points says more.
    if extent > 0.0 && extent < MIN_EXTENT { Err(PolygonError::TooSmall { extent }) } else { Ok(()) }
}

/// Point indices sorted by x, then y, then index.
fn lexicographic_order(points: &[DVec2]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    sort_by_number(&mut order, |&k| points[k as usize].y);
    sort_by_number(&mut order, |&k| points[k as usize].x);
    order
}

fn check_distinct(points: &[DVec2], order: &[u32]) -> Result<(), PolygonError> {
    let repeated = order.windows(2).filter(|w| points[w[0] as usize] == points[w[1] as usize]).min_by_key(|w| w[1]);
    match repeated {
        None => Ok(()),
        Some(w) => {
            let (first, second) = (w[0] as usize, w[1] as usize);
            Err(PolygonError::RepeatedPoint { first, second, at: points[first] })
        }
    }
}

fn check_not_flat(points: &[DVec2]) -> Result<(), PolygonError> {
    let (a, b) = (points[0], points[1]);
    if points[2..].iter().all(|&p| side(a, b, p) == Side::On) { Err(PolygonError::ZeroArea) } else { Ok(()) }
}

/// The sweep finds folds too, but often reports them first as a touch, which says less.
fn check_no_folds(points: &[DVec2]) -> Result<(), PolygonError> {
    let n = points.len();
    let folds = |&index: &usize| {
        let (a, at, b) = (points[(index + n - 1) % n], points[index], points[(index + 1) % n]);
        (a - at).dot(b - at) > 0.0 && side(a, at, b) == Side::On
    };
    (0..n).find(folds).map_or(Ok(()), |index| Err(PolygonError::FoldsBack { index, at: points[index] }))
}

/// Orientation of a simple polygon: the sign of the turn at its lexicographically first vertex.
fn is_clockwise(points: &[DVec2], first: usize) -> bool {
    let n = points.len();
    let (a, b) = (points[(first + n - 1) % n], points[(first + 1) % n]);
    side(a, points[first], b) == Side::Right
}

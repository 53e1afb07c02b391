//! The nearest of several points to a query point at any distance.
//!
//! From far away, distances to the points of a shape agree in all their digits, so distances are not compared.
//! The sign of the difference of their squares is computed instead, in a form that does not cancel; and a query
//! point beyond a million extents of the shape is moved to that distance in the same direction, so that nothing
//! overflows.

use super::{DVec2, DVec3};

/// In extents of the shape. From any point farther away, the directions to the shape agree up to 1e-6; at this
/// distance, differences are resolved to 1e-10 of an extent.
const FAR: f64 = 1e6;

/// Whether `p` is nearer to `x` than `q`: the sign of |p − x|² − |q − x|².
pub fn is_nearer(p: DVec3, q: DVec3, x: DVec3) -> bool {
    (p - q).dot(p.midpoint(q) - x) < 0.0
}

/// `x`; if it is farther than a million extents from the middle of the box, the point at that distance towards it.
pub fn pulled_back(x: DVec3, low: DVec3, high: DVec3) -> DVec3 {
    let (middle, reach) = (low.midpoint(high), FAR * (high - low).max_element());
    let away = x - middle;
    let length = away.abs().max_element();
    if length > reach { middle + away / length * reach } else { x }
}

/// A point of a closed chain.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ChainPoint {
    /// The edge that contains the point, named by its first vertex.
    pub edge: usize,
    /// The position along the edge from its first vertex, in `[0, 1]`.
    pub along: f64,
    /// The position of the point.
    pub place: DVec3,
}

/// The point nearest to `x` of the closed chain of `points`; of several, the first. `None` if there are no points, or
/// `x` is not finite. Cost O(m).
pub fn nearest_of_chain(points: impl Iterator<Item = DVec3> + Clone, x: DVec3) -> Option<ChainPoint> {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = points.clone().fold(empty, |(low, high), p| (low.min(p), high.max(p)));
    let x = pulled_back(x, low, high);
    let edges = points.clone().zip(points.cycle().skip(1)).enumerate();
    let feet = edges.map(|(edge, (a, b))| {
        let along = ((x - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        ChainPoint { edge, along, place: if along == 1.0 { b } else { a + along * (b - a) } }
    });
    let finite = feet.filter(|foot| foot.place.is_finite());
    finite.reduce(|best, next| if is_nearer(next.place, best.place, x) { next } else { best })
}

/// As [`nearest_of_chain`], in the plane.
pub fn nearest_of_polygon(points: &[DVec2], x: DVec2) -> Option<ChainPoint> {
    nearest_of_chain(points.iter().map(|p| p.extend(0.0)), x.extend(0.0))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn ring() -> Vec<DVec2> {
        (0..36).map(|k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 36.0)).collect()
    }

    #[test]
    fn from_any_distance_the_nearest_point_is_the_outermost_one() {
        for scale in [1e-30, 1.0, 1e30] {
            let scaled: Vec<DVec2> = ring().into_iter().map(|p| scale * p).collect();
            for (k, vertex) in ring().into_iter().enumerate() {
                for distance in [2.0 * scale, 1e8 * scale, 1e100, 1e160, 1.7e308] {
                    let found = nearest_of_polygon(&scaled, distance * vertex).unwrap();
                    let on = (found.edge + usize::from(found.along == 1.0)) % 36;
                    assert_eq!(on, k, "{scale:e}, {distance:e}: {found:?}");
                }
            }
        }
    }

    #[test]
    fn of_points_on_a_diagonal_far_out_the_corner_is_nearest() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from_array);
        for far in [1e20, 1e150, 1e308] {
            let found = nearest_of_polygon(&square, DVec2::splat(far)).unwrap();
            assert_eq!(found.place, DVec3::new(1.0, 1.0, 0.0), "{far:e}");
        }
        assert_eq!(nearest_of_polygon(&square, DVec2::new(0.25, -1.0)).unwrap().along, 0.25);
        assert_eq!(nearest_of_polygon(&square, DVec2::NAN), None);
        assert_eq!(nearest_of_polygon(&[], DVec2::ZERO), None);
    }
}

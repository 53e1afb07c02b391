//! The smallest spherical cap around points.
//!
//! The cap of at most three points is known; the point farthest outside joins them until none is outside (as in Welzl's
//! and other algorithms for smallest balls, whose intersection with the sphere the cap is). Exact up to rounding if the
//! points lie in a hemisphere; a cap around all points, perhaps not the smallest one, if they do not.

use crate::geometry::DVec3;

/// Rounds at most; a few are usual, since each cap is larger than the one before.
const ROUNDS: usize = 1000;

/// A cap {p : p·c ≥ cosine}.
#[derive(Debug, Clone, Copy)]
struct Cap {
    center: DVec3,
    cosine: f64,
}

impl Cap {
    /// The center's direction is that of `towards`, on the side of the points.
    fn of(towards: DVec3, points: &[DVec3]) -> Option<Self> {
        let center = towards.try_normalize()?;
        let center = if points[0].dot(center) < 0.0 { -center } else { center };
        let cosine = points.iter().map(|p| p.dot(center)).fold(1.0, f64::min);
        Some(Self { center, cosine })
    }
}

/// The center of the smallest cap; `points` has at least one.
pub fn smallest(points: &[DVec3]) -> DVec3 {
    let mut support = vec![points[0]];
    let mut cap = Cap { center: points[0], cosine: 1.0 };
    for _ in 0..ROUNDS {
        let farthest = points.iter().copied().min_by(|p, q| p.dot(cap.center).total_cmp(&q.dot(cap.center)));
        let Some(farthest) = farthest.filter(|p| p.dot(cap.center) < cap.cosine - 1e-15) else { break };
        support.push(farthest);
        let Some((next, kept)) = smallest_of_few(&support) else { break };
        if next.cosine >= cap.cosine {
            break;
        }
        (cap, support) = (next, kept);
    }
    cap.center
}

/// The smallest cap around at most four points among those that two or three of them determine, and these.
fn smallest_of_few(points: &[DVec3]) -> Option<(Cap, Vec<DVec3>)> {
    let n = points.len();
    let mut best: Option<(Cap, Vec<DVec3>)> = None;
    let mut offer = |towards: DVec3, of: &[DVec3]| {
        let Some(cap) = Cap::of(towards, of) else { return };
        let holds_all = points.iter().all(|p| p.dot(cap.center) >= cap.cosine - 1e-14);
        if holds_all && best.as_ref().is_none_or(|(least, _)| cap.cosine > least.cosine) {
            best = Some((cap, of.to_vec()));
        }
    };
    for i in 0..n {
        for j in 0..i {
            offer(points[i] + points[j], &[points[i], points[j]]);
            for k in 0..j {
                let normal = (points[j] - points[i]).cross(points[k] - points[i]);
                offer(normal, &[points[i], points[j], points[k]]);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cap_of_a_circle_is_its_own_and_inner_points_do_not_count() {
        let center = DVec3::new(0.3, -0.5, 0.8).normalize();
        let side = center.any_orthonormal_vector();
        let other = center.cross(side);
        let at = |distance: f64, angle: f64| {
            distance.cos() * center + distance.sin() * (angle.cos() * side + angle.sin() * other)
        };
        let mut points: Vec<DVec3> = (0..50).map(|k| at(0.5, f64::from(k))).collect();
        points.extend((0..50).map(|k| at(0.3, 0.7 * f64::from(k))));
        assert!(smallest(&points).distance(center) < 1e-3);
        // two opposite points alone
        let two = [at(0.4, 0.0), at(0.1, 1.0), at(0.4, std::f64::consts::PI), at(0.2, 2.0)];
        assert!(smallest(&two).distance(center) < 1e-12);
    }
}

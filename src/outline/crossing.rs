//! Whether a closed chain of cubic Bézier curves crosses or touches itself.
//!
//! Curves are halved until the boxes of their control points are disjoint. The answer "no" is certain up to rounding;
//! where halving does not part two curves after [`HALVINGS`] steps, they count as touching.

use super::corners::turn_between;
use super::overlaps::for_each_overlap;
use crate::geometry::{Bounds, DVec2};

type Cubic = [DVec2; 4];

/// Halvings on the way to one pair of parts: 2⁻²⁰ of both curves.
const HALVINGS: u32 = 40;
/// The most pairs of parts that are examined for one pair of curves; sides of a channel as long as 100 widths need 400.
const MOST_PARTS: u32 = 20_000;
/// Halvings next to a joint, until the curves' control points lie on different sides: the angle between two curves of
/// usual bend is then known to 2⁻³⁰.
const JOINT_HALVINGS: u32 = 30;

/// Two curves of a closed chain that meet elsewhere than at their joint; the indices of the first such pair found. If
/// there are too many pairs to examine, the first and the last curve.
pub(super) fn first_crossing(chain: &[Cubic]) -> Option<(usize, usize)> {
    let n = chain.len();
    let boxes: Vec<Bounds> = chain.iter().map(|c| Bounds::of(*c)).collect();
    let mut found = None;
    let complete = for_each_overlap(&boxes, &mut |i, j| {
        if found.is_none() && do_meet(chain, i, j) {
            found = Some((i.min(j), i.max(j)));
        }
    });
    found.or_else(|| (!complete).then(|| (0, n - 1)))
}

fn do_meet(chain: &[Cubic], i: usize, j: usize) -> bool {
    let (n, mut parts) = (chain.len(), 0);
    match ((i + 1) % n == j, (j + 1) % n == i) {
        (true, true) => true,
        (true, false) => meet_beside_joint(reversed(chain[i]), chain[j], &mut parts),
        (false, true) => meet_beside_joint(reversed(chain[j]), chain[i], &mut parts),
        (false, false) => may_meet(chain[i], chain[j], HALVINGS, &mut parts),
    }
}

/// Whether parts of two curves have overlapping boxes after `halvings`.
fn may_meet(a: Cubic, b: Cubic, halvings: u32, parts: &mut u32) -> bool {
    let [p, q] = [Bounds::of(a), Bounds::of(b)];
    if p.min().cmpgt(q.max()).any() || q.min().cmpgt(p.max()).any() {
        return false;
    }
    *parts += 1;
    if halvings == 0 || *parts > MOST_PARTS {
        return true;
    }
    let is_larger = p.size().max_element() >= q.size().max_element();
    let ([c, d], other) = if is_larger { (halves(a), b) } else { (halves(b), a) };
    may_meet(c, other, halvings - 1, parts) || may_meet(d, other, halvings - 1, parts)
}

/// Whether two curves that begin at the same point meet again.
fn meet_beside_joint(mut a: Cubic, mut b: Cubic, parts: &mut u32) -> bool {
    for _ in 0..JOINT_HALVINGS {
        if lie_apart(&a, &b) {
            return false;
        }
        let ([near_a, far_a], [near_b, far_b]) = (halves(a), halves(b));
        if may_meet(far_a, b, HALVINGS, parts) || may_meet(near_a, far_b, HALVINGS, parts) {
            return true;
        }
        (a, b) = (near_a, near_b);
    }
    true
}

/// Whether the control points of two curves lie in different sectors around their common first point.
fn lie_apart(a: &Cubic, b: &Cubic) -> bool {
    let sector = |curve: &Cubic| {
        let middle = curve[3] - curve[0];
        let width = [1, 2]
            .map(|k| curve[k] - curve[0])
            .map(|p| if p == DVec2::ZERO { 0.0 } else { turn_between(middle, p).abs() });
        (middle, width[0].max(width[1]))
    };
    let ((u, half_a), (v, half_b)) = (sector(a), sector(b));
    u != DVec2::ZERO && v != DVec2::ZERO && turn_between(u, v).abs() > half_a + half_b
}

fn reversed([a, b, c, d]: Cubic) -> Cubic {
    [d, c, b, a]
}

/// Both halves, by de Casteljau's algorithm.
fn halves([a, b, c, d]: Cubic) -> [Cubic; 2] {
    let (ab, bc, cd) = (a.midpoint(b), b.midpoint(c), c.midpoint(d));
    let (abc, bcd) = (ab.midpoint(bc), bc.midpoint(cd));
    let middle = abc.midpoint(bcd);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(a: (f64, f64), b: (f64, f64)) -> Cubic {
        let (a, b) = (DVec2::from(a), DVec2::from(b));
        [a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b]
    }

    fn chain(points: &[(f64, f64)]) -> Vec<Cubic> {
        (0..points.len()).map(|k| line(points[k], points[(k + 1) % points.len()])).collect()
    }

    #[test]
    fn polygons_cross_where_their_edges_do() {
        assert_eq!(first_crossing(&chain(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)])), None);
        assert_eq!(first_crossing(&chain(&[(0., 0.), (1., 1.), (1., 0.), (0., 1.)])), Some((0, 2)));
        // a needle of 1e-6, and one that folds back onto itself
        assert_eq!(first_crossing(&chain(&[(0., 0.), (2., 0.), (1., 1e-6), (0., 1.)])), None);
        assert!(first_crossing(&chain(&[(0., 0.), (2., 0.), (1., 0.), (0., 1.)])).is_some());
    }

    #[test]
    fn a_bulge_into_the_opposite_edge_is_found_and_one_before_it_is_not() {
        for (bulge, meets) in [(1.3, false), (1.3335, true), (1.6, true)] {
            let mut around = chain(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)]);
            // at its middle the curve is 3/4 of the height of its control points above the edge
            around[0][1].y = bulge;
            around[0][2].y = bulge;
            assert_eq!(first_crossing(&around).is_some(), meets, "{bulge}");
        }
    }

    #[test]
    fn a_curve_that_leaves_a_corner_across_its_neighbor_is_found() {
        let mut around = chain(&[(0., 0.), (1., 0.), (1., 1.), (0., 1.)]);
        around[1] = [(1., 0.), (1.2, -0.3), (0.2, -0.3), (1., 1.)].map(DVec2::from);
        assert_eq!(first_crossing(&around), Some((0, 1)));
        around[1] = [(1., 0.), (1.2, -0.3), (1.2, 0.3), (1., 1.)].map(DVec2::from);
        assert_eq!(first_crossing(&around), None);
    }
}

//! Finds chords between samples that cross, and the vertices that separate them when added as samples.

use super::arc::Arc;
use crate::geometry::{DVec2, on_segment, side};

/// For each chord that meets another one, the arc length of the polygon vertex
/// nearest to its middle, if there is any vertex inside. Exact tests, on the
/// pairs of chords whose bounding boxes overlap. Cost O(m c) with c chords over the
/// same x, but at most [`BUDGET`] such pairs are examined: further crossings are
/// left to the mesher, which reports them.
pub(super) fn first_vertices_to_add(arc: &Arc, positions: &[f64]) -> Vec<f64> {
    let points: Vec<DVec2> = positions.iter().map(|&s| arc.point(s)).collect();
    let mut crossing = vec![false; points.len()];
    for_each_candidate(&points, &mut |i, j| {
        if !(crossing[i] && crossing[j]) && meet(&points, i, j) {
            (crossing[i], crossing[j]) = (true, true);
        }
    });
    let crossing = crossing.iter().enumerate().filter(|&(_, &crossing)| crossing);
    crossing.filter_map(|(k, _)| middle_vertex(arc, positions, k)).collect()
}

/// The vertex strictly between samples `k` and `k+1` that is nearest to their middle in arc length.
fn middle_vertex(arc: &Arc, positions: &[f64], k: usize) -> Option<f64> {
    let (start, end) = (positions[k], positions.get(k + 1).copied().unwrap_or(arc.length()));
    let middle = 0.5 * (start + end);
    let edge = arc.edge_at(middle);
    let candidates = [edge, edge + 1].map(|v| arc.at_vertex(v));
    let inside = candidates.into_iter().filter(|&s| start < s && s < end);
    inside.min_by(|a, b| (a - middle).abs().total_cmp(&(b - middle).abs()))
}

/// Whether chords `i` and `j` meet, other than at the sample that they share.
fn meet(points: &[DVec2], i: usize, j: usize) -> bool {
    let m = points.len();
    let (a, b, c, d) = (points[i], points[(i + 1) % m], points[j], points[(j + 1) % m]);
    if (i + 1) % m == j {
        return on_segment(a, b, d) || on_segment(c, d, a);
    }
    if (j + 1) % m == i {
        return on_segment(c, d, b) || on_segment(a, b, c);
    }
    let touch = on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
    let parted = |a: DVec2, b: DVec2, c: DVec2, d: DVec2| side(a, b, c) != side(a, b, d);
    touch || (parted(a, b, c, d) && parted(c, d, a, b))
}

/// Limit on examined pairs, 0.1 s; a coastline of 1,500 chords has 2e4 pairs over the same x, the worst preset 1e5.
const BUDGET: usize = 20_000_000;

/// Calls `visit` for pairs of chords whose bounding boxes overlap, by a sweep over x.
fn for_each_candidate(points: &[DVec2], visit: &mut dyn FnMut(usize, usize)) {
    let m = points.len();
    let low = |k: u32| points[k as usize].min(points[(k as usize + 1) % m]);
    let high = |k: u32| points[k as usize].max(points[(k as usize + 1) % m]);
    let mut order: Vec<u32> = (0..m as u32).collect();
    order.sort_unstable_by(|&i, &j| low(i).x.total_cmp(&low(j).x).then(i.cmp(&j)));
    let mut active: Vec<u32> = Vec::new();
    let mut budget = BUDGET;
    for k in order {
        let (from, to) = (low(k), high(k));
        let Some(left) = budget.checked_sub(active.len()) else { return };
        budget = left;
        active.retain(|&j| high(j).x >= from.x);
        for &j in active.iter().filter(|&&j| low(j).y <= to.y && high(j).y >= from.y) {
            visit(j as usize, k as usize);
        }
        active.push(k);
    }
}

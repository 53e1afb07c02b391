//! Finds chords between samples that cross, and the vertices that separate them when added as samples.

use super::super::overlaps::for_each_overlap;
use super::arc::Arc;
use crate::geometry::{Bounds, DVec2, on_segment, side};

/// For each chord that meets another one, the arc length of the polygon vertex
/// nearest to its middle, if there is any vertex inside. Exact tests, on the
/// pairs of chords whose bounding boxes overlap. Cost O(m c) with c chords over the
/// same x, but only as many such pairs are examined as [`for_each_overlap`] visits: further crossings are
/// left to the mesher, which reports them.
pub(super) fn first_vertices_to_add(arc: &Arc, positions: &[f64]) -> Vec<f64> {
    let points: Vec<DVec2> = positions.iter().map(|&s| arc.point(s)).collect();
    let mut crossing = vec![false; points.len()];
    let m = points.len();
    let boxes: Vec<Bounds> = (0..m).map(|k| Bounds::of([points[k], points[(k + 1) % m]])).collect();
    for_each_overlap(&boxes, &mut |i, j| {
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

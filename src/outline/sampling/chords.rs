//! Chords between samples that cross, or cut off too much of the area, and the vertices that mend this as samples.

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

/// For the chords that cut off the largest parts, so many that what all cut off falls to `share` of the outline's area,
/// the arc length of the vertex nearest to the middle. Parts are signed areas between a chord and the outline.
pub(super) fn vertices_where_area_is_lost(arc: &Arc, positions: &[f64], share: f64) -> Vec<f64> {
    let whole = twice_area(arc.vertices().iter().copied()).abs();
    let mut parts: Vec<(f64, usize)> = (0..positions.len()).map(|k| (part_cut_off(arc, positions, k), k)).collect();
    let mut excess = parts.iter().map(|part| part.0).sum::<f64>() - share * whole;
    parts.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
    let largest = parts.into_iter().take_while(|&(part, _)| {
        let needed = excess > 0.0;
        excess -= part;
        needed
    });
    largest.filter_map(|(_, k)| middle_vertex(arc, positions, k)).collect()
}

/// Twice the area between the chord from sample `k` and the outline.
fn part_cut_off(arc: &Arc, positions: &[f64], k: usize) -> f64 {
    let (start, end) = (positions[k], positions.get(k + 1).copied().unwrap_or(arc.length()));
    let between = (arc.edge_at(start) + 1..arc.vertices().len()).take_while(|&v| arc.at_vertex(v) < end);
    let last = arc.point(if end < arc.length() { end } else { 0.0 });
    let piece = std::iter::once(arc.point(start)).chain(between.map(|v| arc.vertices()[v])).chain([last]);
    twice_area(piece).abs()
}

/// Twice the signed area of a closed polygon.
fn twice_area(mut points: impl Iterator<Item = DVec2>) -> f64 {
    let Some(origin) = points.next() else { return 0.0 };
    let mut before = DVec2::ZERO;
    points.fold(0.0, |sum, p| {
        let offset = p - origin;
        sum + std::mem::replace(&mut before, offset).perp_dot(offset)
    })
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

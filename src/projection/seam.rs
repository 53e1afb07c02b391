//! Regions cut at the antimeridian are put together again (RFC 7946, 3.1.9).
//!
//! Every ring has its region on the left, so that the two sides of a cut are edges in opposite directions: along the
//! antimeridian edges are divided at each other's ends, and opposite ones cancel. The rest is walked anew. So the two
//! halves of a region that crosses the antimeridian become one ring, and a region around a pole, cut from the pole along
//! the antimeridian, loses the cut.

use super::ring::{Edge, Key, key};
use crate::geometry::DVec2;
use std::collections::BTreeMap;

/// The rings without their edges along the antimeridian that another one cancels.
pub fn joined(rings: Vec<Vec<Edge>>) -> Vec<Vec<Edge>> {
    let latitudes = latitudes_on_seam(&rings);
    let divided = rings.into_iter().map(|ring| divided(&ring, &latitudes)).filter(|ring: &Vec<Edge>| !ring.is_empty());
    let mut walk = Walk::default();
    for ring in divided {
        let first = walk.edges.len();
        let n = ring.len();
        walk.next.extend((0..n).map(|k| first + (k + 1) % n));
        walk.edges.extend(ring);
    }
    walk.cancel();
    let rings = walk.rings().into_iter().map(without_spikes);
    rings.filter(|ring| !ring.is_empty()).collect()
}

/// Whether the edge runs along the antimeridian.
fn is_on_seam(edge: &Edge) -> bool {
    edge.step.x == 0.0 && edge.from.x.abs() == 180.0
}

/// The latitudes of the ends of edges along the antimeridian, ascending.
fn latitudes_on_seam(rings: &[Vec<Edge>]) -> Vec<f64> {
    let on_seam = rings.iter().flatten().filter(|edge| is_on_seam(edge));
    let mut latitudes: Vec<f64> = on_seam.flat_map(|edge| [edge.from.y, edge.end.y]).collect();
    latitudes.sort_by(f64::total_cmp);
    latitudes.dedup();
    latitudes
}

/// The ring without edges of no length, those along the antimeridian divided at the given latitudes.
fn divided(ring: &[Edge], latitudes: &[f64]) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(ring.len());
    for edge in ring.iter().filter(|edge| !edge.is_nothing()) {
        if !is_on_seam(edge) {
            edges.push(*edge);
            continue;
        }
        let (low, high) = (edge.from.y.min(edge.end.y), edge.from.y.max(edge.end.y));
        let [first, last] =
            [latitudes.partition_point(|&stop| stop < low), latitudes.partition_point(|&stop| stop <= high)];
        let mut stops = latitudes[first..last].to_vec();
        if edge.step.y < 0.0 {
            stops.reverse();
        }
        let piece = |ends: &[f64]| Edge {
            from: DVec2::new(edge.from.x, ends[0]),
            end: DVec2::new(edge.from.x, ends[1]),
            step: DVec2::new(0.0, ends[1] - ends[0]),
            place: edge.place,
        };
        edges.extend(stops.windows(2).map(piece));
    }
    edges
}

/// All edges, and which follows which in its own ring.
#[derive(Debug, Default)]
struct Walk {
    edges: Vec<Edge>,
    next: Vec<usize>,
    /// Cancelled, or already part of a ring.
    used: Vec<bool>,
}

impl Walk {
    /// Marks the pairs of opposite edges along the antimeridian.
    fn cancel(&mut self) {
        self.used = vec![false; self.edges.len()];
        let mut waiting: BTreeMap<[u64; 2], Vec<usize>> = BTreeMap::new();
        for (k, edge) in self.edges.iter().enumerate().filter(|(_, edge)| is_on_seam(edge)) {
            let [from, to] = [key(edge.from)[1], key(edge.end)[1]];
            if let Some(opposite) = waiting.get_mut(&[to, from]).and_then(Vec::pop) {
                (self.used[k], self.used[opposite]) = (true, true);
            } else {
                waiting.entry([from, to]).or_default().push(k);
            }
        }
    }

    /// The closed chains of the edges that are not used yet. As many edges arrive at each vertex as leave it.
    fn rings(&mut self) -> Vec<Vec<Edge>> {
        let mut leaving: BTreeMap<Key, Vec<usize>> = BTreeMap::new();
        for (k, edge) in self.edges.iter().enumerate().filter(|&(k, _)| !self.used[k]) {
            leaving.entry(key(edge.from)).or_default().push(k);
        }
        let mut rings = Vec::new();
        for start in 0..self.edges.len() {
            let mut ring = Vec::new();
            let mut at = Some(start).filter(|&k| !self.used[k]);
            while let Some(k) = at {
                self.used[k] = true;
                ring.push(self.edges[k]);
                at = self.after(k, start, &leaving);
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }

    /// The edge after `k`: that of its own ring or, where this one is cancelled, another one that begins there.
    fn after(&self, k: usize, start: usize, leaving: &BTreeMap<Key, Vec<usize>>) -> Option<usize> {
        let own = self.next[k];
        if !self.used[own] {
            return Some(own);
        }
        let end = key(self.edges[k].end);
        if end == key(self.edges[start].from) {
            return None;
        }
        leaving.get(&end)?.iter().copied().find(|&other| !self.used[other])
    }
}

/// Removes edges that the next one goes back.
fn without_spikes(ring: Vec<Edge>) -> Vec<Edge> {
    // the same two points may also be joined the other way around the sphere
    let is_back = |a: &Edge, b: &Edge| key(a.from) == key(b.end) && (a.step + b.step).abs().max_element() < 1e-9;
    let mut kept: Vec<Edge> = Vec::with_capacity(ring.len());
    for edge in ring {
        if kept.last().is_some_and(|last| is_back(last, &edge)) {
            kept.pop();
        } else {
            kept.push(edge);
        }
    }
    let n = kept.len();
    let closing = (0..n / 2).take_while(|&k| is_back(&kept[n - 1 - k], &kept[k])).count();
    kept[closing..n - closing].to_vec()
}

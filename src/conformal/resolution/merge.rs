//! The vertices of both boundaries in the order of their harmonic measure, on the mapped boundary.
//!
//! A vertex of the other boundary lies on the mapped one where the measure is the same. Vertices of the other boundary
//! that lie closer to each other than the limit of the resolution form a group, of which only the first and the last
//! are kept (file `cut`). At an angle of π/β of the other domain, places within r of its corner crowd within r^β: a
//! small group around one corner, or around the anchor, becomes that vertex.

use super::cut::cut;
use super::rim::Rim;
use crate::geometry::sort_by_number;
use crate::outline::BoundarySamples;

/// The smallest distance between boundary vertices, relative to the extent of the domain: details of the other domain
/// are resolved whose images are 1e-6 in size, which takes a few vertices.
pub(super) const FINEST: f64 = 2e-7;

/// A group around one corner is that corner alone where it is smaller than this, relative to the extent of the domain.
const SMALL: f64 = 1e-3;

/// A vertex of the other boundary that is nearer than this, relative to the edges around, to a vertex of the mapped
/// boundary is left out: an edge of a tenth of its neighbors' length costs ten vertices of the mesh. On the polygon of
/// samples it becomes the image, and angles there change by up to that. On a curve the image stays exact, and a corner is
/// left out only next to a corner.
const SNAP: f64 = 0.12;

/// A vertex of the resolved boundary.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    /// The length on the mapped boundary, from the start.
    pub at: f64,
    /// Which vertex of the mapped boundary it is, if it is one.
    pub own: Option<u32>,
    /// The image: the number of edges of the other boundary from its start, with the fraction on the last one.
    pub image: f64,
    /// Whether the edge that starts here is mapped to a chord that cuts off a part of the other domain.
    pub is_cut: bool,
}

/// Vertices of the other boundary that are too close to each other.
struct Group {
    /// From the first to the last, with what a cut takes away around them.
    run: [usize; 2],
    /// Those that stay: both ends of the run, or one vertex twice.
    kept: [usize; 2],
}

/// Both boundaries merged.
pub(super) struct Merged {
    /// In the order of the mapped boundary from its start, a vertex of the other boundary.
    pub knots: Vec<Knot>,
    /// The length from the mapped boundary's anchor to the start.
    pub start: f64,
    /// The length of the mapped boundary.
    pub length: f64,
    /// The vertex of the other boundary at the start.
    pub first: usize,
    /// The parts of the other boundary that are cut off, as vertices from the first to the last.
    pub cuts: Vec<[usize; 2]>,
}

impl Merged {
    /// Merges the boundaries.
    pub fn new(mapped: &Rim<'_>, other: &Rim<'_>) -> Self {
        let finest = FINEST * mapped.extent();
        let length = mapped.length();
        let (places, vertices) = preimages(mapped, other);
        let count = places.len();
        // vertices closer than this are not told apart: what has no measure has no length
        let measured = |i: usize| match i {
            i if i + 1 < count => mapped.measured_length(places[i], places[i + 1]),
            i => mapped.measured_length(places[i], length) + mapped.measured_length(0.0, places[0]),
        };
        // the start: after the largest gap, which no group contains
        let gaps: Vec<f64> = (0..count).map(measured).collect();
        let widest = (0..count).max_by(|&i, &j| gaps[i].total_cmp(&gaps[j])).unwrap_or(0);
        let turn = (widest + 1) % count;
        let start = places[turn];
        let from_start = |s: f64, before: bool| if before { s - start + length } else { s - start };
        let others: Vec<f64> = (0..count).map(|i| from_start(places[(i + turn) % count], i + turn >= count)).collect();
        let first = vertices[turn];
        let mut own: Vec<(f64, u32, f64)> = (mapped.vertices())
            .map(|(vertex, knot)| {
                let (s, image) = (mapped.length_at(knot), other.point(other.length_of(mapped.at_knot(knot))));
                let passed = (image.edge() as usize + count - first) % count;
                // rounding may leave the start's own vertex before it
                let at = from_start(s, s < start - 0.2 * finest).max(0.0);
                (at, vertex as u32, passed as f64 + image.fraction())
            })
            .collect();
        sort_by_number(&mut own, |vertex| vertex.0);
        let mut merged = Self { knots: Vec::new(), start, length, first, cuts: Vec::new() };
        let gap = |i: usize| gaps[(i + turn) % count];
        let groups = merged.groups(&gap, other, finest);
        merged.join(&own, &others, &groups, (mapped, other), finest);
        merged
    }

    /// The groups of other vertices, in order. Those of more than two are cut off where the chord between their ends lies
    /// inside the other domain.
    fn groups(&mut self, gap: &dyn Fn(usize) -> f64, other: &Rim<'_>, finest: f64) -> Vec<Group> {
        let m = other.samples.len();
        let mut groups: Vec<Group> = Vec::new();
        let mut i = 0;
        while i < m {
            let last = (i..m).find(|&k| k + 1 == m || gap(k) >= finest).unwrap_or(i);
            if last > i {
                let least = groups.last().map_or(0, |group| group.run[1] + 1);
                let kept = if last == i + 1 {
                    [i, last]
                } else if let Some(corner) = self.only_corner(other, [i, last]) {
                    [corner, corner]
                } else {
                    self.cut_off(other.samples, [i, last], least)
                };
                let run = [i.min(kept[0]), last.max(kept[1])];
                groups.push(Group { run, kept });
                i = run[1];
            }
            i += 1;
        }
        groups
    }

    /// Cuts a run off; the ends of the chord, of which the first is not before `least`.
    fn cut_off(&mut self, samples: &BoundarySamples, [from, to]: [usize; 2], least: usize) -> [usize; 2] {
        let m = samples.len();
        let vertex = |k: usize| (self.first + k) % m;
        let ends = cut(samples.points(), vertex(from), to - from, [from - least.min(from), m - 1 - to]);
        let kept = [from - ends[0], to + ends[1]];
        self.cuts.push(kept.map(vertex));
        kept
    }

    /// The only corner of a small run, or its anchor where it has no corner.
    fn only_corner(&self, other: &Rim<'_>, [from, to]: [usize; 2]) -> Option<usize> {
        let vertex = |k: usize| (self.first + k) % other.samples.len();
        let [first, last] = [from, to].map(|k| other.samples.points()[vertex(k)]);
        if first.distance(last) > SMALL * other.extent() {
            return None;
        }
        let mut corners = (from..=to).filter(|&k| other.is_corner_of_curve(vertex(k)));
        match (corners.next(), corners.next()) {
            (Some(corner), None) => Some(corner),
            (None, _) => other.anchor_vertex().and_then(|anchor| (from..=to).find(|&k| vertex(k) == anchor)),
            _ => None,
        }
    }

    /// Merges own and other vertices, of each group the first and the last.
    fn join(
        &mut self,
        own: &[(f64, u32, f64)],
        others: &[f64],
        groups: &[Group],
        (mapped, other): (&Rim<'_>, &Rim<'_>),
        finest: f64,
    ) {
        let mut kept: Vec<(f64, usize, bool)> = Vec::new();
        let mut pending = groups.iter().peekable();
        let mut i = 0;
        while i < others.len() {
            if let Some(&Group { run, kept: [from, to] }) = pending.next_if(|group| group.run[0] == i) {
                if from < to {
                    // the ends stay apart
                    let spread = (0.25 * finest - 0.5 * (others[to] - others[from])).max(0.0);
                    kept.push((others[from] - spread, from, to > from + 1));
                    kept.push((others[to] + spread, to, false));
                } else {
                    kept.push((others[from], from, false));
                }
                i = run[1] + 1;
            } else {
                kept.push((others[i], i, false));
                i += 1;
            }
        }
        let count = others.len();
        let is_kept = |k: u32, i: usize| {
            other.is_corner_of_curve((self.first + i) % count) && !mapped.is_corner_of_curve(k as usize)
        };
        let snap = |k: u32, i: usize| if is_kept(k, i) { 0.0 } else { SNAP };
        self.knots = snapped(own, &kept, count, mapped, (finest, &snap));
    }
}

/// The lengths on the mapped boundary, from its anchor, where the other boundary's vertices lie by their measure,
/// ascending, and those vertices.
fn preimages(mapped: &Rim<'_>, other: &Rim<'_>) -> (Vec<f64>, Vec<usize>) {
    let mut before = 0.0;
    let place = |(vertex, knot): (usize, usize)| {
        before = mapped.length_of(other.at_knot(knot)).clamp(before, mapped.length());
        (before, vertex)
    };
    other.vertices().map(place).unzip()
}

/// Own and other vertices in order; others that nearly coincide with an own one, by `snap`, are replaced by it.
fn snapped(
    own: &[(f64, u32, f64)],
    kept: &[(f64, usize, bool)],
    count: usize,
    mapped: &Rim<'_>,
    (finest, snap): (f64, &dyn Fn(u32, usize) -> f64),
) -> Vec<Knot> {
    let mut knots: Vec<Knot> = Vec::with_capacity(own.len() + kept.len());
    let m = mapped.samples.len() as u32;
    let edges = |k: u32| [mapped.edge(((k + m - 1) % m) as usize), mapped.edge(k as usize)];
    let mut taken = vec![false; kept.len()];
    let gap = |i: usize| if i + 1 < kept.len() { kept[i + 1].0 - kept[i].0 } else { f64::INFINITY };
    let mut next = 0;
    let mut images: Vec<(f64, bool)> = Vec::with_capacity(own.len());
    for &(at, k, image) in own {
        while next < kept.len() && kept[next].0 < at {
            next += 1;
        }
        // between the ends of a cut the image is unknown: that of an end
        let inside_cut = next > 0 && next < kept.len() && kept[next - 1].2;
        let nearest = [next.checked_sub(1), (next < kept.len()).then_some(next)].into_iter().flatten();
        let nearest = nearest.min_by(|&i, &j| (kept[i].0 - at).abs().total_cmp(&(kept[j].0 - at).abs()));
        let snapped = nearest.filter(|&i| {
            let around = gap(i).min(if i > 0 { gap(i - 1) } else { f64::INFINITY });
            let [before, after] = edges(k);
            let near = (snap(k, kept[i].1) * around.min(before).min(after)).max(0.25 * finest);
            inside_cut || (kept[i].0 - at).abs() < near
        });
        if let Some(i) = snapped {
            images.push((kept[i].1 as f64, kept[i].2));
            taken[i] = true;
        } else {
            let [low, high] = [next.checked_sub(1).map_or(0, |i| kept[i].1), kept.get(next).map_or(count, |k| k.1)];
            images.push((nearest_lap(image, [low as f64, high as f64], count), false));
        }
    }
    let own = own.iter().zip(images).map(|(&(at, k, _), (image, is_cut))| Knot { at, own: Some(k), image, is_cut });
    knots.extend(own);
    let others = kept.iter().zip(taken).filter(|(_, taken)| !taken);
    knots.extend(others.map(|(&(at, i, is_cut), _)| Knot { at, own: None, image: i as f64, is_cut }));
    sort_by_number(&mut knots, |knot| knot.at);
    monotone(&mut knots, finest);
    knots
}

/// The image, which rounding may have moved around the whole boundary, between two others.
pub(super) fn nearest_lap(image: f64, [low, high]: [f64; 2], count: usize) -> f64 {
    let count = count as f64;
    (image - count * ((image - 0.5 * (low + high)) / count).round()).max(low).min(high)
}

/// Drops vertices that coincide with others, and makes the images ascend.
fn monotone(knots: &mut Vec<Knot>, finest: f64) {
    let all = std::mem::take(knots);
    for knot in all {
        let near = knots.last().is_some_and(|last| knot.at - last.at < 0.2 * finest);
        match (near, knots.last().and_then(|last| last.own), knot.own) {
            (true, _, None) => {
                if let Some(last) = knots.last_mut() {
                    last.is_cut |= knot.is_cut;
                }
            }
            (true, None, Some(_)) => {
                let dropped = knots.pop();
                knots.push(Knot { image: dropped.map_or(knot.image, |d| d.image), ..knot });
            }
            _ => knots.push(knot),
        }
    }
    let mut before = 0.0f64;
    for knot in knots {
        before = before.max(knot.image);
        knot.image = before;
    }
}

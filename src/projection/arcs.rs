//! A closed polygon divided into arcs by its length, and a place outside beside each.

use super::region::Region;
use crate::geometry::{DVec2, SimplePolygon};
use num_complex::Complex64;
use rayon::prelude::*;

/// The number of arcs before any is bisected.
const FIRST: usize = 48;

/// Rounds in which arcs without room for a pole are bisected at first, and the largest number of arcs with which one begins.
const ROOM_ROUNDS: u32 = 3;
const ROOM_ARCS: usize = 250;

/// Distances of poles that are tried, in lengths of the arc, and the number of directions.
const DISTANCES: [f64; 5] = [2.5, 1.5, 0.8, 0.4, 0.2];
const DIRECTIONS: usize = 12;

/// The least distance of a pole from the boundary, in its distance from the middle of its arc.
const CLEAR: f64 = 0.5;

/// The least distance of a pole from the boundary, in lengths of the arc there.
const SEEN: f64 = 0.5;

/// A part of the boundary, by length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    start: f64,
    length: f64,
}

/// A pole outside, with its distance from the boundary as its unit.
#[derive(Debug, Clone, Copy)]
pub struct Pole {
    pub at: Complex64,
    pub unit: f64,
}

/// The arcs of a polygon; all bisected ones are replaced by their halves.
#[derive(Debug, Clone)]
pub struct Arcs<'a> {
    polygon: &'a SimplePolygon,
    /// The length up to each vertex, and all of it at the end.
    lengths: Vec<f64>,
    /// By their places.
    leaves: Vec<Arc>,
    /// The leaves and all that were bisected.
    all: Vec<Arc>,
}

impl<'a> Arcs<'a> {
    /// [`FIRST`] arcs of equal length, or more where the region or the gaps beside it are narrow.
    pub fn new(region: &'a Region) -> Self {
        let mut arcs = Self::equal(region.polygon());
        for _ in 0..ROOM_ROUNDS {
            let is_narrow = |k: &usize| arcs.pole(&arcs.leaves[*k], region).is_none();
            let narrow: Vec<(usize, f64)> = (0..arcs.leaves.len()).filter(is_narrow).map(|k| (k, 0.5)).collect();
            if narrow.is_empty() || arcs.leaves.len() > ROOM_ARCS {
                break;
            }
            arcs.bisect(&narrow, 1);
        }
        arcs
    }

    fn equal(polygon: &'a SimplePolygon) -> Self {
        let mut lengths = vec![0.0];
        let mut sum = 0.0;
        for (a, b) in polygon.edges() {
            sum += a.distance(b);
            lengths.push(sum);
        }
        let length = sum / FIRST as f64;
        let leaves: Vec<Arc> = (0..FIRST).map(|k| Arc { start: k as f64 * length, length }).collect();
        Self { polygon, lengths, all: leaves.clone(), leaves }
    }

    /// The arcs that are not bisected.
    pub fn leaves(&self) -> &[Arc] {
        &self.leaves
    }

    /// Points of an arc, at the middles of `count` equal parts.
    pub fn points(&self, arc: &Arc, count: usize) -> impl Iterator<Item = DVec2> {
        let Arc { start, length } = *arc;
        (0..count).map(move |k| self.at(start + length * (k as f64 + 0.5) / count as f64))
    }

    /// The point at this length.
    fn at(&self, length: f64) -> DVec2 {
        let vertices = self.polygon.vertices();
        let n = vertices.len();
        let k = (self.lengths.partition_point(|&before| before <= length) - 1).min(n - 1);
        let share = (length - self.lengths[k]) / (self.lengths[k + 1] - self.lengths[k]);
        vertices[k].lerp(vertices[(k + 1) % n], share.min(1.0))
    }

    /// Bisects the chosen arcs, given with the shares at which they are worst, `times` times toward these.
    pub fn bisect(&mut self, chosen: &[(usize, f64)], times: u32) {
        for &(k, share) in chosen {
            let mut at = k;
            let worst = self.leaves[k].start + share * self.leaves[k].length;
            for _ in 0..times {
                let Arc { start, length } = self.leaves[at];
                let half = 0.5 * length;
                let [first, second] = [start, start + half].map(|start| Arc { start, length: half });
                self.leaves[at] = first;
                self.leaves.push(second);
                self.all.extend([first, second]);
                if worst > second.start {
                    at = self.leaves.len() - 1;
                }
            }
        }
        self.leaves.sort_by(|a, b| a.start.total_cmp(&b.start));
    }

    /// The poles beside all arcs, bisected or not.
    pub fn poles(&self, region: &Region) -> Vec<Pole> {
        self.all.par_iter().filter_map(|arc| self.pole(arc, region)).collect()
    }

    /// A pole outside beside an arc, as far from it as there is room up to a few of its lengths; `None` where there is
    /// none, and where the pole would be so near to another arc that the points there would not see it.
    fn pole(&self, arc: &Arc, region: &Region) -> Option<Pole> {
        let middle = self.at(arc.start + 0.5 * arc.length);
        for distance in DISTANCES.map(|factor| factor * arc.length) {
            let place = |k: usize| {
                let z = middle + distance * DVec2::from_angle(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
                (z, -region.signed_distance(z))
            };
            let (z, clearance) = (0..DIRECTIONS).map(place).max_by(|a, b| a.1.total_cmp(&b.1))?;
            if clearance >= CLEAR * distance && clearance >= SEEN * self.leaf_beside(z, region).length {
                return Some(Pole { at: Complex64::new(z.x, z.y), unit: clearance });
            }
        }
        None
    }

    /// The arc that is not bisected at the boundary point nearest to a point.
    fn leaf_beside(&self, z: DVec2, region: &Region) -> Arc {
        let nearest = region.nearest_point(z);
        let (before, after) = (self.lengths[nearest.edge], self.lengths[nearest.edge + 1]);
        let length = before + nearest.fraction * (after - before);
        let k = self.leaves.partition_point(|leaf| leaf.start <= length);
        self.leaves[k.max(1) - 1]
    }
}

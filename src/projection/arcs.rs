//! A closed polygon divided into arcs by its length, and a place outside beside each.

use super::potential::Pole;
use super::region::Region;
use crate::geometry::{DVec2, SimplePolygon};
use num_complex::Complex64;

/// The number of arcs before any is bisected.
const FIRST: usize = 48;

/// Distances of poles that are tried, in lengths of the arc, and the number of directions.
const DISTANCES: [f64; 5] = [2.5, 1.5, 0.8, 0.4, 0.2];
const DIRECTIONS: usize = 12;

/// The least distance of a pole from the boundary, in its distance from the middle of its arc.
const CLEAR: f64 = 0.5;

/// A part of the boundary, by length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    start: f64,
    length: f64,
}

/// The arcs of a polygon; all bisected ones are replaced by their halves.
#[derive(Debug, Clone)]
pub struct Arcs<'a> {
    polygon: &'a SimplePolygon,
    /// The length up to each vertex, and all of it at the end.
    lengths: Vec<f64>,
    leaves: Vec<Arc>,
}

impl<'a> Arcs<'a> {
    /// [`FIRST`] arcs of equal length.
    pub fn new(polygon: &'a SimplePolygon) -> Self {
        let mut lengths = vec![0.0];
        let mut sum = 0.0;
        for (a, b) in polygon.edges() {
            sum += a.distance(b);
            lengths.push(sum);
        }
        let length = sum / FIRST as f64;
        let leaves = (0..FIRST).map(|k| Arc { start: k as f64 * length, length }).collect();
        Self { polygon, lengths, leaves }
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

    /// Bisects arcs whose residual is larger than `limit`, the worst first and at most `most`; returns the halves.
    pub fn bisect(&mut self, residuals: &[f64], limit: f64, most: usize) -> Vec<Arc> {
        let mut chosen: Vec<usize> = (0..self.leaves.len()).filter(|&k| residuals[k] > limit).collect();
        chosen.sort_by(|&i, &j| residuals[j].total_cmp(&residuals[i]));
        chosen.truncate(most);
        let mut halves = Vec::with_capacity(2 * chosen.len());
        for k in chosen {
            let Arc { start, length } = self.leaves[k];
            let half = 0.5 * length;
            let [first, second] = [start, start + half].map(|start| Arc { start, length: half });
            self.leaves[k] = first;
            self.leaves.push(second);
            halves.extend([first, second]);
        }
        halves
    }

    /// A pole outside beside an arc, as far from it as there is room up to a few of its lengths; `None` where there is
    /// none.
    pub fn pole(&self, arc: &Arc, region: &Region) -> Option<Pole> {
        let middle = self.at(arc.start + 0.5 * arc.length);
        for distance in DISTANCES.map(|factor| factor * arc.length) {
            let place = |k: usize| {
                let z = middle + distance * DVec2::from_angle(std::f64::consts::TAU * k as f64 / DIRECTIONS as f64);
                (z, -region.signed_distance(z))
            };
            let (z, clearance) = (0..DIRECTIONS).map(place).max_by(|a, b| a.1.total_cmp(&b.1))?;
            if clearance >= CLEAR * distance {
                return Some(Pole { at: Complex64::new(z.x, z.y), unit: clearance });
            }
        }
        None
    }
}

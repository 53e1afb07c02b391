//! Interior points of the graded mesher, grown inward from the boundary.
//!
//! The local size is the boundary's edge length plus `growth` times the distance
//! from it. The first points are the apexes of nearly equilateral triangles on
//! the boundary edges; every accepted point proposes six neighbors at its own
//! size, 60° apart, and a proposal is accepted if no point is closer to it than
//! [`SEPARATION`] sizes. The points form layers along the boundary and are nearly
//! hexagonal except at the seams where the layers of opposite sides meet.
//! Guaranteed: points are strictly inside, and the same boundary gives the same points.
//! Cost O(n) for n points: a hashed grid with one level per power of two of the size.

use super::MeshError;
use super::hex_lattice::bounds;
use super::level_grid::LevelGrid;
use super::planar::check_count;
use crate::geometry::{DVec2, orientation};

/// The least distance between two points, in sizes. 1 would accept perfect
/// hexagons only and leave gaps where layers meet; at 0.6 the seams are crowded.
const SEPARATION: f64 = 0.72;

/// The height of the first layer's triangles over the edge, `√3/2` for equilateral ones.
const APEX: f64 = 0.88;

/// Between boundary points sizes grow by at most this per distance, even where
/// the edge lengths change suddenly.
const BOUNDARY_GROWTH: f64 = 0.5;

/// The next layer is `cos 30°` of an edge away, but proposals are made along edges.
const PATH_FACTOR: f64 = 0.93;

/// A rotation by 60°.
const SIXTH: DVec2 = DVec2::new(0.5, 0.866_025_403_784_438_6);

/// Interior points whose spacing is the boundary's plus `growth` times the distance to it.
pub(super) fn seeds(boundary: &[DVec2], growth: f64) -> Result<Vec<DVec2>, MeshError> {
    let mut front = Front::new(boundary, growth);
    let m = boundary.len();
    for k in 0..m {
        let (a, b) = (boundary[k], boundary[(k + 1) % m]);
        let size = 0.5 * (front.grid.size(k as u32) + front.grid.size(((k + 1) % m) as u32));
        let apex = 0.5 * (a + b) + (b - a).normalize_or_zero().perp() * (APEX * size.min(a.distance(b)));
        front.propose(apex, size * (1.0 + APEX * growth), (b - a).normalize_or(DVec2::X));
    }
    let mut next = 0;
    while next < front.directions.len() {
        front.grow(next);
        next += 1;
        check_count(front.directions.len() as f64)?;
    }
    Ok(front.grid.positions()[front.fixed..].to_vec())
}

struct Front<'a> {
    boundary: &'a [DVec2],
    slabs: Slabs,
    grid: LevelGrid,
    /// The number of boundary points, which come first in the grid.
    fixed: usize,
    /// A corner of the hexagon around each interior point.
    directions: Vec<DVec2>,
    growth: f64,
}

impl<'a> Front<'a> {
    fn new(boundary: &'a [DVec2], growth: f64) -> Self {
        let sizes = boundary_sizes(boundary);
        let mut grid = LevelGrid::default();
        boundary.iter().zip(&sizes).for_each(|(&p, &size)| grid.insert(p, size));
        let m = boundary.len();
        for k in 0..m {
            let next = (k + 1) % m;
            block_edge(&mut grid, [boundary[k], boundary[next]], [sizes[k], sizes[next]]);
        }
        let fixed = grid.positions().len();
        Self { boundary, slabs: Slabs::new(boundary), grid, fixed, directions: Vec::new(), growth }
    }

    /// Proposes the six neighbors of interior point `k`.
    fn grow(&mut self, k: usize) {
        let id = (self.fixed + k) as u32;
        let (centre, size) = (self.grid.positions()[id as usize], self.grid.size(id));
        let mut direction = self.directions[k];
        for _ in 0..6 {
            self.propose(centre + size * direction, size * (1.0 + PATH_FACTOR * self.growth), direction);
            direction = SIXTH.rotate(direction);
        }
    }

    fn propose(&mut self, p: DVec2, size: f64, direction: DVec2) {
        let growth = self.growth;
        let mut local = size;
        let near = self.grid.any_within(p, size, |distance, other| {
            local = local.min(other + growth * distance);
            distance < SEPARATION * 0.5 * (local + other)
        });
        if !near && self.slabs.contains(self.boundary, p) {
            self.grid.insert(p, local);
            self.directions.push(direction);
        }
    }
}

/// The geometric mean of the two edges at each vertex, with the growth along the boundary limited.
fn boundary_sizes(boundary: &[DVec2]) -> Vec<f64> {
    let m = boundary.len();
    let edge = |k: usize| boundary[k % m].distance(boundary[(k + 1) % m]);
    let mut sizes: Vec<f64> = (0..m).map(|k| (edge(k) * edge(k + m - 1)).sqrt()).collect();
    for k in 1..2 * m {
        sizes[k % m] = sizes[k % m].min(sizes[(k - 1) % m] + BOUNDARY_GROWTH * edge(k - 1));
    }
    for k in (0..2 * m - 1).rev() {
        sizes[k % m] = sizes[k % m].min(sizes[(k + 1) % m] + BOUNDARY_GROWTH * edge(k));
    }
    sizes
}

/// Inserts points along an edge that is much longer than the sizes at its ends,
/// so that no proposal next to the edge or beyond it is accepted.
fn block_edge(grid: &mut LevelGrid, [a, b]: [DVec2; 2], [from, to]: [f64; 2]) {
    let length = a.distance(b);
    let size = |t: f64| (from + BOUNDARY_GROWTH * t).min(to + BOUNDARY_GROWTH * (length - t));
    let mut t = size(0.0);
    while t + 0.5 * size(t) < length {
        grid.insert(a.lerp(b, t / length), size(t));
        t += size(t);
    }
}

/// Boundary edges by horizontal slab, for inside tests.
struct Slabs {
    low: f64,
    per_height: f64,
    /// `edges[start[k] .. start[k+1]]` meet slab `k`.
    start: Vec<u32>,
    edges: Vec<u32>,
}

impl Slabs {
    fn new(boundary: &[DVec2]) -> Self {
        let (low, high) = bounds(boundary);
        let (m, height) = (boundary.len(), high.y - low.y);
        let rises: f64 = (0..m).map(|k| (boundary[(k + 1) % m].y - boundary[k].y).abs()).sum();
        // an edge is listed in one slab and in one more for every slab it crosses: 32 m entries in all
        let fitting = (31.0 * m as f64 * height / rises) as usize;
        let count = m.min(fitting).clamp(16, 4096);
        let mut slabs =
            Self { low: low.y, per_height: count as f64 / height, start: vec![0; count + 2], edges: Vec::new() };
        let ranges: Vec<_> = (0..m).map(|k| slabs.range(boundary[k].y, boundary[(k + 1) % m].y)).collect();
        for range in &ranges {
            range.clone().for_each(|s| slabs.start[s + 2] += 1);
        }
        (2..slabs.start.len()).for_each(|s| slabs.start[s] += slabs.start[s - 1]);
        slabs.edges = vec![0; slabs.start[count + 1] as usize];
        for (k, range) in ranges.into_iter().enumerate() {
            for s in range {
                slabs.edges[slabs.start[s + 1] as usize] = k as u32;
                slabs.start[s + 1] += 1;
            }
        }
        slabs
    }

    fn slab(&self, y: f64) -> usize {
        (((y - self.low) * self.per_height).max(0.0) as usize).min(self.start.len() - 3)
    }

    fn range(&self, y0: f64, y1: f64) -> std::ops::Range<usize> {
        self.slab(y0.min(y1))..self.slab(y0.max(y1)) + 1
    }

    /// Whether `p` is strictly inside, exactly.
    fn contains(&self, boundary: &[DVec2], p: DVec2) -> bool {
        let slab = self.slab(p.y);
        let mut inside = false;
        for &k in &self.edges[self.start[slab] as usize..self.start[slab + 1] as usize] {
            let (a, b) = (boundary[k as usize], boundary[(k as usize + 1) % boundary.len()]);
            if (a.y <= p.y) != (b.y <= p.y) {
                let side = orientation(a, b, p);
                if side == 0.0 {
                    return false;
                }
                inside ^= (side > 0.0) == (a.y < b.y);
            }
        }
        inside
    }
}

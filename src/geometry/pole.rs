//! The pole of inaccessibility: the interior point farthest from the boundary.
//!
//! Best-first search over a quadtree, as in Agafonkin's polylabel: a cell of
//! half-width h whose center has signed distance d contains no point farther inside than
//! d + h√2. The starting points come from scan lines, so that slivers, where
//! the quadtree would need very many cells, have an interior point at once.

use super::sorting::sort_by_number;
use std::collections::BinaryHeap;
use std::f64::consts::SQRT_2;

use glam::DVec2;

use super::SimplePolygon;
use super::edge_tree::EdgeTree;

/// Cells examined at most, about 1 µs each. Compact shapes need below 300 at
/// 1/1000 of the extent; the spiral, an even corridor, needs more than 20,000.
const MAX_CELLS: usize = 2_400;

/// Tolerances are raised to this fraction of the extent.
const FINEST: f64 = 1e-9;

struct Cell {
    center: DVec2,
    half_width: f64,
    distance: f64,
}

impl Cell {
    fn new(center: DVec2, half_width: f64, tree: &EdgeTree<&[DVec2]>) -> Self {
        Self { center, half_width, distance: tree.signed_distance(center) }
    }

    /// Upper bound of the signed distance over the cell: d + h√2.
    fn reach(&self) -> f64 {
        self.distance + self.half_width * SQRT_2
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.reach().total_cmp(&other.reach())
    }
}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}

pub(super) fn pole_of_inaccessibility(polygon: &SimplePolygon, tolerance: f64) -> DVec2 {
    let tree = EdgeTree::new(polygon.vertices());
    let bounds = tree.bounds();
    let extent = bounds.size().max_element();
    let tolerance = tolerance.max(FINEST * extent);

    let mut best = start(polygon, &tree);
    let mut queue = BinaryHeap::from([Cell::new(bounds.center(), 0.5 * extent, &tree)]);
    for _ in 0..MAX_CELLS / 4 {
        let Some(cell) = queue.pop() else { break };
        if cell.distance > best.1 {
            best = (cell.center, cell.distance);
        }
        if cell.reach() - best.1 <= tolerance {
            break;
        }
        let h = 0.5 * cell.half_width;
        for offset in [DVec2::new(-h, -h), DVec2::new(h, -h), DVec2::new(-h, h), DVec2::new(h, h)] {
            let child = Cell::new(cell.center + offset, h, &tree);
            if child.distance > best.1 {
                best = (child.center, child.distance);
            }
            if child.reach() - best.1 > tolerance {
                queue.push(child);
            }
        }
    }
    climb(&tree, best, tolerance)
}

/// Compass search for a greater distance: moves the best point of a corridor, where the
/// cells ran out, onto its center line.
fn climb(tree: &EdgeTree<&[DVec2]>, (mut point, mut distance): (DVec2, f64), tolerance: f64) -> DVec2 {
    let mut step = 0.25 * distance;
    // Each halving allows a few moves; the bound only guards against very slow convergence.
    for _ in 0..200 {
        if step < 0.5 * tolerance {
            break;
        }
        let moved = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|d| point + step * d);
        let measured = moved.map(|p| (p, tree.signed_distance(p)));
        match measured.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((p, d)) if d > distance => (point, distance) = (p, d),
            _ => step *= 0.5,
        }
    }
    point
}

/// A point strictly inside, with its distance: of the midpoints of the widest interior
/// intervals on a few scan lines, the one farthest from the boundary.
fn start(polygon: &SimplePolygon, tree: &EdgeTree<&[DVec2]>) -> (DVec2, f64) {
    let bounds = tree.bounds();
    let evenly = (0..8).map(|k| bounds.min().y + bounds.size().y * (f64::from(k) + 0.5) / 8.0);
    let best = best_middle(polygon, tree, evenly);
    if best.1 > 0.0 {
        return best;
    }
    let mut heights: Vec<f64> = polygon.vertices().iter().map(|p| p.y).collect();
    heights.sort_unstable_by(f64::total_cmp);
    heights.dedup();
    let mut gaps: Vec<(f64, f64)> = heights.windows(2).map(|w| (w[1] - w[0], w[0].midpoint(w[1]))).collect();
    sort_by_number(&mut gaps, |gap| -gap.0);
    best_middle(polygon, tree, gaps.into_iter().take(64).map(|(_, y)| y))
}

fn best_middle(polygon: &SimplePolygon, tree: &EdgeTree<&[DVec2]>, heights: impl Iterator<Item = f64>) -> (DVec2, f64) {
    let middles = heights.filter_map(|y| widest_middle(polygon, y)).map(|p| (p, tree.signed_distance(p)));
    middles.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((tree.bounds().center(), f64::NEG_INFINITY))
}

/// The midpoint of the widest interior interval at height `y`.
fn widest_middle(polygon: &SimplePolygon, y: f64) -> Option<DVec2> {
    let crossed = polygon.edges().filter(|(a, b)| (a.y > y) != (b.y > y));
    let mut xs: Vec<f64> = crossed.map(|(a, b)| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y))).collect();
    xs.sort_unstable_by(f64::total_cmp);
    let widest = xs.as_chunks::<2>().0.iter().max_by(|[a, b], [c, d]| (b - a).total_cmp(&(d - c)))?;
    Some(DVec2::new(widest[0].midpoint(widest[1]), y))
}

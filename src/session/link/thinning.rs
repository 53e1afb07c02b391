//! Which vertices of a polygon can go: Visvalingam and Whyatt's order, "Line generalisation by repeated elimination of
//! points" (1993), with the check that keeps the polygon simple.
//!
//! A vertex is removed only if the triangle with its neighbors contains no other vertex. The new edge then meets no
//! other edge: one that enters the triangle would have to end in it or cross the two old edges. So every prefix of the
//! order leaves a simple polygon with the same orientation. The order does not depend on how many vertices are removed.

use crate::geometry::{Bounds, DVec2, orientation};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The number of vertices that always remain.
const LEAST_POINTS: usize = 48;
/// The most cells of the grid along an axis.
const MOST_CELLS: f64 = 512.0;

/// For each vertex of a simple polygon the level at which it is removed, ∞ if never: those with a level above `t` form a
/// simple polygon, for every `t`. The level is the area of the triangle that is cut off, over that of the bounding box,
/// or the level of a vertex that had to go before. Vertices in `kept` never go. Cost O(n log n) for outlines whose
/// points are spread along them.
pub(super) fn levels(points: &[DVec2], kept: &[usize]) -> Vec<f64> {
    let mut thinning = Thinning::new(points, kept);
    let mut level: f64 = 0.0;
    let mut blocked = Vec::new();
    while thinning.remaining > LEAST_POINTS {
        let Some(Reverse((Area(area), k, version))) = thinning.queue.pop() else {
            // those that were in the way may have gone since
            if !thinning.take_up(&mut blocked) {
                break;
            }
            continue;
        };
        if thinning.version[k] != version {
            continue; // its neighbors have changed, and it is in the queue again
        }
        if thinning.is_blocked(k) {
            blocked.push(k);
            continue;
        }
        level = level.max(area);
        thinning.levels[k] = level;
        thinning.remove(k);
    }
    thinning.levels
}

/// An area by which vertices are ordered.
#[derive(PartialEq)]
struct Area(f64);

impl Eq for Area {}

impl PartialOrd for Area {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Area {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

struct Thinning<'a> {
    points: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
    /// Counts the changes of a vertex's neighbors.
    version: Vec<u32>,
    stays: Vec<bool>,
    levels: Vec<f64>,
    queue: BinaryHeap<Reverse<(Area, usize, u32)>>,
    grid: Grid,
    /// The area of the bounding box.
    whole: f64,
    remaining: usize,
    /// The number of vertices when blocked ones were taken up last.
    taken_up_at: usize,
}

impl<'a> Thinning<'a> {
    fn new(points: &'a [DVec2], kept: &[usize]) -> Self {
        let count = points.len();
        let bounds = Bounds::of(points.iter().copied());
        let mut stays = vec![false; count];
        for &k in kept {
            stays[k] = true;
        }
        let mut thinning = Self {
            points,
            before: (0..count).map(|k| (k + count - 1) % count).collect(),
            after: (0..count).map(|k| (k + 1) % count).collect(),
            version: vec![0; count],
            stays,
            levels: vec![f64::INFINITY; count],
            queue: BinaryHeap::with_capacity(count),
            grid: Grid::new(points, bounds),
            whole: bounds.size().x * bounds.size().y,
            remaining: count,
            taken_up_at: usize::MAX,
        };
        (0..count).for_each(|k| thinning.enqueue(k));
        thinning
    }

    fn corners(&self, k: usize) -> [DVec2; 3] {
        [self.before[k], k, self.after[k]].map(|k| self.points[k])
    }

    fn enqueue(&mut self, k: usize) {
        if !self.stays[k] {
            let [a, b, c] = self.corners(k);
            let area = 0.5 * orientation(a, b, c).abs() / self.whole;
            self.queue.push(Reverse((Area(area), k, self.version[k])));
        }
    }

    fn is_blocked(&self, k: usize) -> bool {
        let corners = self.corners(k);
        let own = [self.before[k], k, self.after[k]];
        self.grid.any_near(corners, |j| !own.contains(&j) && contains(corners, self.points[j]))
    }

    fn remove(&mut self, k: usize) {
        let (before, after) = (self.before[k], self.after[k]);
        (self.after[before], self.before[after]) = (after, before);
        self.grid.remove(k, self.points[k]);
        self.stays[k] = true;
        self.remaining -= 1;
        for k in [before, after] {
            self.version[k] += 1;
            self.enqueue(k);
        }
    }

    /// Puts blocked vertices into the queue again; returns whether any vertex has been removed since the last time.
    fn take_up(&mut self, blocked: &mut Vec<usize>) -> bool {
        let is_progress = self.remaining < self.taken_up_at && !blocked.is_empty();
        self.taken_up_at = self.remaining;
        for k in std::mem::take(blocked) {
            self.version[k] += 1;
            self.enqueue(k);
        }
        is_progress
    }
}

/// Whether a closed triangle contains a point, exactly.
fn contains([a, b, c]: [DVec2; 3], p: DVec2) -> bool {
    let in_box = a.min(b).min(c).cmple(p).all() && p.cmple(a.max(b).max(c)).all();
    let turns = || [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
    in_box && {
        let turns = turns();
        turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
    }
}

/// The remaining vertices by the cells of a grid over the bounding box.
struct Grid {
    low: DVec2,
    scale: DVec2,
    across: usize,
    cells: Vec<Vec<u32>>,
}

impl Grid {
    fn new(points: &[DVec2], bounds: Bounds) -> Self {
        let across = (points.len() as f64).sqrt().clamp(1.0, MOST_CELLS) as usize;
        let scale = across as f64 / bounds.size();
        let mut grid = Self { low: bounds.min(), scale, across, cells: vec![Vec::new(); across * across] };
        for (k, &p) in points.iter().enumerate() {
            let [x, y] = grid.cell(p);
            grid.cells[y * across + x].push(k as u32);
        }
        grid
    }

    fn cell(&self, p: DVec2) -> [usize; 2] {
        ((p - self.low) * self.scale).to_array().map(|place| (place as usize).min(self.across - 1))
    }

    fn remove(&mut self, k: usize, p: DVec2) {
        let [x, y] = self.cell(p);
        self.cells[y * self.across + x].retain(|&known| known as usize != k);
    }

    /// Whether a vertex in a cell that the triangle's box meets satisfies `is`.
    fn any_near(&self, [a, b, c]: [DVec2; 3], is: impl Fn(usize) -> bool) -> bool {
        let ([left, low], [right, high]) = (self.cell(a.min(b).min(c)), self.cell(a.max(b).max(c)));
        (low..=high).any(|y| {
            let row = &self.cells[y * self.across + left..=y * self.across + right];
            row.iter().flatten().any(|&k| is(k as usize))
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::SimplePolygon;
    use crate::outline::Preset;

    fn above(points: &[DVec2], levels: &[f64], t: f64) -> Vec<DVec2> {
        points.iter().zip(levels).filter(|(_, level)| **level > t).map(|(p, _)| *p).collect()
    }

    /// A comb of long thin teeth with rough flanks: most removals would cross another flank.
    fn comb(teeth: u32) -> Vec<DVec2> {
        let rough = |k: u32| f64::from(k * 7919 % 101) / 101.0;
        let mut points = Vec::new();
        for tooth in 0..teeth {
            let x = f64::from(tooth);
            points.extend((0..60).map(|k| DVec2::new(x + 0.3 * rough(k + tooth), 0.5 + 0.5 * f64::from(k))));
            points.extend((0..60).map(|k| DVec2::new(x + 0.45 + 0.3 * rough(k), 30.0 - 0.5 * f64::from(k))));
        }
        points.extend([DVec2::new(f64::from(teeth), -1.0), DVec2::new(-1.0, -1.0)]);
        points
    }

    #[test]
    fn every_level_leaves_a_simple_polygon_with_the_same_orientation() {
        for points in [Preset::Turkey, Preset::Spiral, Preset::Gingerbread]
            .map(|preset| preset.outline().into_polygon().vertices().to_vec())
            .into_iter()
            .chain([comb(12)])
        {
            let clockwise = SimplePolygon::try_from(points.clone()).unwrap().was_clockwise();
            let levels = levels(&points, &[0]);
            let mut all: Vec<f64> = levels.iter().copied().filter(|level| level.is_finite()).collect();
            all.sort_by(f64::total_cmp);
            assert!(all.len() + 200 > points.len(), "{} of {} can go", all.len(), points.len());
            for k in (0..20).map(|k| (all.len() - 1) * k / 19) {
                let rest = above(&points, &levels, all[k]);
                let polygon = SimplePolygon::try_from(rest.clone()).unwrap();
                assert!(
                    polygon.was_clockwise() == clockwise && rest[0] == points[0],
                    "{} of {}",
                    rest.len(),
                    points.len()
                );
            }
        }
    }

    #[test]
    fn points_on_straight_edges_go_first() {
        let edge = |from: DVec2, to: DVec2| (0..100).map(move |k| from.lerp(to, f64::from(k) / 100.0));
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
        let square: Vec<DVec2> = (0..4).flat_map(|k| edge(corners[k], corners[(k + 1) % 4])).collect();
        let levels = levels(&square, &[]);
        for k in [0, 100, 200, 300] {
            assert!(levels[k] > 1e-6, "a corner");
        }
        assert!(levels.iter().filter(|level| **level < 1e-12).count() >= 400 - LEAST_POINTS);
    }
}

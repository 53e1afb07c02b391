//! Signed distance to a closed chain, and its nearest point, in O(log k) for usual shapes.
//!
//! A tree of boxes over runs of consecutive edges, four to one at each level. For
//! a box wholly to the right of a point, the parity of its run's crossings follows from the run's
//! two ends alone, so the side test costs no more than the distance; it is exact.
//!
//! Published trees answer half of that: `kiddo` knows points, not segments; `rstar` knows segments and finds
//! the nearest one, but the side would need a second search. Runs of a chain also need no sorting.

use glam::DVec2;

use super::Bounds;
use super::predicates::orientation;

const LEAF: usize = 8;
const FAN: usize = 4;

/// Boxes over the edges of a closed chain, borrowed (`&[DVec2]`) or owned (`Vec<DVec2>`).
#[derive(Debug, Clone)]
pub struct EdgeTree<P> {
    points: P,
    /// `levels[0]` bounds runs of [`LEAF`] edges; the last level is one box.
    levels: Vec<Vec<Bounds>>,
}

/// The point of a closed chain nearest to some other point: `(1 − fraction) v_edge + fraction v_{edge+1}`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NearestPoint {
    /// Index of the edge, from `v_edge` to `v_{edge+1}`.
    pub edge: usize,
    /// The position on the edge, in `[0, 1]`.
    pub fraction: f64,
    /// The distance from the given point to this one.
    pub distance: f64,
}

/// The nearest edge found so far.
struct Nearest {
    squared: f64,
    edge: usize,
}

#[derive(Clone, Copy)]
struct Node {
    level: usize,
    index: usize,
}

impl<P: AsRef<[DVec2]>> EdgeTree<P> {
    /// Builds the tree over the edges `(v_k, v_{k+1})`, cyclic; `points` must not be empty. Cost O(k).
    pub fn new(points: P) -> Self {
        let chain = points.as_ref();
        let n = chain.len();
        let run = |start: usize| Bounds::of((start..=(start + LEAF).min(n)).map(|k| chain[k % n]));
        let mut levels = vec![(0..n).step_by(LEAF).map(run).collect::<Vec<_>>()];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let merged = below.chunks(FAN).map(|c| Bounds::of(c.iter().flat_map(|b| [b.min(), b.max()]))).collect();
            levels.push(merged);
        }
        Self { points, levels }
    }

    /// The vertices.
    pub fn points(&self) -> &[DVec2] {
        self.points.as_ref()
    }

    /// The smallest box around the chain.
    pub fn bounds(&self) -> Bounds {
        self.bounds_of(self.root())
    }

    /// The distance from `p` to the chain: positive strictly inside, zero or negative elsewhere.
    pub fn signed_distance(&self, p: DVec2) -> f64 {
        let distance = self.nearest_edge(p).squared.sqrt();
        if self.winds_around(self.root(), p) { distance } else { -distance }
    }

    /// The point of the chain nearest to `p`.
    pub fn nearest_point(&self, p: DVec2) -> NearestPoint {
        let Nearest { squared, edge } = self.nearest_edge(p);
        let fraction = nearest_fraction(self.point(edge), self.point(edge + 1), p);
        NearestPoint { edge, fraction, distance: squared.sqrt() }
    }

    fn nearest_edge(&self, p: DVec2) -> Nearest {
        let mut best = Nearest { squared: f64::INFINITY, edge: 0 };
        self.nearest(self.root(), p, &mut best);
        best
    }

    fn root(&self) -> Node {
        Node { level: self.levels.len() - 1, index: 0 }
    }

    fn bounds_of(&self, node: Node) -> Bounds {
        self.levels[node.level][node.index]
    }

    /// The edges of a node, as indices.
    fn edges(&self, node: Node) -> std::ops::Range<usize> {
        let length = LEAF * FAN.pow(node.level as u32);
        node.index * length..((node.index + 1) * length).min(self.points().len())
    }

    fn children(&self, node: Node) -> impl Iterator<Item = Node> + use<P> {
        let level = node.level - 1;
        let end = ((node.index + 1) * FAN).min(self.levels[level].len());
        (node.index * FAN..end).map(move |index| Node { level, index })
    }

    fn point(&self, k: usize) -> DVec2 {
        let points = self.points();
        points[if k == points.len() { 0 } else { k }]
    }

    fn nearest(&self, node: Node, p: DVec2, best: &mut Nearest) {
        if node.level == 0 {
            for edge in self.edges(node) {
                let squared = squared_distance(self.point(edge), self.point(edge + 1), p);
                if squared < best.squared {
                    *best = Nearest { squared, edge };
                }
            }
            return;
        }
        let mut queue = [(f64::INFINITY, node); FAN];
        for (slot, child) in queue.iter_mut().zip(self.children(node)) {
            let b = self.bounds_of(child);
            *slot = (p.clamp(b.min(), b.max()).distance_squared(p), child);
        }
        queue.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        for (lower_bound, child) in queue {
            if lower_bound < best.squared {
                self.nearest(child, p, best);
            }
        }
    }

    /// Whether the run crosses the ray from `p` to the right an odd number of times.
    fn winds_around(&self, node: Node, p: DVec2) -> bool {
        let b = self.bounds_of(node);
        if b.max().y <= p.y || b.min().y > p.y || b.max().x < p.x {
            return false;
        }
        let above = |k: usize| self.point(k).y > p.y;
        let edges = self.edges(node);
        if b.min().x > p.x {
            return above(edges.start) != above(edges.end);
        }
        if node.level > 0 {
            return self.children(node).fold(false, |odd, child| odd ^ self.winds_around(child, p));
        }
        edges.fold(false, |odd, k| {
            let crossed =
                above(k) != above(k + 1) && (orientation(self.point(k), self.point(k + 1), p) > 0.0) == above(k + 1);
            odd ^ crossed
        })
    }
}

fn squared_distance(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    (a + nearest_fraction(a, b, p) * (b - a)).distance_squared(p)
}

/// Where on the segment from `a` to `b` the point nearest to `p` lies.
fn nearest_fraction(a: DVec2, b: DVec2, p: DVec2) -> f64 {
    let d = b - a;
    ((p - a).dot(d) / d.length_squared()).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signed_distance_agrees_with_the_direct_sum_over_all_edges() {
        let n = 997;
        let points: Vec<DVec2> = (0..n)
            .map(|k| {
                let t = std::f64::consts::TAU * f64::from(k) / f64::from(n);
                (1.0 + 0.6 * (9.0 * t).cos()) * DVec2::from_angle(t)
            })
            .collect();
        let tree = EdgeTree::new(points.as_slice());
        for i in -12..=12 {
            for j in -12..=12 {
                let p = DVec2::new(f64::from(i), f64::from(j)) / 7.0;
                let inside = p.length() < 1.0 + 0.6 * (9.0 * p.to_angle()).cos();
                let direct = (0..points.len())
                    .map(|k| squared_distance(points[k], points[(k + 1) % points.len()], p))
                    .fold(f64::INFINITY, f64::min)
                    .sqrt();
                let expected = if inside { direct } else { -direct };
                assert!(direct < 1e-4 || tree.signed_distance(p) == expected, "p = {p}");
                let nearest = tree.nearest_point(p);
                let (a, b) = (points[nearest.edge], points[(nearest.edge + 1) % points.len()]);
                let found = (a + nearest.fraction * (b - a)).distance(p);
                assert!(nearest.distance == direct && found == direct, "p = {p}: {nearest:?}");
            }
        }
    }
}

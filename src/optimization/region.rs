//! A region of the source: polygons in the plane, and strokes of a brush in the plane or in space.
//!
//! Dabs are found by a tree of boxes: thousands of them, asked four times for every triangle of a mesh, cost a few
//! milliseconds in all.

use crate::geometry::{DVec2, DVec3, SimplePolygon};

/// The most dabs of a brush in one region.
pub const MOST_DABS: usize = 4096;

/// The most polygons in one region.
pub const MOST_POLYGONS: usize = 1024;

/// One dab of a brush: a disk in the plane (z = 0), or the part of a surface within a distance in space.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Dab {
    /// Its middle; in the plane z = 0.
    pub middle: DVec3,
    /// Its radius, > 0.
    pub radius: f64,
}

impl Dab {
    /// The dab with numbers rounded to 32 bits, as links hold them.
    #[must_use]
    pub fn rounded(self) -> Self {
        Self { middle: self.middle.as_vec3().as_dvec3(), radius: f64::from(self.radius as f32) }
    }
}

/// Dabs of a leaf of the tree.
const LEAF: usize = 4;

/// The union of polygons and dabs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Region {
    /// Each with the corners of its box.
    polygons: Vec<(SimplePolygon, [DVec2; 2])>,
    dabs: Vec<Dab>,
    tree: Tree,
}

/// Dabs, and the boxes of their halves, of the halves of those, and so on.
#[derive(Debug, Clone, PartialEq, Default)]
struct Tree {
    sorted: Vec<Dab>,
    /// Corners; the box of a node is followed by those within its first half, then by those within its second.
    boxes: Vec<[DVec3; 2]>,
}

impl Tree {
    fn new(dabs: &[Dab]) -> Self {
        let mut tree = Self { sorted: dabs.to_vec(), boxes: Vec::new() };
        if !dabs.is_empty() {
            tree.divide(0, dabs.len());
        }
        tree
    }

    fn divide(&mut self, from: usize, to: usize) {
        let dabs = &mut self.sorted[from..to];
        let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = dabs
            .iter()
            .fold(ends, |(low, high), dab| (low.min(dab.middle - dab.radius), high.max(dab.middle + dab.radius)));
        self.boxes.push([low, high]);
        if dabs.len() > LEAF {
            let size = high - low;
            let axis = (0..3).max_by(|&i, &j| size[i].total_cmp(&size[j])).unwrap_or(0);
            dabs.sort_by(|a, b| a.middle[axis].total_cmp(&b.middle[axis]));
            let half = usize::midpoint(from, to);
            self.divide(from, half);
            self.divide(half, to);
        }
    }

    fn contains(&self, place: DVec3) -> bool {
        !self.sorted.is_empty() && self.contains_within(place, 0, [0, self.sorted.len()]).0
    }

    /// Whether a dab of a node contains a place, and the next node after it and all within.
    fn contains_within(&self, place: DVec3, node: usize, [from, to]: [usize; 2]) -> (bool, usize) {
        let [low, high] = self.boxes[node];
        if !(place.cmpge(low) & place.cmple(high)).all() {
            return (false, node + nodes(to - from));
        }
        if to - from <= LEAF {
            let painted = |dab: &Dab| dab.middle.distance_squared(place) <= dab.radius * dab.radius;
            return (self.sorted[from..to].iter().any(painted), node + 1);
        }
        let half = usize::midpoint(from, to);
        match self.contains_within(place, node + 1, [from, half]) {
            (true, next) => (true, next),
            (false, next) => self.contains_within(place, next, [half, to]),
        }
    }
}

/// Nodes of a tree of this many dabs: those of the halves, which differ by one at most, and one.
fn nodes(count: usize) -> usize {
    if count <= LEAF { 1 } else { 1 + nodes(count / 2) + nodes(count - count / 2) }
}

impl Region {
    /// The union of polygons in the plane.
    pub fn of_polygons(polygons: Vec<SimplePolygon>) -> Self {
        let with_box = |polygon: SimplePolygon| {
            let ends = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            let (low, high) = polygon.vertices().iter().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
            (polygon, [low, high])
        };
        Self { polygons: polygons.into_iter().map(with_box).collect(), ..Self::default() }
    }

    /// The union of dabs.
    pub fn of_dabs(dabs: Vec<Dab>) -> Self {
        Self { polygons: Vec::new(), tree: Tree::new(&dabs), dabs }
    }

    /// The dabs, in the order in which they were given.
    pub fn dabs(&self) -> &[Dab] {
        &self.dabs
    }

    /// Whether nothing was painted.
    pub fn is_empty(&self) -> bool {
        self.polygons.is_empty() && self.dabs.is_empty()
    }

    /// Whether a place of the source lies inside; the plane lies at z = 0, and polygons hold nothing else.
    pub fn contains(&self, place: DVec3) -> bool {
        let at = place.truncate();
        let inside = |(polygon, [low, high]): &(SimplePolygon, [DVec2; 2])| {
            (at.cmpge(*low) & at.cmple(*high)).all() && polygon.contains(at)
        };
        self.tree.contains(place) || (place.z == 0.0 && self.polygons.iter().any(inside))
    }

    /// The share of a triangle that lies inside, in quarters: by its middle and the points half way to its corners.
    pub fn share(&self, corners: [DVec3; 3]) -> f64 {
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let places = [middle, 0.5 * (middle + corners[0]), 0.5 * (middle + corners[1]), 0.5 * (middle + corners[2])];
        0.25 * places.into_iter().filter(|&place| self.contains(place)).count() as f64
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;

    #[test]
    fn a_place_is_inside_of_a_polygon_or_of_a_dab() {
        let square = SimplePolygon::try_from(vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]).unwrap();
        let far = Preset::Heart.outline().polygon().clone();
        let polygons = Region::of_polygons(vec![square, far]);
        let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        assert!(polygons.contains(at(0.5, 0.99, 0.0)) && !polygons.contains(at(0.5, 0.99, 0.1)));
        let dabs = Region::of_dabs(vec![Dab { middle: at(1.0, 2.0, 3.0), radius: 0.5 }]);
        assert!(dabs.contains(at(1.0, 2.0, 3.49)) && !dabs.contains(at(1.0, 2.0, 3.51)));
        assert!(Region::default().is_empty() && !dabs.is_empty());
    }

    /// Dabs of two radii on a curve in space, many of them at the same places.
    #[test]
    fn the_tree_finds_the_dabs_that_contain_a_place() {
        let dab = |k: u32| {
            let t = f64::from(k % 300) / 40.0;
            Dab {
                middle: DVec3::new(t.cos(), (2.0 * t).sin(), 0.3 * t),
                radius: if k.is_multiple_of(7) { 0.2 } else { 0.05 },
            }
        };
        for count in [1, 4, 5, 6, 11, 500] {
            let dabs: Vec<Dab> = (0..count).map(dab).collect();
            let region = Region::of_dabs(dabs.clone());
            assert_eq!(region.tree.boxes.len(), nodes(dabs.len()), "{count} dabs");
            let mut inside = 0;
            for k in 0..4000 {
                let t = f64::from(k) * 0.618;
                let place = DVec3::new(1.2 * t.sin(), 1.2 * (3.1 * t).cos(), (0.7 * t).rem_euclid(2.5));
                let expected = dabs.iter().any(|dab| dab.middle.distance(place) <= dab.radius);
                assert_eq!(region.contains(place), expected, "{place} among {count}");
                inside += usize::from(expected);
            }
            assert!(count < 500 || inside > 20, "{inside} places are inside");
            assert!(dabs.iter().all(|dab| region.contains(dab.middle)));
        }
    }

    #[test]
    fn the_share_of_a_triangle_is_in_quarters() {
        let dab = |radius: f64| Region::of_dabs(vec![Dab { middle: DVec3::ZERO, radius }]);
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let shares = [0.01, 0.3, 0.5, 2.0].map(|radius| dab(radius).share(corners));
        assert_eq!(shares, [0.0, 0.25, 0.5, 1.0]);
    }
}

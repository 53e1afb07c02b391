//! Random walks from x to the boundary: the probabilistic form of harmonic measure (Kakutani 1944).
//!
//! Brownian motion leaves a disk about its start at a uniformly distributed point. So
//! the walk on spheres (M. E. Muller, Ann. Math. Statist. 27, 1956) jumps from the
//! center of the largest circle inside the domain to a random point of that circle, repeatedly,
//! and stops close to the boundary. The nearest boundary point is the hit.
//!
//! A walk takes O(log 1/ε) jumps on average, each O(log m). It always terminates: after
//! [`MAX_JUMPS`] the nearest boundary point is taken, however far it is. The same
//! seed gives the same walks.

use crate::geometry::{DVec2, EdgeTree};
use crate::outline::BoundaryPoint;
use std::f64::consts::TAU;

/// A walk stops where the distance to the boundary is below this fraction of the extent (the larger
/// side of the bounding box). The distribution of the hits then has an error of about that size: 100
/// times less than the noise of 10⁶ walks.
pub const WALK_STOP: f64 = 1e-5;

/// The largest number of jumps of a walk. On the presets, from their poles, the mean is 13 to 18 (1 from
/// the disk's center) and the longest of 5000 walks has fewer than 120.
pub const MAX_JUMPS: u32 = 10_000;

/// Why random walks cannot start.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WalkError {
    /// The start is not inside the boundary.
    #[error("the start ({x}, {y}) of the random walks is not inside the outline as it is sampled")]
    StartOutside {
        /// The x coordinate of the start.
        x: f64,
        /// The y coordinate of the start.
        y: f64,
    },
    /// The boundary is not a polygon.
    #[error("a boundary of finite points is needed, at least 3 of them, no two neighbors equal")]
    NoBoundary,
}

/// A circle of a walk: the largest one inside the domain about its center.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WalkCircle {
    /// The current position of the walk.
    pub centre: DVec2,
    /// The distance to the boundary.
    pub radius: f64,
}

/// One step of a walk.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum WalkStep {
    /// A jump to the center of this circle, a point of the previous circle.
    Jump(WalkCircle),
    /// The end of the walk; the next step starts a new walk at x.
    Hit(BoundaryPoint),
}

/// Walks from a point until they hit the boundary of a sampled domain.
#[derive(Debug, Clone)]
pub struct Walker {
    tree: EdgeTree<Vec<DVec2>>,
    start: DVec2,
    stop: f64,
    random: SplitMix64,
    circle: WalkCircle,
    nearest: BoundaryPoint,
    jumps: u32,
}

impl Walker {
    /// Walks from `x` inside the closed chain `points`, with the random numbers of `seed`. Cost O(m).
    pub fn new(points: &[DVec2], x: DVec2, seed: u64) -> Result<Self, WalkError> {
        let next = points.iter().cycle().skip(1);
        if points.len() < 3 || points.iter().zip(next).any(|(p, q)| p == q || !p.is_finite()) {
            return Err(WalkError::NoBoundary);
        }
        let tree = EdgeTree::new(points.to_vec());
        if !x.is_finite() || tree.signed_distance(x) <= 0.0 {
            return Err(WalkError::StartOutside { x: x.x, y: x.y });
        }
        let mut walker = Self {
            start: x,
            stop: WALK_STOP * tree.bounds().size().max_element(),
            random: SplitMix64(seed),
            circle: WalkCircle { centre: x, radius: 0.0 },
            nearest: BoundaryPoint::new(0, 0.0),
            jumps: 0,
            tree,
        };
        walker.restart();
        Ok(walker)
    }

    /// The circle about the walk's current position; about x before the first jump.
    pub fn circle(&self) -> WalkCircle {
        self.circle
    }

    /// The number of jumps of the current walk.
    pub fn jumps(&self) -> u32 {
        self.jumps
    }

    /// Makes the next jump, or ends the walk and returns the walker to x.
    pub fn step(&mut self) -> WalkStep {
        if self.circle.radius <= self.stop || self.jumps >= MAX_JUMPS {
            let hit = self.nearest;
            self.restart();
            return WalkStep::Hit(hit);
        }
        let direction = DVec2::from_angle(TAU * self.random.unit());
        self.move_to(self.circle.centre + self.circle.radius * direction);
        self.jumps += 1;
        WalkStep::Jump(self.circle)
    }

    /// Runs the walk to its end and returns the hit.
    pub fn walk(&mut self) -> BoundaryPoint {
        loop {
            if let WalkStep::Hit(hit) = self.step() {
                return hit;
            }
        }
    }

    fn restart(&mut self) {
        self.jumps = 0;
        self.move_to(self.start);
    }

    fn move_to(&mut self, place: DVec2) {
        let found = self.tree.nearest_point(place);
        self.circle = WalkCircle { centre: place, radius: found.distance };
        // a vertex belongs to the edge that starts there
        let next = (found.edge + 1) % self.tree.points().len();
        let (edge, fraction) = if found.fraction < 1.0 { (found.edge, found.fraction) } else { (next, 0.0) };
        self.nearest = BoundaryPoint::new(edge as u32, fraction);
    }
}

/// The generator of G. L. Steele, D. Lea & C. H. Flood, "Fast splittable pseudorandom
/// number generators", OOPSLA 2014: 64 bits of state, any seed will do.
#[derive(Debug, Clone)]
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `[0, 1)`, a multiple of 2⁻⁵³.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (-53.0_f64).exp2()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn generator_gives_the_published_numbers() {
        let mut random = SplitMix64(1_234_567);
        let expected = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([random.next(), random.next(), random.next()], expected);
    }

    fn disk(count: usize) -> Vec<DVec2> {
        (0..count).map(|k| DVec2::from_angle(TAU * k as f64 / count as f64)).collect()
    }

    #[test]
    fn every_jump_goes_to_a_point_of_the_circle_before() {
        let mut walker = Walker::new(&disk(200), DVec2::new(0.3, -0.4), 7).unwrap();
        for _ in 0..2000 {
            let before = walker.circle();
            match walker.step() {
                WalkStep::Jump(circle) => {
                    let jump = circle.centre.distance(before.centre);
                    assert!((jump - before.radius).abs() < 1e-15, "{jump} and {}", before.radius);
                    assert!(circle.centre.length() < 1.0 && circle.radius > 0.0);
                }
                WalkStep::Hit(_) => {
                    assert!(before.radius <= 2.0 * WALK_STOP);
                    assert_eq!((walker.jumps(), walker.circle().centre), (0, DVec2::new(0.3, -0.4)));
                }
            }
        }
    }

    #[test]
    fn equal_seeds_walk_alike_and_others_do_not() {
        let hits = |seed| {
            let mut walker = Walker::new(&disk(50), DVec2::ZERO, seed).unwrap();
            [(); 10].map(|()| walker.walk())
        };
        assert_eq!(hits(3), hits(3));
        assert_ne!(hits(3), hits(4));
    }

    #[test]
    fn starts_that_are_not_inside_are_refused() {
        for x in [DVec2::new(1.5, 0.0), DVec2::new(f64::NAN, 0.0), DVec2::X] {
            assert!(matches!(Walker::new(&disk(50), x, 0), Err(WalkError::StartOutside { .. })), "{x}");
        }
        assert_eq!(Walker::new(&disk(2), DVec2::ZERO, 0).unwrap_err(), WalkError::NoBoundary);
        assert_eq!(Walker::new(&[DVec2::ZERO; 4], DVec2::ZERO, 0).unwrap_err(), WalkError::NoBoundary);
    }
}

//! A circle inside a domain, through a given point.
//!
//! Let d(c) be the distance of c from the boundary. Along a ray p + r u the function d(p + r u) − k r with k > 1
//! falls strictly, because d changes by at most r; where it is zero, the circle of radius r about p + r u passes
//! through p and keeps the distance (k − 1) r from the boundary. Up to there d is positive: the
//! centre is inside. Of several directions the one with the largest circle is taken.

use crate::geometry::DVec2;
use crate::outline::BoundarySamples;
use std::f64::consts::TAU;

/// k: the circle keeps a quarter of its radius from the boundary.
const CLEARANCE: f64 = 1.25;
/// Directions that are tried. Those of a wide place differ little; in a channel two of sixteen lie along it.
const DIRECTIONS: u32 = 16;
/// Steps of the bisection: the radius is found to a thousandth of the way.
const STEPS: u32 = 10;

/// A circle that is gone around once, counter-clockwise or clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub centre: DVec2,
    /// From the centre to where it begins: as long as the radius.
    pub arm: DVec2,
    turns: f64,
}

impl Circle {
    /// The largest found circle through the interior point `point`. Its radius is 0 where the point lies on the boundary. Cost O(m).
    pub fn through(point: DVec2, samples: &BoundarySamples) -> Self {
        let distance = |c: DVec2| samples.position(samples.nearest(c)).distance(c);
        let room = distance(point);
        let mut best = 0.0;
        let mut centre = point;
        for k in 0..DIRECTIONS {
            let direction = DVec2::from_angle(TAU * f64::from(k) / f64::from(DIRECTIONS));
            let fits = |r: f64| distance(point + r * direction) >= CLEARANCE * r;
            // a direction that has no more room than the best one is not worth a search
            if !fits(1.001 * best) {
                continue;
            }
            // d(p + r u) ≤ d(p) + r: no larger circle fits
            let radius = largest(fits, room / (CLEARANCE - 1.0));
            if radius > best {
                (best, centre) = (radius, point + radius * direction);
            }
        }
        Self { centre, arm: point - centre, turns: 1.0 }
    }

    /// The same circle, clockwise.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { turns: -self.turns, ..self }
    }

    /// The point at time `t`; at 0 and 1 where it begins.
    pub fn at(&self, t: f64) -> DVec2 {
        if t == 0.0 {
            return self.centre + self.arm;
        }
        self.centre + DVec2::from_angle(self.turns * TAU * t).rotate(self.arm)
    }
}

/// The end of the interval from 0 in which `fits` holds, below `limit`.
fn largest(fits: impl Fn(f64) -> bool, limit: f64) -> f64 {
    let (mut low, mut high) = (0.0, limit);
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

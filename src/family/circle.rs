//! A circle inside a domain, through a given point.
//!
//! Let d(c) be the distance of c from the boundary. Along a ray p + r u the function d(p + r u) − k r with k > 1
//! decreases strictly, because d changes by at most r; at its zero, the circle of radius r about p + r u passes
//! through p and keeps the distance (k − 1) r from the boundary. Up to there d is positive, so that the
//! center is inside. Of several directions the one with the largest circle is chosen.

use crate::geometry::DVec2;
use crate::outline::BoundarySamples;
use std::f64::consts::TAU;

/// k: the circle keeps a quarter of its radius from the boundary.
const CLEARANCE: f64 = 1.25;
/// The number of directions. In wide places they give similar circles; in a channel two of sixteen lie along it.
const DIRECTIONS: u32 = 16;
/// Steps of the bisection, which gives the radius to a thousandth of the interval.
const STEPS: u32 = 10;

/// A circle traversed once, counter-clockwise or clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    center: DVec2,
    /// The vector from the center to the start.
    arm: DVec2,
    /// 1 counter-clockwise, −1 clockwise.
    turns: f64,
}

impl Circle {
    /// The largest circle found through the interior point `point`; radius 0 if the point lies on the boundary. Cost
    /// O(m).
    pub fn through(point: DVec2, samples: &BoundarySamples) -> Self {
        let distance = |c: DVec2| samples.position(samples.nearest(c)).distance(c);
        let room = distance(point);
        let mut best = 0.0;
        let mut center = point;
        for k in 0..DIRECTIONS {
            let direction = DVec2::from_angle(TAU * f64::from(k) / f64::from(DIRECTIONS));
            let fits = |r: f64| distance(point + r * direction) >= CLEARANCE * r;
            // skip a direction that has no more room than the best one so far
            if !fits(1.001 * best) {
                continue;
            }
            // d(p + r u) ≤ d(p) + r, so that no larger circle fits
            let radius = largest(fits, room / (CLEARANCE - 1.0));
            if radius > best {
                (best, center) = (radius, point + radius * direction);
            }
        }
        Self { center, arm: point - center, turns: 1.0 }
    }

    /// The center.
    pub fn center(&self) -> DVec2 {
        self.center
    }

    /// The radius; 0 about a point on the boundary.
    pub fn radius(&self) -> f64 {
        self.arm.length()
    }

    /// The same circle in the opposite direction.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { turns: -self.turns, ..self }
    }

    /// The point at time `t`; at 0 and 1 the start.
    pub fn at(&self, t: f64) -> DVec2 {
        if t == 0.0 {
            return self.center + self.arm;
        }
        self.center + DVec2::from_angle(self.turns * TAU * t).rotate(self.arm)
    }
}

/// The upper end of the interval from 0 in which `fits` holds, at most `limit`.
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

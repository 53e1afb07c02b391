//! Simple polygons, validated once: a [`SimplePolygon`] is finite, free of
//! repeated points, of non-zero area, nowhere touching or crossing itself, and
//! counter-clockwise.
//!
//! Consecutive edges may be collinear. The decisions (simple, orientation,
//! [`SimplePolygon::contains`]) are exact; lengths and areas are rounded.

use glam::DVec2;

use super::predicates::{in_box, orientation};
use super::validate::{Checked, check};
use super::{PolygonError, pole};

/// A simple, counter-clockwise polygon `v_0 … v_{k-1}`; the edge `k` runs from `v_k` to `v_{k+1}`.
///
/// Two polygons are equal if their vertices are, even if one was given clockwise.
#[derive(Debug, Clone)]
pub struct SimplePolygon {
    vertices: Vec<DVec2>,
    was_clockwise: bool,
}

impl PartialEq for SimplePolygon {
    fn eq(&self, other: &Self) -> bool {
        self.vertices == other.vertices
    }
}

/// An axis-parallel box with `min ≤ max` in both coordinates; the box of no points is the exception.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    min: DVec2,
    max: DVec2,
}

impl Bounds {
    /// The box between its lower left and its upper right corner.
    pub const fn new(min: DVec2, max: DVec2) -> Self {
        Self { min, max }
    }

    /// The lower left and the upper right corner.
    pub const fn corners(&self) -> [DVec2; 2] {
        [self.min, self.max]
    }

    /// The lower left corner.
    pub const fn min(&self) -> DVec2 {
        self.min
    }

    /// The upper right corner.
    pub const fn max(&self) -> DVec2 {
        self.max
    }

    /// The smallest box around `points`; inverted and infinite if there are none.
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Self {
        let empty = Self { min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };
        points.into_iter().fold(empty, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The middle.
    pub fn center(&self) -> DVec2 {
        self.min.midpoint(self.max)
    }
}

impl TryFrom<Vec<DVec2>> for SimplePolygon {
    type Error = PolygonError;

    /// Checks the points, and reverses them if they are clockwise. Cost O(k log k).
    ///
    /// Coordinates below 2⁻¹⁴⁰ in magnitude become 0.
    fn try_from(vertices: Vec<DVec2>) -> Result<Self, PolygonError> {
        let Checked { mut points, clockwise } = check(vertices)?;
        if clockwise {
            points[1..].reverse();
        }
        Ok(Self { vertices: points, was_clockwise: clockwise })
    }
}

impl SimplePolygon {
    /// A polygon from points known to be valid and counter-clockwise: those of the built-in outlines, which
    /// the tests check, and vertices of a `SimplePolygon` that were sent to a worker. Checked in debug
    /// builds only.
    pub(crate) fn known_simple(vertices: Vec<DVec2>) -> Self {
        debug_assert!(check(vertices.clone()).is_ok_and(|c| !c.clockwise), "not a counter-clockwise simple polygon");
        Self { vertices, was_clockwise: false }
    }

    /// The vertices, counter-clockwise.
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// Whether the given points were clockwise and have been reversed (the first point stays first).
    pub fn was_clockwise(&self) -> bool {
        self.was_clockwise
    }

    /// The edges `(v_k, v_{k+1})`, `k = 0 … `, the closing one last.
    pub fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        let v = &self.vertices;
        v.iter().copied().zip(v.iter().copied().cycle().skip(1))
    }

    /// The total length of the boundary.
    pub fn perimeter(&self) -> f64 {
        self.edges().map(|(a, b)| a.distance(b)).sum()
    }

    /// The place of the top-most point, as a fraction of the boundary's length from the first vertex. Of several such
    /// points, as on a flat top, it is the one nearest to the vertical line through the middle of the box.
    pub fn fraction_of_top(&self) -> f64 {
        let bounds = self.bounds();
        let (middle, top) = (bounds.center().x, bounds.corners()[1].y);
        let (mut before, mut best) = (0.0, (f64::INFINITY, 0.0));
        for (a, b) in self.edges() {
            let length = a.distance(b);
            if a.y == top {
                let share = if b.y == top { ((middle - a.x) / (b.x - a.x)).clamp(0.0, 1.0) } else { 0.0 };
                let aside = (a.x + share * (b.x - a.x) - middle).abs();
                if aside < best.0 {
                    best = (aside, before + share * length);
                }
            }
            before += length;
        }
        (best.1 / before).rem_euclid(1.0)
    }

    /// The enclosed area, `½ Σ (v_k − v_0) × (v_{k+1} − v_0)`; not negative.
    pub fn area(&self) -> f64 {
        let origin = self.vertices[0];
        let twice: f64 = self.edges().map(|(a, b)| (a - origin).perp_dot(b - origin)).sum();
        (0.5 * twice).max(0.0)
    }

    /// The smallest axis-parallel box around the polygon.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.vertices.iter().copied())
    }

    /// Whether `x` lies strictly inside, decided exactly; points of the boundary do not. Cost O(k).
    pub fn contains(&self, x: DVec2) -> bool {
        let mut inside = false;
        for (a, b) in self.edges() {
            let upward = b.y > x.y;
            if upward == (a.y > x.y) && !(a.y == x.y || b.y == x.y) {
                continue;
            }
            let turn = orientation(a, b, x);
            if turn == 0.0 && in_box(a, b, x) {
                return false;
            }
            if upward != (a.y > x.y) && (turn > 0.0) == upward {
                inside = !inside;
            }
        }
        inside
    }

    /// The interior point farthest from the boundary: its distance is within
    /// `tolerance` (absolute) of the greatest one.
    ///
    /// A best-first quadtree search, after Agafonkin's polylabel. It stops after
    /// 2,400 cells (3 ms), a limit that a long corridor of even width can reach; the result is then
    /// a local maximum near the best point so far. Tolerances below 10⁻⁹ of the
    /// extent are raised to that. The point is always strictly inside, unless the polygon is so
    /// thin that no `f64` point inside it is found on its scan lines.
    pub fn pole_of_inaccessibility(&self, tolerance: f64) -> DVec2 {
        pole::pole_of_inaccessibility(self, tolerance)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
#[path = "polygon_tests.rs"]
mod tests;

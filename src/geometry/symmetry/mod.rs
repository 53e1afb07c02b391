//! Reflections and rotations that carry an outline onto itself, within a tolerance.
//!
//! The candidates are a fan of axes through the centroid of the area, which every symmetry fixes, and turns by 2π/n
//! about it. Each is fitted to the outline by least squares and then measured on all of its boundary, so that neither
//! the number of points nor their spacing matters. Guaranteed: what is listed moves no point of the boundary farther
//! from it than the tolerance (and a hundredth of it, up to which deviations are known). Not guaranteed: parts thinner
//! than the tolerance are not told apart from each other; fits minimize squares, so that a symmetry whose deviation
//! is near the tolerance may be missed.

mod measure;
mod motion;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::SimplePolygon;
use measure::Centered;
use motion::Motion;

/// The largest distance of the moved outline from the outline, in sizes of the outline ([`Symmetries::size`]): two
/// pixels and a half of a silhouette that is 500 pixels across. The symmetries of the built-in outlines are off by
/// 1e-15.
pub const SYMMETRY_TOLERANCE: f64 = 0.01;
/// Turns by less than 2π/60 are not looked for: a regular polygon of 60 corners is a circle within a fifth of the tolerance.
const MOST_TURNS: u32 = 60;
/// The number of axes in the fan. The nearest one is off by at most 0.25°, which moves no point by more than 0.009 sizes.
const FAN: u32 = 360;
/// Axes of the fan that turn less than this are one axis after the fit, in radians.
const ONE_AXIS: f64 = 2e-3;

/// Axes that fall by less than this angle count as level, so that noise does not turn their direction around.
const LEVEL: f64 = 0.01;

/// The symmetries of an outline: each is listed with its deviation, the largest distance of the moved outline from the
/// outline, in multiples of `size`, and at most [`SYMMETRY_TOLERANCE`].
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Symmetries {
    /// The center of the rotations; without one the point of the first axis next to the centroid of the area, or that
    /// centroid itself.
    pub center: DVec2,
    /// The largest distance of the outline from the centroid of its area.
    pub size: f64,
    /// The rotations about the center.
    pub rotations: Rotations,
    /// The axes of the reflections, by their angle from the x-axis, in [0, π) up to noise. Empty for a circle, which has all of them.
    pub axes: Vec<Axis>,
}

/// The rotations about a center that carry an outline onto itself.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub enum Rotations {
    /// Only that by 0.
    Identity,
    /// Those by multiples of 2π/`order`.
    Order {
        /// The number of rotations, at least 2.
        order: u32,
        /// The largest deviation of these turns.
        deviation: f64,
    },
    /// All: the outline is a circle, with reflections at all lines through the center.
    Circle {
        /// The difference of the largest and the least distance from the center.
        deviation: f64,
    },
}

/// An axis of reflection.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Axis {
    /// The point of the axis next to the centroid of the area.
    pub point: DVec2,
    /// Its direction, of length 1, upward or to the right.
    pub direction: DVec2,
    /// The deviation of the reflection.
    pub deviation: f64,
}

impl Axis {
    /// The point of the axis next to `p`.
    pub fn foot(&self, p: DVec2) -> DVec2 {
        self.point + (p - self.point).dot(self.direction) * self.direction
    }

    /// The mirror image of `p`.
    pub fn reflected(&self, p: DVec2) -> DVec2 {
        2.0 * self.foot(p) - p
    }

    /// Where the axis meets a polygon: the index of the edge and the place in [0, 1) on it, in the polygon's order. An
    /// edge that lies on the axis counts with its first end.
    pub fn crossings(&self, polygon: &SimplePolygon) -> Vec<(usize, f64)> {
        let height = |p: DVec2| self.direction.perp_dot(p - self.point);
        let rounding =
            4.0 * f64::EPSILON * polygon.bounds().corners().map(DVec2::length).into_iter().fold(0.0, f64::max);
        let snapped = |p: DVec2| Some(height(p)).filter(|h| h.abs() > rounding).unwrap_or(0.0);
        let crossing = |(k, (a, b)): (usize, (DVec2, DVec2))| match (snapped(a), snapped(b)) {
            (0.0, _) => Some((k, 0.0)),
            (from, to) if from * to < 0.0 => Some((k, from / (from - to))),
            _ => None,
        };
        polygon.edges().enumerate().filter_map(crossing).collect()
    }
}

impl Symmetries {
    /// Finds the symmetries of an outline. Cost O(k log k) for each one found; 1 to 180 ms for the built-in outlines of
    /// up to 6,000 points, most for the spiral.
    pub fn of(polygon: &SimplePolygon) -> Self {
        let shape = Centered::new(polygon);
        if let Some(deviation) = shape.circle() {
            let rotations = Rotations::Circle { deviation };
            return Self { center: shape.centroid, size: shape.size, rotations, axes: Vec::new() };
        }
        let turn = largest_turn(&shape);
        let mut axes = axes(&shape);
        axes.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
        let center = match (turn, axes.first()) {
            (Some((center, ..)), _) => shape.centroid + shape.size * center,
            (None, Some(axis)) => axis.point,
            (None, None) => shape.centroid,
        };
        let rotations = turn.map_or(Rotations::Identity, |(_, order, deviation)| Rotations::Order { order, deviation });
        Self { center, size: shape.size, rotations, axes }
    }

    /// Whether the identity is the only one.
    pub fn is_empty(&self) -> bool {
        self.axes.is_empty() && self.rotations == Rotations::Identity
    }
}

/// Center, order and deviation of the smallest turn.
fn largest_turn(shape: &Centered) -> Option<(DVec2, u32, f64)> {
    (2..=MOST_TURNS).rev().find_map(|order| {
        let start = Motion::Turn { center: DVec2::ZERO, angle: TAU / f64::from(order) };
        match shape.verified(start)? {
            (Motion::Turn { center, .. }, deviation) => Some((center, order, deviation)),
            (Motion::Mirror { .. }, _) => None,
        }
    })
}

/// The axes to which the local minima of the fan lead.
fn axes(shape: &Centered) -> Vec<Axis> {
    let fan: Vec<Motion> =
        (0..FAN).map(|k| Motion::Mirror { angle: PI * f64::from(k) / f64::from(FAN), offset: 0.0 }).collect();
    let misfit: Vec<f64> = fan.iter().map(|&motion| shape.misfit(motion).unwrap_or(f64::INFINITY)).collect();
    let n = fan.len();
    let is_least = |k: usize| misfit[k] <= misfit[(k + n - 1) % n] && misfit[k] < misfit[(k + 1) % n];
    let mut found: Vec<Axis> = Vec::new();
    for start in (0..n).filter(|&k| is_least(k)) {
        if let Some((Motion::Mirror { angle, offset }, deviation)) = shape.verified(fan[start]) {
            let direction = upward(DVec2::from_angle(angle));
            let point = shape.centroid + shape.size * offset * DVec2::from_angle(angle).perp();
            let is_new = |axis: &Axis| axis.direction.perp_dot(direction).abs() > ONE_AXIS;
            if found.iter().all(is_new) {
                found.push(Axis { point, direction, deviation });
            }
        }
    }
    found
}

/// The direction of a line, of the two that with an angle in [−[`LEVEL`], π − `LEVEL`).
fn upward(direction: DVec2) -> DVec2 {
    if (-LEVEL..PI - LEVEL).contains(&direction.to_angle()) { direction } else { -direction }
}

fn angle(axis: &Axis) -> f64 {
    axis.direction.to_angle()
}

//! Rings of longitudes and latitudes as directed edges, each straight in longitude and latitude (RFC 7946, 3.1.1).
//!
//! Steps of more than 180° of longitude go the other way around, across the antimeridian. One of exactly 360° is a whole
//! parallel in a ring that reaches a pole, as that of a polar cap cut at the antimeridian, and otherwise no step at all.
//! A ring is turned so that the region is on its left: by its area in the plane of longitude and latitude or, if it
//! winds around a pole, such that the region is the smaller side.

use super::ProjectionError;
use super::sphere::on_sphere;
use crate::geometry::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};
use std::fmt;

/// A point of a ring, both counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// The ring.
    pub ring: usize,
    /// The point.
    pub point: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "point {} of ring {}", self.point, self.ring)
    }
}

/// An edge, in degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Longitude and latitude of its beginning.
    pub from: DVec2,
    /// Longitude and latitude of its end, as in the file: `from + step` up to whole turns and rounding.
    pub end: DVec2,
    /// What longitude and latitude grow by.
    pub step: DVec2,
    /// The file's point at its beginning, before it was turned.
    pub place: Place,
}

/// A vertex: the bits of longitude in [−180°, 180°) and latitude; at a pole of longitude 0.
pub type Key = [u64; 2];

pub fn key(p: DVec2) -> Key {
    let longitude = if p.y.abs() == 90.0 { 0.0 } else { (p.x + 180.0).rem_euclid(360.0) - 180.0 };
    // −0 becomes 0
    [longitude + 0.0, p.y + 0.0].map(f64::to_bits)
}

impl Edge {
    /// The point of the sphere after the share `t` of the edge.
    pub fn at(&self, t: f64) -> DVec3 {
        on_sphere(self.lon_lat(t))
    }

    /// Longitude and latitude after the share `t` of the edge.
    pub fn lon_lat(&self, t: f64) -> DVec2 {
        self.from + t * self.step
    }

    /// −∫ sin φ dλ along the edge.
    fn area(&self) -> f64 {
        let half = 0.5 * self.step.y.to_radians();
        let mean = if half == 0.0 { 1.0 } else { half.sin() / half };
        -self.step.x.to_radians() * (self.from.y + 0.5 * self.step.y).to_radians().sin() * mean
    }

    /// Whether both ends are one point of the sphere, and the edge does not go around it.
    pub fn is_nothing(&self) -> bool {
        key(self.from) == key(self.end) && (self.from.y.abs() == 90.0 || self.step.x.abs() < 180.0)
    }

    fn reversed(self) -> Self {
        Self { from: self.end, end: self.from, step: -self.step, place: self.place }
    }
}

/// The turns of longitude around which a closed chain of edges winds, eastward.
fn turns(edges: &[Edge]) -> f64 {
    (edges.iter().map(|edge| edge.step.x).sum::<f64>() / 360.0).round()
}

/// The area on the left of a closed chain of edges on the unit sphere, in [0, 4π).
///
/// By Green's theorem −∮ sin φ dλ, and 2π more if the chain winds around a pole; negative where both poles are inside.
pub fn area(edges: &[Edge]) -> f64 {
    let winding = turns(edges).abs();
    let area = edges.iter().map(Edge::area).sum::<f64>() + TAU * winding;
    let area = area.rem_euclid(4.0 * PI);
    // rounding below zero is no whole sphere
    if area > 4.0 * PI - 1e-12 { 0.0 } else { area }
}

/// Points within this distance of the antimeridian, in degrees (0.1 m), are on it, and their latitudes are rounded to
/// it, so that both sides of a cut have the same vertices.
const SNAP: f64 = 1e-6;

/// The point, moved onto the antimeridian or the pole next to it.
fn snapped(p: DVec2) -> DVec2 {
    let pole = |latitude: f64| if 90.0 - latitude.abs() < SNAP { 90.0_f64.copysign(latitude) } else { latitude };
    if (p.x.abs() - 180.0).abs() > SNAP {
        return DVec2::new(p.x, pole(p.y));
    }
    DVec2::new(180.0_f64.copysign(p.x), pole((p.y / SNAP).round() * SNAP))
}

/// The edges of a ring of points, its number counted from 1, with the region on the left.
pub fn ring(points: &[DVec2], ring: usize) -> Result<Vec<Edge>, ProjectionError> {
    let snapped = checked(points, ring)?;
    let reaches_pole = snapped.iter().any(|p| p.y.abs() == 90.0);
    let n = snapped.len();
    let edge = |k: usize| {
        let (from, to) = (snapped[k], snapped[(k + 1) % n]);
        let mut step = to - from;
        if step.x.abs() > 180.0 && !(reaches_pole && step.x.abs() == 360.0) {
            step.x -= 360.0 * (step.x / 360.0).round();
        }
        Edge { from, end: to, step, place: Place { ring, point: k + 1 } }
    };
    let edges: Vec<Edge> = (0..n).map(edge).collect();
    let different = edges.iter().filter(|edge| !edge.is_nothing()).count();
    if different < 3 && !reaches_pole {
        return Err(ProjectionError::TooFewPoints { ring, points: different });
    }
    let is_left = if turns(&edges) == 0.0 { plane_area(&edges) > 0.0 } else { area(&edges) <= TAU };
    Ok(if is_left { edges } else { edges.into_iter().rev().map(Edge::reversed).collect() })
}

fn checked(points: &[DVec2], ring: usize) -> Result<Vec<DVec2>, ProjectionError> {
    let check = |(k, p): (usize, &DVec2)| {
        let place = Place { ring, point: k + 1 };
        if !(-90.0..=90.0).contains(&p.y) {
            return Err(ProjectionError::Latitude { place, latitude: p.y });
        }
        if !(-360.0..=360.0).contains(&p.x) {
            return Err(ProjectionError::Longitude { place, longitude: p.x });
        }
        Ok(snapped(*p))
    };
    points.iter().enumerate().map(check).collect()
}

/// Twice the area in the plane of longitude and latitude, along the unrolled edges.
fn plane_area(edges: &[Edge]) -> f64 {
    let origin = edges[0].from;
    let mut at = DVec2::ZERO;
    let mut sum = 0.0;
    for edge in edges {
        at.y = edge.from.y - origin.y;
        sum += at.perp_dot(edge.step);
        at.x += edge.step.x;
    }
    sum
}

//! The stereographic projection whose scale varies least over a region.
//!
//! Its scale at the angular distance d from its center c is sec²(d/2) = 2/(1 + p·c), so that the ratio over the region is
//! (1 + M)/(1 + m) with the largest and the least p·c. If c lies in the region M = 1, and the best center is that of the
//! smallest cap around the region. Otherwise a farther center may be better, since M < 1 then: a search over directions,
//! turned at every step, goes down from there, and the ratio may be a little larger than the least one.

use super::cap;
use super::region::Region;
use super::sphere::{lon_lat, on_sphere};
use crate::geometry::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Directions that are tried at each step.
const DIRECTIONS: u32 = 12;

/// The golden ratio's part of the angle between two directions, by which they turn from step to step.
const TURN: f64 = 0.618_033_988_749_894_9;

/// The least step, in radians, and the largest number of steps.
const LEAST_STEP: f64 = 1e-9;
const MOST_STEPS: u32 = 400;

/// A stereographic projection over a region.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Stereographics {
    /// Longitude and latitude of its center, in degrees.
    pub center: DVec2,
    /// The largest scale over the least one.
    pub ratio: f64,
}

/// The ratio for a center: infinite if its antipode is in the region.
fn ratio(region: &Region, points: &[DVec3], center: DVec3) -> f64 {
    let products = points.iter().map(|p| p.dot(center));
    let (low, high) = products.fold((1.0_f64, -1.0_f64), |(low, high), x| (low.min(x), high.max(x)));
    if region.contains(-center) {
        return f64::INFINITY;
    }
    let most = if region.contains(center) { 1.0 } else { high };
    (1.0 + most) / (1.0 + low)
}

/// The best stereographic projection of a region.
pub fn best(region: &Region) -> Stereographics {
    let points: Vec<DVec3> = region.lon_lat().iter().map(|&p| on_sphere(p)).collect();
    let starts = [cap::smallest(&points), region.frame().center()];
    let found = starts.map(|start| search(region, &points, start));
    let (center, ratio) = if found[1].1 < found[0].1 { found[1] } else { found[0] };
    Stereographics { center: lon_lat(center), ratio }
}

fn search(region: &Region, points: &[DVec3], start: DVec3) -> (DVec3, f64) {
    let mut best = (start, ratio(region, points, start));
    let radius = points.iter().map(|p| p.distance(start)).fold(0.0, f64::max);
    let mut step = 0.3 * radius;
    for count in 0..MOST_STEPS {
        if step < LEAST_STEP * radius {
            break;
        }
        let east = best.0.any_orthonormal_vector();
        let north = best.0.cross(east);
        let moved = |k: u32| {
            let angle = TAU * (f64::from(k) + (f64::from(count) * TURN).fract()) / f64::from(DIRECTIONS);
            let center = (best.0 + step * (angle.cos() * east + angle.sin() * north)).normalize();
            (center, ratio(region, points, center))
        };
        match (0..DIRECTIONS).map(moved).min_by(|a, b| a.1.total_cmp(&b.1)).filter(|found| found.1 < best.1) {
            Some(found) => best = found,
            None => step *= 0.6,
        }
    }
    best
}

//! An island that does not exist, for those who have no file of a region at hand.
//!
//! Its coast has the distance R (1 + Σ aₖ cos(kθ + φₖ)) from its center in the direction θ, on a map whose parallels and
//! meridians are equally spaced and as long as on the globe at the center's latitude.

use crate::geometry::DVec2;
use std::f64::consts::TAU;

/// Longitude and latitude of the center, and R in degrees.
const CENTER: DVec2 = DVec2::new(-32.0, 52.0);
const RADIUS: f64 = 15.0;

/// k, aₖ and φₖ: long from southwest to northeast, with bays.
const WAVES: [(f64, f64, f64); 5] =
    [(1.0, 0.12, 0.8), (2.0, 0.34, -1.7), (3.0, 0.10, 0.6), (5.0, 0.07, 2.1), (8.0, 0.04, 0.3)];

/// The number of points: one every six degrees of θ.
const POINTS: u32 = 60;

/// The island's ring of longitude and latitude in degrees, without a last point that repeats the first.
pub fn island() -> Vec<DVec2> {
    let coast = |k: u32| {
        let theta = TAU * f64::from(k) / f64::from(POINTS);
        let waves: f64 = WAVES.iter().map(|(k, a, phase)| a * (k * theta + phase).cos()).sum();
        let step = RADIUS * (1.0 + waves) * DVec2::from_angle(theta);
        let place = CENTER + step / DVec2::new(CENTER.y.to_radians().cos(), 1.0);
        (1e4 * place).round() / 1e4
    };
    (0..POINTS).map(coast).collect()
}

//! The head of an unspecified animal, by formula: a sphere with bumps, open at the neck.
//!
//! The unit disk is wrapped around the sphere (azimuthal equidistant projection), and each
//! direction d gets the distance `r(d) = 1 + Σ h exp(−|offset|²)`, the offset of d from a bump's
//! direction being measured in the bump's two widths.

use crate::geometry::{DVec2, DVec3};

/// The angle from the middle of the wrapped disk to its boundary; the opening that remains is the neck.
const REACH: f64 = 125.0 * std::f64::consts::PI / 180.0;

/// The middle of the disk: the forehead. The head looks towards −y, z is up.
const FOREHEAD: DVec3 = DVec3::new(0.0, -0.45, 0.9);

/// A bump: its direction, its widths sideways and upwards, its height.
type Bump = (DVec3, f64, f64, f64);

/// The bumps in the plane of symmetry.
const MIDDLE: [Bump; 4] = [
    (DVec3::new(0.0, -1.0, -0.30), 0.50, 0.50, 0.62),
    (DVec3::new(0.0, -1.0, -0.34), 0.34, 0.22, 0.14),
    (DVec3::new(0.0, -0.75, 0.30), 0.20, 0.45, 0.10),
    (DVec3::new(0.0, -0.80, -0.62), 0.35, 0.16, -0.10),
];

/// The bumps on the right, mirrored to the left: ear, its hollow, brow, eye, cheek, nostril.
const RIGHT: [Bump; 6] = [
    (DVec3::new(0.66, 0.05, 0.75), 0.22, 0.30, 0.85),
    (DVec3::new(0.62, -0.25, 0.74), 0.14, 0.16, -0.22),
    (DVec3::new(0.42, -0.68, 0.60), 0.26, 0.15, 0.08),
    (DVec3::new(0.42, -0.82, 0.34), 0.13, 0.12, -0.12),
    (DVec3::new(0.60, -0.70, -0.20), 0.30, 0.30, 0.10),
    (DVec3::new(0.16, -1.0, -0.30), 0.06, 0.06, -0.10),
];

/// The point of the head over the point p of the unit disk.
pub(super) fn lifted(p: DVec2) -> DVec3 {
    let toward = direction(p);
    let twin = |&(d, wide, high, height): &Bump| (DVec3::new(-d.x, d.y, d.z), wide, high, height);
    let bumps = MIDDLE.iter().copied().chain(RIGHT).chain(RIGHT.iter().map(twin));
    let radius: f64 = 1.0 + bumps.map(|bump| height(bump, toward)).sum::<f64>();
    radius * toward
}

/// The direction at p: its angle from the forehead is proportional to |p|.
fn direction(p: DVec2) -> DVec3 {
    let forehead = FOREHEAD.normalize();
    let up = (DVec3::Z - DVec3::Z.dot(forehead) * forehead).normalize();
    let right = up.cross(forehead);
    let (sine, cosine) = (REACH * p.length()).sin_cos();
    let sideways = p.normalize_or_zero();
    cosine * forehead + sine * (sideways.x * right + sideways.y * up)
}

fn height((toward, wide, high, height): Bump, d: DVec3) -> f64 {
    let toward = toward.normalize();
    let right = DVec3::Z.cross(toward).normalize_or_zero();
    let up = toward.cross(right);
    let offset = d - toward;
    let (x, y) = (offset.dot(right) / wide, offset.dot(up) / high);
    // makes a bump vanish on the other side of the head
    let depth = offset.dot(toward) / wide.max(high);
    height * (-(x * x + y * y + depth * depth)).exp()
}

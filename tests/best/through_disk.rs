//! The disk map of a side, and the best Möbius transformation after it by brute force.

use riemap::conformal::InteriorPoint;
use riemap::conformal::{
    HarmonicMeasure, PreparedSide, Unfold, disk_coordinates, poisson_kernel, triangle_distortions,
};
use riemap::geometry::{DVec2, DVec3};
use riemap::mesh::{TriMesh, locate};
use riemap::outline::BoundaryPoint;
use std::f64::consts::{LN_2, TAU};

/// Images of the vertices in the unit disk, the default point at 0.
pub struct Disk(Vec<DVec2>);

/// Circles and points on each, at distances up to 5 in the disk's own measure, and how often the neighborhood of the best
/// is searched more finely.
const CIRCLES: u32 = 12;
const POINTS: u32 = 24;
const FARTHEST: f64 = 5.0;
const ROUNDS: u32 = 5;

impl Disk {
    /// By harmonic measure on the boundary, extended harmonically.
    pub fn of(side: &PreparedSide) -> Self {
        let middle = match side.default_point() {
            InteriorPoint::Plane(x) => locate(side.domain().unwrap().mesh(), x, None).unwrap(),
            InteriorPoint::Surface(x) => x,
        };
        let kernel = poisson_kernel(side, middle).unwrap();
        let mut measure = HarmonicMeasure::default();
        measure.set_along(side.edge_lengths(), &kernel, BoundaryPoint::new(0, 0.0));
        Self(disk_coordinates(side, &measure).unwrap())
    }

    /// z ↦ (z − a)/(1 − ā z) of all images.
    fn moved(&self, a: DVec2) -> Vec<DVec2> {
        let conjugate = |z: DVec2| DVec2::new(z.x, -z.y);
        let times = |p: DVec2, q: DVec2| DVec2::new(p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x);
        let moved = |&z: &DVec2| {
            let below = DVec2::X - times(conjugate(a), z);
            times(z - a, conjugate(below)) / below.length_squared()
        };
        self.0.iter().map(moved).collect()
    }

    /// The least value of a function of the images over all maps of the disk onto itself: on a grid of a, then more and more
    /// finely about the best one. Turns do not matter onto a disk. Returns a, too.
    pub fn best(&self, value: impl Fn(&[DVec2]) -> f64) -> (f64, DVec2) {
        let at = |distance: f64, angle: f64| (0.5 * distance).tanh() * DVec2::from_angle(angle);
        let grid = (0..CIRCLES).flat_map(|i| (0..POINTS).map(move |k| (i, k)));
        let grid =
            grid.map(|(i, k)| at(FARTHEST * f64::from(i) / f64::from(CIRCLES), TAU * f64::from(k) / f64::from(POINTS)));
        let mut best = self.least(grid.collect(), &value);
        let mut step = FARTHEST / f64::from(CIRCLES) * (1.0 - best.1.length_squared());
        for _ in 0..ROUNDS {
            let around = (-3..=3).flat_map(|i| (-3..=3).map(move |k| (i, k)));
            let around = around.map(|(i, k)| best.1 + 0.34 * step * DVec2::new(f64::from(i), f64::from(k)));
            best = self.least(around.filter(|a| a.length() < 1.0).collect(), &value);
            step *= 0.4;
        }
        best
    }

    fn least(&self, places: Vec<DVec2>, value: &impl Fn(&[DVec2]) -> f64) -> (f64, DVec2) {
        let values = places.into_iter().map(|a| (value(&self.moved(a)), a));
        values.min_by(|p, q| p.0.total_cmp(&q.0)).unwrap()
    }
}

/// Where a round target's middle and radius are, the point of the map z ↦ (z − a)/(1 − ā z), turned so that the first
/// boundary points of both sides go to each other.
pub fn point_of(a: DVec2, target: &PreparedSide) -> DVec2 {
    let middle = target.default_point().in_plane().unwrap();
    let first = target.domain().unwrap().samples().points()[0] - middle;
    let turned = DVec2::X - a; // (1 − a)/(1 − ā) has twice its angle
    let image = DVec2::from_angle(-2.0 * turned.to_angle()).rotate(-a);
    middle + first.rotate(image)
}

/// The mean of (ln σ₁σ₂)² after the best scale, weighted by the triangles' areas, summed anew: a triangle whose image is a
/// segment counts by its lengths.
pub fn distortion<P: Unfold>(mesh: &TriMesh<P>, images: &[DVec2]) -> f64 {
    let squares = |[a, b, c]: [DVec3; 3]| a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
    let value = |(found, corners): (_, &[u32; 3])| {
        let found: riemap::conformal::TriangleDistortion = found;
        if !found.collapsed {
            return (found.area, LN_2 * found.area_log2);
        }
        let there = squares(corners.map(|v| images[v as usize].extend(0.0)));
        let here = squares(corners.map(|v| mesh.vertices()[v as usize].in_space()));
        (found.area, (there / here).ln().max(-128.0 * LN_2))
    };
    let values: Vec<(f64, f64)> =
        triangle_distortions(mesh, images).into_iter().zip(mesh.triangles()).map(value).collect();
    let total: f64 = values.iter().map(|value| value.0).sum();
    let mean = values.iter().map(|value| value.0 * value.1).sum::<f64>() / total;
    values.iter().map(|value| value.0 * (value.1 - mean).powi(2)).sum::<f64>() / total
}

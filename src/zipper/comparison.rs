//! Matching two domains through the disk, in both variants of sections 1.2 and 5.2.
//!
//! *Fresh*: g is computed for the interior point x, so that φ is a rotation.
//! *Precomputed*: g was computed once for another point; φ moves a = g(x) to 0. On a
//! crowded domain a and the boundary's images round to the same few points of the circle, and
//! their images under φ are noise. No correction is attempted; the lost points are counted.
//!
//! Between boundary points the angle is assumed to be linear along the edge:
//! an error of second order in the samples' distance.

use super::disk_map::LiftedAngles;
use super::{DiskMap, ZipperError};
use crate::exact::Complex;
use crate::geometry::DVec2;
use crate::outline::BoundaryPoint;
use std::f64::consts::TAU;

/// A decrease by less than this counts as rounding; by more, as an increase by nearly
/// the whole circle. Without crowding, rounding gives 1e-14, and an edge has more
/// than 1 − 2e-7 of the measure only if x almost touches it. Collapsed images can be off by any
/// angle, and may count as either.
const STEP_BACK: f64 = 1e-6;

/// The harmonic measure of a boundary by a disk map, counter-clockwise from an anchor y.
#[derive(Debug, Clone, PartialEq)]
pub struct DiskMeasure {
    anchor: BoundaryPoint,
    /// ω at the vertices `edge + 1 … edge + m` (mod m), after the anchor's edge: non-decreasing.
    from_anchor: Vec<f64>,
    image: Complex,
    collapsed: usize,
    disordered: usize,
}

impl DiskMeasure {
    /// By a disk map computed for `x`: one run of the geodesic algorithm over `points`, O(m²).
    pub fn fresh(points: &[DVec2], x: DVec2, y: BoundaryPoint) -> Result<Self, ZipperError> {
        let map = DiskMap::new(points, x)?;
        let (collapsed, disordered) = (map.collapsed(), map.disordered());
        let angles = LiftedAngles { values: map.angles().to_vec(), collapsed, disordered };
        Ok(Self::from_angles(&angles, Complex::ZERO, y))
    }

    /// By a `map` computed for another point, followed by the Möbius map that takes a = g(x) to 0. O(m).
    pub fn precomputed(map: &DiskMap, x: DVec2, y: BoundaryPoint) -> Result<Self, ZipperError> {
        let image = map.map(x).ok_or(ZipperError::PointOutside { x: x.x, y: x.y })?;
        Ok(Self::from_angles(&moved_angles(map.angles(), image), image, y))
    }

    fn from_angles(angles: &LiftedAngles, image: Complex, y: BoundaryPoint) -> Self {
        let theta = &angles.values;
        let m = theta.len();
        let edge = y.edge() as usize % m;
        let fraction = if y.fraction() >= 0.0 { y.fraction().min(1.0 - f64::EPSILON) } else { 0.0 };
        let turned = |k: usize| theta[k % m] + if k < m { 0.0 } else { TAU };
        let start = (1.0 - fraction) * theta[edge] + fraction * turned(edge + 1);
        let measure = |j: usize| ((turned(edge + j) - start) / TAU).clamp(0.0, 1.0);
        Self {
            anchor: BoundaryPoint::new(edge as u32, fraction),
            from_anchor: (1..=m).map(measure).collect(),
            image,
            collapsed: angles.collapsed,
            disordered: angles.disordered,
        }
    }

    /// The number of boundary vertices, m.
    pub fn vertex_count(&self) -> usize {
        self.from_anchor.len()
    }

    /// ω from the anchor to boundary vertex `k < m`, in `[0, 1]`; 0 at the anchor.
    pub fn at_vertex(&self, k: usize) -> f64 {
        let m = self.vertex_count();
        let j = (k + m - self.anchor.edge() as usize - 1) % m;
        if j == m - 1 && self.anchor.fraction() == 0.0 { 0.0 } else { self.from_anchor[j] }
    }

    /// ω from the anchor at the vertices `edge + 1 … edge + m` after the anchor's edge, non-decreasing.
    pub fn from_anchor(&self) -> &[f64] {
        &self.from_anchor
    }

    /// The anchor.
    pub fn anchor(&self) -> BoundaryPoint {
        self.anchor
    }

    /// a = g(x) under the map used: 0 for a fresh one; |a| close to 1 indicates crowding.
    pub fn image(&self) -> Complex {
        self.image
    }

    /// How many vertices have the same measure as the previous one.
    pub fn collapsed(&self) -> usize {
        self.collapsed
    }

    /// How many vertices came before the previous one; they were moved to it.
    pub fn disordered(&self) -> usize {
        self.disordered
    }
}

/// The arguments of φ(e^{iθ}) for φ(z) = (z − a)/(1 − āz), counted from φ(1).
///
/// arg φ(e^{iθ}) = 2 arg(e^{iθ} − a) − θ, which is a number even if a = e^{iθ}.
fn moved_angles(angles: &[f64], a: Complex) -> LiftedAngles {
    let argument = |theta: f64| 2.0 * (Complex::cis(theta) - a).arg() - theta;
    let mut before = argument(0.0);
    let mut sum = 0.0;
    let moved = angles.iter().map(|&theta| {
        let now = argument(theta);
        let step = (now - before).rem_euclid(TAU);
        before = now;
        sum += if step > TAU - STEP_BACK { step - TAU } else { step };
        sum
    });
    LiftedAngles::new(moved.collect())
}

/// Two domains matched through the disk, with one image for each vertex of the mapped boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct DiskComparison {
    mapped: DiskMeasure,
    other: DiskMeasure,
    points: Vec<BoundaryPoint>,
}

impl DiskComparison {
    /// Matches equal measures, both counted from their anchors. O(m + m').
    ///
    /// Where the other measure is constant, as in collapsed parts, the last of the points
    /// with that measure is taken.
    pub fn new(mapped: DiskMeasure, other: DiskMeasure) -> Self {
        let m = mapped.vertex_count();
        let mut points = vec![other.anchor; m];
        let mut interval = 0;
        for (j, &omega) in mapped.from_anchor.iter().enumerate() {
            while interval < other.vertex_count() && omega >= other.from_anchor[interval] {
                interval += 1;
            }
            let at_anchor = j + 1 == m && mapped.anchor.fraction() == 0.0;
            if !at_anchor {
                points[(mapped.anchor.edge() as usize + j + 1) % m] = other.point(interval, omega);
            }
        }
        Self { mapped, other, points }
    }

    /// The measure of the boundary that is mapped.
    pub fn mapped(&self) -> &DiskMeasure {
        &self.mapped
    }

    /// The measure of the other boundary.
    pub fn other(&self) -> &DiskMeasure {
        &self.other
    }

    /// The images on the other boundary, by vertex of the mapped one.
    pub fn points(&self) -> &[BoundaryPoint] {
        &self.points
    }
}

impl DiskMeasure {
    /// The point with measure `omega` in interval `j`: between the vertices `edge + j` and
    /// `edge + j + 1`, cut off at the anchor if j is 0 or m.
    fn point(&self, j: usize, omega: f64) -> BoundaryPoint {
        let m = self.vertex_count();
        let f = self.anchor.fraction();
        let (low, from) = if j == 0 { (0.0, f) } else { (self.from_anchor[j - 1], 0.0) };
        let (high, to) = if j == m { (1.0, f) } else { (self.from_anchor[j], 1.0) };
        let lambda = if high > low { ((omega - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
        let fraction = (from + lambda * (to - from)).min(1.0 - f64::EPSILON);
        BoundaryPoint::new(((self.anchor.edge() as usize + j) % m) as u32, fraction)
    }
}

//! An outline about its centroid, and how far motions move it from itself.

use glam::{DMat2, DVec2};

use super::super::{EdgeTree, SimplePolygon};
use super::SYMMETRY_TOLERANCE;
use super::motion::Motion;

/// The number of points, equally spaced along the boundary, to which motions are fitted.
const SAMPLES: usize = 128;
/// A motion is not fitted if it moves a sample farther than this from the outline: the fan's axes and the centroid of
/// an outline with the largest noise are off by less than half of it.
const OUT_OF_REACH: f64 = 0.1;
/// Deviations are exact up to this.
const RESOLUTION: f64 = 0.01 * SYMMETRY_TOLERANCE;
/// Newton steps of a fit at most. It converges quadratically, in 3 to 5 steps.
const MOST_STEPS: u32 = 12;

/// An outline, moved and scaled so that the centroid of its area is 0 and its largest distance from there 1.
pub struct Centered {
    /// The centroid in the given coordinates.
    pub centroid: DVec2,
    /// The length of 1 in the given coordinates.
    pub size: f64,
    tree: EdgeTree<Vec<DVec2>>,
    samples: Vec<DVec2>,
}

/// A point of the outline after a motion.
#[derive(Clone, Copy)]
struct Moved {
    before: DVec2,
    /// The nearest edge of the outline.
    edge: usize,
    distance: f64,
}

impl Centered {
    pub fn new(polygon: &SimplePolygon) -> Self {
        let centroid = centroid(polygon);
        let size = polygon.vertices().iter().map(|p| p.distance(centroid)).fold(0.0, f64::max);
        let points: Vec<DVec2> = polygon.vertices().iter().map(|p| (p - centroid) / size).collect();
        let samples = equally_spaced(&points, polygon.perimeter() / size);
        Self { centroid, size, tree: EdgeTree::new(points), samples }
    }

    /// The difference of the largest and the least distance from the centroid, where that is within the tolerance.
    pub fn circle(&self) -> Option<f64> {
        let deviation = 1.0 - self.tree.signed_distance(DVec2::ZERO);
        (deviation <= SYMMETRY_TOLERANCE).then_some(deviation)
    }

    /// The motion, fitted to the outline, and the largest deviation of its powers, where that is within the tolerance:
    /// a reflection has none, and the turn of a round outline may fit where twice that turn does not.
    pub fn verified(&self, start: Motion) -> Option<(Motion, f64)> {
        let motion = self.fitted(start)?;
        if !motion.powers().all(|power| self.few_are_within(power)) {
            return None;
        }
        let within = |most: f64, power: Motion| Some(most.max(self.deviation(power)?));
        Some((motion, motion.powers().try_fold(0.0, within)?))
    }

    /// The sum of the squares of the samples' distances from the outline after the motion; `None` if one is out of
    /// reach.
    pub fn misfit(&self, motion: Motion) -> Option<f64> {
        self.samples.iter().try_fold(0.0, |sum, &p| {
            let distance = self.moved(motion, p).distance;
            (distance <= OUT_OF_REACH).then_some(sum + distance * distance)
        })
    }

    /// The motion of least misfit next to `motion`, by the Gauss–Newton method on the distances along the normals.
    fn fitted(&self, mut motion: Motion) -> Option<Motion> {
        let mut misfit = self.misfit(motion)?;
        for _ in 0..MOST_STEPS {
            let next = motion.moved(self.step(motion));
            match self.misfit(next) {
                Some(less) if less < misfit => (motion, misfit) = (next, less),
                _ => break,
            }
        }
        Some(motion)
    }

    /// The step of the parameters to the least sum of squares of the linearized distances.
    fn step(&self, motion: Motion) -> DVec2 {
        let (mut matrix, mut right) = (DMat2::ZERO, DVec2::ZERO);
        for &p in &self.samples {
            let image = motion.image(p);
            let nearest = self.tree.nearest_point(image);
            let (a, b) = self.edge(nearest.edge);
            let away = image - (a + nearest.fraction * (b - a));
            let is_beside_end = nearest.fraction == 0.0 || nearest.fraction == 1.0;
            let normal =
                if is_beside_end && nearest.distance > RESOLUTION { away } else { (b - a).perp() }.normalize_or_zero();
            let slope = DVec2::from_array(motion.slopes(p).map(|by| by.dot(normal)));
            matrix += DMat2::from_cols(slope * slope.x, slope * slope.y);
            right -= slope * away.dot(normal);
        }
        let ridge = f64::EPSILON * (matrix.x_axis.x + matrix.y_axis.y) + f64::MIN_POSITIVE;
        (matrix + DMat2::from_diagonal(DVec2::splat(ridge))).inverse() * right
    }

    /// Whether the motion moves some vertices, all over the outline, and the samples by no more than the tolerance.
    fn few_are_within(&self, motion: Motion) -> bool {
        let points = self.tree.points();
        let few = points.iter().step_by(points.len() / SAMPLES + 1);
        few.chain(&self.samples).all(|&p| self.moved(motion, p).distance <= SYMMETRY_TOLERANCE)
    }

    /// The largest distance of the moved outline from the outline, up to [`RESOLUTION`]; `None` if it exceeds the
    /// tolerance.
    fn deviation(&self, motion: Motion) -> Option<f64> {
        let points = self.tree.points();
        let (mut most, mut start) = (0.0, self.moved(motion, points[0]));
        for k in 1..=points.len() {
            let end = self.moved(motion, points[k % points.len()]);
            most = self.over_edge(motion, start, end, most);
            if most > SYMMETRY_TOLERANCE {
                return None;
            }
            start = end;
        }
        Some(most)
    }

    /// `most`, or the largest distance of the moved edge from `start` to `end` from the outline, if that is larger.
    ///
    /// Distances of points ℓ apart differ by ℓ at most, so that none between them exceeds (d₀ + d₁ + ℓ)/2; and the
    /// distance to one edge is convex. What that leaves open is halved.
    fn over_edge(&self, motion: Motion, start: Moved, end: Moved, most: f64) -> f64 {
        let most = most.max(start.distance).max(end.distance);
        let bound = 0.5 * (start.distance + end.distance + start.before.distance(end.before));
        if start.edge == end.edge || bound <= most + RESOLUTION || most > SYMMETRY_TOLERANCE {
            return most;
        }
        let middle = self.moved(motion, start.before.midpoint(end.before));
        let most = self.over_edge(motion, start, middle, most);
        self.over_edge(motion, middle, end, most)
    }

    fn moved(&self, motion: Motion, before: DVec2) -> Moved {
        let nearest = self.tree.nearest_point(motion.image(before));
        Moved { before, edge: nearest.edge, distance: nearest.distance }
    }

    fn edge(&self, k: usize) -> (DVec2, DVec2) {
        let points = self.tree.points();
        (points[k], points[(k + 1) % points.len()])
    }
}

/// The centroid of the area, summed from the first vertex; the middle of the box if the area is 0 when rounded.
fn centroid(polygon: &SimplePolygon) -> DVec2 {
    let origin = polygon.vertices()[0];
    let triangles = polygon.edges().map(|(a, b)| (a - origin, b - origin)).map(|(a, b)| (a.perp_dot(b), a + b));
    let (twice, moment) =
        triangles.fold((0.0, DVec2::ZERO), |(area, sum), (twice, ends)| (area + twice, sum + twice * ends));
    if twice > 0.0 { origin + moment / (3.0 * twice) } else { polygon.bounds().center() }
}

/// [`SAMPLES`] points of the closed polygon, at equal distances along it; `length` is that of all edges.
fn equally_spaced(points: &[DVec2], length: f64) -> Vec<DVec2> {
    let mut samples = Vec::with_capacity(SAMPLES);
    let step = length / SAMPLES as f64;
    let mut before = 0.0;
    for (k, &a) in points.iter().enumerate() {
        let b = points[(k + 1) % points.len()];
        let edge = a.distance(b);
        while samples.len() < SAMPLES && (samples.len() as f64 + 0.5) * step <= before + edge {
            samples.push(a.lerp(b, ((samples.len() as f64 + 0.5) * step - before) / edge));
        }
        before += edge;
    }
    samples
}

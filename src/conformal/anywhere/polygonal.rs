//! The map inside of a sampled polygon with images that are linear on its edges, for measures from finite elements.
//!
//! f is Cauchy's integral over the edges, f′ = Σ (Δw/Δv) log((v_{k+1} − z)/(v_k − z))/(2πi), and an error that is
//! e_k on edge k one of f of at most Σ e_k |log((v_{k+1} − z)/(v_k − z))|/(2π); errors that change their sign within an
//! edge may add up to more.

use super::{InteriorImage, NoInteriorMap};
use crate::cauchy_integral::Evaluation;
use crate::conformal::{BoundaryCorrespondence, BoundaryValues, ConformalMap, Contour, Side, match_measures};
use crate::geometry::{Bounds, DVec2, nearest_of_polygon};
use std::f64::consts::{PI, TAU};

/// The error of boundary images from finite elements, in extents of the other side, where no estimate is known: at the
/// defaults 2e-4 in the mean, 2e-3 in the worst place, of V-shape → blob.
const FINITE_ELEMENTS: f64 = 2e-3;
/// The error of linear values, in steps from one image to the next.
const LINEAR: f64 = 0.1;
/// Distances from the polygon, in extents, up to which a point lies on it.
const ON_POLYGON: f64 = 1e-14;

/// The map inside of a polygon.
#[derive(Debug, Clone)]
pub struct PolygonalMap {
    points: Vec<DVec2>,
    images: Vec<DVec2>,
    contour: Contour,
    values: BoundaryValues,
    /// The errors of the images.
    errors: Vec<f64>,
    extent: f64,
}

impl PolygonalMap {
    /// The map of the sampled boundary of `from`. Errors: a side is a surface.
    pub fn new(map: &ConformalMap, from: Side) -> Result<Self, NoInteriorMap> {
        let domain = |side: Side| map.domain(side).ok_or(NoInteriorMap::Surface { side });
        let (own, other) = (domain(from)?.samples(), domain(from.other())?.samples());
        let mut matched = BoundaryCorrespondence::default();
        let correspondence = if from == map.mapped_side() {
            map.correspondence()
        } else {
            match_measures(map.measure(from), map.measure(from.other()), &mut matched);
            &matched
        };
        let images: Vec<DVec2> = correspondence.images(other).collect();
        let extent = |points: &[DVec2]| Bounds::of(points.iter().copied()).size().max_element();
        Ok(Self {
            contour: Contour::new(own.points()),
            values: BoundaryValues::new(images.iter().copied()),
            errors: map
                .boundary_errors(from)
                .unwrap_or_else(|| vec![FINITE_ELEMENTS * extent(&images); own.points().len()]),
            extent: extent(own.points()),
            points: own.points().to_vec(),
            images,
        })
    }

    /// The number of vertices.
    pub fn node_count(&self) -> usize {
        self.points.len()
    }

    /// The image of a point.
    pub fn image(&self, z: DVec2) -> InteriorImage {
        if !z.is_finite() {
            return InteriorImage::Outside;
        }
        if let Some(on) = self.on_boundary(z) {
            return on;
        }
        let (mut turn, mut slope, mut error) = (0.0, DVec2::ZERO, 0.0);
        for k in 0..self.points.len() {
            let next = (k + 1) % self.points.len();
            let (a, b) = (self.points[k] - z, self.points[next] - z);
            let log = DVec2::new(0.5 * (b.length_squared() / a.length_squared()).ln(), a.perp_dot(b).atan2(a.dot(b)));
            let step = self.images[next] - self.images[k];
            turn += log.y;
            slope += times(times(step, conjugate(b - a)) / (b - a).length_squared(), log);
            error += self.error(k) * log.length();
        }
        if turn < PI {
            return InteriorImage::Outside;
        }
        InteriorImage::Inside(Evaluation {
            value: self.contour.evaluate(z, &self.values),
            derivative: DVec2::new(slope.y, -slope.x) / TAU,
            error: error / TAU,
        })
    }

    /// The error of the values on an edge.
    fn error(&self, edge: usize) -> f64 {
        let next = (edge + 1) % self.points.len();
        self.errors[edge].max(self.errors[next]) + LINEAR * self.images[edge].distance(self.images[next])
    }

    /// The image of a point on the polygon.
    fn on_boundary(&self, z: DVec2) -> Option<InteriorImage> {
        let on = nearest_of_polygon(&self.points, z)?;
        let next = (on.edge + 1) % self.points.len();
        let place = self.points[on.edge].lerp(self.points[next], on.along);
        let (a, b) = (self.images[on.edge], self.images[next]);
        let image =
            InteriorImage::Boundary { value: a.lerp(b, on.along), derivative: None, error: self.error(on.edge) };
        (place.distance(z) <= ON_POLYGON * self.extent).then_some(image)
    }
}

fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

fn conjugate(a: DVec2) -> DVec2 {
    DVec2::new(a.x, -a.y)
}

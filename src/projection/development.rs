//! f by integration of f′ = exp Φ over a mesh: along a tree of its edges, and from a vertex to any point beside it.
//!
//! Where the path goes does not matter, since Φ is analytic; edges are short compared to the distance of the poles, so
//! that Gauss's rule of [`NODES`] points leaves rounding errors only.

use super::log_metric;
use super::potential::{Fitted, Potential};
use super::region::Region;
use crate::geometry::{DVec2, gauss_legendre};
use crate::mesh::{MeshError, Sizing, TriMesh, TriangleId, mesh_domain};
use num_complex::Complex64;
use rayon::prelude::*;
use std::collections::VecDeque;

/// The number of nodes on an edge.
const NODES: usize = 6;

/// The growth of triangles with the distance from the boundary: lines of equal scale are then smooth in a picture.
const GROWTH: f64 = 0.03;

/// Boundaries with more than this many points times the growth get coarser triangles, up to the largest growth.
const FINE_BOUNDARY: f64 = 3e5;
const MOST_GROWTH: f64 = 0.5;

/// The step at which the search for the least scale ends, in distances from the boundary: the scale is quadratic there.
const SETTLED: f64 = 1e-8;

/// Places on each edge of the boundary at which log k is taken, beside its ends.
const BETWEEN: u32 = 3;
/// Edges on which an extreme of log k is looked for, and halvings of the step by which that is done.
const POLISHED: usize = 16;
const HALVINGS: u32 = 30;

/// f, on a mesh.
#[derive(Debug, Clone)]
pub struct Development {
    mesh: TriMesh,
    potential: Potential,
    residual: f64,
    /// The largest log k on the boundary.
    most: f64,
    /// log k at the vertices.
    logs: Vec<f64>,
    images: Vec<DVec2>,
    rule: Vec<(f64, f64)>,
}

impl Development {
    pub fn new(region: &Region, fitted: Fitted) -> Result<Self, MeshError> {
        let Fitted { potential, residual } = fitted;
        let boundary = region.polygon().vertices();
        let growth = (boundary.len() as f64 / FINE_BOUNDARY).clamp(GROWTH, MOST_GROWTH);
        let (mesh, _) = mesh_domain(boundary, Sizing::Graded(growth))?;
        let log = |&z: &DVec2| potential.value(z).re - log_metric(z);
        let logs: Vec<f64> = mesh.vertices().par_iter().map(log).collect();
        let rule = gauss_legendre(NODES);
        let [lowest, most] = boundary_extremes(boundary, &|z| log(&z));
        let residual = residual.max(most).max(-lowest);
        let mut development = Self { mesh, potential, residual, most, logs, images: Vec::new(), rule };
        development.images = development.integrated();
        Ok(development)
    }

    /// The images of the vertices, from that of vertex 0 at the origin.
    fn integrated(&self) -> Vec<DVec2> {
        let tree = tree(&self.mesh);
        let vertices = self.mesh.vertices();
        let along = |&[from, to]: &[u32; 2]| self.integral(vertices[from as usize], vertices[to as usize]);
        let steps: Vec<DVec2> = tree.par_iter().map(along).collect();
        let mut images = vec![DVec2::ZERO; vertices.len()];
        for ([from, to], step) in tree.into_iter().zip(steps) {
            images[to as usize] = images[from as usize] + step;
        }
        images
    }

    /// ∫ f′ dz along a segment, twice the radius of the sphere being 1 in `log_metric`.
    fn integral(&self, a: DVec2, b: DVec2) -> DVec2 {
        let (middle, half) = (a.midpoint(b), 0.5 * (b - a));
        let term = |&(x, weight): &(f64, f64)| weight * self.potential.value(middle + x * half).exp();
        let sum: Complex64 = self.rule.iter().map(term).sum();
        let product = 2.0 * sum * Complex64::new(half.x, half.y);
        DVec2::new(product.re, product.im)
    }

    /// Moves the image such that that of `origin` is 0, and turns it such that the direction `up` there becomes that of y.
    #[must_use]
    pub fn placed(mut self, origin: DVec2, up: DVec2) -> Self {
        let turned = self.potential.value(origin).im + up.to_angle();
        let turn = std::f64::consts::FRAC_PI_2 - turned;
        self.potential = self.potential.plus(Complex64::new(0.0, turn));
        let rotation = DVec2::from_angle(turn);
        self.images.iter_mut().for_each(|p| *p = rotation.rotate(*p));
        let at = crate::mesh::locate(&self.mesh, origin, None);
        let middle = at.map_or(DVec2::ZERO, |at| self.image(origin, at.triangle()));
        self.images.iter_mut().for_each(|p| *p -= middle);
        self
    }

    /// The image of a point of this triangle.
    pub fn image(&self, z: DVec2, triangle: TriangleId) -> DVec2 {
        let places = self.mesh.corner_places(triangle);
        let corners = self.mesh.corners(triangle);
        let nearest = (1..3).fold(0, |best, k| if places[k].distance(z) < places[best].distance(z) { k } else { best });
        self.images[corners[nearest].index()] + self.integral(places[nearest], z)
    }

    /// log k at a point.
    pub fn log_scale(&self, z: DVec2) -> f64 {
        self.potential.value(z).re - log_metric(z)
    }

    /// The point of least scale and log k there: the least vertex, and a compass search from it.
    pub fn least(&self, region: &Region) -> (DVec2, f64) {
        let start = (0..self.logs.len()).fold(0, |best, k| if self.logs[k] < self.logs[best] { k } else { best });
        let mut best = (self.mesh.vertices()[start], self.logs[start]);
        let room = region.signed_distance(best.0);
        let mut step = 0.3 * room;
        while step > SETTLED * room {
            let moved = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|d| best.0 + step * d);
            let better = moved.map(|z| (z, self.log_scale(z))).into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
            match better.filter(|&(z, log)| log < best.1 && region.signed_distance(z) > 0.0) {
                Some(found) => best = found,
                None => step *= 0.5,
            }
        }
        best
    }

    /// The largest log k on the boundary, and so anywhere: log k is subharmonic.
    pub fn most(&self) -> f64 {
        self.most
    }

    /// The largest deviation of log k from 0 on the boundary.
    pub fn residual(&self) -> f64 {
        self.residual
    }

    pub fn mesh(&self) -> &TriMesh {
        &self.mesh
    }

    pub fn images(&self) -> &[DVec2] {
        &self.images
    }

    pub fn logs(&self) -> &[f64] {
        &self.logs
    }

    pub fn boundary_images(&self) -> &[DVec2] {
        &self.images[..self.mesh.boundary_count() as usize]
    }
}

/// The least and the largest value on a closed polygon of a function that is smooth along its edges: at vertices and
/// [`BETWEEN`] places of each edge, then polished by halved steps on the [`POLISHED`] edges with the best of them.
fn boundary_extremes(polygon: &[DVec2], value: &(dyn Fn(DVec2) -> f64 + Sync)) -> [f64; 2] {
    let count = polygon.len();
    let at = |k: usize, share: f64| value(polygon[k].lerp(polygon[(k + 1) % count], share));
    let step = 1.0 / f64::from(BETWEEN + 1);
    let values = |k: usize| (0..=BETWEEN).map(|j| f64::from(j) * step).map(|share| (share, at(k, share))).collect();
    let taken: Vec<Vec<(f64, f64)>> = (0..count).into_par_iter().map(values).collect();
    [-1.0, 1.0].map(|sign| {
        let of_edge = |edge: &Vec<(f64, f64)>| {
            let best = |a: (f64, f64), b: (f64, f64)| if sign * b.1 > sign * a.1 { b } else { a };
            edge.iter().copied().reduce(best).unwrap_or_default()
        };
        let mut best: Vec<(usize, (f64, f64))> = taken.iter().map(of_edge).enumerate().collect();
        best.sort_by(|a, b| (sign * b.1.1).total_cmp(&(sign * a.1.1)));
        let polished =
            best.into_iter().take(POLISHED).map(|(k, start)| polished(start, step, sign, &|share| at(k, share)));
        sign * polished.map(|value| sign * value).fold(f64::NEG_INFINITY, f64::max)
    })
}

/// The extreme of this sign near a place of an edge.
fn polished((mut share, mut best): (f64, f64), mut step: f64, sign: f64, at: &dyn Fn(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        step *= 0.5;
        for next in [share - step, share + step].map(|share| share.clamp(0.0, 1.0)) {
            let value = at(next);
            if sign * value > sign * best {
                (share, best) = (next, value);
                break;
            }
        }
    }
    best
}

/// Edges from a vertex that is reached to one that is not, until all are reached from vertex 0.
fn tree(mesh: &TriMesh) -> Vec<[u32; 2]> {
    let mut around: Vec<Vec<u32>> = vec![Vec::new(); mesh.vertices().len()];
    for &[a, b, c] in mesh.triangles() {
        for (from, to) in [(a, b), (b, c), (c, a), (b, a), (c, b), (a, c)] {
            around[from as usize].push(to);
        }
    }
    let mut reached = vec![false; around.len()];
    reached[0] = true;
    let mut edges = Vec::with_capacity(around.len());
    let mut queue = VecDeque::from([0]);
    while let Some(from) = queue.pop_front() {
        for &to in &around[from as usize] {
            if !std::mem::replace(&mut reached[to as usize], true) {
                edges.push([from, to]);
                queue.push_back(to);
            }
        }
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between the places taken, on the last edge too.
    #[test]
    fn extremes_on_a_boundary_are_found_between_its_points() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from_array);
        for (low, high) in [([0.37, 0.0], [1.0, 0.81]), ([0.0, 0.93], [0.45, 1.0]), ([0.0, 0.06], [1.0, 1.0])] {
            let [low, high] = [low, high].map(DVec2::from_array);
            // −1 at `low` and 1 at `high` only
            let bump = |z: DVec2, at: DVec2| (-200.0 * z.distance_squared(at)).exp();
            let [least, most] = boundary_extremes(&square, &|z| bump(z, high) - bump(z, low));
            assert!((least + 1.0).abs() < 1e-8 && (most - 1.0).abs() < 1e-8, "{low}, {high}: {least}, {most}");
        }
    }
}

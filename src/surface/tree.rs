//! Where a ray meets a surface, and the surface's point nearest to a given one: a tree of boxes over the triangles.
//!
//! The tree is that of obvhs (parallel locally-ordered clustering, Meister and Bittner 2018). Its boxes are in f32,
//! for the surface scaled to unit size, and wider than the triangles; everything else is in f64. Projected along a ray,
//! vertices are points of a plane, and a triangle is hit if it contains the origin of that plane, which is
//! decided exactly: no ray passes between two adjacent triangles (after Woop, Benthin, Wald: "Watertight
//! ray/triangle intersection", 2013). The projected vertices are rounded, so that a ray within 1e-16 of
//! the silhouette may hit or miss.

use super::nearest::nearest_in_triangle;
use crate::geometry::{DVec2, DVec3, orientation, pulled_back};
use crate::mesh::{BarycentricPoint, TriMesh, TriangleId};
use obvhs::aabb::Aabb;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

/// The triangles of a surface, sorted into boxes; 170 bytes per triangle.
#[derive(Debug, Clone)]
pub struct SurfaceTree {
    /// The root comes first; the two children of a box are adjacent.
    boxes: Vec<Bvh2Node>,
    /// Triangle numbers; each box has a range of them.
    order: Vec<u32>,
    triangles: Vec<[DVec3; 3]>,
    /// The map from the surface to the boxes is `(p − middle) · scale`.
    middle: DVec3,
    scale: f64,
}

/// Boxes are wider than their triangles by this much on every side, for a surface of size 1: f32 is rounded by
/// 3e-8 there, and the tests of boxes in f64 by less than 1e-14.
const WIDENING: f64 = 1e-7;

/// A point of the surface is hidden if the ray hits something nearer by more than this part of its distance: a point
/// on a triangle is rounded by 1e-15, and within a pixel of a silhouette depths differ by 1e-4.
const HIDDEN: f64 = 1e-5;

impl SurfaceTree {
    /// Sorts the triangles; all positions must be finite. Cost O(n log n).
    pub fn new(mesh: &TriMesh<DVec3>) -> Self {
        Self::of(mesh.triangles().iter().map(|t| t.map(|v| mesh.vertices()[v as usize])).collect())
    }

    /// As [`Self::new`], from the corners of triangles.
    pub(crate) fn of(triangles: Vec<[DVec3; 3]>) -> Self {
        let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = triangles.iter().flatten().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
        let extent = (high - low).max_element();
        let (middle, scale) = (low.midpoint(high), if extent > 0.0 { extent.recip() } else { 1.0 });
        let boxes: Vec<_> = triangles.iter().map(|&corners| bounds(corners.map(|p| (p - middle) * scale))).collect();
        let numbers = (0..triangles.len() as u32).collect();
        let tree = PlocBuilder::new().build(PlocSearchDistance::Low, &boxes, numbers, SortPrecision::U64, 0);
        Self { boxes: tree.nodes, order: tree.primitive_indices, triangles, middle, scale }
    }

    /// The first point of the surface on the ray, from either side, and its distance from `origin`.
    ///
    /// The direction's length does not matter. `None` where nothing is hit, or the ray is not finite or has
    /// no direction. Cost O(log n) for most rays.
    pub fn ray(&self, origin: DVec3, direction: DVec3) -> Option<(BarycentricPoint, f64)> {
        let ray = Ray::new(origin, direction)?;
        let (start, inverse) = (self.to_boxes(origin), ray.direction.recip());
        let enters = |node: &Bvh2Node| enter(node, start, inverse) / self.scale;
        self.least(enters, |corners| ray.meets(corners))
    }

    /// The point of the surface nearest to `place`, and its distance; `None` if `place` is not finite.
    ///
    /// For a `place` farther than a million extents of the surface, the result is the point nearest to the position at
    /// that distance in its direction; a distance beyond 1e154 is ∞.
    pub fn nearest(&self, place: DVec3) -> Option<(BarycentricPoint, f64)> {
        if !place.is_finite() {
            return None;
        }
        let half = DVec3::splat(0.5 / self.scale);
        let (point, _) = self.nearest_to(pulled_back(place, self.middle - half, self.middle + half))?;
        let found = weighted(self.triangles[point.triangle().index()], point.weights());
        Some((point, found.distance(place)))
    }

    fn nearest_to(&self, place: DVec3) -> Option<(BarycentricPoint, f64)> {
        let scaled = self.to_boxes(place);
        let distance = |node: &Bvh2Node| {
            let (low, high) = corners(node);
            scaled.distance(scaled.clamp(low, high)) / self.scale
        };
        self.least(distance, |corners| {
            let weights = nearest_in_triangle(corners, place);
            Some((weights, weighted(corners, weights).distance(place)))
        })
    }

    /// Whether the surface lies between `eye` and `place`, which may itself be a point of the surface.
    pub fn hides(&self, eye: DVec3, place: DVec3) -> bool {
        let distance = eye.distance(place);
        self.ray(eye, place - eye).is_some_and(|(_, first)| first < (1.0 - HIDDEN) * distance)
    }

    fn to_boxes(&self, place: DVec3) -> DVec3 {
        (place - self.middle) * self.scale
    }

    /// The triangle of least distance; `bound` gives a lower bound for a box (∞: skip the box).
    fn least(
        &self,
        bound: impl Fn(&Bvh2Node) -> f64,
        distance: impl Fn([DVec3; 3]) -> Option<([f64; 3], f64)>,
    ) -> Option<(BarycentricPoint, f64)> {
        let nodes = &self.boxes;
        let (mut best, mut least) = (None, f64::INFINITY);
        let mut pending: Vec<(f64, &Bvh2Node)> = nodes.first().map(|root| (bound(root), root)).into_iter().collect();
        while let Some((from, node)) = pending.pop() {
            if from >= least {
                continue;
            }
            let first = node.first_index as usize;
            if node.prim_count == 0 {
                let mut children = [&nodes[first], &nodes[first + 1]].map(|child| (bound(child), child));
                if children[0].0 < children[1].0 {
                    children.reverse();
                }
                pending.extend(children);
                continue;
            }
            for &triangle in &self.order[first..first + node.prim_count as usize] {
                if let Some((weights, distance)) = distance(self.triangles[triangle as usize])
                    && distance < least
                {
                    (best, least) = (Some(BarycentricPoint::new(TriangleId::new(triangle), weights)), distance);
                }
            }
        }
        best.map(|point| (point, least))
    }
}

/// The widened box of a triangle.
fn bounds([a, b, c]: [DVec3; 3]) -> Aabb {
    let (low, high) = (a.min(b).min(c) - WIDENING, a.max(b).max(c) + WIDENING);
    Aabb::new(low.as_vec3a(), high.as_vec3a())
}

fn corners(node: &Bvh2Node) -> (DVec3, DVec3) {
    (node.aabb.min.as_dvec3(), node.aabb.max.as_dvec3())
}

/// The distance along a ray at which it enters a box; ∞ if it misses the box.
fn enter(node: &Bvh2Node, start: DVec3, inverse: DVec3) -> f64 {
    let (low, high) = corners(node);
    let (near, far) = ((low - start) * inverse, (high - start) * inverse);
    // 0·∞ need not be avoided: a ray in the plane of a side is within the widening, where either answer is correct
    let (enter, leave) = (near.min(far).max_element().max(0.0), near.max(far).min_element());
    if enter <= leave { enter } else { f64::INFINITY }
}

fn weighted(corners: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    corners.iter().zip(weights).map(|(&p, w)| w * p).sum()
}

/// A ray, with the plane onto which triangles are projected along it.
struct Ray {
    origin: DVec3,
    direction: DVec3,
    across: [DVec3; 2],
}

impl Ray {
    fn new(origin: DVec3, direction: DVec3) -> Option<Self> {
        let direction = direction.try_normalize().filter(|_| origin.is_finite())?;
        let (right, up) = direction.any_orthonormal_pair();
        Some(Self { origin, direction, across: [right, up] })
    }

    /// The weights of the point where the ray meets a triangle (edges included), and its distance.
    fn meets(&self, corners: [DVec3; 3]) -> Option<([f64; 3], f64)> {
        let corners = corners.map(|p| p - self.origin);
        let [a, b, c] = corners.map(|p| DVec2::new(p.dot(self.across[0]), p.dot(self.across[1])));
        let sides = [(b, c), (c, a), (a, b)].map(|(p, q)| orientation(p, q, DVec2::ZERO));
        let inside = sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0);
        let sum: f64 = sides.iter().sum();
        if !inside || sum == 0.0 {
            return None;
        }
        let weights = sides.map(|side| side / sum);
        let distance = weighted(corners, weights).dot(self.direction);
        (distance >= 0.0 && distance.is_finite()).then_some((weights, distance))
    }
}

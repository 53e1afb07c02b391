//! Point location by walking.
//!
//! A visibility walk (step across any edge that has the point on its far side)
//! ends in a Delaunay mesh for every order of the edges. In a domain that is
//! not convex the walk can reach the boundary first. Then the boundary polygon
//! decides exactly whether the point is inside; if so, the walk starts again from
//! the boundary edge visible from the point on its left; if that fails too, all
//! triangles are tried. Orientation tests are exact, so a point of the closed
//! domain is always found, also on edges and vertices; points outside by no more
//! than rounding ([`BOUNDARY_TOLERANCE`]) are moved onto the boundary.
//! Cost: a few steps from a near hint; O(m) when blocked; O(n) in the worst case.

use super::TriangleId;
use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::{DVec2, MAX_COORDINATE, nearest_of_polygon, on_segment, orientation};

/// A point of a triangle, given by the weights of the triangle's three corners.
///
/// For a point located on a mesh, the weights are non-negative and sum to 1 up to rounding, and the triangle is one
/// of the mesh. A point from a link or a file is checked where the mesh is known: by the map.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct BarycentricPoint {
    triangle: TriangleId,
    weights: [f64; 3],
}

/// How far outside a point may be, relative to the largest coordinate: points
/// computed on an edge are off by 1e-16, and 1e-12 is invisible.
pub(super) const BOUNDARY_TOLERANCE: f64 = 1e-12;

/// The triangle that contains `x`, walking from triangle `hint`; `None` outside the mesh.
///
/// Any `hint`, or none, gives a correct answer; the triangle of the previous answer is the fastest hint.
pub fn locate(mesh: &TriMesh, x: DVec2, hint: Option<TriangleId>) -> Option<BarycentricPoint> {
    // beyond the largest coordinate of an outline the predicates would overflow; NaN fails the comparison too
    if !(x.abs().max_element() <= MAX_COORDINATE && x.is_finite()) {
        return None;
    }
    let found = containing(mesh, x, hint.map_or(0, TriangleId::number));
    found.map(|t| barycentric(mesh, x, t)).or_else(|| at_boundary(mesh, x))
}

/// A triangle that contains the finite point `x`, exactly.
pub(super) fn containing(mesh: &TriMesh, x: DVec2, hint: u32) -> Option<u32> {
    let start = if (hint as usize) < mesh.triangles.len() { hint } else { 0 };
    walk(mesh, x, start).or_else(|| search(mesh, x))
}

/// Walks until the triangle contains `x`; `None` when the walk reaches the boundary.
fn walk(mesh: &TriMesh, x: DVec2, start: u32) -> Option<u32> {
    let (mut t, mut from) = (start, NO_TRIANGLE);
    // a visibility walk visits no triangle twice
    for step in 0..=mesh.triangles.len() {
        let neighbours = mesh.neighbours[t as usize];
        // Alternating the first edge keeps the walk from following one side.
        let mut edges = [0, 1, 2];
        edges.rotate_left(step % 3);
        let beyond = |&i: &usize| (neighbours[i] != from || from == NO_TRIANGLE) && is_beyond(mesh, x, t, i);
        let Some(i) = edges.into_iter().find(beyond) else { return Some(t) };
        if neighbours[i] == NO_TRIANGLE {
            // the edge is on the boundary: another edge may have `x` on its far side
            let detour = edges.into_iter().filter(|&j| neighbours[j] != NO_TRIANGLE).find(beyond)?;
            (from, t) = (t, neighbours[detour]);
        } else {
            (from, t) = (t, neighbours[i]);
        }
    }
    None
}

/// Whether `x` is strictly on the far side of the edge opposite to corner `i`.
fn is_beyond(mesh: &TriMesh, x: DVec2, t: u32, i: usize) -> bool {
    let triangle = mesh.triangles[t as usize];
    let (a, b) = (mesh.vertices[triangle[(i + 1) % 3] as usize], mesh.vertices[triangle[(i + 2) % 3] as usize]);
    orientation(a, b, x) < 0.0
}

/// Finds the triangle of an `x` that the walk could not reach.
fn search(mesh: &TriMesh, x: DVec2) -> Option<u32> {
    let left = edge_on_the_left(mesh, x)?;
    let start = triangle_at_edge(mesh, left)?;
    let all = || (0..mesh.triangles.len() as u32).find(|&t| (0..3).all(|i| !is_beyond(mesh, x, t, i)));
    walk(mesh, x, start).or_else(all)
}

/// For an `x` of the closed domain, the first boundary edge to the left of it (or on it); `None` outside.
fn edge_on_the_left(mesh: &TriMesh, x: DVec2) -> Option<u32> {
    let m = mesh.boundary_count as usize;
    let (mut inside, mut nearest) = (false, None);
    for k in 0..m {
        let (a, b) = (mesh.vertices[k], mesh.vertices[(k + 1) % m]);
        if on_segment(a, b, x) {
            return Some(k as u32);
        }
        if (a.y <= x.y) == (b.y <= x.y) {
            continue;
        }
        let to_the_left = (orientation(a, b, x) > 0.0) == (b.y <= a.y);
        if to_the_left {
            inside = !inside;
            let at = a.x + (b.x - a.x) * ((x.y - a.y) / (b.y - a.y));
            if nearest.is_none_or(|(best, _)| at > best) {
                nearest = Some((at, k as u32));
            }
        }
    }
    nearest.filter(|_| inside).map(|(_, k)| k)
}

/// The triangle at the boundary edge `k → k+1`.
///
/// O(m) in meshes of [`super::mesh_domain`], where triangles at the boundary come first.
pub(super) fn triangle_at_edge(mesh: &TriMesh, k: u32) -> Option<u32> {
    let next = (k + 1) % mesh.boundary_count;
    let has_edge = |t: &[u32; 3]| (0..3).any(|i| t[i] == k && t[(i + 1) % 3] == next);
    mesh.triangles.iter().position(has_edge).map(|t| t as u32)
}

/// The edge nearest to `x`, the nearest point of it, and its distance.
pub(super) fn nearest_on_boundary(mesh: &TriMesh, x: DVec2) -> (u32, DVec2, f64) {
    let nearest = nearest_of_polygon(&mesh.vertices[..mesh.boundary_count as usize], x);
    let (edge, point) = nearest.map_or((0, mesh.vertices[0]), |point| (point.edge as u32, point.place.truncate()));
    (edge, point, point.distance(x))
}

/// A point outside the mesh by no more than rounding, moved onto the boundary; `None` if it is farther outside.
fn at_boundary(mesh: &TriMesh, x: DVec2) -> Option<BarycentricPoint> {
    let (edge, point, distance) = nearest_on_boundary(mesh, x);
    let size = mesh.vertices[..mesh.boundary_count as usize].iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    if distance > BOUNDARY_TOLERANCE * size {
        return None;
    }
    Some(barycentric(mesh, point, triangle_at_edge(mesh, edge)?))
}

/// The weights of `x`, which is in triangle `t` up to rounding.
fn barycentric(mesh: &TriMesh, x: DVec2, t: u32) -> BarycentricPoint {
    let corners = mesh.triangles[t as usize].map(|v| mesh.vertices[v as usize]);
    BarycentricPoint::new(TriangleId::new(t), weights_in(corners, x))
}

/// The weights of `x` in a counter-clockwise triangle that contains it up to rounding; not finite if its area is 0.
pub(super) fn weights_in([a, b, c]: [DVec2; 3], x: DVec2) -> [f64; 3] {
    let areas = [orientation(b, c, x), orientation(c, a, x), orientation(a, b, x)].map(|area| area.max(0.0));
    let total = areas[0] + areas[1] + areas[2];
    areas.map(|area| area / total)
}

impl BarycentricPoint {
    /// The point with these weights of the triangle's corners.
    pub const fn new(triangle: TriangleId, weights: [f64; 3]) -> Self {
        Self { triangle, weights }
    }

    /// The triangle that contains the point.
    pub const fn triangle(&self) -> TriangleId {
        self.triangle
    }

    /// The weights of its three corners.
    pub const fn weights(&self) -> [f64; 3] {
        self.weights
    }

    /// The point in the plane.
    pub fn position(&self, mesh: &TriMesh) -> DVec2 {
        let corners = mesh.corner_places(self.triangle);
        (0..3).map(|i| self.weights[i] * corners[i]).sum()
    }
}

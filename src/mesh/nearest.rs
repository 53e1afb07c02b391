//! The interior point that a handle goes to when the pointer leaves the domain.

use super::locate::{locate, nearest_on_boundary, triangle_at_edge};
use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec2;

/// Halvings of the inset before the fallback: 2⁻⁴⁰ of a sensible inset is less than any channel that can be seen.
const HALVINGS: usize = 40;

/// The point strictly inside the mesh that is near `x` and keeps the distance `inset` from the boundary.
///
/// An `x` far enough inside is returned as it is. Else the nearest point of the
/// boundary is moved inward along the normal (the bisector at a vertex) by `inset`, or by
/// `inset/2, inset/4, …` where the domain is narrower; if nothing fits, it is
/// the centroid of the triangle at the nearest edge. In a convex corner the
/// distance to the other side may be less than `inset`, but not zero.
/// Cost O(m) in meshes of [`super::mesh_domain`].
pub fn nearest_inside(mesh: &TriMesh, x: DVec2, inset: f64) -> DVec2 {
    let x = if x.is_finite() { x } else { DVec2::ZERO };
    let (edge, foot, distance) = nearest_on_boundary(mesh, x);
    let Some(triangle) = triangle_at_edge(mesh, edge) else { return foot };
    if distance >= inset && distance > 0.0 && locate(mesh, x, triangle).is_some() {
        return x;
    }
    let inward = inward_direction(mesh, edge, foot);
    let step = |halvings: usize| inset * 0.5f64.powi(halvings as i32);
    // half the step: between two walls of a channel the other wall is that near
    let clear =
        |p: &DVec2, step: f64| nearest_on_boundary(mesh, *p).2 > 0.5 * step && locate(mesh, *p, triangle).is_some();
    let moved = (0..HALVINGS).map(|k| (foot + step(k) * inward, step(k))).find(|(p, step)| clear(p, *step));
    moved.map_or_else(|| centroid(mesh, triangle), |(p, _)| p)
}

/// The inner normal of the edge, or the mean of two where `foot` is a vertex.
fn inward_direction(mesh: &TriMesh, edge: u32, foot: DVec2) -> DVec2 {
    let m = mesh.boundary_count;
    let vertex = |k: u32| mesh.vertices[(k % m) as usize];
    let normal = |k: u32| (vertex(k + 1) - vertex(k)).normalize_or_zero().perp();
    let own = normal(edge);
    let other = if foot == vertex(edge) {
        normal(edge + m - 1)
    } else if foot == vertex(edge + 1) {
        normal(edge + 1)
    } else {
        own
    };
    (own + other).try_normalize().unwrap_or(own)
}

fn centroid(mesh: &TriMesh, triangle: u32) -> DVec2 {
    // next to the boundary rather than at it where there is such a triangle
    let inner = mesh.neighbours[triangle as usize].into_iter().find(|&t| t != NO_TRIANGLE).unwrap_or(triangle);
    let corners = mesh.triangles[inner as usize].map(|v| mesh.vertices[v as usize]);
    (corners[0] + corners[1] + corners[2]) / 3.0
}

//! The interior point that a handle goes to when the pointer leaves the domain.

use super::locate::{containing, nearest_on_boundary, triangle_at_edge};
use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec2;

/// Halvings of the inset before the fallback: 2⁻⁴⁰ of a sensible inset is less than any channel that can be seen.
const HALVINGS: usize = 40;

/// Projections tried per inset: in a corner the first leads to one side, the second to the other.
const PROJECTIONS: usize = 4;

/// The point strictly inside the mesh that is near `x` and keeps the distance `inset` from the boundary.
///
/// An `x` far enough inside is returned as it is. Else it is moved to the
/// nearest point of the boundary and inward from there along the normal (the
/// bisector at a vertex), again if another side is too near then. Where the
/// domain is too narrow the inset is halved until something fits, or else
/// the centroid of a triangle near by is taken. Cost O(m) in meshes of
/// [`super::mesh_domain`].
pub fn nearest_inside(mesh: &TriMesh, x: DVec2, inset: f64) -> DVec2 {
    let x = if x.is_finite() { x } else { DVec2::ZERO };
    let (edge, foot, _) = nearest_on_boundary(mesh, x);
    let Some(triangle) = triangle_at_edge(mesh, edge) else { return foot };
    let insets = (0..HALVINGS).map(|k| inset.abs() * 0.5f64.powi(k as i32));
    let mut fitting = insets.filter_map(|inset| project(mesh, x, inset, triangle));
    fitting.next().unwrap_or_else(|| centroid(mesh, triangle))
}

/// Moves `x` inward until it is `inset` away from every edge, if a few steps do.
fn project(mesh: &TriMesh, x: DVec2, inset: f64, hint: u32) -> Option<DVec2> {
    let mut p = x;
    for _ in 0..PROJECTIONS {
        let (edge, foot, distance) = nearest_on_boundary(mesh, p);
        // the moved point's distance is the inset up to rounding
        if distance > 0.999 * inset && distance > 0.0 && containing(mesh, p, hint).is_some() {
            return Some(p);
        }
        p = foot + inset * inward_direction(mesh, edge, foot);
    }
    None
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

//! The interior point to which a handle is moved when the pointer leaves the domain.

use super::locate::{containing, nearest_on_boundary, triangle_at_edge};
use super::tri_mesh::{NO_TRIANGLE, TriMesh};
use crate::geometry::DVec2;

/// Halvings of the inset before the fallback: 2⁻⁴⁰ of a sensible inset is less than any channel that can be seen.
const HALVINGS: usize = 40;

/// Projections tried per inset: in a corner the first leads to one side, the second to the other.
const PROJECTIONS: usize = 4;

/// Part of the inset that is accepted when the projections do not converge, as in spikes and
/// channels narrower than twice the inset.
const LEAST_PART: f64 = 1.0 / 16.0;

/// In a sharp corner the point at distance `inset` from both edges is `inset / sin(half the
/// angle)` from the corner; beyond 8 insets (14°) a handle would visibly jump.
const LONGEST_MITER: f64 = 8.0;

/// A point strictly inside the mesh, near `x`, at distance `inset` from the boundary or more.
///
/// An `x` far enough inside is returned unchanged. Otherwise it is moved to the
/// nearest point of the boundary and inward from there along the normal (the
/// bisector at a vertex), again if it is then too near another side. Where the
/// domain is too narrow the distance may be as small as 1/16 of `inset`; where even that
/// does not fit, `inset` is halved, and the last fallback is the centroid of a nearby
/// triangle. Cost O(m) in meshes of [`super::mesh_domain`].
pub fn nearest_inside(mesh: &TriMesh, x: DVec2, inset: f64) -> DVec2 {
    let x = if x.is_finite() { x } else { DVec2::ZERO };
    let (edge, foot, _) = nearest_on_boundary(mesh, x);
    let Some(triangle) = triangle_at_edge(mesh, edge) else { return foot };
    let insets = (0..HALVINGS).map(|k| inset.abs() * 0.5f64.powi(k as i32));
    let mut fitting = insets.filter_map(|inset| project(mesh, x, inset, triangle));
    fitting.next().unwrap_or_else(|| centroid(mesh, triangle))
}

/// Moves `x` inward until it is `inset` away from every edge; if that fails, the deepest point of the attempts.
fn project(mesh: &TriMesh, x: DVec2, inset: f64, hint: u32) -> Option<DVec2> {
    let (mut p, mut deepest) = (x, (LEAST_PART * inset, None));
    for _ in 0..=PROJECTIONS {
        let (edge, foot, distance) = nearest_on_boundary(mesh, p);
        if distance > deepest.0 && containing(mesh, p, hint).is_some() {
            deepest = (distance, Some(p));
        }
        // the moved point's distance is the inset up to rounding
        if deepest.0 > 0.999 * inset {
            break;
        }
        p = foot + inset * inward(mesh, edge, foot);
    }
    deepest.1
}

/// The vector from `foot` to the point at distance 1 from its edge, or from both edges if `foot` is a vertex.
fn inward(mesh: &TriMesh, edge: u32, foot: DVec2) -> DVec2 {
    let m = mesh.boundary_count;
    let vertex = |k: u32| mesh.vertices[(k % m) as usize];
    let normal = |k: u32| (vertex(k + 1) - vertex(k)).normalize_or_zero().perp();
    let (before, after) = if foot == vertex(edge) {
        (normal(edge + m - 1), normal(edge))
    } else if foot == vertex(edge + 1) {
        (normal(edge), normal(edge + 1))
    } else {
        (normal(edge), normal(edge))
    };
    let bisector = (before + after).try_normalize().unwrap_or(after);
    // at a re-entrant vertex the nearest point is the vertex itself
    let is_convex = before.perp_dot(after) > 0.0;
    if is_convex { bisector / bisector.dot(after).max(1.0 / LONGEST_MITER) } else { bisector }
}

fn centroid(mesh: &TriMesh, triangle: u32) -> DVec2 {
    // prefer the triangle next to the one at the boundary, if there is one
    let inner = mesh.neighbours[triangle as usize].into_iter().find(|&t| t != NO_TRIANGLE).unwrap_or(triangle);
    let corners = mesh.triangles[inner as usize].map(|v| mesh.vertices[v as usize]);
    (corners[0] + corners[1] + corners[2]) / 3.0
}

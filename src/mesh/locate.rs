//! Point location by walking.

use super::TriMesh;
use crate::geometry::DVec2;

/// A point inside a triangle: weights are non-negative and sum to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BarycentricPoint {
    /// The triangle's index.
    pub triangle: u32,
    /// The weights of its three corners.
    pub weights: [f64; 3],
}

/// The triangle that contains `x`, walking from triangle `hint`; `None` outside the mesh.
pub fn locate(mesh: &TriMesh, x: DVec2, hint: u32) -> Option<BarycentricPoint> {
    let _ = hint; // skeleton: tries all triangles
    mesh.triangles.iter().enumerate().find_map(|(t, &[a, b, c])| {
        let (a, b, c) = (mesh.vertices[a as usize], mesh.vertices[b as usize], mesh.vertices[c as usize]);
        let area = (b - a).perp_dot(c - a);
        let w = [(b - x).perp_dot(c - x) / area, (c - x).perp_dot(a - x) / area, (a - x).perp_dot(b - x) / area];
        w.iter().all(|&w| w >= 0.0).then_some(BarycentricPoint { triangle: t as u32, weights: w })
    })
}

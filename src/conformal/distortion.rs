//! Angle distortion of a piecewise linear map (section 5.1): Q = σ₁/σ₂ per triangle.
//!
//! With the complex derivatives of the linear map on a triangle, σ₁,₂ = |f_z| ± |f_z̄|,
//! and the triangle is flipped where |f_z| < |f_z̄|. Triangles whose image is a point
//! up to rounding have no Q: they are counted as collapsed and left out of the mean.

use crate::geometry::DVec2;
use crate::mesh::TriMesh;

/// An image shorter than this part of the whole image's extent is rounding: the
/// V's far arm has images of 1e-16, resolved triangles start at 1e-9.
const COLLAPSED: f64 = 1e-13;

/// Angle distortion of the mapped mesh, `Q = σ₁/σ₂` per triangle.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Quality {
    /// Mean of Q, weighted by the area in the mapped mesh; 1 is conformal.
    pub q_mean: f64,
    /// The largest Q.
    pub q_max: f64,
    /// How many triangles changed their orientation.
    pub flipped: u32,
    /// How many triangles have an image too small to have an angle; not in the other figures.
    pub collapsed: u32,
}

/// The largest Q that is reported: a triangle flattened to a segment has Q = ∞.
const Q_LIMIT: f64 = 1e9;

impl Quality {
    /// The distortion of the map that takes `mesh.vertices` to `images`.
    pub fn of(mesh: &TriMesh, images: &[DVec2]) -> Self {
        let smallest = COLLAPSED * extent(images);
        let (mut weighted, mut area_sum) = (0.0, 0.0);
        let mut quality = Self { q_mean: 1.0, q_max: 1.0, flipped: 0, collapsed: 0 };
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|v| mesh.vertices[v as usize]);
            let [fa, fb, fc] = triangle.map(|v| images[v as usize]);
            if (fb - fa).length() <= smallest && (fc - fa).length() <= smallest {
                quality.collapsed += 1;
                continue;
            }
            let (u, v) = (b - a, c - a);
            let area = u.perp_dot(v);
            // f_z and f_z̄ times 2·area·i; the common factor drops out of Q
            let (p, q) = (fb - fa, fc - fa);
            let conjugate = |z: DVec2| DVec2::new(z.x, -z.y);
            let holomorphic = (times(p, conjugate(v)) - times(q, conjugate(u))).length();
            let antiholomorphic = (times(q, u) - times(p, v)).length();
            if holomorphic < antiholomorphic {
                quality.flipped += 1;
            }
            let shear = (holomorphic - antiholomorphic).abs();
            let ratio = ((holomorphic + antiholomorphic) / shear).min(Q_LIMIT);
            weighted += area * ratio;
            area_sum += area;
            quality.q_max = quality.q_max.max(ratio);
        }
        if area_sum > 0.0 {
            quality.q_mean = weighted / area_sum;
        }
        quality
    }
}

/// The product of two complex numbers.
fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// The larger side of the bounding box.
fn extent(points: &[DVec2]) -> f64 {
    let low = points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
    let high = points.iter().fold(DVec2::NEG_INFINITY, |high, &p| high.max(p));
    (high - low).max_element()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> TriMesh {
        TriMesh {
            vertices: vec![DVec2::ZERO, DVec2::X, DVec2::new(0.3, 0.7)],
            boundary_count: 3,
            triangles: vec![[0, 1, 2]],
            neighbours: vec![[u32::MAX; 3]],
        }
    }

    fn quality_under(f: impl Fn(DVec2) -> DVec2) -> Quality {
        let mesh = triangle();
        let images: Vec<_> = mesh.vertices.iter().map(|&v| f(v)).collect();
        Quality::of(&mesh, &images)
    }

    #[test]
    fn similarity_has_unit_distortion() {
        let quality = quality_under(|v| times(v, DVec2::new(0.3, -2.0)) + DVec2::ONE);
        assert!((quality.q_mean - 1.0).abs() < 1e-14, "{quality:?}");
        assert_eq!((quality.flipped, quality.collapsed), (0, 0));
    }

    #[test]
    fn stretch_by_three_has_distortion_three() {
        let quality = quality_under(|v| DVec2::new(3.0 * v.x, v.y));
        assert!((quality.q_mean - 3.0).abs() < 1e-14 && (quality.q_max - 3.0).abs() < 1e-14, "{quality:?}");
    }

    #[test]
    fn reflection_is_flipped_and_a_point_image_collapsed() {
        assert_eq!(quality_under(|v| DVec2::new(-v.x, v.y)).flipped, 1);
        assert_eq!(quality_under(|_| DVec2::ONE).collapsed, 1);
    }
}

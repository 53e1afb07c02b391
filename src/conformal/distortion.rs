//! Distortion of a piecewise linear map (section 5.1): Q = σ₁/σ₂ and log₂(σ₁σ₂) per triangle.
//!
//! With the complex derivatives of the linear map on a triangle, σ₁,₂ = |f_z| ± |f_z̄|,
//! and the triangle is flipped where |f_z| < |f_z̄|; σ₁σ₂ is the ratio of the areas.
//! Triangles whose image is a point or a segment up to rounding have no Q: they are counted
//! as collapsed, left out of the mean, and their share of the area is given beside it.

use super::Unfold;
use crate::geometry::{DVec2, DVec3};
use crate::laplace::Deadline;
use crate::mesh::TriMesh;

/// An image whose smallest height is below this fraction of the whole image's extent is rounding: images in the V's far
/// arm are 1e-16 in size, a segment of boundary points has heights of 1e-16; resolved triangles start at 1e-9.
const COLLAPSED: f64 = 1e-13;

/// An image shorter than this many distances that are rounding is a point: with an error of one distance at each corner,
/// the Q of a longer one is right to three digits.
const POINT: f64 = 1e3;

/// With a larger share of the area in triangles without a Q, their mean is not that of the map.
const UNRESOLVED: f64 = 0.01;

/// Triangles between points of a straight side have heights of up to 2.1 ε times their largest coordinate
/// (300,000 random ones, up to 1e9 from the origin); a height below twice that is rounding too.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// Triangles between two checks of the deadline: 0.3 ms.
const BLOCK: usize = 8192;

/// The largest Q that is reported: that of an image 1e-4 of the whole in length, whose height is resolved to 1e-13.
const Q_LIMIT: f64 = 1e9;

/// The largest |log₂(σ₁σ₂)| that is reported; a triangle without area has −∞.
/// 2¹²⁸ is beyond the f64 resolution of any domain that the other triangles still fill.
const AREA_LIMIT: f64 = 128.0;

/// Angle distortion of the mapped mesh, `Q = σ₁/σ₂` per triangle.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(into = "WrittenQuality")]
#[non_exhaustive]
pub struct Quality {
    /// Mean of Q over the triangles that are not collapsed, weighted by the area in the mapped mesh; 1 is conformal. See
    /// [`Self::resolved_mean`].
    pub q_mean: f64,
    /// The largest Q.
    pub q_max: f64,
    /// The number of triangles whose orientation is reversed.
    pub flipped: u32,
    /// The number of triangles whose image is a point or a segment (between two surfaces: in the disk or in space);
    /// these are not part of the other figures.
    pub collapsed: u32,
    /// The share of the area in collapsed triangles, from 0 to 1.
    pub collapsed_area: f64,
}

/// What is written of a [`Quality`]: no mean where it is not resolved.
#[derive(serde::Serialize)]
struct WrittenQuality {
    q_mean: Option<f64>,
    q_max: f64,
    flipped: u32,
    collapsed: u32,
    collapsed_area: f64,
}

impl From<Quality> for WrittenQuality {
    fn from(quality: Quality) -> Self {
        let Quality { q_max, flipped, collapsed, collapsed_area, .. } = quality;
        Self { q_mean: quality.resolved_mean(), q_max, flipped, collapsed, collapsed_area }
    }
}

/// The distortion of one triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TriangleDistortion {
    /// `Q = σ₁/σ₂ ≥ 1`, at most 1e9; 1 where the triangle is collapsed.
    pub q: f64,
    /// `log₂(σ₁σ₂)`, image area over area, within ±128.
    pub area_log2: f64,
    /// The area in the mapped mesh: the triangle's weight in means.
    pub area: f64,
    /// Whether the image has the opposite orientation.
    pub flipped: bool,
    /// Whether the image is a point or a segment up to rounding; such triangles are left out of all means.
    pub collapsed: bool,
}

impl TriangleDistortion {
    /// The distortion of the linear map that takes `corners` (counter-clockwise) to
    /// `images`; collapsed if the smallest height of the image is not above `smallest`, the error of its corners, or all of
    /// it is not a thousand times as long.
    pub fn of([a, b, c]: [DVec2; 3], [fa, fb, fc]: [DVec2; 3], smallest: f64) -> Self {
        let (u, v) = (b - a, c - a);
        let (p, q) = (fb - fa, fc - fa);
        let area = 0.5 * u.perp_dot(v);
        let longest = p.length().max(q.length()).max(p.distance(q));
        if p.perp_dot(q).abs() <= smallest * longest || longest <= POINT * smallest {
            return Self { q: 1.0, area_log2: -AREA_LIMIT, area, flipped: false, collapsed: true };
        }
        // f_z and f_z̄ times 4·area·i; the common factor drops out of Q
        let conjugate = |z: DVec2| DVec2::new(z.x, -z.y);
        let holomorphic = (times(p, conjugate(v)) - times(q, conjugate(u))).length();
        let antiholomorphic = (times(q, u) - times(p, v)).length();
        let (large, small) = (holomorphic + antiholomorphic, (holomorphic - antiholomorphic).abs());
        let scale = 4.0 * area;
        let area_log2 = ((large / scale) * (small / scale)).log2();
        Self {
            q: (large / small).min(Q_LIMIT),
            area_log2: area_log2.clamp(-AREA_LIMIT, AREA_LIMIT),
            area,
            flipped: holomorphic < antiholomorphic,
            collapsed: false,
        }
    }
}

/// The distortion of every triangle of `mesh` under the map that takes its vertices to
/// `images`, in the order of the triangles.
pub fn triangle_distortions<P: Unfold>(mesh: &TriMesh<P>, images: &[DVec2]) -> Vec<TriangleDistortion> {
    let mut result = Vec::new();
    advance_distortions(mesh, images, &mut result, Deadline::NEVER);
    result
}

/// Continues [`triangle_distortions`] after those in `result`, until all are
/// done (true) or `deadline` has passed; computes at least one block.
pub(super) fn advance_distortions<P: Unfold>(
    mesh: &TriMesh<P>,
    images: &[DVec2],
    result: &mut Vec<TriangleDistortion>,
    deadline: Deadline,
) -> bool {
    let smallest = resolution(images);
    in_blocks(mesh.triangles(), result, deadline, |triangle| {
        let corners = P::unfold(triangle.map(|v| mesh.vertices()[v as usize]));
        TriangleDistortion::of(corners, triangle.map(|v| images[v as usize]), smallest)
    })
}

/// As [`advance_distortions`], for a surface whose vertices go to `images` on another one: both triangles are unfolded.
/// A triangle counts as flipped if it is flipped in the `disk`, through which the map goes, and as collapsed if it is
/// collapsed in the disk or in space.
pub(super) fn advance_surface_distortions(
    mesh: &TriMesh<DVec3>,
    images: &[DVec3],
    disk: &[DVec2],
    result: &mut Vec<TriangleDistortion>,
    deadline: Deadline,
) -> bool {
    let (smallest, smallest_in_disk) = (resolution(images), resolution(disk));
    in_blocks(mesh.triangles(), result, deadline, |triangle| {
        let [corners, there] = [mesh.vertices(), images].map(|p| DVec3::unfold(triangle.map(|v| p[v as usize])));
        let found = TriangleDistortion::of(corners, there, smallest);
        let in_disk = TriangleDistortion::of(corners, triangle.map(|v| disk[v as usize]), smallest_in_disk);
        match (found.collapsed, in_disk.collapsed) {
            (false, false) => TriangleDistortion { flipped: in_disk.flipped, ..found },
            (false, true) => in_disk,
            (true, _) => found,
        }
    })
}

/// Continues with the triangles after those whose distortions are in `result`.
fn in_blocks(
    triangles: &[[u32; 3]],
    result: &mut Vec<TriangleDistortion>,
    deadline: Deadline,
    measure: impl Fn(&[u32; 3]) -> TriangleDistortion,
) -> bool {
    result.reserve(triangles.len().saturating_sub(result.len()));
    while result.len() < triangles.len() {
        let end = (result.len() + BLOCK).min(triangles.len());
        result.extend(triangles[result.len()..end].iter().map(&measure));
        if end < triangles.len() && deadline.is_over() {
            return false;
        }
    }
    true
}

impl Quality {
    /// The distortion of the map that takes `mesh.vertices` to `images`.
    pub fn of<P: Unfold>(mesh: &TriMesh<P>, images: &[DVec2]) -> Self {
        Self::summary(&triangle_distortions(mesh, images))
    }

    /// The summary of distortions that are already computed.
    pub fn summary<'a>(triangles: impl IntoIterator<Item = &'a TriangleDistortion>) -> Self {
        let (mut weighted, mut area_sum, mut collapsed_sum) = (0.0, 0.0, 0.0);
        let mut quality = Self { q_mean: 1.0, q_max: 1.0, flipped: 0, collapsed: 0, collapsed_area: 0.0 };
        for triangle in triangles {
            if triangle.collapsed {
                quality.collapsed += 1;
                collapsed_sum += triangle.area;
                continue;
            }
            quality.flipped += u32::from(triangle.flipped);
            weighted += triangle.area * triangle.q;
            area_sum += triangle.area;
            quality.q_max = quality.q_max.max(triangle.q);
        }
        if area_sum > 0.0 {
            quality.q_mean = weighted / area_sum;
        }
        if collapsed_sum > 0.0 {
            quality.collapsed_area = collapsed_sum / (area_sum + collapsed_sum);
        }
        quality
    }

    /// The mean of Q, unless more than a hundredth of the area is in collapsed triangles: then that of the rest says
    /// nothing about the map.
    pub fn resolved_mean(&self) -> Option<f64> {
        (self.collapsed_area <= UNRESOLVED).then_some(self.q_mean)
    }
}

/// The product of two complex numbers.
fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// The distance within which images of the vertices cannot be told apart.
pub(super) fn resolution<P: Unfold>(images: &[P]) -> f64 {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = images.iter().map(|p| p.in_space()).fold(ends, |(low, high), p| (low.min(p), high.max(p)));
    let farthest = low.abs().max(high.abs()).max_element();
    (COLLAPSED * (high - low).max_element()).max(ROUNDED * farthest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::TriangleId;

    fn triangle() -> TriMesh {
        TriMesh::known_sound(vec![DVec2::ZERO, DVec2::X, DVec2::new(0.3, 0.7)], 3, vec![[0, 1, 2]], vec![[u32::MAX; 3]])
    }

    fn quality_under(f: impl Fn(DVec2) -> DVec2) -> Quality {
        let mesh = triangle();
        let images: Vec<_> = mesh.vertices().iter().map(|&v| f(v)).collect();
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

    /// Of two triangles the one with 2 % or 0.5 % of the area has a point as its image, or one that is noise: it has no Q,
    /// and beyond a hundredth the rest has none either.
    #[test]
    fn the_mean_is_that_of_what_is_resolved_and_has_the_share_of_the_rest_beside_it() {
        for (share, tiny) in [(0.02, 0.0), (0.02, 1e-11), (0.005, 1e-12)] {
            let of = |images: [DVec2; 3], area: f64| TriangleDistortion {
                area,
                ..TriangleDistortion::of(triangle().corner_places(TriangleId::new(0)), images, 1e-13)
            };
            let noise = [DVec2::ZERO, DVec2::new(tiny, 0.0), DVec2::new(0.4 * tiny, 0.05 * tiny)];
            let whole = triangle().corner_places(TriangleId::new(0)).map(|p| DVec2::new(3.0 * p.x, p.y));
            let quality = Quality::summary(&[of(whole, 1.0 - share), of(noise, share)]);
            assert!((quality.q_mean - 3.0).abs() < 1e-12 && quality.collapsed == 1, "{quality:?}");
            assert!((quality.collapsed_area - share).abs() < 1e-15, "{quality:?}");
            assert_eq!(quality.resolved_mean().is_some(), share < 0.01);
        }
    }

    fn distortion_under(f: impl Fn(DVec2) -> DVec2) -> TriangleDistortion {
        let mesh = triangle();
        let images: Vec<_> = mesh.vertices().iter().map(|&v| f(v)).collect();
        let distortions = triangle_distortions(&mesh, &images);
        assert_eq!(distortions.len(), 1);
        distortions[0]
    }

    #[test]
    fn an_affine_map_has_the_singular_values_of_its_matrix() {
        // the matrix (2 1; 0 1/2): σ² = (21 ± √377)/8, σ₁σ₂ = 1
        let shear = distortion_under(|v| DVec2::new(2.0 * v.x + v.y, 0.5 * v.y));
        let root = 377_f64.sqrt();
        let expected = ((21.0 + root) / (21.0 - root)).sqrt();
        assert!((shear.q - expected).abs() < 1e-13 * expected, "{} for {expected}", shear.q);
        assert!(shear.area_log2.abs() < 1e-14, "{shear:?}");
        assert!((shear.area - 0.35).abs() < 1e-15 && !shear.flipped && !shear.collapsed, "{shear:?}");
    }

    #[test]
    fn scaling_by_s_multiplies_areas_by_s_squared() {
        for exponent in [-20, -1, 0, 3] {
            let s = f64::from(exponent).exp2();
            let scaled = distortion_under(|v| s * v);
            assert!((scaled.area_log2 - 2.0 * f64::from(exponent)).abs() < 1e-13, "{scaled:?}");
        }
    }

    #[test]
    fn a_reflection_is_flipped_and_keeps_angles_and_areas() {
        let reflected = distortion_under(|v| DVec2::new(-v.x, v.y));
        assert!(reflected.flipped && (reflected.q - 1.0).abs() < 1e-14 && reflected.area_log2.abs() < 1e-14);
    }

    #[test]
    fn images_that_are_segments_or_points_are_collapsed_wherever_they_lie() {
        let slanted = DVec2::new(0.6, 0.8);
        for place in [DVec2::ZERO, DVec2::splat(1e6), DVec2::new(-5e8, 1.0)] {
            for segment in [DVec2::X, slanted] {
                let flat = distortion_under(|v| place + (v.x + v.y) * segment);
                assert!(flat.collapsed && !flat.flipped && flat.q == 1.0 && flat.area_log2 == -AREA_LIMIT, "{flat:?}");
            }
            // two corners coincide
            let folded = distortion_under(|v| place + (v.x + 0.3 / 0.7 * v.y) * slanted);
            assert!(folded.collapsed, "{folded:?}");
            let point = distortion_under(|_| place + DVec2::ONE);
            assert!(point.collapsed && !point.flipped && point.area_log2 == -AREA_LIMIT);
            let whole = distortion_under(|v| place + v);
            assert!(!whole.collapsed && (whole.q - 1.0).abs() < 1e-6, "{whole:?}");
        }
    }

    #[test]
    fn points_of_a_straight_side_far_from_the_origin_are_collapsed() {
        let from = DVec2::new(5e6, 5e6 - 300.0);
        let side = DVec2::new(1000.0, 617.3);
        for k in 0..2000 {
            let part = |i: u32| f64::from((7919 * k + 104_729 * i) % 10_007) / 10_007.0;
            let corners = triangle().corner_places(TriangleId::new(0));
            let images = [1, 2, 3].map(|i| from + part(i) * side);
            let found = TriangleDistortion::of(corners, images, resolution(&[from, from + side]));
            assert!(found.collapsed, "{k}: {images:?}");
        }
    }

    #[test]
    fn between_surfaces_what_is_collapsed_or_flipped_in_the_disk_counts() {
        let plane = triangle();
        let vertices: Vec<_> = plane.vertices().iter().map(|p| p.extend(0.0)).collect();
        let (triangles, neighbours) = (plane.triangles().to_vec(), plane.neighbours().to_vec());
        let mesh = TriMesh::known_sound(vertices.clone(), 3, triangles, neighbours);
        let found = |images: &[DVec3], disk: &[DVec2]| {
            let mut result = Vec::new();
            assert!(advance_surface_distortions(&mesh, images, disk, &mut result, Deadline::NEVER));
            (result[0].collapsed, result[0].flipped)
        };
        let upright = plane.vertices();
        let mirrored = [upright[1], upright[0], upright[2]];
        let segment = [upright[0], upright[1], 0.5 * upright[1]];
        let point = [DVec3::ONE; 3];
        assert_eq!(found(&vertices, upright), (false, false));
        assert_eq!(found(&vertices, &mirrored), (false, true));
        assert_eq!(found(&vertices, &segment), (true, false));
        assert_eq!(found(&point, &mirrored), (true, false));
    }

    #[test]
    fn thin_images_stay_within_the_limits() {
        for height in [1e-9, 1e-12] {
            let thin = distortion_under(|v| DVec2::new(v.x, height * v.y));
            assert!(!thin.collapsed && thin.q > 1e8 && thin.q <= Q_LIMIT, "{height}: {thin:?}");
        }
    }
}

//! The vertices of a surface as the GPU has them: a place and a normal in four floats.
//!
//! Normals are means of the triangles' normals, weighted by their angles (Thürmer and Wüthrich 1998), so that
//! shading does not depend on how a surface is cut into triangles. They are stored as two 12-bit numbers (the octahedron's
//! square: Cigolle et al. 2014), exact to 0.06° (√18/4095): less than a step of 8-bit light.

use glam::{DVec2, DVec3};

/// A vertex: xyz, and the packed normal.
pub type SpaceVertex = [f32; 4];

/// The largest number in 12 bits.
const LEVELS: f64 = 4095.0;

/// Fills `vertices` with places relative to the middle of their bounding box, which is returned. Cost O(n).
pub fn stage(vertices: &mut Vec<SpaceVertex>, positions: &[DVec3], triangles: &[[u32; 3]]) -> DVec3 {
    let (low, high) =
        positions.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    let middle = low.midpoint(high);
    let origin = if middle.is_finite() { middle } else { DVec3::ZERO };
    let normals = normals(positions, triangles);
    vertices.clear();
    vertices.extend(positions.iter().zip(normals).map(|(&p, normal)| {
        let [x, y, z] = (p - origin).as_vec3().to_array();
        [x, y, z, packed(normal)]
    }));
    origin
}

fn normals(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|v| positions[v as usize]);
        let Some(normal) = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize() else { continue };
        for (i, &v) in triangle.iter().enumerate() {
            let [u, w] = [corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]];
            normals[v as usize] += u.angle_between(w) * normal;
        }
    }
    normals
}

/// A normal of any length in one float: an integer below 2²⁴. Zero is packed as z.
fn packed(normal: DVec3) -> f32 {
    let sum = normal.abs().element_sum();
    let n = if sum > 0.0 && sum.is_finite() { normal / sum } else { DVec3::Z };
    let flat = n.truncate();
    let sign = |x: f64| if x >= 0.0 { 1.0 } else { -1.0 };
    let folded = DVec2::new((1.0 - flat.y.abs()) * sign(flat.x), (1.0 - flat.x.abs()) * sign(flat.y));
    let square = if n.z >= 0.0 { flat } else { folded };
    let [across, up] = ((0.5 + 0.5 * square) * LEVELS).round().to_array();
    (across * (LEVELS + 1.0) + up) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As `unpacked_normal` of `shaders/space.wgsl`.
    fn unpacked(packed: f32) -> DVec3 {
        let packed = f64::from(packed);
        let across = (packed / 4096.0).floor();
        let square = DVec2::new(across, packed - 4096.0 * across) / 2047.5 - 1.0;
        let z = 1.0 - square.x.abs() - square.y.abs();
        let fold = |x: f64| x - if x >= 0.0 { (-z).max(0.0) } else { -(-z).max(0.0) };
        DVec3::new(fold(square.x), fold(square.y), z).normalize()
    }

    #[test]
    fn normals_come_back_within_a_16th_of_a_degree() {
        for k in 0..2000 {
            let (z, turn) = (1.0 - (f64::from(k) + 0.5) / 1000.0, 2.399_963 * f64::from(k));
            let flat = (1.0 - z * z).sqrt();
            let normal = DVec3::new(flat * turn.cos(), flat * turn.sin(), z);
            let angle = unpacked(packed(3.0 * normal)).angle_between(normal).to_degrees();
            assert!(angle < 0.06, "{normal}: {angle}°");
        }
        for axis in DVec3::AXES.into_iter().chain(DVec3::AXES.map(|axis| -axis)) {
            // the middle of 4096 steps is between two of them
            assert!(unpacked(packed(axis)).angle_between(axis).to_degrees() < 0.06, "{axis}");
        }
        assert_eq!(packed(DVec3::ZERO), packed(DVec3::Z));
    }

    #[test]
    fn the_normal_at_a_cube_s_corner_does_not_see_how_its_squares_are_cut() {
        let positions: Vec<_> =
            (0..8).map(|v| DVec3::new(f64::from(v & 1), f64::from(v >> 1 & 1), f64::from(v >> 2))).collect();
        // three squares at vertex 7, one of them cut through it
        let triangles = [[7, 6, 4], [7, 4, 5], [7, 3, 6], [3, 2, 6], [7, 5, 1], [7, 1, 3]];
        let normal = normals(&positions, &triangles)[7].normalize();
        assert!(normal.distance(DVec3::ONE.normalize()) < 1e-15, "{normal}");
    }
}

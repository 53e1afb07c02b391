//! The vertices of a surface on the GPU: a position and a normal in four floats.
//!
//! Normals are means of the triangles' normals, weighted by their angles (Thürmer and Wüthrich 1998), so that
//! shading does not depend on how a surface is cut into triangles. They are stored as two 12-bit numbers (octahedral
//! encoding: Cigolle et al. 2014), exact to 0.06° (√18/4095): less than a step of 8-bit light.

use glam::{DVec2, DVec3};

/// A vertex: xyz, and the packed normal.
pub type SpaceVertex = [f32; 4];

/// The largest number in 12 bits.
const LEVELS: f64 = 4095.0;

/// The frame of positions on the GPU. In its unit, coordinates are about 1, so that f32 suits surfaces of any size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalFrame {
    /// The middle of the surface's bounding box.
    pub origin: DVec3,
    /// A power of two, so that dividing by it rounds nothing.
    pub unit: f64,
}

impl Default for LocalFrame {
    fn default() -> Self {
        Self { origin: DVec3::ZERO, unit: 1.0 }
    }
}

impl LocalFrame {
    /// The frame of a surface with these vertices. Cost O(n).
    fn of(positions: &[DVec3]) -> Self {
        let (low, high) =
            positions.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
        let (middle, extent) = (low.midpoint(high), (high - low).max_element());
        let origin = if middle.is_finite() { middle } else { DVec3::ZERO };
        let unit = 2_f64.powi(extent.log2().floor().clamp(-1000.0, 1000.0) as i32);
        Self { origin, unit: if extent > 0.0 && extent.is_finite() { unit } else { 1.0 } }
    }

    fn local(&self, p: DVec3) -> DVec3 {
        (p - self.origin) / self.unit
    }

    /// A position in the frame, as f32.
    pub fn place(&self, p: DVec3) -> [f32; 3] {
        self.local(p).as_vec3().to_array()
    }
}

/// Fills `vertices` with positions in a new frame, which is returned. Cost O(n).
pub fn stage(vertices: &mut Vec<SpaceVertex>, positions: &[DVec3], triangles: &[[u32; 3]]) -> LocalFrame {
    let frame = LocalFrame::of(positions);
    let normals = normals(&frame, positions, triangles);
    vertices.clear();
    vertices.extend(positions.iter().zip(normals).map(|(&p, normal)| {
        let [x, y, z] = frame.place(p);
        [x, y, z, packed(normal)]
    }));
    frame
}

/// Vertex normals. Computed in the frame's unit, so that products of areas do not overflow.
fn normals(frame: &LocalFrame, positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; positions.len()];
    for triangle in triangles {
        let corners = triangle.map(|v| frame.local(positions[v as usize]));
        let Some(normal) = (corners[1] - corners[0]).cross(corners[2] - corners[0]).try_normalize() else { continue };
        for (i, &v) in triangle.iter().enumerate() {
            let [u, w] = [corners[(i + 1) % 3] - corners[i], corners[(i + 2) % 3] - corners[i]];
            normals[v as usize] += u.angle_between(w) * normal;
        }
    }
    normals
}

/// A normal of any length, packed into one float as an integer below 2²⁴. The zero vector is packed as z.
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
            // the middle of 4096 steps lies between two of them
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
        let normal = normals(&LocalFrame::default(), &positions, &triangles)[7].normalize();
        assert!(normal.distance(DVec3::ONE.normalize()) < 1e-15, "{normal}");
    }

    #[test]
    fn surfaces_of_any_size_and_place_are_staged_alike() {
        let positions: Vec<_> =
            [[0.0, 0.0, 0.0], [3.0, 0.5, 0.0], [2.5, 2.0, 1.0], [-0.5, 1.0, 0.25]].map(DVec3::from_array).to_vec();
        let triangles = [[0, 1, 2], [0, 2, 3]];
        let staged = |size: f64, moved: DVec3| {
            let mut vertices = Vec::new();
            let scaled: Vec<_> = positions.iter().map(|&p| size * (p + moved)).collect();
            let frame = stage(&mut vertices, &scaled, &triangles);
            (vertices, frame.unit / size)
        };
        let usual = staged(1.0, DVec3::ZERO);
        assert_eq!(usual.1, 2.0);
        for exponent in [-450, -126, 40, 127, 332] {
            assert_eq!(staged(2_f64.powi(exponent), DVec3::ZERO), usual, "2^{exponent}");
        }
        assert_eq!(staged(2_f64.powi(200), DVec3::splat(1024.0)), usual);
    }
}

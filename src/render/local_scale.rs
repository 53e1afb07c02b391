//! The local scale of a texture at the vertices of a mesh: log₂ of the texture's units per unit of the drawn mesh, which
//! is log₂ |f′| of the map between them, or its negative.
//!
//! At a vertex it is ½ log₂ of the ratio of two areas: of its triangles in the texture, and drawn. A discrete map's
//! triangles differ from their neighbors by some tenths, so that the ratio is averaged over neighbors
//! [`SMOOTHINGS`] times: interpolated in between, it shows no triangles. Vertices whose triangles have no area in one
//! of the two take the mean of their neighbors, or 0. With it goes the length of an edge there in the texture's units: what
//! is smaller in the texture is not resolved. Cost O(triangles), without allocation after the first call.

use glam::DVec2;

/// Means over the neighbors. Without any, the octaves of a pattern fade by triangles of the mesh; each takes 0.1 ms for
/// 10,000 triangles.
const SMOOTHINGS: usize = 3;

/// The triangles of a mesh, and working memory.
#[derive(Debug, Default)]
pub struct LocalScale {
    triangles: Vec<[u32; 3]>,
    /// By vertex: the areas in the texture and drawn; then the sum and the number of the values around it.
    sums: Vec<[f64; 2]>,
    scales: Vec<f32>,
    /// By vertex, for the GPU: the scale, and the length of an edge.
    vertices: Vec<[f32; 2]>,
}

/// The length of an edge over the square root of twice the area of the triangles at one of its ends, where these are the
/// three equilateral ones of a straight boundary; where they are six, this is too much by 1.4.
const EDGE: f64 = 0.62;

impl LocalScale {
    /// Replaces the mesh; all scales are 0.
    pub fn set(&mut self, vertices: usize, triangles: &[[u32; 3]]) {
        self.triangles.clear();
        self.triangles.extend_from_slice(triangles);
        self.scales.clear();
        self.scales.resize(vertices, 0.0);
        self.vertices.clear();
        self.vertices.resize(vertices, [0.0; 2]);
    }

    /// Computes the scales, and the edges' lengths, from twice the areas of the triangles with these corners, of any sign.
    pub fn compute(&mut self, textured: impl Fn([usize; 3]) -> f64, drawn: impl Fn([usize; 3]) -> f64) -> &[[f32; 2]] {
        self.sums.clear();
        self.sums.resize(self.scales.len(), [0.0; 2]);
        for triangle in &self.triangles {
            let corners = triangle.map(|v| v as usize);
            let areas = [textured(corners).abs(), drawn(corners).abs()];
            for v in corners {
                self.sums[v][0] += areas[0];
                self.sums[v][1] += areas[1];
            }
        }
        for ((scale, vertex), [textured, drawn]) in self.scales.iter_mut().zip(&mut self.vertices).zip(&self.sums) {
            // not finite without an area
            *scale = (0.5 * (textured / drawn).log2()) as f32;
            vertex[1] = (EDGE * textured.sqrt()) as f32;
        }
        (0..SMOOTHINGS).for_each(|_| self.smooth());
        for (vertex, scale) in self.vertices.iter_mut().zip(&self.scales) {
            vertex[0] = if scale.is_finite() { *scale } else { 0.0 };
        }
        &self.vertices
    }

    /// Replaces each value by the mean of those around it, and of its own.
    fn smooth(&mut self) {
        self.sums.fill([0.0; 2]);
        for triangle in &self.triangles {
            let corners = triangle.map(|v| v as usize);
            let known = corners.map(|v| self.scales[v]).into_iter().filter(|scale| scale.is_finite());
            let [sum, count] = known.fold([0.0; 2], |[sum, count], scale| [sum + f64::from(scale), count + 1.0]);
            for v in corners {
                self.sums[v][0] += sum;
                self.sums[v][1] += count;
            }
        }
        for (scale, [sum, count]) in self.scales.iter_mut().zip(&self.sums).filter(|(_, [_, count])| *count > 0.0) {
            *scale = (sum / count) as f32;
        }
    }
}

/// Twice the signed area of a triangle of `points`.
pub fn double_area(points: &[DVec2], [a, b, c]: [usize; 3]) -> f64 {
    (points[b] - points[a]).perp_dot(points[c] - points[a])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square grid of `n`² cells, each cut into two triangles.
    fn grid(n: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
        let points = (0..=n).flat_map(|y| (0..=n).map(move |x| DVec2::new(f64::from(x), f64::from(y)) / f64::from(n)));
        let corners = (0..n).flat_map(|y| (0..n).map(move |x| y * (n + 1) + x));
        let triangles = corners.flat_map(|a| [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]);
        (points.collect(), triangles.collect())
    }

    fn scales(points: &[DVec2], images: &[DVec2], triangles: &[[u32; 3]]) -> Vec<f32> {
        let mut scale = LocalScale::default();
        scale.set(points.len(), triangles);
        scale
            .compute(|corners| double_area(images, corners), |corners| double_area(points, corners))
            .iter()
            .map(|vertex| vertex[0])
            .collect()
    }

    #[test]
    fn a_similarity_has_its_factor_everywhere() {
        let (points, triangles) = grid(5);
        let images: Vec<DVec2> = points.iter().map(|p| 8.0 * p.perp() + 3.0).collect();
        assert!(scales(&points, &images, &triangles).iter().all(|scale| (scale - 3.0).abs() < 1e-6));
    }

    #[test]
    fn the_scale_of_an_analytic_map_is_its_derivative() {
        let (points, triangles) = grid(64);
        let exponential = |p: &DVec2| (2.0 * p.x).exp() * DVec2::from_angle(2.0 * p.y);
        let images: Vec<DVec2> = points.iter().map(exponential).collect();
        let found = scales(&points, &images, &triangles);
        for (p, found) in points.iter().zip(found) {
            // f′ = 2 e^{2z}; the means reach four cells, one-sided at the boundary
            let expected = 1.0 + 2.0 * p.x * std::f64::consts::LOG2_E;
            assert!((f64::from(found) - expected).abs() < 0.12, "at {p}: {found} instead of {expected}");
        }
    }

    #[test]
    fn edges_have_their_length_in_the_texture() {
        let (points, triangles) = grid(8);
        let images: Vec<DVec2> = points.iter().map(|p| 4.0 * p).collect();
        let mut scale = LocalScale::default();
        scale.set(points.len(), &triangles);
        let found = scale.compute(|corners| double_area(&images, corners), |corners| double_area(&points, corners));
        // edges of 0.5 and 0.7; a corner of the square has one or two triangles, its inside six
        assert!(found.iter().all(|[_, edge]| (0.3..0.8).contains(edge)), "{found:?}");
    }

    #[test]
    fn vertices_without_area_take_the_mean_of_their_neighbors_and_nothing_is_infinite() {
        let (points, triangles) = grid(6);
        let collapsed: Vec<DVec2> = points.iter().map(|p| 4.0 * p.max(DVec2::splat(0.5))).collect();
        let found = scales(&points, &collapsed, &triangles);
        assert!(found.iter().all(|scale| scale.is_finite()), "{found:?}");
        assert!((found[48] - 2.0).abs() < 0.3, "{found:?}");
        let single = scales(&points, &vec![DVec2::ONE; points.len()], &triangles);
        assert!(single.iter().all(|&scale| scale == 0.0));
    }
}

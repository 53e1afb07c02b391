//! A sketch of a surface that cannot be opened: its triangles as lines, and the places of its faults.

use crate::geometry::DVec3;
use crate::surface::{Surface, TopologyError, is_sound};

/// The most triangles that are drawn; of more, every k-th one.
const MOST_TRIANGLES: usize = 3000;
/// The most edges and the most vertices that are marked.
const MOST_MARKS: usize = 2000;

/// A place in the cube [−32767, 32767]³ around the surface.
pub type Place = [i16; 3];

/// Lines and marks in space, small enough for a message.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Sketch {
    /// The corners of triangles.
    pub triangles: Vec<[Place; 3]>,
    /// Faulty edges.
    pub edges: Vec<[Place; 2]>,
    /// Faulty vertices.
    pub vertices: Vec<Place>,
    /// The number of faulty places that are not marked, because there are too many.
    pub unmarked: usize,
}

impl Sketch {
    /// The surface with the places of `error` marked; `None` if that has no places.
    pub fn new(surface: &Surface, error: &TopologyError) -> Option<Self> {
        let faults = error.places(surface);
        let marks = faults.edges.len() + faults.vertices.len();
        if marks == 0 {
            return None;
        }
        let place = placed(surface);
        let step = surface.triangles().len().div_ceil(MOST_TRIANGLES).max(1);
        let drawn = surface
            .triangles()
            .iter()
            .step_by(step)
            .filter(|corners| corners.iter().all(|&v| is_sound(surface.vertices()[v as usize])));
        let triangles = drawn.map(|corners| corners.map(&place)).collect();
        let edges: Vec<_> = faults.edges.into_iter().take(MOST_MARKS).map(|ends| ends.map(&place)).collect();
        let vertices: Vec<_> = faults.vertices.into_iter().take(MOST_MARKS).map(&place).collect();
        let unmarked = marks - edges.len() - vertices.len();
        Some(Self { triangles, edges, vertices, unmarked })
    }
}

/// The place of a vertex: the box of all triangles is centered, and its longest edge fills the cube. The center for a vertex at
/// no finite place.
fn placed(surface: &Surface) -> impl Fn(u32) -> Place {
    let vertices = surface.vertices();
    let corners = surface.triangles().as_flattened().iter().copied().filter(|&v| is_sound(vertices[v as usize]));
    let bounds = |least: fn(DVec3, DVec3) -> DVec3, start: f64| {
        corners.clone().map(|v| vertices[v as usize]).fold(DVec3::splat(start), least)
    };
    let (low, high) = (bounds(DVec3::min, f64::INFINITY), bounds(DVec3::max, f64::NEG_INFINITY));
    let (center, half) = (low.midpoint(high), (0.5 * (high - low)).max_element());
    let scale = if half > 0.0 { f64::from(i16::MAX) / half } else { 0.0 };
    move |v| ((vertices[v as usize] - center) * scale).to_array().map(|x| x as i16)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::mesh::{TriangleId, VertexId};
    use crate::surface::SurfaceMesh;

    #[test]
    fn a_triple_edge_is_marked_where_it_is() {
        let places = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, -2.0, 0.0], [0.0, 0.0, 1.0]];
        let surface = Surface::new(places.map(DVec3::from).to_vec(), vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        let error = SurfaceMesh::new(&surface).unwrap_err();
        let sketch = Sketch::new(&surface, &error).unwrap();
        assert_eq!((sketch.triangles.len(), sketch.vertices.len(), sketch.unmarked), (3, 0, 0));
        let [a, b] = sketch.edges[0];
        assert_eq!(([a[0], b[0]], a[1], a[2]), ([-i16::MAX, i16::MAX], 0, -8191), "the box is 4 × 4 × 1");
    }

    #[test]
    fn vertices_at_no_finite_place_are_left_out() {
        let places = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [f64::NAN, 0.0, 0.0], [1e300, 0.0, 0.0]];
        let surface = Surface::new(places.map(DVec3::from).to_vec(), vec![[0, 1, 2], [0, 1, 1], [1, 2, 3], [2, 1, 4]]);
        let error = TopologyError::RepeatedCorner {
            triangle: TriangleId::new(1),
            corners: [0, 1, 1].map(VertexId::new),
            count: 1,
        };
        let sketch = Sketch::new(&surface, &error).unwrap();
        assert_eq!((sketch.triangles.len(), sketch.edges.len()), (2, 3));
        assert_eq!(sketch.triangles[0][1], [i16::MAX, -16_383, 0]);
    }

    #[test]
    fn large_surfaces_are_thinned_and_what_is_not_marked_is_counted() {
        let vertices: Vec<DVec3> =
            (0..30_000).map(|k| DVec3::new(f64::from(k), f64::from(k % 3), f64::from(k % 3 / 2))).collect();
        let triangles = (0..10_000).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        let surface = Surface::new(vertices, triangles);
        let error = SurfaceMesh::new(&surface).unwrap_err();
        let sketch = Sketch::new(&surface, &error).unwrap();
        assert_eq!((sketch.triangles.len(), sketch.edges.len(), sketch.unmarked), (2500, 2000, 27_997));
    }
}

//! Point location in a mesh whose vertices were laid out in the unit disk, its boundary on the circle.
//!
//! The layout of [`crate::conformal::disk_coordinates`] crowds, and it may have flipped triangles where the mesh has
//! negative weights, so that the invariants of [`super::locate`] do not hold. A walk does not depend on scale: it
//! also works where triangles have a size of 1e-14. Boundary vertices lie on the circle, in order up to rounding if no
//! measure is negative; only then is the boundary convex. So a point beyond a boundary edge is assigned to it only if
//! the point lies between that chord and its arc; beyond a reversed edge lies most of the disk.

use super::TriangleId;
use super::locate::{BarycentricPoint, weights_in};
use super::tri_mesh::NO_TRIANGLE;
use crate::geometry::{DVec2, orientation};

/// The number of steps that a walk may always take, besides a multiple of √n: from a near start a few are usual.
const LEAST_STEPS: usize = 256;

/// The allowed multiple of √n; across a disk of uniform triangles a walk takes 2 √n.
const STEPS_PER_SIDE: f64 = 16.0;

/// A point closer than this to the lens between a chord and its arc may lie in it: positions are rounded at 1e-16, and
/// those of vertices solved for to 1e-14.
const ROUNDING: f64 = 1e-13;

/// A mesh laid out in the disk.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DiskLayout<'a> {
    /// As in [`super::TriMesh`].
    pub triangles: &'a [[u32; 3]],
    /// As in [`super::TriMesh`].
    pub neighbours: &'a [[u32; 3]],
    /// The positions of the vertices.
    pub places: &'a [DVec2],
}

impl DiskLayout<'_> {
    /// The point of the mesh at `x` in the closed disk, walking from triangle `start`; between a boundary edge and the
    /// circle, the edge's nearest point. `None` if the walk does not end among flipped triangles, or leaves over a
    /// reversed edge or over one that cuts off more than half of the circle. Adds the number of steps to `steps`.
    pub(crate) fn locate(&self, x: DVec2, start: TriangleId, steps: &mut usize) -> Option<BarycentricPoint> {
        let most = LEAST_STEPS + (STEPS_PER_SIDE * (self.triangles.len() as f64).sqrt()) as usize;
        let (mut triangle, mut from) = (start.number(), NO_TRIANGLE);
        for step in 0..most {
            *steps += 1;
            let corners = self.corners(triangle);
            let neighbours = self.neighbours[triangle as usize];
            // alternating the first edge keeps the walk from circling
            let mut edges = [0, 1, 2];
            edges.rotate_left(step % 3);
            let is_beyond = |&i: &usize| orientation(corners[(i + 1) % 3], corners[(i + 2) % 3], x) < 0.0;
            let came_from = |i: &usize| neighbours[*i] == from && from != NO_TRIANGLE;
            let is_wall = |i: usize| neighbours[i] == NO_TRIANGLE && !is_in_lens(corners, i, x);
            let mut beyond = edges.into_iter().filter(|i| !came_from(i) && is_beyond(i));
            match beyond.clone().find(|&i| !is_wall(i)) {
                None if beyond.next().is_some() => return None,
                None => return Some(BarycentricPoint::new(TriangleId::new(triangle), inside(corners, x))),
                Some(i) if neighbours[i] == NO_TRIANGLE => {
                    return Some(BarycentricPoint::new(TriangleId::new(triangle), on_edge(corners, i, x)));
                }
                Some(i) => (from, triangle) = (triangle, neighbours[i]),
            }
        }
        None
    }

    fn corners(&self, triangle: u32) -> [DVec2; 3] {
        self.triangles[triangle as usize].map(|v| self.places[v as usize])
    }
}

/// The weights of `x` in a triangle that contains it; in a triangle without area, those of the corner nearest to `x`.
fn inside(corners: [DVec2; 3], x: DVec2) -> [f64; 3] {
    let weights = weights_in(corners, x);
    if weights.iter().all(|w| w.is_finite()) {
        return weights;
    }
    let nearest = (0..3).min_by(|&i, &j| corners[i].distance(x).total_cmp(&corners[j].distance(x)));
    std::array::from_fn(|i| if Some(i) == nearest { 1.0 } else { 0.0 })
}

/// Whether `x`, right of the boundary edge opposite to corner `i`, lies between that chord and its arc; the arc is
/// half of the circle at most.
fn is_in_lens(corners: [DVec2; 3], i: usize, x: DVec2) -> bool {
    let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
    let Some(direction) = (b - a).try_normalize() else { return x.distance(a) <= ROUNDING };
    let (along, height) = ((x - a).dot(direction), direction.perp_dot(a - x));
    let sagitta = 1.0 - 0.5 * (a + b).length();
    a.perp_dot(b) >= -ROUNDING
        && (-ROUNDING..=a.distance(b) + ROUNDING).contains(&along)
        && height <= sagitta + ROUNDING
}

/// The weights of the point nearest to `x` on the edge opposite to corner `i`.
fn on_edge(corners: [DVec2; 3], i: usize, x: DVec2) -> [f64; 3] {
    let (a, b) = ((i + 1) % 3, (i + 2) % 3);
    let edge = corners[b] - corners[a];
    let along = (x - corners[a]).dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
    let along = along.clamp(0.0, 1.0);
    let mut weights = [0.0; 3];
    (weights[a], weights[b]) = (1.0 - along, along);
    weights
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::mesh::{Sizing, TriMesh, mesh_domain};
    use std::f64::consts::TAU;

    fn disk(count: u32) -> TriMesh {
        let rim: Vec<_> = (0..count).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(count))).collect();
        mesh_domain(&rim, Sizing::Uniform).unwrap().0
    }

    fn layout<'a>(mesh: &'a TriMesh, places: &'a [DVec2]) -> DiskLayout<'a> {
        DiskLayout { triangles: &mesh.triangles, neighbours: &mesh.neighbours, places }
    }

    fn place(mesh: &TriMesh, point: BarycentricPoint) -> DVec2 {
        let corners = mesh.triangles[point.triangle().index()].map(|v| mesh.vertices[v as usize]);
        (0..3).map(|i| point.weights()[i] * corners[i]).sum()
    }

    #[test]
    fn vertices_are_found_to_the_bit_and_points_to_rounding() {
        let mesh = disk(60);
        let layout = layout(&mesh, &mesh.vertices);
        for start in [0, mesh.triangles.len() as u32 - 1].map(TriangleId::new) {
            for &p in &mesh.vertices {
                assert_eq!(place(&mesh, layout.locate(p, start, &mut 0).unwrap()), p);
                let inside = 0.97 * p + DVec2::new(1e-3, -2e-3);
                assert!(place(&mesh, layout.locate(inside, start, &mut 0).unwrap()).distance(inside) < 1e-15);
            }
        }
    }

    #[test]
    fn between_chord_and_circle_the_chord_s_nearest_point_is_taken() {
        let mesh = disk(60);
        let layout = layout(&mesh, &mesh.vertices);
        // a chord of 6° is 1 − cos 3° = 1.4e-3 from the circle
        for k in 0..600 {
            let x = DVec2::from_angle(TAU * f64::from(k) / 600.0);
            let found = layout.locate(x, TriangleId::new(0), &mut 0).unwrap();
            let distance = place(&mesh, found).distance(x);
            assert!(distance < 1.4e-3 && found.weights().iter().all(|w| (0.0..=1.0).contains(w)), "{k}: {distance}");
        }
    }

    #[test]
    fn nothing_is_found_beyond_a_reversed_boundary_edge() {
        let mesh = disk(60);
        let mut places = mesh.vertices.clone();
        places.swap(20, 21);
        let layout = layout(&mesh, &places);
        let place = |point: BarycentricPoint| -> DVec2 {
            let corners = mesh.triangles[point.triangle().index()].map(|v| places[v as usize]);
            (0..3).map(|i| point.weights()[i] * corners[i]).sum()
        };
        let mut found = 0;
        for start in (0..mesh.triangles.len() as u32).map(TriangleId::new) {
            for &p in &mesh.vertices {
                let Some(point) = layout.locate(p, start, &mut 0) else { continue };
                // a chord of 12° is 1 − cos 6° = 5.5e-3 from the circle
                assert!(place(point).distance(p) < 5.6e-3, "{p} from {start}: {point:?}");
                found += 1;
            }
        }
        let walks = mesh.triangles.len() * mesh.vertices.len();
        println!("{found} of {walks} walks end");
        assert!(10 * found > 9 * walks, "{found} of {walks}");
    }

    #[test]
    fn among_flipped_and_flat_triangles_what_is_found_is_a_point() {
        let mesh = disk(60);
        let m = mesh.boundary_count as usize;
        let mut places = mesh.vertices.clone();
        // one vertex far beyond its neighbors, and three at one position
        places[m] = -places[m] + DVec2::new(0.3, 0.2);
        let [a, b, c] = mesh.triangles[mesh.triangles.len() - 1];
        for v in [b, c] {
            places[v as usize] = places[a as usize];
        }
        let layout = layout(&mesh, &places);
        for &p in &mesh.vertices {
            if let Some(found) = layout.locate(p, TriangleId::new(0), &mut 0) {
                let sum: f64 = found.weights().iter().sum();
                assert!((sum - 1.0).abs() < 1e-12, "{found:?}");
            }
        }
        assert!(layout.locate(places[a as usize], TriangleId::new(0), &mut 0).is_some());
    }
}

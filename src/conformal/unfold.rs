//! The ring of triangles around a point of a surface, unfolded into the plane where it is flat.
//!
//! Harmonic functions on a flat piece of a surface are harmonic in the plane into which it unfolds
//! (isometrically, so conformally). There file `stencil` interpolates with the same accuracy as in a planar
//! mesh: a flat mesh in space and a bent copy of it have the same kernel as the planar one.

use super::stencil::{self, Stencil};
use crate::geometry::{DVec2, DVec3};
use crate::mesh::{BarycentricPoint, TriMesh, TriangleId};

/// A ring is flat if unfolding it around a vertex closes up to this fraction of an edge. With coordinates
/// computed in f64 it closes up to 1e-14; a curvature with a gap of 1e-9 changes the weights by no more than that.
const FLAT: f64 = 1e-9;

/// Vertices with their positions in the plane.
pub(super) type UnfoldedPlaces = Vec<(u32, DVec2)>;

/// Writes the weights of the vertices around `x` into `stencil`: those of the ring if it is flat and interior, else
/// those of the three corners. `places` is working memory.
pub(super) fn around(mesh: &TriMesh<DVec3>, x: BarycentricPoint, stencil: &mut Stencil, places: &mut UnfoldedPlaces) {
    stencil.clear();
    let corners = mesh.triangles()[x.triangle().index()];
    if unfold(mesh, x.triangle(), places).is_some() {
        let point = (0..3).map(|i| x.weights()[i] * places[i].1).sum();
        let place = |vertex: u32| known(places, vertex).unwrap_or(DVec2::NAN);
        stencil.extend(places.iter().map(|&(vertex, _)| (vertex, 0.0)));
        if stencil::set_weights(point, place, stencil).is_some() {
            return;
        }
    }
    stencil.clear();
    stencil.extend(corners.into_iter().zip(x.weights()));
}

/// The position of a vertex that is already unfolded; rings have about 12 vertices.
fn known(places: &UnfoldedPlaces, vertex: u32) -> Option<DVec2> {
    places.iter().find(|(known, _)| *known == vertex).map(|&(_, place)| place)
}

/// Unfolds the corners of `start` and all vertices of the triangles at them; `None` if one of them
/// is on the boundary or the ring is not flat.
fn unfold(mesh: &TriMesh<DVec3>, start: TriangleId, places: &mut UnfoldedPlaces) -> Option<()> {
    places.clear();
    let corners = mesh.triangles()[start.index()];
    let [a, b, c] = corners.map(|v| mesh.vertices()[v as usize]);
    let second = DVec2::new(a.distance(b), 0.0);
    let third = beside(DVec2::ZERO, second, [a, b, c]);
    places.extend(corners.into_iter().zip([DVec2::ZERO, second, third]));
    (0..3).try_for_each(|i| turn(mesh, start, i, places))
}

/// Unfolds the triangles at corner `i` of `start` one after another, counter-clockwise.
fn turn(mesh: &TriMesh<DVec3>, start: TriangleId, i: usize, places: &mut UnfoldedPlaces) -> Option<()> {
    let corner = mesh.triangles()[start.index()][i];
    let centre = known(places, corner)?;
    let (mut triangle, mut at) = (start, i);
    let mut beyond = known(places, mesh.triangles()[start.index()][(i + 2) % 3])?;
    loop {
        if mesh.triangles()[triangle.index()].iter().any(|&v| v < mesh.boundary_count()) {
            return None;
        }
        // across the edge from the corner to the third vertex, which is the second of the next triangle
        triangle = mesh.neighbour(triangle, (at + 1) % 3)?;
        let vertices = mesh.triangles()[triangle.index()];
        at = vertices.iter().position(|&v| v == corner)?;
        let next = vertices[(at + 2) % 3];
        let positions = [0, 1, 2].map(|k| mesh.vertices()[vertices[(at + k) % 3] as usize]);
        let place = beside(centre, beyond, positions);
        match known(places, next) {
            Some(before) if before.distance(place) > FLAT * centre.distance(place) => return None,
            Some(_) => {}
            None => places.push((next, place)),
        }
        if triangle == start {
            return Some(());
        }
        beyond = place;
    }
}

/// The place of the third corner of a triangle whose first two are at `a` and `b` in the plane.
fn beside(a: DVec2, b: DVec2, [p, q, r]: [DVec3; 3]) -> DVec2 {
    let (u, v) = (q - p, r - p);
    let along = u.dot(v) / u.length_squared();
    let across = u.cross(v).length() / u.length_squared();
    a + along * (b - a) + across * (b - a).perp()
}

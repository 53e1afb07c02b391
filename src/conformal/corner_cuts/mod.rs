//! A flattened surface divided so that its layout reaches every corner of the outline.
//!
//! The image of a boundary edge is a segment, and a corner of the outline between the images of its ends is cut off. Here
//! a boundary edge is divided at the point whose harmonic measure is the corner's; the new vertex has the corner's
//! coordinates, to the bit. A vertex nearer to that point than [`NEAREST`] of the edge is moved to the corner instead,
//! and several corners on one edge keep that distance from each other, so that no triangle in space is degenerate.
//!
//! The vertices of the mesh keep their numbers, and new ones follow. The first part of a divided triangle takes its place
//! in the list, the others follow at the end; all keep its orientation. A triangle whose third corner is on the boundary
//! too gets a vertex in its middle: it could be mapped onto one side of the outline otherwise.
//!
//! At a reentrant corner a part can be folded: the third corner of its triangle is behind the outline's corner. Then the
//! triangle's edge inside the surface is divided too, where that unfolds it (`unfold`); [`CornerCuts::folded`] counts the
//! parts that stay folded. The map itself does not change.

mod unfold;

use super::ConformalMap;
use super::subdivision::Finest;
use crate::geometry::{DVec2, DVec3, orientation};
use crate::mesh::{NO_TRIANGLE, TriMesh, TriangleId, VertexId};
use crate::outline::BoundaryPoint;
use std::collections::BTreeMap;
use unfold::Parts;

/// The least distance of a new vertex from the others of its edge, in lengths of the edge. An edge of a hundredth of the
/// surface's size is then divided at 1e-6 of it, which is still resolved in f32 (6e-8).
const NEAREST: f64 = 1e-4;
/// Coordinates beyond those of all corners by less, in sizes of the layout, are on the outline's side: rounding.
const ROUNDING: f64 = 1e-12;

/// What a new vertex divides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Divided {
    /// An edge, at this fraction of its length from its first end: one of the boundary, or one next to a reentrant corner.
    Edge {
        /// Its ends; those of a boundary edge in the direction of the boundary.
        ends: [VertexId; 2],
        /// In (0, 1).
        fraction: f64,
    },
    /// A triangle, in its middle.
    Triangle(TriangleId),
}

/// A new vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AddedVertex {
    /// Its position on the surface.
    pub place: DVec3,
    /// What it divides.
    pub divides: Divided,
}

/// A surface's mesh with a vertex at each corner of the outline; made by [`ConformalMap::cut_corners`].
#[derive(Debug, Clone)]
pub struct CornerCuts {
    images: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    /// For each triangle beyond the mesh's own, the triangle of which it is a part.
    parents: Vec<u32>,
    added: Vec<AddedVertex>,
    at_corners: Vec<VertexId>,
    folded: usize,
}

impl CornerCuts {
    /// The images of all vertices: of the mesh's, then of the new ones.
    pub fn images(&self) -> &[DVec2] {
        &self.images
    }

    /// All triangles: the mesh's own, of which the divided ones are their first part, then the other parts.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The triangle of the mesh of which triangle `k` is a part, or which it is.
    pub fn parent(&self, k: usize) -> TriangleId {
        let own = self.triangles.len() - self.parents.len();
        TriangleId::new(if k < own { k as u32 } else { self.parents[k - own] })
    }

    /// The new vertices, numbered from the mesh's number of vertices on.
    pub fn added(&self) -> &[AddedVertex] {
        &self.added
    }

    /// The vertex at each corner, in the order in which the corners were given.
    pub fn at_corners(&self) -> &[VertexId] {
        &self.at_corners
    }

    /// The number of corners at which a vertex of the mesh is, or was as good as.
    pub fn reused(&self) -> usize {
        let own = (self.images.len() - self.added.len()) as u32;
        self.at_corners.iter().filter(|vertex| vertex.number() < own).count()
    }

    /// The number of parts of triangles that are folded over in the plane.
    pub fn folded(&self) -> usize {
        self.folded
    }
}

impl ConformalMap {
    /// The mapped surface divided so that each of `corners`, points of the outline in any order, is the image of a vertex.
    /// `None` unless exactly one side is a surface, and before the first update. Cost O(n + corners · m₁).
    pub fn cut_corners(&self, corners: &[DVec2]) -> Option<CornerCuts> {
        let mesh = self.mapped().surface()?.mesh();
        let preimages = self.preimages(corners)?;
        let mut images = self.images().to_vec();
        if images.is_empty() {
            return None;
        }
        let vertices = mesh.vertices().len();
        let mut cutting = Cutting { mesh, added: Vec::new(), edges: BTreeMap::new() };
        let mut at_corners = vec![VertexId::new(0); corners.len()];
        for (corner, place) in cutting.placed(&preimages) {
            let vertex = match place {
                Place::Vertex(vertex) => vertex,
                Place::Edge(edge, fraction) => (vertices + cutting.divide(edge, fraction)) as u32,
            };
            images.resize(images.len().max(vertex as usize + 1), DVec2::ZERO);
            images[vertex as usize] = corners[corner];
            at_corners[corner] = VertexId::new(vertex);
        }
        within_corners(&mut images[..mesh.boundary_count() as usize], corners);
        let (triangles, parents) = cutting.triangles(&mut images);
        let mut parts = Parts { mesh, images, added: cutting.added, triangles, parents };
        let folded = parts.unfold();
        let Parts { images, added, triangles, parents, .. } = parts;
        Some(CornerCuts { images, triangles, parents, added, at_corners, folded })
    }

    /// What the images of the surface's boundary edges cut off: for each of `corners`, points of the outline in any order, the
    /// triangle between it and the image of the edge that passes it, and the number of the surface's triangle at that edge.
    /// Counter-clockwise, except at reentrant corners. `None` unless exactly one side is a surface, and before the first
    /// update. Cost O(n + corners · log m₁).
    pub fn cut_off(&self, corners: &[DVec2]) -> Option<Vec<([DVec2; 3], u32)>> {
        let mesh = self.mapped().surface()?.mesh();
        let (preimages, images) = (self.preimages(corners)?, self.images());
        if images.is_empty() {
            return None;
        }
        let m = mesh.boundary_count();
        let mut at_edge = vec![0; m as usize];
        for (t, (corners, neighbours)) in (0..).zip(mesh.triangles().iter().zip(mesh.neighbours())) {
            for i in (0..3).filter(|i| neighbours[(i + 2) % 3] == NO_TRIANGLE) {
                at_edge[corners[i] as usize] = t;
            }
        }
        let mut last = None;
        let triangle = |&(corner, point): &(usize, BoundaryPoint)| {
            let edge = point.edge();
            let [a, b] = [edge, (edge + 1) % m].map(|v| images[v as usize]);
            let behind = last.filter(|(passed, _)| *passed == edge).map_or(a, |(_, corner)| corner);
            last = Some((edge, corners[corner]));
            ([behind, corners[corner], b], at_edge[edge as usize])
        };
        Some(preimages.iter().map(triangle).collect())
    }

    /// The points of the surface's boundary with the same harmonic measure as the corners: the number of each corner with
    /// its point, along the boundary from its first vertex.
    fn preimages(&self, corners: &[DVec2]) -> Option<Vec<(usize, BoundaryPoint)>> {
        let (surface, outline) = (self.mapped_side(), self.mapped_side().other());
        if let Some(Finest { map, cuts }) = self.finest.as_deref() {
            let on_own = |(k, point)| (k, cuts[surface].coarser_on_boundary(point));
            return Some(map.preimages(corners)?.into_iter().map(on_own).collect());
        }
        let (onto, own) = (self.measure(outline), self.measure(surface));
        let samples = self.domain(outline)?.samples();
        let mut along: Vec<(usize, (usize, f64))> =
            corners.iter().enumerate().map(|(k, &corner)| (k, onto.place_of(samples.nearest(corner)))).collect();
        along.sort_by(|(_, a), (_, b)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let anchor = own.anchor();
        let mut found: Vec<(usize, BoundaryPoint, bool)> = Vec::new();
        for (k, (j, lambda)) in along {
            let omega = onto.within(j, lambda);
            let point = own.point_at(omega);
            // the anchor's edge begins with what is found last
            let is_behind =
                point.fraction() < anchor.fraction() || (point.fraction() == anchor.fraction() && omega > 0.5);
            found.push((k, point, point.edge() != anchor.edge() || !is_behind));
        }
        found.sort_by_key(|&(_, point, is_ahead)| (point.edge(), is_ahead));
        Some(found.into_iter().map(|(k, point, _)| (k, point)).collect())
    }
}

/// Where a corner is hit.
#[derive(Clone, Copy)]
enum Place {
    Vertex(u32),
    /// The edge from this boundary vertex on, and the fraction of its length.
    Edge(u32, f64),
}

struct Cutting<'a> {
    mesh: &'a TriMesh<DVec3>,
    added: Vec<AddedVertex>,
    /// For each divided boundary edge its new vertices in the direction of the boundary.
    edges: BTreeMap<u32, Vec<u32>>,
}

impl Cutting<'_> {
    /// The place of each corner, edge by edge and along each edge.
    fn placed(&self, preimages: &[(usize, BoundaryPoint)]) -> Vec<(usize, Place)> {
        let mut on_edges: BTreeMap<u32, Vec<(usize, f64)>> = BTreeMap::new();
        for &(corner, point) in preimages {
            on_edges.entry(point.edge()).or_default().push((corner, point.fraction()));
        }
        let m = self.mesh.boundary_count();
        let mut taken = vec![false; m as usize];
        let mut take = |vertex: u32| !std::mem::replace(&mut taken[vertex as usize], true);
        let mut placed = Vec::new();
        for (edge, mut corners) in on_edges {
            if let Some(&(corner, fraction)) = corners.first()
                && fraction < NEAREST
                && take(edge)
            {
                placed.push((corner, Place::Vertex(edge)));
                corners.remove(0);
            }
            if let Some(&(corner, fraction)) = corners.last()
                && fraction > 1.0 - NEAREST
                && take((edge + 1) % m)
            {
                placed.push((corner, Place::Vertex((edge + 1) % m)));
                corners.pop();
            }
            let fractions = spaced(&corners.iter().map(|&(_, fraction)| fraction).collect::<Vec<_>>());
            placed.extend(corners.iter().zip(fractions).map(|(&(k, _), fraction)| (k, Place::Edge(edge, fraction))));
        }
        placed
    }

    /// Divides a boundary edge behind its former divisions; returns the number of the new vertex among the new ones.
    fn divide(&mut self, edge: u32, fraction: f64) -> usize {
        let ends = [edge, (edge + 1) % self.mesh.boundary_count()];
        let [a, b] = ends.map(|v| self.mesh.vertices()[v as usize]);
        let divides = Divided::Edge { ends: ends.map(VertexId::new), fraction };
        let added = self.added.len();
        self.added.push(AddedVertex { place: a.lerp(b, fraction), divides });
        self.edges.entry(edge).or_default().push((self.mesh.vertices().len() + added) as u32);
        added
    }

    /// All triangles, and of those beyond the mesh's own the triangles of which they are parts.
    fn triangles(&mut self, images: &mut Vec<DVec2>) -> (Vec<[u32; 3]>, Vec<u32>) {
        let mesh = self.mesh;
        let (mut triangles, mut parents) = (mesh.triangles().to_vec(), Vec::new());
        for (t, neighbours) in mesh.neighbours().iter().enumerate() {
            let corners = mesh.triangles()[t];
            let new = |i: usize| {
                let is_open = neighbours[(i + 2) % 3] == NO_TRIANGLE;
                self.edges.get(&corners[i]).filter(|_| is_open).map_or(&[][..], Vec::as_slice)
            };
            // each side's first corner, then the new vertices on it
            let ring: Vec<u32> = (0..3).flat_map(|i| [&corners[i..=i], new(i)].concat()).collect();
            let Some(divided) = (0..3).find(|&i| !new(i).is_empty()) else { continue };
            let apex = corners[(divided + 2) % 3];
            let apex = if apex < mesh.boundary_count() { self.middle(t, images) } else { apex };
            let sides = ring.iter().zip(ring.iter().cycle().skip(1));
            let mut parts =
                sides.filter(|&(&a, &b)| a != apex && b != apex).map(|(&a, &b)| [a, b, apex]).collect::<Vec<_>>();
            triangles[t] = parts.remove(0);
            parents.extend(parts.iter().map(|_| t as u32));
            triangles.extend(parts);
        }
        (triangles, parents)
    }

    /// A new vertex in the middle of triangle `t`.
    fn middle(&mut self, t: usize, images: &mut Vec<DVec2>) -> u32 {
        let triangle = TriangleId::new(t as u32);
        let place = self.mesh.corner_places(triangle).iter().sum::<DVec3>() / 3.0;
        let image = self.mesh.triangles()[t].iter().map(|&v| images[v as usize]).sum::<DVec2>() / 3.0;
        images.push(image);
        self.added.push(AddedVertex { place, divides: Divided::Triangle(triangle) });
        (images.len() - 1) as u32
    }
}

/// Ascending fractions of an edge with at least [`NEAREST`] between them and to the ends, or evenly less where they are
/// too many for that.
fn spaced(fractions: &[f64]) -> Vec<f64> {
    let step = NEAREST.min(0.5 / (fractions.len() + 1) as f64);
    let mut least = 0.0;
    let forward = fractions.iter().map(|&fraction| {
        least = fraction.max(least + step);
        least
    });
    let mut all: Vec<f64> = forward.collect();
    let mut most = 1.0;
    for fraction in all.iter_mut().rev() {
        most = fraction.min(most - step);
        *fraction = most;
    }
    all
}

/// Moves images that are outside of the corners' bounding box by rounding onto it.
fn within_corners(images: &mut [DVec2], corners: &[DVec2]) {
    if corners.is_empty() {
        return;
    }
    let (low, high) = corners
        .iter()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &corner| (low.min(corner), high.max(corner)));
    let rounding = ROUNDING * (high - low).max_element();
    for image in images {
        let inside = image.clamp(low, high);
        if image.distance(inside) <= rounding {
            *image = inside;
        }
    }
}

/// Whether the corners are clockwise.
fn is_folded([a, b, c]: [DVec2; 3]) -> bool {
    orientation(a, b, c) < 0.0
}

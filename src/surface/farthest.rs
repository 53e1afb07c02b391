//! The default interior point: the vertex farthest from the boundary along edges (Dijkstra 1959).

use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, TriMesh, TriangleId, VertexId};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// A vertex with the length of the shortest known path to the boundary; ordered so that the nearest is the greatest.
#[derive(Debug, PartialEq)]
struct Reached {
    distance: f64,
    vertex: u32,
}

impl Eq for Reached {}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        other.distance.total_cmp(&self.distance).then(other.vertex.cmp(&self.vertex))
    }
}

/// The interior vertex whose shortest path along edges to the boundary is the longest, as a
/// corner of a triangle; without interior vertices the centroid of the first triangle. Cost O(n log n).
pub fn farthest_from_boundary(mesh: &TriMesh<DVec3>) -> BarycentricPoint {
    let distances = distances(mesh);
    let interior = (mesh.boundary_count()..mesh.vertices().len() as u32).filter(|&v| distances[v as usize].is_finite());
    let farthest = interior.max_by(|&u, &v| distances[u as usize].total_cmp(&distances[v as usize]));
    let at_corner = farthest.and_then(|vertex| at_vertex(mesh, VertexId::new(vertex)));
    at_corner.unwrap_or(BarycentricPoint::new(TriangleId::new(0), [1.0 / 3.0; 3]))
}

/// The vertex as a corner of the first triangle that has it; `None` if no triangle has it. Cost O(n).
pub fn at_vertex(mesh: &TriMesh<DVec3>, vertex: VertexId) -> Option<BarycentricPoint> {
    let triangle = mesh.triangles().iter().position(|corners| corners.contains(&vertex.number()))?;
    let weights = mesh.triangles()[triangle].map(|v| if v == vertex.number() { 1.0 } else { 0.0 });
    Some(BarycentricPoint::new(TriangleId::new(triangle as u32), weights))
}

fn distances(mesh: &TriMesh<DVec3>) -> Vec<f64> {
    let (starts, neighbours) = adjacency(mesh);
    let mut distances = vec![f64::INFINITY; mesh.vertices().len()];
    let mut pending = BinaryHeap::new();
    for vertex in 0..mesh.boundary_count() {
        distances[vertex as usize] = 0.0;
        pending.push(Reached { distance: 0.0, vertex });
    }
    while let Some(Reached { distance, vertex }) = pending.pop() {
        let u = vertex as usize;
        if distance > distances[u] {
            continue;
        }
        for &v in &neighbours[starts[u] as usize..starts[u + 1] as usize] {
            let length = distance + mesh.vertices()[u].distance(mesh.vertices()[v as usize]);
            if length < distances[v as usize] {
                distances[v as usize] = length;
                pending.push(Reached { distance: length, vertex: v });
            }
        }
    }
    distances
}

/// For each vertex, the vertices that follow it in its triangles: interior edges appear in both directions.
fn adjacency(mesh: &TriMesh<DVec3>) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; mesh.vertices().len() + 1];
    for &v in mesh.triangles().as_flattened() {
        starts[v as usize + 1] += 1;
    }
    for k in 1..starts.len() {
        starts[k] += starts[k - 1];
    }
    let mut places = starts.clone();
    let mut neighbours = vec![0; 3 * mesh.triangles().len()];
    for corners in mesh.triangles() {
        for (i, &v) in corners.iter().enumerate() {
            neighbours[places[v as usize] as usize] = corners[(i + 1) % 3];
            places[v as usize] += 1;
        }
    }
    (starts, neighbours)
}

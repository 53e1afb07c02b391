//! All places on account of which a surface is no disk, for a picture; the error names the first one of each kind.

use super::duplicates::duplicates;
use super::edges::{EdgeTable, NO_TWIN, ends};
use super::survey::{components, disoriented, fans, has_no_area, largest, repeats};
use super::{Surface, TopologyError};

/// Faulty edges and vertices, as indices of vertices.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Faults {
    /// Edges: those with more than two triangles, between triangles of different orientation, of triangles that have no
    /// area or are there twice, of loops, and of all components but the largest.
    pub edges: Vec<[u32; 2]>,
    /// Vertices: those that join parts without a common edge.
    pub vertices: Vec<u32>,
}

impl TopologyError {
    /// The places that `surface` has this fault at; none where the fault is that of the whole (a closed surface, a
    /// handle), or where there are no places (indices out of range). `surface` must be the one that was refused.
    ///
    /// Cost O(n log d) for n triangles, d at a vertex.
    pub fn places(&self, surface: &Surface) -> Faults {
        match self {
            Self::RepeatedCorner { .. } => of_triangles(surface, repeats),
            Self::Degenerate { .. } => of_triangles(surface, |corners| has_no_area(surface, corners)),
            Self::OneSided { triangle } => of_list(surface, [triangle.index()]),
            Self::Duplicates { .. } => {
                let found = duplicates(&surface.triangles, &table(surface));
                of_list(surface, found.into_iter().map(|[triangle, _]| triangle as usize))
            }
            Self::NonManifoldEdge { .. } => {
                let table = table(surface);
                let crowded = table.edges().filter(|edge| edge.len() > 2);
                of_edges(crowded.map(|edge| ends(&surface.triangles, edge[0].1)))
            }
            Self::Orientation { .. } => {
                let twins = table(surface).twins();
                of_edges(disoriented(&surface.triangles, &twins).map(|(half, _)| ends(&surface.triangles, half)))
            }
            Self::Loops { .. } | Self::NoLoop { .. } => {
                let twins = table(surface).twins();
                let boundary = (0..).zip(&twins).filter(|(_, twin)| **twin == NO_TWIN);
                of_edges(boundary.map(|(half, _)| ends(&surface.triangles, half)))
            }
            Self::NonManifoldVertex { .. } => {
                let edges = table(surface);
                let fans = fans(&surface.triangles, &edges, &edges.twins(), surface.vertices.len());
                of_vertices((0..).zip(fans).filter(|(_, fans)| *fans > 1).map(|(v, _)| v))
            }
            Self::Components { .. } => outside_of_largest(surface),
            Self::Several { faults } => {
                let all = faults.iter().map(|fault| fault.places(surface));
                all.reduce(Faults::and).unwrap_or_default()
            }
            Self::Empty
            | Self::IndexOutOfRange { .. }
            | Self::NotFinite { .. }
            | Self::TooSmall { .. }
            | Self::Closed { .. }
            | Self::FlatHole { .. }
            | Self::Genus { .. } => Faults::default(),
        }
    }
}

impl Faults {
    /// These places and then `others`.
    fn and(mut self, others: Self) -> Self {
        self.edges.extend(others.edges);
        self.vertices.extend(others.vertices);
        self
    }
}

fn table(surface: &Surface) -> EdgeTable {
    EdgeTable::new(&surface.triangles, surface.vertices.len())
}

fn of_edges(edges: impl IntoIterator<Item = [u32; 2]>) -> Faults {
    Faults { edges: edges.into_iter().collect(), vertices: Vec::new() }
}

fn of_vertices(vertices: impl IntoIterator<Item = u32>) -> Faults {
    Faults { edges: Vec::new(), vertices: vertices.into_iter().collect() }
}

/// The edges of the triangles with these numbers.
fn of_list(surface: &Surface, triangles: impl IntoIterator<Item = usize>) -> Faults {
    let edges = |t: usize| (0..3).map(move |i| ends(&surface.triangles, (3 * t + i) as u32));
    of_edges(triangles.into_iter().flat_map(edges))
}

fn of_triangles(surface: &Surface, is_wrong: impl Fn(&[u32; 3]) -> bool) -> Faults {
    of_list(surface, (0..surface.triangles.len()).filter(|&t| is_wrong(&surface.triangles[t])))
}

/// The edges of all components but the largest.
fn outside_of_largest(surface: &Surface) -> Faults {
    let (component, sizes) = components(&table(surface), surface.triangles.len());
    let largest = largest(&sizes);
    of_list(surface, (0..component.len()).filter(|&t| component[t] as usize != largest))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec3;
    use crate::surface::SurfaceMesh;

    /// Vertices on a curve in space, so that no triangle is flat.
    fn faults(vertices: u32, triangles: &[[u32; 3]]) -> Faults {
        let place = |k: u32| DVec3::new(f64::from(k), f64::from(k * k), f64::from(k * k * k));
        let surface = Surface::new((0..vertices).map(place).collect(), triangles.to_vec());
        SurfaceMesh::new(&surface).unwrap_err().places(&surface)
    }

    #[test]
    fn every_fault_has_its_places() {
        let triple = faults(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
        assert_eq!((triple.edges.len(), triple.vertices.len()), (1, 0));
        assert!(triple.edges[0] == [0, 1] || triple.edges[0] == [1, 0]);
        let turned = faults(4, &[[0, 1, 2], [0, 1, 3]]);
        assert_eq!(turned.edges, [[0, 1]]);
        assert_eq!(faults(5, &[[0, 1, 2], [0, 3, 4]]).vertices, [0]);
        let apart = faults(7, &[[0, 1, 2], [0, 2, 3], [4, 5, 6]]);
        assert_eq!(apart.edges, [[5, 6], [6, 4], [4, 5]]);
        let twice = faults(3, &[[0, 1, 2], [0, 1, 2]]);
        assert_eq!(twice.edges, [[1, 2], [2, 0], [0, 1]]);
        let ring = [[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5]];
        let loops = faults(6, &ring).edges;
        assert_eq!(loops.len(), 6);
        assert!(loops.iter().all(|edge| edge.iter().all(|v| *v < 3) || edge.iter().all(|v| *v > 2)), "{loops:?}");
    }

    #[test]
    fn a_fault_of_the_whole_has_none() {
        assert_eq!(faults(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]), Faults::default());
    }
}

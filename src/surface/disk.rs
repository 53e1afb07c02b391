//! A surface that is a disk, numbered as the map needs it: boundary loop first, interior after.

use super::diagnosis::disk_connectivity;
use super::edges::NO_TWIN;
use super::repair::{ADDED, RepairNote, Repaired, drop_repeating, drop_unreferenced, repair};
use super::survey::{check_indices, is_sound};
use super::{Surface, TopologyError};
use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, NO_TRIANGLE, TriMesh, TriangleId, VertexId};

/// A disk in space: one boundary loop, no handles, consistently oriented, no flat triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceMesh {
    /// The boundary loop in the direction of the triangles, from its vertex of least index on;
    /// then the interior in the surface's order. The triangles are in the surface's order too.
    mesh: TriMesh<DVec3>,
    /// For each vertex its index in the surface as it was read, or [`ADDED`].
    vertex_origins: Vec<u32>,
    /// For each triangle its index in the surface as it was read, or [`ADDED`]: it fills a hole.
    triangle_origins: Vec<u32>,
    /// The repairs that were made.
    repairs: Vec<RepairNote>,
    /// For each vertex of the surface its number here, or [`ADDED`] if it was dropped.
    numbers: Vec<u32>,
    /// The positions of the dropped vertices, in the surface's order; that of the first vertex for those without a finite one.
    dropped: Vec<DVec3>,
}

impl SurfaceMesh {
    /// The surface with its triangles unchanged; an error with all faults if it is not a disk. Vertices in no triangle are
    /// dropped with a note, wherever they are, and so are triangles that name a vertex twice, if vertices were merged when the
    /// surface was read. Cost O(n log d).
    pub fn new(surface: &Surface) -> Result<Self, TopologyError> {
        check_indices(surface)?;
        let mut used = Repaired::untouched(surface.clone());
        if surface.merged.is_some() {
            drop_repeating(&mut used);
        }
        drop_unreferenced(&mut used);
        Self::ordered(used, &surface.vertices).map_err(|fault| surface.in_file(fault))
    }

    /// The surface after all safe repairs that it needs; [`Self::repairs`] lists them.
    pub fn repaired(surface: &Surface) -> Result<Self, TopologyError> {
        Self::repaired_around(surface, 0)
    }

    /// As [`Self::repaired`], with the boundary loop number `outline`, counted from 0 by falling length, as the boundary;
    /// the others are filled. Errors: there is no such loop.
    pub fn repaired_around(surface: &Surface, outline: usize) -> Result<Self, TopologyError> {
        let repaired = repair(surface.clone(), outline).and_then(|repaired| Self::ordered(repaired, &surface.vertices));
        repaired.map_err(|fault| surface.in_file(fault))
    }

    /// The mesh.
    pub fn mesh(&self) -> &TriMesh<DVec3> {
        &self.mesh
    }

    /// The compact form of [`Self::origin_of`], for buffers and tables.
    #[cfg(feature = "io")]
    pub(crate) fn vertex_origins(&self) -> &[u32] {
        &self.vertex_origins
    }

    /// The compact form of [`Self::origins_of_triangles`], for buffers and tables.
    #[cfg(feature = "io")]
    pub(crate) fn triangle_origins(&self) -> &[u32] {
        &self.triangle_origins
    }

    /// The vertex of the surface as it was read from which this one comes; `None` if a repair has added it.
    pub fn origin_of(&self, vertex: VertexId) -> Option<VertexId> {
        Some(self.vertex_origins[vertex.index()]).filter(|&origin| origin != ADDED).map(VertexId::new)
    }

    /// The triangle of the surface as it was read from which this one comes; `None` if a repair has added it.
    pub fn origin_of_triangle(&self, triangle: TriangleId) -> Option<TriangleId> {
        original(self.triangle_origins[triangle.index()])
    }

    /// [`Self::origin_of_triangle`] of all triangles in order.
    pub fn origins_of_triangles(&self) -> impl Iterator<Item = Option<TriangleId>> {
        self.triangle_origins.iter().copied().map(original)
    }

    /// The number of triangles that come from the surface as it was read; those that fill holes come after them.
    pub(super) fn given_count(&self) -> usize {
        self.triangle_origins.partition_point(|&origin| origin != ADDED)
    }

    /// The repairs that were made.
    pub fn repairs(&self) -> &[RepairNote] {
        &self.repairs
    }

    /// For each corner of a triangle, which corner of the same triangle it is in `surface`, from which this mesh was
    /// made: repairs reverse some triangles. `None` where they gave it other corners.
    pub fn corners_in(&self, surface: &Surface, triangle: TriangleId) -> Option<[usize; 3]> {
        let corners = self.mesh.corners(triangle).map(|v| self.vertex_origins[v.index()]);
        let given = surface.triangles.get(self.triangle_origins[triangle.index()] as usize)?;
        let [a, b, c] = corners.map(|corner| given.iter().position(|&v| v == corner));
        Some([a?, b?, c?])
    }

    /// The weights of a point at the corners of its triangle in `surface`; where repairs gave this other corners, at its own.
    pub fn weights_in(&self, surface: &Surface, point: BarycentricPoint) -> [f64; 3] {
        let mut weights = [0.0; 3];
        let corners = self.corners_in(surface, point.triangle()).unwrap_or([0, 1, 2]);
        for (i, weight) in corners.into_iter().zip(point.weights()) {
            weights[i] = weight;
        }
        weights
    }

    fn ordered(repaired: Repaired, before: &[DVec3]) -> Result<Self, TopologyError> {
        let found = disk_connectivity(&repaired)?;
        let Repaired { surface, vertex_origins, triangle_origins, split, notes: repairs } = repaired;
        let before = [before, &split].concat();
        let boundary = found.loops.first().map(Vec::as_slice).unwrap_or_default();
        let mut is_on_boundary = vec![false; surface.vertices.len()];
        for &v in boundary {
            is_on_boundary[v as usize] = true;
        }
        let mut order = boundary.to_vec();
        order.extend((0..surface.vertices.len() as u32).filter(|&v| !is_on_boundary[v as usize]));
        let mut number = vec![0; order.len()];
        for (k, &v) in (0..).zip(&order) {
            number[v as usize] = k;
        }
        let across = |twin: u32| if twin == NO_TWIN { NO_TRIANGLE } else { twin / 3 };
        let mesh = TriMesh::known_sound(
            order.iter().map(|&v| surface.vertices[v as usize]).collect(),
            boundary.len() as u32,
            surface.triangles.iter().map(|t| t.map(|v| number[v as usize])).collect(),
            found.twins.as_chunks::<3>().0.iter().map(|twins| twins.map(across)).collect(),
        );
        let vertex_origins: Vec<u32> = order.iter().map(|&v| vertex_origins[v as usize]).collect();
        let numbers = numbers_of(&vertex_origins, before.len());
        let is_dropped = |(_, number): &(&DVec3, &u32)| **number == ADDED;
        let finite = |(&position, _)| if is_sound(position) { position } else { mesh.vertices()[0] };
        let dropped = before.iter().zip(&numbers).filter(is_dropped).map(finite).collect();
        Ok(Self { mesh, vertex_origins, triangle_origins, repairs, numbers, dropped })
    }

    /// From parts of unknown origin, such as a worker's message; `None` if they do not fit together. `dropped` are the
    /// positions of the vertices that a repair has dropped, in the surface's order.
    #[cfg(feature = "io")]
    pub(crate) fn from_parts(
        mesh: TriMesh<DVec3>,
        vertex_origins: Vec<u32>,
        triangle_origins: Vec<u32>,
        repairs: Vec<RepairNote>,
        dropped: Vec<DVec3>,
    ) -> Option<Self> {
        let kept = vertex_origins.iter().filter(|&&origin| origin != ADDED).count();
        let before = kept + dropped.len();
        let sizes = (vertex_origins.len(), triangle_origins.len()) == (mesh.vertices().len(), mesh.triangles().len());
        let known = vertex_origins.iter().all(|&origin| origin == ADDED || (origin as usize) < before);
        if !(sizes && known) {
            return None;
        }
        let numbers = numbers_of(&vertex_origins, before);
        let is_complete = numbers.iter().filter(|&&number| number == ADDED).count() == dropped.len();
        is_complete.then_some(Self { mesh, vertex_origins, triangle_origins, repairs, numbers, dropped })
    }

    /// The number here of a vertex of the surface as it was read; `None` if it was dropped or did not exist.
    pub fn number_of(&self, origin: VertexId) -> Option<VertexId> {
        self.numbers.get(origin.index()).copied().filter(|&number| number != ADDED).map(VertexId::new)
    }

    /// The positions of all vertices of the surface as it was read, those of dropped vertices too, in its order.
    pub fn origin_positions(&self) -> impl Iterator<Item = DVec3> + '_ {
        let (vertices, mut dropped) = (self.mesh.vertices(), self.dropped.iter());
        let position = move |&number: &u32| vertices.get(number as usize).or_else(|| dropped.next());
        self.numbers.iter().filter_map(position).copied()
    }

    /// The positions of the dropped vertices, in the surface's order.
    #[cfg(feature = "io")]
    pub(crate) fn dropped(&self) -> &[DVec3] {
        &self.dropped
    }

    /// The number of vertices of the surface as it was read.
    pub fn origin_count(&self) -> usize {
        self.numbers.len()
    }
}

/// The triangle with this number in [`SurfaceMesh::triangle_origins`].
fn original(number: u32) -> Option<TriangleId> {
    (number != ADDED).then(|| TriangleId::new(number))
}

/// For each of `before` vertices its position in `origins`, or [`ADDED`].
fn numbers_of(origins: &[u32], before: usize) -> Vec<u32> {
    let mut numbers = vec![ADDED; before];
    for (k, &origin) in origins.iter().enumerate().filter(|(_, origin)| **origin != ADDED) {
        numbers[origin as usize] = k as u32;
    }
    numbers
}

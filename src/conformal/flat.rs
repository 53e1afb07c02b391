//! Prepared sides as flat arrays, which cross a worker boundary by transfer.
//!
//! A side is written part by part in a fixed order and read in the same order;
//! the reader validates everything: `None` for arrays that the writer does not produce.

use super::system::DirichletSystem;
use super::{HarmonicTable, PrepareTimings, Unsharpened};
use crate::laplace::{Factor, FactorBuffers, Pcg, PcgBuffers, Solver};
use crate::mesh::TriMesh;
use crate::surface::RepairNote;
use sprs::CsMatI;

/// A [`super::PreparedSide`] as flat arrays.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct FlatBuffers {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
    /// The repairs of a surface.
    pub repairs: Vec<RepairNote>,
    /// Whether an integral equation follows.
    pub expected: Expected,
}

/// Whether an integral equation follows a side.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub(crate) enum Expected {
    /// None was requested.
    #[default]
    FiniteElements,
    /// It does.
    Equation,
    /// It was requested, and there is none.
    Refused(Unsharpened),
}

/// A point as its coordinates.
pub(super) trait Coordinates<const D: usize>: Copy {
    fn to_coordinates(self) -> [f64; D];
    fn from_coordinates(coordinates: [f64; D]) -> Self;
}

impl Coordinates<2> for crate::geometry::DVec2 {
    fn to_coordinates(self) -> [f64; 2] {
        self.to_array()
    }

    fn from_coordinates(coordinates: [f64; 2]) -> Self {
        Self::from_array(coordinates)
    }
}

impl Coordinates<3> for crate::geometry::DVec3 {
    fn to_coordinates(self) -> [f64; 3] {
        self.to_array()
    }

    fn from_coordinates(coordinates: [f64; 3]) -> Self {
        Self::from_array(coordinates)
    }
}

impl FlatBuffers {
    pub(super) fn put_mesh<const D: usize, P: Coordinates<D>>(&mut self, mesh: &TriMesh<P>) {
        self.floats.push(mesh.vertices().iter().flat_map(|p| p.to_coordinates()).collect());
        self.indices.push(vec![mesh.boundary_count()]);
        self.indices.push(mesh.triangles().as_flattened().to_vec());
        self.indices.push(mesh.neighbours().as_flattened().to_vec());
    }

    pub(super) fn put_system(&mut self, system: &DirichletSystem) {
        let DirichletSystem { coupling, solver, table, .. } = system;
        let flags = [matches!(solver, Solver::Direct(_)), table.is_some()].map(u32::from);
        self.indices.extend([flags.to_vec(), coupling.proper_indptr().into_owned(), coupling.indices().to_vec()]);
        self.floats.push(coupling.data().to_vec());
        match solver {
            Solver::Direct(factor) => {
                let FactorBuffers { forward, chunks, rows, values } = factor.to_buffers();
                self.indices.extend([forward, chunks, rows]);
                self.floats.push(values);
            }
            Solver::Pcg { pcg, .. } => {
                let PcgBuffers { starts, columns, matrix, factor } = pcg.to_buffers();
                self.indices.extend([starts, columns]);
                self.floats.extend([matrix, factor]);
            }
        }
        self.floats.extend(table.as_ref().map(|table| table.values().to_vec()));
    }

    pub(super) fn put_timings(&mut self, timings: &PrepareTimings) {
        let PrepareTimings { sample, mesh, assemble, order, factor, table, integral } = *timings;
        self.floats.push(vec![sample, mesh, assemble, order, factor, table, integral]);
    }
}

/// Reads the arrays of [`FlatBuffers`] in order.
pub(super) struct FlatReader {
    floats: std::vec::IntoIter<Vec<f64>>,
    indices: std::vec::IntoIter<Vec<u32>>,
}

impl FlatReader {
    pub fn new(buffers: FlatBuffers) -> Self {
        Self { floats: buffers.floats.into_iter(), indices: buffers.indices.into_iter() }
    }

    pub fn floats(&mut self) -> Option<Vec<f64>> {
        self.floats.next()
    }

    pub fn indices(&mut self) -> Option<Vec<u32>> {
        self.indices.next()
    }

    /// The next mesh; `None` if an index is out of range.
    pub fn mesh<const D: usize, P: Coordinates<D>>(&mut self) -> Option<TriMesh<P>> {
        let (vertices, counts, triangles, neighbours) =
            (self.floats()?, self.indices()?, self.indices()?, self.indices()?);
        let (places, odd) = vertices.as_chunks::<D>();
        let (triangles, more) = triangles.as_chunks::<3>();
        let (neighbours, rest) = neighbours.as_chunks::<3>();
        let &[boundary_count] = counts.as_slice() else { return None };
        if !(odd.is_empty() && more.is_empty() && rest.is_empty()) {
            return None;
        }
        let vertices = places.iter().map(|&p| P::from_coordinates(p)).collect();
        TriMesh::checked(vertices, boundary_count, triangles.to_vec(), neighbours.to_vec())
    }

    /// The system of n unknowns and m boundary vertices.
    pub fn system(&mut self, n: usize, m: usize) -> Option<DirichletSystem> {
        let flags = self.indices()?;
        let &[direct, has_table] = flags.as_slice() else { return None };
        let coupling = CsMatI::try_new_csc((n, m), self.indices()?, self.indices()?, self.floats()?).ok()?;
        let solver = if direct != 0 {
            let (forward, chunks, rows) = (self.indices()?, self.indices()?, self.indices()?);
            Solver::Direct(Factor::from_buffers(FactorBuffers { forward, chunks, rows, values: self.floats()? })?)
        } else {
            let (starts, columns) = (self.indices()?, self.indices()?);
            let (matrix, factor) = (self.floats()?, self.floats()?);
            Solver::from(Pcg::from_buffers(PcgBuffers { starts, columns, matrix, factor })?)
        };
        let table = if has_table != 0 { Some(HarmonicTable::from_values(self.floats()?, n, m)?) } else { None };
        (solver.len() == n).then(|| DirichletSystem::new(coupling, solver, table))
    }

    pub fn timings(&mut self) -> Option<PrepareTimings> {
        let values = self.floats()?;
        let &[sample, mesh, assemble, order, factor, table, integral] = values.as_slice() else { return None };
        Some(PrepareTimings { sample, mesh, assemble, order, factor, table, integral })
    }

    /// Whether all arrays have been read.
    pub fn is_at_end(&mut self) -> bool {
        self.floats.next().is_none() && self.indices.next().is_none()
    }
}

//! A prepared domain as flat arrays, so that it crosses a worker boundary by transfer.

use super::HarmonicTable;
use super::{PrepareTimings, PreparedDomain};
use crate::geometry::DVec2;
use crate::laplace::{Factor, FactorBuffers, Pcg, PcgBuffers, Solver};
use crate::mesh::{NO_TRIANGLE, RefineReport, TriMesh};
use crate::outline::BoundarySamples;
use sprs::CsMatI;

/// A [`PreparedDomain`] as flat arrays.
#[derive(Debug, Clone, PartialEq)]
pub struct DomainBuffers {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
}

impl PreparedDomain {
    /// As flat arrays.
    pub fn to_buffers(&self) -> DomainBuffers {
        let t = &self.timings;
        let scalars = vec![self.pole.x, self.pole.y, t.sample, t.mesh, t.assemble, t.order, t.factor, t.table];
        let pointers = self.coupling.proper_indptr().into_owned();
        let flags = [self.refinement.complete, matches!(self.solver, Solver::Direct(_)), self.table.is_some()];
        let counts = flags.map(u32::from).into_iter().chain([self.refinement.added as u32]).collect();
        let mut buffers = DomainBuffers {
            floats: vec![
                scalars,
                flat(&self.mesh.vertices),
                self.samples.edge_lengths.clone(),
                self.samples.fractions.clone(),
                self.coupling.data().to_vec(),
            ],
            indices: vec![
                counts,
                self.mesh.triangles.as_flattened().to_vec(),
                self.mesh.neighbours.as_flattened().to_vec(),
                pointers,
                self.coupling.indices().to_vec(),
            ],
        };
        match &self.solver {
            Solver::Direct(factor) => {
                let FactorBuffers { forward, chunks, rows, values } = factor.to_buffers();
                buffers.indices.extend([forward, chunks, rows]);
                buffers.floats.push(values);
            }
            Solver::Pcg { pcg, .. } => {
                let PcgBuffers { starts, columns, matrix, factor } = pcg.to_buffers();
                buffers.indices.extend([starts, columns]);
                buffers.floats.extend([matrix, factor]);
            }
        }
        buffers.floats.extend(self.table.as_ref().map(|table| table.values().to_vec()));
        buffers
    }

    /// From flat arrays; `None` if they are not what [`Self::to_buffers`] makes.
    pub fn from_buffers(buffers: DomainBuffers) -> Option<Self> {
        let (mut floats, mut indices) = (buffers.floats.into_iter(), buffers.indices.into_iter());
        let (scalars, counts) = (floats.next()?, indices.next()?);
        let &[pole_x, pole_y, sample, mesh, assemble, order, factor, table] = scalars.as_slice() else { return None };
        let &[complete, direct, has_table, added] = counts.as_slice() else { return None };
        let timings = PrepareTimings { sample, mesh, assemble, order, factor, table };
        let (vertices, edge_lengths, fractions) = (floats.next()?, floats.next()?, floats.next()?);
        let m = edge_lengths.len();
        let mesh = mesh_from(&vertices, m, &indices.next()?, &indices.next()?)?;
        let n = mesh.interior_count();
        let samples = BoundarySamples { points: mesh.vertices[..m].to_vec(), edge_lengths, fractions };
        let ordered = samples.fractions.windows(2).all(|pair| pair[0] < pair[1]);
        if samples.fractions.len() != m || !ordered {
            return None;
        }
        let coupling = CsMatI::try_new_csc((n, m), indices.next()?, indices.next()?, floats.next()?).ok()?;
        let solver = if direct != 0 {
            let (forward, chunks, rows) = (indices.next()?, indices.next()?, indices.next()?);
            Solver::Direct(Factor::from_buffers(FactorBuffers { forward, chunks, rows, values: floats.next()? })?)
        } else {
            let (starts, columns) = (indices.next()?, indices.next()?);
            let (matrix, factor) = (floats.next()?, floats.next()?);
            Solver::from(Pcg::from_buffers(PcgBuffers { starts, columns, matrix, factor })?)
        };
        let table = if has_table != 0 { Some(HarmonicTable::from_values(floats.next()?, n, m)?) } else { None };
        if solver.len() != n || floats.next().is_some() || indices.next().is_some() {
            return None;
        }
        let refinement = RefineReport { complete: complete != 0, added: added as usize };
        let pole = DVec2::new(pole_x, pole_y);
        Some(Self::new(samples, mesh, refinement, coupling, solver, table, pole, timings))
    }
}

fn flat(points: &[DVec2]) -> Vec<f64> {
    points.iter().flat_map(DVec2::to_array).collect()
}

fn mesh_from(vertices: &[f64], boundary: usize, triangles: &[u32], neighbours: &[u32]) -> Option<TriMesh> {
    let (pairs, odd) = vertices.as_chunks::<2>();
    let (triangles, more) = triangles.as_chunks::<3>();
    let (neighbours, rest) = neighbours.as_chunks::<3>();
    let count = pairs.len();
    let sound = odd.is_empty()
        && more.is_empty()
        && rest.is_empty()
        && (3..=count).contains(&boundary)
        && triangles.len() == neighbours.len()
        && triangles.as_flattened().iter().all(|&v| (v as usize) < count)
        && neighbours.as_flattened().iter().all(|&t| t == NO_TRIANGLE || (t as usize) < triangles.len());
    sound.then(|| TriMesh {
        vertices: pairs.iter().map(|&p| DVec2::from_array(p)).collect(),
        boundary_count: boundary as u32,
        triangles: triangles.to_vec(),
        neighbours: neighbours.to_vec(),
    })
}

//! A prepared domain as flat arrays, so that it crosses a worker boundary by transfer.

use super::{PrepareTimings, PreparedDomain};
use crate::geometry::DVec2;
use crate::laplace::{Factor, FactorBuffers};
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
        let factor = self.factor.to_buffers();
        let t = &self.timings;
        let scalars = vec![self.pole.x, self.pole.y, t.sample, t.mesh, t.assemble, t.order, t.factor];
        let pointers = self.coupling.proper_indptr().into_owned();
        let counts = vec![u32::from(self.refinement.complete), self.refinement.added as u32];
        DomainBuffers {
            floats: vec![
                scalars,
                flat(&self.mesh.vertices),
                self.samples.edge_lengths.clone(),
                self.samples.fractions.clone(),
                self.coupling.data().to_vec(),
                factor.values,
            ],
            indices: vec![
                counts,
                self.mesh.triangles.as_flattened().to_vec(),
                self.mesh.neighbours.as_flattened().to_vec(),
                pointers,
                self.coupling.indices().to_vec(),
                factor.forward,
                factor.chunks,
                factor.rows,
            ],
        }
    }

    /// From flat arrays; `None` if they are not what [`Self::to_buffers`] makes.
    pub fn from_buffers(buffers: DomainBuffers) -> Option<Self> {
        let [scalars, vertices, edge_lengths, fractions, couplings, values] =
            <[Vec<f64>; 6]>::try_from(buffers.floats).ok()?;
        let [counts, triangles, neighbours, pointers, rows_of_coupling, forward, chunks, rows] =
            <[Vec<u32>; 8]>::try_from(buffers.indices).ok()?;
        let &[pole_x, pole_y, sample, mesh, assemble, order, factor] = scalars.as_slice() else { return None };
        let &[complete, added] = counts.as_slice() else { return None };
        let timings = PrepareTimings { sample, mesh, assemble, order, factor };
        let mesh = mesh_from(&vertices, edge_lengths.len(), &triangles, &neighbours)?;
        let m = edge_lengths.len();
        let samples = BoundarySamples { points: mesh.vertices[..m].to_vec(), edge_lengths, fractions };
        let ordered = samples.fractions.windows(2).all(|pair| pair[0] < pair[1]);
        if samples.fractions.len() != m || !ordered || forward.len() != mesh.interior_count() {
            return None;
        }
        let factor = Factor::from_buffers(FactorBuffers { forward, chunks, rows, values })?;
        let shape = (mesh.interior_count(), m);
        let coupling = CsMatI::try_new_csc(shape, pointers, rows_of_coupling, couplings).ok()?;
        let refinement = RefineReport { complete: complete != 0, added: added as usize };
        let pole = DVec2::new(pole_x, pole_y);
        Some(Self::new(samples, mesh, refinement, coupling, factor, pole, timings))
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

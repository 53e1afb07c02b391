//! A prepared domain as flat arrays, and back.

use super::PreparedDomain;
use super::flat::{FlatBuffers, FlatReader, sound_boundary};
use crate::geometry::DVec2;
use crate::mesh::RefineReport;
use crate::outline::BoundarySamples;

impl PreparedDomain {
    /// As flat arrays.
    pub fn to_buffers(&self) -> FlatBuffers {
        let mut buffers = FlatBuffers::default();
        buffers.floats.push(self.pole.to_array().to_vec());
        buffers.indices.push(vec![u32::from(self.refinement.complete), self.refinement.added as u32]);
        buffers.put_timings(&self.timings);
        buffers.put_mesh(&self.mesh);
        buffers.floats.extend([self.samples.edge_lengths.clone(), self.samples.fractions.clone()]);
        buffers.put_system(&self.coupling, &self.solver, self.table.as_ref());
        buffers
    }

    /// From flat arrays; `None` if they are not what [`Self::to_buffers`] makes.
    pub fn from_buffers(buffers: FlatBuffers) -> Option<Self> {
        let mut reader = FlatReader::new(buffers);
        let pole = DVec2::from_array(reader.floats()?.try_into().ok()?);
        let [complete, added]: [u32; 2] = reader.indices()?.try_into().ok()?;
        let refinement = RefineReport { complete: complete != 0, added: added as usize };
        let timings = reader.timings()?;
        let mesh = reader.mesh::<2, DVec2>()?;
        let m = mesh.boundary_count as usize;
        let (edge_lengths, fractions) = (reader.floats()?, reader.floats()?);
        if !sound_boundary(&edge_lengths, &fractions, m) {
            return None;
        }
        let samples = BoundarySamples { points: mesh.vertices[..m].to_vec(), edge_lengths, fractions };
        let system = reader.system(mesh.interior_count(), m)?;
        let whole = reader.is_at_end();
        whole.then(|| Self::new(samples, mesh, refinement, system.coupling, system.solver, system.table, pole, timings))
    }
}

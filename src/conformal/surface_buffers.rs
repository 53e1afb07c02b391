//! A prepared surface as flat arrays, and back.

use super::PreparedSurface;
use super::flat::{FlatBuffers, FlatReader};
use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, FlipReport};
use crate::surface::SurfaceMesh;

impl PreparedSurface {
    /// As flat arrays.
    pub fn to_buffers(&self) -> FlatBuffers {
        let FlipReport { flips, negative_before, negative_after } = self.flips;
        let counts = [flips, negative_before, negative_after, self.surface.origin_count()].map(|count| count as u32);
        let mut buffers = FlatBuffers::default();
        buffers.floats.push(self.centre.weights.to_vec());
        buffers.indices.push([&counts[..], &[self.centre.triangle]].concat());
        buffers.put_timings(&self.timings);
        buffers.put_mesh(&self.surface.mesh);
        buffers.indices.extend([self.surface.vertex_origins.clone(), self.surface.triangle_origins.clone()]);
        buffers.put_system(&self.coupling, &self.solver, self.table.as_ref());
        // Plain data: it always has a form as text.
        buffers.text = serde_json::to_string(&self.surface.repairs).unwrap_or_default();
        buffers
    }

    /// From flat arrays; `None` if they are not what [`Self::to_buffers`] makes.
    pub fn from_buffers(buffers: FlatBuffers) -> Option<Self> {
        let repairs = serde_json::from_str(&buffers.text).ok()?;
        let mut reader = FlatReader::new(buffers);
        let weights: [f64; 3] = reader.floats()?.try_into().ok()?;
        let [flips, negative_before, negative_after, before, triangle]: [u32; 5] = reader.indices()?.try_into().ok()?;
        let timings = reader.timings()?;
        let mesh = reader.mesh::<3, DVec3>()?;
        let (n, m) = (mesh.interior_count(), mesh.boundary_count as usize);
        let (vertex_origins, triangle_origins) = (reader.indices()?, reader.indices()?);
        if triangle as usize >= mesh.triangles.len() {
            return None;
        }
        let surface = SurfaceMesh::from_parts(mesh, vertex_origins, triangle_origins, repairs, before as usize)?;
        let system = reader.system(n, m)?;
        let [flips, negative_before, negative_after] = [flips, negative_before, negative_after].map(|k| k as usize);
        let flips = FlipReport { flips, negative_before, negative_after };
        let whole = reader.is_at_end();
        whole.then(|| Self::new(surface, system, flips, BarycentricPoint { triangle, weights }, timings))
    }
}

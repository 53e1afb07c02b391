//! Conversion of a prepared side to flat arrays and back.

use super::domain::MeshedDomain;
use super::flat::{Expected, FlatBuffers, FlatReader};
use super::prepared_side::{PreparedSide, Sharpness, SideGeometry};
use super::surface::MeshedSurface;
use crate::geometry::{DVec2, DVec3};
use crate::mesh::{BarycentricPoint, FlipReport, RefineReport, TriangleId};
use crate::outline::BoundarySamples;
use crate::surface::{RepairNote, SurfaceMesh};
use std::sync::Arc;

/// The content of the first index array: the kind of geometry that follows.
const PLANE: u32 = 0;
const SPACE: u32 = 1;

/// The integral equation of a side does not travel with the side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the integral equation of a side travels apart from the side")]
pub struct NotFlat;

impl PreparedSide {
    /// Converts the side to flat arrays. Errors: the side has its integral equation already, which travels as
    /// [`super::FlatEquation`].
    pub(crate) fn to_buffers(&self) -> Result<FlatBuffers, NotFlat> {
        let expected = match self.sharpness() {
            Sharpness::FiniteElements => Expected::FiniteElements,
            Sharpness::Awaited => Expected::Equation,
            Sharpness::Stays(reason) => Expected::Refused(reason.clone()),
            Sharpness::Integral(_) => return Err(NotFlat),
        };
        let mut buffers = FlatBuffers { expected, ..FlatBuffers::default() };
        match self.geometry() {
            SideGeometry::Plane(domain) => buffers.put_domain(domain),
            SideGeometry::Space(surface) => buffers.put_surface(surface),
        }
        buffers.put_timings(&self.timings());
        buffers.put_system(&self.system);
        Ok(buffers)
    }

    /// The side from flat arrays; `None` unless they have the layout that [`Self::to_buffers`] writes.
    pub(crate) fn from_buffers(mut buffers: FlatBuffers) -> Option<Self> {
        let repairs = std::mem::take(&mut buffers.repairs);
        let sharpness = match std::mem::take(&mut buffers.expected) {
            Expected::FiniteElements => Sharpness::FiniteElements,
            Expected::Equation => Sharpness::Awaited,
            Expected::Refused(reason) => Sharpness::Stays(reason),
        };
        let mut reader = FlatReader::new(buffers);
        let geometry = match *reader.indices()?.as_slice() {
            [PLANE] => SideGeometry::Plane(Arc::new(reader.domain()?)),
            [SPACE] => SideGeometry::Space(Arc::new(reader.surface(repairs)?)),
            _ => return None,
        };
        let timings = reader.timings()?;
        let system = reader.system(geometry.interior_count(), geometry.boundary_count())?;
        reader.is_at_end().then(|| Self::new(geometry, system, timings).with_sharpness(sharpness))
    }
}

impl FlatBuffers {
    fn put_domain(&mut self, domain: &MeshedDomain) {
        let (samples, refinement) = (domain.samples(), domain.refinement());
        self.indices.push(vec![PLANE]);
        self.floats.push(domain.default_point().to_array().to_vec());
        self.indices.push(vec![u32::from(refinement.complete), refinement.added as u32]);
        self.put_mesh(domain.mesh());
        self.floats.extend([samples.edge_lengths().to_vec(), samples.fractions().to_vec()]);
    }

    fn put_surface(&mut self, meshed: &MeshedSurface) {
        let (surface, centre) = (meshed.surface(), meshed.centre());
        let FlipReport { flips, negative_before, negative_after } = meshed.flips();
        let counts = [flips, negative_before, negative_after].map(|count| count as u32);
        self.indices.push(vec![SPACE]);
        self.floats.push(centre.weights().to_vec());
        self.indices.push([&counts[..], &[centre.triangle().number()]].concat());
        self.put_mesh(surface.mesh());
        self.indices.extend([surface.vertex_origins().to_vec(), surface.triangle_origins().to_vec()]);
        self.floats.push(surface.dropped().iter().flat_map(DVec3::to_array).collect());
        self.repairs = surface.repairs().to_vec();
    }
}

impl FlatReader {
    fn domain(&mut self) -> Option<MeshedDomain> {
        let default_point = DVec2::from_array(self.floats()?.try_into().ok()?);
        let [complete, added]: [u32; 2] = self.indices()?.try_into().ok()?;
        let refinement = RefineReport { complete: complete != 0, added: added as usize };
        let mesh = self.mesh::<2, DVec2>()?;
        let samples = BoundarySamples::checked(mesh.boundary().to_vec(), self.floats()?, self.floats()?)?;
        Some(MeshedDomain::from_parts(samples, mesh, refinement, default_point))
    }

    fn surface(&mut self, repairs: Vec<RepairNote>) -> Option<MeshedSurface> {
        let weights: [f64; 3] = self.floats()?.try_into().ok()?;
        let [flips, negative_before, negative_after, triangle]: [u32; 4] = self.indices()?.try_into().ok()?;
        let mesh = self.mesh::<3, DVec3>()?;
        let (vertex_origins, triangle_origins) = (self.indices()?, self.indices()?);
        if triangle as usize >= mesh.triangles().len() {
            return None;
        }
        let dropped = self.floats()?;
        let (dropped, []) = dropped.as_chunks::<3>() else { return None };
        let dropped = dropped.iter().copied().map(DVec3::from_array).collect();
        let surface = SurfaceMesh::from_parts(mesh, vertex_origins, triangle_origins, repairs, dropped)?;
        let [flips, negative_before, negative_after] = [flips, negative_before, negative_after].map(|k| k as usize);
        let flips = FlipReport { flips, negative_before, negative_after };
        Some(MeshedSurface::from_parts(surface, flips, BarycentricPoint::new(TriangleId::new(triangle), weights)))
    }
}

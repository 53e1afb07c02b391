//! The surface that is shown, and its map.
//!
//! No egui in here: it is a part of the model.

use super::SurfacePreparation;
use crate::conformal::{PreparedDomain, PreparedSurface, SurfaceConstraints, SurfaceMap, SurfaceMapError};
use crate::geometry::{DVec2, DVec3};
use crate::laplace::Lanes;
use crate::mesh::{BarycentricPoint, NO_TRIANGLE};
use crate::render::BoundingSphere;
use crate::session::{SurfaceShape, SurfaceState};
use std::sync::Arc;

/// The share of a point's weight that corners on the boundary may have: nearer to the loop harmonic
/// measure is a peak that no drag can hold still.
const MOST_BOUNDARY_WEIGHT: f64 = 0.9;

/// Towards the eye, for surfaces by formula: a little from the right and above.
pub(super) const PRESET_EYE: DVec3 = DVec3::new(0.35, -0.75, 0.6);

/// A front that points this much along y has z upwards.
const STEEP: f64 = 0.9;
/// How far the eye is beside and above the front of a surface from a file: a shape is read better so.
const TURNED: f64 = 0.35;
const RAISED: f64 = 0.3;

/// The direction of the sum of all normals: by Stokes' theorem that of the loop's vector area ½ Σ p × q.
fn front(boundary: &[DVec3]) -> DVec3 {
    let next = boundary.iter().cycle().skip(1);
    let area: DVec3 = boundary.iter().zip(next).map(|(p, q)| (*p - boundary[0]).cross(*q - boundary[0])).sum();
    area.normalize_or(DVec3::Z)
}

/// The surface side of the model.
#[derive(Debug, Default)]
pub struct SurfaceSide {
    /// The way to the next surface.
    pub preparation: SurfacePreparation,
    /// The surface that is shown; the map may still be missing.
    shown: Option<Arc<PreparedSurface>>,
    map: Option<SurfaceMap>,
    /// The conformal polar coordinates of the surface, where they are shown.
    disk: Vec<DVec2>,
    scratch: Vec<Lanes<2>>,
}

impl SurfaceSide {
    /// Takes over the surface that was prepared.
    pub fn renew(&mut self) {
        self.shown = self.preparation.surface().map(Arc::clone);
        self.map = None;
    }

    /// The surface.
    pub fn surface(&self) -> Option<&Arc<PreparedSurface>> {
        self.shown.as_ref()
    }

    /// Its map.
    pub fn map(&self) -> Option<&SurfaceMap> {
        self.map.as_ref()
    }

    /// A ball around it.
    pub fn scene(&self) -> Option<BoundingSphere> {
        self.shown.as_ref().map(|surface| BoundingSphere::of(&surface.surface.mesh.vertices))
    }

    /// From where the surface is looked at first, and which way is up: z for those by formula;
    /// a surface from a file shows its front, which is where the sum of its normals points.
    pub fn default_view(&self, state: &SurfaceState) -> (DVec3, DVec3) {
        match (&state.spec.shape, &self.shown) {
            (SurfaceShape::File { .. }, Some(surface)) => {
                let mesh = &surface.surface.mesh;
                let front = front(&mesh.vertices[..mesh.boundary_count as usize]);
                let up = if front.y.abs() < STEEP { DVec3::Y } else { DVec3::Z };
                let right = up.cross(front).normalize_or(DVec3::X);
                (front + TURNED * right + RAISED * up, up)
            }
            _ => (PRESET_EYE, DVec3::Z),
        }
    }

    /// g at the vertices of the surface, see [`crate::conformal::surface_disk_coordinates`]; empty before
    /// [`Self::follow_disk`].
    pub fn disk_coordinates(&self) -> &[DVec2] {
        &self.disk
    }

    /// Brings the disk coordinates to the map.
    pub fn follow_disk(&mut self) -> Result<(), crate::laplace::NotConverged> {
        let Some(map) = &self.map else { return Ok(()) };
        crate::conformal::surface_disk_coordinates(map.surface(), map.measure(), &mut self.disk, &mut self.scratch)
    }

    /// The interior point where its handle is.
    pub fn point(&self, state: &SurfaceState) -> Option<BarycentricPoint> {
        let surface = self.shown.as_ref()?;
        let count = surface.surface.mesh.triangles.len();
        Some(state.point.filter(|point| (point.triangle as usize) < count).unwrap_or(surface.centre))
    }

    /// Where the interior point lies in space.
    pub fn place(&self, state: &SurfaceState) -> Option<DVec3> {
        Some(self.shown.as_ref()?.position(self.point(state)?))
    }

    /// Where the boundary point lies in space.
    pub fn anchor_place(&self, state: &SurfaceState) -> Option<DVec3> {
        let surface = self.shown.as_ref()?;
        Some(surface.boundary_position(surface.at_fraction(state.anchor)))
    }

    /// The point near `found` that the interior handle may take: a little inside of the loop.
    pub fn interior_near(&self, found: BarycentricPoint) -> Option<BarycentricPoint> {
        let mesh = &self.shown.as_ref()?.surface.mesh;
        let corners = mesh.triangles[found.triangle as usize];
        let on_loop = corners.map(|v| v < mesh.boundary_count);
        let sum: f64 = (0..3).filter(|&i| on_loop[i]).map(|i| found.weights[i]).sum();
        if sum <= MOST_BOUNDARY_WEIGHT {
            return Some(found);
        }
        let BarycentricPoint { triangle, mut weights } = found;
        let inner = on_loop.iter().filter(|on_loop| !**on_loop).count();
        if inner == 0 {
            // An ear or a bridge between two boundaries: the middle is as far from them as one can be.
            let open = mesh.neighbours[triangle as usize].contains(&NO_TRIANGLE);
            return Some(BarycentricPoint { triangle, weights: if open { [1.0 / 3.0; 3] } else { weights } });
        }
        for i in 0..3 {
            weights[i] = if on_loop[i] {
                weights[i] * MOST_BOUNDARY_WEIGHT / sum
            } else {
                weights[i] + (sum - MOST_BOUNDARY_WEIGHT) / inner as f64
            };
        }
        let total: f64 = weights.iter().sum();
        Some(BarycentricPoint { triangle, weights: weights.map(|w| w / total) })
    }

    /// The map under `constraints`, anew.
    pub fn rebuild(
        &mut self,
        source: &Arc<PreparedDomain>,
        constraints: &SurfaceConstraints,
    ) -> Result<(), SurfaceMapError> {
        let Some(surface) = &self.shown else { return Ok(()) };
        self.map = Some(SurfaceMap::new(Arc::clone(source), Arc::clone(surface), constraints)?);
        Ok(())
    }

    /// Brings the map to `constraints`.
    pub fn update(&mut self, constraints: &SurfaceConstraints) -> Result<(), SurfaceMapError> {
        self.map.as_mut().map_or(Ok(()), |map| map.update(constraints))
    }
}

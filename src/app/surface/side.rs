//! The surface that is shown, and its map.
//!
//! No egui in here: it is a part of the model.

use super::SurfacePreparation;
use crate::conformal::{PreparedDomain, PreparedSurface, SurfaceConstraints, SurfaceMap, SurfaceMapError};
use crate::geometry::DVec3;
use crate::laplace::Deadline;
use crate::mesh::{BarycentricPoint, NO_TRIANGLE};
use crate::render::{BoundingSphere, OrbitCamera};
use crate::session::{SurfaceShape, SurfaceState};
use std::sync::Arc;

/// The share of a point's weight that corners on the boundary may have: nearer to the loop harmonic
/// measure is a peak that no drag can hold still.
const MOST_BOUNDARY_WEIGHT: f64 = 0.9;

/// How much larger than the surface what is fitted into the viewport is.
const ROOM: f64 = 1.12;

/// Triangles that are sorted into their tree within a frame, about 20 ms for 70,000; of more the dots
/// are never drawn fainter before the first one was dragged.
const SORTED_AT_ONCE: usize = 150_000;

/// The surface side of the model.
#[derive(Debug, Default)]
pub struct SurfaceSide {
    /// The way to the next surface.
    pub preparation: SurfacePreparation,
    /// A person wants an outline in its place: it goes when the outline is there.
    pub gives_way: bool,
    /// The surface that is shown; the map may still be missing.
    shown: Option<Arc<PreparedSurface>>,
    map: Option<SurfaceMap>,
    scene: Option<BoundingSphere>,
    /// The map of another surface or outline, until it is complete.
    next: Option<SurfaceMap>,
    /// The constraints that the map is on its way to.
    under_way: Option<SurfaceConstraints>,
    /// The next map was refused with its constraints; it waits for others.
    is_stuck: bool,
}

impl SurfaceSide {
    /// Takes over the surface that was prepared.
    pub fn renew(&mut self) {
        self.shown = self.preparation.surface().map(Arc::clone);
        self.scene = self.shown.as_ref().map(|surface| {
            let BoundingSphere { center, radius } = BoundingSphere::of(&surface.surface.mesh.vertices);
            BoundingSphere { center, radius: ROOM * radius }
        });
        (self.map, self.next, self.under_way, self.is_stuck) = (None, None, None, false);
    }

    /// The same surface, not yet mapped.
    #[must_use]
    pub fn twin(&self) -> Self {
        let mut twin = Self { preparation: self.preparation.twin(), ..Self::default() };
        twin.renew();
        twin
    }

    /// The surface.
    pub fn surface(&self) -> Option<&Arc<PreparedSurface>> {
        self.shown.as_ref()
    }

    /// Sorts its triangles for rays, now that there is time for it: until then, a tenth of a second after a surface is
    /// prepared, its dots are drawn as if nothing were before them.
    pub fn sort_at_rest(&self) {
        if let Some(surface) = &self.shown
            && surface.surface.mesh.triangles.len() <= SORTED_AT_ONCE
        {
            surface.tree();
        }
    }

    /// Its map.
    pub fn map(&self) -> Option<&SurfaceMap> {
        self.map.as_ref()
    }

    /// A ball around it, with room for the words above and below it.
    pub fn scene(&self) -> Option<BoundingSphere> {
        self.scene
    }

    /// From where the surface is looked at first, in a viewport of this width over height.
    pub fn first_view(&self, state: &SurfaceState, aspect: f64) -> Option<OrbitCamera> {
        let (surface, scene) = (self.shown.as_ref()?, self.scene?);
        let mesh = &surface.surface.mesh;
        let mut camera = match &state.spec.shape {
            SurfaceShape::Preset { preset, .. } => {
                let [towards_eye, up] = preset.view();
                OrbitCamera::new(scene, towards_eye, up, aspect)
            }
            SurfaceShape::File { .. } => OrbitCamera::before(&mesh.vertices, &mesh.triangles, aspect),
        };
        camera.fit(scene, aspect);
        Some(camera)
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

    /// Begins with a map over another outline, or of another surface.
    pub fn begin(&mut self, source: &Arc<PreparedDomain>) {
        (self.under_way, self.is_stuck) = (None, false);
        self.next = self.shown.as_ref().map(|surface| SurfaceMap::unmapped(Arc::clone(source), Arc::clone(surface)));
    }

    /// Whether the map is on its way.
    pub fn is_under_way(&self) -> bool {
        !self.is_stuck && (self.next.is_some() || self.under_way.is_some())
    }

    /// Whether the first map of a surface, or over an outline, was refused.
    pub fn is_stuck(&self) -> bool {
        self.is_stuck
    }

    /// The point of the surface nearest to a place.
    pub fn nearest(&self, place: DVec3) -> Option<BarycentricPoint> {
        let found = self.shown.as_ref()?.tree().nearest(place)?.0;
        self.interior_near(found)
    }

    /// Goes on with the map until `deadline` is over. One that takes several frames comes to where the points were
    /// when it began, and then goes on to `wanted`: under a drag the picture follows as fast as it can.
    pub fn advance(&mut self, wanted: &SurfaceConstraints, deadline: Deadline) -> Result<Advance, SurfaceMapError> {
        let Some(map) = self.next.as_mut().or(self.map.as_mut()) else { return Ok(Advance::Unfinished) };
        let constraints = *self.under_way.get_or_insert(*wanted);
        let is_done = map.advance(&constraints, deadline).inspect_err(|_| {
            (self.under_way, self.is_stuck) = (None, self.next.is_some());
        });
        let is_done = is_done?;
        self.is_stuck = false;
        if !is_done {
            return Ok(Advance::Unfinished);
        }
        self.under_way = (constraints != *wanted).then_some(*wanted);
        if self.next.is_none() {
            return Ok(Advance::Moved);
        }
        self.map = self.next.take();
        Ok(Advance::Replaced)
    }
}

/// What a frame's share of work has come to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Advance {
    /// The picture stays.
    Unfinished,
    /// The same meshes have other images.
    Moved,
    /// Another surface or outline.
    Replaced,
}

//! The surface that is shown: the positions of its two points, and its first camera.

use crate::conformal::{MeshedSurface, PreparedSide};
use crate::geometry::DVec3;
use crate::mesh::BarycentricPoint;
use crate::model::side::preparation::Preparation;
use crate::model::side::surface_files::SurfaceFiles;
use crate::model::side::surface_request::SurfaceRequest;
use crate::render::{BoundingSphere, OrbitCamera};
use crate::session::{SurfaceShape, SurfaceSpec, SurfaceState};
use crate::worker::{NamedFile, SurfaceSource};
use std::sync::Arc;

/// The largest sum of barycentric weights of corners on the boundary that an interior point may have. Nearer to the
/// boundary loop the harmonic measure is a peak that moves far with every pixel of a drag.
const MOST_BOUNDARY_WEIGHT: f64 = 0.9;

/// The radius of the ball that is fitted into the viewport, relative to the surface's bounding sphere.
const ROOM: f64 = 1.12;

/// The most triangles whose search tree is built within a frame, which takes about 20 ms for 70,000. For larger
/// surfaces it is built at the first drag; until then hidden dots are not drawn fainter.
const SORTED_AT_ONCE: usize = 150_000;

/// The surface side of the model.
#[derive(Debug, Default)]
pub struct SurfaceSide {
    /// The preparation of the next surface.
    pub preparation: Preparation<Option<SurfaceRequest>>,
    /// The surface that is shown; its map may not be computed yet.
    shown: Option<Arc<PreparedSide>>,
    scene: Option<BoundingSphere>,
}

impl SurfaceSide {
    /// Requests the surface of an opened file, with the repairs and settings of `spec`, which then names the file.
    pub fn want_file(&mut self, spec: &SurfaceSpec, file: NamedFile) {
        let spec = SurfaceSpec { shape: SurfaceShape::File { name: file.name.clone() }, ..spec.clone() };
        self.preparation.want_surface(spec, SurfaceSource::File(file), f64::NEG_INFINITY);
    }

    /// Requests the surface that `spec` describes: at once, or after `now` if only a preset's resolution changes.
    /// Returns whether it has to be prepared. The person is asked for a file that is not among `files`.
    pub fn want_spec(&mut self, spec: &SurfaceSpec, files: &SurfaceFiles, now: f64) -> bool {
        let source = files.source(&spec.shape);
        if self.preparation.want_last_good(spec, source.as_ref()) {
            return false;
        }
        if let Some(source) = source {
            self.preparation.want_surface(spec.clone(), source, now);
        } else if let SurfaceShape::File { name } = &spec.shape {
            self.preparation.ask_for_file(name);
        }
        true
    }

    /// Whether what is shown is not the surface that was prepared last.
    pub fn is_outdated(&self) -> bool {
        self.shown.as_ref().map(Arc::as_ptr) != self.preparation.prepared().map(Arc::as_ptr)
    }

    /// Shows the surface that was prepared last.
    pub fn renew(&mut self) {
        self.shown = self.preparation.prepared().map(Arc::clone);
        self.scene = self.surface().map(|surface| {
            let BoundingSphere { center, radius } = BoundingSphere::of(surface.mesh().vertices());
            BoundingSphere { center, radius: ROOM * radius }
        });
    }

    /// A copy with the same surface and no request.
    #[must_use]
    pub fn twin(&self) -> Self {
        let mut twin = Self { preparation: self.preparation.twin(), ..Self::default() };
        twin.renew();
        twin
    }

    /// The surface.
    pub fn surface(&self) -> Option<&Arc<MeshedSurface>> {
        self.shown.as_ref()?.surface()
    }

    /// The surface, prepared.
    pub fn prepared(&self) -> Option<&Arc<PreparedSide>> {
        self.shown.as_ref()
    }

    /// Builds the search tree for rays if it is missing and the surface has at most `SORTED_AT_ONCE` triangles;
    /// returns whether it was built. Called at rest, about 0.1 s after the preparation; without the tree no dot counts
    /// as hidden.
    pub fn sort_at_rest(&self) -> bool {
        let is_due = |surface: &MeshedSurface| {
            surface.tree_if_made().is_none() && surface.mesh().triangles().len() <= SORTED_AT_ONCE
        };
        let Some(surface) = self.surface().filter(|surface| is_due(surface)) else { return false };
        surface.tree();
        true
    }

    /// The ball that a camera fits into the viewport: the bounding sphere, enlarged for the texts above and below it.
    pub fn scene(&self) -> Option<BoundingSphere> {
        self.scene
    }

    /// The first camera, in a viewport with this ratio of width to height.
    pub fn first_view(&self, state: &SurfaceState, aspect: f64) -> Option<OrbitCamera> {
        let (surface, scene) = (self.surface()?, self.scene?);
        let mesh = surface.mesh();
        let mut camera = match &state.spec.shape {
            SurfaceShape::Preset { preset, .. } => {
                let [towards_eye, up] = preset.view();
                OrbitCamera::new(scene, towards_eye, up, aspect)
            }
            SurfaceShape::File { .. } => OrbitCamera::before(mesh.vertices(), mesh.triangles(), aspect),
        };
        camera.fit(scene, aspect);
        Some(camera)
    }

    /// The interior point: that of `state`, or the default if it has none in this mesh.
    pub fn point(&self, state: &SurfaceState) -> Option<BarycentricPoint> {
        let surface = self.surface()?;
        let count = surface.mesh().triangles().len();
        Some(state.point.filter(|point| point.triangle().index() < count).unwrap_or(surface.centre()))
    }

    /// The interior point in space.
    pub fn place(&self, state: &SurfaceState) -> Option<DVec3> {
        Some(self.surface()?.position(self.point(state)?))
    }

    /// The boundary point in space.
    pub fn anchor_place(&self, state: &SurfaceState) -> Option<DVec3> {
        let (prepared, surface) = (self.prepared()?, self.surface()?);
        Some(surface.boundary_position(prepared.at_fraction(state.anchor)))
    }

    /// The point near `found` that the interior handle may take: a little inside of the loop.
    pub fn interior_near(&self, found: BarycentricPoint) -> Option<BarycentricPoint> {
        let mesh = self.surface()?.mesh();
        let corners = mesh.triangles()[found.triangle().index()];
        let on_loop = corners.map(|v| v < mesh.boundary_count());
        let sum: f64 = (0..3).filter(|&i| on_loop[i]).map(|i| found.weights()[i]).sum();
        if sum <= MOST_BOUNDARY_WEIGHT {
            return Some(found);
        }
        let (triangle, mut weights) = (found.triangle(), found.weights());
        let inner = on_loop.iter().filter(|on_loop| !**on_loop).count();
        if inner == 0 {
            // An ear or a bridge between two boundaries: the middle is as far from them as one can be.
            let open = mesh.is_at_boundary(triangle);
            return Some(BarycentricPoint::new(triangle, if open { [1.0 / 3.0; 3] } else { weights }));
        }
        for i in 0..3 {
            weights[i] = if on_loop[i] {
                weights[i] * MOST_BOUNDARY_WEIGHT / sum
            } else {
                weights[i] + (sum - MOST_BOUNDARY_WEIGHT) / inner as f64
            };
        }
        let total: f64 = weights.iter().sum();
        Some(BarycentricPoint::new(triangle, weights.map(|w| w / total)))
    }

    /// The point of the surface nearest to a place.
    pub fn nearest(&self, place: DVec3) -> Option<BarycentricPoint> {
        let found = self.surface()?.tree().nearest(place)?.0;
        self.interior_near(found)
    }
}

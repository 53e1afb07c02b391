//! The results of a map: images, measures, distortion.

use super::distortion::{advance_distortions, advance_surface_distortions, resolution};
use super::{
    BoundaryCorrespondence, ConformalMap, Direction, Extension, FrameTimings, HarmonicMeasure, MapNote, MapSettings,
    MeshedDomain, Places, PreparedSide, Quality, Side, SideGeometry, SurfaceImages, TriangleDistortion, Unfold,
};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use crate::mesh::{TriangleId, VertexId, locate};
use std::sync::Arc;

impl ConformalMap {
    /// A prepared side.
    pub fn side(&self, side: Side) -> &Arc<PreparedSide> {
        &self.sides[side].prepared
    }

    /// The planar domain of a side; `None` of a surface.
    pub fn domain(&self, side: Side) -> Option<&Arc<MeshedDomain>> {
        self.side(side).domain()
    }

    /// The Poisson kernel ψ of a side's interior point, per boundary vertex.
    pub fn kernel(&self, side: Side) -> &[f64] {
        &self.sides[side].measured.kernel
    }

    /// The harmonic measure of a side, from its anchor.
    pub fn measure(&self, side: Side) -> &HarmonicMeasure {
        &self.sides[side].measured.measure
    }

    /// The images of the boundary vertices of the mapped side.
    pub fn correspondence(&self) -> &BoundaryCorrespondence {
        &self.correspondence
    }

    /// Which mesh is mapped: as requested, or with one surface the surface's.
    pub fn direction(&self) -> Direction {
        self.settings.direction
    }

    /// Which mesh is mapped, and how the boundary map is extended.
    pub fn settings(&self) -> MapSettings {
        self.settings
    }

    /// The side whose mesh is mapped.
    pub fn mapped_side(&self) -> Side {
        self.settings.direction.mapped_side()
    }

    /// The prepared side whose vertices are mapped.
    pub fn mapped(&self) -> &Arc<PreparedSide> {
        self.side(self.mapped_side())
    }

    /// How the boundary map is extended.
    pub fn extension(&self) -> Extension {
        self.settings.extension
    }

    /// Whether both sides are surfaces: the map goes through the unit disk.
    pub fn is_through_disk(&self) -> bool {
        self.sides.iter().all(|(_, side)| side.prepared.is_surface())
    }

    /// The images of the mapped mesh's vertices in the plane: in the other domain or, between two surfaces, in the unit
    /// disk, where flips are counted; empty before the first update. Until [`Self::refine`] is complete, some are those
    /// of the harmonic extension.
    pub fn images(&self) -> &[DVec2] {
        if self.is_through_disk() { self.through_disk.disks[self.mapped_side()].places() } else { &self.images }
    }

    /// Between two surfaces, the images of the mapped surface's vertices on the other one; `None` if one side is
    /// planar, and before the first update.
    pub fn surface_images(&self) -> Option<&SurfaceImages> {
        let images = &self.through_disk.images;
        (!images.points().is_empty()).then_some(images)
    }

    /// The images of the mapped mesh's vertices as positions on the other side: in the plane, or in space between two
    /// surfaces.
    pub fn image_places(&self) -> Places<'_> {
        self.surface_images().map_or(Places::Plane(self.images()), |images| Places::Space(images.places()))
    }

    /// Between two surfaces, the positions of a side's vertices in the unit disk: its disk coordinates. `None` if one
    /// side is planar, and before the first update.
    pub fn disk(&self, side: Side) -> Option<&[DVec2]> {
        let disk = self.through_disk.disks[side].places();
        (!disk.is_empty()).then_some(disk)
    }

    /// Incremented when [`Self::disk`] changes; each map counts from 0.
    pub fn disk_revision(&self, side: Side) -> u64 {
        self.through_disk.revisions[side]
    }

    /// The images of a mapped surface's vertices, in the order of the surface as it was read; `None` for vertices that
    /// a repair has dropped. Empty if no surface is mapped.
    pub fn texture_coordinates(&self) -> Vec<Option<DVec2>> {
        let Some(meshed) = self.mapped().surface() else { return Vec::new() };
        let surface = meshed.surface();
        let images = self.images();
        let image =
            |origin| surface.number_of(VertexId::new(origin)).and_then(|number| images.get(number.index()).copied());
        (0..surface.origin_count() as u32).map(image).collect()
    }

    /// The timings of the last update, with the refinements since.
    pub fn timings(&self) -> FrameTimings {
        self.timings
    }

    /// The distortion of every triangle of the mapped mesh except those added by a repair, in the mesh's order; between
    /// two surfaces, from triangles in space to their images in space. Cost O(n).
    pub fn distortions(&self) -> Vec<TriangleDistortion> {
        let mut all = Vec::new();
        self.advance_distortions(&mut all, Deadline::NEVER);
        self.given(&all).copied().collect()
    }

    /// Continues computing the distortions of all triangles of the mapped mesh, including those added by a repair,
    /// after those in `result`, until they are complete (true) or `deadline` has passed.
    pub(crate) fn advance_distortions(&self, result: &mut Vec<TriangleDistortion>, deadline: Deadline) -> bool {
        let images = self.images();
        match (self.mapped().geometry(), self.surface_images()) {
            (SideGeometry::Plane(domain), _) => advance_distortions(domain.mesh(), images, result, deadline),
            (SideGeometry::Space(surface), None) => advance_distortions(surface.mesh(), images, result, deadline),
            (SideGeometry::Space(surface), Some(there)) => {
                advance_surface_distortions(surface.mesh(), there.places(), images, result, deadline)
            }
        }
    }

    /// The distance within which images of the mapped mesh's vertices cannot be told apart.
    pub(crate) fn image_resolution(&self) -> f64 {
        match self.image_places() {
            Places::Plane(places) => resolution(places),
            Places::Space(places) => resolution(places),
        }
    }

    /// Of one value per triangle of the mapped mesh, the values of triangles that were not added by a repair.
    pub fn given<'a, T>(&'a self, values: &'a [T]) -> impl Iterator<Item = &'a T> {
        let mesh = self.mapped().surface().map(|meshed| meshed.surface());
        let is_given =
            move |k: usize| mesh.is_none_or(|mesh| mesh.origin_of_triangle(TriangleId::new(k as u32)).is_some());
        values.iter().enumerate().filter(move |(k, _)| is_given(*k)).map(|(_, value)| value)
    }

    /// Angle distortion and flips of [`Self::distortions`]; for a surface, shapes are those of the triangles as given,
    /// not of the flipped ones. Cost O(triangles); call it only when the result is shown.
    pub fn quality(&self) -> Quality {
        Quality::summary(&self.distortions())
    }

    /// The warning about a side of the map that is a surface, under the current constraints. Cost O(m).
    pub fn note(&self, side: Side) -> Option<MapNote> {
        self.side(side).surface()?;
        let edges = self.collapsed_edges(side);
        let is_negative = self.kernel(side).iter().any(|&psi| psi < 0.0);
        let note = if is_negative { MapNote::NegativeKernel { edges } } else { MapNote::NoMeasure { edges } };
        (edges > 0).then_some(note)
    }

    /// The number of boundary edges of a surface whose ends have indistinguishable images (between two surfaces, in the
    /// disk).
    fn collapsed_edges(&self, side: Side) -> usize {
        let images = if self.is_through_disk() { self.through_disk.disks[side].places() } else { &self.images };
        collapsed(&images[..self.side(side).boundary_count().min(images.len())])
    }

    /// The image of a point of the mapped domain (piecewise linear); `None` outside it, for a surface, and before the
    /// first update.
    pub fn image_of(&self, x: DVec2) -> Option<DVec2> {
        let side = self.mapped_side();
        let mesh = self.domain(side)?.mesh();
        let found = locate(mesh, x, Some(self.sides[side].located.triangle()))?;
        let corners = mesh.triangles()[found.triangle().index()];
        let images = (!self.images.is_empty()).then_some(&self.images)?;
        Some(corners.iter().zip(found.weights()).map(|(&v, w)| w * images[v as usize]).sum())
    }
}

/// The number of edges between boundary positions whose ends are indistinguishable.
fn collapsed<P: Unfold>(boundary: &[P]) -> usize {
    let (next, smallest) = (boundary.iter().cycle().skip(1), resolution(boundary));
    boundary.iter().zip(next).filter(|(p, q)| p.in_space().distance(q.in_space()) <= smallest).count()
}

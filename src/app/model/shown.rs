//! The map that is shown, planar or of a surface, for those to whom it makes no difference.

use super::Model;
use crate::conformal::{Direction, FrameTimings, Side};
use crate::geometry::DVec2;

/// The mapped mesh's triangles and the images of its vertices.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// Which way it goes; a surface is always mapped backward.
    pub direction: Direction,
    /// The triangles of the mapped mesh.
    pub triangles: &'a [[u32; 3]],
    /// The places of its vertices, where it lies in the plane.
    pub planar: Option<&'a [DVec2]>,
    /// The images of its vertices, in the other domain.
    pub images: &'a [DVec2],
    /// The number of its boundary vertices, which come first.
    pub boundary_count: usize,
    /// What the last update took.
    pub timings: FrameTimings,
}

impl<'a> Shown<'a> {
    /// The side whose mesh is mapped.
    pub fn mapped_side(&self) -> Side {
        self.direction.mapped_side()
    }

    /// Where the mapped mesh's vertices lie on a side; `None` on that of a surface.
    pub fn places(&self, side: Side) -> Option<&'a [DVec2]> {
        if side == self.mapped_side() { self.planar } else { Some(self.images) }
    }
}

impl Model {
    /// The map on the screen, as soon as there is one.
    pub fn shown(&self) -> Option<Shown<'_>> {
        if let Some(map) = self.surface_map() {
            let mesh = &map.surface().surface.mesh;
            return Some(Shown {
                direction: Direction::Backward,
                triangles: &mesh.triangles,
                planar: None,
                images: map.images(),
                boundary_count: mesh.boundary_count as usize,
                timings: map.timings(),
            });
        }
        let map = self.map()?;
        let mesh = map.mapped_mesh();
        Some(Shown {
            direction: map.direction(),
            triangles: &mesh.triangles,
            planar: Some(&mesh.vertices),
            images: map.images(),
            boundary_count: mesh.boundary_count as usize,
            timings: map.timings(),
        })
    }
}

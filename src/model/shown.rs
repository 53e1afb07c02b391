//! The map that is shown, as data independent of the kind of its sides.

use crate::conformal::{ConformalMap, Direction, FrameTimings, Side};
use crate::geometry::DVec2;
use crate::model::Model;
use crate::model::pointer::Pointer;
use crate::model::sharpness::Estimated;

/// The last complete full map, and its state in the picture.
///
/// Invariants: `revision` is that of the picture; while the map is at a later one, `map_revision`, and its
/// disk coordinates are incomplete, the picture is not updated. The generations never decrease.
#[derive(Debug)]
pub struct ShownMap {
    /// The last complete full map.
    pub map: Option<ConformalMap>,
    /// The revision of the request that the map was last updated to.
    pub map_revision: u64,
    /// The revision of the map when the picture was last updated.
    pub revision: u64,
    /// The direction of the map in the picture.
    pub direction: Direction,
    /// The side on which the pattern in the picture is defined; `None`: in the disk.
    pub pattern_home: Option<Side>,
    /// Incremented when the images change.
    pub generation: u64,
    /// Incremented when another mesh is mapped.
    pub mesh_generation: u64,
    /// Incremented when the boundary map changes.
    pub map_generation: u64,
    /// The estimate of the map's errors.
    pub estimated: Estimated,
    /// Cauchy's integrals of the map, for the point under the pointer.
    pub pointer: Pointer,
}

impl ShownMap {
    /// No map.
    pub fn new(pattern_home: Option<Side>) -> Self {
        Self {
            map: None,
            map_revision: 0,
            revision: 0,
            direction: Direction::default(),
            pattern_home,
            generation: 0,
            mesh_generation: 0,
            map_generation: 0,
            estimated: Estimated::default(),
            pointer: Pointer::default(),
        }
    }
}

/// The mapped mesh's triangles and the images of its vertices.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// The direction of the map; with one surface, the surface is mapped.
    pub direction: Direction,
    /// The triangles of the mapped mesh that are painted.
    pub triangles: &'a [[u32; 3]],
    /// The positions of its vertices, if they lie in the plane.
    pub planar: Option<&'a [DVec2]>,
    /// The images of its vertices in the plane: in the other domain or, between two surfaces, in the disk.
    pub images: &'a [DVec2],
    /// Whether the other side is a surface too, on which its vertices lie in space.
    pub is_through_disk: bool,
    /// The number of its boundary vertices, which come first.
    pub boundary_count: usize,
    /// The timings of the last update.
    pub timings: FrameTimings,
}

impl<'a> Shown<'a> {
    /// The side whose mesh is mapped.
    pub fn mapped_side(&self) -> Side {
        self.direction.mapped_side()
    }

    /// The positions of the mapped mesh's vertices on a side; `None` on the side of a surface.
    pub fn places(&self, side: Side) -> Option<&'a [DVec2]> {
        if side == self.mapped_side() { self.planar } else { (!self.is_through_disk).then_some(self.images) }
    }
}

impl Model {
    /// The map on the screen; `None` before the first.
    pub fn shown(&self) -> Option<Shown<'_>> {
        let map = self.map()?;
        let mapped = map.mapped();
        Some(Shown {
            direction: map.direction(),
            triangles: mapped.surface().map_or(mapped.triangles(), |surface| self.painted(map.mapped_side(), surface)),
            planar: mapped.domain().map(|domain| domain.mesh().vertices()),
            images: map.images(),
            is_through_disk: map.is_through_disk(),
            boundary_count: mapped.boundary_count(),
            timings: map.timings(),
        })
    }
}

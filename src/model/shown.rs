//! The map that is shown, for those to whom its sides make no difference.

use crate::conformal::{ConformalMap, Direction, FrameTimings, Side};
use crate::geometry::DVec2;
use crate::model::Model;

/// The last full map that is complete, and what of it is in the picture.
///
/// Invariants: `revision` is that of the picture; while the map has gone on to a later one, `map_revision`, and its
/// disk coordinates are not there yet, the picture is not told. The generations only count up.
#[derive(Debug)]
pub struct ShownMap {
    /// The map.
    pub map: Option<ConformalMap>,
    /// What the map was asked for when it was brought up to date.
    pub map_revision: u64,
    /// The revision of the map when the picture was told last.
    pub revision: u64,
    /// The direction of the map in the picture.
    pub direction: Direction,
    /// Where the pattern in the picture lives.
    pub pattern_home: Option<Side>,
    /// How many times the images have changed.
    pub generation: u64,
    /// How many times another mesh was mapped.
    pub mesh_generation: u64,
    /// How many times the boundary map has changed.
    pub map_generation: u64,
}

impl ShownMap {
    /// None yet.
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
        }
    }
}

/// The mapped mesh's triangles and the images of its vertices.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// Which way it goes; one surface is always mapped.
    pub direction: Direction,
    /// The triangles of the mapped mesh.
    pub triangles: &'a [[u32; 3]],
    /// The places of its vertices, where it lies in the plane.
    pub planar: Option<&'a [DVec2]>,
    /// The images of its vertices in the plane: in the other domain or, between two surfaces, in the disk.
    pub images: &'a [DVec2],
    /// Whether the other side is a surface too, on which its vertices lie in space.
    pub is_through_disk: bool,
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
        if side == self.mapped_side() { self.planar } else { (!self.is_through_disk).then_some(self.images) }
    }
}

impl Model {
    /// The map on the screen, as soon as there is one.
    pub fn shown(&self) -> Option<Shown<'_>> {
        let map = self.map()?;
        let mapped = map.mapped();
        Some(Shown {
            direction: map.direction(),
            triangles: mapped.triangles(),
            planar: mapped.domain().map(|domain| domain.mesh().vertices()),
            images: map.images(),
            is_through_disk: map.is_through_disk(),
            boundary_count: mapped.boundary_count(),
            timings: map.timings(),
        })
    }
}

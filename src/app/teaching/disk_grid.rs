//! The disk coordinates of both meshes, for the conformal pattern.
//!
//! Each side has its own, from its own measure. f takes the level sets of one side to
//! those of the other, f = g₂⁻¹ ∘ g₁, so the pattern that both pictures show is one
//! pattern, carried by the map. They can be made in pieces; both sides change at once.

use crate::conformal::{
    ConformalMap, ExtensionScratch, Side, SurfaceMap, advance_extension, advance_surface_extension,
    begin_disk_coordinates, begin_surface_disk_coordinates,
};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};

/// The map whose sides get coordinates.
#[derive(Debug, Clone, Copy)]
pub enum GridMap<'a> {
    /// Between two plane domains.
    Planar(&'a ConformalMap),
    /// With a surface as the target.
    Surface(&'a SurfaceMap),
}

impl GridMap<'_> {
    fn begin(self, side: Side, scratch: &mut ExtensionScratch) {
        match (self, side) {
            (Self::Planar(map), _) => begin_disk_coordinates(map.domain(side), map.measure(side), scratch),
            (Self::Surface(map), Side::Source) => begin_disk_coordinates(map.source(), map.source_measure(), scratch),
            (Self::Surface(map), Side::Target) => begin_surface_disk_coordinates(map.surface(), map.measure(), scratch),
        }
    }

    fn advance(
        self,
        side: Side,
        scratch: &mut ExtensionScratch,
        values: &mut Vec<DVec2>,
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        match (self, side) {
            (Self::Planar(map), _) => advance_extension(map.domain(side), scratch, values, deadline),
            (Self::Surface(map), Side::Source) => advance_extension(map.source(), scratch, values, deadline),
            (Self::Surface(map), Side::Target) => advance_surface_extension(map.surface(), scratch, values, deadline),
        }
    }

    fn vertex_count(self, side: Side) -> usize {
        match (self, side) {
            (Self::Planar(map), _) => map.domain(side).mesh.vertices.len(),
            (Self::Surface(map), Side::Source) => map.source().mesh.vertices.len(),
            (Self::Surface(map), Side::Target) => map.surface().surface.mesh.vertices.len(),
        }
    }
}

/// Both sides' coordinates.
#[derive(Debug, Default)]
pub struct DiskGrid {
    made: Coordinates,
    /// Those that are under way.
    coming: Coordinates,
    /// The side that is worked on.
    at: Option<Side>,
    scratch: ExtensionScratch,
}

#[derive(Debug, Default)]
struct Coordinates {
    sides: [Vec<DVec2>; 2],
    /// What they are of.
    generation: Option<u64>,
    error: Option<String>,
}

impl DiskGrid {
    /// Goes on with the coordinates of `map`, the `generation`-th, until they are there (true) or
    /// `deadline` is over. Another generation starts over.
    pub fn advance(&mut self, map: GridMap, generation: u64, deadline: Deadline) -> bool {
        if self.is_of(generation) {
            return true;
        }
        let known = self.at.filter(|_| self.coming.generation == Some(generation));
        let mut side = known.unwrap_or_else(|| {
            (self.coming.generation, self.coming.error) = (Some(generation), None);
            self.begin(map, Side::Source)
        });
        while self.advance_side(map, side, deadline) {
            if side == Side::Target {
                self.at = None;
                std::mem::swap(&mut self.made, &mut self.coming);
                return true;
            }
            side = self.begin(map, Side::Target);
            if deadline.is_over() {
                break;
            }
        }
        false
    }

    fn begin(&mut self, map: GridMap, side: Side) -> Side {
        map.begin(side, &mut self.scratch);
        *self.at.insert(side)
    }

    fn advance_side(&mut self, map: GridMap, side: Side, deadline: Deadline) -> bool {
        let values = &mut self.coming.sides[side as usize];
        map.advance(side, &mut self.scratch, values, deadline).unwrap_or_else(|error| {
            // The flat pattern of a point at the centre, rather than a wrong one.
            values.clear();
            values.resize(map.vertex_count(side), DVec2::ZERO);
            self.coming.error = Some(format!("The {side} has no disk coordinates: {error}."));
            true
        })
    }

    /// Whether these are the coordinates of the `generation`-th map.
    pub fn is_of(&self, generation: u64) -> bool {
        self.made.generation == Some(generation)
    }

    /// g at the vertices of a side's mesh; empty before the first have been made.
    pub fn of(&self, side: Side) -> &[DVec2] {
        &self.made.sides[side as usize]
    }

    /// Why there is no pattern.
    pub fn error(&self) -> Option<&str> {
        self.made.error.as_deref()
    }
}

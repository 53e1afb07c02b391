//! The disk coordinates of both meshes, for the conformal pattern.
//!
//! Each side has its own, from its own measure. f takes the level sets of one side to
//! those of the other, f = g₂⁻¹ ∘ g₁, so the pattern that both pictures show is one
//! pattern, carried by the map.

use super::Situation;
use crate::conformal::{Side, SurfaceMap, disk_coordinates};
use crate::geometry::DVec2;
use crate::laplace::Lanes;

/// Both sides' coordinates.
#[derive(Debug, Default)]
pub struct DiskGrid {
    coordinates: [Vec<DVec2>; 2],
    scratch: Vec<Lanes<2>>,
    /// What the coordinates are of.
    generation: Option<u64>,
    error: Option<String>,
}

impl DiskGrid {
    /// Makes the coordinates of the map on the screen; whether they are others than before.
    pub fn update(&mut self, situation: &Situation) -> bool {
        if self.generation == Some(situation.generation) {
            return false;
        }
        self.generation = Some(situation.generation);
        self.error = None;
        for side in Side::BOTH {
            let (domain, measure) = (situation.map.domain(side), situation.map.measure(side));
            let coordinates = &mut self.coordinates[side as usize];
            if let Err(error) = disk_coordinates(domain, measure, coordinates, &mut self.scratch) {
                // The flat pattern of a point at the centre, rather than a wrong one.
                coordinates.fill(DVec2::ZERO);
                self.error = Some(format!("The {side} has no disk coordinates: {error}."));
            }
        }
        true
    }

    /// Makes the source's coordinates of a surface's map.
    pub fn follow_surface(&mut self, map: &SurfaceMap) {
        self.generation = None;
        let coordinates = &mut self.coordinates[Side::Source as usize];
        let result = disk_coordinates(map.source(), map.source_measure(), coordinates, &mut self.scratch);
        self.error = result.err().map(|error| format!("The source has no disk coordinates: {error}."));
    }

    /// g at the vertices of a side's mesh; empty before [`Self::update`].
    pub fn of(&self, side: Side) -> &[DVec2] {
        &self.coordinates[side as usize]
    }

    /// Why there is no pattern.
    pub fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }
}

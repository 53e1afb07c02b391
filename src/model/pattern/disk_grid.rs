//! The disk coordinates of both meshes, for the conformal pattern.
//!
//! The coordinates g of a side come from its own harmonic measure. Since f = g₂⁻¹ ∘ g₁, the map takes level sets of g₁
//! to those of g₂: corresponding points have the same color. They are computed in steps of limited duration; the
//! coordinates of both sides are replaced at the same time.

use crate::conformal::{ConformalMap, ExtensionScratch, PerSide, Side, begin_disk_coordinates};
use crate::geometry::DVec2;
use crate::language::{Message, key};
use crate::laplace::Deadline;

/// Both sides' coordinates.
#[derive(Debug, Default)]
pub struct DiskGrid {
    made: Coordinates,
    /// The coordinates that are being computed.
    coming: Coordinates,
    /// The side whose coordinates are being computed.
    at: Option<Side>,
    scratch: ExtensionScratch,
}

#[derive(Debug, Default)]
struct Coordinates {
    sides: PerSide<Vec<DVec2>>,
    /// The generation of their map.
    generation: Option<u64>,
    error: Option<Message>,
}

impl DiskGrid {
    /// Continues to compute the coordinates of `map` until they are complete (true) or `deadline` has passed. If
    /// `generation` differs from that of the last call, the computation starts again.
    pub fn advance(&mut self, map: &ConformalMap, generation: u64, deadline: Deadline) -> bool {
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

    fn begin(&mut self, map: &ConformalMap, side: Side) -> Side {
        begin_disk_coordinates(map.side(side), map.measure(side), &mut self.scratch);
        *self.at.insert(side)
    }

    fn advance_side(&mut self, map: &ConformalMap, side: Side, deadline: Deadline) -> bool {
        let values = &mut self.coming.sides[side];
        map.side(side).advance_extension(&mut self.scratch, values, deadline).unwrap_or_else(|error| {
            // The flat pattern of a point at the center, rather than a wrong one.
            values.clear();
            values.resize(map.side(side).vertex_count(), DVec2::ZERO);
            self.coming.error = Some(key::no_disk_coordinates(side, Message::from(&error)));
            true
        })
    }

    /// Whether these are the coordinates of the `generation`-th map.
    pub fn is_of(&self, generation: u64) -> bool {
        self.made.generation == Some(generation)
    }

    /// g at the vertices of a side's mesh; empty before the first have been made.
    pub fn of(&self, side: Side) -> &[DVec2] {
        &self.made.sides[side]
    }

    /// Why there is no pattern.
    pub fn error(&self) -> Option<&Message> {
        self.made.error.as_ref()
    }
}

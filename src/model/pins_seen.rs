//! What is seen of pins: where they lie, and how far the map misses them; computed once for each map.

use super::Model;
use crate::conformal::{PerSide, Pins, Side};
use crate::geometry::DVec3;

/// The places of pins and their misses, for a map and its pins.
#[derive(Debug, Default)]
pub(super) struct PinsSeen {
    /// The pins, the number of the map, and whether another one is being computed.
    of: Option<(Pins, u64, bool)>,
    places: PerSide<Vec<DVec3>>,
    /// None while the map is computed.
    misses: Option<Vec<f64>>,
    missed: Option<Vec<f64>>,
}

impl Model {
    /// The distance between each pin's image and its target, in the target's units; `None` without pins or while the map
    /// is computed.
    pub fn pin_misses(&self) -> Option<&[f64]> {
        self.pins_seen()?.misses.as_deref()
    }

    /// Where the map carries the source's pins: fractions of the target's boundary; `None` where no pin is missed by
    /// construction, with three of them, or while the map is computed.
    pub fn missed_pins(&self) -> Option<&[f64]> {
        self.pins_seen()?.missed.as_deref()
    }

    /// The places of a side's pins, in the plane z = 0 or on the surface; none without pins.
    pub fn pin_places(&self, side: Side) -> &[DVec3] {
        self.pins_seen().map_or(&[], |seen| &seen.places[side])
    }

    /// What is seen of the present pins.
    fn pins_seen(&self) -> Option<&PinsSeen> {
        let seen = &self.pinned.seen;
        seen.of.as_ref().is_some_and(|(pins, ..)| Some(pins) == self.pins()).then_some(seen)
    }

    /// Updates what is seen of the pins, if the map or the pins have changed.
    pub(super) fn see_pins(&mut self) {
        let of = self.pins().map(|pins| (pins.clone(), self.shown.map_generation, self.is_pending()));
        if of == self.pinned.seen.of {
            return;
        }
        let Some((pins, ..)) = &of else {
            self.pinned.seen = PinsSeen::default();
            return;
        };
        let map = self.full_map();
        let missed = map.filter(|_| pins.pairs().len() > 3).map(|map| {
            let images = pins.pairs().iter().map(|pair| map.boundary_image(Side::Source, pair.source));
            images.collect()
        });
        let misses = map.map(|map| pins.misses(map));
        let places = PerSide::from_fn(|side| {
            let place = |prepared: &crate::conformal::PreparedSide, fraction| {
                prepared.boundary_place(prepared.at_fraction(fraction))
            };
            let fractions = pins.pairs().iter().map(|pair| pair[side]);
            self.prepared(side).map(|prepared| fractions.map(|at| place(prepared, at)).collect()).unwrap_or_default()
        });
        self.pinned.seen = PinsSeen { of, places, misses, missed };
    }
}

//! The symmetries of the planar sides: what a worker is asked, and what it has found.
//!
//! They are looked for while they are shown, one outline at a time and at rest. A result belongs to its outline, on
//! whichever side that is.

use crate::conformal::{PerSide, Side};
use crate::language::Message;
use crate::session::OutlineSpec;
use crate::worker::FoundSymmetries;

/// An outline with the symmetries found, or why there are none.
type Found = (OutlineSpec, Result<FoundSymmetries, Message>);

/// The symmetries of both sides.
#[derive(Debug, Default)]
pub struct SymmetryState {
    found: PerSide<Option<Found>>,
    in_flight: Option<(Side, OutlineSpec)>,
}

impl SymmetryState {
    /// The result for an outline; `None` until it is there.
    pub fn of(&self, outline: &OutlineSpec) -> Option<&Result<FoundSymmetries, Message>> {
        let found = self.found.iter().filter_map(|(_, found)| found.as_ref());
        found.filter(|(known, _)| known == outline).map(|(_, result)| result).next()
    }

    /// The next outline without a result, unless the worker is busy.
    pub fn next<'a>(&self, outlines: &PerSide<Option<&'a OutlineSpec>>) -> Option<(Side, &'a OutlineSpec)> {
        let waiting = outlines.iter().filter_map(|(side, outline)| Some((side, (*outline)?)));
        waiting.filter(|_| self.in_flight.is_none()).find(|(_, outline)| self.of(outline).is_none())
    }

    /// Notes that the worker got this outline.
    pub fn send(&mut self, side: Side, outline: OutlineSpec) {
        self.in_flight = Some((side, outline));
    }

    /// Stores the result for the outline that the worker got.
    pub fn accept(&mut self, result: Result<FoundSymmetries, Message>) {
        if let Some((side, outline)) = self.in_flight.take() {
            self.found[side] = Some((outline, result));
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;

    #[test]
    fn one_outline_at_a_time_and_results_belong_to_their_outlines() {
        let mut state = SymmetryState::default();
        let [heart, star] = [Preset::Heart, Preset::Star].map(OutlineSpec::Preset);
        let both = PerSide::new(Some(&heart), Some(&star));
        assert_eq!(state.next(&both), Some((Side::Source, &heart)));
        state.send(Side::Source, heart.clone());
        assert_eq!(state.next(&both), None, "one is in flight");
        state.accept(Err("no".into()));
        assert!(state.of(&heart).unwrap().is_err());
        assert_eq!(state.next(&both), Some((Side::Target, &star)));
        state.send(Side::Target, star.clone());
        state.accept(Err("no".into()));
        state.accept(Err("the worker died twice".into()));
        assert_eq!(state.next(&PerSide::new(Some(&star), Some(&heart))), None, "the sides were exchanged");
        assert_eq!(state.next(&PerSide::new(None, None)), None);
    }
}

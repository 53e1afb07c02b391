//! The conformal invariants of the outlines that the session shows: requests to their worker, and its results.

use super::Model;
use super::overlays::invariants::InvariantsAction;
use crate::conformal::{PerSide, Side};
use crate::language::Message;
use crate::worker::{FoundInvariants, InvariantsTask};

impl Model {
    /// Changes what is asked for.
    pub fn act_on_invariants(&mut self, action: InvariantsAction) {
        self.overlay_state.invariants.act(action);
    }

    /// The result for a side as it is now; `None` until it is there, and for a surface.
    pub fn invariants(&self, side: Side) -> Option<&Result<FoundInvariants, Message>> {
        self.overlay_state.invariants.of(side).result(&self.invariants_task(side)?)
    }

    /// Whether a side's invariants are to be computed.
    pub fn are_invariants_due(&self) -> bool {
        self.overlay_state.invariants.is_due(&PerSide::from_fn(|side| self.invariants_task(side)))
    }

    /// The next request for the worker.
    pub fn take_invariants(&mut self) -> Option<InvariantsTask> {
        let tasks = PerSide::from_fn(|side| self.invariants_task(side));
        self.overlay_state.invariants.take(&tasks)
    }

    /// Stores the worker's result; its modulus tells how many cells a grid gets.
    pub fn accept_invariants(&mut self, result: Result<FoundInvariants, Message>) {
        self.overlay_state.invariants.accept(result);
        for side in Side::BOTH {
            if let Some((result, marks)) = self.invariants(side).zip(self.marks(side)) {
                let modulus = result.as_ref().ok().and_then(|found| Some(found.modulus?.value));
                self.overlay_state.orthogonal_grids.fit_cells(side, marks, modulus);
            }
        }
    }

    /// Whether the invariants of a side are asked for: as such, or by marks.
    pub fn shows_invariants(&self, side: Side) -> bool {
        self.overlay_state.invariants.of(side).is_open || self.session.marks(side).is_some()
    }

    /// What is asked for of a side; `None` if nothing is, if the side is a surface, or while its outline is prepared.
    fn invariants_task(&self, side: Side) -> Option<InvariantsTask> {
        let asked = self.overlay_state.invariants.of(side);
        if !self.shows_invariants(side) || !self.abilities().has_outline(side) || self.is_preparing(side) {
            return None;
        }
        Some(InvariantsTask {
            side,
            outline: (&self.session.domain(side).outline).into(),
            point: self.interior(side)?,
            second_point: asked.second_point,
            marks: self.session.marks(side),
        })
    }
}

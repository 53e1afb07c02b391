//! The symmetries of the outlines that the session shows: requests to their worker, and its results.

use super::Model;
use crate::conformal::{PerSide, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::session::OutlineSpec;
use crate::worker::{FoundSymmetries, StudiedOutline};

impl Model {
    /// The symmetries of a side's outline, or why they are not known; `None` while they are looked for, where they are not
    /// shown, and for a surface.
    pub fn symmetries(&self, side: Side) -> Option<&Result<FoundSymmetries, Message>> {
        self.overlay_state.symmetries.of(self.outline_with_symmetries(side)?)
    }

    /// Whether an outline's symmetries are to be looked for.
    pub fn are_symmetries_due(&self) -> bool {
        self.overlay_state.symmetries.next(&self.outlines_with_symmetries()).is_some()
    }

    /// The next request for the worker.
    pub fn take_symmetry(&mut self) -> Option<StudiedOutline> {
        let (side, outline) = self.overlay_state.symmetries.next(&self.outlines_with_symmetries())?;
        let (outline, request) = (outline.clone(), outline.into());
        self.overlay_state.symmetries.send(side, outline);
        Some(request)
    }

    /// Stores the worker's result.
    pub fn accept_symmetries(&mut self, result: Result<FoundSymmetries, Message>) {
        self.overlay_state.symmetries.accept(result);
    }

    /// The corners of a side's outline. Cost O(points).
    pub fn corner_places(&self, side: Side) -> Vec<DVec2> {
        self.session.domain(side).outline.corner_places()
    }

    fn outlines_with_symmetries(&self) -> PerSide<Option<&OutlineSpec>> {
        PerSide::from_fn(|side| self.outline_with_symmetries(side))
    }

    /// The outline of a side if its symmetries are shown.
    fn outline_with_symmetries(&self, side: Side) -> Option<&OutlineSpec> {
        let is_shown = self.session.symmetries() && self.abilities().has_outline(side);
        is_shown.then(|| &self.session.domain(side).outline)
    }
}

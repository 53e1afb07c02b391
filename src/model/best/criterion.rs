//! The criterion of the aim that is chosen; the symmetries of the outlines are found once.

use super::Aim;
use super::sides::KnownSides;
use crate::conformal::PerSide;
use crate::geometry::Symmetries;
use crate::model::Model;
use crate::optimization::{Criterion, OptimizeError, SharedSymmetries};
use std::sync::Arc;

/// The symmetries that both outlines share, and the sides for which they were found.
#[derive(Debug, Default)]
pub(super) struct KnownSymmetries(Option<(KnownSides, Shared)>);

type Shared = Result<Arc<SharedSymmetries>, OptimizeError>;

impl Model {
    /// The criterion of the aim that is chosen. Errors: the outlines share no symmetry.
    pub(super) fn criterion(&mut self) -> Result<Criterion, OptimizeError> {
        match self.best.aim {
            Aim::Area => Ok(Criterion::Area),
            Aim::Scale => Ok(Criterion::Scale),
            Aim::Region => Ok(Criterion::Region(self.painted_region())),
            Aim::Symmetry => self.shared_symmetries().map(Criterion::Symmetry),
        }
    }

    fn shared_symmetries(&mut self) -> Shared {
        if !self.abilities().compares_outlines() {
            return Err(OptimizeError::NoSharedSymmetry);
        }
        let sides = KnownSides::new(&self.both_sides().ok_or(OptimizeError::NoSharedSymmetry)?);
        if let Some((_, shared)) = self.best.symmetries.0.as_ref().filter(|(known, _)| *known == sides) {
            return shared.clone();
        }
        let symmetries = PerSide::from_fn(|side| {
            let outline = &self.session.domain(side).outline;
            match self.overlay_state.symmetries.of(outline) {
                Some(Ok(found)) => found.symmetries.clone(), // by the worker, while they are shown
                _ => Symmetries::of(&outline.polygon()),
            }
        });
        let shared = SharedSymmetries::new(&symmetries).map(Arc::new);
        self.best.symmetries = KnownSymmetries(Some((sides, shared.clone())));
        shared
    }
}

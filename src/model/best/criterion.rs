//! The criterion of the aim that is chosen; the symmetries of the outlines are found once.

use super::Aim;
use crate::conformal::{PerSide, PreparedSide, Side};
use crate::geometry::Symmetries;
use crate::model::Model;
use crate::optimization::{Criterion, OptimizeError, Region, SharedSymmetries};
use std::sync::{Arc, Weak};

/// The symmetries that both outlines share, and the sides for which they were found.
#[derive(Debug, Default)]
pub(super) struct KnownSymmetries(Option<(PerSide<Weak<PreparedSide>>, Shared)>);

type Shared = Result<Arc<SharedSymmetries>, OptimizeError>;

impl Model {
    /// The criterion of the aim that is chosen. Errors: the outlines share no symmetry.
    pub(super) fn criterion(&mut self) -> Result<Criterion, OptimizeError> {
        match self.best.aim {
            Aim::Area => Ok(Criterion::Area),
            Aim::Scale => Ok(Criterion::Scale),
            Aim::Region => Ok(Criterion::Region(Arc::new(Region::of_dabs(self.session.region().to_vec())))),
            Aim::Symmetry => self.shared_symmetries().map(Criterion::Symmetry),
        }
    }

    fn shared_symmetries(&mut self) -> Shared {
        if !self.abilities().compares_outlines() {
            return Err(OptimizeError::NoSharedSymmetry);
        }
        let sides = self.both_sides().ok_or(OptimizeError::NoSharedSymmetry)?.map(|side| Arc::downgrade(&side));
        let is_of =
            |known: &PerSide<Weak<PreparedSide>>| Side::BOTH.into_iter().all(|side| known[side].ptr_eq(&sides[side]));
        if let Some((_, shared)) = self.best.symmetries.0.as_ref().filter(|(known, _)| is_of(known)) {
            return shared.clone();
        }
        let symmetries = PerSide::from_fn(|side| Symmetries::of(&self.session.domain(side).outline.polygon()));
        let shared = SharedSymmetries::new(&symmetries).map(Arc::new);
        self.best.symmetries = KnownSymmetries(Some((sides, shared.clone())));
        shared
    }
}

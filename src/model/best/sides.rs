//! The sides that something was computed for: compared by identity, and not kept alive.

use crate::conformal::{PerSide, PreparedSide, Side};
use std::sync::{Arc, Weak};

/// Both sides, once they were prepared. Equal to others only if these are the same preparations.
#[derive(Debug, Clone)]
pub(super) struct KnownSides(PerSide<Weak<PreparedSide>>);

impl KnownSides {
    pub fn new(sides: &PerSide<Arc<PreparedSide>>) -> Self {
        Self(sides.as_ref().map(Arc::downgrade))
    }
}

impl PartialEq for KnownSides {
    fn eq(&self, other: &Self) -> bool {
        Side::BOTH.into_iter().all(|side| self.0[side].ptr_eq(&other.0[side]))
    }
}

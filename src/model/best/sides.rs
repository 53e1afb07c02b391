//! The sides that something was computed for, compared by identity and not kept alive, and their shapes.

use crate::conformal::{PerSide, PreparedSide, Side};
use crate::session::{DomainSpec, Session, SurfaceSpec};
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

/// The shapes of both sides: those of sides that are prepared anew, as for a point next to the boundary, are the same.
#[derive(Debug, Clone)]
pub(super) struct KnownShapes(PerSide<(DomainSpec, Option<SurfaceSpec>)>);

impl KnownShapes {
    pub fn new(session: &Session) -> Self {
        Self(PerSide::from_fn(|side| {
            (session.domain(side).clone(), session.surface(side).map(|surface| surface.spec.clone()))
        }))
    }

    /// Whether the session has these shapes.
    pub fn are_of(&self, session: &Session) -> bool {
        self.0.iter().all(|(side, (domain, surface))| {
            session.domain(side) == domain && session.surface(side).map(|surface| &surface.spec) == surface.as_ref()
        })
    }
}

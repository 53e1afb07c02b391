//! The map update in progress: the constraints that were requested, and those that it is computed for.

use crate::conformal::{ConformalMap, Constraints, Side};
use crate::language::Message;

/// The state of the full map's update.
///
/// Invariants: `next` is a map between the present geometries of the two sides; `held` is set only while pending.
#[derive(Debug, Default)]
pub struct MapUnderWay {
    /// The full map of changed sides, until its first update is complete.
    pub next: Option<ConformalMap>,
    /// The number of frames spent on the update; `None` if the full map is up to date.
    frames: Option<u32>,
    /// Incremented with every request to the map.
    pub revision: u64,
    /// The request that a map without a coarse substitute is computed for: the constraints when its update started.
    held: Option<Asked>,
    /// The number of successive frames that were too short for an update.
    pub unfinished: u32,
    /// Why the last update rejected a constraint, and on which side.
    pub error: Option<(Side, Message)>,
    /// Whether a point moves, so that requests that depend on its place wait.
    pub is_moving: bool,
}

/// A request to the map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// The requested points.
    pub constraints: Constraints,
    /// The revision of the request.
    pub revision: u64,
}

impl MapUnderWay {
    /// Whether the full map is behind the session.
    pub fn is_pending(&self) -> bool {
        self.frames.is_some()
    }

    /// Records that the full map is behind the session.
    pub fn want(&mut self) {
        self.frames = Some(0);
    }

    /// Counts one more frame of the update. Returns its request: for `constraints` or, if it `holds` its request, for
    /// those at its start.
    pub fn go_on(&mut self, constraints: Constraints, holds: bool) -> Asked {
        self.frames = self.frames.map(|frames| frames + 1);
        let asked = Asked { constraints, revision: self.revision };
        if holds { *self.held.get_or_insert(asked) } else { asked }
    }

    /// Ends the update. If the requested points have changed since a held update started, starts the next one; returns
    /// whether the map is up to date now.
    pub fn finish(&mut self, wanted: Option<Constraints>) -> bool {
        if self.frames.take() == Some(1) {
            self.unfinished = 0;
        }
        let is_behind = self.held.take().is_some_and(|held| wanted.is_some_and(|wanted| wanted != held.constraints));
        if is_behind {
            self.want();
        }
        !is_behind
    }

    /// Ends an update that failed.
    pub fn give_up(&mut self) {
        (self.frames, self.held) = (None, None);
    }

    /// Starts the update of the map `next` of changed sides.
    pub fn restart(&mut self, next: Option<ConformalMap>) {
        (self.next, self.held, self.unfinished) = (next, None, 0);
    }
}

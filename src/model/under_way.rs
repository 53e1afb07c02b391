//! The map under way: what it was asked for, and what it is coming to.

use crate::conformal::{ConformalMap, Constraints};

/// What the full map is on its way to.
///
/// Invariants: `next` is a map between what stands on the two sides now; `held` is there only while pending.
#[derive(Debug, Default)]
pub struct MapUnderWay {
    /// The full map of other sides, until its first update is complete.
    pub next: Option<ConformalMap>,
    /// While the full map is behind the session: how many frames have gone on with it.
    frames: Option<u32>,
    /// Counts what the map has been asked for.
    pub revision: u64,
    /// What a map that nothing stands in for is coming to: where the points were when it began.
    held: Option<Asked>,
    /// How many times in a row a frame was too short for an update.
    pub unfinished: u32,
}

/// What the map is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Where the points are to be.
    pub constraints: Constraints,
    /// When that was.
    pub revision: u64,
}

impl MapUnderWay {
    /// Whether the full map is behind the session.
    pub fn is_pending(&self) -> bool {
        self.frames.is_some()
    }

    /// The full map is behind the session.
    pub fn want(&mut self) {
        self.frames = Some(0);
    }

    /// One frame more goes on with it. What it is coming to: `constraints`, or, if it is to hold them, those of when it began.
    pub fn go_on(&mut self, constraints: Constraints, holds: bool) -> Asked {
        self.frames = self.frames.map(|frames| frames + 1);
        let asked = Asked { constraints, revision: self.revision };
        if holds { *self.held.get_or_insert(asked) } else { asked }
    }

    /// It is complete. If the points have gone on since it began, so does it; whether it has caught up.
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

    /// It could not be made.
    pub fn give_up(&mut self) {
        (self.frames, self.held) = (None, None);
    }

    /// Other sides: `next` is to be their map.
    pub fn restart(&mut self, next: Option<ConformalMap>) {
        (self.next, self.held, self.unfinished) = (next, None, 0);
    }
}

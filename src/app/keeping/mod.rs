//! What outlives a frame: the steps that can be undone, the address that carries the session, the
//! copy that the next start finds.
//!
//! All of them take in the session when it has come to rest: nothing is held, nothing is being prepared.
//! Nothing in here touches the address or the copy: what is to be done with them is the answer.
//!
//! * What a step led to is no step of its own, even if it does not come to rest as it was.
//! * To open a link or the app changes the address, but not the copy; a change by the person does.
//! * While an outline is missing that the opened link only names, the address stays that link.

mod first;
mod report;

pub use first::{Start, first_session, missing_text};
pub use report::link_report;

use crate::session::link::{self, MissingOutline};
use crate::session::{Command, History, Session, file};

/// From this many points on a session is large: its copy is made at most once in [`COPY_SECONDS`].
/// 20,000 points take 2 ms to write on a desktop, and several times that in a browser, which also has to store them.
const LARGE_POINTS: usize = 20_000;
/// How often a large session is copied, in seconds: what a crash costs at most.
const COPY_SECONDS: f64 = 5.0;

/// What is to be done when a session has come to rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settled {
    /// The points of outlines that a link only named, and that are there now.
    pub moves: Vec<Command>,
    /// What the address shows from now on.
    pub address: Option<String>,
    /// The copy for the next start.
    pub copy: Option<String>,
    /// In how many seconds the copy is due.
    pub copy_due: Option<f64>,
}

/// The keeper of sessions.
#[derive(Debug)]
pub struct Keeper {
    history: History,
    /// No session has come to rest yet.
    is_new: bool,
    /// Whether the address and the kept copy follow, or the history alone.
    is_public: bool,
    /// What comes to rest next is what a step led to.
    is_stepping: bool,
    /// What comes to rest next is what a link held.
    is_opening: bool,
    /// What comes to rest next has got the points of a missing outline.
    is_completing: bool,
    /// The outlines that the opened link only names.
    missing: Vec<MissingOutline>,
    /// Whether address and copy wait for them.
    waits: bool,
    owes_address: bool,
    owes_copy: bool,
    copied_at: Option<f64>,
    has_complained: bool,
}

impl Keeper {
    /// Begins at `session`; `is_public`: the address and the copy for the next start follow it.
    pub fn new(session: Session, is_public: bool) -> Self {
        Self {
            history: History::new(session),
            is_new: true,
            is_public,
            is_stepping: false,
            is_opening: false,
            is_completing: false,
            missing: Vec::new(),
            waits: false,
            owes_address: false,
            owes_copy: false,
            copied_at: None,
            has_complained: false,
        }
    }

    /// Undo and redo.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The outlines that the opened link only names, for which a disk stands in.
    pub fn missing(&self) -> &[MissingOutline] {
        &self.missing
    }

    /// The session before. `at_rest`: the present one, or nothing while something is being prepared:
    /// then a change is under way that is no step yet, and going back leaves it out.
    pub fn undo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if self.is_new && at_rest.is_none() {
            return None;
        }
        let is_under_way = at_rest.is_none() && !self.is_stepping;
        self.leave_link(at_rest);
        let before = if is_under_way { Some(self.history.now()) } else { self.history.undo() }.cloned();
        self.began_step(before)
    }

    /// The session after; there is none while a change is under way.
    pub fn redo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if at_rest.is_none() && !self.is_stepping {
            return None;
        }
        self.leave_link(at_rest);
        let after = self.history.redo().cloned();
        self.began_step(after)
    }

    /// Takes in what has not been yet; a link that was not there before the step is left.
    fn leave_link(&mut self, at_rest: Option<&Session>) {
        match at_rest {
            Some(session) => self.take_in(session),
            None if std::mem::take(&mut self.is_opening) => self.missing.clear(),
            None => {}
        }
    }

    fn began_step(&mut self, session: Option<Session>) -> Option<Session> {
        self.is_stepping |= session.is_some();
        session
    }

    /// The person changes something: what comes to rest next is a step of its own.
    pub fn touch(&mut self) {
        self.is_stepping = false;
    }

    /// A link is being opened that only names the `missing` outlines.
    pub fn open_link(&mut self, missing: Vec<MissingOutline>) {
        self.touch();
        self.is_opening = true;
        self.waits = !missing.is_empty();
        self.missing = missing;
    }

    /// Takes in a session that has come to rest, at a time in seconds; the first one is where the history begins.
    pub fn settle(&mut self, session: &Session, now: f64) -> Settled {
        let moves = self.moves_in(session);
        if !moves.is_empty() {
            return Settled { moves, ..Settled::default() };
        }
        self.take_in(session);
        if !self.is_public || self.waits {
            return Settled::default();
        }
        // Copy link says why there is none.
        let link = |_| link::encode(session).ok().map(|encoded| encoded.fragment);
        let address = std::mem::take(&mut self.owes_address).then_some(()).and_then(link);
        let is_large = session.loaded_points() > LARGE_POINTS;
        let due = self.copied_at.filter(|_| is_large).map_or(0.0, |at| at + COPY_SECONDS - now);
        if !self.owes_copy || due > 0.0 {
            let copy_due = self.owes_copy.then_some(due);
            return Settled { address, copy_due, ..Settled::default() };
        }
        self.owes_copy = false;
        self.copied_at = Some(now);
        Settled { address, copy: file::write_compact(session).ok(), ..Settled::default() }
    }

    /// What to say about a copy that could not be kept: once is enough.
    pub fn not_kept(&mut self, reason: &str) -> Option<String> {
        let is_news = !std::mem::replace(&mut self.has_complained, true);
        is_news.then(|| format!("The session is not kept for the next time: {reason}. Save it as a file instead."))
    }

    /// What gives the outlines their points that are there now and were missing.
    fn moves_in(&mut self, session: &Session) -> Vec<Command> {
        let mut moves = Vec::new();
        self.missing.retain(|missing| {
            let &MissingOutline { side, interior, anchor, .. } = missing;
            let is_there = missing.is_named(&session.domain(side).outline);
            if is_there {
                moves.extend(interior.map(|point| Command::MoveInterior { side, point }));
                moves.push(Command::MoveAnchor { side, fraction: anchor });
            }
            !is_there
        });
        self.is_completing |= !moves.is_empty();
        moves
    }

    fn take_in(&mut self, session: &Session) {
        let is_first = std::mem::take(&mut self.is_new);
        let has_stepped = std::mem::take(&mut self.is_stepping);
        let is_opening = std::mem::take(&mut self.is_opening) || is_first;
        let is_completing = std::mem::take(&mut self.is_completing);
        let changed = if is_first {
            self.history = History::new(session.clone());
            true
        } else if has_stepped {
            self.history.amend(session);
            true
        } else {
            self.history.settle(session)
        };
        self.missing.retain(|missing| MissingOutline::is_stand_in(&session.domain(missing.side).outline));
        let is_other_change = changed && !is_opening && !is_completing;
        self.waits &= !is_other_change && !self.missing.is_empty();
        self.owes_address |= changed;
        self.owes_copy |= changed && !is_opening;
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

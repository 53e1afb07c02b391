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
mod public;
mod report;

pub use first::{Start, first_session, missing_text};
pub use report::{link_report, whole_link};

use crate::language::Message;
use crate::session::link::MissingOutline;
use crate::session::{Command, History, Session, SidePoints};
use public::Public;

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

/// What will come to rest next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coming {
    /// What the person has changed.
    Change,
    /// What a step led to.
    Step,
    /// What a link or the last time has left.
    Opened,
    /// What a link has left, with the points of an outline that was missing.
    Completed,
}

/// The persistence of sessions.
#[derive(Debug)]
pub struct Persistence {
    history: History,
    /// No session has come to rest yet.
    is_new: bool,
    coming: Coming,
    /// The outlines that the opened link only names.
    missing: Vec<MissingOutline>,
    /// Whether the person has read which they are.
    are_known: bool,
    /// Whether address and copy wait for them.
    waits: bool,
    /// The address and the kept copy, if they follow.
    public: Option<Public>,
}

impl Persistence {
    /// Begins at `session`; `is_public`: the address and the copy for the next start follow it.
    pub fn new(session: Session, is_public: bool) -> Self {
        Self {
            history: History::new(session),
            is_new: true,
            coming: Coming::Opened,
            missing: Vec::new(),
            are_known: false,
            waits: false,
            public: is_public.then(Public::default),
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

    /// The message about them that is still to be read after another one, which has been.
    pub fn unread_after(&mut self, message: &Message) -> Option<Message> {
        let text = missing_text(&self.missing)?;
        self.are_known |= message.mentions(&text);
        (!self.are_known).then_some(text)
    }

    /// The session before. `at_rest`: the present one, or nothing while something is being prepared:
    /// then a change is under way that is no step yet, and going back leaves it out.
    pub fn undo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if self.is_new && at_rest.is_none() {
            return None;
        }
        let is_under_way = at_rest.is_none() && self.coming != Coming::Step;
        self.leave_link(at_rest);
        let before = if is_under_way { Some(self.history.now()) } else { self.history.undo() }.cloned();
        self.began_step(before)
    }

    /// The session after; there is none while a change is under way.
    pub fn redo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if at_rest.is_none() && self.coming != Coming::Step {
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
            None if self.coming == Coming::Opened => {
                self.missing.clear();
                self.waits = false;
            }
            None => {}
        }
    }

    fn began_step(&mut self, session: Option<Session>) -> Option<Session> {
        if session.is_some() {
            self.coming = Coming::Step;
        }
        session
    }

    /// The person changes something: what comes to rest next is a step of its own.
    pub fn touch(&mut self) {
        self.coming = Coming::Change;
    }

    /// What comes to rest next is where the history begins: there is no way back behind it.
    pub fn begin_anew(&mut self) {
        (self.is_new, self.coming) = (true, Coming::Change);
    }

    /// A link is being opened that only names the `missing` outlines; `address`: what the address shows.
    pub fn open_link(&mut self, missing: Vec<MissingOutline>, address: Option<String>) {
        self.coming = Coming::Opened;
        self.waits = !missing.is_empty();
        self.are_known = false;
        self.missing = missing;
        if let Some(public) = self.public.as_mut().filter(|_| self.waits) {
            public.stay_at(address);
        }
    }

    /// What stands in the address was refused: what is to stand there again, at once.
    pub fn correct_address(&mut self) -> Option<String> {
        self.public.as_mut()?.correct_address()
    }

    /// Takes in a session that has come to rest, at a time in seconds; the first one is where the history begins.
    pub fn settle(&mut self, session: &Session, now: f64) -> Settled {
        let moves = self.moves_in(session);
        if !moves.is_empty() {
            return Settled { moves, ..Settled::default() };
        }
        self.take_in(session);
        match &mut self.public {
            Some(public) if !self.waits => public.pay(session, now),
            _ => Settled::default(),
        }
    }

    /// What to say about a copy that could not be kept: once is enough.
    pub fn not_kept(&mut self, reason: Message) -> Option<Message> {
        self.public.as_mut()?.not_kept(reason)
    }

    /// What gives the outlines their points that are there now and were missing.
    fn moves_in(&mut self, session: &Session) -> Vec<Command> {
        let mut moves = Vec::new();
        self.missing.retain(|missing| {
            let &MissingOutline { side, interior, anchor, .. } = missing;
            let is_there = missing.is_named(&session.domain(side).outline);
            if is_there {
                moves.push(Command::PlacePoints { side, points: SidePoints::Outline { interior, anchor } });
            }
            !is_there
        });
        if !moves.is_empty() {
            self.coming = Coming::Completed;
        }
        moves
    }

    fn take_in(&mut self, session: &Session) {
        let is_first = std::mem::take(&mut self.is_new);
        let came = std::mem::replace(&mut self.coming, Coming::Change);
        let changed = if is_first {
            self.history = History::new(session.clone());
            true
        } else if came == Coming::Step {
            self.history.amend(session);
            true
        } else {
            self.history.settle(session)
        };
        self.missing.retain(|missing| MissingOutline::is_stand_in(&session.domain(missing.side).outline));
        let ends_waiting = changed && matches!(came, Coming::Change | Coming::Step);
        self.waits &= !ends_waiting && !self.missing.is_empty();
        if let Some(public) = self.public.as_mut().filter(|_| changed) {
            public.note_change(came != Coming::Opened);
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

//! Persistence of the session: undo steps, the address that carries the session, and the copy for the next start.
//!
//! All of them follow the session when it has settled: nothing is held, nothing is being prepared.
//! Nothing here writes to the address or stores the copy; the results say what to write.
//!
//! * The result of an undo or redo is not a new history entry, even if it settles in another state.
//! * Opening a link or starting the app changes the address but not the copy; a user's change does both.
//! * While an outline is missing that the opened link only names, the address stays that link.

mod first;
mod public;
mod report;
pub mod visits;

pub use first::{KeptCopies, Start, first_session, missing_text};
pub use report::{lacks, link_report, whole_link};

use crate::language::Message;
use crate::session::link::MissingOutline;
use crate::session::{Command, History, Session, SidePoints};
use public::Public;
use visits::Visits;

/// What to do after a session has settled.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settled {
    /// Commands that set the points of outlines that were missing and have been loaded.
    pub moves: Vec<Command>,
    /// The new fragment of the address.
    pub address: Option<String>,
    /// The copy to store for the next start.
    pub copy: Option<String>,
    /// The seconds until a copy is due.
    pub copy_due: Option<f64>,
}

/// The origin of the session that will settle next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Coming {
    /// A user's change.
    Change,
    /// An undo or redo.
    Step,
    /// The end of the tour or a lesson, which shows the session of the present step again.
    Return,
    /// A link, or the start of the app.
    Opened,
    /// A link, with the points of an outline that was missing.
    Completed,
}

impl Coming {
    /// Whether the session is the present entry of the history, and so no new one.
    fn is_of_history(self) -> bool {
        matches!(self, Self::Step | Self::Return)
    }
}

/// The undo history, the missing outlines of a link, and the state of address and copy.
#[derive(Debug)]
pub struct Persistence {
    history: History,
    /// Whether no session has settled yet.
    is_new: bool,
    coming: Coming,
    /// The outlines that the opened link only names.
    missing: Vec<MissingOutline>,
    /// Whether the user has been told which they are.
    are_known: bool,
    /// Whether address and copy are not updated until they are loaded.
    waits: bool,
    /// The state of address and copy; `None` if they do not follow the session.
    public: Option<Public>,
    /// The opened sessions, of which this one is shown.
    pub visits: Visits,
}

impl Persistence {
    /// Starts with `session`; `is_public`: the address and the copy for the next start follow it.
    pub fn new(session: Session, is_public: bool) -> Self {
        Self {
            history: History::new(session),
            is_new: true,
            coming: Coming::Opened,
            missing: Vec::new(),
            are_known: false,
            waits: false,
            public: is_public.then(Public::default),
            visits: Visits::default(),
        }
    }

    /// Continues with the steps of an earlier run; its session is being prepared. The copy is kept already.
    pub fn resume(history: History, is_public: bool) -> Self {
        let mut resumed = Self::new(history.now().clone(), is_public);
        (resumed.is_new, resumed.history) = (false, history);
        if let Some(public) = &mut resumed.public {
            public.note_change(false);
        }
        resumed
    }

    /// Replaces all steps, by those of a visit that is gone back to. Its session is then opened.
    pub fn go_to(&mut self, history: History) {
        self.missing.clear();
        (self.is_new, self.waits, self.coming) = (false, false, Coming::Step);
        self.history = history;
    }

    /// Records the session at rest, and returns the steps, to be kept while another session is shown.
    pub fn leave(&mut self, at_rest: Option<&Session>) -> History {
        self.leave_link(at_rest);
        self.history.clone()
    }

    /// Undo and redo.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The outlines that the opened link only names; a disk is shown instead of each.
    pub fn missing(&self) -> &[MissingOutline] {
        &self.missing
    }

    /// The message about missing outlines, unless `message`, which has been read, has included it.
    pub fn unread_after(&mut self, message: &Message) -> Option<Message> {
        let text = missing_text(&self.missing)?;
        self.are_known |= message.mentions(&text);
        (!self.are_known).then_some(text)
    }

    /// The previous session. `at_rest` is the present one, or `None` while something is being prepared: a change in
    /// progress is not yet a step, and undoing discards it.
    pub fn undo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if self.is_new && at_rest.is_none() {
            return None;
        }
        let is_under_way = at_rest.is_none() && !self.coming.is_of_history();
        self.leave_link(at_rest);
        let before = if is_under_way { Some(self.history.now()) } else { self.history.undo() }.cloned();
        self.began_step(before)
    }

    /// The next session; `None` while a change is in progress.
    pub fn redo(&mut self, at_rest: Option<&Session>) -> Option<Session> {
        if at_rest.is_none() && !self.coming.is_of_history() {
            return None;
        }
        self.leave_link(at_rest);
        let after = self.history.redo().cloned();
        self.began_step(after)
    }

    /// Records the session if it is not yet recorded. A link still being opened is abandoned.
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

    /// Continues with the steps of a session that is opened from a file: undo goes through them, then through the present
    /// ones. `at_rest` as for [`Self::undo`].
    pub fn continue_with(&mut self, history: History, at_rest: Option<&Session>) {
        self.leave_link(at_rest);
        self.missing.clear();
        (self.is_new, self.waits) = (false, false);
        self.history.continue_with(history);
        self.coming = Coming::Step;
    }

    /// To be called when the files of the session have changed, or it is shown in another visit: it is kept with them when
    /// it settles.
    pub fn owe_copy(&mut self) {
        if let Some(public) = &mut self.public {
            public.note_change(true);
        }
    }

    /// To be called when the session of the present step is shown again, after the tour or a lesson: what it settles in
    /// is no new step.
    pub fn come_back(&mut self) {
        self.coming = Coming::Return;
    }

    /// The copy of the session if one is pending, also one that is not due yet: the session is about to be left.
    pub fn overdue_copy(&mut self, session: &Session) -> Option<String> {
        self.public.as_mut().filter(|_| !self.waits)?.overdue_copy(session)
    }

    /// To be called when the user changes something: the next settled session is a new step.
    pub fn touch(&mut self) {
        self.coming = Coming::Change;
    }

    /// Makes the next settled session the start of the history: undo cannot go before it.
    pub fn begin_anew(&mut self) {
        (self.is_new, self.coming) = (true, Coming::Change);
    }

    /// To be called when a link that only names the `missing` outlines is opened; `address` is the fragment shown.
    pub fn open_link(&mut self, missing: Vec<MissingOutline>, address: Option<String>) {
        self.coming = Coming::Opened;
        self.waits = !missing.is_empty();
        self.are_known = false;
        self.missing = missing;
        if let Some(public) = self.public.as_mut().filter(|_| self.waits) {
            public.stay_at(address);
        }
    }

    /// Whether sessions are stored for the next start.
    pub fn is_kept(&self) -> bool {
        self.public.is_some()
    }

    /// The fragment in the address, by which the kept session is found; `None` if the session has no link.
    pub fn address(&self) -> Option<&str> {
        self.public.as_ref()?.address()
    }

    /// The fragment to restore, at once, after the one in the address was refused.
    pub fn correct_address(&mut self) -> Option<String> {
        self.public.as_mut()?.correct_address()
    }

    /// Records a settled session at a time in seconds; the first one is the start of the history.
    pub fn settle(&mut self, session: &Session, now: f64) -> Settled {
        let moves = self.moves_in(session);
        if !moves.is_empty() {
            return Settled { moves, ..Settled::default() };
        }
        self.take_in(session);
        match &mut self.public {
            Some(public) if !self.waits => public.pay(session, self.history.loaded_points(), now),
            _ => Settled::default(),
        }
    }

    /// The message that something could not be stored; only the first time.
    pub fn not_kept(&mut self, message: Message) -> Option<Message> {
        self.public.as_mut()?.not_kept(message)
    }

    /// The commands that set the points of missing outlines that have been loaded, and with the last one the pins.
    fn moves_in(&mut self, session: &Session) -> Vec<Command> {
        let (mut moves, mut pins) = (Vec::new(), None);
        self.missing.retain(|missing| {
            let &MissingOutline { side, interior, anchor, ref region, .. } = missing;
            let is_there = missing.is_named(&session.domain(side).outline);
            if is_there {
                moves.push(Command::PlacePoints { side, points: SidePoints::Outline { interior, anchor } });
                if !region.is_empty() {
                    moves.push(Command::SetRegion(region.clone()));
                }
                pins.clone_from(&missing.pins);
            }
            !is_there
        });
        if !moves.is_empty() {
            self.coming = Coming::Completed;
            moves.extend(pins.filter(|_| self.missing.is_empty()).map(|pins| Command::SetPins(Some(pins))));
        }
        moves
    }

    fn take_in(&mut self, session: &Session) {
        let is_first = std::mem::take(&mut self.is_new);
        let came = std::mem::replace(&mut self.coming, Coming::Change);
        let changed = if is_first {
            self.history = History::new(session.clone());
            true
        } else if came.is_of_history() {
            self.history.amend(session);
            true
        } else {
            self.history.settle(session)
        };
        self.missing.retain(|missing| MissingOutline::is_stand_in(&session.domain(missing.side).outline));
        let ends_waiting = changed && matches!(came, Coming::Change | Coming::Step);
        self.waits &= !ends_waiting && !self.missing.is_empty();
        if let Some(public) = self.public.as_mut().filter(|_| changed) {
            public.note_change(!matches!(came, Coming::Opened | Coming::Return));
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

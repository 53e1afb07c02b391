//! Visits: each opened session has an entry of its own in the browser's history, and is kept with its undo steps.

use super::RiemapApp;
use crate::app::input::action::ExploreAction;
use crate::language::{Message, key};
use crate::model::persistence::visits::{Kept as KeptVisit, Left, Listed, Visit};
use crate::platform::{self, Kept};
use crate::session::file::{Archive, FileError};
use crate::session::link;
use crate::session::{Session, Touched};

impl RiemapApp {
    /// Begins another visit, for a session that is about to be opened; the present one can be gone back to. Does nothing
    /// where sessions are not kept.
    pub(super) fn begin_visit(&mut self) {
        if let Some(id) = platform::new_visit() {
            let left = self.leave_visit();
            self.persistence.visits.leave_for(id.clone(), left);
            platform::begin_visit(&id);
        }
    }

    /// Stores what is overdue of the visit that is shown, and returns what stays of it in memory.
    fn leave_visit(&mut self) -> Left {
        let at_rest = self.own_at_rest().cloned();
        let steps = self.persistence.leave(at_rest.as_ref());
        if let Some(session) = at_rest.filter(|session| self.persistence.overdue_copy(session).is_some()) {
            self.store_visit(&session);
        }
        Left { steps, picture: self.own_picture() }
    }

    /// Shows the visit that the user went back or forward to; if sessions are locked, nothing changes.
    pub(super) fn go_to_visit(&mut self, id: String) {
        if self.persistence.visits.is_at(&id) || !self.may(Touched::EVERYTHING) {
            return;
        }
        let present = self.leave_visit();
        match self.persistence.visits.left(&id).cloned() {
            // its surfaces are still at hand
            Some(Left { steps, picture }) => {
                self.persistence.visits.leave_for(id, present);
                self.show_archive(Archive { history: steps, surfaces: Vec::new(), picture });
            }
            None => self.read_visit(id, present),
        }
    }

    fn read_visit(&mut self, id: String, present: Left) {
        self.persistence.visits.leave_to_read(id.clone(), present);
        platform::load_visit(id, self.workers.mailbox.clone());
    }

    /// Opens a kept visit as a new entry of the browser's history.
    pub(super) fn open_kept(&mut self, id: &str) {
        let present = self.leave_visit();
        platform::begin_visit(id);
        self.read_visit(id.to_owned(), present);
    }

    /// Shows a visit that was read, under its `own` id; one that is not kept any more is opened from the address.
    pub(super) fn take_visit(&mut self, id: &str, own: String, kept: Option<KeptVisit>) {
        if !self.persistence.visits.take_read(id, own) {
            return; // the user has gone on
        }
        match kept.map(|kept| kept.archive()) {
            Some(Ok(archive)) => self.show_archive(archive),
            Some(Err(error)) => self.refuse_visit(&error),
            None => self.show_address(),
        }
    }

    /// Shows what the address tells, in this visit: another one would cut off those that the user can go forward to.
    fn show_address(&mut self) {
        if let Some(address) = platform::lesson_link() {
            self.drop_tour();
            return self.play_address(&address);
        }
        let Some(address) = platform::link() else { return };
        match link::decode(&address) {
            Ok(decoded) => self.show_decoded(decoded),
            Err(error) => {
                self.messages.common = Some(key::link_not_opened(Message::from(&error)));
                self.correct_address();
            }
        }
    }

    fn refuse_visit(&mut self, error: &FileError) {
        self.messages.common = Some(key::last_session_not_opened(Message::from(error)));
    }

    /// Shows an archive in place of everything, with its steps; over it plays the lesson of the address, if there is one.
    fn show_archive(&mut self, archive: Archive) {
        let history = self.take_files(archive);
        let session = history.now().clone();
        // the address is that of the archive by now
        self.drop_tour();
        self.persistence.go_to(history);
        self.show_session(session);
        if let Some(address) = platform::lesson_link() {
            self.play_address(&address);
        }
    }

    /// Stores the user's session: `text` is the session alone, which is stored at once, and the visit with everything
    /// follows. The text alone matters only where the visit cannot be stored.
    pub(super) fn store(&mut self, session: &Session, text: &str) {
        let without_files = platform::remember(Kept::Session, text);
        self.store_visit(session);
        if let (Err(reason), None) = (without_files, self.persistence.visits.current()) {
            self.say_once(key::session_not_kept(reason));
            self.workers.mailbox.wake();
        }
    }

    /// Stores the visit that is shown: the session with its undo steps and files.
    fn store_visit(&self, session: &Session) {
        let link = self.persistence.address().map(str::to_owned);
        let visit = self.persistence.visits.current().map(|id| Visit::new(id, link, &self.archive(session)));
        // an error would be a number out of its range, which no control allows
        if let Some(Ok(visit)) = visit {
            platform::keep(visit, self.workers.mailbox.clone());
        }
    }

    /// Stores the session and its undo steps at once, since the window may have to be opened again, and says so. Instead
    /// of the tour's session the user's own is stored.
    pub(super) fn take_loss_of_graphics(&mut self, reason: &str) {
        let own = self.own().clone();
        self.explore(ExploreAction::LeaveTour { keeps: false });
        self.messages.common = Some(key::graphics_device_lost(reason));
        let text = crate::session::file::write_compact(&own);
        if let Some(Ok(text)) = self.persistence.is_kept().then_some(text) {
            self.store(&own, &text);
        }
    }

    /// Takes the result of storing a visit.
    pub(super) fn take_kept(&mut self, result: Result<(Vec<Listed>, Option<Message>), Message>) {
        match result {
            Ok((listed, without_files)) => {
                self.persistence.visits.listed = listed;
                if let Some(reason) = without_files {
                    self.say_once(key::files_not_kept(reason));
                }
            }
            Err(reason) => self.not_kept_whole(reason),
        }
    }

    /// Says once that the session is kept without files and undo steps, or not at all.
    fn not_kept_whole(&mut self, reason: Message) {
        let text = crate::session::file::write_compact(self.own()).unwrap_or_default();
        match platform::remember(Kept::Session, &text) {
            Ok(()) => self.say_once(key::only_session_kept(reason)),
            Err(reason) => self.say_once(key::session_not_kept(reason)),
        }
    }

    fn say_once(&mut self, message: Message) {
        if let Some(message) = self.persistence.not_kept(message) {
            self.messages.common = Some(message);
        }
    }
}

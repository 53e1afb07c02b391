//! Operations on whole sessions: undo and redo, files, links, and storing them.

use super::RiemapApp;
use super::messages::Notice;
use crate::app::input::action::{Actions, ExploreAction, ShareAction};
use crate::app::input::locks::Control;
use crate::app::viewport::gpu::Gpu;
use crate::app::windows::share::SharedLink;
use crate::language::{Message, key};
use crate::model::files::FilePurpose;
use crate::model::persistence;
use crate::model::persistence::Persistence;
use crate::platform::{self, PageEvent};
use crate::session::file::{Archive, Attachment};
use crate::session::link::Decoded;
use crate::session::{Command, History, Session, file, lesson, link};

impl RiemapApp {
    /// Undo. In the tour or a lesson its step begins anew, and the user's own history stays as it is.
    pub(super) fn undo(&mut self) {
        match self.windows.explore.step() {
            Some(step) => self.explore(ExploreAction::Step(step)),
            // points on their way to the best map are a change that is discarded
            None if self.model.end_flight() => self.step_from(false, Persistence::undo),
            None => self.step_from(self.is_at_rest(), Persistence::undo),
        }
    }

    /// Redo; nothing in the tour or a lesson.
    pub(super) fn redo(&mut self) {
        if !self.windows.explore.is_touring() {
            self.step_from(self.is_at_rest(), Persistence::redo);
        }
    }

    /// Whether there is something to undo and to redo.
    pub(super) fn can_step(&self) -> [bool; 2] {
        let history = self.persistence.history();
        let flies = self.model.best().is_moving();
        let can_step = [history.can_undo() || flies, history.can_redo() && !flies];
        if self.windows.explore.is_touring() { [true, false] } else { can_step }
    }

    /// Whether the session is one to come back to: it is mapped, and no points are on their way to the best map.
    pub(super) fn is_at_rest(&self) -> bool {
        self.model.is_mapped() && !self.model.best().is_moving()
    }

    /// The user's own session at rest; in the tour or a lesson, the one from before.
    pub(super) fn own_at_rest(&self) -> Option<&Session> {
        self.windows.explore.before().or_else(|| self.is_at_rest().then(|| self.model.session()))
    }

    /// Goes to another entry of the history: `to` is undo or redo.
    fn step_from(&mut self, is_at_rest: bool, to: impl Fn(&mut Persistence, Option<&Session>) -> Option<Session>) {
        let at_rest = is_at_rest.then(|| self.model.session());
        let Some(session) = to(&mut self.persistence, at_rest) else { return };
        self.show_session(session);
    }

    /// Replaces the session, and releases whatever is being dragged. The caller records the change in the history.
    pub(super) fn show_session(&mut self, session: Session) {
        self.player.pause();
        self.input.handles.release();
        self.editor.drop_handle();
        self.model.dispatch(Command::Open(Box::new(session)), 0.0);
        self.workers.mailbox.wake();
    }

    /// The user's own session: in the tour or a lesson, the one from before.
    pub(super) fn own(&self) -> &Session {
        self.windows.explore.before().unwrap_or(self.model.session())
    }

    /// A session as the last of the undo steps, with the files that they use.
    pub(super) fn archive(&self, session: &Session) -> Archive {
        let mut history = self.persistence.history().clone();
        history.settle(session);
        let is_used = history.shows_image();
        self.model.archive(history, self.own_picture().filter(|_| is_used))
    }

    /// The file of the own picture that is loaded; its bytes are shared.
    pub(super) fn own_picture(&self) -> Option<Attachment> {
        self.pictures.image.as_ref().map(|image| image.file.clone())
    }

    /// Takes the files of an archive and returns its steps: surfaces are kept until they are shown, and an own picture
    /// other than the loaded one is decoded.
    pub(super) fn take_files(&mut self, mut archive: Archive) -> History {
        self.model.keep_files(&mut archive);
        let loaded = self.own_picture();
        if let Some(picture) = archive.picture.filter(|picture| loaded.as_ref() != Some(picture)) {
            self.load_image(picture);
        }
        archive.history
    }

    /// Opens the session of a file as the next step, with the steps and the files that it comes with. If sessions are
    /// locked, it is opened as [`Self::open_session`] does.
    pub(super) fn open_archive(&mut self, archive: Archive) {
        let history = self.take_files(archive);
        let session = history.now().clone();
        if self.options.locks.holds(Control::Session) {
            return self.open_session(session);
        }
        self.begin_visit();
        let at_rest = self.own_at_rest().cloned();
        self.end_tour();
        self.persistence.continue_with(history, at_rest.as_ref());
        self.show_session(session);
    }

    /// Decodes the own picture of a session.
    pub(super) fn load_image(&self, Attachment { name, bytes }: Attachment) {
        let limit = self.pictures.gpu.as_ref().map_or(2048, Gpu::max_texture_side);
        platform::decode_image(FilePurpose::OfSession, name, bytes, limit, self.workers.mailbox.clone());
    }

    pub(super) fn save_session(&mut self) {
        match self.archive(self.model.session()).write() {
            Ok(bytes) => {
                let name = format!("map.{}", file::EXTENSION);
                platform::save_file(&name, bytes, self.workers.mailbox.clone());
            }
            Err(error) => self.messages.common = Some(key::session_not_saved(Message::from(&error))),
        }
    }

    pub(super) fn copy_link(&mut self, context: &egui::Context) {
        match link::encode(self.model.session()) {
            Ok(encoded) => {
                context.copy_text(platform::address_with(&encoded.fragment));
                self.messages.common =
                    persistence::link_report(self.model.session(), &encoded, self.persistence.missing());
                let notice = Notice::new(key::link_copied(), context.input(|input| input.time));
                self.messages.notice = self.messages.common.is_none().then_some(notice);
            }
            Err(error) => self.messages.common = Some(key::no_link_to_session(Message::from(&error))),
        }
    }

    /// Carries out an action of the window that shares the link.
    pub(super) fn share(&mut self, action: ShareAction) {
        match action {
            ShareAction::Open => self.windows.share.set_open(true),
            ShareAction::Close => self.windows.share.set_open(false),
            ShareAction::Send => {
                if let Some(address) = self.windows.share.address() {
                    platform::share(address, self.workers.mailbox.clone());
                }
            }
        }
    }

    /// Shows the window of the link, if it is open.
    pub(super) fn show_share(&mut self, context: &egui::Context, actions: &mut Actions) {
        if self.windows.share.needs(self.model.session()) {
            let link = self.link_to_share();
            self.windows.share.renew(context, self.model.session().clone(), link);
        }
        self.windows.share.show(context, actions);
    }

    fn link_to_share(&self) -> Result<SharedLink, Message> {
        let session = self.model.session();
        let encoded = link::encode(session).map_err(|error| key::no_link_to_session(Message::from(&error)))?;
        let lacks = persistence::lacks(session, &encoded, self.persistence.missing());
        Ok(SharedLink { address: platform::address_with(&encoded.fragment), lacks })
    }

    /// The link of this session, if it contains all of its outlines and none is replaced by a placeholder disk.
    pub fn link(&self) -> Option<String> {
        persistence::whole_link(self.model.session(), self.persistence.missing())
    }

    /// Opens the session of another link, or shows why that fails.
    pub(super) fn open_link(&mut self, address: &str) {
        if let Err(reason) = self.try_link(address) {
            self.messages.common = Some(key::link_not_opened(reason));
            self.correct_address();
        }
    }

    /// Replaces the rejected address, or that of a lesson, by that of the user's own session.
    pub(super) fn correct_address(&mut self) {
        match self.persistence.correct_address() {
            Some(fragment) => platform::show_link(fragment.trim_start_matches('#')),
            // a session without a link: a reload finds it by its visit, and is not to find the lesson
            None if platform::lesson_link().is_some() => platform::show_link(""),
            None => {}
        }
    }

    /// Opens the session of another link, or plays its lesson; the error is the reason why the link cannot be opened.
    pub fn try_link(&mut self, address: &str) -> Result<(), Message> {
        if lesson::is_link(address) {
            return self.try_lesson_link(address);
        }
        let decoded = link::decode(address).map_err(|error| Message::from(&error))?;
        self.begin_visit();
        self.show_decoded(decoded);
        Ok(())
    }

    /// Shows the session of a link in this visit.
    pub(super) fn show_decoded(&mut self, Decoded { session, missing }: Decoded) {
        // the address is that of the link by now
        self.drop_tour();
        self.messages.common = persistence::missing_text(&missing);
        self.open_session(session);
        self.persistence.open_link(missing, platform::link());
    }

    /// Whether points move by themselves: along a loop, or to the best map.
    fn is_in_motion(&self) -> bool {
        self.player.is_playing() || self.model.best().is_moving()
    }

    /// Stores the session when it is at rest. In the tour or a lesson that is the one from before, at once: their own
    /// sessions are not stored, and a reload restores the user's.
    pub(super) fn keep(&mut self, context: &egui::Context) {
        self.keep_lesson();
        let (held, now) = context.input(|input| (input.pointer.any_down() || !input.keys_down.is_empty(), input.time));
        let own = match self.windows.explore.before() {
            Some(before) => before.clone(),
            None if held || self.is_in_motion() || !self.model.is_mapped() => return,
            None => self.model.session().clone(),
        };
        let settled = self.persistence.settle(&own, now);
        let is_touring = self.windows.explore.is_touring();
        let is_news = !is_touring && (settled.address.is_some() || settled.copy.is_some());
        for command in settled.moves {
            self.model.dispatch(command, now);
            context.request_repaint();
        }
        // a reload shows the lesson again that the address tells
        if let Some(fragment) = settled.address.filter(|_| !is_touring || platform::lesson_link().is_none()) {
            platform::show_link(&fragment);
        }
        if is_news {
            platform::tell_page(PageEvent::Session, "");
        }
        if let Some(text) = settled.copy {
            self.store(&own, &text);
        }
        if let Some(seconds) = settled.copy_due {
            context.request_repaint_after_secs(seconds as f32);
        }
    }
}

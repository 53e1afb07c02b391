//! Lessons: made in their panel, kept, saved, opened and played.

use super::RiemapApp;
use super::messages::Notice;
use crate::app::input::action::{EditAction, LessonAction};
use crate::app::windows::lesson::Change;
use crate::conformal::Side;
use crate::language::{Label, Message, key};
use crate::model::files::FilePurpose;
use crate::platform::{self, Kept};
use crate::session::Touched;
use crate::session::lesson::{self, Lesson, LessonError, Step};
use std::sync::Arc;

/// The name of a saved lesson: text editors open it.
const FILE_NAME: &str = "lesson.txt";

impl RiemapApp {
    /// Carries out an action of the lesson's panel.
    pub(super) fn act_on_lesson(&mut self, action: LessonAction, context: &egui::Context) {
        if action.concerns_session() && self.held().is_some() {
            return; // the panel says why
        }
        let editor = &mut self.windows.lesson;
        match action {
            LessonAction::Open => {
                editor.is_open = true;
                self.meet_other_draft();
            }
            LessonAction::Close => editor.is_open = false,
            LessonAction::Title(title) => editor.change(Change::Title, |draft| draft.title = title),
            LessonAction::Caption(k, caption) => editor.change(Change::Caption(k), |draft| {
                if let Some(step) = draft.steps.get_mut(k) {
                    step.caption = caption;
                }
            }),
            LessonAction::Add => self.take_step(None),
            LessonAction::Renew(k) => self.take_step(Some(k)),
            LessonAction::Show(k) => self.show_step(k),
            LessonAction::Swap(k) if k + 1 < editor.draft().steps.len() => {
                editor.change(Change::Move, |draft| draft.steps.swap(k, k + 1));
            }
            LessonAction::Swap(_) => {}
            LessonAction::Delete(k) => editor.delete(k),
            LessonAction::Undo => editor.undo(),
            LessonAction::Redo => editor.redo(),
            LessonAction::Play => {
                let draft = editor.draft().tidied();
                self.play_lesson(draft);
            }
            LessonAction::Save => self.save_lesson(),
            LessonAction::CopyLink => self.copy_lesson_link(context),
            LessonAction::OpenFile => self.pick_file(FilePurpose::Lesson),
        }
    }

    /// Why no picture can be taken, shown or played now: something else holds the session.
    pub(super) fn held(&self) -> Option<Label> {
        if !self.editor.is_at_rest() {
            Some(key::lesson_waits_for_outline())
        } else if self.windows.exporter.is_busy() {
            Some(key::lesson_waits_for_export())
        } else {
            None
        }
    }

    fn is_preparing(&self) -> bool {
        Side::BOTH.into_iter().any(|side| self.model.is_preparing(side))
    }

    /// Makes the present picture a step, the one at this place or the last; says what a link does not hold of it.
    fn take_step(&mut self, at: Option<usize>) {
        if self.is_preparing() {
            // the session is still that of the shapes before
            self.windows.lesson.note = Some(key::lesson_waits_for_shapes().into());
            return;
        }
        let session = self.model.session();
        let missing = self.persistence.missing();
        let step = Step::of(session, String::new());
        let editor = &mut self.windows.lesson;
        // a disk stands for what is missing
        if let Some(missing) = missing.first() {
            editor.note = Some(key::step_refused(key::disk_stands_in(missing.side, &missing.name)));
            return;
        }
        match step {
            Ok((step, shortened)) => {
                editor.put(step, at);
                let lacks = Message::joined(shortened.iter().map(Message::from), key::both_clauses);
                editor.note = lacks.map(key::step_added_but);
            }
            Err(error) => editor.note = Some(key::step_refused(Message::from(&error))),
        }
    }

    /// Shows the picture of a step, as an undo step.
    fn show_step(&mut self, k: usize) {
        let Some(step) = self.windows.lesson.draft().steps.get(k) else { return };
        let session = step.session().clone();
        // what the user has just changed, or what moves, is what undo brings back
        self.persistence.leave(self.is_at_rest().then(|| self.model.session()));
        self.open_session(session);
    }

    fn save_lesson(&mut self) {
        match lesson::write(self.windows.lesson.draft(), platform::address_with) {
            Ok(text) => platform::save_file(FILE_NAME, text.into_bytes(), self.workers.mailbox.clone()),
            Err(error) => self.refuse_draft(&error),
        }
    }

    fn copy_lesson_link(&mut self, context: &egui::Context) {
        match lesson::encode(self.windows.lesson.draft()) {
            Ok(fragment) => {
                context.copy_text(platform::address_with(&fragment));
                self.windows.lesson.note = None;
                self.messages.notice = Some(Notice::new(key::link_copied(), context.input(|input| input.time)));
            }
            Err(error) => self.refuse_draft(&error),
        }
    }

    fn refuse_draft(&mut self, error: &LessonError) {
        self.windows.lesson.note = Some(key::lesson_refused(Message::from(error)));
    }

    /// Stores the draft if it has changed. What another tab has stored meanwhile is one undo step away.
    pub(super) fn keep_lesson(&mut self) {
        let waits = Message::from(key::lesson_waits_for_shapes());
        if self.windows.lesson.note.as_ref() == Some(&waits) && !self.is_preparing() {
            self.windows.lesson.note = None; // its cause is gone
        }
        if !self.windows.lesson.is_stale() || !self.screen.remembers {
            return;
        }
        let is_replaceable = self.meet_other_draft();
        self.windows.lesson.end_stale();
        if !is_replaceable {
            return;
        }
        match lesson::write(self.windows.lesson.draft(), |fragment| format!("#{fragment}")) {
            Ok(text) => match platform::remember(Kept::Lesson, &text) {
                Ok(()) => self.windows.lesson.known = Some(text),
                Err(reason) => self.windows.lesson.note = Some(key::lesson_not_kept(reason)),
            },
            Err(error) => self.refuse_draft(&error),
        }
    }

    /// Takes in the draft that is stored if another tab or window has stored it. Returns whether the stored one may be
    /// replaced: not one that cannot be read, as of a newer version.
    pub(super) fn meet_other_draft(&mut self) -> bool {
        if !self.screen.remembers {
            return false;
        }
        let stored = platform::remembered(Kept::Lesson);
        let editor = &mut self.windows.lesson;
        if stored == editor.known {
            return true;
        }
        match stored.as_deref().filter(|text| !text.is_empty()).map(|text| lesson::read_draft(text.as_bytes())) {
            Some(Err(error)) => {
                editor.note = Some(key::lesson_not_kept(Message::from(&error)));
                return false;
            }
            Some(Ok(other)) => editor.meet(other),
            None => {}
        }
        editor.known = stored;
        true
    }

    /// Plays a lesson in place of what is shown; its end brings that back.
    pub(super) fn play_lesson(&mut self, lesson: Lesson) {
        self.begin_playing();
        let is_walking = self.model.overlay_state().walks.is_running();
        let consequences = self.windows.explore.play(Arc::new(lesson), &self.model.requested(), is_walking);
        self.follow(consequences);
    }

    /// Leaves the editing of an outline, and the motions of a step before.
    pub(super) fn begin_playing(&mut self) {
        self.editor.act(EditAction::Leave, &mut self.model, &mut self.pictures.views);
        self.windows.explore.end_motions(&mut self.player, &self.model);
    }

    /// Plays the lesson of a link; the error is the reason why the link cannot be opened.
    pub(super) fn try_lesson_link(&mut self, address: &str) -> Result<(), Message> {
        let lesson = lesson::decode(address).map_err(|error| Message::from(&error))?;
        if let Some(reason) = self.held() {
            return Err(reason.into());
        }
        self.begin_visit();
        // a reload in the middle of the lesson finds the session in this visit
        self.persistence.owe_copy();
        self.messages.common = None;
        self.play_lesson(lesson);
        Ok(())
    }

    /// Takes the file of a lesson: one for the panel becomes the draft, any other is played.
    pub(super) fn take_lesson(&mut self, purpose: FilePurpose, name: &str, bytes: &[u8]) {
        match lesson::read(bytes) {
            Ok(lesson) if purpose == FilePurpose::Lesson => self.windows.lesson.replace(lesson),
            Ok(lesson) => {
                if let Some(reason) = self.held() {
                    self.messages.common = Some(key::about(name, reason));
                    return;
                }
                self.messages.common = None;
                let was_lesson = self.windows.explore.plays_lesson();
                self.play_lesson(lesson);
                if was_lesson {
                    self.correct_address(); // it may be that of the lesson before
                }
            }
            Err(error) => self.messages.common = Some(key::about(name, Message::from(&error))),
        }
    }

    /// Plays the lesson in the address of the page, once the app is there.
    pub(super) fn play_addressed(&mut self) {
        if let Some(address) = platform::lesson_link() {
            self.play_address(&address);
        }
    }

    /// Plays the lesson of this visit's address over the user's session, or says why not.
    pub(super) fn play_address(&mut self, address: &str) {
        match lesson::decode(address) {
            Ok(lesson) if self.may(Touched::EVERYTHING) => self.play_lesson(lesson),
            Ok(_) => self.correct_address(),
            Err(error) => {
                self.messages.common = Some(key::link_not_opened(Message::from(&error)));
                self.correct_address();
            }
        }
    }
}

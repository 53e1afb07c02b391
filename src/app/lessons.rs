//! Lessons: made in their panel, kept, saved, opened and played.

use super::RiemapApp;
use super::messages::Notice;
use crate::app::input::action::{EditAction, LessonAction};
use crate::language::{Message, key};
use crate::model::files::FilePurpose;
use crate::platform::{self, Kept};
use crate::session::lesson::{self, Lesson, LessonError, Step};
use crate::session::{Command, Touched};
use std::sync::Arc;

/// The name of a saved lesson: text editors open it.
const FILE_NAME: &str = "lesson.txt";

impl RiemapApp {
    /// Carries out an action of the lesson's panel.
    pub(super) fn act_on_lesson(&mut self, action: LessonAction, context: &egui::Context) {
        let editor = &mut self.windows.lesson;
        match action {
            LessonAction::Open => editor.is_open = true,
            LessonAction::Close => editor.is_open = false,
            LessonAction::Title(title) => editor.change(|draft| draft.title = title),
            LessonAction::Caption(k, caption) => editor.change(|draft| {
                if let Some(step) = draft.steps.get_mut(k) {
                    step.caption = caption;
                }
            }),
            LessonAction::Add => self.take_step(None),
            LessonAction::Renew(k) => self.take_step(Some(k)),
            LessonAction::Show(k) => self.show_step(k, context.input(|input| input.time)),
            LessonAction::Swap(k) if k + 1 < editor.draft().steps.len() => {
                editor.change(|draft| draft.steps.swap(k, k + 1));
            }
            LessonAction::Swap(_) => {}
            LessonAction::Delete(k) => editor.delete(k),
            LessonAction::Restore => editor.restore(),
            LessonAction::Play => {
                let draft = editor.draft().tidied();
                self.play_lesson(draft);
            }
            LessonAction::Save => self.save_lesson(),
            LessonAction::CopyLink => self.copy_lesson_link(context),
            LessonAction::OpenFile => self.pick_file(FilePurpose::Lesson),
        }
    }

    /// Makes the present picture a step, the one at this place or the last; says what a link does not hold of it.
    fn take_step(&mut self, at: Option<usize>) {
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
    fn show_step(&mut self, k: usize, now: f64) {
        if let Some(step) = self.windows.lesson.draft().steps.get(k) {
            let open = Command::Open(Box::new(step.session().clone()));
            self.command(open, now);
        }
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

    /// Stores the draft if it has changed.
    pub(super) fn keep_lesson(&mut self) {
        if !self.windows.lesson.take_stale() || !self.screen.remembers {
            return;
        }
        match lesson::write(self.windows.lesson.draft(), |fragment| format!("#{fragment}")) {
            Ok(text) => {
                if let Err(reason) = platform::remember(Kept::Lesson, &text) {
                    self.windows.lesson.note = Some(key::lesson_not_kept(reason));
                }
            }
            Err(error) => self.refuse_draft(&error),
        }
    }

    /// Plays a lesson in place of what is shown; its end brings that back.
    pub(super) fn play_lesson(&mut self, lesson: Lesson) {
        self.begin_playing();
        let is_walking = self.model.overlay_state().walks.is_running();
        let consequences = self.windows.explore.play(Arc::new(lesson), self.model.session(), is_walking);
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
        self.begin_visit();
        self.messages.common = None;
        self.play_lesson(lesson);
        Ok(())
    }

    /// Takes the file of a lesson: one for the panel becomes the draft, any other is played.
    pub(super) fn take_lesson(&mut self, purpose: FilePurpose, name: &str, bytes: &[u8]) {
        match lesson::read(bytes) {
            Ok(lesson) if purpose == FilePurpose::Lesson => self.windows.lesson.replace(lesson),
            Ok(lesson) => {
                self.messages.common = None;
                self.play_lesson(lesson);
            }
            Err(error) => self.messages.common = Some(key::about(name, Message::from(&error))),
        }
    }

    /// Plays the lesson in the address of the page, once the app is there.
    pub(super) fn play_addressed(&mut self) {
        let Some(address) = platform::lesson_link() else { return };
        match lesson::decode(&address) {
            Ok(lesson) if self.may(Touched::EVERYTHING) => self.play_lesson(lesson),
            Ok(_) => {}
            Err(error) => {
                self.messages.common = Some(key::link_not_opened(Message::from(&error)));
                self.correct_address();
            }
        }
    }
}

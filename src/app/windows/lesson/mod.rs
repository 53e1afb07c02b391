//! The panel in which a lesson is made: its draft, and the way back from the last deletion. The panel is laid out in
//! `panel`; `src/app/lessons.rs` does what concerns the session, files and links.

mod panel;

pub use panel::show;

use crate::language::{Label, Message, key};
use crate::session::lesson::{Lesson, MAX_STEPS, Step};

/// The draft of a lesson, and whether its panel is shown.
#[derive(Default)]
pub struct LessonEditor {
    pub is_open: bool,
    draft: Lesson,
    /// The draft before a step was deleted or the whole replaced, and what has happened to it.
    former: Option<(Label, Lesson)>,
    /// What is to be said about the last action.
    pub note: Option<Message>,
    /// Whether the draft has changed since it was stored.
    is_stale: bool,
}

impl LessonEditor {
    /// The panel with the draft of the last run, closed.
    pub fn resume(draft: Lesson) -> Self {
        Self { draft, ..Self::default() }
    }

    pub fn draft(&self) -> &Lesson {
        &self.draft
    }

    /// Whether another step fits.
    pub fn has_room(&self) -> bool {
        self.draft.steps.len() < MAX_STEPS
    }

    /// What was deleted or replaced, if that can be taken back.
    pub fn restorable(&self) -> Option<Label> {
        self.former.as_ref().map(|(what, _)| *what)
    }

    /// Whether the draft has changed since the last call.
    pub fn take_stale(&mut self) -> bool {
        std::mem::take(&mut self.is_stale)
    }

    /// Changes the draft.
    pub fn change(&mut self, change: impl FnOnce(&mut Lesson)) {
        change(&mut self.draft);
        (self.note, self.is_stale) = (None, true);
    }

    /// Puts a step with the caption of the old one in place of a step, or appends it.
    pub fn put(&mut self, step: Step, at: Option<usize>) {
        self.change(|draft| match at.and_then(|at| draft.steps.get_mut(at)) {
            Some(old) => {
                let caption = std::mem::replace(old, step).caption;
                old.caption = caption;
            }
            None => draft.steps.push(step),
        });
    }

    /// Deletes a step; [`Self::restore`] brings it back.
    pub fn delete(&mut self, at: usize) {
        if at < self.draft.steps.len() {
            self.former = Some((key::step_deleted(), self.draft.clone()));
            self.change(|draft| _ = draft.steps.remove(at));
        }
    }

    /// Puts another lesson in place of the draft, which [`Self::restore`] brings back.
    pub fn replace(&mut self, lesson: Lesson) {
        let former = std::mem::replace(&mut self.draft, lesson);
        self.former = (!former.is_empty()).then_some((key::lesson_replaced(), former));
        (self.is_open, self.note, self.is_stale) = (true, None, true);
    }

    /// Takes the last deletion or replacement back. What was changed since is lost with it.
    pub fn restore(&mut self) {
        if let Some((_, former)) = self.former.take() {
            self.change(|draft| *draft = former);
        }
    }
}

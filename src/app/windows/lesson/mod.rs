//! The panel in which a lesson is made. `draft` has the lesson with its own undo, and the panel is laid out in `panel`;
//! `src/app/lessons.rs` does what concerns the session, files and links.

mod draft;
mod panel;

pub use draft::{Change, Draft};
pub use panel::show;

use crate::language::Message;
use crate::session::lesson::{Lesson, MAX_STEPS, Step};

/// The draft of a lesson, and whether its panel is shown.
#[derive(Default)]
pub struct LessonEditor {
    pub is_open: bool,
    draft: Draft,
    /// What is to be said about the last action.
    pub note: Option<Message>,
    /// The text of the draft that was read or stored last: if another is stored, another tab has changed it.
    pub known: Option<String>,
    /// Whether the draft has changed since it was stored.
    is_stale: bool,
}

impl LessonEditor {
    /// The panel with the draft of the last run and its stored text, closed.
    pub fn resume(draft: Lesson, known: Option<String>) -> Self {
        Self { draft: Draft::new(draft), known, ..Self::default() }
    }

    pub fn draft(&self) -> &Lesson {
        self.draft.lesson()
    }

    /// Whether another step fits.
    pub fn has_room(&self) -> bool {
        self.draft().steps.len() < MAX_STEPS
    }

    /// Whether the draft has changed since it was stored.
    pub fn is_stale(&self) -> bool {
        self.is_stale
    }

    /// Records that the draft is stored, or cannot be.
    pub fn end_stale(&mut self) {
        self.is_stale = false;
    }

    /// Changes the draft.
    pub fn change(&mut self, change: Change, make: impl FnOnce(&mut Lesson)) {
        self.note = None;
        self.is_stale |= self.draft.change(change, make);
    }

    /// Puts a step with the caption of the old one in place of a step, or appends it.
    pub fn put(&mut self, step: Step, at: Option<usize>) {
        match at.filter(|at| *at < self.draft().steps.len()) {
            Some(at) => self.change(Change::Renew(at), |draft| {
                let old = std::mem::replace(&mut draft.steps[at], step);
                draft.steps[at].caption = old.caption;
            }),
            None => self.change(Change::Add, |draft| draft.steps.push(step)),
        }
    }

    /// Deletes a step.
    pub fn delete(&mut self, at: usize) {
        if at < self.draft().steps.len() {
            self.change(Change::Delete, |draft| _ = draft.steps.remove(at));
        }
    }

    /// Puts another lesson in place of the draft.
    pub fn replace(&mut self, lesson: Lesson) {
        self.change(Change::Replace, |draft| *draft = lesson);
        self.is_open = true;
    }

    /// Takes the last change of the draft back.
    pub fn undo(&mut self) {
        self.note = None;
        self.is_stale |= self.draft.undo();
    }

    /// Makes the change again that was taken back last.
    pub fn redo(&mut self) {
        self.note = None;
        self.is_stale |= self.draft.redo();
    }

    /// Takes in what another tab or window has made of the draft; an own change that is not stored yet stands.
    pub fn meet(&mut self, other: Lesson) {
        self.draft.meet(other, self.is_stale);
    }
}

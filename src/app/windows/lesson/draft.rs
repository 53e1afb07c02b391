//! The draft of a lesson with its own undo: every change of it can be taken back and made again.

use crate::language::{Message, key};
use crate::session::lesson::Lesson;

/// The most changes that can be taken back: an hour's work, and 60 steps with long links take 25 MB then.
const MOST_CHANGES: usize = 50;

/// What a change of the draft does. Steps are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    Title,
    Caption(usize),
    Add,
    Renew(usize),
    Move,
    Delete,
    /// Another lesson takes the place of the whole.
    Replace,
    /// Another tab or window has changed it.
    Elsewhere,
    /// It stays as it is here although another tab or window has changed it too.
    KeepOwn,
}

impl Change {
    /// What has happened, for the row beside undo and redo.
    pub fn words(self) -> Message {
        match self {
            Self::Title => key::title_changed().into(),
            Self::Caption(k) => key::caption_changed(k + 1),
            Self::Add => key::step_added().into(),
            Self::Renew(k) => key::step_renewed(k + 1),
            Self::Move => key::step_moved().into(),
            Self::Delete => key::step_deleted().into(),
            Self::Replace => key::lesson_replaced().into(),
            Self::Elsewhere => key::lesson_changed_elsewhere().into(),
            Self::KeepOwn => key::lesson_kept_own().into(),
        }
    }

    /// Whether it is made letter by letter.
    fn is_typed(self) -> bool {
        matches!(self, Self::Title | Self::Caption(_))
    }
}

/// A draft, and the changes that led to it and that were taken back.
#[derive(Debug, Default)]
pub struct Draft {
    lesson: Lesson,
    /// Each change with the draft before it, the last one last.
    past: Vec<(Change, Lesson)>,
    /// Each change that was taken back with the draft after it, the next one last.
    future: Vec<(Change, Lesson)>,
    /// Whether what is typed next in the same field belongs to the last change.
    is_typing: bool,
    /// Counts the changes other than typing, after which a field may show another text.
    pub arrangement: usize,
}

impl Draft {
    /// A draft without changes.
    pub fn new(lesson: Lesson) -> Self {
        Self { lesson, ..Self::default() }
    }

    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// The change that would be taken back.
    pub fn last(&self) -> Option<Change> {
        self.past.last().map(|(change, _)| *change)
    }

    /// The change that would be made again.
    pub fn next(&self) -> Option<Change> {
        self.future.last().map(|(change, _)| *change)
    }

    /// Makes a change; texts typed one after another in the same field are one. Returns whether the draft has changed.
    pub fn change(&mut self, change: Change, make: impl FnOnce(&mut Lesson)) -> bool {
        let before = self.lesson.clone();
        make(&mut self.lesson);
        if self.lesson == before {
            return false;
        }
        let goes_on = self.is_typing && self.last() == Some(change);
        if !goes_on {
            self.past.push((change, before));
        }
        self.past.drain(..self.past.len().saturating_sub(MOST_CHANGES));
        self.future.clear();
        self.is_typing = change.is_typed();
        self.arrangement += usize::from(!change.is_typed());
        true
    }

    /// Takes the last change back; whether there is one.
    pub fn undo(&mut self) -> bool {
        self.step(true)
    }

    /// Makes the change again that was taken back last; whether there is one.
    pub fn redo(&mut self) -> bool {
        self.step(false)
    }

    fn step(&mut self, back: bool) -> bool {
        let (from, to) = if back { (&mut self.past, &mut self.future) } else { (&mut self.future, &mut self.past) };
        let Some((change, other)) = from.pop() else { return false };
        to.push((change, std::mem::replace(&mut self.lesson, other)));
        self.is_typing = false;
        self.arrangement += 1;
        true
    }

    /// Takes in what another tab has made of the draft. Without a change of its own that is not `stored` yet the draft
    /// becomes the other; otherwise it stays, and undo shows the other.
    pub fn meet(&mut self, other: Lesson, has_own_change: bool) {
        if other == self.lesson.tidied() {
            return;
        }
        self.is_typing = false;
        if has_own_change {
            let own = self.lesson.clone();
            self.change(Change::Elsewhere, |draft| *draft = other);
            self.change(Change::KeepOwn, |draft| *draft = own);
        } else {
            self.change(Change::Elsewhere, |draft| *draft = other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn titled(title: &str) -> Lesson {
        Lesson { title: title.into(), ..Lesson::default() }
    }

    fn typed(draft: &mut Draft, title: &str) {
        draft.change(Change::Title, |lesson| lesson.title = title.into());
    }

    #[test]
    fn what_is_typed_in_a_row_is_one_change_and_undone_it_can_be_made_again() {
        let mut draft = Draft::new(titled("A"));
        typed(&mut draft, "AB");
        typed(&mut draft, "ABC");
        assert!(draft.undo() && !draft.undo());
        assert_eq!((draft.lesson().title.as_str(), draft.last(), draft.next()), ("A", None, Some(Change::Title)));
        assert!(draft.redo() && !draft.redo());
        assert_eq!(draft.lesson().title, "ABC");
        typed(&mut draft, "ABCD");
        assert!(draft.undo());
        assert_eq!(draft.lesson().title, "ABC", "after a redo a change of its own begins");
    }

    #[test]
    fn nothing_changed_is_no_change_and_the_oldest_ones_are_forgotten() {
        let mut draft = Draft::default();
        assert!(!draft.change(Change::Delete, |_| {}) && draft.last().is_none());
        for k in 0..MOST_CHANGES + 5 {
            draft.change(Change::Add, |lesson| lesson.title = k.to_string());
        }
        let undone = std::iter::from_fn(|| draft.undo().then_some(())).count();
        assert_eq!((undone, draft.lesson().title.as_str()), (MOST_CHANGES, "4"));
    }

    #[test]
    fn what_another_tab_has_made_of_it_is_shown_and_both_can_be_brought_back() {
        let mut draft = Draft::new(titled("A"));
        draft.meet(titled("theirs"), false);
        assert_eq!((draft.lesson().title.as_str(), draft.last()), ("theirs", Some(Change::Elsewhere)));
        typed(&mut draft, "mine");
        draft.meet(titled("theirs again"), true);
        assert_eq!(draft.lesson().title, "mine");
        let shown = ["theirs again", "mine", "theirs", "A"];
        assert!(shown.iter().all(|title| draft.undo() && draft.lesson().title == *title));
        let arrangement = draft.arrangement;
        draft.meet(titled("A"), false);
        assert_eq!(draft.arrangement, arrangement, "the same is no change");
    }
}

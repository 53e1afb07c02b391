//! Undo and redo: a list of settled sessions.
//!
//! Whatever happens between two settled sessions, a drag or the movement of a slider, is one step.

use super::Session;

/// The maximal number of undo steps kept.
const MOST_STEPS: usize = 200;
/// The maximal number of loaded outline points in all steps together: 32 MB.
const MOST_POINTS: usize = 2_000_000;

/// The present session, the sessions before it, and the undone ones after it.
#[derive(Debug, Clone)]
pub struct History {
    now: Session,
    past: Vec<Session>,
    future: Vec<Session>,
}

impl History {
    /// A history with `session` as its only entry.
    pub fn new(session: Session) -> Self {
        Self { now: session, past: Vec::new(), future: Vec::new() }
    }

    /// A history with the steps before `now`, the oldest first, and the undone ones after it, the last undone last.
    pub fn from_steps(past: Vec<Session>, now: Session, future: Vec<Session>) -> Self {
        let mut history = Self { now, past, future };
        history.forget_the_oldest();
        history
    }

    /// The steps before the present session, the oldest first.
    pub fn past(&self) -> &[Session] {
        &self.past
    }

    /// The undone steps; the one that is redone next comes last.
    pub fn future(&self) -> &[Session] {
        &self.future
    }

    /// The loaded outline points in all steps together.
    pub fn loaded_points(&self) -> usize {
        self.past.iter().chain([&self.now]).chain(&self.future).map(Session::loaded_points).sum()
    }

    /// Whether the own picture is shown in one of its steps.
    pub fn shows_image(&self) -> bool {
        let mut all = self.past.iter().chain([&self.now]).chain(&self.future);
        all.any(Session::shows_picture)
    }

    /// Continues with `other`: its present session becomes the present one, the steps of both can be undone, and its
    /// undone steps redone.
    pub fn continue_with(&mut self, other: Self) {
        if self.now != *other.past.first().unwrap_or(&other.now) {
            self.past.push(std::mem::replace(&mut self.now, other.now.clone()));
        }
        self.past.extend(other.past);
        (self.now, self.future) = (other.now, other.future);
        self.forget_the_oldest();
    }

    /// Gives the files of surfaces other names, in every step.
    pub fn rename_surface_files(&mut self, name: &dyn Fn(&str) -> String) {
        for session in self.past.iter_mut().chain(&mut self.future).chain([&mut self.now]) {
            session.rename_surface_files(name);
        }
    }

    /// Records a settled session as a new step; false if it equals the present one, up to points that follow from pins. A
    /// new step discards what could be redone.
    pub fn settle(&mut self, session: &Session) -> bool {
        if session.is_same_choice(&self.now) {
            self.amend(session);
            return false;
        }
        self.past.push(std::mem::replace(&mut self.now, session.clone()));
        self.future.clear();
        self.forget_the_oldest();
        true
    }

    /// Replaces the present session by the result of an undo or redo, without adding a step.
    pub fn amend(&mut self, session: &Session) {
        if *session != self.now {
            self.now = session.clone();
        }
    }

    /// The present session.
    pub fn now(&self) -> &Session {
        &self.now
    }

    /// One step back; `None` at the beginning.
    pub fn undo(&mut self) -> Option<&Session> {
        let before = self.past.pop()?;
        self.future.push(std::mem::replace(&mut self.now, before));
        Some(&self.now)
    }

    /// One step forward; `None` if nothing is undone.
    pub fn redo(&mut self) -> Option<&Session> {
        let after = self.future.pop()?;
        self.past.push(std::mem::replace(&mut self.now, after));
        Some(&self.now)
    }

    /// Whether there is a step to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// The number of steps that can be undone.
    pub fn undo_count(&self) -> usize {
        self.past.len()
    }

    /// Whether there is a step to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    fn forget_the_oldest(&mut self) {
        let mut points: usize = self.past.iter().map(Session::loaded_points).sum();
        while self.past.len() > MOST_STEPS || (points > MOST_POINTS && self.past.len() > 1) {
            points -= self.past.remove(0).loaded_points();
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::Side;
    use crate::geometry::DVec2;
    use crate::session::{Command, OutlineSpec, scaled};

    #[test]
    fn undo_and_redo_restore_sessions_in_order() {
        let mut history = History::new(scaled(1.0));
        assert!(history.settle(&scaled(2.0)) && history.settle(&scaled(3.0)));
        assert!(!history.settle(&scaled(3.0)), "nothing has changed");
        assert_eq!(history.undo(), Some(&scaled(2.0)));
        assert_eq!(history.undo(), Some(&scaled(1.0)));
        assert!(history.undo().is_none() && !history.can_undo());
        assert_eq!(history.redo(), Some(&scaled(2.0)));
        assert!(!history.settle(&scaled(2.0)) && history.can_redo(), "what was undone to is no new step");
        assert!(history.settle(&scaled(9.0)) && !history.can_redo());
        assert_eq!(history.undo(), Some(&scaled(2.0)));
    }

    #[test]
    fn a_history_that_continues_keeps_the_steps_of_both() {
        let mut history = History::new(scaled(1.0));
        assert!(history.settle(&scaled(2.0)));
        let other = History::from_steps(vec![scaled(5.0)], scaled(6.0), vec![scaled(7.0)]);
        history.continue_with(other);
        assert_eq!(history.now(), &scaled(6.0));
        assert_eq!(history.redo(), Some(&scaled(7.0)));
        let undone: Vec<Session> = std::iter::from_fn(|| history.undo().cloned()).collect();
        assert_eq!(undone, [6.0, 5.0, 2.0, 1.0].map(scaled));
        let mut same = History::new(scaled(1.0));
        same.continue_with(History::new(scaled(1.0)));
        assert_eq!(same.undo_count(), 0, "the same session is no step");
    }

    /// A restored session may settle in another state, for example if its preparation fails.
    #[test]
    fn the_result_of_an_undo_is_not_a_new_history_entry() {
        let mut history = History::new(scaled(1.0));
        assert!(history.settle(&scaled(2.0)) && history.settle(&scaled(3.0)));
        assert_eq!(history.undo(), Some(&scaled(2.0)));
        history.amend(&scaled(2.5));
        assert_eq!((history.now(), history.undo_count()), (&scaled(2.5), 1));
        assert_eq!(history.redo(), Some(&scaled(3.0)));
        assert_eq!(history.undo(), Some(&scaled(2.5)));
        assert_eq!(history.undo(), Some(&scaled(1.0)));
    }

    #[test]
    fn the_oldest_steps_are_forgotten() {
        let mut history = History::new(scaled(0.0));
        for k in 1..=MOST_STEPS + 50 {
            history.settle(&scaled(k as f64));
        }
        let steps = std::iter::from_fn(|| history.undo().map(|_| ())).count();
        assert_eq!(steps, MOST_STEPS);
    }

    #[test]
    fn large_outlines_do_not_fill_the_memory() {
        const LARGE: usize = MOST_POINTS / 20;
        // a staircase along the diagonal, closed through the corner
        let steps = (0..LARGE - 1).map(|k| DVec2::new(k.div_ceil(2) as f64, (k / 2) as f64));
        let points = steps.chain([DVec2::new(0.0, LARGE as f64)]).collect::<Vec<_>>();
        let polygon = crate::geometry::SimplePolygon::try_from(points).unwrap();
        let large = |k: usize| {
            let outline = OutlineSpec::points(format!("large {k}"), polygon.clone());
            Session::with([Command::SetOutline { side: Side::Source, outline }])
        };
        let mut history = History::new(large(0));
        for k in 1..30 {
            history.settle(&large(k));
        }
        assert_eq!(history.past.len(), 20);
    }
}

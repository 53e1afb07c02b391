//! The conformal invariants of the planar sides: what is asked for, what a worker computes, what was found.
//!
//! Only sides of which they are asked for, or which have marks, are computed, one at a time and at rest. A result belongs to its request: after a
//! change the former numbers are not shown.

use crate::conformal::{PerSide, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::worker::{FoundInvariants, InvariantsTask};

/// A change of what is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InvariantsAction {
    /// Compute a side's invariants, or no more.
    Open(Side, bool),
    /// Put a second point into a side, or remove it.
    SecondPoint(Side, Option<DVec2>),
}

/// What is asked for of a side, and the last result.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SideInvariants {
    /// Whether they are asked for, also without marks.
    pub is_open: bool,
    /// The second point.
    pub second_point: Option<DVec2>,
    found: Option<(InvariantsTask, Result<FoundInvariants, Message>)>,
}

/// The invariants of both sides.
#[derive(Debug, Default)]
pub struct InvariantsState {
    sides: PerSide<SideInvariants>,
    in_flight: Option<InvariantsTask>,
}

impl InvariantsState {
    /// What is asked for of a side.
    pub fn of(&self, side: Side) -> &SideInvariants {
        &self.sides[side]
    }

    /// Changes what is asked for.
    pub fn act(&mut self, action: InvariantsAction) {
        match action {
            InvariantsAction::Open(side, is_open) => self.sides[side].is_open = is_open,
            InvariantsAction::SecondPoint(side, point) => self.sides[side].second_point = point,
        }
    }

    /// Follows an exchange of the sides; numbers are computed anew.
    pub fn swap(&mut self) {
        self.sides.swap();
    }

    /// Whether a result for one of the tasks is missing, and none is in flight.
    pub fn is_due(&self, tasks: &PerSide<Option<InvariantsTask>>) -> bool {
        self.in_flight.is_none() && self.next(tasks).is_some()
    }

    /// The next task to send to the worker, which is then in flight.
    pub fn take(&mut self, tasks: &PerSide<Option<InvariantsTask>>) -> Option<InvariantsTask> {
        if self.in_flight.is_none() {
            self.in_flight = self.next(tasks).cloned();
            return self.in_flight.clone();
        }
        None
    }

    fn next<'a>(&self, tasks: &'a PerSide<Option<InvariantsTask>>) -> Option<&'a InvariantsTask> {
        let is_missing = |task: &&InvariantsTask| self.sides[task.side].result(task).is_none();
        Side::BOTH.into_iter().filter_map(|side| tasks[side].as_ref()).find(is_missing)
    }

    /// Stores the result of the task in flight.
    pub fn accept(&mut self, result: Result<FoundInvariants, Message>) {
        if let Some(task) = self.in_flight.take() {
            let side = task.side;
            self.sides[side].found = Some((task, result));
        }
    }
}

impl SideInvariants {
    /// The result of this very task.
    pub fn result(&self, task: &InvariantsTask) -> Option<&Result<FoundInvariants, Message>> {
        self.found.as_ref().filter(|(found, _)| found == task).map(|(_, result)| result)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::worker::StudiedOutline;

    fn task(side: Side, x: f64) -> InvariantsTask {
        let point = DVec2::new(x, 0.0);
        InvariantsTask { side, outline: StudiedOutline::Preset(Preset::Disk), point, second_point: None, marks: None }
    }

    #[test]
    fn one_task_at_a_time_and_results_belong_to_their_tasks() {
        let mut state = InvariantsState::default();
        let both = PerSide::new(Some(task(Side::Source, 0.0)), Some(task(Side::Target, 0.0)));
        assert!(state.is_due(&both));
        assert_eq!(state.take(&both), both.source);
        assert!(state.take(&both).is_none() && !state.is_due(&both), "one is in flight");
        state.accept(Err("no".into()));
        assert!(state.of(Side::Source).result(&task(Side::Source, 0.0)).is_some_and(Result::is_err));
        assert_eq!(state.take(&both), both.target);
        state.accept(Err("no".into()));
        assert!(!state.is_due(&both), "nothing has changed");
        // a point has moved: the former result is not that of the new task
        let moved = PerSide::new(Some(task(Side::Source, 0.1)), both.target.clone());
        assert!(state.of(Side::Source).result(&task(Side::Source, 0.1)).is_none());
        assert_eq!(state.take(&moved), moved.source);
        state.accept(Err("no".into()));
        state.accept(Err("the worker died twice".into()));
        assert!(!state.is_due(&moved) && state.take(&PerSide::new(None, None)).is_none());
    }
}

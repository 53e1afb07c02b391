//! The orthogonal grids between the marks of the outlines: what is asked for, what the worker computes, what was found.
//!
//! One task is computed at a time: the file that is to be saved first, then the grids that are shown. A task that is no more
//! wanted is superseded by the next one, or cancelled.

use crate::conformal::{GridCells, PerSide, Side};
use crate::export::GridFormat;
use crate::language::{Message, key};
use crate::model::export::ReadyFile;
use crate::worker::{Finding, FoundGrid, GridContent, GridTask};

/// The numbers of cells until the modulus is known, and about how many cells there are then.
const CELLS: [u32; 2] = [20, 10];

/// How long a grid that is to be shown is asked for without change before it is computed, in seconds: marks and numbers of
/// cells change in steps, by drags, keys and wheels. A file is asked for by a click, and is computed at once.
const REST_SECONDS: f64 = 0.25;

/// A change of what is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GridAction {
    /// Show a side's grid, or no more.
    Show(Side, bool),
    /// Set the numbers of cells.
    Cells(Side, GridCells),
    /// Save a side's grid.
    Save(Side, GridFormat),
    /// Save a side's grid no more.
    Cancel(Side),
}

/// What is asked for of a side, and the last result.
#[derive(Debug, Clone, Default)]
pub struct SideGrid {
    /// Whether the grid is shown.
    pub is_shown: bool,
    /// The numbers of cells that were chosen.
    cells: Option<GridCells>,
    /// Those that make the cells of the quadrilateral with these marks nearly square.
    square: Option<([f64; 4], GridCells)>,
    /// The file to save.
    to_save: Option<GridTask>,
    found: Option<(GridTask, Result<FoundGrid, Message>)>,
}

/// What the worker is to do next.
#[derive(Debug, Clone, PartialEq)]
pub enum GridWork {
    /// Go on, or wait.
    Nothing,
    /// Wait; in this many seconds there is something to begin with, unless something else is asked for until then.
    Wait(f64),
    /// Begin with this.
    Begin(GridTask),
}

/// The grids of both sides.
#[derive(Debug, Default)]
pub struct GridState {
    sides: PerSide<SideGrid>,
    in_flight: Option<GridTask>,
    /// The share of the task in flight that is done.
    done: f64,
    /// The grid to be shown that waits, and since when it does.
    waits: Option<(GridTask, f64)>,
}

impl SideGrid {
    /// The numbers of cells along the sides from mark 1 to 2 and from mark 2 to 3.
    pub fn cells(&self) -> Option<GridCells> {
        self.cells.or(self.square.map(|(_, cells)| cells)).or(GridCells::new(CELLS))
    }

    /// Whether the numbers of cells are chosen, or known for these marks.
    pub fn has_cells_for(&self, marks: [f64; 4]) -> bool {
        self.cells.is_some() || self.square.is_some_and(|(known, _)| known == marks)
    }

    /// The result of this very task.
    pub fn result(&self, task: &GridTask) -> Option<&Result<FoundGrid, Message>> {
        self.found.as_ref().filter(|(found, _)| found == task).map(|(_, result)| result)
    }
}

impl GridState {
    /// What is asked for of a side.
    pub fn of(&self, side: Side) -> &SideGrid {
        &self.sides[side]
    }

    /// The share of the file of a side's grid that is done; `None` without one.
    pub fn saving(&self, side: Side) -> Option<f64> {
        self.sides[side].to_save.as_ref().map(|task| self.done_of(task))
    }

    /// The share of a task that is done: 0 while it waits.
    pub fn done_of(&self, task: &GridTask) -> f64 {
        if self.in_flight.as_ref() == Some(task) { self.done } else { 0.0 }
    }

    /// Whether the worker computes a grid.
    pub fn is_computing(&self) -> bool {
        self.in_flight.is_some()
    }

    /// Shows a side's grid, or no more.
    pub fn show(&mut self, side: Side, is_shown: bool) {
        self.sides[side].is_shown = is_shown;
    }

    /// Sets the numbers of cells.
    pub fn set_cells(&mut self, side: Side, cells: GridCells) {
        self.sides[side].cells = Some(cells);
    }

    /// Takes in the modulus between marks of a side, `None` if there is none: until numbers of cells are chosen, there are
    /// about as many cells as in the beginning, nearly square in the mean.
    pub fn fit_cells(&mut self, side: Side, marks: [f64; 4], modulus: Option<f64>) {
        let count = f64::from(CELLS[0] * CELLS[1]);
        let fitted = |modulus: f64| {
            [(count / modulus).sqrt(), (count * modulus).sqrt()].map(|cells| cells.round().max(1.0) as u32)
        };
        let cells = GridCells::new(modulus.map_or(CELLS, fitted)).or(GridCells::new(CELLS));
        self.sides[side].square = cells.map(|cells| (marks, cells));
    }

    /// Follows an exchange of the sides.
    pub fn swap(&mut self) {
        self.sides.swap();
    }

    /// The file to save of a side's grid, in the place of its last one; `None`: none any more.
    pub fn save(&mut self, side: Side, task: Option<GridTask>) {
        self.sides[side].to_save = task;
    }

    /// What is to be computed, where these grids are shown: files first.
    fn wanted(&self, shown: &PerSide<Option<GridTask>>) -> Option<GridTask> {
        let is_missing = |(side, task): &(Side, &GridTask)| self.sides[*side].result(task).is_none();
        let missing = shown.iter().filter_map(|(side, task)| Some((side, task.as_ref()?))).find(is_missing);
        let to_save = self.sides.iter().find_map(|(_, side)| side.to_save.as_ref());
        to_save.or(missing.map(|(_, task)| task)).cloned()
    }

    /// Gives up what the worker does if something else is wanted, or nothing; returns whether it did.
    pub fn give_up(&mut self, shown: &PerSide<Option<GridTask>>) -> bool {
        self.in_flight.is_some() && self.wanted(shown) != self.in_flight && self.in_flight.take().is_some()
    }

    /// What the worker is to do at the time `now` in seconds, where these grids are shown; nothing while it does something.
    pub fn next(&mut self, shown: &PerSide<Option<GridTask>>, now: f64) -> GridWork {
        let Some(task) = self.wanted(shown).filter(|_| self.in_flight.is_none()) else { return GridWork::Nothing };
        if task.file().is_none() {
            let left = self.wait_for(&task, now);
            if left > 0.0 {
                return GridWork::Wait(left);
            }
        }
        (self.in_flight, self.done, self.waits) = (Some(task.clone()), 0.0, None);
        GridWork::Begin(task)
    }

    /// The seconds until a grid has been asked for long enough.
    fn wait_for(&mut self, task: &GridTask, now: f64) -> f64 {
        let since = match &self.waits {
            Some((waiting, since)) if waiting == task => *since,
            _ => {
                self.waits = Some((task.clone(), now));
                now
            }
        };
        since + REST_SECONDS - now
    }

    /// Takes a finding about a task: the file to save, if it is complete, or why there is none. One about another task than
    /// that in flight is dropped. `shown` are the grids that are shown.
    pub fn accept(
        &mut self,
        task: &GridTask,
        finding: Finding,
        shown: &PerSide<Option<GridTask>>,
    ) -> Option<Result<ReadyFile, Message>> {
        if self.in_flight.as_ref() != Some(task) {
            return None;
        }
        let result = match finding {
            Finding::Progress(done) => {
                self.done = done;
                return None;
            }
            Finding::Grid(found) => Ok(*found),
            Finding::Failed(reason) => Err(reason),
            _ => Err(key::another_answer().into()),
        };
        self.in_flight = None;
        if let Some(format) = task.file() {
            let saved = Side::BOTH.into_iter().find(|side| self.sides[*side].to_save.as_ref() == Some(task));
            if let Some(side) = saved {
                self.sides[side].to_save = None;
            }
            return Some(result.map(|found| file(found, format)));
        }
        for (side, _) in shown.iter().filter(|(_, shown)| shown.as_ref() == Some(task)) {
            self.sides[side].found = Some((task.clone(), result.clone()));
        }
        None
    }
}

fn file(FoundGrid { content, .. }: FoundGrid, format: GridFormat) -> ReadyFile {
    let text = if let GridContent::File(text) = content { text } else { String::new() };
    ReadyFile::new(format!("riemap_grid.{}", format.extension()), text)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::worker::{Number, StudiedOutline};

    fn task(preset: Preset, file: Option<GridFormat>) -> GridTask {
        let cells = GridCells::new(CELLS).unwrap();
        GridTask::new(StudiedOutline::Preset(preset), [0.0, 0.25, 0.5, 0.75], cells, file)
    }

    fn found(content: GridContent) -> Finding {
        let modulus = Number { value: 1.0, error: 0.0 };
        Finding::Grid(Box::new(FoundGrid { modulus, image_error: 0.0, angle_deviation: None, content }))
    }

    fn lines() -> Finding {
        found(GridContent::Lines([Vec::new(), Vec::new()]))
    }

    /// What is to be done after this has been asked for without change for long enough.
    fn rested(state: &mut GridState, shown: &PerSide<Option<GridTask>>) -> GridWork {
        match state.next(shown, 0.0) {
            GridWork::Wait(_) => state.next(shown, REST_SECONDS),
            work => work,
        }
    }

    #[test]
    fn files_come_first_and_what_is_no_more_wanted_is_given_up() {
        let mut state = GridState::default();
        let (disk, square) = (task(Preset::Disk, None), task(Preset::Square, None));
        let (none, both) = (PerSide::new(None, None), PerSide::new(Some(disk.clone()), Some(square.clone())));
        assert_eq!(rested(&mut state, &none), GridWork::Nothing);
        assert_eq!(rested(&mut state, &both), GridWork::Begin(disk.clone()));
        assert_eq!(rested(&mut state, &both), GridWork::Nothing, "it is in flight");
        state.accept(&disk, Finding::Progress(0.5), &both);
        assert!((state.done_of(&disk) - 0.5).abs() < 1e-12 && state.done_of(&square) < 1e-12);
        let csv = task(Preset::Disk, Some(GridFormat::Csv));
        state.save(Side::Source, Some(csv.clone()));
        assert!(state.give_up(&both));
        assert_eq!(state.next(&both, 0.0), GridWork::Begin(csv.clone()), "a file waits for nothing");
        assert!(!state.give_up(&both));
        assert_eq!(state.accept(&disk, lines(), &both), None, "superseded");
        let saved = state.accept(&csv, found(GridContent::File("i,j".into())), &both).unwrap().unwrap();
        assert_eq!((saved.name.as_str(), saved.bytes.as_slice()), ("riemap_grid.csv", &b"i,j"[..]));
        assert_eq!((rested(&mut state, &both), state.saving(Side::Source)), (GridWork::Begin(disk.clone()), None));
        state.accept(&disk, lines(), &both);
        assert!(state.of(Side::Source).result(&disk).unwrap().is_ok());
        assert_eq!(rested(&mut state, &both), GridWork::Begin(square.clone()));
        state.accept(&square, Finding::Failed("no".into()), &both);
        assert!(state.of(Side::Target).result(&square).unwrap().is_err());
        assert_eq!(rested(&mut state, &both), GridWork::Nothing, "a failure is not repeated");
        // another outline, and then none
        let other = PerSide::new(Some(task(Preset::Star, None)), None);
        assert!(matches!(rested(&mut state, &other), GridWork::Begin(_)) && state.is_computing());
        assert!(state.give_up(&none) && !state.is_computing());
        assert!(rested(&mut state, &none) == GridWork::Nothing && !state.give_up(&none));
    }

    #[test]
    fn cells_are_nearly_square_until_their_numbers_are_chosen() {
        let mut state = GridState::default();
        let counts = |state: &GridState| state.of(Side::Target).cells().unwrap().counts();
        assert_eq!(counts(&state), CELLS);
        for (modulus, expected) in [(0.5, [20, 10]), (1.0, [14, 14]), (2.0, [10, 20]), (17.9, [3, 60])] {
            assert!(!state.of(Side::Target).has_cells_for([modulus; 4]));
            state.fit_cells(Side::Target, [modulus; 4], Some(modulus));
            assert!(state.of(Side::Target).has_cells_for([modulus; 4]));
            assert_eq!(counts(&state), expected, "{modulus}");
        }
        state.set_cells(Side::Target, GridCells::new([7, 8]).unwrap());
        state.fit_cells(Side::Target, [0.0; 4], None);
        assert_eq!((counts(&state), state.of(Side::Source).cells().unwrap().counts()), ([7, 8], CELLS));
    }

    #[test]
    fn each_side_saves_a_file_of_its_own() {
        let (mut state, none) = (GridState::default(), PerSide::new(None, None));
        let (csv, obj) = (task(Preset::Disk, Some(GridFormat::Csv)), task(Preset::Star, Some(GridFormat::Obj)));
        state.save(Side::Source, Some(csv.clone()));
        state.save(Side::Target, Some(obj.clone()));
        assert_eq!(state.next(&none, 0.0), GridWork::Begin(csv.clone()));
        state.accept(&csv, Finding::Progress(0.5), &none);
        assert_eq!(Side::BOTH.map(|side| state.saving(side)), [Some(0.5), Some(0.0)]);
        state.save(Side::Source, None);
        assert!(state.give_up(&none));
        assert_eq!(state.next(&none, 0.0), GridWork::Begin(obj.clone()), "the other side's is still wanted");
        assert_eq!(state.accept(&obj, found(GridContent::File("v".into())), &none).unwrap().unwrap().bytes, b"v");
        assert_eq!((state.next(&none, 0.0), state.saving(Side::Target)), (GridWork::Nothing, None));
    }

    #[test]
    fn steps_of_a_drag_begin_nothing_and_end_what_is_under_way() {
        let mut state = GridState::default();
        let shown = |preset| PerSide::new(Some(task(preset, None)), None);
        let is_wait =
            |work: GridWork, seconds: f64| matches!(work, GridWork::Wait(left) if (left - seconds).abs() < 1e-9);
        assert!(matches!(rested(&mut state, &shown(Preset::Disk)), GridWork::Begin(_)));
        assert!(state.give_up(&shown(Preset::Square)));
        assert!(is_wait(state.next(&shown(Preset::Square), 1.0), REST_SECONDS));
        assert!(is_wait(state.next(&shown(Preset::Square), 1.1), REST_SECONDS - 0.1));
        assert!(is_wait(state.next(&shown(Preset::Star), 1.2), REST_SECONDS), "another step");
        assert!(matches!(state.next(&shown(Preset::Star), 1.2 + REST_SECONDS), GridWork::Begin(_)));
    }
}

//! The quadrilaterals that four marks make of the outlines: their rectangles as the other side, and their grids.
//!
//! Three marks are pinned to corners, which determines the map; the fourth one is met because the modulus is right. Four
//! pins would be met in the sense of least squares only, to 1e-8 to 1e-5, and of a rectangle of 10:1 to 1e-3.

use super::Model;
use super::names;
use super::overlays::orthogonal_grid::{GridAction, GridWork};
use crate::conformal::{GridCells, PerSide, Pins, Side, rectangle_corners};
use crate::drawing::carried_fraction;
use crate::export::GridFormat;
use crate::geometry::{DVec2, SimplePolygon};
use crate::language::{Message, Value, key};
use crate::model::export::ReadyFile;
use crate::outline::CurveForm;
use crate::session::{Command, OutlineSpec};
use crate::worker::{Finding, FoundGrid, GridContent, GridTask, Number};
use std::borrow::Cow;

/// The largest error of a modulus, as a part of it, with which its rectangle is made.
const LEAST_CERTAIN: f64 = 1e-3;

/// The number of marks that are pinned.
const PINNED: usize = 3;

/// The largest difference of two fractions of a boundary's length, or of two ratios, that are the same.
const SAME: f64 = 1e-9;

impl Model {
    /// The marks of an outline.
    pub fn marks(&self, side: Side) -> Option<[f64; 4]> {
        self.session.marks(side).filter(|_| self.abilities().has_outline(side))
    }

    /// The modulus between an outline's marks, once it is computed.
    fn modulus(&self, side: Side) -> Option<Number> {
        let of_grid = self.grid(side).and_then(|grid| grid.as_ref().ok()).map(|grid| grid.modulus);
        of_grid.or_else(|| self.invariants(side)?.as_ref().ok()?.modulus)
    }

    /// The command that puts the rectangle of an outline's marks on the other side, with the marks pinned to its corners.
    /// `None` without marks, or until their modulus is known. Errors: the modulus is too extreme or too uncertain.
    pub fn onto_rectangle(&self, side: Side) -> Option<Result<Command, Message>> {
        let (marks, modulus) = (self.marks(side)?, self.modulus(side)?);
        Some(onto_rectangle(side, marks, modulus))
    }

    /// Whether the modulus is known and too extreme for a rectangle.
    pub fn is_too_long(&self, side: Side) -> bool {
        self.marks(side).is_some()
            && self.modulus(side).is_some_and(|modulus| rectangle_corners(modulus.value).is_err())
    }

    /// The corners of the other side's rectangle in the order of an outline's marks, if they are pinned to each other and
    /// the rectangle is that of the modulus.
    pub fn pinned_rectangle(&self, side: Side) -> Option<[DVec2; 4]> {
        let (marks, other) = (self.marks(side)?, side.other());
        let OutlineSpec::Points { polygon, .. } = &self.session.domain(other).outline else { return None };
        let corners = <[DVec2; 4]>::try_from(polygon.vertices()).ok()?;
        let expected = rectangle_corners(self.modulus(side)?.value).ok()?;
        let ratio = |[a, b, _, d]: [DVec2; 4]| a.distance(d) / a.distance(b);
        let is_its = (ratio(corners) / ratio(expected) - 1.0).abs() < LEAST_CERTAIN
            && (corners[1] - corners[0]).dot(corners[2] - corners[1]) == 0.0
            && corners[0] + corners[2] == corners[1] + corners[3];
        let fractions = fractions(corners);
        let is_pinned = |(k, pair): (usize, &PerSide<f64>)| {
            (pair[side] - marks[k].rem_euclid(1.0)).abs() < SAME && (pair[other] - fractions[k]).abs() < SAME
        };
        let pins = self.pins().filter(|pins| pins.pairs().len() == PINNED)?;
        (is_its && self.abilities().has_outline(other) && pins.pairs().iter().enumerate().all(is_pinned))
            .then_some(corners)
    }

    /// The distance between the image of the fourth mark, which is not pinned, and the fourth corner; on the target.
    /// `None` unless the other three are pinned, and while the map is computed.
    pub fn fourth_miss(&self, side: Side) -> Option<f64> {
        let (marks, corners) = (self.marks(side)?, self.pinned_rectangle(side)?);
        let all = Pins::new(pairs(side, marks, corners)).ok()?;
        all.misses(self.full_map()?).last().copied()
    }

    /// Carries a side's marks along to a reshaped outline. On one that was turned over, the vertices after the first run the
    /// other way around; the first two marks and the last two change places, so that the cells of a grid stay where they are.
    pub(super) fn carry_marks(&mut self, side: Side, outline: &OutlineSpec, is_turned: bool) {
        let Some(marks) = self.session.marks(side) else { return };
        let (old, new) = (self.session.domain(side).outline.polygon(), outline.polygon());
        let mut vertices = new.vertices().to_vec();
        let marks = if is_turned {
            vertices[1..].reverse();
            [1, 0, 3, 2].map(|k| (1.0 - carried_fraction(old.vertices(), &vertices, marks[k])).rem_euclid(1.0))
        } else {
            marks.map(|mark| carried_fraction(old.vertices(), &vertices, mark))
        };
        self.session.apply(Command::SetMarks { side, marks: Some(marks) });
    }

    /// Changes what is asked for of the grids.
    pub fn act_on_grids(&mut self, action: GridAction) {
        let to_save = match action {
            GridAction::Save(side, format) => self.grid_task(side, Some(format)),
            _ => None,
        };
        let grids = &mut self.overlay_state.orthogonal_grids;
        match action {
            GridAction::Show(side, is_shown) => grids.show(side, is_shown),
            GridAction::Cells(side, cells) => grids.set_cells(side, cells),
            GridAction::Save(side, _) | GridAction::Cancel(side) => grids.save(side, to_save),
        }
    }

    /// The grid of an outline, as it is shown now; `None` until it is there, and where none is shown.
    pub fn grid(&self, side: Side) -> Option<&Result<FoundGrid, Message>> {
        self.overlay_state.orthogonal_grids.of(side).result(&self.shown_grid_task(side)?)
    }

    /// The share of a grid that is computed, where it is to be shown and not there yet.
    pub fn grid_progress(&self, side: Side) -> Option<f64> {
        let task = self.shown_grid_task(side)?;
        let grids = &self.overlay_state.orthogonal_grids;
        grids.of(side).result(&task).is_none().then(|| grids.done_of(&task))
    }

    /// The lines of the grids over a side: those of its own marks, and the lattice of the other side's marks where this side
    /// is their rectangle.
    pub fn grid_lines(&self, side: Side) -> Vec<Cow<'_, [DVec2]>> {
        let mut lines = Vec::new();
        if let Some(Ok(FoundGrid { content: GridContent::Lines([rows, columns]), .. })) = self.grid(side) {
            lines.extend(rows.iter().chain(columns).map(|line| Cow::from(line.as_slice())));
        }
        let other = side.other();
        let grid = self.overlay_state.orthogonal_grids.of(other);
        if let Some((cells, corners)) = grid.cells().filter(|_| grid.is_shown).zip(self.pinned_rectangle(other)) {
            lines.extend(lattice(cells, corners).into_iter().map(Cow::from));
        }
        lines
    }

    /// Gives up the grid that is computed if it is no more wanted; returns whether it did.
    pub fn gives_up_grid(&mut self) -> bool {
        let shown = self.shown_grid_tasks();
        self.overlay_state.orthogonal_grids.give_up(&shown)
    }

    /// What the worker of the grids is to do at the time `now` in seconds.
    pub fn next_grid_work(&mut self, now: f64) -> GridWork {
        let shown = self.shown_grid_tasks();
        self.overlay_state.orthogonal_grids.next(&shown, now)
    }

    /// Takes a finding about a grid; returns the file to save, or why there is none.
    pub fn accept_grid(&mut self, task: &GridTask, finding: Finding) -> Option<Result<ReadyFile, Message>> {
        let shown = self.shown_grid_tasks();
        self.overlay_state.orthogonal_grids.accept(task, finding, &shown)
    }

    fn shown_grid_tasks(&self) -> PerSide<Option<GridTask>> {
        PerSide::from_fn(|side| self.shown_grid_task(side))
    }

    /// What is to be computed for the screen, once the numbers of cells are known.
    fn shown_grid_task(&self, side: Side) -> Option<GridTask> {
        let grid = self.overlay_state.orthogonal_grids.of(side);
        let has_cells = grid.has_cells_for(self.marks(side)?);
        if grid.is_shown && has_cells && !self.is_preparing(side) { self.grid_task(side, None) } else { None }
    }

    fn grid_task(&self, side: Side, file: Option<GridFormat>) -> Option<GridTask> {
        let cells = self.overlay_state.orthogonal_grids.of(side).cells()?;
        let marks = self.marks(side)?;
        Some(GridTask::new((&self.session.domain(side).outline).into(), marks, cells, file))
    }
}

fn onto_rectangle(side: Side, marks: [f64; 4], Number { value, error }: Number) -> Result<Command, Message> {
    let corners = rectangle_corners(value).map_err(|error| Message::from(&error))?;
    if error.is_nan() || error > LEAST_CERTAIN * value {
        let number = |x: f64| Value::number(format!("{x:.3e}"));
        return Err(key::modulus_uncertain(number(value), number(error)));
    }
    let pins = Pins::new(pairs(side, marks, corners).into_iter().take(PINNED));
    let pins = pins.map_err(|error| Message::from(&error))?;
    let polygon = SimplePolygon::try_from(corners.to_vec()).map_err(|error| Message::from(&error))?;
    let outline = OutlineSpec::Points { name: names::RECTANGLE.to_owned(), polygon, form: CurveForm::polygon() };
    Ok(Command::PinOutline { side: side.other(), outline, pins })
}

/// The marks of a side with the corners of the other side's rectangle.
fn pairs(side: Side, marks: [f64; 4], corners: [DVec2; 4]) -> [PerSide<f64>; 4] {
    let fractions = fractions(corners);
    [0, 1, 2, 3].map(|k| {
        let mut pair = PerSide::new(fractions[k], fractions[k]);
        pair[side] = marks[k];
        pair
    })
}

/// The fractions of a quadrilateral's boundary at its corners.
fn fractions(corners: [DVec2; 4]) -> [f64; 4] {
    let sides = [0, 1, 2, 3].map(|k| corners[k].distance(corners[(k + 1) % 4]));
    let perimeter: f64 = sides.iter().sum();
    [0, 1, 2, 3].map(|k| sides[..k].iter().fold(0.0, |sum, side| sum + side) / perimeter)
}

/// The lines inside of a rectangle's lattice that are drawn of a grid.
fn lattice(cells: GridCells, [a, b, c, d]: [DVec2; 4]) -> Vec<Vec<DVec2>> {
    let ([n, m], [along, across]) = (cells.counts(), GridTask::strides(cells));
    let line = |[p, q]: [DVec2; 2], [r, s]: [DVec2; 2], share: f64| vec![p.lerp(q, share), r.lerp(s, share)];
    let shares = |stride: u32, count: u32| {
        (1..count).filter(move |k| k % stride == 0).map(move |k| f64::from(k) / f64::from(count))
    };
    let rows = shares(along, m).map(|share| line([a, d], [b, c], share));
    rows.chain(shares(across, n).map(|share| line([a, b], [d, c], share))).collect()
}

//! The quadrilateral of an outline's four marks: its rectangle as the other side, and its orthogonal grid, on the screen
//! and as a file.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::guarded_by;
use crate::app::input::scrolling::keep_place;
use crate::app::panels::pins_panel::missed;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::number_field::{number_field, spoken};
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::conformal::{GridCells, MOST_CELLS, Side};
use crate::export::GridFormat;
use crate::language::{Message, Value, key, say, tr};
use crate::model::Model;
use crate::model::overlays::orthogonal_grid::GridAction;
use crate::session::Touched;
use crate::worker::{FoundGrid, GridTask};
use egui::{Button, Color32, RichText, Role, Ui, WidgetInfo, vec2};

/// The sides along which cells are counted, by the marks at their ends.
const SIDES: [&str; 2] = ["1→2", "2→3"];
/// The change of a number of cells by a drag over one point of the screen.
const SPEED: f64 = 0.1;

/// Shows the group of an outline that has marks.
pub fn show(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    explained_heading(ui, tr(key::quadrilateral()), key::explain_quadrilateral());
    guarded_by(ui, Touched::ANOTHER_SHAPE, |ui| rectangle(ui, side, model, actions));
    grid(ui, side, model, actions);
}

fn small(ui: &mut Ui, text: &str, ink: Color32) {
    ui.label(RichText::new(text).small().color(ink));
}

/// The button that makes the rectangle the other side; once it is that, how well the fourth corner is met. With the
/// keyboard focus it stays enabled, as it would else lose it.
fn rectangle(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let onto = model.onto_rectangle(side);
    let is_there = model.pinned_rectangle(side).is_some();
    let size = vec2(ui.available_width(), control_height(ui, ROW_HEIGHT));
    let has_focus = ui.memory(|memory| memory.has_focus(ui.next_auto_id()));
    let is_enabled = matches!(onto, Some(Ok(_))) || is_there || has_focus;
    let button = Button::selectable(is_there, tr(key::map_onto_rectangle())).frame_when_inactive(true).min_size(size);
    let button = ui.add_enabled(is_enabled, button).on_hover_text(tr(key::map_onto_rectangle_tooltip()));
    keep_place(ui, &button);
    if button.clicked() && !is_there {
        actions.extend(onto.clone().and_then(Result::ok).map(Action::Session));
    }
    if let Some(Err(reason)) = onto {
        small(ui, &say(&key::sentence(reason)), palette.error_edge);
    } else if is_there {
        small(ui, &say(&key::pinned_to_corners(missed(model.fourth_miss(side)))), palette.weak);
    }
    if model.is_too_long(side) {
        small(ui, tr(key::quadrilateral_limit()), palette.weak);
    }
}

fn grid(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let grids = &model.overlay_state().orthogonal_grids;
    let asked = grids.of(side);
    let mut is_shown = asked.is_shown;
    let shown = ui.checkbox(&mut is_shown, tr(key::orthogonal_grid()));
    if shown.on_hover_text(tr(key::orthogonal_grid_tooltip())).changed() {
        actions.push(Action::Grid(GridAction::Show(side, is_shown)));
    }
    let Some(cells) = asked.cells().filter(|_| asked.is_shown) else { return };
    counts(ui, side, cells, actions);
    let palette = Palette::of(ui.visuals());
    match model.grid(side) {
        Some(Ok(found)) => {
            small(ui, &say(&accuracy(found)), palette.weak);
            for (stride, of) in GridTask::strides(cells).into_iter().zip(SIDES) {
                if stride > 1 {
                    small(ui, &say(&key::lines_drawn(stride, of)), palette.weak);
                }
            }
            save(ui, side, grids.saving(side), actions);
        }
        Some(Err(reason)) => small(ui, &say(&key::sentence(reason.clone())), palette.error_edge),
        None => small(ui, &computing(model.grid_progress(side).unwrap_or_default()), palette.weak),
    }
}

fn computing(done: f64) -> String {
    say(&key::computing_at(format!("{:.0}", 100.0 * done)))
}

/// How right the nodes of a grid and the angles of its lines are.
pub fn accuracy(found: &FoundGrid) -> Message {
    let number = |x: f64| Value::number(format!("{x:.0e}"));
    match found.angle_deviation {
        Some(angle) => key::grid_accuracy(number(found.image_error), number(angle)),
        None => key::grid_error(number(found.image_error)),
    }
}

/// The numbers of cells.
fn counts(ui: &mut Ui, side: Side, cells: GridCells, actions: &mut Actions) {
    let old = cells.counts();
    let mut new = old;
    ui.horizontal(|ui| {
        for (k, name) in [key::cells_along(), key::cells_across_marks()].into_iter().enumerate() {
            if k == 1 {
                ui.label("×");
            }
            let field = number_field(&mut new[k]).range(1..=MOST_CELLS).speed(SPEED).prefix(format!("{}: ", SIDES[k]));
            spoken(ui.add(field).on_hover_text(tr(name)), tr(name), f64::from(old[k]));
        }
    });
    if new != old {
        actions.extend(GridCells::new(new).map(|cells| Action::Grid(GridAction::Cells(side, cells))));
    }
}

/// A button for each format; while a file is made, its progress.
fn save(ui: &mut Ui, side: Side, saving: Option<f64>, actions: &mut Actions) {
    let height = control_height(ui, ROW_HEIGHT);
    ui.horizontal_wrapped(|ui| {
        if let Some(done) = saving {
            ui.label(computing(done));
            if ui.add(Button::new(tr(key::cancel())).min_size(vec2(0.0, height))).clicked() {
                actions.push(Action::Grid(GridAction::Cancel(side)));
            }
            return;
        }
        ui.label(tr(key::save_grid()));
        for format in GridFormat::ALL {
            let name = format.extension().to_uppercase();
            let button = ui.add(Button::new(name.as_str()).min_size(vec2(0.0, height)));
            let spoken = say(&key::save_grid_as(name));
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &spoken));
            if button.on_hover_text(spoken).clicked() {
                actions.push(Action::Grid(GridAction::Save(side, format)));
            }
        }
    });
}

/// The grid of a side that is shown, in a sentence.
pub fn sentence(model: &Model, side: Side) -> Option<String> {
    let accuracy = match model.grid(side)? {
        Ok(found) => accuracy(found),
        Err(reason) => key::sentence(reason.clone()),
    };
    let [n, m] = model.overlay_state().orthogonal_grids.of(side).cells()?.counts();
    let name = crate::app::language::words::side(side);
    Some(say(&key::accessible_grid(name, n, m, accuracy)))
}

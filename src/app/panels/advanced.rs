//! The folded part of the column, whatever names a method: direction, extension, kernel, solver, comparisons,
//! symmetries, interpretation, resolution and invariants. Each term has a "?" that explains it in plain words.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded};
use crate::app::input::preferences::Habit;
use crate::app::language::words;
use crate::app::overlays;
use crate::app::panels::{interpretation, invariants_panel, method, surface_panel, symmetry_panel};
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, captioned_slider, chevron, segmented};
use crate::app::theme::{ROW_HEIGHT, control_height};
use crate::conformal::{Direction, PrepareSettings, Side};
use crate::language::{key, number, say, tr};
use crate::mesh::Sizing;
use crate::model::Model;
use crate::outline::Sampling;
use crate::session::{Command, GROWTH, SAMPLES};
use egui::{Button, Id, Role, Ui, UiBuilder, WidgetInfo, vec2};

const DIRECTIONS: [Segment<Direction>; 2] = [
    Segment { value: Direction::Forward, label: key::forward(), tooltip: key::forward_tooltip() },
    Segment { value: Direction::Backward, label: key::backward(), tooltip: key::backward_tooltip() },
];

/// The free space above the button that unfolds the controls, in points.
const ABOVE: f32 = 12.0;

/// Shows the button, and below it the controls if they are unfolded.
pub fn show(ui: &mut Ui, model: &Model, open: bool, actions: &mut Actions) {
    ui.add_space(ABOVE);
    let size = vec2(ui.available_width(), control_height(ui, ROW_HEIGHT));
    let button = ui.add_sized(size, Button::new(tr(key::advanced())));
    button.widget_info(|| WidgetInfo::selected(Role::Button, true, open, tr(key::advanced())));
    chevron(ui, button.rect, open);
    if button.on_hover_text(tr(key::advanced_tooltip())).clicked() {
        actions.push(Action::Recall(Habit::Advanced(!open)));
    }
    if open {
        controls(ui, model, actions);
    }
}

fn controls(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    for side in Side::BOTH {
        ui.push_id(("discretization", side), |ui| surface_panel::discretization(ui, side, model, actions));
    }
    if model.abilities().chooses_direction() {
        explained_heading(ui, tr(key::map()), key::explain_direction());
        let direction = guarded(ui, Control::Method, |ui| segmented(ui, &DIRECTIONS, model.session().direction()));
        actions.extend(direction.map(|direction| Action::Session(Command::SetDirection(direction))));
    }
    guarded(ui, Control::Method, |ui| method::show(ui, model, actions));
    guarded(ui, Control::Comparison, |ui| {
        overlays::panel::show(ui, model, actions);
        symmetry_panel::show(ui, model, actions);
    });
    for side in Side::BOTH {
        if let Some(settings) = model.outline_settings(side) {
            ui.push_id(side, |ui| {
                guarded(ui, Control::Outline, |ui| interpretation::show(ui, side, model, actions));
                guarded(ui, Control::Method, |ui| resolution(ui, side, settings, model, actions));
            });
        }
    }
    for side in Side::BOTH.into_iter().filter(|side| model.abilities().has_outline(*side)) {
        // controls keep the keyboard focus where the groups above get more or fewer
        ui.scope_builder(UiBuilder::new().scope_id(Id::unique(("invariants", side))), |ui| {
            guarded(ui, Control::Comparison, |ui| invariants_panel::show(ui, side, model, actions));
        });
    }
}

fn resolution(ui: &mut Ui, side: Side, old: PrepareSettings, model: &Model, actions: &mut Actions) {
    let there = model.domain(side).map_or(500, |domain| domain.samples().len());
    explained_heading(ui, &say(&key::resolution_of(words::side(side))), key::explain_resolution());
    let sampling = sampling(ui, old.sampling, there);
    let sizing = sizing(ui, old.sizing);
    let settings = PrepareSettings { sampling, sizing, ..old };
    if settings != old {
        actions.push(Action::Session(Command::SetSettings { side, settings }));
    }
}

fn sampling(ui: &mut Ui, old: Sampling, there: usize) -> Sampling {
    let (uniform, asked) = match old {
        Sampling::Uniform { count, .. } => (true, Some(count)),
        Sampling::Adaptive { target } => (false, target),
    };
    let mut new = old;
    let kinds = [
        Segment { value: false, label: key::adaptive(), tooltip: key::adaptive_tooltip() },
        Segment { value: true, label: key::uniform_paper(), tooltip: key::uniform_paper_tooltip() },
    ];
    let count = asked.unwrap_or(there as u32).clamp(*SAMPLES.start(), *SAMPLES.end());
    if let Some(to_uniform) = segmented(ui, &kinds, uniform) {
        new = if to_uniform {
            Sampling::Uniform { count, keep_corners: true }
        } else {
            Sampling::Adaptive { target: Some(count) }
        };
    }
    let range = f64::from(*SAMPLES.start())..=f64::from(*SAMPLES.end());
    let shown = if asked.is_some() { count.to_string() } else { say(&key::automatic(there)) };
    let moved =
        captioned_slider(ui, tr(key::samples()), &shown, f64::from(count), range, true).map(|m| m.round() as u32);
    match (&mut new, moved) {
        (Sampling::Uniform { count, .. }, Some(m)) => *count = m,
        (Sampling::Adaptive { target }, Some(m)) => *target = Some(m),
        _ => {}
    }
    match &mut new {
        Sampling::Uniform { keep_corners, .. } => {
            ui.checkbox(keep_corners, tr(key::keep_corners())).on_hover_text(tr(key::keep_corners_tooltip()));
        }
        Sampling::Adaptive { target } => {
            let mut automatic = target.is_none();
            let label = ui.checkbox(&mut automatic, tr(key::as_many_as_needed()));
            if label.on_hover_text(tr(key::adaptive_samples_tooltip())).changed() {
                *target = (!automatic).then_some(count);
            }
        }
    }
    new
}

fn sizing(ui: &mut Ui, old: Sizing) -> Sizing {
    let grade = match old {
        Sizing::Graded(grade) => Some(grade),
        Sizing::Uniform => None,
    };
    let kinds = [
        Segment { value: true, label: key::graded(), tooltip: key::graded_tooltip() },
        Segment { value: false, label: key::uniform_mesh(), tooltip: key::uniform_mesh_tooltip() },
    ];
    let mut new = old;
    if let Some(graded) = segmented(ui, &kinds, grade.is_some()) {
        new = if graded { Sizing::default() } else { Sizing::Uniform };
    }
    if let Sizing::Graded(grade) = new {
        let shown = say(&key::per_distance(number(grade, 2)));
        if let Some(moved) = captioned_slider(ui, tr(key::growth()), &shown, grade, GROWTH, false) {
            new = Sizing::Graded((100.0 * moved).round() / 100.0);
        }
    }
    new
}

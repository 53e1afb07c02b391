//! The best map: its criterion, the region that is painted, the search with its course, and the landscape.

mod course;

use crate::app::input::action::{Action, Actions};
use crate::app::input::scrolling::has_changed;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, captioned_slider, segmented};
use crate::conformal::Side;
use crate::language::{Label, Message, key, number, say, significant, tr};
use crate::model::Model;
use crate::model::best::{Aim, BRUSHES, BestAction, BestMap, Outcome};
use crate::session::Command;
use egui::{Button, CornerRadius, ProgressBar, RichText, Ui};

const AIMS: [Segment<Aim>; 4] = [
    Segment { value: Aim::Area, label: key::aim_area(), tooltip: key::aim_area_tooltip() },
    Segment { value: Aim::Scale, label: key::aim_scale(), tooltip: key::aim_scale_tooltip() },
    Segment { value: Aim::Region, label: key::aim_region(), tooltip: key::aim_region_tooltip() },
    Segment { value: Aim::Symmetry, label: key::aim_symmetry(), tooltip: key::aim_symmetry_tooltip() },
];

/// Shows the group; nothing before the first map.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    if model.map().is_none() {
        return;
    }
    let best = model.best();
    explained_heading(ui, tr(key::best_map()), key::explain_best_map());
    let mut push = |action| actions.push(Action::Best(action));
    if let Some(aim) = segmented(ui, &AIMS, best.aim()) {
        push(BestAction::Aim(aim));
    }
    landscape(ui, model, &mut push);
    if best.aim() == Aim::Region {
        region(ui, model, actions);
    }
    search(ui, model, actions);
}

/// Search under way, result and error.
fn search(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let best = model.best();
    let has_answer = best.outcome().is_some() || best.error().is_some();
    let is_new = has_changed(ui, egui::Id::unique("answer of the search"), &has_answer) && has_answer;
    if let Some((done, course)) = best.progress() {
        ui.horizontal(|ui| {
            if ui.button(tr(key::cancel())).on_hover_text(tr(key::cancel_best_tooltip())).clicked() {
                actions.push(Action::Best(BestAction::Cancel));
            }
            ui.add(ProgressBar::new(done as f32).desired_height(8.0).corner_radius(CornerRadius::same(4)));
        });
        course::show(ui, course);
        return;
    }
    let button = ui.add_enabled(model.can_search() && !best.is_moving(), Button::new(tr(key::find_best())));
    let button = button.on_hover_text(tr(key::find_best_tooltip())).on_disabled_hover_text(tr(why_not(best)));
    if button.clicked() {
        actions.push(Action::Best(BestAction::Start));
    }
    let answer = ui.scope(|ui| {
        if let Some(outcome) = best.outcome() {
            ui.label(say(&said(outcome)));
            course::show(ui, &outcome.course);
        }
        if let Some(error) = best.error() {
            ui.label(RichText::new(say(error)).color(ui.visuals().error_fg_color));
        }
    });
    if is_new {
        answer.response.scroll_to_me(None);
    }
}

fn why_not(best: &BestMap) -> Label {
    match best.aim() {
        Aim::Region => key::region_is_empty(),
        Aim::Symmetry => key::symmetry_of_outlines(),
        Aim::Area | Aim::Scale => key::being_prepared(),
    }
}

/// What a criterion measures.
pub fn criterion(aim: Aim) -> Label {
    match aim {
        Aim::Area => key::value_area(),
        Aim::Scale => key::value_scale(),
        Aim::Region => key::value_region(),
        Aim::Symmetry => key::value_symmetry(),
    }
}

/// A result in words.
pub fn said(outcome: &Outcome) -> Message {
    let [before, after] = [outcome.before, outcome.after].map(|value| significant(value, 5));
    match outcome.aim {
        _ if outcome.after >= outcome.before => key::best_already(after, outcome.evaluations),
        Aim::Area => key::best_area(before, after, outcome.evaluations),
        Aim::Scale => key::best_scale(before, after, outcome.evaluations),
        Aim::Symmetry => key::best_symmetry(before, after, outcome.evaluations),
        Aim::Region => key::best_region(before, after, outcome.evaluations),
    }
}

fn landscape(ui: &mut Ui, model: &Model, push: &mut dyn FnMut(BestAction)) {
    let is_planar = model.abilities().has_outline(Side::Source);
    let mut shown = is_planar && model.best().asks_for_landscape();
    let box_ = ui.add_enabled(is_planar, egui::Checkbox::new(&mut shown, tr(key::landscape())));
    let box_ = box_.on_hover_text(tr(key::landscape_tooltip())).on_disabled_hover_text(tr(key::landscape_of_surface()));
    if box_.changed() {
        push(BestAction::Landscape(shown));
    }
    if shown && model.best().landscape().is_none() {
        let lacks_region = model.best().aim() == Aim::Region && model.session().region().is_empty();
        let awaited = match model.best().landscape_error() {
            _ if lacks_region => tr(key::region_is_empty()).to_owned(),
            Some(error) => say(&key::sentence(error)),
            None => tr(key::computing()).to_owned(),
        };
        ui.label(RichText::new(awaited).small().color(Palette::of(ui.visuals()).weak));
    }
}

/// The brush, its size, and a button that clears the region.
fn region(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let best = model.best();
    let mut paints = best.is_painting();
    if ui.checkbox(&mut paints, tr(key::brush())).on_hover_text(tr(key::brush_tooltip())).changed() {
        actions.push(Action::Best(BestAction::Paint(paints)));
    }
    let shown = format!("{} %", number(100.0 * best.brush(), 0));
    if let Some(radius) = captioned_slider(ui, tr(key::brush_size()), &shown, best.brush(), BRUSHES, true) {
        actions.push(Action::Best(BestAction::Brush(radius)));
    }
    // what the keyboard can do instead
    let here = model.source_point_in_space().and_then(|at| model.region_with([at]));
    let dab = ui.add_enabled(here.is_some(), Button::new(tr(key::paint_here())));
    let dab = dab.on_hover_text(tr(key::paint_here_tooltip())).on_disabled_hover_text(tr(key::painted_here()));
    if dab.clicked() {
        actions.extend(here.map(|region| Action::Session(Command::SetRegion(region))));
    }
    let has_region = !model.session().region().is_empty();
    let clear = ui.add_enabled(has_region, Button::new(tr(key::clear_region())));
    if clear.on_hover_text(tr(key::clear_region_tooltip())).clicked() {
        actions.push(Action::Session(Command::SetRegion(Vec::new())));
    }
}

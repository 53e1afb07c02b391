//! The layout of the window of map projections.

use super::{ProjectionWindow, Work, picture};
use crate::app::input::action::{Action, Actions, ProjectionAction};
use crate::app::theme::explained::explained_heading;
use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::widgets::{close_button, drop_down};
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::app::windows::exporting::progress::progress_bar;
use crate::export::ProjectionFormat;
use crate::language::{Value, key, number, say, tr};
use crate::worker::{Feature, FoundProjection};
use egui::{
    Align2, Button, Context, Grid, Key, Modifiers, PopupCloseBehavior, RichText, Role, ScrollArea, Ui, WidgetInfo,
    Window, vec2,
};

/// The size of the window where there is room, and what the screen keeps around it, in points.
const SIZE: egui::Vec2 = vec2(760.0, 720.0);
const AROUND: egui::Vec2 = vec2(30.0, 96.0);
/// The share of the window's height that the map takes at most, and its height at least, in points.
const OF_MAP: f32 = 0.62;
const LEAST_MAP: f32 = 160.0;
/// In a window this many times as wide as high, as on a phone on its side, the map has this share of the width and its
/// numbers stand beside it.
const WIDE: f32 = 1.8;
const BESIDE: f32 = 0.55;
/// The height that the list of features leaves free, in points.
const AROUND_LIST: f32 = 260.0;
/// The width of the button that cancels.
const CANCEL: f32 = 100.0;

impl ProjectionWindow {
    /// Draws the window if it is open.
    pub fn show(&self, context: &Context, actions: &mut Actions) {
        if !self.is_open {
            return;
        }
        let size = SIZE.min(context.content_rect().size() - AROUND);
        let mut stays = !context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        Window::new(tr(key::projection()))
            .id(egui::Id::unique("map projection"))
            .open(&mut stays)
            .collapsible(false)
            .resizable(false)
            .pivot(Align2::CENTER_CENTER)
            .fixed_pos(context.content_rect().center())
            .show(context, |ui| {
                ui.set_width(size.x);
                self.content(ui, size.y, actions);
            });
        if !stays {
            actions.push(Action::Projection(ProjectionAction::Close));
        }
    }

    fn content(&self, ui: &mut Ui, height: f32, actions: &mut Actions) {
        explained_heading(ui, &self.name(), key::explain_projection());
        let rows = control_height(ui, ROW_HEIGHT) + ui.spacing().item_spacing.y;
        let height = height - 2.0 * rows;
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| match &self.work {
            Work::None => _ = ui.label(tr(key::projection_begin())),
            Work::Running(done) => self.running(ui, *done, actions),
            Work::Made(found) => made(ui, found, height),
            Work::Failed(refused) => self.refused(ui, refused.repairable, actions),
        });
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| self.buttons(ui, actions));
    }

    fn refused(&self, ui: &mut Ui, repairable: bool, actions: &mut Actions) {
        let ink = Palette::of(ui.visuals()).error_edge;
        if let Some(reason) = self.error() {
            ui.label(RichText::new(say(&reason)).color(ink));
        }
        let height = control_height(ui, ROW_HEIGHT);
        let repair = || Button::new(tr(key::repair())).min_size(vec2(0.0, height));
        if repairable && ui.add(repair()).on_hover_text(tr(key::repair_region_tooltip())).clicked() {
            actions.push(Action::Projection(ProjectionAction::Repair));
        }
    }

    /// The menu of the file's features, by name.
    fn features_button(&self, ui: &mut Ui, actions: &mut Actions) {
        let (features, shown) = self.features();
        if features.is_empty() {
            return;
        }
        let name = |feature: &Feature| feature.name.clone().unwrap_or_else(|| say(&key::part_number(feature.number)));
        drop_down(ui, tr(key::feature()), PopupCloseBehavior::CloseOnClick, |ui| {
            scroll_beyond(ui, AROUND_LIST, |ui| {
                let all = (None, tr(key::all_features()).to_owned());
                let each = features.iter().map(|feature| (Some(feature.number), name(feature)));
                for (number, name) in std::iter::once(all).chain(each) {
                    if ui.selectable_label(number == shown, name).clicked() {
                        actions.push(Action::Projection(ProjectionAction::Feature(number)));
                        ui.close();
                    }
                }
            });
        });
    }

    fn running(&self, ui: &mut Ui, done: f64, actions: &mut Actions) {
        ui.label(say(&key::projecting(self.name().into_owned())));
        let height = control_height(ui, ROW_HEIGHT);
        ui.horizontal(|ui| {
            let size = vec2(ui.available_width() - CANCEL - 10.0, height);
            progress_bar(ui, size, done as f32, format!("{:.0}\u{a0}%", 100.0 * done));
            if ui.add_sized([CANCEL, height], Button::new(tr(key::cancel()))).clicked() {
                actions.push(Action::Projection(ProjectionAction::Cancel));
            }
        });
    }

    fn buttons(&self, ui: &mut Ui, actions: &mut Actions) {
        let height = control_height(ui, ROW_HEIGHT);
        let button = |text: &str| Button::new(text).min_size(vec2(0.0, height));
        for (label, tooltip, action) in [
            (key::open_region(), key::open_region_tooltip(), ProjectionAction::OpenFile),
            (key::show_island(), key::show_island_tooltip(), ProjectionAction::Island),
        ] {
            if ui.add(button(tr(label))).on_hover_text(tr(tooltip)).clicked() {
                actions.push(Action::Projection(action));
            }
        }
        self.features_button(ui, actions);
        for format in ProjectionFormat::ALL.into_iter().filter(|_| self.found().is_some()) {
            let name = format.extension().to_uppercase();
            let save = ui.add(button(&format!("{} {name}", tr(key::save_projection()))));
            let words = say(&key::save_projection_as(name));
            save.widget_info(|| WidgetInfo::labeled(Role::Button, true, &words));
            if save.on_hover_text(words).clicked() {
                actions.push(Action::Projection(ProjectionAction::Save(format)));
            }
        }
        if close_button(ui).clicked() {
            actions.push(Action::Projection(ProjectionAction::Close));
        }
    }
}

/// The map with its numbers and notes, below it or beside it.
fn made(ui: &mut Ui, found: &FoundProjection, height: f32) {
    let width = ui.available_width();
    if width < WIDE * height {
        picture::show(ui, found, (OF_MAP * height).max(LEAST_MAP));
        return notes(ui, found);
    }
    ui.horizontal_top(|ui| {
        ui.vertical(|ui| {
            ui.set_width(BESIDE * width);
            picture::show(ui, found, height - ui.spacing().item_spacing.y);
        });
        ui.vertical(|ui| notes(ui, found));
    });
}

fn notes(ui: &mut Ui, found: &FoundProjection) {
    Grid::new("projection").num_columns(2).spacing([12.0, 2.0]).show(ui, |ui| {
        for (label, text) in numbers(found) {
            ui.label(RichText::new(label).small());
            ui.label(RichText::new(text).small());
            ui.end_row();
        }
    });
    let weak = Palette::of(ui.visuals()).weak;
    let steps = found.steps.to_array().map(|step| Value::number(step.to_string()));
    let [longitude, latitude] = steps;
    let words = [tr(key::scale_lines_legend()).to_owned(), say(&key::graticule_steps(longitude, latitude))];
    ui.label(RichText::new(words.join(" ")).small().color(weak));
    for note in found.notes() {
        ui.label(RichText::new(say(&note)).small());
    }
}

fn numbers(found: &FoundProjection) -> [(&'static str, String); 3] {
    let report = &found.report;
    let [longitude, latitude] = report.least_scale_at.map(|degrees| number(degrees, 3).replace('-', "−"));
    let error = Value::number(format!("{:.0e}", report.scale_ratio_error));
    [
        (tr(key::scale_ratio()), say(&key::ratio_at_most(number(report.scale_ratio, 6), error))),
        (tr(key::stereographic_ratio()), number(report.stereographic_scale_ratio, 6)),
        (tr(key::least_scale()), say(&key::place_in_degrees(longitude, latitude))),
    ]
}

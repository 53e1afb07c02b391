//! The welcome of the first visit: one sentence that says what this is, and three ways to begin.
//!
//! It has a row of its own below the top bar, never over a picture, until it is used or closed.

use crate::app::input::action::{Action, Actions, EditAction, ExploreAction};
use crate::app::input::locks::menu_entry;
use crate::app::input::preferences::Habit;
use crate::app::theme::text_metrics::{button_width, text_width};
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{Label as Words, key, tr};
use crate::model::editing::Pen;
use egui::{Align, Button, Frame, Layout, Margin, Panel, RichText, Role, TextStyle, Ui, WidgetInfo, vec2};

/// The ways to begin: label, tooltip, action.
fn ways() -> [(Words, Words, Action); 3] {
    let draw = EditAction::Draw(Side::Source, Pen::Freehand);
    [
        (key::take_tour(), key::guided_tour_tooltip(), Action::Explore(ExploreAction::Tour(0))),
        (key::draw_own(), key::draw_freehand_tooltip(), Action::Edit(draw)),
        (key::open_own(), key::open_shape_tooltip(), Action::OpenOutline(Side::Source)),
    ]
}

/// The width of the button that closes the welcome, and of the gap beside it, for a mouse.
const CROSS: f32 = 38.0;
/// The free space between the sentence and the buttons in one row, in points.
const BETWEEN: f32 = 24.0;

/// Shows the row; where the sentence and the buttons do not fit side by side, the buttons are below.
pub fn show(ui: &mut Ui, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.raised).inner_margin(Margin::symmetric(14, 8));
    Panel::top("welcome").resizable(false).frame(frame).show(ui, |ui| {
        let sentence = text_width(ui, tr(key::welcome()), TextStyle::Body.resolve(ui.style()));
        let buttons: f32 = ways().iter().map(|(label, ..)| button_width(ui, tr(*label))).sum();
        if sentence + BETWEEN + buttons + CROSS <= ui.available_width() {
            ui.horizontal(|ui| {
                ui.label(RichText::new(tr(key::welcome())).color(palette.text));
                ui.add_space(BETWEEN - ui.spacing().item_spacing.x);
                begin(ui, actions);
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| cross(ui, actions));
            });
            return;
        }
        ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
            cross(ui, actions);
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.label(RichText::new(tr(key::welcome())).color(palette.text));
                ui.horizontal_wrapped(|ui| begin(ui, actions));
            });
        });
    });
}

fn begin(ui: &mut Ui, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let height = control_height(ui, ROW_HEIGHT);
    for (k, (label, tooltip, action)) in ways().into_iter().enumerate() {
        let button = if k == 0 {
            Button::new(RichText::new(tr(label)).color(palette.on_accent)).fill(palette.accent)
        } else {
            Button::new(tr(label)).frame_when_inactive(true)
        };
        if menu_entry(ui, true, button.min_size(vec2(0.0, height)), tooltip, &action) {
            actions.extend([action, Action::Recall(Habit::Welcomed)]);
        }
    }
}

fn cross(ui: &mut Ui, actions: &mut Actions) {
    let side = control_height(ui, ROW_HEIGHT);
    let button = ui.add(Button::new("×").frame(false).min_size(vec2(side, side)));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr(key::close_welcome())));
    if button.on_hover_text(tr(key::close_welcome())).clicked() {
        actions.push(Action::Recall(Habit::Welcomed));
    }
}

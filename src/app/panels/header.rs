//! The overlay of a viewport at its upper edge: title, notes, buttons and messages.

use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::input::locks::{Control, Locks, REFUSAL, guarded};
use crate::app::language::words;
use crate::app::panels::{shapes, sketch};
use crate::app::theme::explained::explain;
use crate::app::theme::text_metrics::{button_width, text_width};
use crate::app::theme::widgets::{MessageAnswer, drop_down_width, message_box};
use crate::app::theme::{self, Palette, widgets};
use crate::conformal::Side;
use crate::language::{Label as Words, Message, key, say, tr};
use crate::model::Model;
use crate::model::side::user_error::{QuickFix, UserError};
use crate::session::Command;
use egui::text::LayoutJob;
use egui::{
    Align, CornerRadius, Galley, Id, Label, Layout, Rect, RichText, ScrollArea, Sense, Shape, Ui, UiBuilder,
    WidgetInfo, vec2,
};
use std::sync::Arc;

/// The tooltip of the button that hides and shows the panels.
pub const PANELS_TOOLTIP: Words = key::panels_tooltip();
/// The facts about the screen that decide which buttons are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Surroundings {
    /// Whether the buttons that open another outline fit beside the title; the top bar has them too.
    pub has_room: bool,
    /// The side whose outline is being edited.
    pub edited: Option<Side>,
    /// Whether the panels are hidden: then a button brings them back, for devices without a Tab key.
    pub folded: bool,
    /// Whether the app is embedded in another page that shows only the pictures.
    pub embedded: bool,
}

/// Whether all buttons fit beside the title of a viewport of this width; the same for both sides.
pub fn has_room(ui: &Ui, width: f32) -> bool {
    let buttons: f32 = [key::fit(), key::edit(), key::swap()].map(|label| button_width(ui, tr(label))).iter().sum();
    width >= TITLE_WIDTH + buttons + drop_down_width(ui, tr(key::shapes()))
}

/// The height of the row of title and buttons, and of the title in its middle, in points; notes are below.
const TITLE_HEIGHT: f32 = 28.0;
const TITLE_LINE: f32 = 18.0;
/// The most lines of a note.
const NOTE_LINES: usize = 3;
/// Free space above and below the notes together, in points.
const AROUND_NOTES: f32 = 12.0;

/// The least width of the title beside all buttons, and the limits of that beside the buttons of a narrow picture: the
/// names of all presets are shown whole.
const TITLE_WIDTH: f32 = 190.0;
const LEAST_TITLE: f32 = 90.0;
const MOST_TITLE: f32 = 130.0;
/// The button "Swap" in a narrow picture.
const SWAP_SYMBOL: &str = "↔";
/// Between the title and the buttons.
const BESIDE_TITLE: f32 = 6.0;

/// From a viewport's edges to its title, buttons and messages.
const INSET: [f32; 2] = [14.0, 10.0];

/// Shows the title line and the buttons of a viewport; returns the y of their lower edge.
pub fn show(
    ui: &mut Ui,
    side: Side,
    model: &Model,
    rect: Rect,
    is_fitted: bool,
    around: Surroundings,
    actions: &mut Actions,
) -> f32 {
    let area = rect.shrink2(INSET.into());
    let shown = ui.scope_builder(UiBuilder::new().max_rect(area), |ui| {
        let line = vec2(ui.available_width(), theme::control_height(ui, TITLE_HEIGHT));
        ui.allocate_ui_with_layout(line, Layout::right_to_left(Align::Center), |ui| {
            if !around.embedded {
                widgets::opaque(ui, |ui| buttons(ui, side, model, is_fitted, around, actions));
                ui.add_space(BESIDE_TITLE);
            }
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ui.add_space(0.5 * (line.y - TITLE_LINE));
                over_the_mesh(ui, |ui| title(ui, side, model));
            });
        });
        show_notes(ui, side, model);
    });
    shown.response.rect.bottom()
}

fn title(ui: &mut Ui, side: Side, model: &Model) {
    let palette = Palette::of(ui.visuals());
    let shape = model.shape(side);
    let whole = words::title(side, shape);
    let fits = text_width(ui, &whole, theme::bold(14.0)) <= ui.available_width();
    let name = if both_fit(ui, side, fits) { whole } else { words::shape(shape).into_owned() };
    let title = ui.add(Label::new(RichText::new(name).font(theme::bold(14.0)).color(palette.text)).truncate());
    let Some(prepared) = model.prepared(side) else { return };
    title.on_hover_text(format!("{}\n\n{}", words::sizes([&**prepared]), words::details(prepared)));
}

/// Whether the whole titles of both sides fit, so that they are worded alike; `fits` is that of this side, the other one's
/// is of the last time that it was shown.
fn both_fit(ui: &Ui, side: Side, fits: bool) -> bool {
    let id = |side: Side| Id::unique(("whole title fits", side));
    let [before, other]: [Option<bool>; 2] = [side, side.other()].map(|side| ui.data(|data| data.get_temp(id(side))));
    if before != Some(fits) {
        ui.data_mut(|data| data.insert_temp(id(side), fits));
        ui.request_repaint();
    }
    fits && other != Some(false)
}

/// The notes below the title and the buttons, over the whole width of the picture.
fn show_notes(ui: &mut Ui, side: Side, model: &Model) {
    let notes: Vec<String> = notes(side, model).map(|note| say(&note)).collect();
    if notes.is_empty() {
        return;
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    over_the_mesh(ui, |ui| {
        for note in notes {
            let galley = note_galley(ui, &note, ui.available_width());
            explain(&ui.add(Label::new(galley).sense(Sense::click())), &note);
        }
    });
}

/// The first lines of a note; all of it is in its popup.
fn note_galley(ui: &Ui, note: &str, width: f32) -> Arc<Galley> {
    let ink = Palette::of(ui.visuals()).weak;
    let mut job = LayoutJob::simple(note.to_owned(), widgets::caption_font(ui), ink, width);
    job.wrap.max_rows = NOTE_LINES;
    ui.painter().layout_job(job)
}

/// The notes below a side's title, a line each.
fn notes(side: Side, model: &Model) -> impl Iterator<Item = Message> {
    let cautions =
        model.prepared(side).into_iter().flat_map(move |prepared| words::cautions(prepared, model.shape(side)));
    model.notes_on_shape(side).into_iter().chain(cautions.map(Message::from))
}

/// The height of title, buttons and notes from the upper edge of a picture on; 0 without notes, as the margins of pictures
/// have room for the others.
pub fn height_with_notes(ui: &Ui, side: Side, model: &Model, picture: Rect) -> f32 {
    let width = picture.width() - 2.0 * INSET[0];
    let notes: f32 = notes(side, model).map(|note| note_galley(ui, &say(&note), width).size().y).sum();
    let above = INSET[1] + theme::control_height(ui, TITLE_HEIGHT) + AROUND_NOTES;
    if notes > 0.0 { above + notes } else { 0.0 }
}

fn buttons(ui: &mut Ui, side: Side, model: &Model, is_fitted: bool, around: Surroundings, actions: &mut Actions) {
    ui.spacing_mut().button_padding = vec2(9.0, 4.0);
    ui.spacing_mut().interact_size.y = theme::control_height(ui, 26.0);
    let panels = (around.folded && side == Side::Target)
        .then(|| guarded(ui, Control::Panels, |ui| ui.button(tr(key::panels())).on_hover_text(tr(PANELS_TOOLTIP))));
    if panels.is_some_and(|button| button.clicked()) {
        actions.push(Action::TogglePanels);
    }
    let name = text_width(ui, &words::shape(model.shape(side)), theme::bold(14.0)) + BESIDE_TITLE;
    let whole = ui.available_width();
    let all_fit = narrow_row(ui, side) + name.clamp(LEAST_TITLE, MOST_TITLE) <= whole;
    if all_fit {
        fit_button(ui, side, is_fitted, actions);
    }
    guarded(ui, Control::Outline, |ui| outline_buttons(ui, side, model, around, actions));
    if !all_fit && !is_fitted {
        // in the place of the swap button, so that the other buttons do not move under the finger
        fit_button(ui, side, is_fitted, actions);
    } else if side == Side::Target {
        // the symbol where the word leaves the name no room
        let row = narrow_row(ui, side) - button_width(ui, tr(key::fit()));
        let label = if row + name <= whole { tr(key::swap()) } else { SWAP_SYMBOL };
        swap_button(ui, model, label, actions);
    }
}

fn fit_button(ui: &mut Ui, side: Side, is_fitted: bool, actions: &mut Actions) {
    guarded(ui, Control::View, |ui| {
        let width = theme::control_height(ui, 0.0); // a button with a short label must not be narrower than a finger
        let fit = ui.add_enabled(!is_fitted, egui::Button::new(tr(key::fit())).min_size(vec2(width, 0.0)));
        if fit.on_hover_text(tr(key::fit_tooltip())).clicked() {
            actions.push(Action::Fit(side));
        }
    });
}

/// The width of the buttons that are always shown, as in a narrow picture.
fn narrow_row(ui: &Ui, side: Side) -> f32 {
    let labels: &[Words] =
        if side == Side::Target { &[key::fit(), key::edit(), key::swap()] } else { &[key::fit(), key::edit()] };
    let least = theme::control_height(ui, 0.0) + ui.spacing().item_spacing.x;
    labels.iter().map(|label| button_width(ui, tr(*label)).max(least)).sum()
}

fn swap_button(ui: &mut Ui, model: &Model, label: &str, actions: &mut Actions) {
    let swap = Action::Session(Command::Swap);
    let is_locked = Locks::of(ui.ctx()).refused(&swap).is_some();
    let refusal = if is_locked { REFUSAL } else { key::swap_waits() };
    let width = theme::control_height(ui, 0.0); // as wide as a finger, also with the symbol
    let button = egui::Button::new(label).min_size(vec2(width, 0.0));
    let button = ui.add_enabled(!is_locked && model.is_mapped(), button);
    button.widget_info(|| WidgetInfo::labeled(egui::Role::Button, button.enabled(), tr(key::swap())));
    if button.on_hover_text(tr(key::swap_tooltip())).on_disabled_hover_text(tr(refusal)).clicked() {
        actions.push(swap);
    }
}

fn outline_buttons(ui: &mut Ui, side: Side, model: &Model, around: Surroundings, actions: &mut Actions) {
    if model.reshapable(side).is_some() {
        let edited = around.edited == Some(side);
        let edit = ui.add(egui::Button::selectable(edited, tr(key::edit())).frame_when_inactive(true));
        if edit.on_hover_text(tr(key::edit_tooltip())).clicked() {
            actions.push(Action::Edit(EditAction::Toggle(side)));
        }
    }
    if around.has_room {
        shapes::menu_button(ui, tr(key::shapes()), side, model, actions);
    }
}

/// Free space above a message.
const BETWEEN_MESSAGES: f32 = 4.0;

/// Shows the errors of a side; they scroll if they are higher than `room`.
pub fn messages(ui: &mut Ui, side: Side, model: &Model, room: Rect, actions: &mut Actions) {
    let user_errors = model.user_errors(side);
    let user_errors =
        user_errors.map(|UserError { text, quick_fix, sketch }| (text, quick_fix.as_ref(), sketch.as_deref()));
    let of_map = model.map_error().filter(|(at, _)| *at == side).map(|(_, text)| (text, None, None));
    let all: Vec<_> = user_errors.chain(of_map).collect();
    if all.is_empty() {
        return;
    }
    let area = room.shrink2(vec2(INSET[0], 0.0));
    ui.scope_builder(UiBuilder::new().max_rect(area).id_salt(("messages", side)), |ui| {
        let between = BETWEEN_MESSAGES + ui.spacing().item_spacing.y;
        let most = area.height() / all.len() as f32 - between;
        ScrollArea::vertical().max_height(area.height()).show(ui, |ui| {
            for (text, quick_fix, refused) in all {
                ui.add_space(BETWEEN_MESSAGES);
                let top = ui.cursor().top();
                match message_box(ui, text, quick_fix.map(QuickFix::label), most) {
                    Some(MessageAnswer::Dismiss) => actions.push(Action::Dismiss(side)),
                    Some(MessageAnswer::QuickFix) => actions.push(Action::QuickFix(side)),
                    None => {}
                }
                if let Some(refused) = refused {
                    sketch::show(ui, refused, most - (ui.cursor().top() - top) - BETWEEN_MESSAGES);
                }
            }
        });
    });
}

/// Shows content on a translucent background, so that it stays readable over a mesh.
pub fn over_the_mesh(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    let ground = ui.painter().add(Shape::Noop);
    let rect = ui.scope(content).response.rect;
    let colour = Palette::of(ui.visuals()).canvas.gamma_multiply(0.82);
    ui.painter().set(ground, Shape::rect_filled(rect.expand2(vec2(6.0, 3.0)), CornerRadius::same(6), colour));
}

//! The panel of a lesson: beside the pictures, on a narrow screen in the place of the sheet below them.
//!
//! Undo and redo are beside the heading. A step has its caption and the buttons that show, renew, move and delete it;
//! below are the buttons of the whole lesson. What cannot be done now is gray, and says why. All requests are actions.

use super::LessonEditor;
use crate::app::input::action::{Action, Actions, LessonAction};
use crate::app::input::locks::{Locks, REFUSAL};
use crate::app::theme::icons::{ICON_WIDTH, Icon, icon_button};
use crate::app::theme::text_metrics::button_width;
use crate::app::theme::{Palette, ROUNDING, ROW_HEIGHT, bold, control_height};
use crate::app::windows::explore::tour::card::is_low;
use crate::language::{Label as Words, key, say, tr};
use crate::session::lesson::{MAX_CAPTION, MAX_TITLE, Step};
use egui::{
    Align, Button, CornerRadius, Frame, Label, Layout, Margin, Panel, RichText, Role, ScrollArea, Stroke, TextEdit, Ui,
    WidgetInfo, vec2,
};

/// The width of the panel, as a share of the screen, and its limits, in points.
const WIDTH_SHARE: f32 = 0.24;
const WIDTHS: [f32; 2] = [264.0, 340.0];
/// The share of the screen's height that a narrow screen leaves to the pictures.
const PICTURES_SHARE: f32 = 0.5;
/// The width of the scroll bar beside the steps.
const SCROLL_BAR: f32 = 8.0;
/// The room for a step's number, the gaps around it and those between the buttons beside it.
const NUMBER: f32 = 32.0;
/// The lines of a caption that are shown while it has no more.
const CAPTION_ROWS: usize = 3;

/// Shows the panel. `held` is why no picture can be taken, shown or played now.
pub fn show(ui: &mut Ui, editor: &LessonEditor, held: Option<Words>, narrow: bool, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let screen = ui.ctx().content_rect();
    let panel = if narrow {
        Panel::bottom("lesson").exact_size(ui.available_height() - PICTURES_SHARE * screen.height())
    } else {
        Panel::right("lesson").exact_size((WIDTH_SHARE * screen.width()).clamp(WIDTHS[0], WIDTHS[1]))
    };
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin { left: 14, right: 8, top: 6, bottom: 8 });
    panel.resizable(false).frame(frame).show(ui, |ui| {
        let mut asked = Vec::new();
        heading(ui, editor, &mut asked);
        let foot = Frame::new().inner_margin(Margin { top: 6, right: 6, ..Margin::ZERO });
        Panel::bottom("lesson-buttons").resizable(false).show_separator_line(false).frame(foot).show(ui, |ui| {
            buttons(ui, editor, held, &mut asked);
        });
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - SCROLL_BAR);
            draft(ui, editor, held, &mut asked);
        });
        actions.extend(asked.into_iter().map(Action::Lesson));
    });
}

/// The name, undo, redo and the cross; below, where there is room for it, the last change.
fn heading(ui: &mut Ui, editor: &LessonEditor, asked: &mut Vec<LessonAction>) {
    let Palette { text, weak, .. } = Palette::of(ui.visuals());
    ui.horizontal(|ui| {
        ui.label(RichText::new(tr(key::lesson())).font(bold(15.0)).color(text));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            if cross(ui, tr(key::close_lesson())) {
                asked.push(LessonAction::Close);
            }
            history(ui, editor, asked);
        });
    });
    let shown = editor.draft.last().or(editor.draft.next()).filter(|_| !is_low(ui));
    if let Some(shown) = shown {
        ui.add(Label::new(RichText::new(say(&shown.words())).color(weak)).wrap());
    }
}

/// Redo and undo of the draft, from the right.
fn history(ui: &mut Ui, editor: &LessonEditor, asked: &mut Vec<LessonAction>) {
    for (change, icon, name, action) in [
        (editor.draft.next(), Icon::Redo, key::redo_in_lesson(), LessonAction::Redo),
        (editor.draft.last(), Icon::Undo, key::undo_in_lesson(), LessonAction::Undo),
    ] {
        let about = change.map_or_else(String::new, |change| format!(": {}", say(&change.words())));
        let about = format!("{}{about}", tr(name));
        if icon_button(ui, icon, change.is_some(), tr(name), &about).clicked() {
            asked.push(action);
        }
    }
}

/// A button with a cross; its name is its tooltip. Returns whether it was clicked.
fn cross(ui: &mut Ui, name: &str) -> bool {
    let side = control_height(ui, ROW_HEIGHT);
    let button = ui.add(Button::new("×").min_size(vec2(side, side)));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    button.on_hover_text(name).clicked()
}

/// Title and steps, or without a step what to do.
fn draft(ui: &mut Ui, editor: &LessonEditor, held: Option<Words>, asked: &mut Vec<LessonAction>) {
    let mut title = editor.draft().title.clone();
    // a field's own undo is not to bring back the text of another step or lesson
    let arrangement = editor.draft.arrangement;
    let field = TextEdit::singleline(&mut title)
        .id_salt(("title", arrangement))
        .char_limit(MAX_TITLE)
        .hint_text(tr(key::lesson_title()));
    let response = edged(ui, |ui| ui.add(field.desired_width(f32::INFINITY)));
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, tr(key::lesson_title())));
    if response.changed() {
        asked.push(LessonAction::Title(title));
    }
    if editor.draft().steps.is_empty() {
        let weak = Palette::of(ui.visuals()).weak;
        ui.add_space(4.0);
        ui.add(Label::new(RichText::new(tr(key::lesson_about())).color(weak)).wrap());
    }
    let count = editor.draft().steps.len();
    for (k, step) in editor.draft().steps.iter().enumerate() {
        ui.add_space(8.0);
        ui.push_id(("step", k), |ui| {
            step_buttons(ui, [k, count], held, asked);
            caption(ui, (k, arrangement), step, asked);
        });
    }
}

/// A field with an edge: in the light theme its own has the color of the background.
fn edged<R>(ui: &mut Ui, field: impl FnOnce(&mut Ui) -> R) -> R {
    let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).border);
    Frame::new().stroke(stroke).corner_radius(CornerRadius::same(ROUNDING)).show(ui, field).inner
}

/// Why an action cannot be carried out now: something holds the session, or the page's address locks it.
fn refusal(ui: &Ui, held: Option<Words>, action: &LessonAction) -> Option<Words> {
    let is_locked = || Locks::of(ui.ctx()).refused(&Action::Lesson(action.clone())).is_some();
    held.filter(|_| action.concerns_session()).or_else(|| is_locked().then_some(REFUSAL))
}

/// The number and the buttons of the step `k`, in one row where they fit, else in two.
fn step_buttons(ui: &mut Ui, [k, count]: [usize; 2], held: Option<Words>, asked: &mut Vec<LessonAction>) {
    let labels: f32 = [key::show_step(), key::renew_step()].map(|label| button_width(ui, tr(label))).iter().sum();
    let fits = NUMBER + labels + 3.0 * control_height(ui, ICON_WIDTH) <= ui.available_width();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(RichText::new((k + 1).to_string()).font(bold(14.0)).color(Palette::of(ui.visuals()).text));
        for (label, tooltip, action) in [
            (key::show_step(), key::show_step_tooltip(), LessonAction::Show(k)),
            (key::renew_step(), key::renew_step_tooltip(), LessonAction::Renew(k)),
        ] {
            if text_button(ui, refusal(ui, held, &action), label, tooltip) {
                asked.push(action);
            }
        }
        if fits {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| order_buttons(ui, [k, count], asked));
        }
    });
    if !fits {
        let row = vec2(ui.available_width(), control_height(ui, ROW_HEIGHT));
        let right = Layout::right_to_left(Align::Center);
        ui.allocate_ui_with_layout(row, right, |ui| order_buttons(ui, [k, count], asked));
    }
}

/// The buttons that delete the step `k` and move it, from the right.
fn order_buttons(ui: &mut Ui, [k, count]: [usize; 2], asked: &mut Vec<LessonAction>) {
    ui.spacing_mut().item_spacing.x = 2.0;
    if cross(ui, tr(key::delete_step())) {
        asked.push(LessonAction::Delete(k));
    }
    let [up, down] = [key::step_up(), key::step_down()].map(tr);
    if icon_button(ui, Icon::Down, k + 1 < count, down, down).clicked() {
        asked.push(LessonAction::Swap(k));
    }
    if icon_button(ui, Icon::Up, k > 0, up, up).clicked() {
        asked.push(LessonAction::Swap(k - 1));
    }
}

/// The caption of the step `k`.
fn caption(ui: &mut Ui, (k, arrangement): (usize, usize), step: &Step, asked: &mut Vec<LessonAction>) {
    let mut caption = step.caption.clone();
    let field = TextEdit::multiline(&mut caption)
        .id_salt(("caption", arrangement))
        .char_limit(MAX_CAPTION)
        .desired_rows(CAPTION_ROWS)
        .desired_width(f32::INFINITY)
        .hint_text(tr(key::lesson_caption_hint()));
    let response = edged(ui, |ui| ui.add(field));
    response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say(&key::caption_of(k + 1))));
    if response.changed() {
        asked.push(LessonAction::Caption(k, caption));
    }
}

/// A button that is gray where something refuses it, with the reason as tooltip. Returns whether it was clicked.
fn text_button(ui: &mut Ui, refusal: Option<Words>, label: Words, tooltip: Words) -> bool {
    let button = Button::new(tr(label)).min_size(vec2(0.0, control_height(ui, ROW_HEIGHT)));
    explained(ui, button, refusal, tooltip)
}

fn explained(ui: &mut Ui, button: Button<'_>, refusal: Option<Words>, tooltip: Words) -> bool {
    let response = ui.add_enabled(refusal.is_none(), button).on_hover_text(tr(tooltip));
    response.on_disabled_hover_text(tr(refusal.unwrap_or(tooltip))).clicked()
}

/// What is to be said, and the buttons that concern the whole lesson.
fn buttons(ui: &mut Ui, editor: &LessonEditor, held: Option<Words>, asked: &mut Vec<LessonAction>) {
    let palette = Palette::of(ui.visuals());
    if let Some(note) = &editor.note {
        ui.add(Label::new(RichText::new(say(note)).color(palette.error_edge)).wrap());
    }
    if let Some(held) = held {
        ui.add(Label::new(RichText::new(tr(held)).color(palette.weak)).wrap());
    }
    let size = vec2(ui.available_width(), control_height(ui, ROW_HEIGHT));
    let add = Button::new(RichText::new(tr(key::add_step())).color(palette.on_accent)).fill(palette.accent);
    let is_full = (!editor.has_room()).then_some(key::lesson_is_full());
    let refused = is_full.or_else(|| refusal(ui, held, &LessonAction::Add));
    let add = add.min_size(size);
    ui.vertical_centered_justified(|ui| {
        if explained(ui, add, refused, key::add_step_tooltip()) {
            asked.push(LessonAction::Add);
        }
    });
    let is_empty = editor.draft().steps.is_empty().then_some(key::lesson_without_steps());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (label, tooltip, needs, action) in [
            (key::play_lesson(), key::play_lesson_tooltip(), is_empty, LessonAction::Play),
            (key::save_lesson(), key::save_lesson_tooltip(), is_empty, LessonAction::Save),
            (key::lesson_link(), key::lesson_link_tooltip(), is_empty, LessonAction::CopyLink),
            (key::open_lesson(), key::open_lesson_tooltip(), None, LessonAction::OpenFile),
        ] {
            let refused = needs.or_else(|| refusal(ui, held, &action));
            if text_button(ui, refused, label, tooltip) {
                asked.push(action);
            }
        }
    });
}

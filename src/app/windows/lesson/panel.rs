//! The panel of a lesson: beside the pictures, on a narrow screen in the place of the sheet below them.
//!
//! A step has its caption and the buttons that show, renew, move and delete it. All requests are actions.

use super::LessonEditor;
use crate::app::input::action::{Action, Actions, LessonAction};
use crate::app::input::locks::Locks;
use crate::app::theme::icons::{Icon, icon_button};
use crate::app::theme::{Palette, ROUNDING, ROW_HEIGHT, bold, control_height};
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
/// The lines of a caption that are shown while it has no more.
const CAPTION_ROWS: usize = 3;

/// Shows the panel.
pub fn show(ui: &mut Ui, editor: &LessonEditor, narrow: bool, actions: &mut Actions) {
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
        heading(ui, &mut asked);
        let foot = Frame::new().inner_margin(Margin { top: 6, right: 6, ..Margin::ZERO });
        Panel::bottom("lesson-buttons").resizable(false).show_separator_line(false).frame(foot).show(ui, |ui| {
            buttons(ui, editor, &mut asked);
        });
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - SCROLL_BAR);
            draft(ui, editor, &mut asked);
        });
        actions.extend(asked.into_iter().map(Action::Lesson));
    });
}

fn heading(ui: &mut Ui, asked: &mut Vec<LessonAction>) {
    ui.horizontal(|ui| {
        let ink = Palette::of(ui.visuals()).text;
        ui.label(RichText::new(tr(key::lesson())).font(bold(15.0)).color(ink));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if cross(ui, tr(key::close_lesson())) {
                asked.push(LessonAction::Close);
            }
        });
    });
}

/// A button with a cross; its name is its tooltip. Returns whether it was clicked.
fn cross(ui: &mut Ui, name: &str) -> bool {
    let side = control_height(ui, ROW_HEIGHT);
    let button = ui.add(Button::new("×").min_size(vec2(side, side)));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
    button.on_hover_text(name).clicked()
}

/// Title and steps, or without a step what to do.
fn draft(ui: &mut Ui, editor: &LessonEditor, asked: &mut Vec<LessonAction>) {
    let mut title = editor.draft().title.clone();
    let field = TextEdit::singleline(&mut title).char_limit(MAX_TITLE).hint_text(tr(key::lesson_title()));
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
        ui.push_id(("step", k), |ui| step_rows(ui, k, count, step, asked));
    }
}

/// A field with an edge: in the light theme its own has the color of the background.
fn edged<R>(ui: &mut Ui, field: impl FnOnce(&mut Ui) -> R) -> R {
    let stroke = Stroke::new(1.0, Palette::of(ui.visuals()).border);
    Frame::new().stroke(stroke).corner_radius(CornerRadius::same(ROUNDING)).show(ui, field).inner
}

fn step_rows(ui: &mut Ui, k: usize, count: usize, step: &Step, asked: &mut Vec<LessonAction>) {
    let locked = Locks::of(ui.ctx()).refused(&Action::Lesson(LessonAction::Show(k))).is_some();
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(RichText::new((k + 1).to_string()).font(bold(14.0)).color(Palette::of(ui.visuals()).text));
        if text_button(ui, !locked, key::show_step(), key::show_step_tooltip()) {
            asked.push(LessonAction::Show(k));
        }
        if text_button(ui, true, key::renew_step(), key::renew_step_tooltip()) {
            asked.push(LessonAction::Renew(k));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
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
        });
    });
    let mut caption = step.caption.clone();
    let field = TextEdit::multiline(&mut caption)
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

fn text_button(ui: &mut Ui, enabled: bool, label: Words, tooltip: Words) -> bool {
    let button = Button::new(tr(label)).min_size(vec2(0.0, control_height(ui, ROW_HEIGHT)));
    ui.add_enabled(enabled, button).on_hover_text(tr(tooltip)).clicked()
}

/// What is to be said, the way back, and the buttons that concern the whole lesson.
fn buttons(ui: &mut Ui, editor: &LessonEditor, asked: &mut Vec<LessonAction>) {
    let palette = Palette::of(ui.visuals());
    if let Some(note) = &editor.note {
        ui.add(Label::new(RichText::new(say(note)).color(palette.error_edge)).wrap());
    }
    if let Some(what) = editor.restorable() {
        ui.horizontal(|ui| {
            ui.label(RichText::new(tr(what)).color(palette.weak));
            if text_button(ui, true, key::undo(), what) {
                asked.push(LessonAction::Restore);
            }
        });
    }
    let size = vec2(ui.available_width(), control_height(ui, ROW_HEIGHT));
    let add = Button::new(RichText::new(tr(key::add_step())).color(palette.on_accent)).fill(palette.accent);
    let add = ui.add_enabled(editor.has_room(), add.min_size(size));
    if add.on_hover_text(tr(key::add_step_tooltip())).clicked() {
        asked.push(LessonAction::Add);
    }
    let has_steps = !editor.draft().steps.is_empty();
    let may_play = Locks::of(ui.ctx()).refused(&Action::Lesson(LessonAction::Play)).is_none();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (label, tooltip, enabled, action) in [
            (key::play_lesson(), key::play_lesson_tooltip(), has_steps && may_play, LessonAction::Play),
            (key::save_lesson(), key::save_lesson_tooltip(), has_steps, LessonAction::Save),
            (key::lesson_link(), key::lesson_link_tooltip(), has_steps, LessonAction::CopyLink),
            (key::open_lesson(), key::open_lesson_tooltip(), true, LessonAction::OpenFile),
        ] {
            if text_button(ui, enabled, label, tooltip) {
                asked.push(action);
            }
        }
    });
}

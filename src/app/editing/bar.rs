//! The toolbar over the picture of an edited side, and the message above it.

use super::paint::RING;
use super::{Change, Editor};
use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::input::locks::menu_entry;
use crate::app::theme::widgets::message_box;
use crate::app::theme::{Palette, ROUNDING, ROW_HEIGHT, control_height};
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::language::{Label, Message, key, tr};
use crate::model::editing::{Drawing, Pen};
use egui::{
    Align2, Area, Button, CornerRadius, Frame, Id, Margin, Order, Pos2, Rect, RichText, Stroke, Ui, pos2, vec2,
};

/// Free space below the bar.
const GAP: f32 = 8.0;

const HANDLES_TOOLTIP: Label = key::handles_tooltip();

/// The assumed height of the bar before its first layout: one row.
const ONE_ROW: f32 = 52.0;

/// The height of a side's bar and the gap below it, in points.
pub fn height(ui: &Ui, side: Side) -> f32 {
    ui.memory(|memory| memory.area_rect(bar_id(side))).map_or(ONE_ROW, |area| area.height()) + GAP
}

fn bar_id(side: Side) -> Id {
    Id::unique(("edit bar", side))
}

/// In a picture narrower than this the buttons have less padding, so that all fit into one row.
const ONE_ROW_WIDTH: f32 = 300.0;
const NARROW_PADDING: f32 = 5.0;

/// The gap between the bar and the message above it.
const BELOW_MESSAGE: f32 = 4.0;
/// Free space above a message at the picture's upper edge, for title and buttons.
const BELOW_TITLE: f32 = 64.0;
/// The assumed height of a message before its first layout: two lines.
const TWO_LINES: f32 = 56.0;

/// Shows the bar of an edited side at the lower edge of `free_area`, the free part of its picture, and the message
/// above it.
pub fn show(ui: &mut Ui, side: Side, view: &View, free_area: Rect, editor: &Editor, actions: &mut Actions) {
    if editor.side() != Some(side) {
        return;
    }
    let bar = show_bar(ui, side, free_area, editor, actions);
    if let Some(text) = editor.message() {
        let crossing = editor.crossing().and_then(|crossing| crossing.at).map(|at| view.to_screen(at));
        show_message(ui, side, view.rect, bar.top() - BELOW_MESSAGE, crossing, text, actions);
    }
}

fn widest(rect: Rect) -> f32 {
    (rect.width() - 12.0).min(460.0)
}

/// Shows a message with its lower edge at `bottom`, or at the upper edge of the picture if it would hide the crossing
/// otherwise.
fn show_message(
    ui: &Ui,
    side: Side,
    rect: Rect,
    bottom: f32,
    crossing: Option<Pos2>,
    text: &Message,
    actions: &mut Actions,
) {
    let id = Id::unique(("edit message", side));
    let size = ui.memory(|memory| memory.area_rect(id)).map_or(vec2(widest(rect), TWO_LINES), |area| area.size());
    let below = Rect::from_min_size(pos2(rect.center().x - 0.5 * size.x, bottom - size.y), size);
    let hides = crossing.is_some_and(|place| below.expand(RING).contains(place));
    let (pivot, y) =
        if hides { (Align2::CENTER_TOP, rect.top() + BELOW_TITLE) } else { (Align2::CENTER_BOTTOM, bottom) };
    let area = Area::new(id).order(Order::Middle).pivot(pivot).fixed_pos(pos2(rect.center().x, y));
    area.show(ui.ctx(), |ui| {
        ui.set_max_width(widest(rect));
        if message_box(ui, text, None, 0.5 * rect.height()).is_some() {
            actions.push(Action::Edit(EditAction::Dismiss));
        }
    });
}

/// Shows the buttons; returns the rectangle of the bar.
fn show_bar(ui: &Ui, side: Side, free_area: Rect, editor: &Editor, actions: &mut Actions) -> Rect {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new()
        .fill(palette.raised)
        .stroke(Stroke::new(1.0, palette.border))
        .corner_radius(CornerRadius::same(ROUNDING + 4))
        .inner_margin(Margin::same(6));
    let area = Area::new(bar_id(side))
        .order(Order::Middle)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(pos2(free_area.center().x, free_area.bottom() - GAP));
    let shown = area.show(ui.ctx(), |ui| {
        ui.set_max_width(widest(free_area));
        frame.show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
                if free_area.width() < ONE_ROW_WIDTH {
                    ui.spacing_mut().button_padding.x = NARROW_PADDING;
                }
                let height = control_height(ui, ROW_HEIGHT);
                if let Some(drawing) = editor.drawing(side) {
                    ui.label(RichText::new(pen_words(drawing.pen())).color(palette.text));
                    drawing_buttons(ui, height, drawing, actions);
                } else if let Some(reshaping) = editor.reshaping(side) {
                    buttons(ui, height, reshaping.selected, actions);
                }
            });
        });
    });
    shown.response.rect
}

/// The instruction for a pen.
fn pen_words(pen: Pen) -> &'static str {
    match pen {
        Pen::Freehand => tr(key::draw_around_shape_go()),
        Pen::Lines => tr(key::click_corners()),
        Pen::Curve => tr(key::click_points_along_curve()),
    }
}

fn drawing_buttons(ui: &mut Ui, height: f32, drawing: &Drawing, actions: &mut Actions) {
    let count = drawing.points().len();
    if drawing.pen() != Pen::Freehand {
        let back = (count > 0).then_some(EditAction::TakeBack);
        button(ui, height, [key::back(), key::back_tooltip()], back, actions);
        let close = (count >= 3).then_some(EditAction::Close);
        button(ui, height, [key::close(), key::close_tooltip()], close, actions);
    }
    button(ui, height, [key::cancel(), key::cancel_tooltip()], Some(EditAction::Leave), actions);
}

/// A button of the bar with label and tooltip; disabled without an action, and where its action is locked.
fn button(ui: &mut Ui, height: f32, words: [Label; 2], action: Option<EditAction>, actions: &mut Actions) {
    let [label, tooltip] = words;
    let button = Button::new(tr(label)).min_size(vec2(0.0, height));
    let Some(action) = action.map(Action::Edit) else {
        ui.add_enabled(false, button).on_disabled_hover_text(tr(tooltip));
        return;
    };
    if menu_entry(ui, true, button, tooltip, &action) {
        actions.push(action);
    }
}

fn buttons(ui: &mut Ui, height: f32, selected: Option<usize>, actions: &mut Actions) {
    let change = |change| Some(EditAction::Change(change));
    let smooth = key::smooth_tooltip();
    button(ui, height, [key::smooth(), smooth], change(Change::Smooth), actions);
    button(ui, height, [key::mirror(), key::mirror_tooltip()], change(Change::Mirror), actions);
    let delete = selected.and_then(|handle| change(Change::Remove(handle)));
    button(ui, height, [key::delete(), key::delete_tooltip()], delete, actions);
    button(ui, height, [key::finish_editing(), HANDLES_TOOLTIP], Some(EditAction::Leave), actions);
}

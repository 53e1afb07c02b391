//! The small bar over the picture of an edited side: what can be done, and what went wrong.

use super::{Change, Drawing, EditAction, Editor, Pen};
use crate::app::action::{Action, Actions};
use crate::app::language::tr;
use crate::app::theme::{Palette, ROUNDING};
use crate::app::widgets::message_box;
use crate::conformal::Side;
use egui::{Align2, Area, Button, CornerRadius, Frame, Id, Margin, Order, Rect, RichText, Stroke, Ui, pos2, vec2};

/// The height of the buttons on a phone, enough for a thumb.
const THUMB: f32 = 40.0;
/// Free space below the bar: the legend is there.
const ABOVE_LEGEND: f32 = 40.0;

const HANDLES_TOOLTIP: &str = "Drag a square to reshape the outline. Double-click on the outline for another one; \
    a right click or a long press takes one away. Arrow keys move the selected one (finely with Shift), N goes to the next; Escape ends.";

/// How much of a phone's picture is free for the bar.
pub const ROOM: f32 = 62.0;

/// Shows the bar of an edited side at the lower edge of its picture.
pub fn show(ui: &mut Ui, side: Side, rect: Rect, narrow: bool, editor: &Editor, actions: &mut Actions) {
    if editor.side() != Some(side) {
        return;
    }
    let palette = Palette::of(ui.visuals());
    let bottom = rect.bottom() - if narrow { 8.0 } else { ABOVE_LEGEND };
    let frame = Frame::new()
        .fill(palette.raised)
        .stroke(Stroke::new(1.0, palette.border))
        .corner_radius(CornerRadius::same(ROUNDING + 4))
        .inner_margin(Margin::same(6));
    let area = Area::new(Id::unique(("edit bar", side)))
        .order(Order::Middle)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(pos2(rect.center().x, bottom));
    area.show(ui.ctx(), |ui| {
        ui.set_max_width((rect.width() - 20.0).min(460.0));
        if let Some(text) = editor.message()
            && message_box(ui, text, None).is_some()
        {
            actions.push(Action::Edit(EditAction::Dismiss));
        }
        frame.show(ui, |ui| {
            if let Some(drawing) = editor.drawing(side) {
                ui.label(RichText::new(pen_words(drawing.pen())).color(palette.text));
            }
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let height = if narrow { THUMB } else { 28.0 };
                if let Some(drawing) = editor.drawing(side) {
                    drawing_buttons(ui, height, drawing, actions);
                } else if let Some(reshaping) = editor.reshaping(side) {
                    buttons(ui, height, reshaping.selected, actions);
                }
            });
        });
    });
}

/// What the pens want from the person.
fn pen_words(pen: Pen) -> &'static str {
    match pen {
        Pen::Freehand => tr("Draw around the shape in one go"),
        Pen::Lines => tr("Click the corners one by one"),
        Pen::Curve => tr("Click points along the curve"),
    }
}

fn drawing_buttons(ui: &mut Ui, height: f32, drawing: &Drawing, actions: &mut Actions) {
    let count = drawing.points().len();
    if drawing.pen() != Pen::Freehand {
        let back = (count > 0).then_some(EditAction::TakeBack);
        button(ui, height, ["Back", "Take the last point back (Backspace)"], back, actions);
        let close = (count >= 3).then_some(EditAction::Close);
        button(
            ui,
            height,
            ["Close", "Join the last point to the first (Enter, or click the first point)"],
            close,
            actions,
        );
    }
    button(ui, height, ["Cancel", "Draw nothing (Escape)"], Some(EditAction::Leave), actions);
}

/// A button of the bar, by its label and its tooltip; without an action it is greyed.
fn button(ui: &mut Ui, height: f32, words: [&'static str; 2], action: Option<EditAction>, actions: &mut Actions) {
    let [label, tooltip] = words.map(tr);
    let button = Button::new(label).min_size(vec2(0.0, height));
    let response = ui.add_enabled(action.is_some(), button).on_hover_text(tooltip).on_disabled_hover_text(tooltip);
    if let Some(action) = action.filter(|_| response.clicked()) {
        actions.push(Action::Edit(action));
    }
}

fn buttons(ui: &mut Ui, height: f32, selected: Option<usize>, actions: &mut Actions) {
    let change = |change| Some(EditAction::Change(change));
    let smooth = "Round the corners: coordinates spread along the outline as heat does; the area stays";
    button(ui, height, ["Smooth", smooth], change(Change::Smooth), actions);
    button(ui, height, ["Mirror", "Exchange left and right, the two points too"], change(Change::Mirror), actions);
    let delete = selected.and_then(|handle| change(Change::Remove(handle)));
    button(ui, height, ["Delete", "Take the selected handle away (Delete)"], delete, actions);
    button(ui, height, ["Done", HANDLES_TOOLTIP], Some(EditAction::Leave), actions);
}

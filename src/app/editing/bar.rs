//! The small bar over the picture of an edited side: what can be done, and what went wrong.

use super::{Change, EditAction, Editor};
use crate::app::action::{Action, Actions};
use crate::app::language::tr;
use crate::app::theme::{Palette, ROUNDING};
use crate::app::widgets::message_box;
use crate::conformal::Side;
use egui::{Align, Button, CornerRadius, Frame, Layout, Margin, Rect, Stroke, Ui, UiBuilder, pos2, vec2};

/// The height of the buttons on a phone, enough for a thumb.
const THUMB: f32 = 40.0;
/// Free space below the bar: the legend is there.
const ABOVE_LEGEND: f32 = 40.0;

const HANDLES_TOOLTIP: &str = "Drag a square to reshape the outline. Double-click on the outline for another one; \
    a right click or a long press takes one away. Arrow keys move the selected one (finely with Shift), N goes to the next; Escape ends.";

/// Shows the bar of an edited side at the lower edge of its picture.
pub fn show(ui: &mut Ui, side: Side, rect: Rect, narrow: bool, editor: &Editor, actions: &mut Actions) {
    let Some(reshaping) = editor.reshaping(side) else { return };
    let palette = Palette::of(ui.visuals());
    let bottom = rect.bottom() - if narrow { 8.0 } else { ABOVE_LEGEND };
    let area = Rect::from_min_max(pos2(rect.left() + 10.0, rect.top()), pos2(rect.right() - 10.0, bottom));
    ui.scope_builder(UiBuilder::new().max_rect(area).layout(Layout::bottom_up(Align::Center)), |ui| {
        let frame = Frame::new()
            .fill(palette.raised)
            .stroke(Stroke::new(1.0, palette.border))
            .corner_radius(CornerRadius::same(ROUNDING + 4))
            .inner_margin(Margin::same(6));
        let width = if narrow { 300.0 } else { 330.0 };
        ui.allocate_ui_with_layout(vec2(width, THUMB), Layout::left_to_right(Align::Center), |ui| {
            frame.show(ui, |ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let height = if narrow { THUMB } else { 28.0 };
                buttons(ui, height, reshaping.selected, actions);
            });
        });
        if let Some(text) = editor.message() {
            ui.set_max_width(area.width().min(460.0));
            if message_box(ui, text, None).is_some() {
                actions.push(Action::Edit(EditAction::Dismiss));
            }
        }
    });
}

fn buttons(ui: &mut Ui, height: f32, selected: Option<usize>, actions: &mut Actions) {
    let mut button = |ui: &mut Ui, label: &'static str, tooltip: &'static str, action: Option<EditAction>| {
        let button = Button::new(tr(label)).min_size(vec2(0.0, height));
        let tooltip = tr(tooltip);
        let response = ui.add_enabled(action.is_some(), button).on_hover_text(tooltip).on_disabled_hover_text(tooltip);
        if let Some(action) = action.filter(|_| response.clicked()) {
            actions.push(Action::Edit(action));
        }
    };
    let change = |change| Some(EditAction::Change(change));
    let smooth = "Round the corners: coordinates spread along the outline as heat does; the area stays";
    button(ui, "Smooth", smooth, change(Change::Smooth));
    button(ui, "Mirror", "Exchange left and right, the two points too", change(Change::Mirror));
    let delete = selected.and_then(|handle| change(Change::Remove(handle)));
    button(ui, "Delete", "Take the selected handle away (Delete)", delete);
    button(ui, "Done", HANDLES_TOOLTIP, Some(EditAction::Leave));
}

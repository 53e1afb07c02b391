//! The marks at the corners of a smooth outline: a square at a corner, a ring where one was made smooth. A click or a
//! tap switches between the two.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::Locks;
use crate::app::theme::Palette;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::language::{key, tr};
use crate::model::Model;
use crate::worker::Corner;
use egui::{CornerRadius, CursorIcon, Pos2, Rect, Response, Stroke, StrokeKind, Ui, Vec2};

/// Half the side of a mark, in points.
const HALF: f32 = 3.5;
/// The distance at which a mark is hit: by a pointer, and by a finger.
const REACH: f32 = 10.0;
const FINGER_REACH: f32 = 22.0;

/// Switches the corner that is clicked, unless a dot or something else `is_over` it.
pub fn interact(
    ui: &Ui,
    response: &Response,
    side: Side,
    model: &Model,
    view: &View,
    is_over: bool,
    actions: &mut Actions,
) {
    let reach = if ui.input(egui::InputState::any_touches) { FINGER_REACH } else { REACH };
    let Some(pointer) = response.interact_pointer_pos().or(response.hover_pos()).filter(|_| !is_over) else { return };
    let Some((corner, _)) = nearest(side, model, view, pointer, reach) else { return };
    let Some(command) = model.switch_corner(side, corner.vertex) else { return };
    let action = Action::Session(command);
    if Locks::of(ui.ctx()).refused(&action).is_some() {
        return;
    }
    ui.set_cursor_icon(CursorIcon::PointingHand);
    if response.clicked() {
        actions.push(action);
    } else if response.hovered() {
        let text = if corner.is_corner { key::corner_mark_tooltip() } else { key::smooth_mark_tooltip() };
        response.clone().on_hover_text_at_pointer(tr(text));
    }
}

fn nearest(side: Side, model: &Model, view: &View, pointer: Pos2, reach: f32) -> Option<(Corner, Pos2)> {
    let marks = model.corners(side).map(|(corner, place)| (corner, view.to_screen(place)));
    let near = marks.filter(|(_, place)| place.distance(pointer) <= reach);
    near.min_by(|(_, a), (_, b)| a.distance(pointer).total_cmp(&b.distance(pointer)))
}

/// Draws the marks.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(view.rect);
    let edge = Stroke::new(1.5, palette.text);
    for (corner, place) in model.corners(side) {
        let place = view.to_screen(place);
        if corner.is_corner {
            let square = Rect::from_center_size(place, Vec2::splat(2.0 * HALF));
            painter.rect(square, CornerRadius::ZERO, palette.canvas, edge, StrokeKind::Middle);
        } else {
            painter.circle(place, HALF, palette.canvas, edge);
        }
    }
}

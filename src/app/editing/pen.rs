//! Gestures of drawing: a stroke with the pointer down, or clicks.
//!
//! A click on the first point closes, and so does a double-click.

use super::{Drawing, EditAction, Pen};
use crate::app::action::{Action, Actions};
use crate::app::handles::GRAB_RADIUS;
use crate::app::view::View;
use crate::app::viewport;
use egui::{CursorIcon, Event, Pos2, Response, Ui};

/// A second click this near the first one, in points, is a double-click and means the end.
const SAME_PLACE: f32 = 6.0;

/// Turns gestures over the picture of the side that is drawn for into steps and camera moves.
pub fn interact(ui: &Ui, response: &Response, view: &mut View, drawing: &Drawing, actions: &mut Actions) {
    let mut push = |action| actions.push(Action::Edit(action));
    let freehand = drawing.pen() == Pen::Freehand;
    if viewport::pinch(ui, response, view) {
        if freehand {
            push(EditAction::Clear);
        }
        return;
    }
    viewport::move_camera(ui, response, view, freehand, false);
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    let Some(pointer) = response.interact_pointer_pos() else { return };
    let at = view.to_world(pointer);
    if freehand {
        if response.dragged() || response.is_pointer_button_down_on() {
            for place in places_since_last_frame(ui) {
                push(EditAction::Point(view.to_world(place)));
            }
            push(EditAction::Point(at));
        }
        if response.drag_stopped() || response.clicked() {
            push(EditAction::Close);
        }
    } else if response.clicked() {
        let near = |point: Option<&_>, reach| point.is_some_and(|&p| view.to_screen(p).distance(pointer) <= reach);
        let points = drawing.points();
        let closes = points.len() >= 3 && (near(points.first(), GRAB_RADIUS) || near(points.last(), SAME_PLACE));
        push(if closes { EditAction::Close } else { EditAction::Point(at) });
    }
}

/// Where the pressed pointer was since the last frame, so that a quick stroke stays round.
fn places_since_last_frame(ui: &Ui) -> Vec<Pos2> {
    let mut places = Vec::new();
    ui.input(|input| {
        for event in &input.events {
            match event {
                Event::PointerMoved(place) => places.push(*place),
                // what was before is the way to the stroke
                Event::PointerButton { pressed: true, .. } => places.clear(),
                _ => {}
            }
        }
    });
    places
}

//! Gestures of drawing: a stroke with the pointer down, or clicks.
//!
//! A click on the first point closes, and so does a double-click.

use super::{Drawing, EditAction, Pen};
use crate::app::action::{Action, Actions};
use crate::app::handles::GRAB_RADIUS;
use crate::app::view::View;
use crate::app::viewport;
use egui::{CursorIcon, Event, PointerButton, Pos2, Response, TouchPhase, Ui};

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
    if freehand {
        stroke(ui, response, view, drawing).into_iter().for_each(push);
    } else if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.clicked()) {
        let near = |point: Option<&_>, reach| point.is_some_and(|&p| view.to_screen(p).distance(pointer) <= reach);
        let points = drawing.points();
        let closes = points.len() >= 3 && (near(points.first(), GRAB_RADIUS) || near(points.last(), SAME_PLACE));
        push(if closes { EditAction::Close } else { EditAction::Point(view.to_world(pointer)) });
    }
}

/// The way of a stroke since the last frame, and its end. Frames may be slow and strokes quick: what egui says of a
/// drag is not enough, for it says nothing of one whose moves and end fall into one frame.
fn stroke(ui: &Ui, response: &Response, view: &View, drawing: &Drawing) -> Vec<EditAction> {
    let is_under_way = !drawing.points().is_empty() && drawing.crossing().is_none();
    let way = ui.input(|input| Way::of(&input.events, is_under_way));
    // a press on something that lies over the picture is none on the picture
    let begins = way.begins && (response.is_pointer_button_down_on() || (way.ends && response.hovered()));
    if !begins && !is_under_way {
        return Vec::new();
    }
    if way.is_cancelled {
        return vec![EditAction::Clear];
    }
    let mut steps: Vec<_> = way.places.iter().map(|&place| EditAction::Point(view.to_world(place))).collect();
    if way.ends || !ui.input(|input| input.pointer.primary_down()) {
        steps.push(EditAction::Close);
    }
    steps
}

/// Where a pressed pointer was.
#[derive(Debug, Default, PartialEq)]
struct Way {
    /// In their order.
    places: Vec<Pos2>,
    /// It was pressed there.
    begins: bool,
    /// It was let go of.
    ends: bool,
    /// The system has taken the touch away.
    is_cancelled: bool,
}

impl Way {
    /// From a frame's events; `is_down`: the pointer was pressed in an earlier one.
    fn of(events: &[Event], is_down: bool) -> Self {
        let mut way = Self::default();
        for event in events {
            match *event {
                Event::PointerMoved(place) if (is_down || way.begins) && !way.ends => way.places.push(place),
                Event::PointerButton { button: PointerButton::Primary, pressed, pos, .. } if !way.ends => {
                    way.begins |= pressed;
                    way.ends = !pressed && (is_down || way.begins);
                    way.places.push(pos);
                }
                Event::Touch { phase: TouchPhase::Cancel, .. } => way.is_cancelled = true,
                _ => {}
            }
        }
        way
    }
}

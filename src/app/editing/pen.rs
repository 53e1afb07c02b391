//! Gestures of drawing: a stroke with the pointer down (freehand), or clicks (lines, curve).
//!
//! A click on the first point or a double-click closes the outline.

use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::input::handles::GRAB_RADIUS;
use crate::app::input::touches;
use crate::app::viewport::planar;
use crate::app::viewport::view::View;
use crate::model::editing::{Drawing, Pen};
use egui::{CursorIcon, Event, PointerButton, Pos2, Response, Ui};

/// A click this near the last point, in points, is a double-click and closes the outline.
const SAME_PLACE: f32 = 6.0;

/// Turns gestures over the picture that is drawn in into actions and camera moves.
pub fn interact(ui: &Ui, response: &Response, view: &mut View, drawing: &Drawing, actions: &mut Actions) {
    let mut push = |action| actions.push(Action::Edit(action));
    let freehand = drawing.pen() == Pen::Freehand;
    if planar::pinch(ui, response, view) {
        if freehand {
            push(EditAction::Clear);
        }
        return;
    }
    planar::move_camera(ui, response, view, freehand, false);
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

/// The points of a stroke since the last frame, and its end. They are read from the events, because egui reports no
/// drag whose moves and release fall into one frame, as happens with slow frames and quick strokes.
fn stroke(ui: &Ui, response: &Response, view: &View, drawing: &Drawing) -> Vec<EditAction> {
    let is_under_way = !drawing.points().is_empty() && drawing.crossing().is_none();
    let way = ui.input(|input| Way::of(&input.events, is_under_way));
    // a press on a widget over the picture does not begin a stroke
    let begins = way.begins && (response.is_pointer_button_down_on() || (way.ends && response.hovered()));
    let mut steps: Vec<_> = way.is_cancelled.then_some(EditAction::Clear).into_iter().collect();
    if !begins && (!is_under_way || way.is_cancelled) {
        return steps;
    }
    steps.extend(way.places.iter().map(|&place| EditAction::Point(view.to_world(place))));
    if way.ends || !ui.input(|input| input.pointer.primary_down()) {
        steps.push(EditAction::Close);
    }
    steps
}

/// The pointer's path within a frame while it was pressed.
#[derive(Debug, Default, PartialEq)]
struct Way {
    /// The places, in order.
    places: Vec<Pos2>,
    /// Whether the pointer was pressed in this frame.
    begins: bool,
    /// Whether the pointer was released in this frame.
    ends: bool,
    /// Whether the system has canceled the touch that was down; the places are those of a later touch.
    is_cancelled: bool,
}

impl Way {
    /// Reads the path from a frame's events; `is_down` is whether the pointer was pressed in an earlier frame.
    fn of(events: &[Event], mut is_down: bool) -> Self {
        let mut way = Self::default();
        for event in events {
            match *event {
                _ if touches::lets_go(event) && is_down => {
                    way = Self { is_cancelled: true, ..Self::default() };
                    is_down = false;
                }
                Event::PointerMoved(place) if is_down => way.places.push(place),
                Event::PointerButton { button: PointerButton::Primary, pressed, pos, .. } if !way.ends => {
                    if pressed || is_down {
                        way.places.push(pos);
                    }
                    way.begins |= pressed;
                    way.ends = is_down && !pressed;
                    is_down = pressed;
                }
                _ => {}
            }
        }
        way
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, TouchDeviceId, TouchId, TouchPhase, pos2};

    #[test]
    fn a_cancelled_touch_discards_its_stroke_and_the_next_touch_draws() {
        let [old, new] = [pos2(10.0, 20.0), pos2(60.0, 20.0)];
        let touch =
            |id, phase, pos| Event::Touch { device_id: TouchDeviceId(0), id: TouchId(id), phase, pos, force: None };
        let press = Event::PointerButton {
            pos: new,
            button: PointerButton::Primary,
            pressed: true,
            modifiers: Modifiers::NONE,
        };
        let mut touches = touches::Touches::default();
        touches.take_in(&mut vec![touch(1, TouchPhase::Start, old)]);
        let mut events = vec![touch(1, TouchPhase::Cancel, old), touch(2, TouchPhase::Start, new), press];
        touches.take_in(&mut events);
        let way = Way::of(&events, true);
        assert_eq!(way, Way { places: vec![new], begins: true, ends: false, is_cancelled: true });
        // a canceled touch that is not the pointer does not affect the stroke
        let mut palm = vec![Event::PointerMoved(new), touch(3, TouchPhase::Cancel, old)];
        touches.take_in(&mut palm);
        assert_eq!(Way::of(&palm, true), Way { places: vec![new], ..Way::default() });
    }
}

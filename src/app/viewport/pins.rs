//! Pins in the pictures: how far they are missed, and the double click that adds one.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::HandleKind;
use crate::app::input::locks::Locks;
use crate::app::theme::BOUNDARY_COLOUR;
use crate::conformal::Side;
use crate::model::Model;
use crate::session::Command;
use egui::{Color32, CursorIcon, Painter, Pos2, Response, Stroke, Ui};

/// The distance on the screen from which a pin is drawn as missed, in points.
const MISSED: f32 = 2.0;

/// Draws how far the target's pins are missed: a line from each pin to the image of its partner, which gets a ring.
/// `to_screen` gives the place of a fraction of the boundary.
pub fn paint_misses(painter: &Painter, side: Side, model: &Model, to_screen: impl Fn(f64) -> Option<Pos2>) {
    let (Some(pins), Some(images), Side::Target) = (model.pins(), model.missed_pins(), side) else { return };
    for (pair, image) in pins.pairs().iter().zip(images) {
        let (Some(pin), Some(image)) = (to_screen(pair.target), to_screen(*image)) else { continue };
        if pin.distance(image) < MISSED {
            continue;
        }
        for (width, ink) in [(5.0, Color32::WHITE), (2.5, BOUNDARY_COLOUR)] {
            painter.line_segment([pin, image], Stroke::new(width, ink));
            painter.circle_stroke(image, 4.0, Stroke::new(width, ink));
        }
    }
}

/// Adds a pin where the boundary is double-clicked, with its present image; `boundary` is the place under the pointer.
/// Returns whether there is one, so that the double click means nothing else.
pub fn add(
    ui: &Ui,
    response: &Response,
    side: Side,
    model: &Model,
    boundary: Option<f64>,
    actions: &mut Actions,
) -> bool {
    let is_locked = Locks::of(ui.ctx()).holds_handle(HandleKind::Pin(0));
    let (Some(fraction), Some(_), false) = (boundary, model.pins(), is_locked) else { return false };
    ui.set_cursor_icon(CursorIcon::Copy);
    if response.double_clicked()
        && let Some(pins) = model.pins_with(side, fraction)
    {
        actions.push(Action::Session(Command::SetPins(Some(pins))));
    }
    true
}

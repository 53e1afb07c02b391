//! Pins in the pictures: their numbers, the double click that adds one, and the keys that move or remove one.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::HandleKind;
use crate::app::input::locks::Locks;
use crate::conformal::{Pins, Side};
use crate::model::Model;
use crate::session::Command;
use egui::{CursorIcon, Response, Ui};

/// The pins of a side as dots, with their fractions of the boundary's length.
pub fn numbered(pins: &Pins, side: Side) -> impl Iterator<Item = (HandleKind, f64)> {
    pins.pairs().iter().zip(0..).map(move |(pair, pin)| (HandleKind::Pin(pin), pair[side]))
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
    let (Some(fraction), Some(_)) = (boundary, model.pins()) else { return false };
    ui.set_cursor_icon(CursorIcon::Copy);
    if response.double_clicked()
        && let Some(pins) = model.pins_with(side, fraction)
    {
        let action = Action::Session(Command::SetPins(Some(pins)));
        actions.extend(Some(action).filter(|action| Locks::of(ui.ctx()).refused(action).is_none()));
    }
    true
}

/// The command that moves a pin along its boundary.
pub fn stepped(model: &Model, side: Side, pin: usize, step: f64) -> Option<Command> {
    let fraction = model.pins()?.pairs().get(pin)?[side] + step;
    Some(Command::MovePin { pin, side, fraction })
}

/// The command that removes a pin; `None` if fewer than three would remain.
pub fn removed(model: &Model, pin: usize) -> Option<Command> {
    model.pins()?.without(pin).ok().map(|pins| Command::SetPins(Some(pins)))
}

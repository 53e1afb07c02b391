//! The dots of a side and the commands that move them, for planar viewports and surfaces alike.

use crate::app::input::handles::{Handle, HandleKind, HandleState};
use crate::app::input::keyboard_navigation::KeyStep;
use crate::conformal::{InteriorPoint, Side};
use crate::model::Model;
use crate::session::Command;
use egui::{Pos2, Ui, Vec2};

/// The dots of a side: its two points, or its pins. `place` gives the place of a fraction of the boundary.
pub fn dots<P>(
    model: &Model,
    side: Side,
    [interior, boundary]: [Option<P>; 2],
    place: impl Fn(f64) -> Option<P>,
) -> Vec<(HandleKind, P)> {
    let (Some(pins), Some(_)) = (model.pins(), &boundary) else {
        let points = [(HandleKind::Interior, interior), (HandleKind::Boundary, boundary)];
        return points.into_iter().filter_map(|(kind, point)| Some((kind, point?))).collect();
    };
    let numbered = pins.pairs().iter().zip(0..);
    numbered.filter_map(|(pair, pin)| Some((HandleKind::Pin(pin), place(pair[side])?))).collect()
}

/// The dot of a side that is dragged, and where the pointer has moved it.
pub fn dragged(ui: &Ui, side: Side, handles: &HandleState) -> Option<(Handle, Pos2)> {
    let grip = handles.grip.filter(|grip| grip.handle.side == side)?;
    let (moved, pointer) = ui.input(|input| (input.pointer.delta() != Vec2::ZERO, input.pointer.interact_pos()));
    Some((grip.handle, pointer.filter(|_| moved)? + grip.offset))
}

/// The command that moves a dot: an interior one to the point `interior`, any other one to the fraction `boundary`.
pub fn moved(
    Handle { side, kind }: Handle,
    interior: impl FnOnce() -> Option<InteriorPoint>,
    boundary: impl FnOnce() -> Option<f64>,
) -> Option<Command> {
    match kind {
        HandleKind::Interior => interior().map(|point| Command::MoveInterior { side, point }),
        HandleKind::Boundary => boundary().map(|fraction| Command::MoveAnchor { side, fraction }),
        HandleKind::Pin(pin) => boundary().map(|fraction| Command::MovePin { pin: pin.into(), side, fraction }),
        HandleKind::Mark(mark) => boundary().map(|fraction| Command::MoveMark { mark: mark.into(), side, fraction }),
    }
}

/// The command of a key: moves a dot of a side, an interior one by a step on the screen, or removes a pin.
pub fn stepped(
    model: &Model,
    side: Side,
    step: KeyStep,
    interior: impl FnOnce(Vec2) -> Option<InteriorPoint>,
) -> Option<Command> {
    match step {
        KeyStep::Interior(step) => interior(step).map(|point| Command::MoveInterior { side, point }),
        KeyStep::Boundary(step) => {
            Some(Command::MoveAnchor { side, fraction: model.session().side(side).points().anchor() + step })
        }
        KeyStep::Pin(pin, step) => {
            let fraction = model.pins()?.pairs().get(pin)?[side] + step;
            Some(Command::MovePin { pin, side, fraction })
        }
        KeyStep::Mark(mark, step) => {
            let fraction = model.session().marks(side)?.get(mark)? + step;
            Some(Command::MoveMark { mark, side, fraction })
        }
        // none if fewer than three would remain
        KeyStep::RemovePin(pin) => model.pins()?.without(pin).ok().map(|pins| Command::SetPins(Some(pins))),
    }
}

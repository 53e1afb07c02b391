//! Whether gestures over the texture's side move the texture's picture instead of the camera: a switch of the screen,
//! neither in the session nor kept.

use egui::{Context, Id};

fn id() -> Id {
    Id::unique("gestures move the picture")
}

/// Whether the switch is on.
pub fn is_on(context: &Context) -> bool {
    context.data(|data| data.get_temp(id())).unwrap_or(false)
}

/// Sets the switch.
pub fn set(context: &Context, is_on: bool) {
    context.data_mut(|data| data.insert_temp(id(), is_on));
}

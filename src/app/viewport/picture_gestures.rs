//! Gestures that move, scale and turn the texture's picture over the outline on which it lies.
//!
//! A drag moves it; scrolling and two fingers scale it about the pointer, Shift and scrolling or turning two fingers turn
//! it. The dots stay above it. Each gesture is one undo step, as the session settles after it.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, Locks};
use crate::app::input::picture_placing;
use crate::app::viewport::planar::ZOOM_PER_POINT;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::PicturePlacement;
use crate::model::Model;
use crate::session::{Command, TextureKind};
use egui::{Context, CursorIcon, Response, Ui};

/// Radians per point of scrolling: one notch of a wheel (50 points) turns by 5°.
const TURN_PER_POINT: f32 = 0.00175;

/// Whether gestures over this side move the picture.
pub fn is_active(context: &Context, side: Side, model: &Model) -> bool {
    picture_placing::is_on(context)
        && model.session().texture() == TextureKind::Image
        && model.pattern_home() == Some(side)
        && !Locks::of(context).holds(Control::Pattern)
}

/// Moves, scales and turns the picture with two fingers. Returns whether there are two; the caller then ends the drag of
/// one finger.
pub fn pinch(ui: &Ui, response: &Response, side: Side, model: &Model, view: &View, actions: &mut Actions) -> bool {
    let Some(touch) = ui.input(egui::InputState::multi_touch) else { return false };
    if !response.rect.contains(touch.center_pos) {
        return false;
    }
    if let Some(bounds) = model.extent(side) {
        let middle = view.to_world(touch.center_pos);
        let delta = middle - view.to_world(touch.center_pos - touch.translation_delta);
        // the screen's y points down
        let (factor, angle) = (f64::from(touch.zoom_delta), -f64::from(touch.rotation_delta));
        let placed = model.session().picture().moved(delta, bounds).turned_about(middle, factor, angle, bounds);
        place(model, placed, actions);
    }
    true
}

/// Moves the picture by dragging, unless a dot is `held`, and scales or turns it by scrolling.
pub fn drag(ui: &Ui, response: &Response, side: Side, model: &Model, view: &View, held: bool, actions: &mut Actions) {
    let Some(bounds) = model.extent(side) else { return };
    let mut placed = model.session().picture();
    if response.dragged() && !held {
        let start = view.rect.center();
        placed = placed.moved(view.to_world(start + response.drag_delta()) - view.to_world(start), bounds);
        ui.set_cursor_icon(CursorIcon::Move);
    }
    if let Some(pointer) = response.hover_pos() {
        let (scroll, zoom) = ui.input(|input| (input.smooth_scroll_delta(), input.zoom_delta()));
        let factor = f64::from(zoom * (ZOOM_PER_POINT * scroll.y).exp());
        let angle = f64::from(TURN_PER_POINT * scroll.x);
        if factor != 1.0 || angle != 0.0 {
            placed = placed.turned_about(view.to_world(pointer), factor, angle, bounds);
        }
    }
    place(model, placed, actions);
}

fn place(model: &Model, placed: PicturePlacement, actions: &mut Actions) {
    if placed != model.session().picture() {
        actions.push(Action::Session(Command::PlacePicture(placed)));
    }
}

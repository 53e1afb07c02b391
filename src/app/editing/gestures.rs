//! Gestures and keys over a picture whose outline is being reshaped or drawn.
//!
//! Dragging a handle moves it, dragging elsewhere pans; a double-click on the boundary inserts a
//! handle, a long press or a right click on a handle removes it.

use super::{Change, Editor, Hold, Reshaping, pen};
use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::input::handles::{GRAB_RADIUS, HandleState};
use crate::app::input::keyboard_navigation::{ARROWS, arrow_keys};
use crate::app::viewport::planar;
use crate::app::viewport::planar::BOUNDARY_REACH;
use crate::app::viewport::view::View;
use crate::conformal::{PerSide, Side};
use crate::geometry::DVec2;
use crate::model::Model;
use crate::model::editing::Pen;
use egui::{CursorIcon, Key, Modifiers, Pos2, Response, Sense, Ui, Vec2};

/// How far an arrow key moves a handle, in points.
const KEY_STEP: f32 = 4.0;
/// The same with Shift.
const FINE_KEY_STEP: f32 = 0.5;

/// Turns gestures over the picture of an edited side into actions and camera moves. While reshaping, dots can
/// still be dragged where no handle is under the pointer.
pub fn interact(
    ui: &Ui,
    side: Side,
    model: &Model,
    view: &mut View,
    editor: &mut Editor,
    dots: &mut HandleState,
    actions: &mut Actions,
) {
    let response = ui.interact(view.rect, ui.scope_id().with(("viewport", side)), Sense::click_and_drag());
    if let Some(drawing) = editor.drawing(side) {
        return pen::interact(ui, &response, view, drawing, actions);
    }
    let Some(reshaping) = editor.reshaping(side) else { return };
    let grabbed = reshaping.held_by(Hold::Pointer);
    if planar::pinch(ui, &response, view) {
        actions.extend(grabbed.map(|_| Action::Edit(EditAction::Release)));
        return;
    }
    let pointer = ui.input(|input| input.pointer.interact_pos()).filter(|_| response.hovered());
    let under = pointer.filter(|_| dots.grip.is_none()).and_then(|pointer| handle_near(reshaping, view, pointer));
    if grabbed.is_none() && under.is_none() {
        planar::drag_dots(ui, &response, side, model, view, dots, actions);
        if dots.grip.is_some() || dots.hovered.is_some() {
            editor.hovered = None;
            return;
        }
    }
    match grabbed {
        Some(handle) => drag(ui, &response, reshaping, view, handle, actions),
        None => press(ui, &response, reshaping, view, pointer, under, actions),
    }
    planar::move_camera(ui, &response, view, grabbed.is_some() || under.is_some(), false);
    if grabbed.is_some() {
        ui.set_cursor_icon(CursorIcon::Grabbing);
    } else if under.is_some() {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    editor.hovered = under;
}

/// The handle nearest to `pointer`, if it is within [`GRAB_RADIUS`].
fn handle_near(reshaping: &Reshaping, view: &View, pointer: Pos2) -> Option<usize> {
    let distances = reshaping.shape().handles().map(|at| view.to_screen(at).distance(pointer));
    let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1))?;
    (nearest.1 <= GRAB_RADIUS).then_some(nearest.0)
}

fn press(
    ui: &Ui,
    response: &Response,
    reshaping: &Reshaping,
    view: &View,
    pointer: Option<Pos2>,
    under: Option<usize>,
    actions: &mut Actions,
) {
    let Some(pointer) = pointer else { return };
    let edit = |action| Action::Edit(action);
    if let Some(handle) = under.filter(|_| response.secondary_clicked()) {
        actions.push(edit(EditAction::Change(Change::Remove(handle))));
    } else if let Some(handle) = under.filter(|_| ui.input(|input| input.pointer.primary_pressed())) {
        actions.push(edit(EditAction::Grab(handle, Hold::Pointer)));
    } else if under.is_none() && response.double_clicked() {
        let at = view.to_world(pointer);
        if is_near_boundary(reshaping, view, pointer) {
            actions.push(edit(EditAction::Change(Change::Insert(at))));
        }
    } else if under.is_none() && response.clicked() {
        actions.push(edit(EditAction::Select(None)));
    }
}

fn is_near_boundary(reshaping: &Reshaping, view: &View, pointer: Pos2) -> bool {
    let (shape, handle) = reshaping.shape().inserted(view.to_world(pointer));
    shape.handle(handle).is_some_and(|at| view.to_screen(at).distance(pointer) <= BOUNDARY_REACH)
}

/// Moves the dragged handle by the pointer's displacement, so that it does not jump to the pointer; ends the drag on
/// release, and removes the handle on a right click or a long press.
fn drag(ui: &Ui, response: &Response, reshaping: &Reshaping, view: &View, handle: usize, actions: &mut Actions) {
    let (down, moved) = ui.input(|input| (input.pointer.primary_down(), input.pointer.delta()));
    if response.secondary_clicked() {
        actions.push(Action::Edit(EditAction::Release));
        actions.push(Action::Edit(EditAction::Change(Change::Remove(handle))));
    } else if !down {
        actions.push(Action::Edit(EditAction::Release));
    } else if moved != Vec2::ZERO
        && let Some(at) = reshaping.shape().handle(handle)
    {
        actions.push(Action::Edit(EditAction::Drag(shifted(view, at, moved))));
    }
}

/// The point of the plane at a displacement of `by`, in points on the screen, from `at`.
fn shifted(view: &View, at: DVec2, by: Vec2) -> DVec2 {
    at + view.to_world(view.rect.center() + by) - view.to_world(view.rect.center())
}

/// E starts and ends reshaping, D, L and C start drawing, Escape ends both; Enter closes a drawing of clicks, Backspace
/// removes its last point. While reshaping, arrow keys move the selected handle, Delete or Backspace removes it, N
/// selects the next one and Shift+N the one before, both removing the focus from a control. No key acts while a
/// text field is focused.
pub fn keys(ui: &Ui, editor: &Editor, views: &PerSide<View>, actions: &mut Actions) {
    if ui.ctx().text_edit_focused() {
        // the text field gets the keys, and their releases too: end the drag now
        let held = editor.side().and_then(|side| editor.reshaping(side)?.held_by(Hold::Keys));
        actions.extend(held.map(|_| Action::Edit(EditAction::Release)));
        return;
    }
    let mut push = |action| actions.push(Action::Edit(action));
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let pointer = ui.input(|input| input.pointer.latest_pos());
    let over_target = pointer.is_some_and(|at| views[Side::Target].rect.contains(at));
    let meant = if over_target { Side::Target } else { Side::Source };
    if pressed(Key::E) {
        push(EditAction::Toggle(editor.reshaped_side().unwrap_or(meant)));
    }
    for (key, pen) in [(Key::D, Pen::Freehand), (Key::L, Pen::Lines), (Key::C, Pen::Curve)] {
        if pressed(key) {
            push(EditAction::Draw(meant, pen));
        }
    }
    let Some(side) = editor.side() else { return };
    if pressed(Key::Escape) {
        push(EditAction::Leave);
    }
    // a freehand stroke is closed by the release of the pointer
    if editor.drawing(side).is_some_and(|drawing| drawing.pen() != Pen::Freehand) {
        for (key, action) in [(Key::Enter, EditAction::Close), (Key::Backspace, EditAction::TakeBack)] {
            if pressed(key) {
                push(action);
            }
        }
    }
    let Some(reshaping) = editor.reshaping(side) else { return };
    let count = reshaping.shape().handle_count();
    let focused = ui.memory(egui::Memory::focused);
    if let Some(id) = focused.filter(|_| ui.input(|input| input.key_pressed(Key::N))) {
        ui.memory_mut(|memory| memory.surrender_focus(id));
    }
    // Shift first: the pattern without modifiers would match the shifted key too
    if ui.input_mut(|input| input.consume_key(Modifiers::SHIFT, Key::N)) {
        push(EditAction::Select(Some(reshaping.selected.map_or(0, |k| (k + count - 1) % count))));
    }
    if pressed(Key::N) {
        push(EditAction::Select(Some(reshaping.selected.map_or(0, |k| (k + 1) % count))));
    }
    let free = focused.is_none() && reshaping.grabbed().is_none();
    if let Some(selected) = reshaping.selected.filter(|_| free)
        && (pressed(Key::Delete) || pressed(Key::Backspace))
    {
        push(EditAction::Change(Change::Remove(selected)));
        return;
    }
    hold_by_keys(ui, reshaping, &views[side], focused.is_none(), actions);
}

/// Arrow keys drag the selected handle, from the first press until none of them is down. A drag starts only if
/// `free`: no control has the keyboard focus.
fn hold_by_keys(ui: &Ui, reshaping: &Reshaping, view: &View, free: bool, actions: &mut Actions) {
    let mut push = |action| actions.push(Action::Edit(action));
    let held = reshaping.held_by(Hold::Keys);
    let takes = free && reshaping.grabbed().is_none();
    let Some(handle) = held.or(reshaping.selected.filter(|_| takes)) else { return };
    let Some(at) = reshaping.shape().handle(handle) else { return };
    let [coarse, fine] = arrow_keys(ui);
    let by = KEY_STEP * coarse + FINE_KEY_STEP * fine;
    if held.is_none() && by == Vec2::ZERO {
        return;
    }
    if held.is_none() {
        push(EditAction::Grab(handle, Hold::Keys));
    }
    if by != Vec2::ZERO {
        push(EditAction::Drag(shifted(view, at, by)));
    }
    if !ui.input(|input| ARROWS.iter().any(|(key, _)| input.key_down(*key))) {
        push(EditAction::Release);
    }
}

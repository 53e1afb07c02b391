//! Keyboard control of the pictures: Tab focuses dots, the probe and viewports, arrow keys move the focused one.
//!
//! An interior dot and the probe move on the screen, a boundary dot along its boundary (right and up: counter-clockwise);
//! Shift makes the steps ten times smaller. In a viewport the arrow keys move the camera, `+` and `-` zoom, `0` fits.

use crate::app::input::handles::{GRAB_RADIUS, Handle, HandleKind, HandleState, Places, number};
use crate::app::input::locks::{Control, Locks};
use crate::conformal::Side;
use crate::language::{Label, key, say, tr};
use egui::{EventFilter, Id, Key, Modifiers, Pos2, Rect, Response, Role, Sense, Ui, Vec2, WidgetInfo, vec2};

/// A step of an interior dot on the screen, in points: coarse (about a dot's radius) and fine.
const STEPS: [f32; 2] = [10.0, 1.0];
/// A step of a boundary dot, as a fraction of the boundary's length: coarse and fine.
const FRACTIONS: [f64; 2] = [0.01, 0.001];
/// A step of the camera, in points.
const EYE_STEP: f32 = 40.0;
/// The zoom factor of one press of `+`.
const ZOOM_STEP: f32 = 1.25;

/// A step of a dot by the arrow keys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum KeyStep {
    /// The displacement on the screen, in points.
    Interior(Vec2),
    /// The displacement along the boundary, as a fraction of its length, counter-clockwise.
    Boundary(f64),
    /// A pin, counted from 0, and its displacement along the boundary.
    Pin(usize, f64),
    /// Delete or Backspace: remove a pin, counted from 0.
    RemovePin(usize),
    /// A mark, counted from 0, and its displacement along the boundary.
    Mark(usize, f64),
}

/// Scrolls to the control that has just got the keyboard focus, if it is in the scrolled content of `ui` and not wholly
/// visible. To be called after the content; a control outside of it is never clipped in these columns.
pub fn follow_focus(ui: &Ui) {
    let focused = ui.memory(egui::Memory::focused);
    let reached = focused.and_then(|id| ui.ctx().read_response(id)).filter(egui::Response::gained_focus);
    let Some(control) = reached else { return };
    let is_within = ui.min_rect().x_range().contains(control.rect.center().x);
    if is_within && control.layer_id == ui.layer_id() && control.interact_rect != control.rect {
        ui.scroll_to_rect(control.rect, None);
    }
}

/// Makes a side's dots focusable by Tab; returns the step of the focused one.
pub fn of_dots(ui: &Ui, side: Side, places: &Places, handles: &mut HandleState) -> Option<KeyStep> {
    let mut key_step = None;
    for &(kind, place) in places {
        let handle = Handle { side, kind };
        let station = Rect::from_center_size(place, Vec2::splat(2.0 * GRAB_RADIUS));
        let response = ui.interact(station, id_of(handle), Sense::focusable_noninteractive());
        response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, name(handle)));
        if response.has_focus() {
            handles.focused = Some(handle);
            handles.ever_dragged = true;
            let arrows = held_arrows(ui, &response);
            key_step = (arrows != [Vec2::ZERO; 2]).then(|| steps(kind, arrows)).or(removal(ui, kind)).or(key_step);
        } else if handles.focused == Some(handle) {
            handles.focused = None;
        }
    }
    key_step
}

/// Makes the circle of the probe focusable by Tab; returns the step of its center on the screen, in points.
pub fn of_probe(ui: &Ui, place: Pos2, handles: &mut HandleState) -> Option<Vec2> {
    let station = Rect::from_center_size(place, Vec2::splat(2.0 * GRAB_RADIUS));
    let response = ui.interact(station, Id::unique("probe"), Sense::focusable_noninteractive());
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, tr(key::probe())));
    handles.is_probe_focused = response.has_focus();
    if !handles.is_probe_focused {
        return None;
    }
    let [coarse, fine] = held_arrows(ui, &response);
    Some(STEPS[0] * coarse + STEPS[1] * fine).filter(|step| *step != Vec2::ZERO)
}

fn removal(ui: &Ui, kind: HandleKind) -> Option<KeyStep> {
    let HandleKind::Pin(pin) = kind else { return None };
    let pressed = ui.input(|input| input.key_pressed(Key::Delete) || input.key_pressed(Key::Backspace));
    pressed.then_some(KeyStep::RemovePin(pin.into()))
}

fn steps(kind: HandleKind, [coarse, fine]: [Vec2; 2]) -> KeyStep {
    let along = |arrow: Vec2| f64::from(arrow.x - arrow.y);
    let fraction = FRACTIONS[0] * along(coarse) + FRACTIONS[1] * along(fine);
    match kind {
        HandleKind::Interior => KeyStep::Interior(STEPS[0] * coarse + STEPS[1] * fine),
        HandleKind::Boundary => KeyStep::Boundary(fraction),
        HandleKind::Pin(pin) => KeyStep::Pin(pin.into(), fraction),
        HandleKind::Mark(mark) => KeyStep::Mark(mark.into(), fraction),
    }
}

/// A camera move by keys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EyeMove {
    /// Pan a planar view or orbit a surface, in points.
    Step(Vec2),
    /// Zoom in by this factor.
    Zoom(f32),
    /// Fit the whole outline or surface.
    Fit,
}

/// The camera move of the pressed keys, if the viewport of `side` is focused and the view is not locked.
pub fn of_viewport(ui: &Ui, response: &Response, side: Side, handles: &mut HandleState) -> Option<EyeMove> {
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, tr(viewport_name(side))));
    if !response.has_focus() || Locks::of(ui.ctx()).holds(Control::View) {
        handles.focused_view = handles.focused_view.filter(|focused| *focused != side);
        return None;
    }
    handles.focused_view = Some(side);
    let [plain, shifted] = held_arrows(ui, response);
    if plain + shifted != Vec2::ZERO {
        return Some(EyeMove::Step(EYE_STEP * (plain + shifted)));
    }
    let moves = [
        (Key::Plus, EyeMove::Zoom(ZOOM_STEP)),
        (Key::Equals, EyeMove::Zoom(ZOOM_STEP)),
        (Key::Minus, EyeMove::Zoom(1.0 / ZOOM_STEP)),
        (Key::Num0, EyeMove::Fit),
    ];
    ui.input(|input| moves.into_iter().find(|(key, _)| input.key_pressed(*key) && !input.modifiers.command))
        .map(|(_, wanted)| wanted)
}

/// The [`arrow_keys`] of the focused control, which are kept from moving the focus.
pub fn held_arrows(ui: &Ui, response: &Response) -> [Vec2; 2] {
    let ours = EventFilter { horizontal_arrows: true, vertical_arrows: true, tab: false, escape: false };
    if response.gained_focus() {
        // the filter takes effect in the second frame; in the first one an arrow key would move the focus
        ui.request_repaint();
    }
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, ours));
    arrow_keys(ui)
}

/// The arrow keys and their directions, y down.
pub const ARROWS: [(Key, Vec2); 4] = [
    (Key::ArrowRight, vec2(1.0, 0.0)),
    (Key::ArrowLeft, vec2(-1.0, 0.0)),
    (Key::ArrowUp, vec2(0.0, -1.0)),
    (Key::ArrowDown, vec2(0.0, 1.0)),
];

/// The arrow keys that were pressed in this frame, y down: without and with Shift.
pub fn arrow_keys(ui: &Ui) -> [Vec2; 2] {
    ui.input_mut(|input| {
        let mut sum = |modifiers| {
            let pressed = |(key, way)| input.count_and_consume_key(modifiers, key) as f32 * way;
            ARROWS.map(pressed).into_iter().fold(Vec2::ZERO, |sum, by| sum + by)
        };
        // Shift first: the pattern without modifiers would match a shifted arrow too
        let fine = sum(Modifiers::SHIFT);
        [sum(Modifiers::NONE), fine]
    })
}

/// The id of a dot's focusable area, the same in the plane and on a surface.
fn id_of(handle: Handle) -> Id {
    Id::unique(("dot", handle.side, handle.symbol()))
}

fn name(handle: Handle) -> String {
    let label = match (handle.kind, handle.side) {
        (HandleKind::Interior, Side::Source) => key::x1_interior_point_source(),
        (HandleKind::Interior, Side::Target) => key::x2_interior_point_target(),
        (HandleKind::Boundary, Side::Source) => key::y1_boundary_point_source(),
        (HandleKind::Boundary, Side::Target) => key::y2_boundary_point_target(),
        (HandleKind::Pin(k), side) => return say(&key::pin_of_side(number(k), side)),
        (HandleKind::Mark(k), side) => return say(&key::mark_of_side(number(k), side)),
    };
    String::from(tr(label))
}

fn viewport_name(side: Side) -> Label {
    match side {
        Side::Source => key::picture_source(),
        Side::Target => key::picture_target(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use crate::app::RiemapApp;
    use crate::app::tests::ready_app;
    use crate::conformal::Side;
    use egui::{Key, Modifiers};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    #[test]
    fn a_dot_that_was_just_reached_keeps_the_keyboard() {
        let mut harness = ready_app([1200.0, 800.0]);
        harness.get_by_label("x₁, interior point of the source").focus();
        harness.run(); // until no frame is requested
        for step in 1..=3 {
            let [x, _] = harness.state().stats().screen.handles.x1.unwrap();
            harness.key_press(Key::ArrowRight);
            harness.run_steps(2);
            let [u, _] = harness.state().stats().screen.handles.x1.unwrap();
            assert!((u - x - 10.0).abs() < 0.1, "step {step}: from {x} to {u}");
        }
    }

    fn focused<'a>(label: &str) -> Harness<'a, RiemapApp> {
        let mut harness = ready_app([1200.0, 800.0]);
        harness.get_by_label(label).focus();
        harness.run_steps(3);
        harness
    }

    #[test]
    fn arrow_keys_move_a_dot_and_shift_makes_the_step_fine() {
        let mut harness = focused("x₁, interior point of the source");
        let [x, y] = harness.state().stats().screen.handles.x1.unwrap();
        harness.key_press(Key::ArrowRight);
        harness.run_steps(3);
        let [u, v] = harness.state().stats().screen.handles.x1.unwrap();
        assert!((u - x - 10.0).abs() < 0.1 && (v - y).abs() < 0.1, "from {x}, {y} to {u}, {v}");
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowUp);
        harness.run_steps(3);
        let [s, t] = harness.state().stats().screen.handles.x1.unwrap();
        assert!((s - u).abs() < 0.1 && (v - t - 1.0).abs() < 0.1, "from {u}, {v} to {s}, {t}");
    }

    #[test]
    fn a_boundary_dot_moves_along_its_boundary_counter_clockwise_and_back() {
        let mut harness = focused("y₂, boundary point of the target");
        let at = |harness: &Harness<'_, RiemapApp>| harness.state().session().side(Side::Target).anchor();
        let start = at(&harness);
        harness.key_press(Key::ArrowUp);
        harness.run_steps(3);
        assert!((at(&harness) - start - 0.01).abs() < 1e-12);
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
        harness.run_steps(3);
        assert!((at(&harness) - start - 0.009).abs() < 1e-12);
    }

    #[test]
    fn a_viewport_that_has_the_keyboard_moves_zooms_and_fits() {
        let mut harness = focused("Picture of the source");
        let start = harness.state().stats().screen.handles.y1.unwrap();
        harness.key_press(Key::ArrowLeft);
        harness.run_steps(3);
        let moved = harness.state().stats().screen.handles.y1.unwrap();
        assert!((moved[0] - start[0] - 40.0).abs() < 0.1, "the eye goes left: {start:?}, {moved:?}");
        let before = harness.state().stats().screen.handles;
        harness.key_press(Key::Plus);
        harness.run_steps(3);
        let after = harness.state().stats().screen.handles;
        let apart = |(x, y): (Option<[f32; 2]>, Option<[f32; 2]>)| (y.unwrap()[1] - x.unwrap()[1]).abs();
        let ratio = apart((after.x1, after.y1)) / apart((before.x1, before.y1));
        assert!((ratio - 1.25).abs() < 0.01, "zoomed by {ratio}");
        harness.key_press(Key::Num0);
        harness.run_steps(3);
        assert_eq!(harness.state().stats().screen.handles.y1.unwrap(), start);
    }
}

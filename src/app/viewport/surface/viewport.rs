//! The surface's viewport: its gestures, and what is painted over it.
//!
//! As in the planar `viewport` a frame goes through it twice, and dots win over the eye: what does
//! not grab a dot turns the surface, two fingers or the other buttons move it.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::{Handle, HandleKind, HandleState, Places};
use crate::app::input::keyboard_navigation;
use crate::app::input::keyboard_navigation::EyeMove;
use crate::app::input::locks::{Control, Locks};
use crate::app::theme::{Palette, is_animated};
use crate::app::viewport::best;
use crate::app::viewport::dots;
use crate::app::viewport::dots::Dot;
use crate::app::viewport::gpu::ViewportCallback;
use crate::app::viewport::moves;
use crate::app::viewport::picture::Picture;
use crate::app::viewport::pins;
use crate::app::viewport::planar::{BOUNDARY_REACH, ZOOM_PER_POINT};
use crate::app::viewport::surface::{OrbitView, loops};
use crate::conformal::{InteriorPoint, Side};
use crate::geometry::DVec3;
use crate::model::Model;
use crate::model::best::Aim;
use crate::render::{CellStyle, Pace, SpaceFrame, StrokeStyle, TextureStyle};
use crate::surface::nearest_on_boundary_to_ray;
use egui::{CornerRadius, CursorIcon, PointerButton, Pos2, Response, Sense, Ui, Vec2};

/// How near the ray passages of the loop compete for the boundary handle, as a tangent: 14 points at arm's length.
const REACH: f64 = 0.015;

/// Turns gestures into commands and moves of the eye. Returns the boundary point under the
/// pointer, as a fraction of the loop's length.
pub fn interact(
    ui: &mut Ui,
    side: Side,
    model: &Model,
    view: &mut OrbitView,
    handles: &mut HandleState,
    actions: &mut Actions,
) -> Option<f64> {
    let response = ui.interact(view.rect, ui.scope_id().with(("orbit", side)), Sense::click_and_drag());
    if pinch(ui, &response, view, handles) {
        return None;
    }
    let places = places(side, model, view);
    let held_dot = handles.grip.is_some();
    dots::grab_and_release(ui, &response, side, &places, handles);
    drag_handle(ui, side, model, view, handles, actions);
    if let Some(key_step) = keyboard_navigation::of_dots(ui, side, &places, handles) {
        let interior = |step| point_at(side, model, view, view.to_screen(model.surface_point(side)?)? + step);
        actions.extend(moves::stepped(model, side, key_step, interior).map(Action::Session));
    }
    if !held_dot {
        loops::interact(ui, &response, (side, model), view, handles, actions);
    }
    let boundary = boundary_under_pointer(&response, side, model, view, handles);
    let adds_pin = pins::add(ui, &response, side, model, boundary, actions);
    let is_busy = handles.grip.is_some() || handles.hovered.is_some();
    let place = |at| place_at(side, model, view, at);
    if !best::paint_region(ui, (&response, side), model, is_busy, place, actions) {
        move_eye(ui, &response, view, handles, !adds_pin);
    }
    match keyboard_navigation::of_viewport(ui, &response, side, handles) {
        Some(EyeMove::Step(step)) => view.turn(-step),
        Some(EyeMove::Zoom(factor)) => view.zoom(factor, view.rect.center()),
        Some(EyeMove::Fit) => view.fit(),
        None => {}
    }
    boundary
}

/// Two fingers: pan and zoom, and let go of what one finger had. Returns whether there are two.
fn pinch(ui: &Ui, response: &Response, view: &mut OrbitView, handles: &mut HandleState) -> bool {
    let Some(touch) = ui.input(egui::InputState::multi_touch) else { return false };
    if !response.rect.contains(touch.center_pos) {
        return false;
    }
    handles.release();
    if Locks::of(ui.ctx()).holds(Control::View) {
        return true;
    }
    view.let_spin(Vec2::ZERO);
    view.pan(touch.translation_delta);
    view.zoom(touch.zoom_delta, touch.center_pos);
    true
}

fn drag_handle(ui: &Ui, side: Side, model: &Model, view: &OrbitView, handles: &HandleState, actions: &mut Actions) {
    let Some((handle, at)) = moves::dragged(ui, side, handles) else { return };
    let command = moves::moved(handle, || point_at(side, model, view, at), || anchor_at(side, model, view, at));
    actions.extend(command.map(Action::Session));
}

/// The interior point for a pointer at `at`: the surface point under it; if `at` is beside the surface, to the
/// point nearest to the ray at the depth of the present one.
fn point_at(side: Side, model: &Model, view: &OrbitView, at: Pos2) -> Option<InteriorPoint> {
    let (surface, _) = model.surface(side)?;
    let (eye, direction) = view.ray(at)?;
    let tree = surface.surface()?.tree();
    let hit = tree.ray(eye, direction).or_else(|| {
        let depth = (model.surface_point(side)? - eye).dot(direction);
        tree.nearest(eye + depth * direction)
    });
    surface.interior_near(hit?.0).map(Into::into)
}

/// The place of the surface under the pointer.
fn place_at(side: Side, model: &Model, view: &OrbitView, at: Pos2) -> Option<DVec3> {
    let surface = model.surface(side)?.0.surface()?;
    let (eye, direction) = view.ray(at)?;
    surface.tree().ray(eye, direction).map(|(point, _)| surface.position(point))
}

/// Draws the painted region over the triangles that face the eye.
pub fn paint_region(ui: &Ui, side: Side, model: &Model, view: &OrbitView) {
    let Some((surface, camera)) = model.surface(side).and_then(|it| it.0.surface()).zip(view.camera()) else { return };
    if side != Side::Source || model.best().aim() != Aim::Region {
        return;
    }
    let (mesh, eye) = (surface.mesh(), camera.eye());
    let on_screen = |t: usize| {
        let [a, b, c] = mesh.triangles()[t].map(|v| mesh.vertices()[v as usize]);
        let faces = (b - a).cross(c - a).dot(eye - a) > 0.0;
        Some([view.to_screen(a)?, view.to_screen(b)?, view.to_screen(c)?]).filter(|_| faces)
    };
    best::paint_triangles(ui, view.rect, model, mesh.triangles().len(), on_screen);
}

fn anchor_at(side: Side, model: &Model, view: &OrbitView, at: Pos2) -> Option<f64> {
    let surface = model.surface(side)?.0.surface()?;
    let (eye, direction) = view.ray(at)?;
    Some(surface.fraction_at(nearest_on_boundary_to_ray(surface.mesh(), eye, direction, REACH)?))
}

fn move_eye(ui: &Ui, response: &Response, view: &mut OrbitView, handles: &HandleState, fits: bool) {
    if Locks::of(ui.ctx()).holds(Control::View) {
        return;
    }
    let (shift, seconds, speed) =
        ui.input(|input| (input.modifiers.shift, input.stable_dt.min(0.1), input.pointer.velocity()));
    if handles.grip.is_some() {
        view.let_spin(Vec2::ZERO);
    } else if response.dragged() {
        let pans = shift || !response.dragged_by(PointerButton::Primary);
        view.let_spin(Vec2::ZERO);
        if pans {
            view.pan(response.drag_delta());
        } else {
            view.turn(response.drag_delta());
        }
        ui.set_cursor_icon(if pans { CursorIcon::Move } else { CursorIcon::AllScroll });
    } else if response.drag_stopped_by(PointerButton::Primary) && !shift {
        view.let_spin(if is_animated(ui) { speed } else { Vec2::ZERO });
    }
    if view.spin(seconds) {
        ui.request_repaint();
    }
    if response.double_clicked() && handles.hovered.is_none() && fits {
        view.fit();
    }
    if let Some(pointer) = response.hover_pos() {
        let (scroll, zoom) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        view.zoom(zoom * (ZOOM_PER_POINT * scroll).exp(), pointer);
    }
}

fn boundary_under_pointer(
    response: &Response,
    side: Side,
    model: &Model,
    view: &OrbitView,
    handles: &HandleState,
) -> Option<f64> {
    let pointer = response.hover_pos().filter(|_| handles.grip.is_none() && handles.hovered.is_none())?;
    let surface = model.surface(side)?.0.surface()?;
    let fraction = anchor_at(side, model, view, pointer)?;
    let place = view.to_screen(surface.boundary_position(surface.at_fraction(fraction)))?;
    (place.distance(pointer) <= BOUNDARY_REACH).then_some(fraction)
}

/// Draws the textured surface.
pub fn paint_surface(
    ui: &Ui,
    side: Side,
    view: &OrbitView,
    style: Option<&TextureStyle>,
    cells: Option<CellStyle>,
    pace: Pace,
) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(view.rect);
    let (Some(style), Some(camera)) = (style, view.camera()) else {
        painter.rect_filled(view.rect, CornerRadius::ZERO, palette.canvas);
        return;
    };
    let frame = SpaceFrame {
        size_px: view.size_px(),
        camera: *camera,
        style: *style,
        cells,
        stroke: StrokeStyle::themed(ui.visuals().dark_mode, ui.pixels_per_point()),
        background: palette.canvas.to_normalized_gamma_f32(),
    };
    let callback = ViewportCallback { side, frame: Picture::Space(frame), pace, context: ui.ctx().clone() };
    painter.add(egui_wgpu::Callback::new_paint_callback(view.rect, callback));
}

/// Draws the dots, over everything else in the viewport; fainter where the surface hides them.
pub fn paint_dots(ui: &Ui, side: Side, model: &Model, view: &OrbitView, handles: &HandleState) {
    let painter = ui.painter_at(view.rect);
    pins::paint_misses(&painter, side, model, |fraction| {
        let surface = model.surface(side)?.0.surface()?;
        view.to_screen(surface.boundary_position(surface.at_fraction(fraction)))
    });
    for (kind, point) in points(side, model).into_iter().rev() {
        let Some(dot) = dot(side, model, view, point) else { continue };
        let handle = Handle { side, kind };
        let words = || dots::coordinates(handle, &point.to_array());
        dots::paint(ui, &painter, handle, dot, handles, &words);
    }
}

/// The dots of a side: its two points, or its pins.
fn points(side: Side, model: &Model) -> Vec<(HandleKind, DVec3)> {
    moves::dots(model, side, [model.surface_point(side), model.surface_anchor(side)], |fraction| {
        let surface = model.surface(side)?.0.surface()?;
        Some(surface.boundary_position(surface.at_fraction(fraction)))
    })
}

/// Where the dots of a side are on the screen.
pub fn places(side: Side, model: &Model, view: &OrbitView) -> Places {
    points(side, model).into_iter().filter_map(|(kind, point)| Some((kind, view.to_screen(point)?))).collect()
}

fn dot(side: Side, model: &Model, view: &OrbitView, point: DVec3) -> Option<Dot> {
    let eye = view.camera()?.eye();
    let surface = model.surface(side)?.0.surface()?;
    let hidden = surface.tree_if_made().is_some_and(|tree| tree.hides(eye, point));
    Some(Dot { place: view.to_screen(point)?, hidden })
}

/// Draws the mark at a fraction of the loop's length.
pub fn paint_boundary_mark(ui: &Ui, side: Side, model: &Model, view: &OrbitView, fraction: f64) {
    let Some(surface) = model.surface(side).and_then(|(surface, _)| surface.surface()) else { return };
    if let Some(place) = view.to_screen(surface.boundary_position(surface.at_fraction(fraction))) {
        dots::paint_mark(ui, &ui.painter_at(view.rect), side, place);
    }
}

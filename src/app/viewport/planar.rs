//! A planar viewport: its gestures, and what is painted over the mesh.
//!
//! A frame visits a viewport twice: [`interact`] turns gestures into commands and
//! camera moves; after the map has been updated, [`paint_mesh`], [`paint_dots`] and the
//! other functions draw it, so that a dragged dot never lags behind the pointer.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::{DOT_RADIUS, Handle, HandleKind, HandleState, Places, Pointed};
use crate::app::input::keyboard_navigation;
use crate::app::input::keyboard_navigation::EyeMove;
use crate::app::input::locks::{Control, Locks};
use crate::app::input::snapping;
use crate::app::input::snapping::Catch;
use crate::app::theme::Palette;
use crate::app::theme::widgets::caption_font;
use crate::app::viewport::best;
use crate::app::viewport::corners;
use crate::app::viewport::dots;
use crate::app::viewport::dots::Dot;
use crate::app::viewport::gpu::ViewportCallback;
use crate::app::viewport::marks;
use crate::app::viewport::moves;
use crate::app::viewport::picture::Picture;
use crate::app::viewport::picture_gestures;
use crate::app::viewport::pins;
use crate::app::viewport::probe;
use crate::app::viewport::symmetry;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::{key, tr};
use crate::model::Model;
use crate::platform::STAGES_SHOWN_AFTER;
use crate::render::{Pace, PlanarFrame, TextureStyle};
use egui::{Align2, Color32, CornerRadius, CursorIcon, Rect, Response, Sense, Stroke, StrokeKind, Ui, vec2};

/// Zoom per point of scrolling: one notch of a wheel (50 points) zooms by 13 %.
pub const ZOOM_PER_POINT: f32 = 0.0025;

/// The distance from the boundary within which the pointer hits it, in points.
pub const BOUNDARY_REACH: f32 = 14.0;

/// The radius of the mark of an image, in points.
const IMAGE_RADIUS: f32 = 6.0;

/// Turns gestures over the viewport into commands and camera moves. Returns the boundary
/// point under the pointer, as a fraction of arc length.
pub fn interact(
    ui: &mut Ui,
    side: Side,
    model: &Model,
    view: &mut View,
    handles: &mut HandleState,
    actions: &mut Actions,
) -> Option<f64> {
    let response = ui.interact(view.rect, ui.scope_id().with(("viewport", side)), Sense::click_and_drag());
    let places_picture = picture_gestures::is_active(ui.ctx(), side, model);
    let has_two_fingers = if places_picture {
        picture_gestures::pinch(ui, &response, side, model, view, actions)
    } else {
        pinch(ui, &response, view)
    };
    if has_two_fingers {
        handles.release();
        return None;
    }
    drag_dots(ui, &response, side, model, view, handles, actions);
    let on_probe = probe::interact(ui, &response, side, model, view, handles);
    let is_held = handles.grip.is_some() || on_probe.is_held;
    let is_busy = is_held || handles.hovered.is_some();
    let plane = |at| Some(view.to_world(at).extend(0.0));
    let is_taken = best::paint_region(ui, (&response, side), model, is_busy, plane, actions)
        || best::follow_landscape(ui, (&response, side), (model, view), is_busy, actions);
    let is_held = is_held || is_taken;
    let boundary = boundary_under_pointer(&response, side, model, view, handles);
    let adds_pin = pins::add(ui, &response, side, model, boundary, actions);
    if places_picture {
        picture_gestures::drag(ui, &response, side, model, view, is_held, actions);
    } else {
        move_camera(ui, &response, view, is_held, handles.hovered.is_none() && !adds_pin);
    }
    let is_over = handles.grip.is_some() || handles.hovered.is_some() || on_probe.is_over;
    corners::interact(ui, &response, side, model, view, is_over, actions);
    match keyboard_navigation::of_viewport(ui, &response, side, handles) {
        Some(EyeMove::Step(step)) => view.pan(-step),
        Some(EyeMove::Zoom(factor)) => view.zoom(factor, view.rect.center()),
        Some(EyeMove::Fit) => view.fit(),
        None => {}
    }
    if !on_probe.is_over {
        point_at(ui, &response, side, view, handles);
    }
    boundary
}

/// Notes the point under a pointer that hovers, or the one that is clicked; none while a button is down.
fn point_at(ui: &Ui, response: &Response, side: Side, view: &View, handles: &mut HandleState) {
    let is_down = ui.input(|input| input.pointer.any_down());
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
    let hover = response.hover_pos().filter(|_| !is_down && handles.hovered.is_none());
    if let Some(place) = clicked.or(hover) {
        let decimals = view.decimals();
        let unit = 10_f64.powi(decimals as i32);
        let point = (view.to_world(place) * unit).round() / unit;
        handles.pointed = Some(Pointed { side, point, decimals, stays: clicked.is_some() });
    } else if handles.pointed.is_some_and(|pointed| is_down || (pointed.side == side && !pointed.stays)) {
        handles.pointed = None;
    }
}

/// Draws the image of the point under the pointer of the other picture.
pub fn paint_image_mark(ui: &Ui, view: &View, image: DVec2) {
    let place = view.to_screen(image);
    let painter = ui.painter_at(view.rect);
    for (width, ink) in [(4.0, Color32::from_black_alpha(150)), (2.0, Color32::WHITE)] {
        painter.circle_stroke(place, IMAGE_RADIUS, Stroke::new(width, ink));
        painter.circle_filled(place, 0.5 * width, ink);
    }
}

/// The dots of a side: its two points, or its pins.
fn points(side: Side, model: &Model) -> Vec<(HandleKind, DVec2)> {
    moves::dots(model, side, [model.interior(side), model.anchor(side)], |fraction| {
        let samples = model.domain(side)?.samples();
        Some(samples.position(samples.at_fraction(fraction)))
    })
}

/// Where the dots of a side are on the screen.
pub fn places(side: Side, model: &Model, view: &View) -> Places {
    points(side, model).into_iter().map(|(kind, point)| (kind, view.to_screen(point))).collect()
}

/// Grabs, drags and releases the side's dots and marks, or moves them by keys.
pub fn drag_dots(
    ui: &Ui,
    response: &Response,
    side: Side,
    model: &Model,
    view: &View,
    handles: &mut HandleState,
    actions: &mut Actions,
) {
    let mut places = places(side, model, view);
    places.extend(marks::places(side, model, view));
    let held = handles.grip;
    dots::grab_and_release(ui, response, side, &places, handles);
    if handles.grip != held {
        marks::hold_by_foot(side, model, view, handles);
    }
    drag_handle(ui, side, model, view, handles, actions);
    if let Some(key_step) = keyboard_navigation::of_dots(ui, side, &places, handles) {
        let interior = |step| {
            let at = view.to_world(view.to_screen(model.interior(side)?) + step);
            model.interior_near(side, at).map(Into::into)
        };
        actions.extend(moves::stepped(model, side, key_step, interior).map(Action::Session));
    }
}

fn boundary_under_pointer(
    response: &Response,
    side: Side,
    model: &Model,
    view: &View,
    handles: &HandleState,
) -> Option<f64> {
    let pointer = response.hover_pos().filter(|_| handles.grip.is_none() && handles.hovered.is_none())?;
    let samples = model.domain(side)?.samples();
    let nearest = samples.nearest(view.to_world(pointer));
    let near = view.to_screen(samples.position(nearest)).distance(pointer) <= BOUNDARY_REACH;
    near.then(|| samples.fraction_at(nearest))
}

/// Pans and zooms with two fingers. Returns whether there are two; the caller then ends the drag of one finger.
pub fn pinch(ui: &Ui, response: &Response, view: &mut View) -> bool {
    let Some(touch) = ui.input(egui::InputState::multi_touch) else { return false };
    if !response.rect.contains(touch.center_pos) {
        return false;
    }
    if Locks::of(ui.ctx()).holds(Control::View) {
        return true;
    }
    view.pan(touch.translation_delta);
    view.zoom(touch.zoom_delta, touch.center_pos);
    true
}

fn drag_handle(ui: &Ui, side: Side, model: &Model, view: &View, handles: &mut HandleState, actions: &mut Actions) {
    let Some((handle, at)) = moves::dragged(ui, side, handles) else { return };
    let pointed = view.to_world(at);
    let catch = caught(ui, handle, pointed, model, view, handles);
    handles.caught = catch.map(|catch| (handle, catch));
    let at = catch.map_or(pointed, |catch| catch.place);
    let interior = || model.interior_near(side, at).map(Into::into);
    actions.extend(moves::moved(handle, interior, || model.anchor_near(side, at)).map(Action::Session));
}

/// What catches a dot that is dragged to `at`.
fn caught(
    ui: &Ui,
    Handle { side, kind }: Handle,
    at: DVec2,
    model: &Model,
    view: &View,
    handles: &mut HandleState,
) -> Option<Catch> {
    let found = model.symmetries(side).and_then(|found| found.as_ref().ok());
    let reach = snapping::reach(ui);
    let distance = |a, b| view.to_screen(a).distance(view.to_screen(b));
    if kind == HandleKind::Interior {
        let is_inside = |catch: &Catch| model.interior_near(side, catch.place) == Some(catch.place);
        return snapping::of_interior(found?, at, reach, distance).find(is_inside);
    }
    let samples = model.domain(side)?.samples();
    let nearest = samples.nearest(at);
    let (on_boundary, fraction) = (samples.position(nearest), samples.fraction_at(nearest));
    let corners = handles.corners.get_or_insert_with(|| model.corner_places(side));
    let length = distance(DVec2::ZERO, DVec2::X) * samples.edge_lengths().iter().sum::<f64>() as f32;
    let along = |place| {
        let way = (samples.fraction_at(samples.nearest(place)) - fraction).rem_euclid(1.0);
        length * way.min(1.0 - way) as f32
    };
    snapping::of_boundary(found, corners, on_boundary, reach, distance, along)
}

/// Pans by dragging, unless something in the picture is `held`, and zooms by scrolling. A double-click fits the outline
/// if `fits`.
pub fn move_camera(ui: &Ui, response: &Response, view: &mut View, held: bool, fits: bool) {
    if Locks::of(ui.ctx()).holds(Control::View) {
        return;
    }
    if response.dragged() && !held {
        view.pan(response.drag_delta());
        ui.set_cursor_icon(CursorIcon::Move);
    }
    if response.double_clicked() && fits {
        view.fit();
    }
    if let Some(pointer) = response.hover_pos() {
        let (scroll, zoom) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        view.zoom(zoom * (ZOOM_PER_POINT * scroll).exp(), pointer);
    }
}

/// Draws the textured mesh; without a style, only the background.
pub fn paint_mesh(ui: &Ui, side: Side, view: &View, style: Option<&TextureStyle>, pace: Pace) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(view.rect);
    let Some(style) = style else {
        painter.rect_filled(view.rect, CornerRadius::ZERO, palette.canvas);
        return;
    };
    let frame = PlanarFrame {
        size_px: view.size_px(),
        camera: view.camera(),
        style: *style,
        background: palette.canvas.to_normalized_gamma_f32(),
    };
    let callback = ViewportCallback { side, frame: Picture::Plane(frame), pace, context: ui.ctx().clone() };
    painter.add(egui_wgpu::Callback::new_paint_callback(view.rect, callback));
}

/// Draws the dots, over all other content of the viewport.
pub fn paint_dots(ui: &Ui, side: Side, model: &Model, view: &View, handles: &HandleState) {
    symmetry::paint(ui, side, model, view, handles);
    corners::paint(ui, side, model, view);
    marks::paint(ui, side, model, view, handles);
    let painter = ui.painter_at(view.rect);
    pins::paint_misses(&painter, side, model, |fraction| {
        let samples = model.domain(side)?.samples();
        Some(view.to_screen(samples.position(samples.at_fraction(fraction))))
    });
    for (kind, point) in points(side, model).into_iter().rev() {
        let handle = Handle { side, kind };
        let words = || dots::words(side, model, handles, handle, &point.to_array());
        dots::paint(ui, &painter, handle, Dot { place: view.to_screen(point), hidden: false }, handles, &words);
    }
}

/// Draws the focus frame if the viewport has the keyboard focus.
pub fn paint_focus(ui: &Ui, side: Side, rect: Rect, handles: &HandleState) {
    if handles.focused_view == Some(side) {
        let ring = Stroke::new(2.0, Palette::of(ui.visuals()).accent_soft);
        ui.painter().rect_stroke(rect.shrink(3.0), CornerRadius::same(6), ring, StrokeKind::Inside);
    }
}

/// Draws the mark at a fraction of the boundary's arc length.
pub fn paint_boundary_mark(ui: &Ui, side: Side, model: &Model, view: &View, fraction: f64) {
    let Some(domain) = model.domain(side) else { return };
    let samples = domain.samples();
    let place = view.to_screen(samples.position(samples.at_fraction(fraction)));
    dots::paint_mark(ui, &ui.painter_at(view.rect), side, place);
}

/// A picture lower than this has a small hint, which leaves most of the shape in sight.
const LOW: f32 = 260.0;

/// Draws the hint "drag a dot" below the first dot that is not locked.
pub fn paint_hint(ui: &Ui, rect: Rect, places: &Places) {
    let locks = Locks::of(ui.ctx());
    let mut free = places.iter().filter(|(kind, _)| !locks.holds_handle(*kind));
    let Some(&(_, place)) = free.next() else { return };
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(rect);
    let is_low = rect.height() < LOW;
    let galley = painter.layout_no_wrap(
        String::from(tr(key::drag_dot())),
        if is_low { caption_font(ui) } else { egui::TextStyle::Body.resolve(ui.style()) },
        palette.on_accent,
    );
    let size = galley.size() + if is_low { vec2(12.0, 4.0) } else { vec2(22.0, 12.0) };
    let label = Rect::from_center_size(place + vec2(0.0, DOT_RADIUS + 14.0 + 0.5 * size.y), size);
    let tip = label.center_top() - vec2(0.0, 6.0);
    let base = [label.center_top() + vec2(-6.0, 0.5), label.center_top() + vec2(6.0, 0.5)];
    painter.rect_filled(label, CornerRadius::same(8), palette.accent);
    painter.add(egui::Shape::convex_polygon(vec![tip, base[1], base[0]], palette.accent, Stroke::NONE));
    painter.galley(label.center() - 0.5 * galley.size(), galley, palette.on_accent);
}

/// Draws the progress of a preparation: a thin line along the upper edge, and the name of the stage near the lower one.
/// Nothing is drawn for the first [`STAGES_SHOWN_AFTER`] seconds.
pub fn paint_progress(ui: &Ui, side: Side, model: &Model, rect: Rect) {
    let Some((stage, seconds)) = model.worker_stage(side) else { return };
    let left = f64::from(STAGES_SHOWN_AFTER) - seconds;
    if left > 0.0 {
        ui.ctx().request_repaint_after_secs(left as f32);
        return;
    }
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(rect);
    let (done, name) = crate::app::language::words::stage(stage);
    let done = ui.ctx().animate_value_with_time(ui.scope_id().with(("progress", side)), done, 0.15);
    let line = Rect::from_min_size(rect.min, vec2(rect.width(), 3.0));
    painter.rect_filled(line, CornerRadius::ZERO, palette.border);
    let filled = Rect::from_min_size(line.min, vec2(line.width() * done, 3.0));
    painter.rect_filled(filled, CornerRadius::ZERO, palette.accent_soft);
    let place = rect.center_bottom() - vec2(0.0, 40.0);
    painter.text(place, Align2::CENTER_CENTER, name, caption_font(ui), palette.weak);
}

/// Draws what dropping would do, while a file is dragged over the viewport.
pub fn paint_drop_target(ui: &Ui, rect: Rect) {
    let over = crate::platform::drop_position(ui.ctx()).is_some_and(|place| rect.contains(place));
    if !over || ui.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(rect);
    let ground = palette.accent.gamma_multiply(0.25);
    let edge = Stroke::new(2.0, palette.accent_soft);
    painter.rect(rect.shrink(6.0), CornerRadius::same(10), ground, edge, StrokeKind::Inside);
    let galley = painter.layout(
        tr(key::drop_for_side()).into(),
        egui::TextStyle::Body.resolve(ui.style()),
        palette.text,
        rect.width() - 60.0,
    );
    let label = Rect::from_center_size(rect.center(), galley.size() + vec2(24.0, 16.0));
    painter.rect_filled(label, CornerRadius::same(8), palette.raised);
    painter.galley(label.min + vec2(12.0, 8.0), galley, palette.text);
}

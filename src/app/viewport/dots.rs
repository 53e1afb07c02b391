//! Grabbing, releasing and painting the dots, in planar viewports and on surfaces.

use crate::app::input::handles::{DOT_RADIUS, GRAB_RADIUS, Handle, HandleKind, HandleState, Places, hit};
use crate::app::input::locks::Locks;
use crate::app::plots::Plots;
use crate::app::theme::widgets::caption_font;
use crate::app::theme::{Palette, bold, is_animated};
use crate::conformal::Side;
use crate::language::{self, Label, Language, key, number, tr};
use crate::model::Model;
use egui::emath::GuiRounding;
use egui::{
    Align2, Color32, CornerRadius, CursorIcon, Painter, Pos2, Rect, Response, Stroke, StrokeKind, Ui, Vec2, vec2,
};

/// The opacity of a dot behind the surface.
const HIDDEN_STRENGTH: f32 = 0.4;

/// The size of a pin's number, in points.
const NUMBER: f32 = 11.0;

/// The place of a dot on the screen.
#[derive(Debug, Clone, Copy)]
pub struct Dot {
    /// The dot's center.
    pub place: Pos2,
    /// Whether the surface occludes the dot.
    pub hidden: bool,
}

/// Starts dragging the dot under a pressed pointer, ends the drag on release, and updates hover state and cursor.
/// Locked dots are not hit.
pub fn grab_and_release(ui: &Ui, response: &Response, side: Side, places: &Places, handles: &mut HandleState) {
    let (pressed, down, pointer, now) = ui.input(|input| {
        let pointer = &input.pointer;
        (pointer.primary_pressed(), pointer.primary_down(), pointer.interact_pos(), input.time)
    });
    let locks = Locks::of(ui.ctx());
    let under = pointer.filter(|_| response.hovered()).and_then(|pointer| hit(side, places, pointer));
    let under = under.filter(|(handle, _)| !locks.holds_handle(handle.kind));
    if let (true, Some((handle, place)), Some(pointer)) = (pressed, under, pointer) {
        handles.grab(handle, place, pointer, now);
        // grabbing a dot with the pointer takes the keyboard focus away from the focused control
        ui.memory_mut(|memory| memory.focused().inspect(|id| memory.surrender_focus(*id)));
    }
    if !down && handles.grip.is_some_and(|grip| grip.handle.side == side) {
        handles.release();
    }
    if handles.hovered.is_none_or(|hovered| hovered.side == side) {
        handles.hovered = under.map(|(handle, _)| handle);
    }
    if handles.grip.is_some() {
        ui.set_cursor_icon(CursorIcon::Grabbing);
    } else if let Some((handle, _)) = under {
        ui.set_cursor_icon(CursorIcon::Grab);
        response.clone().on_hover_text_at_pointer(tr(explanation(handle)));
    }
}

/// What a dot stands for, in a sentence.
pub fn explanation(handle: Handle) -> Label {
    match (handle.kind, handle.side) {
        (HandleKind::Interior, Side::Source) => key::explain_x1(),
        (HandleKind::Interior, Side::Target) => key::explain_x2(),
        (HandleKind::Boundary, Side::Source) => key::explain_y1(),
        (HandleKind::Boundary, Side::Target) => key::explain_y2(),
        (HandleKind::Pin(_), _) => key::explain_pin(),
        (HandleKind::Mark(_), _) => key::explain_mark(),
    }
}

/// Paints a dot; while it is dragged or focused, with `words` beside it.
pub fn paint(ui: &Ui, painter: &Painter, handle: Handle, dot: Dot, handles: &HandleState, words: &dyn Fn() -> String) {
    // egui draws small discs from a texture, aligned to pixels, and large ones unaligned: align all of them.
    let place = dot.place.round_to_pixels(ui.pixels_per_point());
    let strength = if dot.hidden { HIDDEN_STRENGTH } else { 1.0 };
    let colour = handle.kind.colour();
    let now = ui.input(|input| input.time);
    if let Some(progress) = handles.pulse_of(handle, now).filter(|_| is_animated(ui)) {
        let radius = DOT_RADIUS + 24.0 * progress;
        painter.circle_stroke(place, radius, Stroke::new(3.0 * (1.0 - progress), colour));
        ui.request_repaint();
    }
    let raised = ui.ctx().animate_bool_with_time(
        ui.scope_id().with((handle.side, handle.symbol())),
        handles.is_raised(handle),
        if is_animated(ui) { 0.1 } else { 0.0 },
    );
    let radius = DOT_RADIUS + 3.0 * raised;
    painter.circle_filled(place + vec2(0.0, 1.0), radius + 3.0, Color32::from_black_alpha(70).gamma_multiply(strength));
    painter.circle_filled(place, radius + 1.0, Color32::WHITE.gamma_multiply(strength));
    painter.circle_filled(place, radius - 1.5, colour.gamma_multiply(strength));
    if let HandleKind::Pin(_) = handle.kind {
        let ink = Color32::WHITE.gamma_multiply(strength);
        painter.text(place, Align2::CENTER_CENTER, handle.symbol(), bold(NUMBER), ink);
    }
    if handles.focused == Some(handle) {
        painter.circle_stroke(place, radius + 5.0, Stroke::new(2.0, Palette::of(ui.visuals()).accent_soft));
    }
    if handles.is_held(handle) || handles.focused == Some(handle) {
        paint_words(ui, painter, words(), place);
    }
}

/// The coordinates of a dot of an outline, and what has caught it.
pub fn words(side: Side, model: &Model, handles: &HandleState, handle: Handle, place: &[f64]) -> String {
    let catch = handles.held_catch().filter(|(held, _)| *held == handle);
    let found = model.symmetries(side).and_then(|found| found.as_ref().ok());
    let caught = catch.and_then(|(_, catch)| catch.by.words(found));
    coordinates(handle, place) + &caught.map(|by| format!(" · {by}")).unwrap_or_default()
}

/// The symbol and the coordinates of a dot; the decimal comma needs a semicolon between them.
pub fn coordinates(handle: Handle, place: &[f64]) -> String {
    let between = if language::current() == Language::German { "; " } else { ", " };
    // −0.0001 is written as 0
    let written = |coordinate: &f64| number((1e3 * coordinate).round() / 1e3 + 0.0, 3);
    let place = place.iter().map(written).collect::<Vec<_>>().join(between);
    format!("{} = ({place})", handle.symbol())
}

/// Paints the mark of the boundary point under the pointer, or of the corresponding one.
pub fn paint_mark(ui: &Ui, painter: &Painter, side: Side, place: Pos2) {
    let place = place.round_to_pixels(ui.pixels_per_point());
    painter.circle_filled(place + vec2(0.0, 1.0), 8.0, Color32::from_black_alpha(70));
    painter.circle_filled(place, 6.5, Color32::WHITE);
    painter.circle_filled(place, 4.5, Plots::inks(ui.visuals().dark_mode)[side]);
}

/// Paints words above a place, or below it where there is no room.
pub fn paint_words(ui: &Ui, painter: &Painter, words: String, place: Pos2) {
    paint_words_beside(ui, painter, words, Rect::from_center_size(place, Vec2::ZERO), &[]);
}

/// Paints words above `what`, or where they cover none of the dots and have room: below, at the right or at the left.
pub fn paint_words_beside(ui: &Ui, painter: &Painter, words: String, what: Rect, dots: &[Pos2]) {
    let palette = Palette::of(ui.visuals());
    let galley = painter.layout_no_wrap(words, caption_font(ui), palette.text);
    let label = label_place(galley.size() + vec2(16.0, 8.0), painter.clip_rect().shrink(6.0), what, dots);
    painter.rect(label, CornerRadius::same(6), palette.raised, Stroke::new(1.0, palette.border), StrokeKind::Inside);
    painter.galley(label.min + vec2(8.0, 4.0), galley, palette.text);
}

fn label_place(size: Vec2, clip: Rect, what: Rect, dots: &[Pos2]) -> Rect {
    let around = what.expand2(0.5 * size + Vec2::splat(GRAB_RADIUS));
    let tried = [around.center_top(), around.center_bottom(), around.right_center(), around.left_center()];
    let within = tried.map(|center| {
        let low = clip.min + 0.5 * size;
        let center = center.clamp(low, low.max(clip.max - 0.5 * size));
        Rect::from_center_size(center, size)
    });
    let is_free = |label: &&Rect| {
        let covers_none = dots.iter().all(|&dot| !label.expand(DOT_RADIUS).contains(dot));
        covers_none && !label.intersects(what)
    };
    *within.iter().find(is_free).unwrap_or(&within[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_above_what_they_name_and_go_where_no_dot_is_covered() {
        let clip = Rect::from_min_max(Pos2::ZERO, Pos2::new(300.0, 300.0));
        let size = vec2(100.0, 24.0);
        let what = Rect::from_center_size(Pos2::new(150.0, 150.0), Vec2::splat(12.0));
        let place = |dots: &[Pos2]| label_place(size, clip, what, dots);
        let above = place(&[]);
        assert!(above.bottom() < what.top() && above.center().x == what.center().x);
        let below = place(&[above.center()]);
        assert!(below.top() > what.bottom());
        let beside = place(&[above.center(), below.center()]);
        assert!(beside.left() > what.right());
        let left = place(&[above.center(), below.center(), beside.center()]);
        assert!(left.right() < what.left());
        let high = Rect::from_center_size(Pos2::new(150.0, 10.0), Vec2::splat(12.0));
        assert!(label_place(size, clip, high, &[]).top() > high.bottom(), "above there is no room");
        let everywhere = [above, below, beside, left].map(|label| label.center());
        assert_eq!(place(&everywhere), above);
    }
}

//! The four marks of an outline in its picture: numbered squares beside it, which are dragged along it.
//!
//! A square stands outside of the outline, where no dot covers it: the dot of y may be at its place. A line connects it
//! with its foot, the marked point; a drag moves the foot as the pointer moves, since the square turns about it at corners.

use crate::app::input::handles::{Handle, HandleKind, HandleState, Places, number};
use crate::app::theme::{Palette, bold};
use crate::app::viewport::dots;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::Model;
use egui::{Align2, CornerRadius, Painter, Pos2, Rect, Stroke, StrokeKind, Ui, Vec2, vec2};

/// Half the side of a square, what it grows by under the pointer, and the distance of its center from its foot, in points.
const HALF: f32 = 8.0;
const RAISED: f32 = 2.0;
const OUTSIDE: f32 = 22.0;
/// The width of the ground that lifts a line from the pattern.
const GROUND: f32 = 3.0;
/// Between a mark and the points whose connection is the tangent there, as a fraction of the length: at a corner both
/// edges count.
const BESIDE: f64 = 4e-3;

/// A mark in a picture.
struct Mark {
    index: u8,
    point: DVec2,
    foot: Pos2,
    center: Pos2,
}

impl Mark {
    fn kind(&self) -> HandleKind {
        HandleKind::Mark(self.index)
    }
}

/// The marks of a side, where they are asked for.
fn marks(side: Side, model: &Model, view: &View) -> Vec<Mark> {
    let (Some(marks), Some(domain)) = (model.marks(side), model.domain(side)) else { return Vec::new() };
    let samples = domain.samples();
    let at = |fraction: f64| samples.position(samples.at_fraction(fraction.rem_euclid(1.0)));
    let mark = |(index, fraction): (u8, f64)| {
        let [before, after] = [fraction - BESIDE, fraction + BESIDE].map(|fraction| view.to_screen(at(fraction)));
        // counter-clockwise in the plane; on the screen y points down
        let along = (after - before).normalized();
        let foot = view.to_screen(at(fraction));
        Mark { index, point: at(fraction), foot, center: foot + OUTSIDE * vec2(-along.y, along.x) }
    };
    (0..).zip(marks).map(mark).collect()
}

/// Where the squares of a side's marks are on the screen.
pub fn places(side: Side, model: &Model, view: &View) -> Places {
    marks(side, model, view).into_iter().map(|mark| (mark.kind(), mark.center)).collect()
}

/// Lets the pointer hold a mark that it has just grabbed by its foot.
pub fn hold_by_foot(side: Side, model: &Model, view: &View, handles: &mut HandleState) {
    let Some(grip) = handles.grip.as_mut().filter(|grip| grip.handle.side == side) else { return };
    if let Some(mark) = marks(side, model, view).into_iter().find(|mark| mark.kind() == grip.handle.kind) {
        grip.offset += mark.foot - mark.center;
    }
}

/// Draws the marks; one that is dragged or focused with its coordinates.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View, handles: &HandleState) {
    let painter = ui.painter_at(view.rect);
    let palette = Palette::of(ui.visuals());
    for mark in marks(side, model, view) {
        let handle = Handle { side, kind: mark.kind() };
        let half = if handles.is_raised(handle) { HALF + RAISED } else { HALF };
        square(&painter, &palette, &mark, half);
        if handles.focused == Some(handle) {
            let ring = Rect::from_center_size(mark.center, Vec2::splat(2.0 * (half + GROUND)));
            let stroke = Stroke::new(2.0, palette.accent_soft);
            painter.rect_stroke(ring, CornerRadius::same(5), stroke, StrokeKind::Inside);
        }
        if handles.is_held(handle) || handles.focused == Some(handle) {
            let words = dots::words(side, model, handles, handle, &mark.point.to_array());
            dots::paint_words(ui, &painter, words, mark.center);
        }
    }
}

/// A square with the number of a mark, which no dot looks like.
fn square(painter: &Painter, palette: &Palette, mark: &Mark, half: f32) {
    let edge = Stroke::new(1.5, palette.text);
    painter.line_segment([mark.foot, mark.center], Stroke::new(GROUND, palette.canvas));
    painter.line_segment([mark.foot, mark.center], edge);
    let square = Rect::from_center_size(mark.center, Vec2::splat(2.0 * half));
    painter.rect(square, CornerRadius::same(3), palette.canvas, edge, StrokeKind::Inside);
    painter.text(mark.center, Align2::CENTER_CENTER, number(mark.index), bold(11.0), palette.text);
}

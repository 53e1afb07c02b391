//! Painting over the picture of an edited side: the outline, its handles, the place where it crosses itself.

use super::{Editor, Reshaping};
use crate::app::theme::Palette;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::model::editing::{Crossing, Drawing, Pen};
use egui::{CornerRadius, Painter, Pos2, Rect, Shape, Stroke, StrokeKind, Ui, Vec2};

/// Half the side of a handle's square, in points: small, and large while hovered, dragged or selected.
const HALF: [f32; 2] = [4.0, 6.5];

/// The radius of the ring around a crossing.
pub(super) const RING: f32 = 16.0;

/// The opacity of the sheet that covers the picture below a drawing.
const SHEET: f32 = 0.78;

/// Covers the picture with a sheet while an outline is drawn for its side.
pub fn paint_sheet(ui: &Ui, side: Side, view: &View, editor: &Editor) {
    if editor.drawing(side).is_some() {
        let canvas = Palette::of(ui.visuals()).canvas;
        ui.painter_at(view.rect).rect_filled(view.rect, CornerRadius::ZERO, canvas.gamma_multiply(SHEET));
    }
}

/// Paints the drawing, or the reshaped outline and its handles.
pub fn paint(ui: &Ui, side: Side, view: &View, editor: &Editor) {
    if let Some(drawing) = editor.drawing(side) {
        paint_drawing(ui, view, drawing);
    }
    let Some(reshaping) = editor.reshaping(side) else { return };
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(view.rect);
    let crossed = reshaping.crossing().is_some();
    let colour = if crossed { palette.error_edge } else { palette.accent_soft };
    let outline: Vec<Pos2> = reshaping.shape().vertices().iter().map(|&p| view.to_screen(p)).collect();
    painter.add(Shape::closed_line(outline, Stroke::new(if crossed { 2.5 } else { 1.5 }, colour)));
    ring(&painter, &palette, view, reshaping.crossing());
    for (handle, at) in reshaping.shape().handles().enumerate() {
        square(&painter, &palette, view.to_screen(at), look(reshaping, editor, handle));
    }
}

/// A ring around the place where the outline crosses itself.
fn ring(painter: &Painter, palette: &Palette, view: &View, crossing: Option<&Crossing>) {
    if let Some(at) = crossing.and_then(|crossing| crossing.at) {
        let place = view.to_screen(at);
        painter.circle_stroke(place, RING, Stroke::new(5.0, palette.canvas));
        painter.circle_stroke(place, RING, Stroke::new(3.0, palette.error_edge));
    }
}

/// Paints a drawing, with the edge that would close it.
fn paint_drawing(ui: &Ui, view: &View, drawing: &Drawing) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(view.rect);
    let ink = if drawing.crossing().is_some() { palette.error_edge } else { palette.accent_soft };
    let clicks = drawing.pen() != Pen::Freehand;
    let pointer = ui.input(|input| input.pointer.latest_pos()).filter(|at| clicks && view.rect.contains(*at));
    let next = pointer.filter(|_| drawing.crossing().is_none()).map(|at| view.to_world(at));
    let chain: Vec<Pos2> = drawing.chain(next).into_iter().map(|p| view.to_screen(p)).collect();
    if let (Some(&first), Some(&last)) = (chain.first(), chain.last()) {
        painter.line_segment([last, first], Stroke::new(1.0, palette.weak));
    }
    painter.line(chain, Stroke::new(2.5, ink));
    ring(&painter, &palette, view, drawing.crossing());
    for (k, &at) in drawing.points().iter().enumerate().filter(|_| clicks) {
        square(&painter, &palette, view.to_screen(at), (k == 0, false));
    }
}

/// Whether a handle is painted large, and whether it is selected.
fn look(reshaping: &Reshaping, editor: &Editor, handle: usize) -> (bool, bool) {
    let selected = reshaping.selected == Some(handle);
    let in_hand = reshaping.grabbed() == Some(handle);
    let hovered = reshaping.grabbed().is_none() && editor.hovered == Some(handle);
    (selected || in_hand || hovered, selected)
}

fn square(painter: &Painter, palette: &Palette, place: Pos2, (large, selected): (bool, bool)) {
    let rect = Rect::from_center_size(place, Vec2::splat(2.0 * HALF[usize::from(large)]));
    let fill = if selected { palette.accent } else { palette.raised };
    let edge = if selected { palette.on_accent } else { palette.accent };
    painter.rect_filled(rect.expand(1.5), CornerRadius::same(2), palette.canvas.gamma_multiply(0.6));
    painter.rect(rect, CornerRadius::same(2), fill, Stroke::new(1.5, edge), StrokeKind::Inside);
}

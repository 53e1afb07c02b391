//! The marks of an outline, numbered, and the lines of its orthogonal grid; on the rectangle of the marks its lattice.

use crate::app::theme::{Palette, bold};
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::Model;
use egui::{Align2, CornerRadius, Painter, Pos2, Rect, Stroke, StrokeKind, Ui, Vec2, vec2};
use std::borrow::Cow;

/// The width of a line, and of the ground that lifts it from the pattern, in points.
const LINE: f32 = 1.2;
const GROUND: f32 = 3.0;
/// With more lines than this a ground would cover the pattern.
const MOST_GROUNDED: usize = 80;
/// Points of a line nearer to the last one than this are left out, in points.
const STEP: f32 = 1.5;
/// Half the side of a mark, and the distance of its center from the outline, in points.
const HALF: f32 = 8.0;
const OUTSIDE: f32 = 22.0;
/// Between a mark and the points whose connection is the tangent there, as a fraction of the length: at a corner both
/// edges count.
const BESIDE: f64 = 4e-3;

/// Paints the grid and the marks over a side's picture.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View) {
    let painter = ui.painter_at(view.rect);
    let palette = Palette::of(ui.visuals());
    grid(&painter, &palette, &model.grid_lines(side), view);
    let (Some(marks), Some(domain)) = (model.marks(side), model.domain(side)) else { return };
    let samples = domain.samples();
    for (k, fraction) in marks.into_iter().enumerate() {
        let at = |fraction: f64| view.to_screen(samples.position(samples.at_fraction(fraction.rem_euclid(1.0))));
        // counter-clockwise in the plane; on the screen y points down
        let along = (at(fraction + BESIDE) - at(fraction - BESIDE)).normalized();
        mark(&painter, &palette, at(fraction), vec2(-along.y, along.x), k + 1);
    }
}

fn grid(painter: &Painter, palette: &Palette, lines: &[Cow<'_, [DVec2]>], view: &View) {
    let lines: Vec<Vec<Pos2>> = lines.iter().map(|line| thinned(line, view)).collect();
    if lines.len() <= MOST_GROUNDED {
        let ground = Stroke::new(GROUND, palette.canvas.gamma_multiply(0.55));
        for line in &lines {
            painter.line(line.clone(), ground);
        }
    }
    let ink = Stroke::new(LINE, palette.text);
    for line in lines {
        painter.line(line, ink);
    }
}

/// The line on the screen, without points that are too near to each other to be told apart; its end stays.
fn thinned(line: &[DVec2], view: &View) -> Vec<Pos2> {
    let mut points: Vec<Pos2> = Vec::with_capacity(line.len());
    for (k, place) in line.iter().enumerate() {
        let point = view.to_screen(*place);
        if k + 1 == line.len() || points.last().is_none_or(|last| last.distance(point) >= STEP) {
            points.push(point);
        }
    }
    points
}

/// A square with the number of a mark, which no dot looks like, outside of the outline: the dot of y may be at its place.
fn mark(painter: &Painter, palette: &Palette, place: Pos2, outwards: Vec2, number: usize) {
    let edge = Stroke::new(1.5, palette.text);
    let center = place + OUTSIDE * outwards;
    painter.line_segment([place, center], Stroke::new(GROUND, palette.canvas));
    painter.line_segment([place, center], edge);
    let square = Rect::from_center_size(center, Vec2::splat(2.0 * HALF));
    painter.rect(square, CornerRadius::same(3), palette.canvas, edge, StrokeKind::Inside);
    painter.text(center, Align2::CENTER_CENTER, number, bold(11.0), palette.text);
}

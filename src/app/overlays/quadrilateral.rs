//! The lines of an outline's orthogonal grid; on the rectangle of its marks the lattice.

use crate::app::theme::Palette;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::Model;
use egui::{Painter, Pos2, Stroke, Ui};
use std::borrow::Cow;

/// The width of a line, and of the ground that lifts it from the pattern, in points.
const LINE: f32 = 1.2;
const GROUND: f32 = 3.0;
/// With more lines than this a ground would cover the pattern.
const MOST_GROUNDED: usize = 80;
/// Points of a line nearer to the last one than this are left out, in points.
const STEP: f32 = 1.5;

/// Paints the grid over a side's picture.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View) {
    grid(&ui.painter_at(view.rect), &Palette::of(ui.visuals()), &model.grid_lines(side), view);
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

//! Axes and centers of symmetry over an outline, and the cue that one of them, or a corner, has caught the dragged dot.

use crate::app::input::handles::HandleState;
use crate::app::input::snapping::Catcher;
use crate::app::theme::Palette;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::{Axis, DVec2, Rotations};
use crate::model::Model;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Ui, Vec2};

/// How far an axis is drawn beyond the outline, in sizes of the outline.
const BEYOND: f64 = 0.08;
/// Dashes and gaps, in points.
const DASH: f32 = 7.0;
const GAP: f32 = 5.0;
/// The widths of an axis, and of one that has caught the dot, with their rims in the color of the ground: seen on every
/// pattern and beside it.
const WIDTH: f32 = 1.25;
const LIT_WIDTH: f32 = 2.5;
const RIM: f32 = 2.0;
const RIM_STRENGTH: f32 = 0.75;
/// The radii of the mark of a center, and of the ring about a place that has caught the dot.
const CENTER: f32 = 4.0;
const RING: f32 = 17.0;

/// Draws the symmetries of a side's outline where they are shown, and what has caught the dragged dot.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View, handles: &HandleState) {
    let painter = ui.painter_at(view.rect);
    let palette = Palette::of(ui.visuals());
    let lit = palette.accent_soft;
    let rim = palette.canvas.gamma_multiply(RIM_STRENGTH);
    let caught = handles.held_catch().filter(|(handle, _)| handle.side == side).map(|(_, catch)| catch);
    if let Some(Ok(found)) = model.symmetries(side) {
        let symmetries = &found.symmetries;
        for (k, (axis, ends)) in symmetries.axes.iter().zip(&found.ends).enumerate() {
            let is_lit = caught.is_some_and(|catch| catch.by.axis() == Some(k));
            paint_axis(
                &painter,
                line(view, axis, ends, BEYOND * symmetries.size),
                if is_lit { (LIT_WIDTH, lit) } else { (WIDTH, palette.text) },
                rim,
            );
        }
        if symmetries.rotations != Rotations::Identity {
            let is_lit = caught.is_some_and(|catch| catch.by == Catcher::Center);
            paint_center(&painter, view.to_screen(symmetries.center), if is_lit { lit } else { palette.text }, rim);
        }
    }
    if let Some(catch) = caught.filter(|catch| !matches!(catch.by, Catcher::Axis(_))) {
        let place = view.to_screen(catch.place);
        for (width, ink) in [(LIT_WIDTH + RIM, rim), (LIT_WIDTH, lit)] {
            painter.circle_stroke(place, RING, Stroke::new(width, ink));
        }
    }
}

/// The ends of an axis on the screen, `beyond` the outermost points in which it meets the outline.
fn line(view: &View, axis: &Axis, ends: &[DVec2], beyond: f64) -> [Pos2; 2] {
    let along = ends.iter().map(|end| (end - axis.point).dot(axis.direction));
    let (low, high) = along.fold((0.0_f64, 0.0_f64), |(low, high), at| (low.min(at), high.max(at)));
    [low - beyond, high + beyond].map(|along| view.to_screen(axis.point + along * axis.direction))
}

fn paint_axis(painter: &Painter, ends: [Pos2; 2], (width, ink): (f32, Color32), rim: Color32) {
    let Some(ends) = within(painter.clip_rect(), ends) else { return };
    for stroke in [Stroke::new(width + RIM, rim), Stroke::new(width, ink)] {
        painter.extend(Shape::dashed_line(&ends, stroke, DASH, GAP));
    }
}

fn paint_center(painter: &Painter, place: Pos2, ink: Color32, rim: Color32) {
    for (width, ink) in [(WIDTH + RIM, rim), (WIDTH, ink)] {
        painter.circle_stroke(place, CENTER, Stroke::new(width, ink));
        for arm in [Vec2::X, Vec2::Y] {
            painter.line_segment([place - 2.0 * CENTER * arm, place + 2.0 * CENTER * arm], Stroke::new(width, ink));
        }
    }
}

/// The part of a segment in a rectangle (Liang and Barsky), so that no dashes are made far outside of the picture.
fn within(rect: Rect, [a, b]: [Pos2; 2]) -> Option<[Pos2; 2]> {
    let (mut from, mut to, along) = (0.0_f32, 1.0_f32, b - a);
    for (start, step, low, high) in
        [(a.x, along.x, rect.left(), rect.right()), (a.y, along.y, rect.top(), rect.bottom())]
    {
        if step == 0.0 {
            if !(low..=high).contains(&start) {
                return None;
            }
            continue;
        }
        let (enter, leave) = ((low - start) / step, (high - start) / step);
        from = from.max(enter.min(leave));
        to = to.min(enter.max(leave));
    }
    (from < to).then(|| [a + from * along, a + to * along])
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn only_the_part_of_an_axis_in_the_picture_is_drawn() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 50.0));
        let far = [pos2(-1e6, -1e6), pos2(1e6, 1e6)];
        let part = within(rect, far).unwrap_or_default();
        assert!(part[0].distance(pos2(0.0, 0.0)) < 0.5 && part[1].distance(pos2(50.0, 50.0)) < 0.5, "{part:?}");
        assert_eq!(within(rect, [pos2(10.0, -5.0), pos2(10.0, 20.0)]), Some([pos2(10.0, 0.0), pos2(10.0, 20.0)]));
        assert_eq!(within(rect, [pos2(-10.0, -5.0), pos2(-10.0, 20.0)]), None);
        assert_eq!(within(rect, [pos2(160.0, 0.0), pos2(0.0, 200.0)]), None);
    }
}

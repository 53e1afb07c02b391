//! The picture of a surface that cannot be opened: its triangles as lines, its faults in red. Dragging turns it, and so
//! do the arrow keys where it has the focus.

use crate::app::input::keyboard_navigation::held_arrows;
use crate::app::theme::widgets::caption_font;
use crate::app::theme::{Palette, ROUNDING};
use crate::language::{key, say};
use crate::worker::{Place, Sketch};
use egui::{
    Color32, CornerRadius, CursorIcon, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, vec2,
};
use glam::{EulerRot, Mat3, Vec3};

/// The largest size of the picture, and the least height that shows anything, in points.
const MOST: [f32; 2] = [320.0, 220.0];
const LEAST: f32 = 72.0;
/// The share of the picture that the surface fills.
const FILLED: f32 = 0.94;
/// The turns at first: around the vertical, and down.
const FIRST_TURNS: [f32; 2] = [0.6, 0.4];
/// The space around the words, in points.
const INSET: f32 = 6.0;
/// Radians for a point of dragging, and the points that an arrow key is worth: coarse, and with Shift.
const TURN: f32 = 0.01;
const STEPS: [f32; 2] = [20.0, 2.0];
/// The width of the edge that shows the keyboard's focus, in points.
const FOCUS_RING: f32 = 2.0;
/// The width of a faulty edge, and the radius of the circle around what would be too small to see, in points.
const MARK: f32 = 2.5;
const RING: f32 = 6.0;
/// Circles are drawn around edges that are shorter, as long as these are few.
const SHORT: f32 = 6.0;
const MOST_RINGS: usize = 40;

/// Shows the picture, at most `most` high; nothing if that is too little.
pub fn show(ui: &mut Ui, sketch: &Sketch, most: f32) {
    let size = vec2(ui.available_width().min(MOST[0]), most.min(MOST[1]));
    if size.y < LEAST {
        return;
    }
    let (rect, response) = ui.allocate_exact_size(size, Sense::drag());
    let marked = sketch.edges.len() + sketch.vertices.len();
    let words = say(&key::faults_in_red(marked, sketch.unmarked));
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words.clone()));
    let turns = turns(ui, &response);
    let above = caption(ui, &words, rect);
    let colors = Palette::of(ui.visuals());
    let edge = if response.has_focus() { (FOCUS_RING, colors.accent_soft) } else { (1.0, colors.border) };
    paint(ui, sketch, [rect, above], turns, edge.into());
    response.on_hover_cursor(CursorIcon::Grab).on_hover_text(words);
}

/// The turns around the vertical and down, after what the pointer and the arrow keys add in this frame.
fn turns(ui: &Ui, response: &Response) -> [f32; 2] {
    let mut moved = if response.dragged() { response.drag_delta() } else { Vec2::ZERO };
    if response.has_focus() {
        let [coarse, fine] = held_arrows(ui, response);
        moved += STEPS[0] * coarse + STEPS[1] * fine;
    }
    let [around, down] = ui.data(|data| data.get_temp(response.id)).unwrap_or(FIRST_TURNS);
    let turns = [around + TURN * moved.x, (down + TURN * moved.y).clamp(-1.5, 1.5)];
    if moved != Vec2::ZERO {
        ui.data_mut(|data| data.insert_temp(response.id, turns));
    }
    turns
}

/// Draws the surface in the part `above` the words, and the edge of the whole.
fn paint(ui: &Ui, sketch: &Sketch, [rect, above]: [Rect; 2], turns: [f32; 2], edge: Stroke) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(rect);
    let at = projection(sketch, above, turns);
    let line = Stroke::new(1.0, palette.text.gamma_multiply(0.25));
    // edge by edge: a closed line has mitres, which are long rays at triangles smaller than a pixel
    let edges = sketch.triangles.iter().flat_map(|corners| {
        let [a, b, c] = corners.map(&at);
        [[a, b], [b, c], [c, a]]
    });
    painter.extend(edges.map(|ends| Shape::line_segment(ends, line)));
    marks(&painter, sketch, palette.error_edge, &at);
    painter.rect_stroke(rect, CornerRadius::same(ROUNDING), edge, StrokeKind::Inside);
}

/// Paints the ground and says at its lower edge what is red, where there is room; returns the part above.
fn caption(ui: &Ui, words: &str, rect: Rect) -> Rect {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, CornerRadius::same(ROUNDING), palette.canvas);
    let galley = painter.layout(words.to_owned(), caption_font(ui), palette.weak, rect.width() - 2.0 * INSET);
    let above = rect.with_max_y(rect.bottom() - galley.size().y - 2.0 * INSET);
    if above.height() < LEAST {
        return rect; // the words are in the tooltip
    }
    painter.galley(above.left_bottom() + vec2(INSET, INSET), galley, palette.weak);
    above
}

fn marks(painter: &Painter, sketch: &Sketch, ink: Color32, at: &impl Fn(Place) -> Pos2) {
    let edges = || sketch.edges.iter().map(|ends| ends.map(at));
    painter.extend(edges().map(|ends| Shape::line_segment(ends, Stroke::new(MARK, ink))));
    let short = edges().filter(|[a, b]| a.distance(*b) < SHORT).map(|[a, b]| a.lerp(b, 0.5));
    let rings: Vec<Pos2> = sketch.vertices.iter().map(|&place| at(place)).chain(short).take(MOST_RINGS).collect();
    painter.extend(rings.into_iter().map(|center| Shape::circle_stroke(center, RING, Stroke::new(MARK, ink))));
}

/// Where a place is drawn: parallel projection, the turned surface as large as fits.
fn projection(sketch: &Sketch, rect: Rect, [around, down]: [f32; 2]) -> impl Fn(Place) -> Pos2 {
    let turn = Mat3::from_euler(EulerRot::XYZ, down, around, 0.0);
    let turned = move |place: Place| turn * Vec3::from(place.map(f32::from));
    let all = || {
        let corners = sketch.triangles.iter().flatten().chain(sketch.edges.iter().flatten());
        corners.chain(&sketch.vertices).map(|&place| turned(place))
    };
    let (low, high) = all().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    let size = (high - low).max(Vec3::splat(f32::MIN_POSITIVE));
    let scale = FILLED * (rect.width() / size.x).min(rect.height() / size.y);
    let middle = low.midpoint(high);
    move |place| {
        let offset = scale * (turned(place) - middle);
        rect.center() + vec2(offset.x, -offset.y)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn the_surface_fills_the_picture_from_any_direction() {
        let corners = [[-32767, -16000, 0], [32767, 16000, 0], [0, 0, 9000]];
        let sketch = Sketch { triangles: vec![corners], edges: Vec::new(), vertices: vec![corners[2]], unmarked: 0 };
        let rect = Rect::from_min_size(pos2(10.0, 20.0), vec2(200.0, 100.0));
        for turns in [[0.0, 0.0], FIRST_TURNS, [2.0, -1.0]] {
            let at = projection(&sketch, rect, turns);
            let places = corners.map(at);
            let bounds = Rect::from_points(&places);
            assert!(rect.contains_rect(bounds));
            assert!((bounds.width() / 200.0).max(bounds.height() / 100.0) > FILLED - 1e-3, "{turns:?}: {bounds}");
        }
    }
}

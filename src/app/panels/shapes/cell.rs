//! A cell of a menu of shapes: a small picture over its name, as a button.

use crate::app::theme::{PHONE_WIDTH, Palette, ROUNDING};
use egui::text::{LayoutJob, TextWrapping};
use egui::{Color32, CornerRadius, Pos2, Rect, Response, Role, Sense, Shape, Stroke, TextStyle, Ui, WidgetInfo, vec2};

const CELL: egui::Vec2 = vec2(100.0, 84.0);
const COLUMNS: usize = 4;
/// Between cells, in points.
const GAP: f32 = 4.0;
/// The size of the picture, and the distance of its middle from the upper edge of its cell, in points.
const PICTURE: f32 = 50.0;
const MIDDLE: f32 = 34.0;
/// Between a name and the edges of its cell, in points.
const BESIDE_NAME: f32 = 3.0;

/// The cells in a row of a menu, whose width becomes theirs.
pub fn columns(ui: &mut Ui) -> usize {
    let columns = if ui.ctx().content_rect().width() < PHONE_WIDTH { 3 } else { COLUMNS };
    ui.set_width(columns as f32 * (CELL.x + GAP));
    ui.spacing_mut().item_spacing = vec2(GAP, GAP);
    columns
}

/// Shows a cell, whose picture `draw` paints in a square with an ink.
pub fn shape_cell(ui: &mut Ui, name: &str, selected: bool, draw: impl FnOnce(&mut Ui, Rect, Color32)) -> Response {
    let palette = Palette::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(CELL, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, selected, name));
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let (fill, ink) = match (selected, response.hovered() || response.has_focus()) {
        (true, _) => (palette.accent, palette.on_accent),
        (false, true) => (palette.control_hovered, palette.text),
        (false, false) => (Color32::TRANSPARENT, palette.text),
    };
    ui.painter().rect_filled(rect, CornerRadius::same(ROUNDING), fill);
    draw(ui, Rect::from_center_size(rect.center_top() + vec2(0.0, MIDDLE), vec2(PICTURE, PICTURE)), ink);
    caption(ui, rect, name, if selected { palette.on_accent } else { palette.weak });
    response
}

/// The name below the picture, on one line; a long one is cut.
fn caption(ui: &Ui, cell: Rect, name: &str, ink: Color32) {
    let mut job = LayoutJob::simple_singleline(name.to_owned(), TextStyle::Small.resolve(ui.style()), ink);
    job.wrap = TextWrapping::truncate_at_width(cell.width() - 2.0 * BESIDE_NAME);
    let galley = ui.painter().layout_job(job);
    let corner = cell.center_bottom() - vec2(0.5 * galley.size().x, 11.0 + 0.5 * galley.size().y);
    ui.painter().galley(corner, galley, ink);
}

/// Draws a closed line from the square from −1 to 1, y down, in a frame.
pub fn closed_line(ui: &Ui, points: impl IntoIterator<Item = Pos2>, frame: Rect, ink: Color32) {
    let place = |p: Pos2| frame.center() + 0.5 * frame.width() * p.to_vec2();
    ui.painter().add(Shape::closed_line(points.into_iter().map(place).collect(), Stroke::new(1.5, ink)));
}

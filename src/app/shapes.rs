//! The menu of built-in outlines, each with its picture, and the way to a file.

use super::action::{Action, Actions};
use super::model::bounds;
use super::theme::{Palette, ROUNDING};
use super::widgets::chevron;
use super::words;
use crate::conformal::Side;
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec};
use egui::containers::menu::MenuButton;
use egui::{
    Align2, Color32, CornerRadius, Id, Pos2, Rect, Response, Role, Sense, Shape, Stroke, TextStyle, Ui, WidgetInfo,
    vec2,
};
use std::sync::Arc;

const CELL: egui::Vec2 = vec2(100.0, 84.0);
const COLUMNS: usize = 4;
/// Points of a picture: its 50 points across need no more.
const PICTURE_POINTS: usize = 160;

/// A button that opens the menu of a side's outlines.
pub fn menu_button(ui: &mut Ui, label: &str, side: Side, current: &OutlineSpec, actions: &mut Actions) {
    // The spaces make room for the chevron.
    let button = egui::Button::new(format!("{label}     "));
    let (response, _) = MenuButton::from_button(button).ui(ui, |ui| menu(ui, side, current, actions));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
    chevron(ui, response.rect, false);
}

fn menu(ui: &mut Ui, side: Side, current: &OutlineSpec, actions: &mut Actions) {
    let columns = if ui.ctx().content_rect().width() < super::PHONE_WIDTH { 3 } else { COLUMNS };
    ui.set_width(columns as f32 * (CELL.x + 4.0));
    ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
    egui::ScrollArea::vertical().max_height(0.7 * ui.ctx().content_rect().height()).show(ui, |ui| {
        for row in Preset::ALL.chunks(columns) {
            ui.horizontal(|ui| {
                for &preset in row {
                    let selected = *current == OutlineSpec::Preset(preset);
                    if cell(ui, preset, selected).clicked() {
                        let outline = OutlineSpec::Preset(preset);
                        actions.push(Action::Session(Command::SetOutline { side, outline }));
                        ui.close();
                    }
                }
            });
        }
    });
    ui.separator();
    if ui.button("Open a file…").on_hover_text(super::header::OPEN_TOOLTIP).clicked() {
        actions.push(Action::OpenOutline(side));
        ui.close();
    }
}

fn cell(ui: &mut Ui, preset: Preset, selected: bool) -> Response {
    let palette = Palette::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(CELL, Sense::click());
    let name = words::preset(preset);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, selected, name));
    let (fill, ink) = match (selected, response.hovered() || response.has_focus()) {
        (true, _) => (palette.accent, palette.on_accent),
        (false, true) => (palette.control_hovered, palette.text),
        (false, false) => (Color32::TRANSPARENT, palette.text),
    };
    ui.painter().rect_filled(rect, CornerRadius::same(ROUNDING), fill);
    let frame = Rect::from_center_size(rect.center_top() + vec2(0.0, 34.0), vec2(50.0, 50.0));
    let points = picture(ui.ctx(), preset).iter().map(|p| frame.center() + 25.0 * p.to_vec2()).collect();
    ui.painter().add(Shape::closed_line(points, Stroke::new(1.5, ink)));
    let weak = if selected { palette.on_accent } else { palette.weak };
    let caption = rect.center_bottom() - vec2(0.0, 11.0);
    ui.painter().text(caption, Align2::CENTER_CENTER, name, TextStyle::Small.resolve(ui.style()), weak);
    response
}

/// The outline, thinned, in the square from −1 to 1, y down; made once.
fn picture(context: &egui::Context, preset: Preset) -> Arc<Vec<Pos2>> {
    let id = Id::unique(("picture", preset.name()));
    if let Some(points) = context.data(|data| data.get_temp::<Arc<Vec<Pos2>>>(id)) {
        return points;
    }
    let outline = preset.outline();
    let vertices = outline.polygon.vertices();
    let (low, high) = bounds(vertices);
    let (center, scale) = (0.5 * (low + high), 2.0 / (high - low).max_element());
    let step = vertices.len().div_ceil(PICTURE_POINTS).max(1);
    let scaled = |p: &glam::DVec2| Pos2::new((scale * (p.x - center.x)) as f32, (-scale * (p.y - center.y)) as f32);
    let points: Arc<Vec<Pos2>> = Arc::new(vertices.iter().step_by(step).map(scaled).collect());
    context.data_mut(|data| data.insert_temp(id, Arc::clone(&points)));
    points
}

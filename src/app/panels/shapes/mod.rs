//! The menu of preset outlines and surfaces with their pictures; below them drawing, pasting, tracing and opening. First
//! come the shapes of the file from which the outline was read (`parts`).

mod cell;
pub mod parts;

use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::input::locks::{guarded_by, menu_entry};
use crate::app::language::words;
use crate::app::theme::Palette;
use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::widgets::drop_down;
use crate::app::viewport::surface::surface_picture;
use crate::conformal::Side;
use crate::language::{key, tr};
use crate::model::editing::Pen;
use crate::model::shape::PresetShape;
use crate::model::{Model, bounds};
use crate::outline::Preset;
use crate::session::{Command, Touched};
use crate::surface::SurfacePreset;
use cell::{closed_line, columns, shape_cell};
use egui::{Id, PopupCloseBehavior, Pos2, Response, RichText, Stroke, Ui};
use std::sync::Arc;

/// The height above and below the cells together, in points: two or three rows of buttons.
const BESIDES: f32 = 260.0;
/// The most vertices of an outline's picture: the turkey's feathers lose their tips with half as many.
const PICTURE_POINTS: usize = 360;

/// A button that opens the menu of a side's shapes.
pub fn menu_button(ui: &mut Ui, label: &str, side: Side, model: &Model, actions: &mut Actions) {
    drop_down(ui, label, PopupCloseBehavior::CloseOnClick, |ui| menu(ui, side, model, actions));
}

fn name(shape: PresetShape) -> &'static str {
    match shape {
        PresetShape::Outline(preset) => words::preset(preset),
        PresetShape::Surface(preset) => words::surface_preset(preset),
    }
}

fn menu(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let columns = columns(ui);
    let current = model.requested_preset(side);
    let all = |ui: &mut Ui| {
        parts::section(ui, side, model, columns, actions);
        cells(ui, &Preset::ALL.map(PresetShape::Outline), columns, side, current, actions);
        ui.separator();
        let palette = Palette::of(ui.visuals());
        ui.label(RichText::new(tr(key::surfaces())).small().color(palette.weak));
        cells(ui, &SurfacePreset::ALL.map(PresetShape::Surface), columns, side, current, actions);
    };
    scroll_beyond(ui, BESIDES, |ui| guarded_by(ui, Touched::ANOTHER_SHAPE, all));
    ui.separator();
    ui.horizontal_wrapped(|ui| by_hand(ui, side, model, actions));
}

/// The buttons for a custom outline: three pens, pasting, tracing, opening a file; for the source also the target.
fn by_hand(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let draw = |pen| Action::Edit(EditAction::Draw(side, pen));
    let ways = [
        (tr(key::draw_freehand()), key::draw_freehand_tooltip(), draw(Pen::Freehand)),
        (tr(key::draw_lines()), key::draw_lines_tooltip(), draw(Pen::Lines)),
        (tr(key::draw_curve()), key::draw_curve_tooltip(), draw(Pen::Curve)),
        (tr(key::paste()), key::paste_tooltip(), Action::Edit(EditAction::OpenPaste(side))),
        (tr(key::trace_picture()), key::trace_picture_tooltip(), Action::OpenTrace(side)),
        (tr(key::open_file()), key::open_shape_tooltip(), Action::OpenOutline(side)),
    ];
    let target = (tr(key::continue_from_target()), key::continue_tooltip(), Action::Session(Command::Continue));
    for (label, tooltip, action) in ways.into_iter().chain((side == Side::Source).then_some(target)) {
        let button = egui::Button::new(label).fill(palette.control).stroke(Stroke::new(1.0, palette.border));
        let is_possible = action != Action::Session(Command::Continue) || model.is_mapped();
        if menu_entry(ui, is_possible, button, tooltip, &action) {
            actions.push(action);
            ui.close();
        }
    }
}

fn cells(
    ui: &mut Ui,
    all: &[PresetShape],
    columns: usize,
    side: Side,
    current: Option<PresetShape>,
    actions: &mut Actions,
) {
    for row in all.chunks(columns) {
        ui.horizontal(|ui| {
            for &shown in row {
                if cell(ui, shown, current == Some(shown)).clicked() {
                    actions.push(Action::Session(shown.command(side)));
                    ui.close();
                }
            }
        });
    }
}

fn cell(ui: &mut Ui, shown: PresetShape, selected: bool) -> Response {
    let palette = Palette::of(ui.visuals());
    shape_cell(ui, name(shown), selected, |ui, frame, ink| match shown {
        PresetShape::Outline(preset) => closed_line(ui, picture(ui.ctx(), preset).iter().copied(), frame, ink),
        PresetShape::Surface(preset) => {
            let colours = match (ui.visuals().dark_mode, selected) {
                (true, _) => [palette.raised, ink],
                (false, true) => [palette.weak, palette.on_accent],
                (false, false) => [palette.weak, palette.border],
            };
            surface_picture(ui, preset, frame, colours);
        }
    })
}

/// The outline, thinned, in the square from −1 to 1, y down; computed once per context.
fn picture(context: &egui::Context, preset: Preset) -> Arc<Vec<Pos2>> {
    let id = Id::unique(("picture", preset.name()));
    if let Some(points) = context.data(|data| data.get_temp::<Arc<Vec<Pos2>>>(id)) {
        return points;
    }
    let outline = preset.outline();
    let vertices = outline.polygon().vertices();
    let (low, high) = bounds(vertices);
    let (center, scale) = (0.5 * (low + high), 2.0 / (high - low).max_element());
    let step = vertices.len().div_ceil(PICTURE_POINTS).max(1);
    let scaled = |p: &glam::DVec2| Pos2::new((scale * (p.x - center.x)) as f32, (-scale * (p.y - center.y)) as f32);
    let points: Arc<Vec<Pos2>> = Arc::new(vertices.iter().step_by(step).map(scaled).collect());
    context.data_mut(|data| data.insert_temp(id, Arc::clone(&points)));
    points
}

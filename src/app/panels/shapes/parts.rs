//! The shapes of a drawing or the features of a map that the file of a side's outline holds, as small pictures to pick
//! from.

use super::cell::{closed_line, columns, shape_cell};
use crate::app::input::action::{Action, Actions};
use crate::app::theme::Palette;
use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::widgets::drop_down;
use crate::conformal::Side;
use crate::language::{key, say, tr};
use crate::model::Model;
use crate::outline::{Part, Parts};
use egui::{PopupCloseBehavior, Pos2, RichText, Ui};

/// The height above and below the cells of the menu together, in points.
const BESIDES: f32 = 160.0;

/// A button that opens a menu of the parts; nothing if the file holds nothing else.
pub fn menu_button(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let Some((_, parts)) = model.parts(side) else { return };
    drop_down(ui, tr(key::choose_part()), PopupCloseBehavior::CloseOnClick, |ui| {
        let columns = columns(ui);
        scroll_beyond(ui, BESIDES, |ui| cells(ui, side, parts, columns, actions));
    });
}

/// The parts as a section of the menu of shapes, with the name of their file.
pub fn section(ui: &mut Ui, side: Side, model: &Model, columns: usize, actions: &mut Actions) {
    let Some((file, parts)) = model.parts(side) else { return };
    let weak = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(say(&key::parts_of(file))).small().color(weak));
    cells(ui, side, parts, columns, actions);
    ui.separator();
}

fn cells(ui: &mut Ui, side: Side, parts: &Parts, columns: usize, actions: &mut Actions) {
    for row in parts.all.chunks(columns) {
        ui.horizontal(|ui| {
            for part in row {
                let name = name(part);
                let picture = part.picture.iter().map(|&[x, y]| Pos2::new(x, -y));
                let cell = shape_cell(ui, &name, part.number == parts.taken, |ui, frame, ink| {
                    closed_line(ui, picture, frame, ink);
                });
                if cell.on_hover_text(&name).clicked() {
                    actions.push(Action::OpenPart(side, part.number));
                    ui.close();
                }
            }
        });
    }
}

fn name(part: &Part) -> String {
    part.name.clone().unwrap_or_else(|| say(&key::part_number(part.number)))
}

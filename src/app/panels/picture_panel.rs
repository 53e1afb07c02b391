//! The placement of the texture's picture: a switch for gestures, its numbers, and the way back to the whole picture.

use crate::app::input::action::{Action, Actions};
use crate::app::input::picture_placing;
use crate::app::theme::number_field::{number_field, spoken};
use crate::geometry::{PICTURE_MIDDLE, PICTURE_SIZE, PICTURE_TURN, PicturePlacement};
use crate::language::{Label, key, tr};
use crate::model::Model;
use crate::session::Command;
use egui::Ui;
use std::ops::RangeInclusive;

const PERCENT: f64 = 100.0;
/// Between the fields, in points: with the usual 8, the German words made the column wider than its panel.
const GAPS: [f32; 2] = [5.0, 6.0];

/// Shows the controls; the switch only where the picture lies over an outline.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    if model.pattern_home().is_some() {
        let mut is_on = picture_placing::is_on(ui.ctx());
        if ui.checkbox(&mut is_on, tr(key::move_picture())).on_hover_text(tr(key::move_picture_tooltip())).changed() {
            picture_placing::set(ui.ctx(), is_on);
        }
    }
    let old = model.session().picture();
    let mut placed = fields(ui, old);
    let whole = ui.add_enabled(!old.is_default(), egui::Button::new(tr(key::whole_picture())));
    if whole.on_hover_text(tr(key::whole_picture_tooltip())).clicked() {
        placed = PicturePlacement::default();
    }
    if placed != old {
        actions.push(Action::Session(Command::PlacePicture(placed)));
    }
}

/// Four numbers in two rows; values that are not edited stay as they are.
fn fields(ui: &mut Ui, old: PicturePlacement) -> PicturePlacement {
    let mut new = old;
    egui::Grid::new("picture placement").num_columns(4).spacing(GAPS).show(ui, |ui| {
        let percent = |range: &RangeInclusive<f64>| PERCENT * range.start()..=PERCENT * range.end();
        let of_side = percent(&PICTURE_MIDDLE);
        field(ui, [key::picture_across(), key::picture_across_tooltip()], (&mut new.middle.x, PERCENT), &of_side, " %");
        field(ui, [key::picture_up(), key::picture_up_tooltip()], (&mut new.middle.y, PERCENT), &of_side, " %");
        ui.end_row();
        let size = percent(&PICTURE_SIZE);
        field(ui, [key::picture_size(), key::picture_size_tooltip()], (&mut new.size, PERCENT), &size, " %");
        let (low, high) = (PICTURE_TURN.start().to_degrees(), PICTURE_TURN.end().to_degrees());
        let turn = [key::picture_turn(), key::picture_turn_tooltip()];
        field(ui, turn, (&mut new.turn, 1.0_f64.to_degrees()), &(low..=high), "°");
        ui.end_row();
    });
    new
}

/// A number shown as a multiple of `1 / unit`.
fn field(
    ui: &mut Ui,
    [label, tooltip]: [Label; 2],
    (value, unit): (&mut f64, f64),
    range: &RangeInclusive<f64>,
    suffix: &str,
) {
    let name = ui.label(tr(label)).on_hover_text(tr(tooltip));
    let mut shown = *value * unit;
    let number = number_field(&mut shown).range(range.clone()).speed(0.5).max_decimals(1).suffix(suffix);
    let changed = ui.add(number).labelled_by(name.id).on_hover_text(tr(tooltip));
    if spoken(changed, tr(label), shown).changed() {
        *value = shown / unit;
    }
}

//! The hyperbolic tiling: its two numbers, and how its tiles are told apart.
//!
//! On the way from one pair of numbers to another lie pairs without a hyperbolic tiling: the fields keep such a pair, with
//! the words where it lives, while the picture keeps the last tiling.

use crate::app::input::action::{Action, Actions};
use crate::app::panels::side_panel;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::number_field::{number_field, spoken};
use crate::app::theme::widgets::{Segment, segmented};
use crate::language::{Label, Message, key, say, tr};
use crate::model::Model;
use crate::session::Command;
use crate::tiling::{TILING_NUMBERS, Tiling, TilingError, TilingPattern, TilingStyle};
use egui::{Id, RichText, Ui};

const STYLES: [Segment<TilingStyle>; 4] = [
    Segment { value: TilingStyle::Tiles, label: key::tiling_tiles(), tooltip: key::tiling_tiles_tooltip() },
    Segment { value: TilingStyle::Edges, label: key::tiling_edges(), tooltip: key::tiling_edges_tooltip() },
    Segment { value: TilingStyle::Triangles, label: key::tiling_triangles(), tooltip: key::tiling_triangles_tooltip() },
    Segment { value: TilingStyle::Picture, label: key::tiling_picture(), tooltip: key::tiling_picture_tooltip() },
];

/// A pair of numbers without a hyperbolic tiling, typed while this one is shown.
#[derive(Debug, Clone, Copy)]
struct Draft {
    shown: Tiling,
    numbers: [u8; 2],
    error: TilingError,
}

/// Shows the controls; `image_name`: the file of the own picture.
pub fn show(ui: &mut Ui, model: &Model, image_name: Option<&str>, actions: &mut Actions) {
    let TilingPattern { tiling, style } = model.session().tiling();
    explained_heading(ui, tr(key::tiling_heading()), key::explain_tiling());
    if let Some(tiling) = numbers(ui, tiling) {
        actions.push(Action::Session(Command::SetTiling(TilingPattern { tiling, style })));
    }
    match segmented(ui, &STYLES, style) {
        // as for the picture as texture: the dialog comes first
        Some(TilingStyle::Picture) if image_name.is_none() => actions.push(Action::OpenImage),
        Some(style) => actions.push(Action::Session(Command::SetTiling(TilingPattern { tiling, style }))),
        None => {}
    }
    if style == TilingStyle::Picture {
        side_panel::own_picture(ui, model, image_name, actions);
    }
}

/// The fields of both numbers, and what is wrong with them; returns another tiling.
fn numbers(ui: &mut Ui, shown: Tiling) -> Option<Tiling> {
    let id = Id::unique("numbers without a hyperbolic tiling");
    let draft: Option<Draft> = ui.data(|data| data.get_temp(id)).filter(|draft: &Draft| draft.shown == shown);
    let before = draft.map_or([shown.p(), shown.q()], |draft| draft.numbers);
    let mut numbers = before;
    let wrong = draft.map(|draft| say(&Message::from(&draft.error)));
    ui.horizontal(|ui| {
        let [p, q] = &mut numbers;
        field(ui, [key::tile_sides(), key::tile_sides_tooltip()], p, wrong.as_deref());
        field(ui, [key::tiles_at_corner(), key::tiles_at_corner_tooltip()], q, wrong.as_deref());
    });
    if let Some(wrong) = wrong {
        let ink = Palette::of(ui.visuals()).error_edge;
        ui.add(egui::Label::new(RichText::new(wrong).small().color(ink)).wrap());
    }
    if numbers == before {
        return None;
    }
    match Tiling::new(numbers[0], numbers[1]) {
        Ok(tiling) => {
            ui.data_mut(|data| data.remove::<Draft>(id));
            Some(tiling)
        }
        Err(error) => {
            ui.data_mut(|data| data.insert_temp(id, Draft { shown, numbers, error }));
            ui.request_repaint();
            None
        }
    }
}

/// A number; those who hear the screen hear with it what is `wrong`.
fn field(ui: &mut Ui, [label, tooltip]: [Label; 2], number: &mut u8, wrong: Option<&str>) {
    let name = ui.label(tr(label)).on_hover_text(tr(tooltip));
    let field = ui.add(number_field(number).range(TILING_NUMBERS).speed(0.05).max_decimals(0));
    let said = wrong.map_or_else(|| tr(label).to_owned(), |wrong| format!("{}. {wrong}", tr(label)));
    spoken(field.labelled_by(name.id).on_hover_text(tr(tooltip)), &said, f64::from(*number));
}

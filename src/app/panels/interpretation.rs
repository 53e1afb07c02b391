//! The controls of an outline's interpretation: polygon or smooth, and each corner.

use crate::app::input::action::{Action, Actions};
use crate::app::language::words;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, segmented};
use crate::conformal::Side;
use crate::language::{key, number, say, tr};
use crate::model::Model;
use crate::outline::Interpretation;
use egui::{CollapsingHeader, RichText, Ui};

const INTERPRETATIONS: [Segment<Interpretation>; 3] = [
    Segment { value: Interpretation::Auto, label: key::interpret_auto(), tooltip: key::interpret_auto_tooltip() },
    Segment {
        value: Interpretation::Polygon,
        label: key::interpret_polygon(),
        tooltip: key::interpret_polygon_tooltip(),
    },
    Segment { value: Interpretation::Smooth, label: key::interpret_smooth(), tooltip: key::interpret_smooth_tooltip() },
];

/// Shows the group of a side; nothing for outlines that are not given by points or a path.
pub fn show(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let Some(interpreting) = model.interpretation(side) else { return };
    explained_heading(ui, &say(&key::outline_of(words::side(side))), key::explain_interpretation());
    if let Some(interpretation) = segmented(ui, &INTERPRETATIONS, interpreting.asked) {
        actions.extend(model.interpret(side, interpretation).map(Action::Session));
    }
    let palette = Palette::of(ui.visuals());
    let weak = |text: String| RichText::new(text).small().color(palette.weak);
    ui.label(weak(words::interpreted(interpreting.taken.interpreted)));
    let is_told = interpreting.asked == Interpretation::Smooth || !interpreting.taken.corners.is_empty();
    if let Some(reason) = interpreting.taken.stays.as_ref().filter(|_| is_told) {
        ui.label(weak(say(reason)));
    }
    corners(ui, side, model, actions);
}

/// The list of corners, each with a check box.
fn corners(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let count = model.corners(side).count();
    if count == 0 {
        return;
    }
    let list = |ui: &mut Ui| {
        for (index, (corner, place)) in model.corners(side).enumerate() {
            let mut is_corner = corner.is_corner;
            let [x, y] = place.to_array().map(|value| number(value, 3));
            let label = ui.checkbox(&mut is_corner, say(&key::corner_at(index + 1, x, y)));
            if label.on_hover_text(tr(key::corner_tooltip())).changed() {
                actions.extend(model.switch_corner(side, corner.vertex).map(Action::Session));
            }
        }
    };
    CollapsingHeader::new(say(&key::corners_of(count))).id_salt(("corners", side)).show(ui, list);
}

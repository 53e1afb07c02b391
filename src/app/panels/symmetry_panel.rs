//! The group "Symmetry": whether axes and centers are shown, and those of each outline with their deviations.

use crate::app::input::action::{Action, Actions};
use crate::app::input::snapping::degrees;
use crate::app::language::words;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::conformal::Side;
use crate::geometry::{Rotations, SYMMETRY_TOLERANCE, Symmetries};
use crate::language::{key, number, say, tr};
use crate::model::Model;
use crate::session::Command;
use egui::{RichText, Ui};
use std::f64::consts::TAU;

/// Axes beyond this number are not listed.
const MOST_AXES: usize = 6;

/// Shows the group; nothing where there is no outline.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let mut sides = Side::BOTH.into_iter().filter(|side| model.abilities().has_outline(*side)).peekable();
    if sides.peek().is_none() {
        return;
    }
    explained_heading(ui, tr(key::symmetry()), key::explain_symmetry());
    let mut shown = model.session().symmetries();
    let choice = ui.checkbox(&mut shown, tr(key::show_symmetries())).on_hover_text(tr(key::show_symmetries_tooltip()));
    if choice.changed() {
        actions.push(Action::Session(Command::SetSymmetries(shown)));
    }
    if !model.session().symmetries() {
        return;
    }
    let palette = Palette::of(ui.visuals());
    for side in sides {
        ui.label(RichText::new(say(&key::symmetries_of(words::side_within(side)))).small());
        let lines = match model.symmetries(side) {
            Some(Ok(found)) => lines(&found.symmetries),
            Some(Err(reason)) => vec![say(reason)],
            None => vec![tr(key::computing()).to_owned()],
        };
        for line in lines {
            ui.label(RichText::new(line).small().color(palette.weak));
        }
    }
    let tolerance = say(&key::symmetry_tolerance(number(100.0 * SYMMETRY_TOLERANCE, 0)));
    ui.label(RichText::new(tolerance).small().color(palette.weak));
}

/// The symmetries in words, a line for each.
pub fn lines(symmetries: &Symmetries) -> Vec<String> {
    if symmetries.is_empty() {
        return vec![tr(key::no_symmetry()).to_owned()];
    }
    let off = |deviation: f64| number(100.0 * deviation, 2);
    let turns = match symmetries.rotations {
        Rotations::Identity => None,
        Rotations::Circle { deviation } => Some(key::symmetry_circle(off(deviation))),
        Rotations::Order { order, deviation } => {
            Some(key::symmetry_turns(degrees(TAU / f64::from(order)), off(deviation)))
        }
    };
    let listed = symmetries.axes.iter().take(MOST_AXES);
    let axes = listed.map(|axis| key::symmetry_axis(degrees(axis.direction.to_angle()), off(axis.deviation)));
    let hidden = symmetries.axes.len().saturating_sub(MOST_AXES);
    let more = (hidden > 0).then(|| key::more_axes(hidden));
    turns.into_iter().chain(axes).chain(more).map(|line| say(&line)).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, SimplePolygon};
    use crate::outline::Preset;

    #[test]
    fn axes_and_turns_are_listed_with_their_deviations() {
        crate::language::set(crate::language::Language::English);
        let of = |polygon: SimplePolygon| lines(&Symmetries::of(&polygon));
        let preset = |preset: Preset| of(preset.outline().into_polygon());
        assert_eq!(preset(Preset::LShape), ["Axis at 45°, off by 0.00 %"]);
        assert_eq!(preset(Preset::Turkey), ["none"]);
        assert_eq!(preset(Preset::Star)[..2], ["Turns by 72°, off by 0.00 %", "Axis at 18°, off by 0.00 %"]);
        assert_eq!(preset(Preset::Disk), ["A circle, off by 0.00 %: every line through the center is an axis"]);
        let octagon = (0..8).map(|k| DVec2::from_angle(f64::from(k) * TAU / 8.0)).collect::<Vec<_>>();
        let octagon = of(SimplePolygon::try_from(octagon).unwrap());
        assert_eq!((octagon.len(), octagon[7].as_str()), (8, "and 2 more axes"));
    }
}

//! The group "Invariants" of an outline: which numbers are wanted, and each number with its error.
//!
//! The numbers are computed at rest, by a worker of their own; what does not fit is said in words.

use crate::app::input::action::{Action, Actions};
use crate::app::language::words;
use crate::app::panels::quadrilateral_panel;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::number_field::{number_field, spoken};
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::{Label, decimal, key, number, say, tr};
use crate::model::Model;
use crate::model::overlays::invariants::{InvariantsAction, SideInvariants};
use crate::session::Command;
use crate::worker::{FoundInvariants, Number};
use egui::{Grid, RichText, ScrollArea, Ui, WidgetInfo};

/// Measures beyond this number of arcs are not listed.
const MOST_ARCS: usize = 12;
/// The marks to start with.
const MARKS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
/// The change of a fraction by a drag over one point of the screen.
const MARK_SPEED: f64 = 0.002;

/// Shows the group of an outline.
pub fn show(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let asked = model.overlay_state().invariants.of(side);
    let heading = say(&key::invariants_of(words::side(side)));
    explained_heading(ui, &heading, key::invariants_explained());
    let mut wanted = Vec::new();
    let mut is_open = model.shows_invariants(side);
    let compute = ui.checkbox(&mut is_open, tr(key::compute_invariants()));
    // both sides have such a box
    compute.widget_info(|| WidgetInfo::selected(egui::Role::CheckBox, true, is_open, &heading));
    if compute.changed() {
        wanted.push(InvariantsAction::Open(side, is_open));
        if !is_open && model.session().marks(side).is_some() {
            actions.push(Action::Session(Command::SetMarks { side, marks: None }));
        }
    }
    if model.shows_invariants(side) {
        marks(ui, side, model, actions);
        second_point(ui, side, asked, model, &mut wanted);
        result(ui, side, model);
        if model.session().marks(side).is_some() {
            quadrilateral_panel::show(ui, side, model, actions);
        }
    }
    actions.extend(wanted.into_iter().map(Action::Invariants));
}

fn marks(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let old = model.session().marks(side);
    let mut has_marks = old.is_some();
    let box_ = ui.checkbox(&mut has_marks, tr(key::four_marks())).on_hover_text(tr(key::four_marks_tooltip()));
    let mut new = if box_.changed() { has_marks.then_some(MARKS) } else { old };
    if let (Some(old), Some(new)) = (old, &mut new) {
        ui.horizontal_wrapped(|ui| {
            for (k, mark) in new.iter_mut().enumerate() {
                let drag = number_field(mark).speed(MARK_SPEED).range(0.0..=1.0).max_decimals(6);
                let drag = drag.prefix(format!("{}: ", k + 1));
                spoken(ui.add(drag), &say(&key::mark(k + 1)), old[k]);
            }
        });
    }
    if new != old {
        actions.push(Action::Session(Command::SetMarks { side, marks: new }));
    }
}

fn second_point(ui: &mut Ui, side: Side, asked: &SideInvariants, model: &Model, wanted: &mut Vec<InvariantsAction>) {
    let mut has_point = asked.second_point.is_some();
    let box_ = ui.checkbox(&mut has_point, tr(key::second_point())).on_hover_text(tr(key::second_point_tooltip()));
    if box_.changed() {
        // half way from the point to the anchor, or as near to that as is inside
        let half_way = model.interior(side).zip(model.anchor(side)).map(|(x, y)| x.midpoint(y));
        let start = half_way.and_then(|point| model.interior_near(side, point)).unwrap_or_default();
        wanted.push(InvariantsAction::SecondPoint(side, has_point.then_some(start)));
    }
    let Some(old) = asked.second_point else { return };
    let mut new = old;
    let speed = 1e-3 * model.extent(side).map_or(1.0, |(low, high)| (high - low).max_element());
    ui.horizontal_wrapped(|ui| {
        for (name, coordinate) in [("x", &mut new.x), ("y", &mut new.y)] {
            let value = *coordinate;
            let drag = number_field(coordinate).speed(speed).max_decimals(8).prefix(format!("{name} "));
            spoken(ui.add(drag), name, value);
        }
    });
    if new != old && new.is_finite() {
        wanted.push(InvariantsAction::SecondPoint(side, Some(DVec2::new(new.x, new.y))));
    }
}

fn result(ui: &mut Ui, side: Side, model: &Model) {
    let palette = Palette::of(ui.visuals());
    match model.invariants(side) {
        // the numbers may be wider than the column, which they must not widen
        Some(Ok(found)) => _ = ScrollArea::horizontal().id_salt("numbers").show(ui, |ui| table(ui, found)),
        Some(Err(reason)) => {
            ui.label(RichText::new(say(reason)).small().color(palette.error_edge));
        }
        None => {
            ui.label(RichText::new(tr(key::computing())).small().color(palette.weak));
        }
    }
}

fn table(ui: &mut Ui, found: &FoundInvariants) {
    Grid::new("invariants").striped(true).spacing([10.0, 2.0]).show(ui, |ui| {
        for (name, number) in rows(found) {
            ui.label(RichText::new(name).small());
            ui.label(RichText::new(shortened(number)).small().monospace()).on_hover_text(shown(number));
            ui.end_row();
        }
    });
    if let Some(hidden) = found.measures.len().checked_sub(MOST_ARCS).filter(|hidden| *hidden > 0) {
        ui.label(RichText::new(say(&key::more_arcs(hidden))).small());
    }
}

/// The numbers with their names.
pub fn rows(found: &FoundInvariants) -> Vec<(String, Number)> {
    let named = |label: Label, number: Option<Number>| Some((tr(label).to_owned(), number?));
    let single = [
        named(key::conformal_radius(), Some(found.conformal_radius)),
        named(key::capacity(), Some(found.capacity)),
        named(key::modulus(), found.modulus),
        named(key::hyperbolic_distance(), found.hyperbolic_distance),
    ];
    let arcs = found.measures.iter().take(MOST_ARCS).enumerate();
    let arcs = arcs.map(|(k, &measure)| (say(&key::measure_of_arc(k + 1)), measure));
    single.into_iter().flatten().chain(arcs).collect()
}

/// The most decimals: beyond them is rounding.
const MOST_DECIMALS: f64 = 15.0;
/// Below this, numbers are written with an exponent.
const SMALL: f64 = 1e-4;

/// The decimals that the column has room for, with the error beside them.
const DECIMALS_IN_COLUMN: f64 = 7.0;

/// A number to the digits that its error allows, and the error.
pub fn shown(number: Number) -> String {
    with_places(number, MOST_DECIMALS)
}

/// The same with fewer digits and "…" for those that are left out, so that the error is seen in the column too.
fn shortened(number: Number) -> String {
    let (whole, short) = (shown(number), with_places(number, DECIMALS_IN_COLUMN));
    if whole == short { whole } else { short.replacen(" ±", "… ±", 1) }
}

fn with_places(Number { value, error }: Number, most: f64) -> String {
    let places = if error > 0.0 { (-error.log10()).ceil() } else { f64::INFINITY };
    let value = if value != 0.0 && value.abs() < SMALL {
        let digits = (places + value.abs().log10()).clamp(0.0, most) as usize;
        decimal(&format!("{value:.digits$e}"))
    } else {
        number(value, places.clamp(0.0, most) as usize)
    };
    format!("{value} ± {error:.0e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_their_errors_allow() {
        crate::language::set(crate::language::Language::English);
        let of = |value, error| shown(Number { value, error });
        assert_eq!(of(0.762_759_763_501_813, 1e-9), "0.762759764 ± 1e-9");
        assert_eq!(of(3.837_587_979_251e-7, 1e-17), "3.8375879793e-7 ± 1e-17");
        assert_eq!(of(2.5, 0.3), "2.5 ± 3e-1");
        let modulus = Number { value: 1.524_504_094_083_92, error: 1e-14 };
        assert_eq!(
            (shown(modulus).as_str(), shortened(modulus).as_str()),
            ("1.52450409408392 ± 1e-14", "1.5245041… ± 1e-14")
        );
    }
}

//! Errors of harmonic measure and of boundary images by all methods on one outline, both axes logarithmic; and the
//! choice of outline and horizontal axis.

use super::super::theme::Palette;
use super::super::theme::widgets::{Segment, segmented};
use super::chart::{power_of_ten, stroked};
use super::legend::{Entry, RADIUS, WIDTH, error_axis, with_legend};
use crate::app::input::action::{Action, Actions, LadderAxis, LadderShown};
use crate::app::language::words::grouped;
use crate::figures::{LadderMethod, LadderRow, LadderShape, Reference};
use crate::language::{self, Label, key, number, say, tr};
use egui::{Color32, ComboBox, RichText, Ui};
use egui_plot::{AxisHints, GridInput, GridMark, LineStyle, Plot, Points};

/// The colors of the methods: Okabe–Ito.
const INKS: [Color32; 4] = [
    Color32::from_rgb(86, 180, 233),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(213, 94, 0),
];

/// Errors below rounding are shown at it.
const LEAST: f64 = 1e-16;

const AXES: [Segment<LadderAxis>; 3] = [
    Segment { value: LadderAxis::Unknowns, label: key::unknowns(), tooltip: key::unknowns_tooltip() },
    Segment { value: LadderAxis::Points, label: key::boundary_points(), tooltip: key::boundary_points_tooltip() },
    Segment { value: LadderAxis::Milliseconds, label: key::milliseconds(), tooltip: key::milliseconds_tooltip() },
];

/// Shows the rows measured so far of the chosen outline.
pub fn ladder_chart(ui: &mut Ui, rows: &[LadderRow], shown: LadderShown, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    ui.label(RichText::new(tr(key::ladder_about())).small().color(palette.weak));
    choices(ui, shown, actions);
    if let Some(note) = note(shown.shape) {
        ui.label(RichText::new(tr(note)).small().color(palette.weak));
    }
    let rows: Vec<&LadderRow> = rows.iter().filter(|row| row.rung.shape == shown.shape).collect();
    let curves: Vec<(NamedCurve, Color32)> = LadderMethod::ALL
        .into_iter()
        .zip(INKS)
        .flat_map(|(method, ink)| curves(&rows, method, shown.axis).into_iter().map(move |curve| (curve, ink)))
        .collect();
    let entry = |((name, _, style), ink): &(NamedCurve, Color32)| Entry {
        name: name.clone(),
        ink: *ink,
        dashed: *style != LineStyle::Solid,
    };
    let entries: Vec<Entry> = curves.iter().map(entry).collect();
    let axis = AxisHints::new_x().label(tr(axis_label(shown.axis)).to_owned());
    let ends = ends_of_axis(curves.iter().flat_map(|((_, points, _), _)| points).map(|point| point[0]));
    with_legend(ui, "ladder", &entries, |ui, plot| {
        let plot = ends.into_iter().fold(plot, Plot::include_x);
        plot.grid_color(palette.border)
            .x_grid_spacer(grid_lines)
            .y_grid_spacer(pairs)
            .custom_x_axes(vec![axis.formatter(|mark, _| size(10_f64.powf(mark.value)))])
            .custom_y_axes(vec![error_axis(tr(key::error())).formatter(|mark, _| power_of_ten(mark.value))])
            .show(ui, |plot| {
                for ((name, points, style), ink) in curves {
                    plot.line(stroked(&name, points.clone(), ink, WIDTH).style(style));
                    plot.points(Points::new(name, points).color(ink).radius(RADIUS));
                }
            });
    });
}

fn choices(ui: &mut Ui, shown: LadderShown, actions: &mut Actions) {
    let mut shape = shown.shape;
    let name = tr(key::ladder_outline());
    let response = ComboBox::from_id_salt("ladder-outline").selected_text(say(&language::ladder_shape(shape)));
    let response = response.show_ui(ui, |ui| {
        for choice in LadderShape::ALL {
            ui.selectable_value(&mut shape, choice, say(&language::ladder_shape(choice)));
        }
    });
    response.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, name));
    let axis = segmented(ui, &AXES, shown.axis).unwrap_or(shown.axis);
    let wanted = LadderShown { shape, axis };
    if wanted != shown {
        actions.push(Action::ShowLadder(wanted));
    }
}

/// What errors are measured against where that is not an exact value along the boundary.
fn note(shape: LadderShape) -> Option<Label> {
    match shape.reference() {
        Reference::Exact => None,
        Reference::Corners => Some(key::ladder_at_corners()),
        Reference::Finer => Some(key::ladder_against_finer()),
    }
}

fn axis_label(axis: LadderAxis) -> Label {
    match axis {
        LadderAxis::Unknowns => key::unknowns(),
        LadderAxis::Points => key::boundary_points(),
        LadderAxis::Milliseconds => key::milliseconds(),
    }
}

fn place(row: &LadderRow, axis: LadderAxis) -> f64 {
    match axis {
        LadderAxis::Unknowns => row.unknowns as f64,
        LadderAxis::Points => row.m as f64,
        LadderAxis::Milliseconds => row.prepare_ms + row.point_ms,
    }
}

type NamedCurve = (String, Vec<[f64; 2]>, LineStyle);

/// ω solid, images dashed; curves without points are left out.
fn curves(rows: &[&LadderRow], method: LadderMethod, axis: LadderAxis) -> Vec<NamedCurve> {
    let of_method = || rows.iter().filter(|row| row.rung.method == method);
    let point = |row: &LadderRow, error: f64| [place(row, axis).log10(), error.max(LEAST).log10()];
    let named = |what: Label| format!("{}, {}", tr(language::ladder_method(method)), tr(what));
    let omega = of_method().map(|row| point(row, row.omega.max)).collect();
    let image = of_method().filter_map(|row| Some(point(row, row.image?.max))).collect();
    let curves: [NamedCurve; 2] = [
        (named(key::harmonic_measure_in_legend()), omega, LineStyle::Solid),
        (named(key::boundary_images()), image, LineStyle::dashed_dense()),
    ];
    curves.into_iter().filter(|curve| !curve.1.is_empty()).collect()
}

/// The logarithms of 1, 2 and 5 times the powers of ten from a number to another one: counts and times span two or three
/// powers.
fn ones_twos_fives(low: f64, high: f64) -> impl DoubleEndedIterator<Item = f64> {
    let powers = (low.floor() as i64..=high.floor() as i64).collect::<Vec<_>>().into_iter();
    let all = powers.flat_map(|k| [1.0, 2.0, 5.0_f64].map(|n| k as f64 + n.log10()));
    all.filter(move |value| (low..=high).contains(value))
}

#[allow(clippy::needless_pass_by_value, reason = "the plot hands it over")]
fn grid_lines(input: GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    // the smallest step decides whether labels have room
    ones_twos_fives(low, high).map(|value| GridMark { value, step_size: 2.0_f64.log10() }).collect()
}

/// The nearest grid lines below and above all of these values, so that an axis has two numbers also with one value;
/// nothing without values.
fn ends_of_axis(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let ends = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    let (low, high) = ends;
    if !(low.is_finite() && high.is_finite()) {
        return Vec::new();
    }
    let below = ones_twos_fives(low - 1.0, low).rfind(|line| *line < low);
    let above = ones_twos_fives(high, high + 1.0).find(|line| *line > high);
    below.into_iter().chain(above).collect()
}

/// A count or a time at a grid line.
fn size(value: f64) -> String {
    if value < 0.95 { number(value, (-value.log10()).ceil() as usize) } else { grouped(value.round() as usize) }
}

/// A grid line at every second power of ten.
#[allow(clippy::needless_pass_by_value, reason = "the plot hands it over")]
fn pairs(input: GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let inside = (low.ceil() as i64..=high.floor() as i64).filter(|k| k % 2 == 0);
    inside.map(|k| GridMark { value: k as f64, step_size: 2.0 }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_has_two_numbers_also_with_one_value() {
        for value in [1.0_f64, 3.0, 20.0, 700.0, 0.04] {
            let ends = ends_of_axis([value.log10()].into_iter());
            assert!(ends.len() == 2 && ends[0] < value.log10() && value.log10() < ends[1], "{value}: {ends:?}");
            let seen = ones_twos_fives(ends[0], ends[1]).count();
            assert!((2..=3).contains(&seen), "{value}: {seen} grid lines");
        }
        assert_eq!(ends_of_axis([].into_iter()), [0.0; 0]);
    }
}

//! Figure 15: the errors of both methods over the number of samples, with both axes logarithmic.

use super::super::theme::Palette;
use super::chart::{power_of_ten, stroked};
use super::legend::{Entry, RADIUS, WIDTH, error_axis, with_legend};
use crate::app::language::words::grouped;
use crate::figures::{ConvergenceRow, Method, SecondMap, fitted_order};
use crate::language::{self, key, number, say, tr};
use egui::{Color32, RichText, Ui};
use egui_plot::{AxisHints, GridInput, GridMark, Points};

/// The colors of maximum and mean error of the harmonic-measure map and of the geodesic algorithm: Okabe–Ito.
const INKS: [Color32; 4] = [
    Color32::from_rgb(86, 180, 233),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(204, 121, 167),
];

/// Shows the rows measured so far of these `resolutions`, with the fitted order of each curve in the legend.
pub fn convergence_chart(ui: &mut Ui, rows: &[ConvergenceRow], resolutions: &[u32]) {
    let palette = Palette::of(ui.visuals());
    let text = key::convergence_about();
    ui.label(RichText::new(tr(text)).small().color(palette.weak));
    let series = all_series(rows);
    let of_curve = |(series, ink): (&Series, Color32)| Entry { name: series.name.clone(), ink, dashed: false };
    let entries: Vec<Entry> = series.iter().zip(INKS).map(of_curve).collect();
    let marks: Vec<GridMark> = resolutions.iter().map(|&m| mark(f64::from(m).log2())).collect();
    with_legend(ui, "convergence", &entries, |ui, plot| {
        // the axis is whole from the beginning
        let plot = marks.iter().fold(plot, |plot, mark| plot.include_x(mark.value));
        plot.grid_color(palette.border)
            .x_grid_spacer(move |_| marks.clone())
            .y_grid_spacer(whole)
            .custom_x_axes(vec![
                AxisHints::new_x()
                    .label(tr(key::boundary_samples_m()).to_owned())
                    .formatter(|mark, _| grouped(mark.value.exp2().round() as usize)),
            ])
            .custom_y_axes(vec![error_axis(tr(key::error())).formatter(|mark, _| power_of_ten(mark.value))])
            .show(ui, |plot| {
                for (series, ink) in series.into_iter().zip(INKS) {
                    let points: Vec<[f64; 2]> =
                        series.points.iter().map(|&(m, e)| [f64::from(m).log2(), e.log10()]).collect();
                    plot.line(stroked(&series.name, points.clone(), ink, WIDTH));
                    plot.points(Points::new(series.name, points).color(ink).radius(RADIUS));
                }
            });
    });
}

fn mark(value: f64) -> GridMark {
    GridMark { value, step_size: 1.0 }
}

struct Series {
    name: String,
    points: Vec<(u32, f64)>,
}

fn all_series(rows: &[ConvergenceRow]) -> Vec<Series> {
    let of = |method: Method| rows.iter().filter(move |row| row.method == method && row.second == SecondMap::Exact);
    let both = |method: Method| {
        [
            series(method, tr(key::max()), of(method).map(|row| (row.m, row.max)).collect()),
            series(method, tr(key::mean()), of(method).map(|row| (row.m, row.mean)).collect()),
        ]
    };
    [Method::HarmonicMeasure, Method::FreshZipper].into_iter().flat_map(both).collect()
}

fn series(method: Method, error: &str, points: Vec<(u32, f64)>) -> Series {
    let order = fitted_order(&points).map(|p| format!(", {}", say(&key::fitted_order(number(p, 1)))));
    let order = order.unwrap_or_default();
    Series { name: format!("{}, {error}{order}", tr(language::method(method))), points }
}

/// A grid line at every integer.
#[allow(clippy::needless_pass_by_value, reason = "the plot hands it over")]
fn whole(input: GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    (low.ceil() as i64..=high.floor() as i64).map(|k| mark(k as f64)).collect()
}

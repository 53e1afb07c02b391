//! One plot, drawn with egui_plot: bounds, axes, lines, legend, and the point under the pointer.

use super::super::theme::Palette;
use super::{PlotKind, Plots};
use crate::app::language::words;
use crate::conformal::{PerSide, Side};
use crate::geometry::sort_by_number;
use crate::language::{decimal, key, number, say, tr};
use crate::model::curves::{Curve, Curves, ExactCurves, decimate};
use crate::model::overlays::overlay::{Overlay, Overlays};
use egui::{Align2, Color32, FontId, Pos2, Rect, RichText, Shape, Stroke, Ui, vec2};
use egui_plot::{
    AxisHints, GridInput, GridMark, Line, LineStyle, Plot, PlotBounds, PlotPoint, PlotTransform, PlotUi, Points, VLine,
};

/// The colors of source and target, in the dark and the light theme: Okabe–Ito's blues, and oranges.
pub const SIDE_INKS: [PerSide<Color32>; 2] = [
    PerSide::new(Color32::from_rgb(86, 180, 233), Color32::from_rgb(230, 159, 0)),
    PerSide::new(Color32::from_rgb(0, 114, 178), Color32::from_rgb(196, 120, 0)),
];

/// The colors of the reparameterization of the shown map and of those through fresh and precomputed disk maps.
pub const MAP_INKS: [[Color32; 3]; 2] = [
    [Color32::from_rgb(64, 196, 150), Color32::from_rgb(168, 148, 255), Color32::from_rgb(204, 121, 167)],
    [Color32::from_rgb(0, 138, 100), Color32::from_rgb(96, 72, 196), Color32::from_rgb(180, 80, 140)],
];

/// The color of the exact curves, by theme. They are wide, below all others and gray: they are the reference for the
/// colored curves.
pub const EXACT_INKS: [Color32; 2] = [Color32::from_rgb(132, 142, 154), Color32::from_rgb(160, 168, 178)];
const EXACT_WIDTH: f32 = 4.5;
/// The width of all other curves, in the plot and in its legend.
const LINE_WIDTH: f32 = 1.75;

/// The color of the hits of random walks, by theme; distinct from [`SIDE_INKS`] and [`MAP_INKS`].
pub const WALK_INKS: [Color32; 2] = [Color32::from_rgb(240, 228, 66), Color32::from_rgb(200, 40, 48)];

/// The most decades on the logarithmic axis: twice the 16 digits of f64; with more, the curve's peak is a spike again.
const MOST_DECADES: f64 = 32.0;

/// The length of a curve's sample in a legend: two dashes and a half.
pub const SAMPLE: f32 = 19.0;
/// The dashes and gaps of `LineStyle::dashed_dense`.
pub const DASHES: (f32, f32) = (5.0, 3.09);

/// Free space at the ends of the axes, as a fraction of their length.
const MARGIN: f64 = 0.03;

/// The content of one plot: its curves, axis range and colors.
pub struct Chart<'a> {
    kind: PlotKind,
    lines: Vec<(&'a Curve, Color32)>,
    exact: Vec<&'a Curve>,
    overlays: &'a [Overlay],
    dark: bool,
    mapped: Side,
    logarithmic: bool,
    /// The lowest and the highest value of the y axis.
    range: (f64, f64),
}

/// An entry of the legend.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Entry {
    name: &'static str,
    ink: Color32,
    width: f32,
    dashed: bool,
}

impl<'a> Chart<'a> {
    /// The plot of this kind; `logarithmic` applies to the kernel only.
    pub fn of(
        kind: PlotKind,
        curves: &'a Curves,
        exact: Option<&'a ExactCurves>,
        overlays: &'a Overlays,
        dark: bool,
        logarithmic: bool,
    ) -> Self {
        let theme = usize::from(!dark);
        let lines: Vec<_> = match kind {
            PlotKind::Kernel => in_inks(&curves.kernel, theme),
            PlotKind::Measure => in_inks(&curves.measure, theme),
            PlotKind::Reparameterization => vec![(&curves.reparameterisation, MAP_INKS[theme][0])],
        };
        let exact = match (kind, exact) {
            (PlotKind::Measure, Some(exact)) => exact.measure.as_ref().into_array().to_vec(),
            (PlotKind::Reparameterization, Some(exact)) => vec![&exact.reparameterisation],
            _ => Vec::new(),
        };
        let overlays = match kind {
            PlotKind::Kernel => &[][..],
            PlotKind::Measure => &overlays.measure,
            PlotKind::Reparameterization => &overlays.reparameterisation,
        };
        let logarithmic = logarithmic && kind == PlotKind::Kernel;
        let range = match kind {
            PlotKind::Kernel => kernel_range(&curves.kernel, logarithmic),
            _ => (0.0, 1.0),
        };
        Self { kind, lines, exact, overlays, dark, mapped: curves.mapped, logarithmic, range }
    }

    /// Draws the plot with the points at `marked` (arc lengths by side, from the anchors); returns the
    /// side and the arc length under the pointer.
    pub fn show(&self, ui: &mut Ui, marked: Option<PerSide<f64>>) -> Option<(Side, f64)> {
        let palette = Palette::of(ui.visuals());
        let columns = (ui.available_width() * ui.pixels_per_point()).max(1.0) as usize;
        let logarithmic = self.logarithmic;
        let plot = Plot::new(("plot", self.kind as usize))
            .sense(egui::Sense::hover())
            .height(ui.available_height().max(80.0))
            .allow_drag(false)
            .allow_zoom(false)
            .allow_scroll(false)
            .allow_boxed_zoom(false)
            .allow_axis_zoom_drag(false)
            .allow_double_click_reset(false)
            .show_x(false)
            .show_y(false)
            .show_crosshair(false)
            .show_background(false)
            .label_formatter(|_| None)
            .grid_color(palette.border)
            .grid_fade(0.5)
            .x_grid_spacer(|_| fifths())
            .y_grid_spacer(move |input| if logarithmic { decades(&input) } else { even_steps(&input) })
            .custom_x_axes(vec![
                axis(AxisHints::new_x(), &palette, self.x_label())
                    .label_spacing(30.0..=44.0)
                    .formatter(|mark, _| of_step(mark)),
            ])
            .custom_y_axes(vec![self.y_axis(&palette)]);
        let response = plot.show(ui, |plot| {
            let (low, high) = self.range;
            let margin = MARGIN * (high - low);
            plot.set_plot_bounds(PlotBounds::from_min_max([-MARGIN, low - margin], [1.0 + MARGIN, high + margin]));
            self.add_lines(plot, columns);
            if let Some(marked) = marked {
                self.add_marks(plot, marked, &palette);
            }
        });
        self.legend(ui, response.response.rect);
        let pointer = response.response.hover_pos()?;
        Some(self.pointed(&response.transform, pointer))
    }

    fn x_label(&self) -> String {
        match self.kind {
            PlotKind::Reparameterization => say(&key::arc_length_of_side(words::side_within(self.mapped))),
            _ => String::from(tr(key::arc_length_y_length())),
        }
    }

    fn y_axis(&self, palette: &Palette) -> AxisHints<'static> {
        let label = match self.kind {
            PlotKind::Kernel => String::from(tr(key::psi_length())),
            PlotKind::Measure => String::from("ω"),
            PlotKind::Reparameterization => words::side_within(self.mapped.other()).to_owned(),
        };
        let axis = axis(AxisHints::new_y(), palette, label).label_spacing(14.0..=20.0).min_thickness(30.0);
        let logarithmic = self.logarithmic;
        axis.formatter(move |mark, _| if logarithmic { power_of_ten(mark.value) } else { of_step(mark) })
    }

    /// The position of a curve's value on the y axis.
    fn ordinate(&self, y: f64) -> f64 {
        if self.logarithmic { y.max(f64::MIN_POSITIVE).log10().max(self.range.0) } else { y }
    }

    fn add_lines(&self, plot: &mut PlotUi, columns: usize) {
        for curve in &self.exact {
            let points = decimate(&curve.points, columns);
            plot.line(stroked(&curve.name, points, self.exact_ink(), EXACT_WIDTH).allow_hover(false));
        }
        for (curve, ink) in &self.lines {
            let points = decimate(&curve.points, columns).into_iter().map(|[x, y]| [x, self.ordinate(y)]).collect();
            plot.line(stroked(&curve.name, points, *ink, LINE_WIDTH).allow_hover(false));
        }
        for Overlay { origin, curve } in self.overlays {
            let ink = Plots::overlay_ink(*origin, self.dark);
            let points = decimate(&curve.points, columns);
            let style = if origin.is_dashed() { LineStyle::dashed_dense() } else { LineStyle::Solid };
            plot.line(stroked(tr(origin.name()), points, ink, LINE_WIDTH).style(style).allow_hover(false));
        }
    }

    fn exact_ink(&self) -> Color32 {
        EXACT_INKS[usize::from(!self.dark)]
    }

    /// The entries of the legend, from top to bottom.
    fn entries(&self) -> Vec<Entry> {
        let overlay = |overlay: &Overlay| Entry {
            name: tr(overlay.origin.name()),
            ink: Plots::overlay_ink(overlay.origin, self.dark),
            width: LINE_WIDTH,
            dashed: overlay.origin.is_dashed(),
        };
        let exact = Entry { name: tr(key::exact()), ink: self.exact_ink(), width: EXACT_WIDTH, dashed: false };
        let map = |ink| Entry { name: tr(key::this_map()), ink, width: LINE_WIDTH, dashed: false };
        let mut entries: Vec<Entry> = (!self.exact.is_empty()).then_some(exact).into_iter().collect();
        entries.extend(self.overlays.iter().rev().map(overlay));
        entries.dedup_by_key(|entry| entry.name);
        if self.kind == PlotKind::Reparameterization && !entries.is_empty() {
            entries.insert(0, map(self.lines[0].1));
        }
        entries
    }

    /// Paints the legend at the lower right, where the curves leave room: below the diagonal.
    fn legend(&self, ui: &Ui, area: Rect) {
        let palette = Palette::of(ui.visuals());
        let painter = ui.painter_at(area);
        for (row, Entry { name, ink, width, dashed }) in self.entries().into_iter().rev().enumerate() {
            let place = area.right_bottom() - vec2(10.0, 10.0 + 15.0 * row as f32);
            let text = painter.text(place, Align2::RIGHT_CENTER, name, FontId::proportional(11.0), palette.weak);
            let end = text.left_center() - vec2(5.0, 0.0);
            let (line, stroke) = ([end - vec2(SAMPLE, 0.0), end], Stroke::new(width, ink));
            if dashed {
                let (dash, gap) = DASHES;
                painter.extend(Shape::dashed_line(&line, stroke, dash, gap));
            } else {
                painter.line_segment(line, stroke);
            }
        }
    }

    fn add_marks(&self, plot: &mut PlotUi, marked: PerSide<f64>, palette: &Palette) {
        let PerSide { source, target } = marked;
        if self.kind == PlotKind::Reparameterization {
            let (x, y) = if self.mapped == Side::Source { (source, target) } else { (target, source) };
            plot.vline(VLine::new("", x).color(palette.weak).width(1.0).allow_hover(false));
            add_dot(plot, [x, y], self.lines[0].1);
            return;
        }
        for ((curve, ink), x) in self.lines.iter().zip(marked.into_array()) {
            plot.vline(VLine::new("", x).color(ink.gamma_multiply(0.6)).width(1.0).allow_hover(false));
            add_dot(plot, [x, self.ordinate(curve.at(x))], *ink);
        }
    }

    /// The side whose curve is nearest to the pointer in y, and the arc length at the pointer.
    fn pointed(&self, transform: &PlotTransform, pointer: Pos2) -> (Side, f64) {
        let x = transform.value_from_position(pointer).x.clamp(0.0, 1.0);
        if self.kind == PlotKind::Reparameterization {
            return (self.mapped, x);
        }
        let distance = |curve: &Curve| {
            let y = self.ordinate(curve.at(x));
            (transform.position_from_point(&PlotPoint::new(x, y)).y - pointer.y).abs()
        };
        let distances = Side::BOTH.into_iter().zip(&self.lines).map(|(side, (curve, _))| (side, distance(curve)));
        let nearest = distances.min_by(|(_, a), (_, b)| a.total_cmp(b));
        (nearest.map_or(Side::Source, |(side, _)| side), x)
    }
}

/// The curves' values at the marked points, formatted, by side.
pub fn values(kind: PlotKind, curves: &Curves, at: PerSide<f64>) -> PerSide<String> {
    PerSide::from_fn(|side| {
        let x = at[side];
        match kind {
            PlotKind::Kernel => short(curves.kernel[side].at(x)),
            PlotKind::Measure => number(curves.measure[side].at(x), 3),
            PlotKind::Reparameterization => number(x, 3),
        }
    })
}

/// The curves of both sides in their colours.
fn in_inks(curves: &PerSide<Curve>, theme: usize) -> Vec<(&Curve, Color32)> {
    curves.as_ref().into_array().into_iter().zip(SIDE_INKS[theme].into_array()).collect()
}

fn short(value: f64) -> String {
    if value == 0.0 || (0.01..1e4).contains(&value) { number(value, 2) } else { decimal(&format!("{value:.1e}")) }
}

/// A curve of even width. Where points are within a pixel of each other, `egui_plot` would else fill a band that has this
/// width vertically, so that steep parts are thin.
pub fn stroked(name: &str, points: Vec<[f64; 2]>, ink: Color32, width: f32) -> Line<'static> {
    Line::new(name, points).color(ink).width(width).allow_band(false)
}

fn add_dot(plot: &mut PlotUi, at: [f64; 2], ink: Color32) {
    plot.points(Points::new("", at).color(Color32::WHITE).radius(4.5).allow_hover(false));
    plot.points(Points::new("", at).color(ink).radius(3.2).allow_hover(false));
}

fn axis<'a>(hints: AxisHints<'a>, palette: &Palette, label: String) -> AxisHints<'a> {
    hints
        .label(RichText::new(label).size(11.0).color(palette.weak))
        .tick_label_color(palette.weak)
        .tick_label_font(FontId::proportional(10.5))
}

/// The linear axis of the kernel ends at `HEADROOM` times the value that ψ stays below on this share of the boundary:
/// near a re-entrant corner ψ is unbounded, and if the axis ended at its maximum, the rest would lie on the axis.
const SHOWN_SHARE: f64 = 0.98;
const HEADROOM: f64 = 1.5;

/// The range of the kernel's y axis: linear from 0 to the end described at [`SHOWN_SHARE`], or, as logarithms, from the
/// smallest positive value to the largest one, over at most [`MOST_DECADES`].
fn kernel_range(curves: &PerSide<Curve>, logarithmic: bool) -> (f64, f64) {
    let values = || curves.iter().flat_map(|(_, curve)| &curve.points).map(|p| p[1]);
    let high = values().fold(f64::MIN_POSITIVE, f64::max);
    if !logarithmic {
        let usual = curves.iter().map(|(_, curve)| quantile(&curve.points, SHOWN_SHARE)).fold(0.0, f64::max);
        return (0.0, high.min((HEADROOM * usual).max(f64::MIN_POSITIVE)));
    }
    let low = values().filter(|&y| y > 0.0).fold(high, f64::min);
    let (low, high) = (low.log10().floor(), high.log10().ceil());
    (low.max(high - MOST_DECADES), high.max(low + 1.0))
}

/// The value that a curve stays below on `share` of its length; 0 for an empty curve.
fn quantile(points: &[[f64; 2]], share: f64) -> f64 {
    let mut pieces: Vec<(f64, f64)> =
        points.windows(2).map(|pair| (pair[0][1].max(pair[1][1]), pair[1][0] - pair[0][0])).collect();
    sort_by_number(&mut pieces, |piece| piece.0);
    let total: f64 = pieces.iter().map(|piece| piece.1).sum();
    let mut sum = 0.0;
    let reached = |(_, length): &&(f64, f64)| {
        sum += length;
        sum >= share * total
    };
    pieces.iter().find(reached).map_or(0.0, |piece| piece.0)
}

fn fifths() -> Vec<GridMark> {
    (0..=5).map(|k| GridMark { value: f64::from(k) / 5.0, step_size: 0.2 }).collect()
}

/// Steps of 1, 2 or 5 times a power of ten, three to seven of them.
fn even_steps(input: &GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    let raw = (high - low) / 6.0;
    let power = 10_f64.powf(raw.log10().floor());
    let step_size = [1.0, 2.0, 5.0, 10.0].map(|k| k * power).into_iter().find(|&step| step >= raw).unwrap_or(raw);
    marks(low.max(0.0), high, step_size)
}

/// Whole decades, at most seven of them.
fn decades(input: &GridInput) -> Vec<GridMark> {
    let (low, high) = input.bounds;
    marks(low, high, ((high - low) / 6.0).ceil().max(1.0))
}

fn marks(low: f64, high: f64, step_size: f64) -> Vec<GridMark> {
    let (first, last) = ((low / step_size).ceil() as i64, (high / step_size).floor() as i64);
    (first..=last).map(|k| GridMark { value: k as f64 * step_size, step_size }).collect()
}

/// The mark's value with as many decimals as its step has.
fn of_step(mark: GridMark) -> String {
    let digits = (-mark.step_size.log10().floor()).max(0.0) as usize;
    number(mark.value, digits)
}

/// A power of ten with its exponent raised, such as "10⁻³"; the exponent is rounded.
pub fn power_of_ten(exponent: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    };
    let digits: String = (exponent.round() as i64).to_string().chars().map(raised).collect();
    format!("10{digits}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::overlays::overlay::Origin;
    use crate::session::DiskWay;

    fn curve(values: &[f64]) -> Curve {
        let points = values.iter().enumerate().map(|(k, &y)| [k as f64, y]).collect();
        Curve { name: String::new(), points }
    }

    /// The names in the legend of a kind of plot with all overlays, and with or without the exact curves.
    fn names(kind: PlotKind, exact: bool) -> Vec<&'static str> {
        let line = || curve(&[0.0, 1.0]);
        let curves = Curves {
            kernel: PerSide::new(line(), line()),
            measure: PerSide::new(line(), line()),
            reparameterisation: line(),
            mapped: Side::Source,
            anchors: PerSide::default(),
        };
        let known = ExactCurves { measure: PerSide::new(line(), line()), reparameterisation: line(), difference: 0.0 };
        let by = |origin| Overlay { origin, curve: line() };
        let [fresh, precomputed] = DiskWay::ALL.map(Origin::Disk);
        let mut overlays = Overlays::default();
        overlays.measure.extend([precomputed, precomputed, fresh, fresh, Origin::Walks].map(by));
        overlays.reparameterisation.extend([precomputed, fresh].map(by));
        let chart = Chart::of(kind, &curves, exact.then_some(&known), &overlays, true, false);
        let entries = chart.entries();
        for (k, entry) in entries.iter().enumerate() {
            assert!(entries[..k].iter().all(|other| other.ink != entry.ink), "{} shares its color", entry.name);
        }
        entries.iter().map(|entry| entry.name).collect()
    }

    #[test]
    fn every_curve_has_its_own_ink_and_its_line_in_the_legend() {
        let [fresh, precomputed] = DiskWay::ALL.map(|way| tr(Origin::Disk(way).name()));
        assert_eq!(names(PlotKind::Reparameterization, true), ["this map", "exact", fresh, precomputed]);
        assert_eq!(names(PlotKind::Reparameterization, false), ["this map", fresh, precomputed]);
        assert_eq!(names(PlotKind::Measure, true), ["exact", "random walks", fresh, precomputed]);
        assert_eq!(names(PlotKind::Kernel, true), [""; 0], "kernels have no overlays");
    }

    /// Whether a curve through a thousand points, with a step, is painted as a stroke.
    fn is_stroke(line: impl Fn(Vec<[f64; 2]>) -> Line<'static> + 'static) -> bool {
        let step = |k: i32| [f64::from(k) / 1000.0, (f64::from(k - 500) / 20.0).tanh()];
        let show = move |ui: &mut Ui| {
            Plot::new("step").show(ui, |plot| plot.line(line((0..=1000).map(step).collect())));
        };
        let mut harness = egui_kittest::Harness::builder()
            .with_size([300.0, 200.0])
            .with_context_setup(crate::app::theme::install)
            .build_ui(show);
        harness.run();
        let is_curve = |shape: &Shape| matches!(shape, Shape::Path(path) if path.points.len() > 200);
        harness.output().shapes.iter().any(|clipped| is_curve(&clipped.shape))
    }

    #[test]
    fn steep_curves_are_as_wide_as_flat_ones() {
        assert!(is_stroke(|points| stroked("step", points, Color32::WHITE, LINE_WIDTH)));
        assert!(!is_stroke(|points| Line::new("step", points)), "egui_plot's own is a band");
    }

    #[test]
    fn the_kernels_axis_holds_both_curves() {
        let curves = PerSide::new(curve(&[0.5, 1.0, 0.0]), curve(&[3.0, 2e-7]));
        assert_eq!(kernel_range(&curves, false), (0.0, 3.0));
        let flat_with_a_spike: Vec<f64> = (0..1000).map(|k| if k == 500 { 400.0 } else { 2.0 }).collect();
        assert_eq!(kernel_range(&PerSide::new(curve(&flat_with_a_spike), curve(&[1.0, 1.0])), false), (0.0, 3.0));
        assert_eq!(kernel_range(&curves, true), (-7.0, 1.0));
        let crowded = PerSide::new(curve(&[1e-200, 20.0]), curve(&[1.0]));
        assert_eq!(kernel_range(&crowded, true), (2.0 - MOST_DECADES, 2.0));
    }

    #[test]
    fn grid_lines_lie_at_round_values() {
        let input = |low, high| GridInput { bounds: (low, high), base_step_size: 0.01 };
        let values = |marks: Vec<GridMark>| marks.iter().map(|mark| mark.value).collect::<Vec<_>>();
        assert_eq!(values(even_steps(&input(-0.1, 3.9))), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(values(decades(&input(-14.2, 2.1))), [-12.0, -9.0, -6.0, -3.0, 0.0]);
        assert_eq!(of_step(GridMark { value: 0.4, step_size: 0.2 }), "0.4");
        assert_eq!(of_step(GridMark { value: 40.0, step_size: 20.0 }), "40");
        assert_eq!((power_of_ten(-12.0), power_of_ten(3.0)), (String::from("10⁻¹²"), String::from("10³")));
    }
}

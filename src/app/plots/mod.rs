//! The plots of Poisson kernel, harmonic measure and reparameterization over the arc length, updated with the map.
//!
//! They are shown in a column beside the viewports where these need no more width, else in a dock below: three in a row,
//! or one at a time in a dock narrower than 900 points; on a phone one at a time in the sheet. Pointing at a plot marks the boundary point and the corresponding one of the
//! other side in both viewports; pointing at a boundary marks both in the plots.

mod chart;
mod convergence;
mod ladder;
mod legend;

pub use convergence::convergence_chart;
pub use ladder::ladder_chart;

use super::theme::{self, Palette};
use crate::app::input::action::{Action, Actions, PlotKind, PlotsAction};
use crate::app::language::words;
use crate::app::theme::widgets::{Segment, dot, segmented};
use crate::conformal::{PerSide, Side};
use crate::language::{Label, key, tr};
use crate::model::Model;
use crate::model::curves::{Curves, ExactCurves, KeptExact};
use crate::model::overlays::overlay::{Origin, Overlays};
use crate::session::DiskWay;
use egui::{Align, Color32, Layout, RichText, Ui, UiBuilder, Vec2};

/// The height of the dock with all plots in a row.
const ROW_HEIGHT: f32 = 212.0;
/// The height of the dock with one plot below a switch.
const ONE_HEIGHT: f32 = 260.0;
/// A dock narrower than this shows one plot at a time: three would be narrower than their titles.
const ROW_FROM: f32 = 900.0;

/// The least height of the dock: a plot with its title and the switch.
const LEAST_HEIGHT: f32 = 176.0;

/// The height of a dock of this width, where dock and pictures share the height `both`: at most half of it, but at
/// least [`LEAST_HEIGHT`].
pub fn dock_height(width: f32, both: f32) -> f32 {
    let wanted = if width < ROW_FROM { ONE_HEIGHT } else { ROW_HEIGHT };
    wanted.min((0.5 * both).max(LEAST_HEIGHT))
}

/// The width of a column of plots beside the pictures, as a share of their common width, and its limits, in points.
const COLUMN_SHARE: f32 = 0.22;
const COLUMN: [f32; 2] = [280.0, 400.0];
/// From the edges of a picture to its outline, left and right together, and above and below together.
const AROUND: [f32; 2] = [60.0, 112.0];
/// The plots stand beside the pictures if these keep at least this share of the size that they have above the plots. On
/// 1280×720 it is 0.94, on 1920×1080 0.85: the width is not needed there. On 1440×900 it is 0.77.
const KEPT_BESIDE: f32 = 0.82;
/// A column lower than this shows one plot at a time.
const COLUMN_FROM: f32 = 520.0;
/// The free space between the plots of a column.
const COLUMN_GAP: f32 = 8.0;

/// The width of a column of plots beside pictures that share `both` with it; `None` where they are better below.
pub fn width_beside(both: Vec2) -> Option<f32> {
    let column = (COLUMN_SHARE * both.x).clamp(COLUMN[0], COLUMN[1]);
    let size = |width: f32, height: f32| (0.5 * width - AROUND[0]).min(height - AROUND[1]).max(0.0);
    let (below, beside) = (size(both.x, both.y - dock_height(both.x, both.y)), size(both.x - column, both.y));
    (both.x > both.y && beside >= KEPT_BESIDE * below && beside > 0.0).then_some(column)
}

const KINDS: [Segment<PlotKind>; 3] = [
    Segment { value: PlotKind::Kernel, label: key::poisson_kernel(), tooltip: key::poisson_kernel_tooltip() },
    Segment { value: PlotKind::Measure, label: key::harmonic_measure(), tooltip: key::harmonic_measure_tooltip() },
    Segment {
        value: PlotKind::Reparameterization,
        label: key::reparameterisation(),
        tooltip: key::reparameterisation_tooltip(),
    },
];

/// A point of a boundary, by its fraction of the outline's arc length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryPlace {
    side: Side,
    fraction: f64,
}

/// The curves, and the state of the plots on the screen.
#[derive(Debug, Default)]
pub struct Plots {
    /// The curves, with the generation of their map.
    curves: Option<(u64, Curves)>,
    /// The exact curves, with the generation of their map.
    exact: Option<(u64, KeptExact)>,
    /// Whether the kernel's y axis is logarithmic.
    logarithmic: bool,
    /// The plot that is shown where there is room for one.
    shown: PlotKind,
    /// The place under the pointer in the plots in the last frame and in this one: the former marks the plots that are
    /// drawn before the one under the pointer.
    in_plot: Option<BoundaryPlace>,
    found: Option<BoundaryPlace>,
    in_view: Option<BoundaryPlace>,
}

impl Plots {
    /// Makes the place under the pointer that of the last frame, and brings the curves up to date.
    pub fn begin_frame(&mut self, model: &Model) {
        self.in_plot = self.found.take();
        self.update(model);
    }

    /// Applies the action of a switch.
    pub fn act(&mut self, action: PlotsAction) {
        match action {
            PlotsAction::Show(kind) => self.shown = kind,
            PlotsAction::ToggleLogarithm => self.logarithmic = !self.logarithmic,
        }
    }

    /// Stores the place under the pointer in the plots of this frame.
    pub fn point_in_plots(&mut self, found: Option<BoundaryPlace>) {
        self.found = found;
    }

    /// Stores the boundary point under the pointer in a viewport; returns whether it changed.
    pub fn point_at(&mut self, place: Option<(Side, f64)>) -> bool {
        let place = place.map(|(side, fraction)| BoundaryPlace { side, fraction });
        std::mem::replace(&mut self.in_view, place) != place
    }

    /// Recomputes the curves if the map has changed and the plots are open or a place is marked.
    pub fn update(&mut self, model: &Model) {
        let needed = model.session().plots() || self.pointed().is_some();
        let generation = model.generation();
        if needed && self.generation() != Some(generation) {
            let session = model.session();
            let anchors = PerSide::from_fn(|side| session.side(side).points().anchor());
            let curves = model.map().map(|map| Curves::new(map, anchors));
            self.curves = curves.map(|curves| (generation, curves)).or(self.curves.take());
        }
        if model.session().plots() {
            self.update_exact(model, generation);
        }
    }

    fn update_exact(&mut self, model: &Model, generation: u64) {
        let is_known = self.exact.as_ref().is_some_and(|(known, _)| *known == generation);
        let (false, Some((_, curves)), Some(domains)) =
            (is_known, &self.curves, PerSide::from_fn(|side| model.domain(side)).both())
        else {
            return;
        };
        let session = model.session();
        let (stamp, kept) = self.exact.get_or_insert_default();
        kept.update(model.exact_presets(), session.constraints(domains.map(|domain| domain.default_point())), curves);
        *stamp = generation;
    }

    /// The exact curves of the map in the plots; `None` where no closed form is known or the curves are of another map.
    pub fn exact(&self) -> Option<&ExactCurves> {
        let (_, kept) = self.exact.as_ref().filter(|(generation, _)| self.generation() == Some(*generation))?;
        kept.curves()
    }

    /// The marked boundary point and the corresponding one, as fractions of arc length of source and target.
    pub fn marked(&self) -> Option<PerSide<f64>> {
        let (curves, at) = (self.curves()?, self.marked_from_anchor(None)?);
        Some(PerSide::from_fn(|side| curves.fraction(side, at[side])))
    }

    /// The colors of source and target.
    pub fn inks(dark: bool) -> PerSide<Color32> {
        chart::SIDE_INKS[usize::from(!dark)]
    }

    /// The color of the reparameterization of the shown map.
    pub fn map_ink(dark: bool) -> Color32 {
        chart::MAP_INKS[usize::from(!dark)][0]
    }

    /// The color of the curves of `origin`.
    pub fn overlay_ink(origin: Origin, dark: bool) -> Color32 {
        let theme = usize::from(!dark);
        match origin {
            Origin::Disk(DiskWay::Fresh) => chart::MAP_INKS[theme][1],
            Origin::Disk(DiskWay::Precomputed) => chart::MAP_INKS[theme][2],
            Origin::Walks => chart::WALK_INKS[theme],
        }
    }

    fn generation(&self) -> Option<u64> {
        self.curves.as_ref().map(|(generation, _)| *generation)
    }

    fn curves(&self) -> Option<&Curves> {
        self.curves.as_ref().map(|(_, curves)| curves)
    }

    fn pointed(&self) -> Option<BoundaryPlace> {
        self.found.or(self.in_plot).or(self.in_view)
    }

    /// As [`Self::marked`], with arc lengths measured from the anchors; of the place `found` in a plot, if there is one.
    fn marked_from_anchor(&self, found: Option<BoundaryPlace>) -> Option<PerSide<f64>> {
        let (curves, place) = (self.curves()?, found.or(self.pointed())?);
        let x = curves.along(place.side, place.fraction);
        let there = curves.partner(place.side, x);
        Some(if place.side == Side::Source { PerSide::new(x, there) } else { PerSide::new(there, x) })
    }

    /// Shows three plots in a row where they fit, else one; returns the place under the pointer.
    pub fn show_dock(&self, ui: &mut Ui, model: &Model, width: f32, actions: &mut Actions) -> Option<BoundaryPlace> {
        if width < ROW_FROM { self.show_one(ui, model, actions) } else { self.show_row(ui, model, actions) }
    }

    fn show_row(&self, ui: &mut Ui, model: &Model, actions: &mut Actions) -> Option<BoundaryPlace> {
        let none = Overlays::default();
        let overlays = model.overlays().unwrap_or(&none);
        ui.spacing_mut().item_spacing.x = 18.0;
        let mut found = None;
        ui.columns_const(|columns: &mut [Ui; KINDS.len()]| {
            for (ui, kind) in columns.iter_mut().zip(&KINDS) {
                found = self.show_plot(ui, kind, overlays, found, actions).or(found);
            }
        });
        self.settle(ui, found)
    }

    /// Shows three plots one above the other where they fit into `height`, else one; returns the place under the pointer.
    pub fn show_column(&self, ui: &mut Ui, model: &Model, height: f32, actions: &mut Actions) -> Option<BoundaryPlace> {
        if height < COLUMN_FROM {
            return self.show_one(ui, model, actions);
        }
        let none = Overlays::default();
        let overlays = model.overlays().unwrap_or(&none);
        let whole = ui.available_rect_before_wrap();
        let each = (whole.height() - COLUMN_GAP * (KINDS.len() - 1) as f32) / KINDS.len() as f32;
        let mut found = None;
        for (k, kind) in KINDS.iter().enumerate() {
            let top = whole.top() + k as f32 * (each + COLUMN_GAP);
            let place = whole.with_min_y(top).with_max_y(top + each);
            ui.scope_builder(UiBuilder::new().id_salt(("plot", k)).max_rect(place), |ui| {
                found = self.show_plot(ui, kind, overlays, found, actions).or(found);
            });
        }
        self.settle(ui, found)
    }

    /// Shows one plot below a switch; returns the place under the pointer.
    pub fn show_one(&self, ui: &mut Ui, model: &Model, actions: &mut Actions) -> Option<BoundaryPlace> {
        let none = Overlays::default();
        let overlays = model.overlays().unwrap_or(&none);
        let short = [(key::kernel(), 0), (key::measure(), 1), (key::reparam(), 2)];
        let kinds = short.map(|(label, k): (Label, usize)| Segment { label, ..KINDS[k] });
        if let Some(kind) = segmented(ui, &kinds, self.shown) {
            actions.push(Action::Plots(PlotsAction::Show(kind)));
        }
        let kind = KINDS.iter().find(|kind| kind.value == self.shown);
        let found = kind.and_then(|kind| self.show_plot(ui, kind, overlays, None, actions));
        self.settle(ui, found)
    }

    /// Requests another frame if the place under the pointer changed: earlier plots of this frame lack its mark.
    fn settle(&self, ui: &Ui, found: Option<BoundaryPlace>) -> Option<BoundaryPlace> {
        if found != self.in_plot {
            ui.request_repaint();
        }
        found
    }

    /// Shows a plot; `found` is the place under the pointer in the plots before it. Returns the place in this one.
    fn show_plot(
        &self,
        ui: &mut Ui,
        kind: &Segment<PlotKind>,
        overlays: &Overlays,
        found: Option<BoundaryPlace>,
        actions: &mut Actions,
    ) -> Option<BoundaryPlace> {
        let marked = self.marked_from_anchor(found);
        self.header(ui, kind, marked, actions);
        let (_, curves) = self.curves.as_ref()?;
        let chart =
            chart::Chart::of(kind.value, curves, self.exact(), overlays, ui.visuals().dark_mode, self.logarithmic);
        let (side, x) = chart.show(ui, marked)?;
        Some(BoundaryPlace { side, fraction: curves.fraction(side, x) })
    }

    /// The title, the sides' colors, and the values at the marked point or else the sides' names.
    fn header(&self, ui: &mut Ui, kind: &Segment<PlotKind>, marked: Option<PerSide<f64>>, actions: &mut Actions) {
        let palette = Palette::of(ui.visuals());
        let inks = Self::inks(ui.visuals().dark_mode);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().interact_size.y = theme::control_height(ui, 20.0);
            let title = RichText::new(tr(kind.label)).font(theme::bold(12.5)).color(palette.text);
            ui.label(title).on_hover_text(tr(kind.tooltip));
            if kind.value == PlotKind::Kernel {
                self.scale_switch(ui, actions);
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let values = marked.and_then(|at| Some(chart::values(kind.value, self.curves()?, at)));
                // one curve belongs to both sides
                let is_map = kind.value == PlotKind::Reparameterization;
                if is_map && values.is_none() {
                    ui.label(RichText::new(tr(key::this_map())).small().color(palette.weak));
                }
                for side in [Side::Target, Side::Source].into_iter().filter(|_| !is_map || values.is_some()) {
                    let text = values
                        .as_ref()
                        .map_or_else(|| words::side_within(side).to_owned(), |values| values[side].clone());
                    ui.label(RichText::new(text).small().color(palette.weak));
                    if !is_map {
                        dot(ui, inks[side]);
                    }
                }
                if is_map {
                    dot(ui, chart::MAP_INKS[usize::from(!ui.visuals().dark_mode)][0]);
                }
            });
        });
    }

    fn scale_switch(&self, ui: &mut Ui, actions: &mut Actions) {
        let tooltip = key::log_tooltip();
        let label = RichText::new(tr(key::log())).small();
        ui.spacing_mut().button_padding = egui::vec2(6.0, 1.0);
        let button = egui::Button::selectable(self.logarithmic, label).frame_when_inactive(true);
        if ui.add(button).on_hover_text(tr(tooltip)).clicked() {
            actions.push(Action::Plots(PlotsAction::ToggleLogarithm));
        }
    }
}

/// The groups of colors that occur together in a plot, for each plot and theme.
#[cfg(test)]
pub fn inks_of_plots() -> Vec<Vec<egui::Color32>> {
    let of_theme = |theme: usize| {
        let PerSide { source, target } = chart::SIDE_INKS[theme];
        [vec![source, target, chart::WALK_INKS[theme]], chart::MAP_INKS[theme].to_vec()]
    };
    [0, 1].into_iter().flat_map(of_theme).collect()
}

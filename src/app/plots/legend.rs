//! The legend of a chart in a window: beside the plot where there is room, else below it, never over the curves.

use super::chart::{DASHES, SAMPLE};
use crate::app::theme::Palette;
use egui::{Color32, RichText, Sense, Shape, Stroke, Ui, vec2};
use egui_plot::{AxisHints, Plot};

/// The width of lines in these charts, and of their samples.
pub const WIDTH: f32 = 1.75;
/// The radius of the points on them.
pub const RADIUS: f32 = 3.5;

/// The height of a plot.
const HEIGHT: f32 = 340.0;
/// The width of a legend beside the plot, and the least width of a plot that has it there.
const BESIDE: f32 = 190.0;
const LEAST: f32 = 380.0;
/// Free space around plot and legend, so that labels of axes do not touch the window's edge.
const FREE: i8 = 8;

/// A curve in the legend.
pub struct Entry {
    /// What it shows.
    pub name: String,
    /// Its color.
    pub ink: Color32,
    /// Whether it is dashed.
    pub dashed: bool,
}

/// Lays out a plot, which `plot` shows, and its legend.
pub fn with_legend(ui: &mut Ui, name: &'static str, entries: &[Entry], plot: impl FnOnce(&mut Ui, Plot<'_>)) {
    let sized = |width: f32| bare(name, width);
    egui::Frame::new().inner_margin(FREE).show(ui, |ui| {
        let width = ui.available_width();
        let is_beside = width >= LEAST + BESIDE;
        if is_beside {
            ui.horizontal_top(|ui| {
                let room = (width - BESIDE - ui.spacing().item_spacing.x).min(620.0);
                ui.vertical(|ui| {
                    ui.set_width(room);
                    plot(ui, sized(room));
                });
                ui.vertical(|ui| {
                    ui.set_width(BESIDE);
                    for entry in entries {
                        row(ui, entry);
                    }
                });
            });
        } else {
            plot(ui, sized(width));
            for entry in entries {
                row(ui, entry);
            }
        }
    });
}

/// A plot of this width that only shows.
fn bare(name: &'static str, width: f32) -> Plot<'static> {
    Plot::new(name)
        .sense(Sense::hover())
        .height(HEIGHT)
        .width(width)
        .set_margin_fraction(vec2(0.06, 0.06))
        .allow_scroll(false)
        .allow_drag(false)
        .allow_zoom(false)
        .allow_boxed_zoom(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(false)
        .show_background(false)
        .show_x(false)
        .show_y(false)
        .show_crosshair(false)
        .grid_fade(0.0)
}

/// The vertical axis of errors.
pub fn error_axis(label: &str) -> AxisHints<'static> {
    AxisHints::new_y().label(label.to_owned()).min_thickness(44.0)
}

fn row(ui: &mut Ui, Entry { name, ink, dashed }: &Entry) {
    let palette = Palette::of(ui.visuals());
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let (rect, _) = ui.allocate_exact_size(vec2(SAMPLE + 2.0 * RADIUS, 15.0), Sense::hover());
        let line = [rect.left_center(), rect.right_center()];
        let stroke = Stroke::new(WIDTH, *ink);
        if *dashed {
            let (dash, gap) = DASHES;
            ui.painter().extend(Shape::dashed_line(&line, stroke, dash, gap));
        } else {
            ui.painter().line_segment(line, stroke);
        }
        ui.painter().circle_filled(rect.center(), RADIUS, *ink);
        ui.add(egui::Label::new(RichText::new(name).small().color(palette.text)).wrap());
    });
}

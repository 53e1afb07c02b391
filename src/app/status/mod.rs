//! The status line: quality Q̄, flipped triangles, times, frame rate, graphics API.

mod best;
pub mod pointed;
pub mod stats;
mod symmetries;
pub mod window_stats;

use super::theme::{self, Palette};
use crate::app::language::words;
use crate::app::language::words::grouped;
use crate::app::theme::text_metrics::text_width;
use crate::app::theme::widgets::caption_font;
use crate::conformal::Side;
use crate::language::{key, number, say, tr};
use crate::model::{Model, PointedImage, SideKernel};
use egui::{Align, Layout, RichText, Ui};

/// The bar of Q̄ from the top of its line, relative to the font's size: Inter's capitals begin at 0.24.
const BAR_ABOVE: f32 = 0.1;

/// A longer time between two frames is not counted for the frame rate: nothing moved meanwhile.
const PAUSE_SECONDS: f32 = 0.1;

/// The first frames, whose times are not counted: they build fonts and pipelines.
const WARM_UP_FRAMES: u32 = 4;

/// Running averages of frame interval and drawing time.
#[derive(Debug, Clone, Default)]
pub struct FrameMeter {
    frame_seconds: Option<f32>,
    draw_ms: f64,
    frames: u32,
}

impl FrameMeter {
    /// Records the time since the last frame, that frame's CPU time, and the part of it that computed the map.
    pub fn tick(&mut self, since_last: f32, cpu_seconds: Option<f32>, compute_ms: f64) {
        if since_last > 0.0 && since_last < PAUSE_SECONDS {
            let old = self.frame_seconds.unwrap_or(since_last);
            self.frame_seconds = Some(0.9 * old + 0.1 * since_last);
        }
        self.frames = self.frames.saturating_add(1);
        if let Some(seconds) = cpu_seconds.filter(|_| self.frames > WARM_UP_FRAMES) {
            let draw = (f64::from(seconds) * 1e3 - compute_ms).max(0.0);
            self.draw_ms = if self.draw_ms == 0.0 { draw } else { 0.8 * self.draw_ms + 0.2 * draw };
        }
    }

    fn frames_per_second(&self) -> Option<f32> {
        self.frame_seconds.map(|seconds| 1.0 / seconds)
    }
}

fn tenths(ms: f64) -> String {
    number(ms, 1)
}

fn hundredths(ms: f64) -> String {
    number(ms, 2)
}

/// The width that the backend's name needs, in points.
const BACKEND_FROM: f32 = 52.0;

/// Shows the line.
pub fn show(
    ui: &mut Ui,
    model: &Model,
    meter: &FrameMeter,
    backend: [&str; 2],
    pointed: Option<(&PointedImage, usize)>,
    narrow: bool,
) {
    match pointed {
        Some((image, decimals)) if narrow => {
            ui.horizontal_centered(|ui| pointed::show(ui, image, decimals));
        }
        _ => facts(ui, model, meter, backend, pointed, narrow),
    }
}

/// Quality, error, times; at the right the point under the pointer, or a hint and the backend.
fn facts(
    ui: &mut Ui,
    model: &Model,
    meter: &FrameMeter,
    [backend, adapter]: [&str; 2],
    pointed: Option<(&PointedImage, usize)>,
    narrow: bool,
) {
    let palette = Palette::of(ui.visuals());
    let weak = |text: String| RichText::new(text).small().color(palette.weak);
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = if narrow { 12.0 } else { 20.0 };
        if let Some(quality) = model.quality() {
            let largest = say(&key::largest_q(number(quality.q_max, 3)));
            let tooltip = format!("{}\n\n{largest}", tr(words::QUALITY_TOOLTIP));
            mean_q(ui, quality.resolved_mean(), palette.weak).on_hover_text(tooltip);
            if quality.collapsed > 0 {
                let share = say(&key::collapsed_area(number(100.0 * quality.collapsed_area, 2)));
                ui.label(weak(share)).on_hover_text(tr(key::collapsed_area_tooltip()));
            }
            let ink = if quality.flipped == 0 { palette.weak } else { palette.error_edge };
            let flipped = say(&key::flipped(grouped(quality.flipped as usize)));
            ui.label(RichText::new(flipped).small().color(ink)).on_hover_text(tr(words::FLIPPED_TOOLTIP));
        }
        sharpness(ui, model);
        if let Some((image, decimals)) = pointed {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| pointed::show(ui, image, decimals));
            return;
        }
        if let Some(map) = model.shown() {
            let t = map.timings;
            let compute = t.kernel + t.matching + t.extend;
            let split = say(&key::frame_parts(hundredths(t.kernel), hundredths(t.matching), hundredths(t.extend)));
            if model.is_pending() {
                ui.label(weak(String::from(tr(words::PENDING)))).on_hover_text(tr(words::PENDING_TOOLTIP));
            }
            let times = say(&key::frame_times(tenths(compute), tenths(meter.draw_ms)));
            if text_width(ui, &times, caption_font(ui)) <= ui.available_width() {
                ui.label(weak(times)).on_hover_text(format!("{}\n\n{split}", tr(words::FRAME_TOOLTIP)));
            }
        }
        if let (Some(rate), false) = (meter.frames_per_second(), narrow) {
            ui.label(weak(say(&key::fps(f64::from(rate.round()))))).on_hover_text(tr(key::fps_tooltip()));
        }
        if !narrow {
            sizes(ui, model);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if !narrow {
                let hint = tr(model.hint(theme::suits_fingers(ui)));
                if text_width(ui, hint, caption_font(ui)) + BACKEND_FROM <= ui.available_width() {
                    ui.label(weak(hint.to_owned()));
                }
            }
            if ui.available_width() >= BACKEND_FROM {
                ui.label(weak(String::from(backend))).on_hover_text(adapter);
            }
        });
    });
}

/// m, n and the times of preparation of both sides, where there is room.
fn sizes(ui: &mut Ui, model: &Model) {
    let prepared = || Side::BOTH.into_iter().filter_map(|side| Some((side, &**model.prepared(side)?)));
    let text = words::sizes(prepared().map(|(_, prepared)| prepared));
    let room = ui.available_width() - BACKEND_FROM - ui.spacing().item_spacing.x;
    if prepared().next().is_none() || text_width(ui, &text, caption_font(ui)) > room {
        return;
    }
    let of_side = |(side, prepared)| format!("{}\n{}", words::side(side), words::details(prepared));
    let details = prepared().map(of_side).collect::<Vec<_>>().join("\n\n");
    ui.label(RichText::new(text).small().color(Palette::of(ui.visuals()).weak)).on_hover_text(details);
}

/// Q̄ and its value, or that it is not resolved. The bar is painted: the combining character is not placed over the letter before it.
fn mean_q(ui: &mut Ui, mean: Option<f64>, ink: egui::Color32) -> egui::Response {
    let value = mean.map_or_else(|| String::from(tr(key::quality_unresolved())), |mean| number(mean, 3));
    let response = ui.label(RichText::new(format!("Q {value}")).small().color(ink));
    let font = egui::TextStyle::Small.resolve(ui.style());
    let (left, above) = (response.rect.left(), response.rect.top() + BAR_ABOVE * font.size);
    let width = text_width(ui, "Q", font);
    ui.painter().hline(left..=left + width, above, egui::Stroke::new(1.0, ink));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, format!("Q̄ {value}")));
    response
}

/// The estimate of the error, or why there is none: sides are being sharpened, or stay with finite elements; and how far
/// the map is refined.
fn sharpness(ui: &mut Ui, model: &Model) {
    let palette = Palette::of(ui.visuals());
    let weak = |text: String| RichText::new(text).small().color(palette.weak);
    if Side::BOTH.into_iter().any(|side| model.is_sharpening(side)) {
        ui.label(weak(String::from(tr(key::sharpening())))).on_hover_text(tr(key::sharpening_tooltip()));
    } else if let Some(bounds) = model.error_bounds() {
        let tooltip = format!("{} {:.0e}", tr(key::error_estimate_tooltip()), bounds.omega);
        ui.label(weak(say(&key::error_estimate(format!("{:.0e}", bounds.image))))).on_hover_text(tooltip);
    }
    if model.is_sharp() && model.is_refining() {
        ui.label(weak(String::from(tr(key::refining())))).on_hover_text(tr(key::refining_tooltip()));
    } else if let Some(share) = model.unresolved_area().filter(|share| *share > 0.0) {
        ui.label(weak(say(&key::unresolved(format!("{share:.0e}"))))).on_hover_text(tr(key::unresolved_tooltip()));
    }
    for side in Side::BOTH {
        if let Some(SideKernel::Stays(reason)) = model.side_kernel(side) {
            let tooltip = format!("{} {}", tr(key::finite_elements_tooltip()), say(&reason));
            let text = say(&key::kernel_of(words::side(side), tr(key::finite_elements())));
            ui.label(weak(text)).on_hover_text(tooltip);
        }
    }
}

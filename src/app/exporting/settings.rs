//! The choices in the window of exports.

use super::window::{Exporter, Surroundings};
use super::wish::Kind;
use crate::app::language::{tr, tr_message, tr_with};
use crate::app::play_panel;
use crate::app::theme::Palette;
use crate::conformal::Side;
use crate::export::FileFormat;
use crate::family::Path;
use crate::render::{FilmFormat, MOST_FRAMES, SECONDS};
use egui::{Button, DragValue, Response, RichText, Ui, vec2};

/// Sizes that can be had by one click.
const SIZES: [([u32; 2], &str); 4] = [
    ([800, 450], "800 × 450"),
    ([1600, 900], "1600 × 900"),
    ([3840, 2160], "3840 × 2160"),
    ([1080, 1080], "1080 × 1080"),
];
/// Sides of a picture, in pixels; fewer where the graphics device has smaller textures.
const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;
impl Exporter {
    /// The kinds of files, and what is in the chosen one.
    pub(super) fn kinds(&mut self, ui: &mut Ui, around: Surroundings, height: f32) {
        ui.horizontal_wrapped(|ui| {
            for &kind in Kind::all(around.on_surface) {
                if self.choice(ui, kind.label(), kind.label(), self.wish.kind == kind, height).clicked() {
                    self.wish.kind = kind;
                }
            }
        });
        let weak = Palette::of(ui.visuals()).weak;
        ui.label(RichText::new(self.wish.kind.explained(around.on_surface)).small().color(weak));
        ui.add_space(4.0);
    }

    /// The rows of a table: what can be chosen about the kind of file.
    pub(super) fn settings(&mut self, ui: &mut Ui, around: Surroundings, height: f32) {
        let kind = self.wish.kind;
        if kind.is_drawn() {
            self.size(ui, around, height);
        }
        let drawing = kind == Kind::File(FileFormat::Svg) && !around.on_surface;
        if kind.is_drawn() || drawing {
            self.sides(ui, height);
        }
        if kind.is_drawn() {
            ui.label(tr("Ground"));
            let transparent = ui.checkbox(&mut self.wish.transparent, tr("Transparent"));
            self.note("Transparent", &transparent.on_hover_text(tr("Without the colour behind the map")));
            ui.end_row();
        }
        if let Kind::Film(format) = kind {
            self.film(ui, around, height, format);
        }
        if around.on_surface && matches!(kind, Kind::File(format) if format != FileFormat::Svg) {
            ui.label(tr("Coordinates"));
            ui.horizontal(|ui| {
                for (unit, name, label, tooltip) in [
                    (
                        true,
                        "Unit box",
                        tr("Unit box"),
                        tr("Texture coordinates are moved and scaled into the unit box"),
                    ),
                    (false, "True scale", tr("True scale"), tr("Texture coordinates are the outline's own")),
                ] {
                    let choice = self.choice(ui, name, label, self.wish.unit == unit, height);
                    if choice.on_hover_text(tooltip).clicked() {
                        self.wish.unit = unit;
                    }
                }
            });
            ui.end_row();
        }
    }

    fn size(&mut self, ui: &mut Ui, around: Surroundings, height: f32) {
        ui.label(tr("Size"));
        let most = around.max_side.min(*SIDES.end());
        ui.vertical(|ui| {
            ui.horizontal_wrapped(|ui| {
                for (size, label) in SIZES.into_iter().filter(|(size, _)| size.iter().all(|&side| side <= most)) {
                    if self.choice(ui, label, label, self.wish.size == size, height).clicked() {
                        self.wish.size = size;
                    }
                }
            });
            ui.horizontal(|ui| {
                for (k, name) in [(0, tr("Width in pixels")), (1, tr("Height in pixels"))] {
                    let field = DragValue::new(&mut self.wish.size[k]).range(*SIDES.start()..=most).suffix(" px");
                    let response = ui.add_sized([84.0, height], field).on_hover_text(name);
                    self.note(if k == 0 { "Width" } else { "Height" }, &response);
                    if k == 0 {
                        ui.label("×");
                    }
                }
            });
        });
        ui.end_row();
    }

    fn sides(&mut self, ui: &mut Ui, height: f32) {
        ui.label(tr("Show"));
        ui.horizontal(|ui| {
            let sides = [
                (None, "Both", tr("Both")),
                (Some(Side::Source), "Source", tr("Source")),
                (Some(Side::Target), "Target", tr("Target")),
            ];
            for (side, name, label) in sides {
                if self.choice(ui, name, label, self.wish.side == side, height).clicked() {
                    self.wish.side = side;
                }
            }
        });
        ui.end_row();
    }

    fn film(&mut self, ui: &mut Ui, around: Surroundings, height: f32, format: FilmFormat) {
        ui.label(tr("Motion"));
        ui.horizontal(|ui| {
            for segment in &play_panel::PATHS {
                let fixed = around.on_surface && segment.value == Path::TargetPoint;
                ui.add_enabled_ui(!fixed, |ui| {
                    let is_chosen = self.wish.path == segment.value;
                    let choice = self.choice(ui, segment.label, tr(segment.label), is_chosen, height);
                    if choice.on_hover_text(tr(segment.tooltip)).clicked() {
                        self.wish.path = segment.value;
                    }
                });
            }
        });
        ui.end_row();
        ui.label(tr("Duration"));
        let seconds = DragValue::new(&mut self.wish.seconds).range(SECONDS).speed(0.1).max_decimals(1).suffix(" s");
        let response = ui.add_sized([84.0, height], seconds).on_hover_text(tr("How long a turn takes"));
        self.note("Duration", &response);
        ui.end_row();
        ui.label(tr("Pictures"));
        ui.horizontal(|ui| {
            let frames = DragValue::new(&mut self.wish.frames).range(2..=MOST_FRAMES);
            let response = ui.add_sized([84.0, height], frames).on_hover_text(tr("How many pictures a turn has"));
            self.note("Pictures", &response);
            let rate = f64::from(self.wish.frames) / self.wish.seconds;
            let weak = Palette::of(ui.visuals()).weak;
            ui.label(RichText::new(tr_with("{0} per second", &[&format!("{rate:.0}")])).color(weak));
        });
        ui.end_row();
        if let Err(error) = self.wish.film(format).check() {
            let ink = Palette::of(ui.visuals()).error_edge;
            ui.label("");
            ui.label(RichText::new(tr_message(&error.to_string())).small().color(ink));
            ui.end_row();
        }
    }

    fn choice(
        &mut self,
        ui: &mut Ui,
        name: &'static str,
        label: &'static str,
        is_chosen: bool,
        height: f32,
    ) -> Response {
        let button = Button::selectable(is_chosen, label).min_size(vec2(0.0, height)).frame_when_inactive(true);
        let response = ui.add(button);
        self.note(name, &response);
        response
    }

    /// Remembers where a control is.
    pub(super) fn note(&mut self, name: &'static str, response: &Response) {
        let place = response.rect.center();
        self.places.insert(name, [place.x, place.y]);
    }
}

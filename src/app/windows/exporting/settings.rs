//! The form of the export window: kind of file, size, sides, background, animation, coordinates.

use crate::app::panels::play_panel;
use crate::app::theme::Palette;
use crate::app::theme::number_field::{number_field, spoken};
use crate::app::windows::exporting::window::{Exporter, Surroundings};
use crate::conformal::Side;
use crate::export::FileFormat;
use crate::language::{Label, Message, key, say, tr};
use crate::model::export::request::Kind;
use crate::render::{FilmFormat, MOST_FRAMES, SECONDS};
use egui::{Button, Id, Response, RichText, Ui, vec2};

/// The sizes offered as buttons, in pixels.
const SIZES: [([u32; 2], &str); 4] = [
    ([800, 450], "800 × 450"),
    ([1600, 900], "1600 × 900"),
    ([3840, 2160], "3840 × 2160"),
    ([1080, 1080], "1080 × 1080"),
];
/// The allowed width and height of a picture, in pixels; the maximum is lower if the graphics device's textures are.
const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;
impl Exporter {
    /// Shows the kinds of files and a description of the chosen one.
    pub(super) fn kinds(&mut self, ui: &mut Ui, around: &Surroundings, height: f32) {
        ui.horizontal_wrapped(|ui| {
            for &kind in Kind::all(around.abilities) {
                if self.choice(ui, kind.label(), self.request.kind == kind, height).clicked() {
                    self.request.kind = kind;
                }
            }
        });
        let weak = Palette::of(ui.visuals()).weak;
        ui.label(RichText::new(tr(self.request.kind.explained(around.abilities))).small().color(weak));
        if let Some(reason) = around.no_formula.as_ref().filter(|_| self.request.kind == Kind::Formula) {
            let ink = Palette::of(ui.visuals()).error_edge;
            ui.label(RichText::new(say(&key::sentence(reason.clone()))).small().color(ink));
        }
        ui.add_space(4.0);
    }

    /// Shows the settings of the chosen kind of file, as rows of a grid.
    pub(super) fn settings(&mut self, ui: &mut Ui, around: &Surroundings, height: f32) {
        let kind = self.request.kind;
        if kind.is_drawn() {
            self.size(ui, around, height);
        }
        let drawing = kind == Kind::File(FileFormat::Svg) && !around.abilities.has_layout();
        if kind.is_drawn() || drawing {
            self.sides(ui, height);
        }
        if kind.is_drawn() {
            ui.label(tr(key::ground()));
            let transparent = ui.checkbox(&mut self.request.transparent, tr(key::transparent()));
            self.note(key::transparent().english(), &transparent.on_hover_text(tr(key::transparent_tooltip())));
            ui.end_row();
            ui.label(tr(key::dots()));
            let dots = ui.checkbox(&mut self.request.dots, tr(key::both_points()));
            self.note(key::both_points().english(), &dots.on_hover_text(tr(key::both_points_tooltip())));
            ui.end_row();
        }
        if kind == Kind::Formula && around.no_formula.is_none() {
            self.formula_settings(ui, height);
        }
        if let Kind::Film(format) = kind {
            self.film(ui, around, height, format);
        }
        if around.abilities.has_layout() && matches!(kind, Kind::File(_)) {
            self.layout_settings(ui, kind != Kind::File(FileFormat::Svg), height);
        }
    }

    /// The rows of a surface's layout: the scale of its coordinates, and the outline's corners.
    fn layout_settings(&mut self, ui: &mut Ui, has_scale: bool, height: f32) {
        if has_scale {
            ui.label(tr(key::coordinates()));
            ui.horizontal(|ui| {
                for (unit, label, tooltip) in [
                    (true, key::unit_box(), key::unit_box_tooltip()),
                    (false, key::true_scale(), key::true_scale_tooltip()),
                ] {
                    let choice = self.choice(ui, label, self.request.layout.unit == unit, height);
                    if choice.on_hover_text(tr(tooltip)).clicked() {
                        self.request.layout.unit = unit;
                    }
                }
            });
            ui.end_row();
        }
        ui.label(tr(key::corners()));
        let corners = ui.checkbox(&mut self.request.layout.corners, tr(key::hit_corners()));
        self.note(key::hit_corners().english(), &corners.on_hover_text(tr(key::hit_corners_tooltip())));
        ui.end_row();
    }

    /// The row of the size: its label is beside the first line of choices, also where they take several.
    fn size(&mut self, ui: &mut Ui, around: &Surroundings, height: f32) {
        let of_row = Id::unique("height of the sizes");
        let row: f32 = ui.data(|data| data.get_temp(of_row)).unwrap_or(height);
        ui.vertical(|ui| {
            ui.set_min_height(row);
            ui.spacing_mut().interact_size.y = height;
            ui.horizontal(|ui| ui.label(tr(key::size())));
        });
        let fields = self.size_fields(ui, around, height);
        if fields.rect.height() != row {
            ui.data_mut(|data| data.insert_temp(of_row, fields.rect.height()));
            ui.request_repaint();
        }
        ui.end_row();
    }

    fn size_fields(&mut self, ui: &mut Ui, around: &Surroundings, height: f32) -> Response {
        let most = around.max_side.min(*SIDES.end());
        let fields = ui.vertical(|ui| {
            ui.horizontal_wrapped(|ui| {
                for (size, label) in SIZES.into_iter().filter(|(size, _)| size.iter().all(|&side| side <= most)) {
                    if self.choice_named(ui, [label; 2], self.request.size == size, height).clicked() {
                        self.request.size = size;
                    }
                }
            });
            ui.horizontal(|ui| {
                for (k, name) in [(0, tr(key::width_pixels())), (1, tr(key::height_pixels()))] {
                    let field = number_field(&mut self.request.size[k]).range(*SIDES.start()..=most).suffix(" px");
                    let response = ui.add_sized([84.0, height], field).on_hover_text(name);
                    let response = spoken(response, name, f64::from(self.request.size[k]));
                    self.note(if k == 0 { "Width" } else { "Height" }, &response);
                    if k == 0 {
                        ui.label("×");
                    }
                }
            });
        });
        fields.response
    }

    fn sides(&mut self, ui: &mut Ui, height: f32) {
        ui.label(tr(key::show()));
        ui.horizontal(|ui| {
            let sides = [
                (None, key::both()),
                (Some(Side::Source), key::source_heading()),
                (Some(Side::Target), key::target_heading()),
            ];
            for (side, label) in sides {
                if self.choice(ui, label, self.request.side == side, height).clicked() {
                    self.request.side = side;
                }
            }
        });
        ui.end_row();
    }

    fn film(&mut self, ui: &mut Ui, around: &Surroundings, height: f32, format: FilmFormat) {
        ui.label(tr(key::motion()));
        ui.horizontal(|ui| {
            for segment in &play_panel::PATHS {
                let moves = around.abilities.refused_path(segment.value).is_none();
                ui.add_enabled_ui(moves, |ui| {
                    let is_chosen = self.request.path == segment.value;
                    let choice = self.choice(ui, segment.label, is_chosen, height);
                    if choice.on_hover_text(tr(segment.tooltip)).clicked() {
                        self.request.path = segment.value;
                    }
                });
            }
        });
        ui.end_row();
        ui.label(tr(key::duration()));
        let seconds = number_field(&mut self.request.seconds).range(SECONDS).speed(0.1).max_decimals(1).suffix(" s");
        let response = ui.add_sized([84.0, height], seconds).on_hover_text(tr(key::duration_tooltip()));
        let response = spoken(response, tr(key::duration()), self.request.seconds);
        self.note(key::duration().english(), &response);
        ui.end_row();
        ui.label(tr(key::pictures()));
        ui.horizontal(|ui| {
            let frames = number_field(&mut self.request.frames).range(2..=MOST_FRAMES);
            let response = ui.add_sized([84.0, height], frames).on_hover_text(tr(key::pictures_tooltip()));
            let response = spoken(response, tr(key::pictures()), f64::from(self.request.frames));
            self.note(key::pictures().english(), &response);
            let rate = f64::from(self.request.frames) / self.request.seconds;
            let weak = Palette::of(ui.visuals()).weak;
            ui.label(RichText::new(say(&key::per_second(format!("{rate:.0}")))).color(weak));
        });
        ui.end_row();
        if let Err(error) = self.request.film(format).check() {
            let ink = Palette::of(ui.visuals()).error_edge;
            ui.label("");
            ui.label(RichText::new(say(&Message::from(&error))).small().color(ink));
            ui.end_row();
        }
    }

    fn choice(&mut self, ui: &mut Ui, label: Label, is_chosen: bool, height: f32) -> Response {
        self.choice_named(ui, [label.english(), tr(label)], is_chosen, height)
    }

    pub(super) fn choice_named(
        &mut self,
        ui: &mut Ui,
        [name, label]: [&'static str; 2],
        is_chosen: bool,
        height: f32,
    ) -> Response {
        let button = Button::selectable(is_chosen, label).min_size(vec2(0.0, height)).frame_when_inactive(true);
        let response = ui.add(button);
        self.note(name, &response);
        response
    }

    /// Stores the center of a control for [`Self::places()`].
    pub(super) fn note(&mut self, name: &'static str, response: &Response) {
        let place = response.rect.center();
        self.places.insert(name, [place.x, place.y]);
    }
}

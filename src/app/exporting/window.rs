//! The window where a file is chosen, made and saved.

use super::job::{Job, Progress};
use super::wish::{Kind, Wish};
use super::{FileWish, ReadyFile};
use crate::app::action::{Action, Actions};
use crate::app::language::{tr, tr_message, tr_with};
use crate::app::theme::{Palette, ROW_HEIGHT};
use crate::app::widgets::message_box;
use crate::conformal::Side;
use crate::render::{FilmFormat, MOST_FRAMES, SECONDS};
use egui::{Button, DragValue, Grid, Key, Modifiers, ProgressBar, Response, RichText, ScrollArea, Ui, Window, vec2};
use std::collections::BTreeMap;

/// Sizes that can be had by one click.
const SIZES: [([u32; 2], &str); 4] = [
    ([800, 450], "800 × 450"),
    ([1600, 900], "1600 × 900"),
    ([3840, 2160], "3840 × 2160"),
    ([1080, 1080], "1080 × 1080"),
];
/// Sides of a picture, in pixels; fewer where the graphics device has smaller textures.
const SIDES: std::ops::RangeInclusive<u32> = 16..=8192;
/// The height of what a finger touches.
const TOUCH_HEIGHT: f32 = 40.0;
const WIDTH: f32 = 400.0;

/// What the window needs to know.
#[derive(Debug, Clone, Copy)]
pub struct Surroundings {
    /// The map is there, complete.
    pub is_ready: bool,
    /// It is one of a surface.
    pub on_surface: bool,
    /// Little room, and fingers.
    pub narrow: bool,
    /// The largest side of a texture.
    pub max_side: u32,
}

/// The window and the work that it has begun.
#[derive(Default)]
pub struct Exporter {
    is_open: bool,
    wish: Wish,
    job: Option<Job>,
    error: Option<String>,
    /// The centres of its controls, by what is written on them.
    places: BTreeMap<&'static str, [f32; 2]>,
}

impl Exporter {
    /// Shows the window.
    pub fn open(&mut self) {
        self.is_open = true;
    }

    /// What is chosen.
    pub fn wish(&self) -> &Wish {
        &self.wish
    }

    /// What is chosen, as numbers or vector graphics.
    pub fn file_wish(&self) -> Option<FileWish> {
        let Kind::File(format) = self.wish.kind else { return None };
        Some(FileWish { format, side: self.wish.side, unit: self.wish.unit })
    }

    /// Begins with work, or says why not.
    pub fn begin(&mut self, job: Result<Job, String>) {
        (self.job, self.error) = match job {
            Ok(job) => (Some(job), None),
            Err(reason) => (None, Some(reason)),
        };
    }

    /// Gives up what is under way.
    pub fn cancel(&mut self) {
        self.job = None;
    }

    /// Says what went wrong, or that nothing did.
    pub fn tell(&mut self, error: Option<String>) {
        self.error = error;
    }

    /// Whether something is being made.
    pub fn is_busy(&self) -> bool {
        self.job.is_some()
    }

    /// Spends a frame's share on what is under way; the file, when it is there.
    pub fn work(&mut self, gpu: (&wgpu::Device, &wgpu::Queue)) -> Option<ReadyFile> {
        match self.job.as_mut()?.work(gpu) {
            Ok(Progress::GoesOn) => None,
            Ok(Progress::Done(file)) => {
                self.job = None;
                Some(file)
            }
            Err(reason) => {
                (self.job, self.error) = (None, Some(reason));
                None
            }
        }
    }

    /// Where its controls are; `None` while it is closed.
    pub fn places(&self) -> Option<&BTreeMap<&'static str, [f32; 2]>> {
        self.is_open.then_some(&self.places)
    }

    /// How many pictures of how many are made.
    pub fn count(&self) -> Option<[u32; 2]> {
        self.job.as_ref().map(Job::count)
    }

    /// Shows the window, if it is open. Closing it gives up what is under way.
    pub fn show(&mut self, context: &egui::Context, around: Surroundings, actions: &mut Actions) {
        if !self.is_open {
            return;
        }
        self.places.clear();
        if !Kind::all(around.on_surface).contains(&self.wish.kind) {
            self.wish.kind = Kind::Picture;
        }
        let screen = context.content_rect();
        let width = WIDTH.min(screen.width() - 40.0);
        let mut stays = !context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        Window::new(tr("Export"))
            .id(egui::Id::unique("export"))
            .open(&mut stays)
            .collapsible(false)
            .resizable(false)
            .pivot(egui::Align2::CENTER_CENTER)
            .default_pos(screen.center())
            .show(context, |ui| {
                ui.set_width(width);
                ScrollArea::vertical().max_height(screen.height() - 140.0).show(ui, |ui| {
                    self.content(ui, around, actions);
                });
            });
        if !stays {
            (self.is_open, self.error) = (false, None);
            actions.push(Action::CancelExport);
        }
    }

    fn content(&mut self, ui: &mut Ui, around: Surroundings, actions: &mut Actions) {
        let height = if around.narrow { TOUCH_HEIGHT } else { ROW_HEIGHT };
        ui.spacing_mut().interact_size.y = height;
        ui.add_enabled_ui(!self.is_busy(), |ui| {
            self.kinds(ui, around, height);
            Grid::new("export settings").num_columns(2).spacing([12.0, 8.0]).show(ui, |ui| {
                self.settings(ui, around, height);
            });
        });
        ui.add_space(6.0);
        self.bottom(ui, around, height, actions);
        if let Some(error) = &self.error
            && message_box(ui, &tr_message(error), None).is_some()
        {
            self.error = None;
        }
    }

    fn kinds(&mut self, ui: &mut Ui, around: Surroundings, height: f32) {
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

    fn settings(&mut self, ui: &mut Ui, around: Surroundings, height: f32) {
        let kind = self.wish.kind;
        if kind.is_drawn() {
            self.size(ui, around, height);
        }
        let drawing = kind == Kind::File(crate::export::FileFormat::Svg) && !around.on_surface;
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
        if around.on_surface && matches!(kind, Kind::File(format) if format != crate::export::FileFormat::Svg) {
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
            for segment in &crate::app::play_panel::PATHS {
                let fixed = around.on_surface && segment.value == crate::family::Path::TargetPoint;
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

    fn bottom(&mut self, ui: &mut Ui, around: Surroundings, height: f32, actions: &mut Actions) {
        ui.horizontal(|ui| {
            if let Some(job) = &self.job {
                let [done, all] = job.count();
                let text = if all > 1 { tr_with("{0} of {1} pictures", &[&done, &all]) } else { String::new() };
                let room = ui.available_width() - 110.0;
                ui.add(ProgressBar::new(job.progress()).desired_width(room).desired_height(height).text(text));
                let cancel = ui.add_sized([100.0, height], Button::new(tr("Cancel")));
                self.note("Cancel", &cancel);
                if cancel.clicked() {
                    actions.push(Action::CancelExport);
                }
                return;
            }
            let Kind::Film(format) = self.wish.kind else {
                return self.save(ui, around.is_ready, height, actions);
            };
            let fixed = around.on_surface && self.wish.path == crate::family::Path::TargetPoint;
            let can_be = self.wish.film(format).check().is_ok() && !fixed;
            self.save(ui, around.is_ready && can_be, height, actions);
        });
    }

    fn save(&mut self, ui: &mut Ui, enabled: bool, height: f32, actions: &mut Actions) {
        let palette = Palette::of(ui.visuals());
        let label = RichText::new(tr("Save")).color(palette.on_accent);
        let button = Button::new(label).fill(palette.accent).min_size(vec2(120.0, height));
        let response = ui.add_enabled(enabled, button);
        let response = response.on_disabled_hover_text(tr("While nothing is prepared"));
        self.note("Save", &response);
        if response.clicked() {
            actions.push(Action::SaveExport);
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

    fn note(&mut self, name: &'static str, response: &Response) {
        let place = response.rect.center();
        self.places.insert(name, [place.x, place.y]);
    }
}

//! The export window: chooses a kind of file, shows the progress of its job or worker, and saves the result.

use crate::app::input::action::{Action, Actions, ExportAction};
use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::widgets::{close_button, message_box};
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::app::windows::exporting::formula::FormulaWork;
use crate::app::windows::exporting::progress::progress_bar;
use crate::language::{Message, key, say, tr};
use crate::model::Abilities;
use crate::model::export::request::{ExportRequest, Kind};
use crate::model::export::{FileRequest, ReadyFile};
use crate::offscreen::job::{Job, Progress};
use egui::{Button, Grid, Key, Modifiers, RichText, Ui, Window, vec2};
use std::collections::BTreeMap;

const WIDTH: f32 = 400.0;
/// Room for the scroll bar beside the form.
const SCROLL_BAR: f32 = 10.0;
/// The height above and below the form together, in points, and on a screen lower than [`LOW`], where the window may lie
/// over the bars.
const BESIDES: [f32; 2] = [210.0, 150.0];
const LOW: f32 = 500.0;
/// The largest height of an error in the window.
const MOST_MESSAGE: f32 = 120.0;
/// The initial distance from the screen's upper edge to the window, in points: below the top bar.
const FROM_TOP: f32 = 64.0;

/// The state of the map on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapState {
    /// The map that is asked for is still being prepared.
    Preparing,
    /// The map is shown, but its extension is not complete.
    Ready,
    /// The map is shown with its complete extension.
    Complete,
}

/// The facts about the app that decide what can be exported.
#[derive(Debug, Clone)]
pub struct Surroundings {
    /// The state of the map.
    pub map: MapState,
    /// What the map allows.
    pub abilities: Abilities,
    /// The largest width or height of a texture, in pixels.
    pub max_side: u32,
    /// Why there is no formula.
    pub no_formula: Option<Message>,
}

/// The export window, and the job or the formula that it has started.
#[derive(Default)]
pub struct Exporter {
    is_open: bool,
    pub(super) request: ExportRequest,
    pub(super) job: Option<Job>,
    pub(super) formula: FormulaWork,
    error: Option<Message>,
    /// The centers of the window's controls, by their English labels.
    pub(super) places: BTreeMap<&'static str, [f32; 2]>,
}

impl Exporter {
    /// Whether the window is open.
    pub fn is_open(&self) -> bool {
        self.is_open
    }

    /// Opens the window; [`Self::show`] draws it.
    pub fn open(&mut self) {
        self.is_open = true;
    }

    /// The chosen settings.
    pub fn request(&self) -> &ExportRequest {
        &self.request
    }

    /// The chosen file of numbers or vector graphics; `None` for pictures and animations.
    pub fn file_request(&self) -> Option<FileRequest> {
        let Kind::File(format) = self.request.kind else { return None };
        Some(FileRequest {
            format,
            side: self.request.side,
            unit: self.request.layout.unit,
            corners: self.request.layout.corners,
        })
    }

    /// Starts a job, or shows the reason why it cannot start.
    pub fn begin(&mut self, job: Result<Job, Message>) {
        (self.job, self.error) = match job {
            Ok(job) => (Some(job), None),
            Err(reason) => (None, Some(reason)),
        };
    }

    /// Drops the job, and whatever comes from the formula's worker.
    pub fn cancel(&mut self) {
        (self.job, self.formula) = (None, FormulaWork::None);
    }

    /// Sets the error or the note that the window shows; `None` clears it.
    pub fn tell(&mut self, error: Option<Message>) {
        self.error = error;
    }

    /// The errors that the window shows; none while it is closed.
    pub fn errors(&self) -> impl Iterator<Item = Message> {
        let refused = match self.request.kind {
            Kind::Film(format) if self.is_open => {
                self.request.film(format).check().err().map(|error| Message::from(&error))
            }
            _ => None,
        };
        self.error.clone().filter(|_| self.is_open).into_iter().chain(refused)
    }

    /// Whether a job is in progress, which goes on by [`Self::work`].
    pub fn is_drawing(&self) -> bool {
        self.job.is_some()
    }

    /// Whether a job or a formula is in progress.
    pub fn is_busy(&self) -> bool {
        self.is_drawing() || self.formula_progress().is_some()
    }

    /// Works on the job for a part of a frame; returns the file once complete. An error ends the job and is shown.
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

    /// The centers of the window's controls, by their English labels; `None` while it is closed.
    pub fn places(&self) -> Option<&BTreeMap<&'static str, [f32; 2]>> {
        self.is_open.then_some(&self.places)
    }

    /// The number of finished pictures and of all pictures of the job; `None` without a job.
    pub fn count(&self) -> Option<[u32; 2]> {
        self.job.as_ref().map(Job::count)
    }

    /// Closes the window and cancels what is in progress.
    pub fn close(&mut self) {
        (self.is_open, self.error) = (false, None);
        self.cancel();
    }

    /// Draws the window if it is open.
    pub fn show(&mut self, context: &egui::Context, around: &Surroundings, actions: &mut Actions) {
        if !self.is_open {
            return;
        }
        self.places.clear();
        if !Kind::all(around.abilities).contains(&self.request.kind) {
            self.request.kind = Kind::Picture;
        }
        let screen = context.content_rect();
        let width = WIDTH.min(screen.width() - 40.0);
        let mut stays = !context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        Window::new(tr(key::export()))
            .id(egui::Id::unique("export"))
            .open(&mut stays)
            .collapsible(false)
            .auto_sized()
            // the window grows downwards only, so that its buttons stay under the pointer
            .pivot(egui::Align2::CENTER_TOP)
            .default_pos(screen.center_top() + vec2(0.0, FROM_TOP))
            .show(context, |ui| {
                ui.set_width(width);
                self.content(ui, around, actions);
            });
        if !stays {
            actions.push(Action::Export(ExportAction::Close));
        }
    }

    /// The form with what a formula reached, which scrolls, and below it the buttons or the progress of the job.
    fn content(&mut self, ui: &mut Ui, around: &Surroundings, actions: &mut Actions) {
        let height = control_height(ui, ROW_HEIGHT);
        let is_low = ui.ctx().content_rect().height() < LOW;
        scroll_beyond(ui, BESIDES[usize::from(is_low)], |ui| {
            ui.set_width(ui.available_width() - SCROLL_BAR);
            ui.add_enabled_ui(!self.is_busy(), |ui| {
                self.kinds(ui, around, height);
                Grid::new("export settings").num_columns(2).spacing([12.0, 8.0]).show(ui, |ui| {
                    self.settings(ui, around, height);
                });
            });
            if self.request.kind == Kind::Formula {
                self.show_formula_notes(ui);
            }
        });
        ui.add_space(6.0);
        self.bottom(ui, around, height, actions);
        if let Some(error) = &self.error
            && message_box(ui, error, None, MOST_MESSAGE).is_some()
        {
            actions.push(Action::Export(ExportAction::DismissError));
        }
    }

    fn bottom(&mut self, ui: &mut Ui, around: &Surroundings, height: f32, actions: &mut Actions) {
        ui.horizontal(|ui| {
            if let Some((done, text)) = self.progress() {
                let size = vec2(ui.available_width() - 110.0, height);
                progress_bar(ui, size, done, text);
                let cancel = ui.add_sized([100.0, height], Button::new(tr(key::cancel())));
                self.note(key::cancel().english(), &cancel);
                if cancel.clicked() {
                    actions.push(Action::Export(ExportAction::Cancel));
                }
                return;
            }
            let Kind::Film(format) = self.request.kind else {
                return self.save(ui, (self.can_save(around), around), height, actions);
            };
            let moves = around.abilities.refused_path(self.request.path).is_none();
            let can_be = self.request.film(format).check().is_ok() && moves;
            self.save(ui, (around.map != MapState::Preparing && can_be, around), height, actions);
        });
    }

    /// Whether a file other than an animation can be saved. A formula needs the points only.
    fn can_save(&self, around: &Surroundings) -> bool {
        match self.request.kind {
            Kind::Formula => around.map != MapState::Preparing && around.no_formula.is_none(),
            Kind::File(_) => around.map == MapState::Complete,
            _ => around.map != MapState::Preparing,
        }
    }

    fn save(&mut self, ui: &mut Ui, (enabled, around): (bool, &Surroundings), height: f32, actions: &mut Actions) {
        let palette = Palette::of(ui.visuals());
        let label = RichText::new(tr(key::save())).color(palette.on_accent);
        let button = Button::new(label).fill(palette.accent).min_size(vec2(120.0, height));
        let response = ui.add_enabled(enabled, button);
        let waits = around.no_formula.as_ref().filter(|_| self.request.kind == Kind::Formula);
        let response = response.on_disabled_hover_text(waits.map_or_else(|| tr(key::swap_waits()).to_owned(), say));
        self.note(key::save().english(), &response);
        if response.clicked() {
            actions.push(Action::Export(ExportAction::Save));
        }
        let close = close_button(ui);
        self.note(key::close().english(), &close);
        if close.clicked() {
            actions.push(Action::Export(ExportAction::Close));
        }
    }
}

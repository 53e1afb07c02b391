//! The stages of a frame: input is read, the update sends due requests to the workers, updates the map and
//! uploads what changed, the pictures are painted. At rest it does nothing and requests no further frame.

use super::arrangement::Arrangement;
use super::incoming::WORDS_FOLLOW_AFTER;
use super::input::action::Actions;
use super::input::preferences::Habit;
use super::input::presentation;
use super::layout::LaidOut;
use super::{RiemapApp, editing, layout, message_bar, pictures};
use crate::app::viewport::gpu::Gpu;
use crate::app::viewport::picture::Seen;
use crate::conformal::Side;
use crate::language::key;
use crate::model::motion::PlayAction;
use crate::model::overlays::orthogonal_grid::GridWork;
use crate::model::{Changes, Refines};
use crate::platform;
use crate::worker::Study;

/// How long the map must be unchanged before an expensive quality is computed, in seconds.
pub(super) const REST_SECONDS: f64 = 0.15;

impl RiemapApp {
    /// Lays out the panels and reads gestures and keys; returns the layout and the requested actions, those of the last
    /// frame's painting first.
    pub(super) fn take_input(&mut self, ui: &mut egui::Ui, cpu_usage: Option<f32>) -> (Arrangement, Actions) {
        self.take_dropped(ui.ctx());
        self.screen.zoom = ui.ctx().zoom_factor();
        self.screen.theme = ui.ctx().theme();
        let timings = self.model.shown().map(|map| map.timings).unwrap_or_default();
        let compute = timings.kernel + timings.matching + timings.extend;
        self.screen.meter.tick(ui.input(|input| input.unstable_dt), cpu_usage, compute);
        self.plots.begin_frame(&self.model);
        message_bar::begin(self, ui);
        let LaidOut { arrangement, actions: asked, pointed, focused_tour } = layout::show(self, ui);
        self.plots.point_in_plots(pointed);
        if focused_tour {
            self.windows.explore.end_focus();
        }
        let mut actions = std::mem::take(&mut self.input.asked);
        if !actions.is_empty() {
            // this frame's panels are laid out before the actions are carried out
            ui.request_repaint();
        }
        // changes by a drag come before those of keys and panels, so that an undo reverts the drag
        pictures::interact(self, ui, arrangement, &mut actions);
        actions.extend(asked);
        (arrangement, actions)
    }

    /// Paints the pictures and windows in the area that the panels leave.
    pub(super) fn paint(&mut self, ui: &mut egui::Ui, arrangement: Arrangement) {
        let content = |ui: &mut egui::Ui| {
            // commands and events may have changed margins and extents
            pictures::place(self, ui, arrangement);
            let mut asked = pictures::show(self, ui, arrangement);
            self.show_windows(ui.ctx(), &mut asked);
            asked
        };
        let asked = egui::CentralPanel::no_frame().show(ui, content).inner;
        presentation::mark_pointer(ui.ctx());
        self.ask(ui.ctx(), asked);
    }

    /// Shows the windows that are open; their fields are changed in place.
    fn show_windows(&mut self, context: &egui::Context, actions: &mut Actions) {
        self.windows.reports.show(context, actions);
        editing::show_paste(context, &mut self.editor, actions);
        self.windows.explore.show(context, actions);
        self.windows.projection.show(context, actions);
        self.show_exporter(context, actions);
        self.show_share(context, actions);
    }

    /// Sends due requests to the workers, updates the map, uploads.
    pub(super) fn advance(&mut self, context: &egui::Context) {
        let now = context.input(|input| input.time);
        self.editor.follow(&mut self.model, &mut self.pictures.views);
        if self.input.handles.ever_dragged {
            self.recall(Habit::Dragged);
        }
        self.begin_study();
        let moves = self.play(context, now) | self.seek_best(context, now);
        self.refresh(context, moves, now);
        let is_held = context.input(|input| input.pointer.any_down());
        self.model.set_at_rest(!moves && !is_held && self.is_resting(now));
        self.send_requests(context, now);
        self.refine_at_rest(context, now);
        self.await_map(context, moves);
        self.refit(context);
        self.measure_at_rest(context, now);
        self.begin_invariants(context, now);
        self.begin_symmetries(context, now);
        self.begin_grids(context, is_held, now);
        self.advance_overlays(context, now);
        self.look_under_pointer(context, now);
        self.look_at_probe(context, now);
        self.work_on_export(context);
        self.describe(context, now);
        self.keep(context);
        self.update_pictures(context);
    }

    fn begin_study(&mut self) {
        if let Some(study) = self.windows.reports.take_study() {
            self.workers.study_runner.begin(study);
        }
    }

    /// Requests the invariants that are asked for, once the points rest.
    fn begin_invariants(&mut self, context: &egui::Context, now: f64) {
        if !self.model.are_invariants_due() {
            return;
        }
        if !self.is_resting(now) || self.input.handles.grip.is_some() {
            context.request_repaint_after_secs(REST_SECONDS as f32);
        } else if let Some(task) = self.model.take_invariants() {
            self.workers.invariants_runner.begin(Study::Invariants(Box::new(task)));
        }
    }

    /// Requests the symmetries that are shown, once the outline rests.
    fn begin_symmetries(&mut self, context: &egui::Context, now: f64) {
        if !self.model.are_symmetries_due() {
            return;
        }
        if !self.is_resting(now) {
            context.request_repaint_after_secs(REST_SECONDS as f32);
        } else if let Some(outline) = self.model.take_symmetry() {
            self.workers.symmetry_runner.begin(Study::Symmetry(Box::new(outline)));
        }
    }

    /// Gives up grids that are no more wanted, and requests those that are asked for; not while a pointer button is down,
    /// since marks and numbers of cells may still change.
    fn begin_grids(&mut self, context: &egui::Context, is_held: bool, now: f64) {
        if self.model.gives_up_grid() {
            self.workers.grid_runner.cancel();
        }
        if is_held {
            return;
        }
        match self.model.next_grid_work(now) {
            GridWork::Nothing => {}
            GridWork::Wait(seconds) => context.request_repaint_after_secs(seconds as f32),
            GridWork::Begin(task) => self.workers.grid_runner.begin(Study::Grid(Box::new(task))),
        }
    }

    /// Moves the points that are in motion; returns whether any point moves, dragged or by itself.
    fn play(&mut self, context: &egui::Context, now: f64) -> bool {
        let is_held = self.input.handles.grip.is_some();
        self.model.hold_dot(is_held);
        if is_held {
            self.player.pause();
        }
        if self.model.pins().is_some() && self.player.is_playing() {
            self.player.act(PlayAction::Toggle, &self.model); // the points follow the pins from now on
        }
        let holds = context.input(|input| input.pointer.any_down());
        if let Some(delay) = self.windows.explore.conduct(&mut self.player, &self.model, holds, now) {
            context.request_repaint_after_secs(delay as f32);
        }
        for command in self.player.advance(&self.model, now) {
            if !self.windows.explore.is_touring() {
                self.persistence.touch();
            }
            self.model.dispatch(command, now);
        }
        if self.player.is_playing() {
            context.request_repaint();
        }
        // a dot that is held without moving counts as at rest
        self.player.is_moving() || (is_held && !self.is_resting(now))
    }

    /// Continues the search for the best map and moves the points to its result; returns whether they move.
    fn seek_best(&mut self, context: &egui::Context, now: f64) -> bool {
        let (commands, goes_on) = self.model.advance_best(now, self.windows.explore.is_calm);
        let moves = !commands.is_empty();
        for command in commands {
            self.command(command, now);
        }
        if goes_on {
            context.request_repaint();
        }
        moves
    }

    /// Whether the map has not changed for [`REST_SECONDS`].
    fn is_resting(&self, now: f64) -> bool {
        now - self.last_change >= REST_SECONDS
    }

    /// Updates the map and uploads what changed.
    fn refresh(&mut self, context: &egui::Context, moves: bool, now: f64) {
        let changes = self.model.refresh(moves);
        if changes != Changes::default() {
            self.last_change = now;
            self.show_changes(context, changes);
        }
    }

    /// Sends due requests to the workers. It follows the update of the map, so that an outline being
    /// dragged is prepared again in the frame that shows it.
    fn send_requests(&mut self, context: &egui::Context, now: f64) {
        self.replace_silent_workers();
        self.workers.send_due(&mut self.model, now);
        if let Some(delay) = self.workers.silent_in() {
            context.request_repaint_after_secs(delay as f32);
        }
        if let Some(due) = self.model.next_due() {
            context.request_repaint_after_secs((due - now).max(0.0) as f32);
        } else if !self.is_resting(now) && self.model.is_mapped() && !self.model.is_ready() {
            context.request_repaint_after_secs(REST_SECONDS as f32); // an equation or a refined mesh is due at rest
        }
    }

    /// Completes the extension, sorts the surface for picking and warms up workers and GPU once the map rests.
    fn refine_at_rest(&mut self, context: &egui::Context, now: f64) {
        if !self.is_resting(now) {
            return;
        }
        let refined = self.model.refine_at_rest();
        if refined.images {
            self.show_changes(context, refined);
        }
        if self.model.map().is_some() && self.model.sort_surface_at_rest() {
            context.request_repaint_after_secs(platform::ONE_FRAME); // for the other side's
        }
        if self.model.is_ready() {
            self.workers.preparer.warm();
            self.pictures.gpu.iter().for_each(Gpu::warm);
        }
    }

    /// Requests a frame while the map is incomplete: at once, or after the rest time if a point moves that follows from
    /// nothing; and while it is being refined.
    fn await_map(&self, context: &egui::Context, moves: bool) {
        if self.model.is_pending() {
            let waits = moves && !self.model.is_searching_points();
            context.request_repaint_after_secs(if waits { REST_SECONDS as f32 } else { 0.0 });
        } else if self.model.refines_in_refresh() {
            context.request_repaint();
        }
    }

    /// Measures the distortion once the map rests and its extension is complete.
    fn measure_at_rest(&mut self, context: &egui::Context, now: f64) {
        let complete = self.model.extension_progress() == 1.0;
        if complete && !self.model.is_quality_stale() {
            return;
        }
        if complete && self.is_resting(now) {
            self.model.measure_at_rest();
            context.request_repaint_after_secs(platform::ONE_FRAME);
        } else {
            context.request_repaint_after_secs(REST_SECONDS as f32);
        }
    }

    /// Evaluates the map under the pointer; its integral is prepared in slices while the map rests.
    fn look_under_pointer(&mut self, context: &egui::Context, now: f64) {
        let is_free = self.input.handles.grip.is_none() && self.editor.side().is_none();
        let at = self.input.handles.pointed.filter(|_| is_free);
        if let Some(at) = at {
            if !self.is_resting(now) {
                context.request_repaint_after_secs(REST_SECONDS as f32);
            } else if !self.model.prepare_pointer(at.side) {
                context.request_repaint();
            }
        }
        let pointed = at.and_then(|at| self.model.pointed(at.side, at.point));
        if std::mem::replace(&mut self.pictures.pointed, pointed) != pointed {
            // the status line was laid out before
            context.request_repaint();
        }
    }

    /// Carries the probe to the target; its integral is prepared in slices while the map rests.
    fn look_at_probe(&mut self, context: &egui::Context, now: f64) {
        let handles = &mut self.input.handles;
        if !self.windows.explore.probes() {
            (handles.probe, self.pictures.probe) = (None, None);
            handles.is_probe_focused = false;
            return;
        }
        if handles.probe.is_none() && self.model.is_mapped() {
            handles.probe = self.model.new_probe();
        }
        let Some(probe) = handles.probe else { return };
        let is_free = self.is_resting(now) && self.input.handles.probe_grip.is_none();
        let is_exact = is_free && self.model.prepare_pointer(Side::Source);
        if is_free && !is_exact {
            context.request_repaint();
        }
        let known = self.pictures.probe.as_ref();
        if !known.is_some_and(|image| self.model.is_probe_current(image, probe, is_exact)) {
            self.pictures.probe = self.model.probe_image(probe, is_exact);
        }
    }

    fn advance_overlays(&mut self, context: &egui::Context, now: f64) {
        if let Some(delay) = self.model.advance_overlays(now) {
            context.request_repaint_after_secs(delay as f32);
        }
    }

    /// Uploads the triangles and renews the plots' curves.
    fn update_pictures(&mut self, context: &egui::Context) {
        self.pictures.cells.update(&self.model, self.pictures.gpu.as_ref(), context.pixels_per_point());
        self.pictures.uv.update(&self.model, self.windows.exporter.request().layout);
        self.plots.update(&self.model);
    }

    /// Fits the view of every side with a new shape.
    fn refit(&mut self, context: &egui::Context) {
        for side in Side::BOTH {
            if self.model.take_refit(side) && self.pictures.look_at_new(&self.model, side) == Seen::InNextFrame {
                context.request_repaint_after_secs(platform::ONE_FRAME);
            }
        }
    }

    /// Uploads, and requests another frame, because the status line was laid out before the change. That frame is
    /// delayed: with a software renderer, it would otherwise postpone the display of this one.
    pub(super) fn show_changes(&mut self, context: &egui::Context, changes: Changes) {
        context.request_repaint_after_secs(WORDS_FOLLOW_AFTER);
        if let Some(gpu) = &mut self.pictures.gpu
            && !gpu.upload(&self.model, changes)
        {
            self.messages.common = Some(key::surface_too_large_to_show().into());
        }
        let extended = self.pictures.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        self.model.set_refines(if extended { Refines::AtRest } else { Refines::InRefresh });
    }
}

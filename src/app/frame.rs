//! What a frame does once the wishes are carried out: sends what is due to the workers, brings the map up to date,
//! uploads what changed, and tells those who hear the screen. At rest it does nothing and asks for no other frame.

use super::gpu::Gpu;
use super::incoming::WORDS_FOLLOW_AFTER;
use super::model::{Changes, Refines};
use super::{RiemapApp, spoken};
use crate::conformal::Side;
use crate::platform;

/// How long the map must rest before an expensive quality is computed, in seconds.
const REST_SECONDS: f64 = 0.15;

impl RiemapApp {
    /// Sends what is due to the workers, updates the map, uploads.
    pub(super) fn advance(&mut self, context: &egui::Context) {
        let now = context.input(|input| input.time);
        self.editor.follow(&mut self.model, &mut self.views);
        if let Some(study) = self.reports.take_study() {
            self.laboratory.begin(study);
        }
        let is_held = self.handles.grip.is_some();
        if is_held {
            self.player.pause();
        }
        self.play(context, now);
        // A dot that is held still rests.
        let moves = self.player.is_moving() || (is_held && now - self.last_change < REST_SECONDS);
        let changes = self.model.refresh(moves);
        if changes != Changes::default() {
            self.last_change = now;
            self.show_changes(context, changes);
        }
        // after the map: what is in a hand is prepared anew as soon as the picture shows it, in the same frame
        for (subject, request) in self.model.take_requests(now) {
            self.preparer.request(subject, request);
        }
        if let Some(due) = self.model.next_due() {
            context.request_repaint_after_secs((due - now).max(0.0) as f32);
        }
        let resting = now - self.last_change >= REST_SECONDS;
        if resting {
            let refined = self.model.refine_at_rest();
            if refined.images {
                self.show_changes(context, refined);
            }
            if self.model.surface_map().is_some() {
                self.model.surface_side().sort_at_rest();
            }
            if self.model.is_ready() {
                self.preparer.warm();
                self.gpu.iter().for_each(Gpu::warm);
            }
        }
        if self.model.is_pending() {
            context.request_repaint_after_secs(if moves { REST_SECONDS as f32 } else { 0.0 });
        }
        self.refit(context);
        let complete = self.model.extension_progress() == 1.0;
        if self.model.is_quality_stale() || !complete {
            if resting && complete {
                self.model.measure_at_rest();
                context.request_repaint_after_secs(platform::ONE_FRAME);
            } else {
                context.request_repaint_after_secs(REST_SECONDS as f32);
            }
        }
        if let Some(delay) = self.model.teach(now) {
            context.request_repaint_after_secs(delay as f32);
        }
        self.work_on_export(context);
        self.describe(context, now);
        self.keep(context);
        self.cells.update(&self.model, self.gpu.as_ref(), context.pixels_per_point());
        self.plots.update(&self.model);
    }

    /// What has another shape is seen as a whole again.
    fn refit(&mut self, context: &egui::Context) {
        for side in Side::BOTH {
            if self.model.take_refit(side) {
                self.views[side as usize].fit();
                if side == Side::Target && self.model.surface().is_some() {
                    self.look_at_surface();
                } else {
                    context.request_repaint_after_secs(platform::ONE_FRAME);
                }
            }
        }
    }

    /// Moves the points that are in motion.
    fn play(&mut self, context: &egui::Context, now: f64) {
        for command in self.player.advance(&self.model, now) {
            self.keeper.touch();
            self.model.dispatch(command, now);
        }
        if self.player.is_playing() {
            context.request_repaint();
        }
    }

    /// Tells those who hear the screen what is on it, whenever something else is and has come to rest.
    fn describe(&mut self, context: &egui::Context, now: f64) {
        let rested = now - self.last_change;
        if rested < REST_SECONDS {
            // a drag collects no news
            context.request_repaint_after_secs((REST_SECONDS - rested) as f32);
            return;
        }
        let news = (self.model.generation(), self.model.is_ready(), self.errors(), self.explore.step());
        let news = (news, self.preferences, self.notice.as_ref().map(|(_, until)| until.to_bits()));
        if self.described.as_ref() == Some(&news) {
            return;
        }
        platform::describe(&spoken::state(self));
        self.described = Some(news);
    }

    /// Another surface is seen from where it shows the most.
    fn look_at_surface(&mut self) {
        let seen = self.model.surface();
        if let Some(camera) = seen.and_then(|(surface, state)| surface.first_view(state, self.orbit.aspect())) {
            self.orbit.look(camera);
        }
    }

    /// Uploads, and asks for another frame: the status line was laid out before the change. That one waits a little:
    /// where the processor draws, it would keep the first from the screen.
    fn show_changes(&mut self, context: &egui::Context, changes: Changes) {
        context.request_repaint_after_secs(WORDS_FOLLOW_AFTER);
        if let Some(gpu) = &mut self.gpu
            && !gpu.upload(&self.model, changes)
        {
            self.message =
                Some(String::from("This surface is too large for the graphics device: it is mapped but not shown."));
        }
        let extended = self.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        self.model.set_refines(if extended { Refines::AtRest } else { Refines::InRefresh });
    }
}

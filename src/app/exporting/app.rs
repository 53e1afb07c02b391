//! What the app does with the window of exports.

use super::file;
use super::job::{Job, Scenery};
use super::window::{MapState, Surroundings};
use crate::app::gpu::Gpu;
use crate::app::{Actions, RiemapApp, still};
use crate::platform;
use crate::render::OrbitCamera;
use egui::Context;

/// Without a graphics device there are no pictures.
const NO_DEVICE: &str = "There is no graphics device to draw with.";

impl RiemapApp {
    /// Shows the window, if it is open.
    pub(in crate::app) fn show_exporter(&mut self, context: &Context, actions: &mut Actions) {
        let around = Surroundings {
            map: self.map_state(),
            on_surface: self.model.surface().is_some(),
            max_side: self.gpu.as_ref().map_or(0, Gpu::max_texture_side),
        };
        self.exporter.show(context, around, actions);
    }

    fn map_state(&self) -> MapState {
        match (self.model.is_ready(), still::is_complete(&self.model)) {
            (_, true) => MapState::Complete,
            (true, false) => MapState::Ready,
            (false, false) => MapState::Preparing,
        }
    }

    /// Saves what is chosen, or begins to make it.
    pub(in crate::app) fn save_export(&mut self, context: &Context) {
        let Some(wish) = self.exporter.file_wish() else { return self.begin_job(context) };
        if !still::is_complete(&self.model) {
            return; // what is shown is not yet what would be written
        }
        match file(&self.model, wish) {
            Some(Ok(file)) => {
                self.exporter.tell(None);
                platform::save_file(&file.name, file.bytes, self.mailbox.clone());
            }
            Some(Err(reason)) => self.exporter.tell(Some(reason)),
            None => {}
        }
    }

    fn begin_job(&mut self, context: &Context) {
        let wish = *self.exporter.wish();
        let dark = context.theme() == egui::Theme::Dark;
        let camera = self.camera(wish.shot(dark).aspect());
        let scenery = Scenery { image: self.image.clone(), camera, dark };
        let job = match &self.gpu {
            Some(gpu) => Job::begin(&self.model, &wish, scenery, gpu.device()),
            None => Err(String::from(NO_DEVICE)),
        };
        self.exporter.begin(job);
        context.request_repaint();
    }

    /// The eye that sees the surface on the screen, in a viewport of this width over height.
    fn camera(&self, aspect: f64) -> Option<OrbitCamera> {
        let scene = self.model.surface()?.0.scene()?;
        let mut camera = *self.orbit.camera()?;
        if self.orbit.is_fitted() {
            camera.fit(scene, aspect);
        }
        Some(camera)
    }

    /// Goes on with what is being made, and saves it when it is there.
    pub(in crate::app) fn work_on_export(&mut self, context: &Context) {
        if !self.exporter.is_busy() {
            return;
        }
        context.request_repaint();
        let Some(gpu) = &self.gpu else { return };
        if let Some(file) = self.exporter.work(gpu.device()) {
            platform::save_file(&file.name, file.bytes, self.mailbox.clone());
        }
    }
}

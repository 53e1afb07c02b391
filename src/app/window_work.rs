//! The app's side of the windows of exports and of map projections: their actions, carried out.

use crate::app::RiemapApp;
use crate::app::input::action::{Actions, ExportAction, ProjectionAction};
use crate::app::panels::offer::Offer;
use crate::app::viewport::gpu::Gpu;
use crate::app::windows::exporting::window::{MapState, Surroundings};
use crate::conformal::PerSide;
use crate::language::key;
use crate::model::export::file;
use crate::model::export::request::Kind;
use crate::model::files::FilePurpose;
use crate::model::scene;
use crate::offscreen::job::{Job, Scenery};
use crate::platform;
use crate::worker::{Finding, FormulaTask, ProjectionTask, Study};
use egui::Context;

impl RiemapApp {
    /// Shows the export window, if it is open.
    pub(in crate::app) fn show_exporter(&mut self, context: &Context, actions: &mut Actions) {
        let around = Surroundings {
            map: self.map_state(),
            abilities: self.model.abilities(),
            max_side: self.pictures.gpu.as_ref().map_or(0, Gpu::max_texture_side),
            no_formula: self.model.refused_formula(),
        };
        let session = self.model.session();
        self.windows.exporter.compare_formula(PerSide::from_fn(|side| session.side(side)));
        self.windows.exporter.show(context, &around, actions);
    }

    fn map_state(&self) -> MapState {
        match (self.model.is_ready(), scene::is_complete(&self.model)) {
            (_, true) => MapState::Complete,
            (true, false) => MapState::Ready,
            (false, false) => MapState::Preparing,
        }
    }

    /// Carries out an action of the export window.
    pub(in crate::app) fn export(&mut self, action: ExportAction, context: &Context) {
        match action {
            ExportAction::Open => self.windows.exporter.open(),
            ExportAction::Save => self.save_export(context),
            ExportAction::Cancel => {
                self.windows.exporter.cancel();
                self.workers.formula_runner.cancel();
            }
            ExportAction::DismissError => self.windows.exporter.tell(None),
            ExportAction::Close => {
                self.windows.exporter.close();
                self.workers.formula_runner.cancel();
            }
        }
    }

    /// Saves the selected export, or starts a job that creates it.
    fn save_export(&mut self, context: &Context) {
        if self.windows.exporter.request().kind == Kind::Formula {
            return self.begin_formula();
        }
        let Some(request) = self.windows.exporter.file_request() else { return self.begin_job(context) };
        if !scene::is_complete(&self.model) {
            return; // the picture does not show yet what would be written
        }
        let picture = self.pictures.image.as_ref().map(|image| &*image.pixels);
        match file(&self.model, request, picture) {
            Some(Ok(file)) => {
                self.windows.exporter.tell(file.note);
                platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone());
            }
            Some(Err(reason)) => self.windows.exporter.tell(Some(reason)),
            None => {}
        }
    }

    fn begin_job(&mut self, context: &Context) {
        let request = *self.windows.exporter.request();
        let dark = context.theme() == egui::Theme::Dark;
        let aspect = request.shot(dark).aspect();
        let image = self.pictures.image.as_ref().map(|image| image.pixels.clone());
        let scenery =
            Scenery { image, cameras: PerSide::from_fn(|side| self.pictures.camera(&self.model, side, aspect)), dark };
        let job = match &self.pictures.gpu {
            Some(gpu) => Job::begin(&self.model, &request, scenery, gpu.device()),
            None => Err(key::no_graphics_device().into()),
        };
        self.windows.exporter.begin(job);
        context.request_repaint();
    }

    fn begin_formula(&mut self) {
        let request = self.windows.exporter.request();
        match self.model.formula_task(request.formula, request.digits()) {
            Ok(task) => {
                if let Some(file) = self.windows.exporter.made_formula(&task) {
                    return platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone());
                }
                let session = self.model.session();
                let sides = PerSide::from_fn(|side| session.side(side).clone());
                self.windows.exporter.begin_formula(task.clone(), sides);
                self.workers.formula_runner.begin(Study::Formula(Box::new(task)));
            }
            Err(reason) => self.windows.exporter.tell(Some(reason)),
        }
    }

    /// Takes a finding about a formula, and saves the file when it is complete.
    pub(in crate::app) fn take_formula(&mut self, task: &FormulaTask, finding: Finding) {
        if let Some(file) = self.windows.exporter.accept_formula(task, finding) {
            platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone());
        }
    }

    /// Continues the export job, and saves the file when it is complete.
    pub(in crate::app) fn work_on_export(&mut self, context: &Context) {
        if !self.windows.exporter.is_drawing() {
            return;
        }
        context.request_repaint();
        let Some(gpu) = &self.pictures.gpu else { return };
        if let Some(file) = self.windows.exporter.work(gpu.device()) {
            platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone());
        }
    }
}

impl RiemapApp {
    /// Carries out an action of the window.
    pub(in crate::app) fn act_on_projection(&mut self, action: ProjectionAction) {
        match action {
            ProjectionAction::Open => self.windows.projection.open(),
            ProjectionAction::OpenFile => self.pick_file(FilePurpose::Region),
            ProjectionAction::Island => self.project(ProjectionTask::Island),
            ProjectionAction::Offered => {
                if let Some(opened) = self.messages.offer.take().and_then(Offer::into_region) {
                    let task = ProjectionTask::of_file(&opened.file.name, opened.file.bytes.to_vec());
                    self.project(task.with_feature(opened.part));
                }
            }
            ProjectionAction::Feature(feature) => self.project_again(|task| task.with_feature(feature)),
            ProjectionAction::Repair => self.project_again(ProjectionTask::repaired),
            ProjectionAction::Save(format) => {
                if let Some(file) = self.windows.projection.file(format) {
                    platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone());
                }
            }
            ProjectionAction::Cancel => self.cancel_projection(),
            ProjectionAction::Close => {
                self.cancel_projection();
                self.windows.projection.close();
            }
        }
    }

    /// Computes a region's projection, in place of the one that is shown, and shows the window.
    pub(in crate::app) fn project(&mut self, task: ProjectionTask) {
        self.windows.projection.begin(task.clone());
        self.workers.projection_runner.begin(Study::Projection(Box::new(task)));
    }

    /// Computes the projection of another region of the file that is shown.
    fn project_again(&mut self, change: impl FnOnce(ProjectionTask) -> ProjectionTask) {
        if let Some(task) = self.windows.projection.task().cloned() {
            self.project(change(task));
        }
    }

    fn cancel_projection(&mut self) {
        if self.windows.projection.cancel() {
            self.workers.projection_runner.cancel();
        }
    }
}

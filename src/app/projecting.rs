//! The app's side of the window of map projections.

use super::RiemapApp;
use crate::app::input::action::ProjectionAction;
use crate::app::panels::offer::Offer;
use crate::model::files::FilePurpose;
use crate::platform;
use crate::worker::{ProjectionTask, Study};

impl RiemapApp {
    /// Carries out an action of the window.
    pub(super) fn act_on_projection(&mut self, action: ProjectionAction) {
        match action {
            ProjectionAction::Open => self.windows.projection.open(),
            ProjectionAction::OpenFile => self.pick_file(FilePurpose::Region),
            ProjectionAction::Island => self.project(ProjectionTask::Island),
            ProjectionAction::Offered => {
                if let Some(file) = self.messages.offer.take().and_then(Offer::into_region) {
                    self.project(ProjectionTask::File { name: file.name, bytes: file.bytes.to_vec() });
                }
            }
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
    pub(super) fn project(&mut self, task: ProjectionTask) {
        self.windows.projection.begin(task.clone());
        self.workers.projection_runner.begin(Study::Projection(Box::new(task)));
    }

    fn cancel_projection(&mut self) {
        if self.windows.projection.cancel() {
            self.workers.projection_runner.cancel();
        }
    }
}

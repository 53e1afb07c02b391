//! The window of map projections: the map of least distortion of a region of the globe, drawn, with its numbers, and saved.
//!
//! What is computed and shown is in this file, its layout in `window`, the drawing in `picture`. A worker computes it; the
//! finding of a task that was cancelled or replaced is dropped.

mod picture;
mod window;

use crate::export::ProjectionFormat;
use crate::language::{Message, key, number, say, tr};
use crate::model::export::ReadyFile;
use crate::worker::{Feature, Finding, FoundProjection, ProjectionTask, RefusedProjection};
use std::borrow::Cow;

/// The window; closed at first.
#[derive(Debug, Default)]
pub struct ProjectionWindow {
    is_open: bool,
    task: Option<ProjectionTask>,
    work: Work,
}

/// What has become of the task.
#[derive(Debug, Default)]
enum Work {
    /// There is none, or it was cancelled.
    #[default]
    None,
    /// The worker is at it; this share is done.
    Running(f64),
    /// It is done.
    Made(Box<FoundProjection>),
    /// Why there is no map.
    Failed(Box<RefusedProjection>),
}

impl Work {
    fn failed(reason: Message) -> Self {
        Self::Failed(Box::new(RefusedProjection { reason, repairable: false, features: Vec::new() }))
    }
}

impl ProjectionWindow {
    /// Whether the window is open.
    pub fn is_open(&self) -> bool {
        self.is_open
    }

    /// Opens the window, with what it showed last.
    pub fn open(&mut self) {
        self.is_open = true;
    }

    /// Closes the window; the map stays for the next time.
    pub fn close(&mut self) {
        self.is_open = false;
    }

    /// Opens the window and waits for the findings about a task.
    pub fn begin(&mut self, task: ProjectionTask) {
        *self = Self { is_open: true, task: Some(task), work: Work::Running(0.0) };
    }

    /// Drops the task in progress; returns whether there was one.
    pub fn cancel(&mut self) -> bool {
        let was_running = matches!(self.work, Work::Running(_));
        if was_running {
            (self.task, self.work) = (None, Work::None);
        }
        was_running
    }

    /// Takes a finding about a task, unless another one is running.
    pub fn accept(&mut self, task: &ProjectionTask, finding: Finding) {
        if !matches!(self.work, Work::Running(_)) || self.task.as_ref() != Some(task) {
            return;
        }
        self.work = match finding {
            Finding::Progress(done) => Work::Running(done),
            Finding::Projection(found) => Work::Made(found),
            Finding::NoProjection(refused) => Work::Failed(refused),
            Finding::Failed(reason) => Work::failed(reason),
            _ => Work::failed(key::another_answer().into()),
        };
    }

    /// What is computed or shown.
    pub fn task(&self) -> Option<&ProjectionTask> {
        self.task.as_ref()
    }

    /// The features of the file, if it has several, and the number of the one that is shown alone.
    fn features(&self) -> (&[Feature], Option<usize>) {
        let features = match &self.work {
            Work::Made(found) => &found.features[..],
            Work::Failed(refused) => &refused.features[..],
            Work::None | Work::Running(_) => &[],
        };
        (features, self.task.as_ref().and_then(ProjectionTask::feature))
    }

    /// The map that is shown.
    pub fn found(&self) -> Option<&FoundProjection> {
        if let Work::Made(found) = &self.work { Some(found) } else { None }
    }

    /// The share of the map that is computed, while it is.
    pub fn progress(&self) -> Option<f64> {
        if let Work::Running(done) = self.work { Some(done) } else { None }
    }

    /// The map as a file.
    pub fn file(&self, format: ProjectionFormat) -> Option<ReadyFile> {
        let place = ProjectionFormat::ALL.iter().position(|other| *other == format)?;
        let stem = self.task.as_ref()?.stem();
        let bytes = self.found()?.files[place].clone().into_bytes();
        Some(ReadyFile::new(format!("{stem}_projection.{}", format.extension()), bytes))
    }

    /// Why there is no map, with the file's name; nothing while the window is closed.
    pub fn error(&self) -> Option<Message> {
        let Work::Failed(refused) = &self.work else { return None };
        let name = self.name().into_owned();
        self.is_open.then(|| key::about(name, refused.reason.clone()))
    }

    /// What is shown, in sentences; nothing while the window is closed.
    pub fn words(&self) -> Option<String> {
        let found = self.found().filter(|_| self.is_open)?;
        let [ratio, stereographic] =
            [found.report.scale_ratio, found.report.stereographic_scale_ratio].map(|ratio| number(ratio, 6));
        let shown = say(&key::accessible_projection(self.name().into_owned(), ratio, stereographic));
        let notes = found.notes().iter().map(say).collect::<Vec<_>>();
        Some([vec![shown], notes].concat().join(" "))
    }

    /// The name of the region, or of its file until that is read.
    fn name(&self) -> Cow<'_, str> {
        match (&self.task, self.found()) {
            (Some(ProjectionTask::File { .. }), Some(found)) => found.report.name.as_str().into(),
            (Some(ProjectionTask::File { name, .. }), None) => name.as_str().into(),
            (Some(ProjectionTask::Island), _) => tr(key::island()).into(),
            (None, _) => tr(key::projection()).into(),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn findings_of_what_was_cancelled_or_replaced_are_dropped() {
        let mut window = ProjectionWindow::default();
        let file = ProjectionTask::of_file("a.geojson", vec![1]);
        window.begin(file.clone());
        window.accept(&file, Finding::Progress(0.5));
        assert_eq!(window.progress(), Some(0.5));
        window.begin(ProjectionTask::Island);
        window.accept(&file, Finding::Failed("stale".into()));
        assert_eq!((window.progress(), window.error()), (Some(0.0), None));
        assert!(window.cancel() && !window.cancel() && window.is_open());
        window.accept(&ProjectionTask::Island, Finding::Failed("canceled".into()));
        assert_eq!((window.error(), window.progress()), (None, None));
        window.begin(file.clone());
        window.accept(&file, Finding::Failed("no region".into()));
        assert_eq!(window.error().unwrap().english(), "a.geojson: no region");
        assert!(window.file(ProjectionFormat::Svg).is_none() && window.words().is_none());
        window.close();
        assert_eq!(window.error(), None, "a closed window says nothing");
    }
}

//! The windows: gallery, figures, list of keys and tour (`explore`); export (`exporting`); measurements (`reports`);
//! the link (`share`); the panel in which a lesson is made (`lesson`).

pub mod explore;
pub mod exporting;
pub mod lesson;
pub mod reports;
pub mod share;

/// The windows, each open or closed.
#[derive(Default)]
pub struct Windows {
    pub explore: explore::Explore,
    pub exporter: exporting::Exporter,
    pub reports: reports::Reports,
    pub share: share::Share,
    pub lesson: lesson::LessonEditor,
}

impl Windows {
    /// Whether a window is open.
    pub fn are_open(&self) -> bool {
        self.explore.is_open() || self.exporter.is_open() || self.reports.is_open() || self.share.is_open()
    }
}

//! The windows: gallery, figures, list of keys and tour (`explore`); export (`exporting`); measurements (`reports`);
//! the link (`share`); map projections (`projection`); the panel in which a lesson is made (`lesson`).

pub mod explore;
pub mod exporting;
pub mod lesson;
pub mod projection;
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
    pub projection: projection::ProjectionWindow,
}

impl Windows {
    /// Whether a window is open.
    pub fn are_open(&self) -> bool {
        let of_map = self.exporter.is_open() || self.share.is_open();
        self.explore.is_open() || of_map || self.reports.is_open() || self.projection.is_open()
    }
}

//! The windows: gallery, figures, list of keys and tour (`explore`); export (`exporting`); measurements (`reports`);
//! the link (`share`).

pub mod explore;
pub mod exporting;
pub mod reports;
pub mod share;

/// The windows, each open or closed.
#[derive(Default)]
pub struct Windows {
    pub explore: explore::Explore,
    pub exporter: exporting::Exporter,
    pub reports: reports::Reports,
    pub share: share::Share,
}

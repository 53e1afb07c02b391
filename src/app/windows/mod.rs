//! The windows: gallery, figures, list of keys and tour (`explore`); export (`exporting`); measurements (`reports`).

pub mod explore;
pub mod exporting;
pub mod reports;

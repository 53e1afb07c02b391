//! Windows over the app: gallery, tour, figures and keys; exports; measurements.

pub mod explore;
pub mod exporting;
pub mod reports;

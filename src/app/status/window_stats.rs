//! The state of the windows over the pictures, as a part of the record of the screen.

use serde::Serialize;
use std::collections::BTreeMap;

/// The windows over the pictures.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct WindowStats {
    /// Where the controls of the window of exports are, by name; `None` while it is closed.
    pub export: Option<BTreeMap<&'static str, [f32; 2]>>,
    /// How many pictures of how many are made, while they are.
    pub export_count: Option<[u32; 2]>,
    /// The progress of a formula, and what the last one reached.
    pub formula: FormulaStats,
    /// The map projection in its window; `None` while that is closed.
    pub projection: Option<ProjectionStats>,
    /// The paper's tables or figure that are measured; `None` while their window is closed.
    pub report: Option<ReportStats>,
    /// The link that the window "Share" shows; `None` while it is closed.
    pub share: Option<ShareStats>,
    /// Where the windows that are open are closed, by name.
    pub close: BTreeMap<&'static str, [f32; 2]>,
}

/// A link that is shared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ShareStats {
    /// The length of the address.
    pub bytes: usize,
    /// The modules along an edge of its QR code; `None` where the link is too long for one.
    pub modules: Option<usize>,
}

/// Measurements for a table or a figure of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ReportStats {
    /// How many rows are shown.
    pub measured: usize,
    /// How many are measured now or wait for it.
    pub left: usize,
}

/// A map projection that is computed or was computed.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct ProjectionStats {
    /// The share that is done, while it is computed.
    pub progress: Option<f64>,
    /// The largest scale over the least one.
    pub scale_ratio: Option<f64>,
    /// The same of the best stereographic projection.
    pub stereographic_scale_ratio: Option<f64>,
    /// The lines of equal scale that are drawn.
    pub scale_lines: usize,
    /// What is not in the map, and what is in it twice, in English.
    pub notes: Vec<String>,
}

/// A formula that is computed or was computed.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct FormulaStats {
    /// The share that is done, while it is computed.
    pub progress: Option<f64>,
    /// What the last one reached, in English.
    pub reached: Vec<String>,
}

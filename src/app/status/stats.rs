//! The state of the screen as one plain record, for `window.riemap.stats()` and for tests.

use crate::app::editing::EditingStats;
use crate::conformal::{FrameTimings, PrepareTimings, Side};
use crate::geometry::DVec2;
use crate::model::overlays::disk_comparison::Found;
use crate::model::{Model, Processor};
use crate::session::{Colouring, DiskWay};
use serde::Serialize;
use std::collections::BTreeMap;

/// The size of a prepared domain; zeros until it is prepared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct DomainSize {
    /// Boundary samples.
    pub m: usize,
    /// Interior vertices.
    pub n: usize,
    /// Triangles.
    pub triangles: usize,
}

/// The places of the dots, in CSS pixels of the page; `None` where a dot is not shown.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct HandlePositions {
    /// The source's interior point.
    pub x1: Option<[f32; 2]>,
    /// The target's interior point.
    pub x2: Option<[f32; 2]>,
    /// The source's boundary point.
    pub y1: Option<[f32; 2]>,
    /// The target's boundary point.
    pub y2: Option<[f32; 2]>,
}

/// The result of a map through the disk; arrays are by source and target.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ComparisonStats {
    /// Boundary samples.
    pub samples: [usize; 2],
    /// Samples at which the disk's harmonic measure is equal to that at the one before, up to rounding.
    pub collapsed: [usize; 2],
    /// Samples at which the disk's harmonic measure is less than at the one before, by more than rounding.
    pub disordered: [usize; 2],
    /// The largest difference between the images of both maps, as a fraction of the boundary's length.
    pub difference: f64,
}

/// The maps through the disk that are shown.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ComparisonsStats {
    /// With fresh disk maps.
    pub fresh: Option<ComparisonStats>,
    /// With precomputed disk maps.
    pub precomputed: Option<ComparisonStats>,
}

/// The state of the screen.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[allow(clippy::struct_excessive_bools, reason = "a record of what is on the screen")]
pub struct Stats {
    /// Whether the full-resolution map of the requested session is shown and nothing is being prepared.
    pub ready: bool,
    /// "WebGPU", "WebGL2", or the desktop's graphics API.
    pub backend: String,
    /// How many times the map has changed.
    pub generation: u64,
    /// Whether each side is being prepared.
    pub preparing: [bool; 2],
    /// The size of Ω₁.
    pub source: DomainSize,
    /// The size of Ω₂.
    pub target: DomainSize,
    /// Area-weighted mean of the angle distortion Q.
    pub q_mean: Option<f64>,
    /// The largest Q.
    pub q_max: Option<f64>,
    /// Triangles that changed their orientation.
    pub flipped: Option<u32>,
    /// The times of the preparation's stages of both sides, in ms.
    pub prepare_ms: [PrepareTimings; 2],
    /// The times of the surface's preparation, in ms; `None` where no surface is shown.
    pub surface_ms: Option<PrepareTimings>,
    /// The times of the last update of the map, in ms.
    pub frame_ms: FrameTimings,
    /// The error messages on the screen.
    pub errors: Vec<String>,
    /// The notes on the screen.
    pub notes: Vec<String>,
    /// The number of undo steps.
    pub undo: usize,
    /// Whether the dark theme is shown.
    pub dark: bool,
    /// How many times a control was announced to screen readers.
    pub spoken: u64,
    /// Whether the motion of the points is running.
    pub playing: bool,
    /// The centers of the export window's controls by English label; `None` while it is closed.
    pub export: Option<BTreeMap<&'static str, [f32; 2]>>,
    /// The centers of the close buttons of the open windows, by English name.
    pub close: BTreeMap<&'static str, [f32; 2]>,
    /// The number of finished pictures and of all pictures of the export under way.
    pub export_count: Option<[u32; 2]>,
    /// The coloring of the triangles.
    pub colouring: Colouring,
    /// The processor that evaluates the Cauchy–Green extension in the picture; `None` for the harmonic extension.
    pub cauchy_green: Option<Processor>,
    /// The progress of the map's own images from the harmonic to the requested extension, from 0 to 1.
    pub extension_progress: f64,
    /// Whether the edges of the mapped mesh are drawn.
    pub wireframe: bool,
    /// Whether the plots are open.
    pub plots: bool,
    /// The [`Self::generation`] of the map whose distortion is shown.
    pub measured_generation: u64,
    /// The boundary point under the pointer and the corresponding one: fractions of arc length of source and target.
    pub marked_boundary: Option<[f64; 2]>,
    /// The comparisons with maps through the disk.
    pub comparison: ComparisonsStats,
    /// The largest distance of the plotted reparameterization from the exact one, as a fraction of the length; `None`
    /// where the exact one is not known.
    pub exact_difference: Option<f64>,
    /// The number of random walks, and the largest deviation of their hits from the harmonic measure.
    pub walks: (u64, Option<f64>),
    /// The places of the dots.
    pub handles: HandlePositions,
    /// The outline that is being drawn, reshaped or pasted.
    pub editing: Option<EditingStats>,
    /// The image of the mapped side's interior point under the piecewise linear map.
    pub image_of_mapped_point: Option<[f64; 2]>,
    /// The expected value of [`Self::image_of_mapped_point`]: the other side's interior point.
    pub expected: Option<[f64; 2]>,
    /// `Σ (k + 1)/m · (x_k + y_k)` over the images of the mapped side's boundary vertices.
    pub boundary_checksum: f64,
}

/// The part of [`Stats`] that the model does not know.
#[derive(Debug, Clone, Default)]
pub struct ScreenFacts {
    /// The graphics API.
    pub backend: String,
    /// The places of the dots.
    pub handles: HandlePositions,
    /// The error messages on the screen.
    pub errors: Vec<String>,
    /// The notes on the screen.
    pub notes: Vec<String>,
    /// The number of undo steps.
    pub undo: usize,
    /// Whether the dark theme is shown.
    pub dark: bool,
    /// How many times a control was announced to screen readers.
    pub spoken: u64,
    /// Whether the motion of the points is running.
    pub playing: bool,
    /// The centers of the export window's controls.
    pub export: Option<BTreeMap<&'static str, [f32; 2]>>,
    /// The centers of the close buttons of the open windows.
    pub close: BTreeMap<&'static str, [f32; 2]>,
    /// The number of finished pictures and of all pictures of the export under way.
    pub export_count: Option<[u32; 2]>,
    /// The boundary point under the pointer and the corresponding one.
    pub marked_boundary: Option<[f64; 2]>,
    /// The distance of the plotted reparameterization from the exact one.
    pub exact_difference: Option<f64>,
    /// The processor that evaluates the Cauchy–Green extension.
    pub cauchy_green: Option<Processor>,
    /// The outline that is being drawn, reshaped or pasted.
    pub editing: Option<EditingStats>,
}

/// Builds the record from the model and the screen.
pub fn collect(model: &Model, screen: ScreenFacts) -> Stats {
    let quality = model.quality();
    let mapped = model.shown().map_or(model.session().direction().mapped_side(), |map| map.mapped_side());
    Stats {
        ready: model.is_ready(),
        backend: screen.backend,
        generation: model.generation(),
        preparing: Side::BOTH.map(|side| model.is_preparing(side)),
        source: size(model, Side::Source),
        target: size(model, Side::Target),
        q_mean: quality.map(|q| q.q_mean),
        q_max: quality.map(|q| q.q_max),
        flipped: quality.map(|q| q.flipped),
        prepare_ms: Side::BOTH.map(|side| model.side(side).prepared().map(|side| side.timings()).unwrap_or_default()),
        surface_ms: model.map().filter(|map| map.mapped().is_surface()).map(|map| map.mapped().timings()),
        frame_ms: model.shown().map(|map| map.timings).unwrap_or_default(),
        errors: screen.errors,
        notes: screen.notes,
        undo: screen.undo,
        dark: screen.dark,
        spoken: screen.spoken,
        playing: screen.playing,
        export: screen.export,
        close: screen.close,
        export_count: screen.export_count,
        colouring: model.session().colouring(),
        cauchy_green: screen.cauchy_green,
        extension_progress: model.extension_progress(),
        wireframe: model.session().wireframe(),
        plots: model.session().plots(),
        measured_generation: model.measured_generation(),
        marked_boundary: screen.marked_boundary,
        comparison: ComparisonsStats {
            fresh: comparison(model, DiskWay::Fresh),
            precomputed: comparison(model, DiskWay::Precomputed),
        },
        exact_difference: screen.exact_difference,
        walks: (model.overlay_state().walks.count(), model.overlay_state().walks.deviation()),
        handles: screen.handles,
        editing: screen.editing,
        image_of_mapped_point: image_of_point(model, mapped),
        expected: model.interior(mapped.other()).map(|point| point.to_array()),
        boundary_checksum: boundary_checksum(model),
    }
}

fn comparison(model: &Model, way: DiskWay) -> Option<ComparisonStats> {
    let &Found { samples, collapsed, disordered, difference, .. } = model.overlay_state().disk_comparison.found(way)?;
    Some(ComparisonStats { samples, collapsed, disordered, difference })
}

fn size(model: &Model, side: Side) -> DomainSize {
    model.prepared(side).map_or_else(DomainSize::default, |prepared| DomainSize {
        m: prepared.boundary_count(),
        n: prepared.interior_count(),
        triangles: prepared.triangles().len(),
    })
}

fn image_of_point(model: &Model, mapped: Side) -> Option<[f64; 2]> {
    let map = model.map()?;
    if let Some(point) = model.point(mapped)?.on_surface() {
        let corners = map.mapped().triangles()[point.triangle as usize];
        let image: DVec2 = corners.iter().zip(point.weights).map(|(&v, w)| w * map.images()[v as usize]).sum();
        return Some(image.to_array());
    }
    Some(map.image_of(model.interior(mapped)?)?.to_array())
}

fn boundary_checksum(model: &Model) -> f64 {
    let Some(map) = model.shown() else { return 0.0 };
    let m = map.boundary_count;
    let weighted = |(k, image): (usize, &DVec2)| (k + 1) as f64 / m as f64 * (image.x + image.y);
    map.images.iter().take(m).enumerate().map(weighted).sum()
}

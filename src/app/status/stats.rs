//! The numbers on the screen as one plain record, for `window.riemap.stats()` and for tests.

use crate::app::editing::EditingStats;
use crate::conformal::{FrameTimings, PrepareTimings, Side};
use crate::geometry::DVec2;
use crate::model::overlays::disk_comparison::Found;
use crate::model::{Model, Processor};
use crate::session::{Colouring, DiskWay};
use serde::Serialize;
use std::collections::BTreeMap;

/// The size of a prepared domain; zeros before there is one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct DomainSize {
    /// Boundary samples.
    pub m: usize,
    /// Interior vertices.
    pub n: usize,
    /// Triangles.
    pub triangles: usize,
}

/// Where the handles are, in CSS pixels of the page.
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

/// A map through the disk, by source and target.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ComparisonStats {
    /// Boundary samples.
    pub samples: [usize; 2],
    /// How many can't be told from the one before.
    pub collapsed: [usize; 2],
    /// How many came out before the one before.
    pub disordered: [usize; 2],
    /// The largest difference between the images, as a part of the boundary's length.
    pub difference: f64,
}

/// The maps through the disk that are shown.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct ComparisonsStats {
    /// By fresh disk maps.
    pub fresh: Option<ComparisonStats>,
    /// By precomputed ones.
    pub precomputed: Option<ComparisonStats>,
}

/// What is on the screen now.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[allow(clippy::struct_excessive_bools, reason = "a record of what is on the screen")]
pub struct Stats {
    /// The full map of what is asked for is shown and nothing is being prepared.
    pub ready: bool,
    /// "WebGPU", "WebGL2", or what the desktop draws with.
    pub backend: String,
    /// How many times the map has changed.
    pub generation: u64,
    /// Whether each side is being prepared.
    pub preparing: [bool; 2],
    /// Ω₁.
    pub source: DomainSize,
    /// Ω₂.
    pub target: DomainSize,
    /// Area-weighted mean of the angle distortion Q.
    pub q_mean: Option<f64>,
    /// The largest Q.
    pub q_max: Option<f64>,
    /// Triangles that changed their orientation.
    pub flipped: Option<u32>,
    /// How long the stages of the preparation took, in ms.
    pub prepare_ms: [PrepareTimings; 2],
    /// Those of the surface; `None` where none is shown.
    pub surface_ms: Option<PrepareTimings>,
    /// What the last update of the map took, in ms.
    pub frame_ms: FrameTimings,
    /// The error messages on the screen.
    pub errors: Vec<String>,
    /// The notes on the screen.
    pub notes: Vec<String>,
    /// How many steps can be taken back.
    pub undo: usize,
    /// Whether the dark theme is shown.
    pub dark: bool,
    /// How many times a control was said to those who hear the screen.
    pub spoken: u64,
    /// Whether points are in motion.
    pub playing: bool,
    /// Where the controls of the window of exports are, by name; `None` while it is closed.
    pub export: Option<BTreeMap<&'static str, [f32; 2]>>,
    /// Where the windows that are open are closed, by name.
    pub close: BTreeMap<&'static str, [f32; 2]>,
    /// How many pictures of how many are made, while they are.
    pub export_count: Option<[u32; 2]>,
    /// What the meshes are painted with.
    pub colouring: Colouring,
    /// Where the Cauchy–Green extension in the picture comes from; `None` if it is not asked for.
    pub cauchy_green: Option<Processor>,
    /// How far the map's own images are those of the extension that is asked for, from 0 to 1.
    pub extension_progress: f64,
    /// Whether the mapped mesh's edges are drawn.
    pub wireframe: bool,
    /// Whether the plots are open.
    pub plots: bool,
    /// The [`Self::generation`] of the map whose distortion is shown.
    pub measured_generation: u64,
    /// The boundary point under the pointer and its partner: fractions of arc length of source and target.
    pub marked_boundary: Option<[f64; 2]>,
    /// What the map is compared with.
    pub comparison: ComparisonsStats,
    /// How far the reparameterisation in the plot is from the exact one, where that is known, as a part of the length.
    pub exact_difference: Option<f64>,
    /// How many random walks were counted, and the largest deviation of their hits from the harmonic measure.
    pub walks: (u64, Option<f64>),
    /// Where the handles are.
    pub handles: HandlePositions,
    /// The outline that is being reshaped.
    pub editing: Option<EditingStats>,
    /// The image of the mapped side's interior point under the piecewise linear map.
    pub image_of_mapped_point: Option<[f64; 2]>,
    /// Where it should be: the other side's interior point.
    pub expected: Option<[f64; 2]>,
    /// `Σ (k + 1)/m · (x_k + y_k)` over the images of the mapped side's boundary vertices.
    pub boundary_checksum: f64,
}

/// What the screen knows and the model does not.
#[derive(Debug, Clone, Default)]
pub struct ScreenFacts {
    /// What it draws with.
    pub backend: String,
    /// Where the handles are.
    pub handles: HandlePositions,
    /// The messages.
    pub errors: Vec<String>,
    /// The notes.
    pub notes: Vec<String>,
    /// How many steps can be taken back.
    pub undo: usize,
    /// Whether the dark theme is shown.
    pub dark: bool,
    /// How many times a control was said to those who hear the screen.
    pub spoken: u64,
    /// Whether points are in motion.
    pub playing: bool,
    /// Where the controls of the window of exports are.
    pub export: Option<BTreeMap<&'static str, [f32; 2]>>,
    /// Where the windows that are open are closed.
    pub close: BTreeMap<&'static str, [f32; 2]>,
    /// How many pictures of how many are made.
    pub export_count: Option<[u32; 2]>,
    /// The boundary point under the pointer and its partner.
    pub marked_boundary: Option<[f64; 2]>,
    /// The distance of the plotted reparameterisation from the exact one.
    pub exact_difference: Option<f64>,
    /// Where the Cauchy–Green extension comes from.
    pub cauchy_green: Option<Processor>,
    /// The outline that is being reshaped.
    pub editing: Option<EditingStats>,
}

/// Collects the record.
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

//! The state of the screen as one plain record, for `window.riemap.stats()` and for tests.

use crate::app::editing::EditingStats;
use crate::app::status::best::BestStats;
use crate::app::status::symmetries::SymmetryStats;
use crate::app::status::window_stats::WindowStats;
use crate::conformal::{FrameTimings, KernelMode, PerSide, PrepareTimings, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::model::overlays::disk_comparison::Found;
use crate::model::{ErrorBounds, Model, PointedImage, Processor, SideKernel};
use crate::outline::Interpreted;
use crate::session::{Colouring, DiskWay};
use crate::worker::{FoundGrid, FoundInvariants, Number};
use serde::Serialize;

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
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct HandlePositions {
    /// The source's interior point.
    pub x1: Option<[f32; 2]>,
    /// The target's interior point.
    pub x2: Option<[f32; 2]>,
    /// The source's boundary point.
    pub y1: Option<[f32; 2]>,
    /// The target's boundary point.
    pub y2: Option<[f32; 2]>,
    /// The source's and the target's pins; none: the points determine the map.
    pub pins: [Vec<[f32; 2]>; 2],
    /// The squares of the source's and the target's marks.
    pub marks: [Vec<[f32; 2]>; 2],
    /// What has caught the dot that was dragged last, in words.
    pub caught: Option<String>,
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

/// What is prepared.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PreparationStats {
    /// The full map of what is asked for is shown and nothing is being prepared.
    pub ready: bool,
    /// Whether each side is being prepared.
    pub preparing: [bool; 2],
    /// The size of Ω₁.
    pub source: DomainSize,
    /// The size of Ω₂.
    pub target: DomainSize,
    /// How long the stages of the preparation took, in ms.
    pub prepare_ms: [PrepareTimings; 2],
    /// The times of the mapped surface's preparation, in ms; `None` where no surface is shown.
    pub surface_ms: Option<PrepareTimings>,
    /// The kernel of each side; `None` until it is prepared.
    pub kernels: [Option<KernelStats>; 2],
}

/// The kernel that a side uses.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct KernelStats {
    /// "integral", "adjoint" or "table".
    pub kernel: KernelMode,
    /// The unknowns of the integral equation.
    pub unknowns: Option<usize>,
    /// Whether the integral equation is due or being factored.
    pub sharpening: bool,
    /// Why finite elements are used although the boundary integral was requested.
    pub reason: Option<String>,
    /// What the points of a loaded outline were taken for.
    pub interpretation: Option<Interpreted>,
}

/// The map that is shown.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapStats {
    /// How many times the map has changed.
    pub generation: u64,
    /// What the last update of the map took, in ms.
    pub frame_ms: FrameTimings,
    /// How far the map's own images are those of the extension that is asked for, from 0 to 1.
    pub extension_progress: f64,
    /// The image of the mapped side's interior point under the piecewise linear map; between two surfaces in the disk.
    pub image_of_mapped_point: Option<[f64; 2]>,
    /// The expected value of [`Self::image_of_mapped_point`]: the other side's interior point, or the disk's center.
    pub expected: Option<[f64; 2]>,
    /// The number of triangles of the mapped mesh that is shown.
    pub triangles: usize,
    /// The area that the images do not cover, as a fraction of the domain; `None` unless the map is refined.
    pub unresolved_area: Option<f64>,
    /// Why the map at rest is not refined.
    pub unrefined: Option<String>,
    /// The estimate of the map's errors; `None` unless both sides use the boundary integral.
    pub error_estimate: Option<ErrorBounds>,
    /// The distance between each pin's image and its target; `None` without pins, and while the map is computed.
    pub pin_misses: Option<Vec<f64>>,
    /// `Σ (k + 1)/m · (x_k + y_k)` over the images of the mapped side's boundary vertices.
    pub boundary_checksum: f64,
}

/// The distortion that is shown.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QualityStats {
    /// The [`MapStats::generation`] of the map that it is of.
    pub measured_generation: u64,
    /// Area-weighted mean of the angle distortion Q; `None` where it is not resolved.
    pub q_mean: Option<f64>,
    /// The largest Q.
    pub q_max: Option<f64>,
    /// Triangles that changed their orientation.
    pub flipped: Option<u32>,
    /// The share of the area in triangles whose image is a point or a segment.
    pub collapsed_area: Option<f64>,
}

/// What is drawn of the map, and beside it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OverlayStats {
    /// What the meshes are painted with.
    pub colouring: Colouring,
    /// Whether the mapped mesh's edges are drawn.
    pub wireframe: bool,
    /// Whether the plots are open.
    pub plots: bool,
    /// What the map is compared with.
    pub comparison: ComparisonsStats,
    /// How many random walks were counted, and the largest deviation of their hits from the harmonic measure.
    pub walks: (u64, Option<f64>),
    /// The best map.
    pub best: BestStats,
    /// The invariants of both sides, where they are asked for and there; a text is why not.
    pub invariants: [Option<Result<FoundInvariants, String>>; 2],
    /// The symmetries of both outlines, where they are shown and found.
    pub symmetries: [Option<SymmetryStats>; 2],
    /// The orthogonal grids of both sides, where they are shown and there; a text is why not.
    pub grids: [Option<Result<GridStats, String>>; 2],
    /// The number of grid lines over each picture.
    pub grid_lines: [usize; 2],
}

/// An orthogonal grid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GridStats {
    /// The modulus between the marks.
    pub modulus: Number,
    /// The estimated error of a node.
    pub image_error: f64,
    /// The largest deviation of its angles from 90°, in degrees.
    pub angle_deviation: Option<f64>,
}

/// What the screen knows and the model does not.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct ScreenStats {
    /// "WebGPU", "WebGL2", or what the desktop draws with.
    pub backend: String,
    /// Whether the dark theme is shown.
    pub dark: bool,
    /// The error messages on the screen.
    pub errors: Vec<String>,
    /// The notes on the screen.
    pub notes: Vec<String>,
    /// How many times a control was said to those who hear the screen.
    pub spoken: u64,
    /// How many steps can be taken back.
    pub undo: usize,
    /// Whether points are in motion.
    pub playing: bool,
    /// Where the Cauchy–Green extension in the picture comes from; `None` if it is not asked for.
    pub cauchy_green: Option<Processor>,
    /// The map at the point under the pointer.
    pub pointed: Option<PointedImage>,
    /// The file name of the own picture.
    pub image: Option<String>,
    /// Where the handles are.
    pub handles: HandlePositions,
    /// Where the numbers of the boundary loops are, on each side that is a surface with several.
    pub loops: [Vec<[f32; 2]>; 2],
    /// The outline that is being reshaped.
    pub editing: Option<EditingStats>,
    /// The plots.
    #[serde(flatten)]
    pub plots: PlotStats,
    /// The windows.
    #[serde(flatten)]
    pub windows: WindowStats,
}

/// What the plots show.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct PlotStats {
    /// The boundary point under the pointer and its partner: fractions of arc length of source and target.
    pub marked_boundary: Option<[f64; 2]>,
    /// How far the reparameterisation in the plot is from the exact one, where that is known, as a part of the length.
    pub exact_difference: Option<f64>,
}

/// What is on the screen now. A page gets one object with the keys of all parts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stats {
    /// What is prepared.
    #[serde(flatten)]
    pub preparation: PreparationStats,
    /// The map.
    #[serde(flatten)]
    pub map: MapStats,
    /// Its distortion.
    #[serde(flatten)]
    pub quality: QualityStats,
    /// What is drawn of it.
    #[serde(flatten)]
    pub overlays: OverlayStats,
    /// What the screen knows.
    #[serde(flatten)]
    pub screen: ScreenStats,
}

impl Stats {
    /// Of what the model shows on a screen.
    pub fn new(model: &Model, screen: ScreenStats) -> Self {
        Self {
            preparation: preparation(model),
            map: map(model),
            quality: quality(model),
            overlays: overlays(model),
            screen,
        }
    }
}

fn preparation(model: &Model) -> PreparationStats {
    PreparationStats {
        ready: model.is_ready(),
        preparing: Side::BOTH.map(|side| model.is_preparing(side)),
        source: size(model, Side::Source),
        target: size(model, Side::Target),
        prepare_ms: Side::BOTH.map(|side| model.side(side).prepared().map(|side| side.timings()).unwrap_or_default()),
        surface_ms: model.surface_timings(),
        kernels: Side::BOTH.map(|side| kernel(model, side)),
    }
}

fn kernel(model: &Model, side: Side) -> Option<KernelStats> {
    let (kernel, unknowns, reason) = match model.side_kernel(side)? {
        SideKernel::Integral { unknowns } => (KernelMode::Integral, Some(unknowns), None),
        SideKernel::Stays(reason) => (KernelMode::Adjoint, None, Some(reason.english())),
        SideKernel::Sharpening => (KernelMode::Adjoint, None, None),
        SideKernel::FiniteElements(kernel) => (kernel, None, None),
    };
    let interpretation = model.interpretation(side).map(|interpreting| interpreting.taken.interpreted);
    Some(KernelStats { kernel, unknowns, sharpening: model.is_sharpening(side), reason, interpretation })
}

fn map(model: &Model) -> MapStats {
    let mapped = model.shown().map_or(model.session().direction().mapped_side(), |map| map.mapped_side());
    MapStats {
        generation: model.generation(),
        frame_ms: model.shown().map(|map| map.timings).unwrap_or_default(),
        extension_progress: model.extension_progress(),
        image_of_mapped_point: image_of_point(model, mapped),
        expected: if model.is_through_disk() { Some(DVec2::ZERO) } else { model.interior(mapped.other()) }
            .map(|point| point.to_array()),
        triangles: model.shown().map_or(0, |map| map.triangles.len()),
        unresolved_area: model.unresolved_area(),
        unrefined: model.unrefined().map(Message::english),
        error_estimate: model.error_bounds(),
        pin_misses: model.pin_misses().map(<[f64]>::to_vec),
        boundary_checksum: boundary_checksum(model),
    }
}

fn quality(model: &Model) -> QualityStats {
    let quality = model.quality();
    QualityStats {
        measured_generation: model.measured_generation(),
        q_mean: quality.and_then(|q| q.resolved_mean()),
        q_max: quality.map(|q| q.q_max),
        flipped: quality.map(|q| q.flipped),
        collapsed_area: quality.map(|q| q.collapsed_area),
    }
}

fn overlays(model: &Model) -> OverlayStats {
    let (session, walks) = (model.session(), &model.overlay_state().walks);
    OverlayStats {
        colouring: session.colouring(),
        wireframe: session.wireframe(),
        plots: session.plots(),
        comparison: ComparisonsStats {
            fresh: comparison(model, DiskWay::Fresh),
            precomputed: comparison(model, DiskWay::Precomputed),
        },
        walks: (walks.count(), walks.deviation()),
        best: BestStats::of(model),
        invariants: Side::BOTH.map(|side| Some(model.invariants(side)?.clone().map_err(|reason| reason.english()))),
        symmetries: Side::BOTH.map(|side| Some(SymmetryStats::of(&model.symmetries(side)?.as_ref().ok()?.symmetries))),
        grids: Side::BOTH.map(|side| Some(model.grid(side)?.as_ref().map(grid).map_err(Message::english))),
        grid_lines: Side::BOTH.map(|side| model.grid_lines(side).len()),
    }
}

fn grid(&FoundGrid { modulus, image_error, angle_deviation, .. }: &FoundGrid) -> GridStats {
    GridStats { modulus, image_error, angle_deviation }
}

fn comparison(model: &Model, way: DiskWay) -> Option<ComparisonStats> {
    let &Found { samples, collapsed, disordered, difference, .. } = model.overlay_state().disk_comparison.found(way)?;
    let [samples, collapsed, disordered] = [samples, collapsed, disordered].map(PerSide::into_array);
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
        // while the picture is that of the surface's former resolution, the point is in no triangle of its mesh
        let mesh = model.prepared(mapped).filter(|present| std::sync::Arc::ptr_eq(present, map.mapped()))?;
        let corners = mesh.triangles().get(point.triangle().index())?;
        let image: DVec2 = corners.iter().zip(point.weights()).map(|(&v, w)| w * map.images()[v as usize]).sum();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;

    /// What pages read by these names.
    const KEYS: [&str; 55] = [
        "backend",
        "best",
        "boundary_checksum",
        "cauchy_green",
        "close",
        "collapsed_area",
        "colouring",
        "comparison",
        "dark",
        "editing",
        "error_estimate",
        "errors",
        "exact_difference",
        "expected",
        "export",
        "export_count",
        "extension_progress",
        "flipped",
        "formula",
        "frame_ms",
        "generation",
        "grid_lines",
        "grids",
        "handles",
        "image",
        "image_of_mapped_point",
        "invariants",
        "kernels",
        "loops",
        "marked_boundary",
        "measured_generation",
        "notes",
        "pin_misses",
        "playing",
        "plots",
        "pointed",
        "prepare_ms",
        "preparing",
        "projection",
        "q_max",
        "q_mean",
        "ready",
        "report",
        "share",
        "source",
        "spoken",
        "surface_ms",
        "symmetries",
        "target",
        "triangles",
        "undo",
        "unrefined",
        "unresolved_area",
        "walks",
        "wireframe",
    ];

    #[test]
    fn a_page_gets_one_object_with_the_keys_of_all_parts() {
        let stats = Stats::new(&Model::new(Session::default()), ScreenStats::default());
        let object = serde_json::to_value(&stats).unwrap_or_default();
        let mut keys: Vec<_> = object.as_object().into_iter().flatten().map(|(key, _)| key.as_str()).collect();
        keys.sort_unstable();
        assert_eq!(keys, KEYS);
        assert!(object["plots"].is_boolean() && object["source"]["m"] == 0, "{object}");
    }
}

//! The words on the screen that are not beside their control: stages, shapes,
//! patterns, and the field's own terms, each explained once.

use super::language::{tr, tr_count, tr_with};
use super::stats::Processor;
use super::widgets::{grouped, milliseconds};
use crate::conformal::{PrepareTimings, PreparedDomain, PreparedSurface, Side, Stage};
use crate::laplace::SolverKind;
use crate::mesh::FlipReport;
use crate::outline::Preset;
use crate::session::{OutlineSpec, SurfaceShape};
use crate::surface::SurfacePreset;
use std::borrow::Cow;

/// How far a preparation is when `stage` begins (from 0 to 1), and what is being done.
pub fn stage(stage: Option<Stage>) -> (f32, Cow<'static, str>) {
    if let Some(Stage::Table { percent }) = stage {
        return (0.85 + 0.15 * f32::from(percent) / 100.0, tr_with("harmonic coordinates: {0} %", &[&percent]).into());
    }
    let (share, words) = match stage {
        None => (0.03, "waiting for the worker…"),
        Some(Stage::Read) => (0.05, "reading the surface…"),
        Some(Stage::Sample) => (0.1, "sampling the boundary…"),
        Some(Stage::Mesh) => (0.25, "triangulating…"),
        Some(Stage::Assemble) => (0.6, "assembling the Laplacian…"),
        Some(Stage::Order) => (0.7, "ordering…"),
        Some(Stage::Factor | Stage::Table { .. }) => (0.85, "factoring…"),
    };
    (share, tr(words).into())
}

/// Where the Cauchy–Green extension comes from, and how far it is.
pub fn cauchy_green(processor: Processor, progress: f64) -> String {
    match processor {
        Processor::Gpu => String::from(tr("Cauchy–Green: GPU")),
        Processor::Cpu if progress == 1.0 => String::from(tr("Cauchy–Green: CPU")),
        Processor::Cpu => tr_with("Cauchy–Green: CPU {0} %", &[&(100.0 * progress).floor()]),
    }
}

/// "Source", "Target".
pub fn side(side: Side) -> &'static str {
    tr(match side {
        Side::Source => "Source",
        Side::Target => "Target",
    })
}

/// "source", "target" inside of a sentence.
pub fn side_within(side: Side) -> &'static str {
    tr(match side {
        Side::Source => "source",
        Side::Target => "target",
    })
}

/// A preset's name in a menu.
pub fn preset(preset: Preset) -> &'static str {
    tr(given(preset))
}

/// The same as sessions have it.
fn given(preset: Preset) -> &'static str {
    match preset {
        Preset::Disk => "Disk",
        Preset::Square => "Square",
        Preset::Gingerbread => "Gingerbread man",
        Preset::Heart => "Heart",
        Preset::Blob => "Blob",
        Preset::VShape => "V-shape",
        Preset::Cinquefoil => "Cinquefoil",
        Preset::MapleLeaf => "Maple leaf",
        Preset::Hand => "Hand",
        Preset::Turkey => "Turkey",
        Preset::LShape => "L-shape",
        Preset::Star => "Star",
        Preset::Spiral => "Spiral",
    }
}

/// What marks the name of an outline that was reshaped, in a session of any language.
const EDITED: char = '*';

/// What an outline that was drawn is called in a session of any language.
pub const DRAWN: &str = "Drawing";
/// One that was pasted.
pub const PASTED: &str = "Pasted";
/// One that was traced from a picture without a name.
pub const TRACED: &str = "Traced";

/// The name of an outline in a title, which says so if it was reshaped.
pub fn outline(outline: &OutlineSpec) -> Cow<'_, str> {
    let name = own_name(outline);
    name.strip_suffix(EDITED).map_or(said(name).into(), |name| tr_with("{0} (edited)", &[&said(name)]).into())
}

/// A name of a session in the language of the screen, if it is one that riemap gives, or a file's that is the same.
fn said(name: &str) -> &str {
    let mut own = [DRAWN, PASTED, TRACED].into_iter().chain(Preset::ALL.map(given));
    if let Some(own) = own.find(|own| *own == name) { tr(own) } else { name }
}

/// The name that an outline has in a session once it is reshaped: marked, but not twice.
pub fn edited(outline: &OutlineSpec) -> String {
    let name = own_name(outline);
    format!("{}{EDITED}", name.strip_suffix(EDITED).unwrap_or(name))
}

fn own_name(outline: &OutlineSpec) -> &str {
    match outline {
        OutlineSpec::Preset(shape) => given(*shape),
        OutlineSpec::Points { name, .. } => name,
    }
}

/// A built-in surface's name in a menu.
pub fn surface_preset(preset: SurfacePreset) -> &'static str {
    tr(given_surface(preset))
}

fn given_surface(preset: SurfacePreset) -> &'static str {
    match preset {
        SurfacePreset::Hemisphere => "Hemisphere",
        SurfacePreset::Paraboloid => "Paraboloid",
        SurfacePreset::Saddle => "Saddle",
        SurfacePreset::BentStrip => "Bent strip",
        SurfacePreset::HalfTorus => "Half torus",
        SurfacePreset::HeightField => "Face-like",
        SurfacePreset::AnimalHead => "Animal head",
    }
}

/// The name of a surface in a title.
pub fn surface(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => surface_preset(*preset),
        SurfaceShape::File { name } => name,
    }
}

/// The same in a message that is kept, and translated when it is shown.
pub fn surface_in_message(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => given_surface(*preset),
        SurfaceShape::File { name } => name,
    }
}

/// How large a domain is, and how long that took.
pub fn domain_sizes(domain: &PreparedDomain) -> String {
    sizes(domain.samples.len(), domain.mesh.interior_count(), domain.timings.total())
}

/// How large a surface is, and how long that took.
pub fn surface_sizes(surface: &PreparedSurface) -> String {
    let mesh = &surface.surface.mesh;
    sizes(mesh.boundary_count as usize, mesh.interior_count(), surface.timings.total())
}

fn sizes(m: usize, n: usize, ms: f64) -> String {
    tr_with("m {0} · n {1} · prepared in {2}", &[&grouped(m), &grouped(n), &milliseconds(ms)])
}

/// What the intrinsic Delaunay flips have done to a surface, and how long the stages took.
pub fn surface_details(surface: &PreparedSurface) -> String {
    let FlipReport { flips, negative_before, negative_after } = surface.flips;
    let triangles = surface.surface.mesh.triangles.len();
    let sizes = tr_count(
        triangles,
        [
            "m: boundary vertices. n: interior vertices. {0} triangle.",
            "m: boundary vertices. n: interior vertices. {0} triangles.",
        ],
        &[&grouped(triangles)],
    );
    let flips = tr_count(
        flips,
        [
            "Intrinsic Delaunay: {0} edge flipped, negative weights {1} → {2}",
            "Intrinsic Delaunay: {0} edges flipped, negative weights {1} → {2}",
        ],
        &[&grouped(flips), &grouped(negative_before), &grouped(negative_after)],
    );
    format!("{sizes}\n\n{flips}\n\n{}", timings(&surface.timings))
}

/// What should be known about a prepared domain that is not quite what was asked for.
pub fn cautions(domain: &PreparedDomain, wanted: SolverKind) -> impl Iterator<Item = &'static str> {
    let iterative = (domain.solver.kind() != wanted)
        .then_some("The Cholesky factor does not fit into memory: solved iteratively. A coarse map follows your drags; the full one takes a while when you let go");
    let coarse = (!domain.refinement.complete)
        .then_some("The mesh is coarser than asked for: its refinement stopped at the limit");
    iterative.into_iter().chain(coarse).map(tr)
}

/// The preparation's stages with their times, a line each.
pub fn timings(timings: &PrepareTimings) -> String {
    let rows = [
        ("sample", timings.sample),
        ("mesh", timings.mesh),
        ("assemble", timings.assemble),
        ("order", timings.order),
        ("factor", timings.factor),
        ("table", timings.table),
    ];
    rows.iter().map(|(name, ms)| format!("{}: {ms:.1} ms", tr(name))).collect::<Vec<_>>().join("\n")
}

/// Said while the full map is not there.
pub const PENDING: &str = "computing the full map…";
pub const PENDING_TOOLTIP: &str = "This map takes longer than a frame. A coarse one is shown \
    while a dot moves, until the full one is there.";

/// m and n.
pub const SIZE_TOOLTIP: &str = "m: boundary samples. n: interior vertices of the mesh.";
/// Q̄.
pub const QUALITY_TOOLTIP: &str = "Q is the ratio of the two singular values of the map on a triangle: 1 where angles are kept. \
    Q̄ is its area-weighted mean over the mesh; the largest Q is shown here.";
/// Flipped triangles.
pub const FLIPPED_TOOLTIP: &str = "Triangles whose orientation the map reversed. None for a good map; more boundary samples help where there are some.";
/// The frame's time.
pub const FRAME_TOOLTIP: &str = "What the last update of the map took: kernel (harmonic measure: the chance that a random walk \
    from x leaves through a part of the boundary), match (the boundaries' measures are made equal), extend (to the inside), \
    and what drawing took on the processor.";

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> OutlineSpec {
        OutlineSpec::Points { name: name.into(), points: Vec::new() }
    }

    #[test]
    fn a_reshaped_outline_says_so_once_in_the_language_of_the_screen() {
        let once = named(&edited(&OutlineSpec::Preset(Preset::VShape)));
        let twice = named(&edited(&once));
        assert_eq!(once, twice);
        assert_eq!(outline(&twice), "V-shape (edited)");
        assert_eq!(outline(&named("V")), "V");
        crate::app::language::set(crate::app::language::Language::German);
        assert_eq!(outline(&named("V*")), "V (bearbeitet)");
        assert_eq!(outline(&twice), "V-Form (bearbeitet)", "it was named in English");
        assert_eq!(outline(&named(&edited(&OutlineSpec::Preset(Preset::VShape)))), "V-Form (bearbeitet)");
        assert_eq!([DRAWN, "my drawing"].map(|name| outline(&named(name)).into_owned()), ["Zeichnung", "my drawing"]);
    }
}

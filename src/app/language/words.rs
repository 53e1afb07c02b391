//! Texts that several controls share: stages, names of sides and shapes, sizes and
//! times, and the tooltips that explain the field's terms.

use crate::conformal::{MeshedSurface, PrepareTimings, PreparedSide, Side, Stage};
use crate::language::{self, Label, key, number, say, tr};
use crate::mesh::FlipReport;
use crate::model::shape::Shape;
use crate::model::{Processor, names};
use crate::outline::{Interpretation, Interpreted, Preset};
use crate::session::{OutlineSpec, SurfaceShape};
use crate::surface::SurfacePreset;
use std::borrow::Cow;

/// The progress of a preparation when `stage` begins, from 0 to 1, and the stage in words. `None` stands for the wait
/// for the worker.
pub fn stage(stage: Option<Stage>) -> (f32, Cow<'static, str>) {
    if let Some(Stage::Table { percent }) = stage {
        return (0.85 + 0.15 * f32::from(percent) / 100.0, say(&key::harmonic_coordinates(u32::from(percent))).into());
    }
    let (share, words) = match stage {
        None => (0.03, key::waiting_worker()),
        Some(Stage::Read) => (0.05, key::reading()),
        Some(Stage::Sample) => (0.1, key::sampling_boundary()),
        Some(Stage::Mesh) => (0.25, key::triangulating()),
        Some(Stage::Assemble) => (0.6, key::assembling_laplacian()),
        Some(Stage::Order) => (0.7, key::ordering()),
        Some(Stage::Factor | Stage::Integral | Stage::Table { .. }) => (0.85, key::factoring()),
    };
    (share, tr(words).into())
}

/// The processor that evaluates the Cauchy–Green extension, and on the CPU the `progress` from 0 to 1.
pub fn cauchy_green(processor: Processor, progress: f64) -> String {
    match processor {
        Processor::Gpu => String::from(tr(key::cauchy_green_gpu())),
        Processor::Cpu if progress == 1.0 => String::from(tr(key::cauchy_green_cpu())),
        Processor::Cpu => say(&key::cauchy_green_cpu_at((100.0 * progress).floor())),
    }
}

/// "Source", "Target".
pub fn side(side: Side) -> &'static str {
    tr(language::side_heading(side))
}

/// "source", "target" within a sentence.
pub fn side_within(side: Side) -> &'static str {
    tr(side.into())
}

/// What an outline was taken for: "smooth, 2 corners".
pub fn interpreted(Interpreted { interpretation, corners }: Interpreted) -> String {
    let kind = if interpretation == Interpretation::Smooth { key::taken_smooth() } else { key::taken_polygon() };
    say(&key::taken_for(tr(kind), corners))
}

/// A preset's name in a menu.
pub fn preset(preset: Preset) -> &'static str {
    tr(language::preset(preset))
}

/// The name of an outline in a title, marked as edited if it was reshaped.
pub fn outline(outline: &OutlineSpec) -> Cow<'_, str> {
    let name = names::outline(outline);
    name.strip_suffix(names::EDITED).map_or(said(name).into(), |name| say(&key::edited_name(said(name))).into())
}

/// Translates a name that riemap itself gives (presets, drawn, pasted, traced, the rectangle of marks); other names are returned unchanged. A
/// file with such a name is translated too.
fn said(name: &str) -> &str {
    let given = [
        (names::DRAWN, key::drawn()),
        (names::PASTED, key::pasted()),
        (names::TRACED, key::traced()),
        (names::RECTANGLE, key::rectangle()),
    ];
    let presets = Preset::ALL.map(|preset| (names::preset(preset), language::preset(preset)));
    let own = given.into_iter().chain(presets).find(|(own, _)| *own == name);
    own.map_or(name, |(_, label)| tr(label))
}

/// A built-in surface's name in a menu.
pub fn surface_preset(preset: SurfacePreset) -> &'static str {
    tr(language::surface_preset(preset))
}

/// The name of a surface in a title.
pub fn surface(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => surface_preset(*preset),
        SurfaceShape::File { name } => name,
    }
}

/// The name of what stands on a side.
pub fn shape(shape: Shape<'_>) -> Cow<'_, str> {
    match shape {
        Shape::Outline(domain) => outline(&domain.outline),
        Shape::Surface(state) => surface(&state.spec.shape).into(),
    }
}

/// The sizes m and n of sides, and the times of their preparation.
pub fn sizes<'a>(sides: impl IntoIterator<Item = &'a PreparedSide>) -> String {
    let sides: Vec<_> = sides.into_iter().collect();
    let all = |of: &dyn Fn(&PreparedSide) -> String| sides.iter().map(|side| of(side)).collect::<Vec<_>>().join(" | ");
    let (m, n) = (all(&|side| grouped(side.boundary_count())), all(&|side| grouped(side.interior_count())));
    say(&key::sizes(m, n, all(&|side| milliseconds(side.timings().total()))))
}

/// The title of a side: what stands there.
pub fn title(at: Side, standing: Shape<'_>) -> String {
    let kind = match standing {
        Shape::Outline(_) => side(at),
        Shape::Surface(_) => tr(key::surface()),
    };
    format!("{kind} · {}", shape(standing))
}

/// The explanation of [`sizes`], and the times of the stages.
pub fn details(side: &PreparedSide) -> String {
    let about = side.surface().map_or_else(|| tr(SIZE_TOOLTIP).into(), |surface| surface_details(surface));
    format!("{about}\n\n{}", timings(&side.timings()))
}

/// The number of triangles of a surface, and the effect of the intrinsic Delaunay flips.
fn surface_details(surface: &MeshedSurface) -> String {
    let FlipReport { flips, negative_before, negative_after } = surface.flips();
    let triangles = surface.mesh().triangles().len();
    let sizes = say(&key::surface_sizes_about(triangles, grouped(triangles)));
    let flips = say(&key::edges_flipped(flips, grouped(flips), grouped(negative_before), grouped(negative_after)));
    format!("{sizes}\n\n{flips}")
}

/// Notes where a prepared outline differs from the request: solved iteratively, or a coarser mesh.
pub fn cautions(side: &PreparedSide, shape: Shape<'_>) -> impl Iterator<Item = Label> {
    let wanted = if let Shape::Outline(domain) = shape { Some(domain.settings.solver) } else { None };
    let iterative = wanted.is_some_and(|wanted| side.solver_kind() != wanted).then_some(key::solved_iteratively());
    let is_coarse = side.domain().is_some_and(|domain| !domain.refinement().complete);
    iterative.into_iter().chain(is_coarse.then_some(key::mesh_is_coarser()))
}

/// The stages of a preparation with their times, one per line.
pub fn timings(timings: &PrepareTimings) -> String {
    let rows = [
        (key::stage_sample(), timings.sample),
        (key::stage_mesh(), timings.mesh),
        (key::stage_assemble(), timings.assemble),
        (key::stage_order(), timings.order),
        (key::factor(), timings.factor),
        (key::stage_table(), timings.table),
    ];
    rows.iter().map(|(name, ms)| format!("{}: {}\u{a0}ms", tr(*name), number(*ms, 1))).collect::<Vec<_>>().join("\n")
}

/// The status while the full-resolution map is not available.
pub const PENDING: Label = key::pending();
/// The tooltip of [`PENDING`].
pub const PENDING_TOOLTIP: Label = key::pending_tooltip();

/// The tooltip that explains m and n.
pub const SIZE_TOOLTIP: Label = key::size_tooltip();
/// The tooltip that explains Q̄.
pub const QUALITY_TOOLTIP: Label = key::quality_tooltip();
/// The tooltip that explains flipped triangles.
pub const FLIPPED_TOOLTIP: Label = key::flipped_tooltip();
/// The tooltip that explains the time of a frame.
pub const FRAME_TOOLTIP: Label = key::frame_tooltip();

/// A number with thin spaces between groups of three digits.
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

/// A time in ms, with one decimal below 10 ms.
pub fn milliseconds(ms: f64) -> String {
    format!("{}\u{202f}ms", number(ms, usize::from(ms < 9.95)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> OutlineSpec {
        OutlineSpec::points(name.into(), Preset::Square.outline().into_polygon())
    }

    #[test]
    fn a_reshaped_outline_says_so_once_in_the_language_of_the_screen() {
        let once = named(&names::edited(&OutlineSpec::Preset(Preset::VShape)));
        let twice = named(&names::edited(&once));
        assert_eq!(once, twice);
        assert_eq!(outline(&twice), "V-shape (edited)");
        assert_eq!(outline(&named("V")), "V");
        crate::language::set(crate::language::Language::German);
        assert_eq!(outline(&named("V*")), "V (bearbeitet)");
        assert_eq!(outline(&twice), "V-Form (bearbeitet)", "it was named in English");
        assert_eq!(outline(&named(&names::edited(&OutlineSpec::Preset(Preset::VShape)))), "V-Form (bearbeitet)");
        assert_eq!(
            [names::DRAWN, "my drawing"].map(|name| outline(&named(name)).into_owned()),
            ["Zeichnung", "my drawing"]
        );
    }

    #[test]
    fn large_numbers_are_grouped_by_three() {
        assert_eq!(grouped(7), "7");
        assert_eq!(grouped(700), "700");
        assert_eq!(grouped(3912), "3\u{2009}912");
        assert_eq!(grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }

    #[test]
    fn short_times_keep_a_digit_after_the_point() {
        assert_eq!(milliseconds(0.64), "0.6\u{202f}ms");
        assert_eq!(milliseconds(12.4), "12\u{202f}ms");
    }
}

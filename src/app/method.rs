//! The controls of how the map is computed: extension, kernel, solver.
//!
//! Kernel and solver are one choice for both sides. What would not fit is greyed, with the reason.

use super::action::{Action, Actions};
use super::language::{tr, tr_message, tr_with};
use super::model::Model;
use super::surface;
use super::theme::Palette;
use super::widgets::{Segment, group_heading, segmented, segmented_where};
use crate::conformal::{ConformalMap, Extension, HarmonicTable, KernelMode, Memory, PrepareSettings, Side};
use crate::laplace::SolverKind;
use crate::session::Command;
use egui::{RichText, Ui};

const EXTENSIONS: [Segment<Extension>; 2] = [
    Segment {
        value: Extension::Harmonic,
        label: "Harmonic",
        tooltip: "The inside follows the boundary by the discrete Laplace equation: covers the other domain exactly",
    },
    Segment {
        value: Extension::CauchyGreen,
        label: "Cauchy–Green",
        tooltip: "The inside follows by Cauchy's integral of the boundary: smooth, but the boundary may shrink or bulge",
    },
];

const KERNELS: [Segment<KernelMode>; 2] = [
    Segment {
        value: KernelMode::Adjoint,
        label: "Adjoint kernel",
        tooltip: "One solve with the transposed system for each new interior point: no table",
    },
    Segment {
        value: KernelMode::Table,
        label: "Table (paper)",
        tooltip: "The harmonic coordinates of every vertex, computed in advance as in the paper: the same numbers",
    },
];

const SOLVERS: [Segment<SolverKind>; 2] = [
    Segment {
        value: SolverKind::Direct,
        label: "Cholesky",
        tooltip: "A complete sparse Cholesky factor: fast, and accurate even where the measure is 1e-300",
    },
    Segment {
        value: SolverKind::Pcg,
        label: "PCG",
        tooltip: "Conjugate gradients with an incomplete factor: little memory, 15 to 300 times slower; \
            a coarse map stands in while you drag",
    },
];

/// Shows the group.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    group_heading(ui, tr("Method"));
    let planar = model.surface().is_none();
    let extension = if planar { model.session().extension } else { Extension::Harmonic };
    let refused = |extension| {
        let refused = !planar && extension == Extension::CauchyGreen;
        refused
            .then(|| String::from(tr("Cauchy's integral is one over a boundary in the plane; a surface's is in space")))
    };
    if let Some(extension) = segmented_where(ui, &EXTENSIONS, extension, refused) {
        actions.push(Action::Session(Command::SetExtension(extension)));
    }
    let progress = model.map().map_or(1.0, ConformalMap::extension_progress);
    if progress < 1.0 {
        let palette = Palette::of(ui.visuals());
        let text = tr_with("harmonic for now · Cauchy–Green {0} %", &[&(100.0 * progress).round()]);
        ui.label(RichText::new(text).small().color(palette.weak));
    }
    let old = model.side(Side::Source).wanted().settings;
    if let Some(kernel) = segmented_where(ui, &KERNELS, old.kernel, |kernel| refusal(model, kernel)) {
        set(model, actions, |settings| PrepareSettings { kernel, ..settings });
    }
    if let Some(solver) = segmented(ui, &SOLVERS, old.solver) {
        set(model, actions, |settings| PrepareSettings { solver, ..settings });
    }
}

fn set(model: &Model, actions: &mut Actions, change: impl Fn(PrepareSettings) -> PrepareSettings) {
    for side in Side::BOTH {
        let settings = change(model.side(side).wanted().settings);
        actions.push(Action::Session(Command::SetSettings { side, settings }));
    }
    let PrepareSettings { kernel, solver, .. } = change(model.side(Side::Source).wanted().settings);
    actions.extend(surface::panel::with_settings(model, |spec| {
        spec.settings.kernel = kernel;
        spec.settings.solver = solver;
    }));
}

/// Why a kernel cannot be had for the domains as they are.
fn refusal(model: &Model, kernel: KernelMode) -> Option<String> {
    let domains = Side::BOTH.into_iter().filter_map(|side| model.domain(side));
    let planar = domains.map(|domain| (domain.mesh.interior_count(), domain.samples.len()));
    let surface = model.surface().and_then(|(surface, _)| surface.surface()).map(|surface| &surface.surface.mesh);
    planar
        .chain(surface.map(|mesh| (mesh.interior_count(), mesh.boundary_count as usize)))
        .filter(|_| kernel == KernelMode::Table)
        .find_map(|(n, m)| HarmonicTable::check(n, m, Memory::default()).err())
        .map(|error| tr_message(&error.to_string()).into_owned())
}

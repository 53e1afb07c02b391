//! The controls of the method: extension, kernel, solver.
//!
//! Kernel and solver are set for both sides at once. A choice that is not possible is grayed, with the reason.

use super::surface_panel;
use crate::app::input::action::{Action, Actions};
use crate::app::theme::Palette;
use crate::app::theme::widgets::{Segment, group_heading, segmented, segmented_where};
use crate::conformal::{ConformalMap, Extension, HarmonicTable, KernelMode, Memory, PrepareSettings, Side};
use crate::language::{Message, key, say, tr};
use crate::laplace::SolverKind;
use crate::model::Model;
use crate::session::Command;
use egui::{RichText, Ui};

const EXTENSIONS: [Segment<Extension>; 2] = [
    Segment { value: Extension::Harmonic, label: key::harmonic(), tooltip: key::harmonic_tooltip() },
    Segment { value: Extension::CauchyGreen, label: key::cauchy_green(), tooltip: key::cauchy_green_tooltip() },
];

const KERNELS: [Segment<KernelMode>; 2] = [
    Segment { value: KernelMode::Adjoint, label: key::adjoint_kernel(), tooltip: key::adjoint_kernel_tooltip() },
    Segment { value: KernelMode::Table, label: key::table_paper(), tooltip: key::table_paper_tooltip() },
];

const SOLVERS: [Segment<SolverKind>; 2] = [
    Segment { value: SolverKind::Direct, label: key::cholesky(), tooltip: key::cholesky_tooltip() },
    Segment { value: SolverKind::Pcg, label: key::pcg(), tooltip: key::pcg_tooltip() },
];

/// Shows the group.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    group_heading(ui, tr(key::method()));
    let planar = model.is_planar();
    let extension = if planar { model.session().extension() } else { Extension::Harmonic };
    let refused = |extension| {
        let refused = !planar && extension == Extension::CauchyGreen;
        refused.then(|| String::from(tr(key::cauchy_green_needs_plane())))
    };
    if let Some(extension) = segmented_where(ui, &EXTENSIONS, extension, refused) {
        actions.push(Action::Session(Command::SetExtension(extension)));
    }
    let progress = model.map().map_or(1.0, ConformalMap::extension_progress);
    if progress < 1.0 {
        let palette = Palette::of(ui.visuals());
        let text = say(&key::harmonic_for_now((100.0 * progress).round()));
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
    actions.extend(surface_panel::with_settings(model, |spec| {
        spec.settings.kernel = kernel;
        spec.settings.solver = solver;
    }));
}

/// The reason why a kernel is not available for the prepared domains: the table of Ψ does not fit into memory.
fn refusal(model: &Model, kernel: KernelMode) -> Option<String> {
    let outlines = Side::BOTH.into_iter().filter_map(|side| model.side(side).prepared());
    let surfaces = Side::BOTH.into_iter().filter_map(|side| model.surface(side)?.0.prepared());
    outlines
        .chain(surfaces)
        .map(|side| (side.interior_count(), side.boundary_count()))
        .filter(|_| kernel == KernelMode::Table)
        .find_map(|(n, m)| HarmonicTable::check(n, m, Memory::default()).err())
        .map(|error| say(&Message::from(&error)))
}

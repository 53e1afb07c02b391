//! The controls of the method: extension, kernel, solver.
//!
//! Kernel and solver are set for both sides at once. A choice that is not possible is grayed, with the reason.

use crate::app::input::action::{Action, Actions};
use crate::app::theme::Palette;
use crate::app::theme::widgets::{Segment, group_heading, segmented, segmented_where};
use crate::conformal::{ConformalMap, Extension, KernelMode};
use crate::language::{Message, key, say, tr};
use crate::laplace::SolverKind;
use crate::model::{Method, Model};
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
    let abilities = model.abilities();
    let refused = |extension| Some(String::from(tr(abilities.refused_extension(extension)?.label())));
    if let Some(extension) = segmented_where(ui, &EXTENSIONS, model.extension(), refused) {
        actions.push(Action::Session(Command::SetExtension(extension)));
    }
    let progress = model.map().map_or(1.0, ConformalMap::extension_progress);
    if progress < 1.0 {
        let palette = Palette::of(ui.visuals());
        let text = say(&key::harmonic_for_now((100.0 * progress).round()));
        ui.label(RichText::new(text).small().color(palette.weak));
    }
    let old = model.method();
    let refused = |kernel| Some(say(&Message::from(&model.refused_kernel(kernel)?)));
    if let Some(kernel) = segmented_where(ui, &KERNELS, old.kernel, refused) {
        actions.extend(model.set_method(|method| Method { kernel, ..method }).into_iter().map(Action::Session));
    }
    if let Some(solver) = segmented(ui, &SOLVERS, old.solver) {
        actions.extend(model.set_method(|method| Method { solver, ..method }).into_iter().map(Action::Session));
    }
}

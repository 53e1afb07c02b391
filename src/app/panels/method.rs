//! The controls of the method: extension, kernel, solver.
//!
//! Kernel and solver are set for both sides at once. A choice that is not possible is grayed, with the reason.

use crate::app::input::action::{Action, Actions};
use crate::app::language::words;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, segmented, segmented_where};
use crate::conformal::{ConformalMap, Extension, KernelMode, Side};
use crate::language::{Message, key, say, tr};
use crate::laplace::SolverKind;
use crate::model::{Method, Model, SideKernel};
use crate::session::Command;
use egui::{RichText, Ui};

const EXTENSIONS: [Segment<Extension>; 3] = [
    Segment { value: Extension::Harmonic, label: key::harmonic(), tooltip: key::harmonic_tooltip() },
    Segment { value: Extension::CauchyGreen, label: key::cauchy_green(), tooltip: key::cauchy_green_tooltip() },
    Segment { value: Extension::Exact, label: key::exact_images(), tooltip: key::exact_images_tooltip() },
];

const KERNELS: [Segment<KernelMode>; 3] = [
    Segment { value: KernelMode::Integral, label: key::integral_kernel(), tooltip: key::integral_kernel_tooltip() },
    Segment { value: KernelMode::Adjoint, label: key::adjoint_kernel(), tooltip: key::adjoint_kernel_tooltip() },
    Segment { value: KernelMode::Table, label: key::table_paper(), tooltip: key::table_paper_tooltip() },
];

const SOLVERS: [Segment<SolverKind>; 2] = [
    Segment { value: SolverKind::Direct, label: key::cholesky(), tooltip: key::cholesky_tooltip() },
    Segment { value: SolverKind::Pcg, label: key::pcg(), tooltip: key::pcg_tooltip() },
];

/// Shows the three groups.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    explained_heading(ui, tr(key::extension()), key::explain_extension());
    let refused = |extension| Some(String::from(tr(model.refused_extension(extension)?.label())));
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
    explained_heading(ui, tr(key::kernel_heading()), key::explain_kernel());
    let refused = |kernel| Some(say(&Message::from(&model.refused_kernel(kernel)?)));
    if let Some(kernel) = segmented_where(ui, &KERNELS, old.kernel, refused) {
        actions.extend(model.set_method(|method| Method { kernel, ..method }).into_iter().map(Action::Session));
    }
    kernels_in_use(ui, model, old.kernel);
    explained_heading(ui, tr(key::solver()), key::explain_solver());
    if let Some(solver) = segmented(ui, &SOLVERS, old.solver) {
        actions.extend(model.set_method(|method| Method { solver, ..method }).into_iter().map(Action::Session));
    }
}

/// Where the boundary integral was chosen, what each side uses.
fn kernels_in_use(ui: &mut Ui, model: &Model, chosen: KernelMode) {
    if chosen != KernelMode::Integral {
        return;
    }
    let palette = Palette::of(ui.visuals());
    for side in Side::BOTH {
        let title = words::side(side);
        let (text, tooltip) = match model.side_kernel(side) {
            None => continue,
            Some(SideKernel::Integral { unknowns }) => (key::unknowns_of(title, unknowns), None),
            Some(SideKernel::Sharpening) => {
                (key::kernel_of(title, tr(key::sharpening())), Some(String::from(tr(key::sharpening_tooltip()))))
            }
            Some(SideKernel::FiniteElements(_)) => {
                let reason = model.session().surface(side).map(|_| tr(key::surfaces_use_finite_elements()).into());
                (key::kernel_of(title, tr(key::finite_elements())), reason)
            }
            Some(SideKernel::Stays(reason)) => (key::kernel_of(title, tr(key::finite_elements())), Some(say(&reason))),
        };
        let label = ui.label(RichText::new(say(&text)).small().color(palette.weak));
        if let Some(tooltip) = tooltip {
            label.on_hover_text(&tooltip);
            ui.label(RichText::new(tooltip).small().color(palette.weak));
        }
    }
}

//! The menu of the paper's figures and tables, and the same as a window where there is no room for the menu's button.

use super::action::{Action, Actions};
use super::language::{tr, tr_message, tr_with};
use super::reports::Report;
use super::room::{BELOW_BAR, menu_label, scroll_beyond};
use super::theme::Palette;
use super::widgets::chevron;
use crate::figures::{Detail, Figure, Scene};
use crate::session::{Command, Session, SurfaceShape};
use egui::containers::menu::MenuButton;
use egui::{RichText, Role, Ui, WidgetInfo};
use std::sync::LazyLock;

/// The four ways of Figure 8 fit into one row of the menu, the low resolution above the high one.
const SCENES_IN_A_ROW: usize = 4;

/// How wide the list is where there is room.
pub const WIDTH: f32 = 620.0;
/// What of the screen's width is left and right of the menu.
const MARGINS: f32 = 40.0;
/// The button of the tables below it.
const TABLES: f32 = 60.0;

/// The figures with their scenes, made once: each scene is a whole session.
static FIGURES: LazyLock<Vec<(Figure, Vec<Scene>)>> =
    LazyLock::new(|| Figure::ALL.map(|figure| (figure, figure.scenes(Detail::Paper))).into());

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, actions: &mut Actions) {
    let (response, _) = MenuButton::from_button(egui::Button::new(menu_label(tr("Figures")))).ui(ui, |ui| {
        ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - MARGINS));
        list(ui, BELOW_BAR, actions);
    });
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("Figures")));
    chevron(ui, response.rect, false);
}

/// The figures and, below them, the tables; `besides` is what else of the screen's height is taken.
pub fn list(ui: &mut Ui, besides: f32, actions: &mut Actions) {
    scroll_beyond(ui, besides + TABLES, |ui| {
        for (figure, scenes) in FIGURES.iter() {
            entry(ui, *figure, scenes, actions);
        }
    });
    ui.separator();
    let bench = egui::Button::new(tr("Tables 1 and 2 · times on this machine, beside the paper's")).wrap();
    if ui.add(bench).on_hover_text(tr("Takes a minute or two, in the background")).clicked() {
        actions.push(Action::OpenReport(Report::Bench));
        ui.close();
    }
}

fn entry(ui: &mut Ui, figure: Figure, scenes: &[Scene], actions: &mut Actions) {
    let title = tr_with("Figure {0} · {1}", &[&figure.number(), &tr(figure.title())]);
    let tooltip =
        figure.choices().iter().map(|choice| format!("• {}", tr_message(choice))).collect::<Vec<_>>().join("\n");
    if figure == Figure::Convergence {
        if ui.add(egui::Button::new(title).wrap()).on_hover_text(tooltip).clicked() {
            actions.push(Action::OpenReport(Report::Convergence));
            ui.close();
        }
        return;
    }
    ui.label(RichText::new(title).color(Palette::of(ui.visuals()).weak)).on_hover_text(tooltip);
    for row in scenes.chunks(SCENES_IN_A_ROW) {
        ui.horizontal_wrapped(|ui| {
            for scene in row {
                scene_button(ui, figure, scene, actions);
            }
        });
    }
    ui.add_space(4.0);
}

fn scene_button(ui: &mut Ui, figure: Figure, scene: &Scene, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let button =
        egui::Button::new(RichText::new(tr_message(&scene.label)).small().color(palette.text)).fill(palette.control);
    if ui.add(button).on_hover_text(resolution(&scene.session)).clicked() {
        actions.push(Action::Session(Command::Open(Box::new(with_plots(figure, scene.session.clone())))));
        ui.close();
    }
}

/// These figures are plots.
fn with_plots(figure: Figure, session: Session) -> Session {
    Session { plots: matches!(figure, Figure::DiskKernel | Figure::Moebius | Figure::Crowding), ..session }
}

fn resolution(session: &Session) -> String {
    let count = |sampling| match sampling {
        crate::outline::Sampling::Uniform { count, .. } => count.to_string(),
        crate::outline::Sampling::Adaptive { target } => {
            target.map_or_else(|| tr("as needed").into(), |m| m.to_string())
        }
    };
    let [a, b] = [&session.source, &session.target].map(|domain| count(domain.settings.sampling));
    match session.surface.as_ref().map(|surface| &surface.spec.shape) {
        Some(SurfaceShape::Preset { boundary, .. }) => {
            tr_with("{0} samples of the outline, {1} boundary vertices of the surface", &[&a, boundary])
        }
        Some(SurfaceShape::File { name }) => tr_with("{0} samples of the outline; the surface {1}", &[&a, name]),
        None => tr_with("{0} samples of the source, {1} of the target", &[&a, &b]),
    }
}

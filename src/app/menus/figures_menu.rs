//! The list of the paper's figures and tables: a menu of the top bar, or a window where the bar has no room for it.

use crate::app::input::action::{Action, Actions, Report};
use crate::app::theme::Palette;
use crate::app::theme::text_metrics::{BELOW_BAR, scroll_beyond};
use crate::app::theme::widgets::drop_down;
use crate::conformal::Side;
use crate::figures::{Detail, Figure, Scene};
use crate::language::{self, key, say, tr};
use crate::model::shape::Shape;
use crate::session::{Command, Session, SurfaceShape};
use egui::{PopupCloseBehavior, RichText, Stroke, Ui};
use std::sync::LazyLock;

/// Scenes per row: the four variants of Figure 8 fit into one row, the low resolution above the high one. Several rows
/// differ in the resolution, which is shown above each.
const SCENES_IN_A_ROW: usize = 4;

/// The width of the list where there is room, in points.
pub const WIDTH: f32 = 620.0;
/// The free width left and right of the menu together, in points.
const MARGINS: f32 = 40.0;
/// The height of the tables' button below the list, in points.
const TABLES: f32 = 60.0;

/// The figures with their scenes, built once: each scene is a whole session.
static FIGURES: LazyLock<Vec<(Figure, Vec<Scene>)>> =
    LazyLock::new(|| Figure::ALL.map(|figure| (figure, figure.scenes(Detail::Paper))).into());

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, actions: &mut Actions) {
    drop_down(ui, tr(key::figures()), PopupCloseBehavior::CloseOnClick, |ui| {
        ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - MARGINS));
        list(ui, BELOW_BAR, actions);
    });
}

/// Shows the figures and, below them, the tables' button; `besides` is the height in points of everything else on the
/// screen.
pub fn list(ui: &mut Ui, besides: f32, actions: &mut Actions) {
    scroll_beyond(ui, besides + TABLES, |ui| {
        for (figure, scenes) in FIGURES.iter() {
            entry(ui, *figure, scenes, actions);
        }
    });
    ui.separator();
    let bench = egui::Button::new(tr(key::tables_tooltip())).wrap();
    if ui.add(bench).on_hover_text(tr(key::takes_a_minute())).clicked() {
        actions.push(Action::OpenReport(Report::Bench));
        ui.close();
    }
}

fn entry(ui: &mut Ui, figure: Figure, scenes: &[Scene], actions: &mut Actions) {
    let title = say(&key::figure_title(figure.number(), tr(language::title(figure))));
    let tooltip =
        language::choices(figure).iter().map(|choice| format!("• {}", tr(*choice))).collect::<Vec<_>>().join("\n");
    if figure == Figure::Convergence {
        if ui.add(egui::Button::new(title).wrap()).on_hover_text(tooltip).clicked() {
            actions.push(Action::OpenReport(Report::Convergence));
            ui.close();
        }
        return;
    }
    ui.label(RichText::new(title).color(Palette::of(ui.visuals()).weak)).on_hover_text(tooltip);
    let has_rows = scenes.len() > SCENES_IN_A_ROW;
    for row in scenes.chunks(SCENES_IN_A_ROW) {
        if let Some(scene) = row.first().filter(|_| has_rows) {
            ui.label(RichText::new(resolution(&scene.session)).small().color(Palette::of(ui.visuals()).weak));
        }
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
    let button = egui::Button::new(RichText::new(say(&scene.label.into())).small().color(palette.text))
        .fill(palette.control)
        .stroke(Stroke::new(1.0, palette.border));
    if ui.add(button).on_hover_text(resolution(&scene.session)).clicked() {
        actions.push(Action::Session(Command::Open(Box::new(with_plots(figure, scene.session.clone())))));
        ui.close();
    }
}

/// Opens the plots for the figures that are plots, and closes them for the others.
fn with_plots(figure: Figure, session: Session) -> Session {
    let plots = matches!(figure, Figure::DiskKernel | Figure::Moebius | Figure::Crowding);
    session.and([Command::SetPlots(plots)])
}

fn resolution(session: &Session) -> String {
    let count = |sampling| match sampling {
        crate::outline::Sampling::Uniform { count, .. } => count.to_string(),
        crate::outline::Sampling::Adaptive { target } => {
            target.map_or_else(|| tr(key::as_needed()).into(), |m| m.to_string())
        }
    };
    let of_side = |side: Side| match Shape::of(session, side) {
        Shape::Outline(domain) => key::figure_samples_of_outline(count(domain.settings.sampling)),
        Shape::Surface(state) => match &state.spec.shape {
            SurfaceShape::Preset { boundary, .. } => key::figure_boundary_of_surface(*boundary),
            SurfaceShape::File { name } => key::figure_surface_file(name),
        },
    };
    if let [Shape::Outline(source), Shape::Outline(target)] = Side::BOTH.map(|side| Shape::of(session, side)) {
        let [source, target] = [source, target].map(|domain| count(domain.settings.sampling));
        return say(&key::figure_samples(source, target));
    }
    let [source, target] = Side::BOTH.map(of_side);
    say(&key::figure_sides(source, target))
}

//! The controls of a side's surface: its discretization, and the return to the plane.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded, menu_entry};
use crate::app::language::words;
use crate::app::language::words::grouped;
use crate::app::panels::loops_panel;
use crate::app::theme::Palette;
use crate::app::theme::explained::{explained_heading, group_heading};
use crate::app::theme::widgets::captioned_slider;
use crate::conformal::Side;
use crate::language::{Label as Words, key, say, tr};
use crate::model::Model;
use crate::session::{Command, SurfaceShape, SurfaceSpec};
use egui::{Button, Label, RichText, Ui};

/// Boundary vertices of a preset surface: with fewer than 24 a hemisphere is visibly faceted, with 2000 it has a
/// million triangles.
const BOUNDARY: std::ops::RangeInclusive<f64> = 24.0..=2000.0;

const MAP_TOOLTIP: Words = key::surface_map_tooltip();

const DELAUNAY_TOOLTIP: Words = key::delaunay_tooltip();

/// Shows the group of a side's surface; nothing while the side is planar.
pub fn show(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    if model.surface_settings(side).is_none() {
        return;
    }
    group_heading(ui, &heading(side, model));
    if let Some(explained) = model.abilities().direction_of_surface(side) {
        let weak = Palette::of(ui.visuals()).weak;
        ui.add(Label::new(RichText::new(tr(explained)).small().color(weak)).wrap()).on_hover_text(tr(MAP_TOOLTIP));
    }
    loops_panel::show(ui, side, model, actions);
    let back = Action::Session(Command::CloseSurface(side));
    if menu_entry(ui, true, Button::new(tr(key::back_plane())), key::back_plane_tooltip(), &back) {
        actions.push(back);
    }
}

/// The heading of the group; it names the side if both are surfaces.
fn heading(side: Side, model: &Model) -> String {
    let name = tr(key::surface());
    if model.abilities().maps_through_disk() { format!("{name} · {}", words::side(side)) } else { name.into() }
}

/// Shows the group of a surface's discretization; nothing while the side is planar.
pub fn discretization(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let Some(spec) = model.surface_settings(side) else { return };
    explained_heading(ui, &heading(side, model), key::explain_surface());
    guarded(ui, Control::Method, |ui| triangles(ui, side, spec, actions));
}

fn triangles(ui: &mut Ui, side: Side, spec: &SurfaceSpec, actions: &mut Actions) {
    let mut wanted = spec.clone();
    if let SurfaceShape::Preset { boundary, .. } = &mut wanted.shape {
        let shown = say(&key::along_boundary(grouped(*boundary as usize)));
        if let Some(moved) = captioned_slider(ui, tr(key::vertices()), &shown, f64::from(*boundary), BOUNDARY, true) {
            *boundary = moved.round() as u32;
        }
    }
    ui.checkbox(&mut wanted.settings.intrinsic_delaunay, tr(key::intrinsic_delaunay()))
        .on_hover_text(tr(DELAUNAY_TOOLTIP));
    if wanted != *spec {
        actions.push(Action::Session(Command::RefineSurface { side, surface: wanted }));
    }
}

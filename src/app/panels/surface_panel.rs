//! The controls of a surface: its discretization, and the return to the plane.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded, menu_entry};
use crate::app::language::words::grouped;
use crate::app::theme::Palette;
use crate::app::theme::widgets::{captioned_slider, group_heading};
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

/// Shows the group that replaces the map's direction while the target is a surface.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let Some(spec) = model.surface_side(Side::Target).preparation.wanted() else { return };
    let weak = Palette::of(ui.visuals()).weak;
    group_heading(ui, tr(key::surface()));
    let words = key::surface_direction();
    ui.add(Label::new(RichText::new(tr(words)).small().color(weak)).wrap()).on_hover_text(tr(MAP_TOOLTIP));
    guarded(ui, Control::Method, |ui| discretisation(ui, spec, actions));
    let back = Action::Session(Command::CloseSurface(Side::Target));
    if menu_entry(ui, true, Button::new(tr(key::back_plane())), key::back_plane_tooltip(), &back) {
        actions.push(back);
    }
}

fn discretisation(ui: &mut Ui, spec: &SurfaceSpec, actions: &mut Actions) {
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
        actions.push(Action::Session(Command::RefineSurface { side: Side::Target, surface: wanted }));
    }
}

/// The action that changes the settings of the requested surface; `None` if the target is not a surface.
pub fn with_settings(model: &Model, change: impl Fn(&mut SurfaceSpec)) -> Option<Action> {
    let mut spec = model
        .surface_side(Side::Target)
        .preparation
        .wanted()
        .filter(|_| model.surface(Side::Target).is_some())?
        .clone();
    change(&mut spec);
    Some(Action::Session(Command::RefineSurface { side: Side::Target, surface: spec }))
}

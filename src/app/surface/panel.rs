//! The surface's controls: how it is discretised, and the way back to the plane.

use crate::app::action::{Action, Actions};
use crate::app::language::{tr, tr_with};
use crate::app::locks::{Control, guarded, menu_entry};
use crate::app::model::Model;
use crate::app::theme::Palette;
use crate::app::widgets::{captioned_slider, group_heading, grouped};
use crate::session::{Command, SurfaceShape, SurfaceSpec};
use egui::{Button, Label, RichText, Ui};

/// Boundary vertices of a surface by formula: fewer than 24 make a hemisphere a gem, 2000 make it a million triangles.
const BOUNDARY: std::ops::RangeInclusive<f64> = 24.0..=2000.0;

const MAP_TOOLTIP: &str = "The surface is the target. Its Laplacian comes from the lengths of its edges; harmonic measure on \
    its boundary loop is matched with the outline's, and every vertex gets its place in the outline: its texture coordinate";

const DELAUNAY_TOOLTIP: &str = "Edges are flipped within the surface until all cotangent weights are positive: then harmonic \
    measure is too, and the boundary keeps its order. The surface itself stays as it is";

/// Shows what takes the place of the map's direction while a surface is shown.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let Some(spec) = model.surface_side().preparation.wanted() else { return };
    let weak = Palette::of(ui.visuals()).weak;
    group_heading(ui, tr("Surface"));
    let words = "Every point of the surface is mapped to the outline on the left";
    ui.add(Label::new(RichText::new(tr(words)).small().color(weak)).wrap()).on_hover_text(tr(MAP_TOOLTIP));
    guarded(ui, Control::Method, |ui| discretisation(ui, spec, actions));
    let back = Action::Session(Command::CloseSurface);
    if menu_entry(ui, true, Button::new(tr("Back to the plane")), "Show the target's outline again", &back) {
        actions.push(back);
    }
}

fn discretisation(ui: &mut Ui, spec: &SurfaceSpec, actions: &mut Actions) {
    let mut wanted = spec.clone();
    if let SurfaceShape::Preset { boundary, .. } = &mut wanted.shape {
        let shown = tr_with("{0} along the boundary", &[&grouped(*boundary as usize)]);
        if let Some(moved) = captioned_slider(ui, tr("Vertices"), &shown, f64::from(*boundary), BOUNDARY, true) {
            *boundary = moved.round() as u32;
        }
    }
    ui.checkbox(&mut wanted.settings.intrinsic_delaunay, tr("Intrinsic Delaunay")).on_hover_text(tr(DELAUNAY_TOOLTIP));
    if wanted != *spec {
        actions.push(Action::Session(Command::RefineSurface(wanted)));
    }
}

/// The wanted surface with other settings.
pub fn with_settings(model: &Model, change: impl Fn(&mut SurfaceSpec)) -> Option<Action> {
    let mut spec = model.surface_side().preparation.wanted().filter(|_| model.surface().is_some())?.clone();
    change(&mut spec);
    Some(Action::Session(Command::RefineSurface(spec)))
}

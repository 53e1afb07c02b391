//! The column of controls: surface, pattern, coloring, play, plots; below them, folded, whatever names a method.
//!
//! The controls show the *requested* settings, not those of the map on the screen; a click becomes an [`Action`].

use super::surface_panel;
use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded, guarded_by};
use crate::app::overlays;
use crate::app::panels::{advanced, best_panel, picture_panel, pins_panel, play_panel, tiling_panel};
use crate::app::theme::Palette;
use crate::app::theme::explained::{explained_heading, group_heading};
use crate::app::theme::widgets::{Segment, captioned_slider, segmented};
use crate::conformal::Side;
use crate::language::{key, tr};
use crate::model::Model;
use crate::model::motion::Player;
use crate::session::{CELLS, Colouring, Command, TextureKind, Touched};
use egui::{RichText, Ui};

const COLOURINGS: [Segment<Colouring>; 3] = [
    Segment { value: Colouring::Texture, label: key::texture(), tooltip: key::texture_tooltip() },
    Segment { value: Colouring::Angle, label: key::angle(), tooltip: key::angle_tooltip() },
    Segment { value: Colouring::Area, label: key::area(), tooltip: key::area_tooltip() },
];

const TEXTURES: [Segment<TextureKind>; 5] = [
    Segment { value: TextureKind::Checker, label: key::checker(), tooltip: key::checker_tooltip() },
    Segment { value: TextureKind::Grid, label: key::grid(), tooltip: key::lines() },
    Segment { value: TextureKind::Conformal, label: key::polar(), tooltip: key::polar_tooltip() },
    Segment { value: TextureKind::Tiling, label: key::tiling(), tooltip: key::tiling_tooltip() },
    Segment { value: TextureKind::Image, label: key::image(), tooltip: key::image_tooltip() },
];

/// What the column needs to know besides the model.
#[derive(Debug, Clone, Copy)]
pub struct Column<'a> {
    /// The file name of the texture's image.
    pub image_name: Option<&'a str>,
    /// Whether the advanced controls are unfolded.
    pub advanced: bool,
    /// Whether the texture coordinates of a surface's layout are shown.
    pub uv: bool,
    /// Whether the plots have a place of their own beside the column: a tab of a phone's sheet.
    pub in_sheet: bool,
}

/// Shows all groups.
pub fn show(ui: &mut Ui, model: &Model, player: &Player, column: Column<'_>, actions: &mut Actions) {
    for side in Side::BOTH {
        ui.push_id(("surface", side), |ui| surface_panel::show(ui, side, model, actions));
    }
    guarded(ui, Control::Pattern, |ui| texture(ui, model, column.image_name, actions));
    guarded(ui, Control::Colours, |ui| shown(ui, model, actions));
    guarded_by(ui, Touched::POINTS, |ui| pins_panel::show(ui, model, actions));
    guarded_by(ui, Touched::POINTS, |ui| best_panel::show(ui, model, actions));
    if model.abilities().has_layout() {
        layout(ui, column.uv, actions);
    }
    guarded_by(ui, Touched::POINTS, |ui| play_panel::show(ui, model, player, actions));
    if !column.in_sheet {
        guarded(ui, Control::Plots, |ui| plots(ui, model, actions));
    }
    advanced::show(ui, model, column.advanced, actions);
}

fn plots(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    explained_heading(ui, tr(key::plots()), key::explain_plots());
    let mut open = model.session().plots();
    if ui.checkbox(&mut open, tr(key::show())).on_hover_text(tr(key::plots_tooltip())).changed() {
        actions.push(Action::Session(Command::SetPlots(open)));
    }
}

fn shown(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr(key::coloring()));
    if let Some(colouring) = segmented(ui, &COLOURINGS, session.colouring()) {
        actions.push(Action::Session(Command::SetColouring(colouring)));
    }
    let mut wireframe = session.wireframe();
    let mesh = ui.checkbox(&mut wireframe, tr(key::mesh()));
    if mesh.on_hover_text(tr(key::mesh_tooltip())).changed() {
        actions.push(Action::Session(Command::SetWireframe(wireframe)));
    }
}

/// The texture coordinates of a surface over an outline; that changes no session.
fn layout(ui: &mut Ui, mut uv: bool, actions: &mut Actions) {
    explained_heading(ui, tr(key::uv_layout()), key::explain_uv());
    if ui.checkbox(&mut uv, tr(key::uv_grid())).on_hover_text(tr(key::explain_uv())).changed() {
        actions.push(Action::ShowUv(uv));
    }
}

fn texture(ui: &mut Ui, model: &Model, image_name: Option<&str>, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr(key::pattern()));
    match segmented(ui, &TEXTURES, overlays::panel::family(session.texture())) {
        // Without an image there is no texture to show: open the dialog first.
        Some(TextureKind::Image) if image_name.is_none() => actions.push(Action::OpenImage),
        Some(texture) => actions.push(Action::Session(Command::SetTexture(texture))),
        None => {}
    }
    match session.texture() {
        TextureKind::Image => own_picture(ui, model, image_name, actions),
        TextureKind::Tiling => tiling_panel::show(ui, model, image_name, actions),
        _ => {
            let shown = overlays::panel::scale(session);
            if let Some(scale) = captioned_slider(ui, tr(key::scale()), &shown, session.texture_scale(), CELLS, true) {
                actions.push(Action::Session(Command::SetTextureScale(scale.round())));
            }
        }
    }
    overlays::panel::pattern(ui, model, actions);
}

/// The choice of the own picture, and its place.
pub fn own_picture(ui: &mut Ui, model: &Model, image_name: Option<&str>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        let palette = Palette::of(ui.visuals());
        if ui.button(tr(key::choose())).clicked() {
            actions.push(Action::OpenImage);
        }
        ui.add(egui::Label::new(RichText::new(image_name.unwrap_or_default()).color(palette.weak)).truncate());
    });
    if image_name.is_some() {
        picture_panel::show(ui, model, actions);
    }
}

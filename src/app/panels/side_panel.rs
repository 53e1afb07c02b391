//! The column of controls: direction, coloring, texture, motion, method, overlays, resolution and invariants of both
//! sides.
//!
//! The controls show the *requested* settings, not those of the map on the screen; a click becomes an [`Action`].

use super::surface_panel;
use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded, guarded_by};
use crate::app::language::words;
use crate::app::overlays;
use crate::app::panels::{interpretation, invariants_panel, method, picture_panel, play_panel};
use crate::app::theme::Palette;
use crate::app::theme::widgets::{Segment, captioned_slider, group_heading, segmented};
use crate::conformal::{Direction, PrepareSettings, Side};
use crate::language::{key, say, tr};
use crate::mesh::Sizing;
use crate::model::Model;
use crate::model::motion::Player;
use crate::outline::Sampling;
use crate::session::{CELLS, Colouring, Command, GROWTH, SAMPLES, TextureKind, Touched};
use egui::{RichText, Ui};

const DIRECTIONS: [Segment<Direction>; 2] = [
    Segment { value: Direction::Forward, label: key::forward(), tooltip: key::forward_tooltip() },
    Segment { value: Direction::Backward, label: key::backward(), tooltip: key::backward_tooltip() },
];

const COLOURINGS: [Segment<Colouring>; 3] = [
    Segment { value: Colouring::Texture, label: key::texture(), tooltip: key::texture_tooltip() },
    Segment { value: Colouring::Angle, label: key::angle(), tooltip: key::angle_tooltip() },
    Segment { value: Colouring::Area, label: key::area(), tooltip: key::area_tooltip() },
];

const TEXTURES: [Segment<TextureKind>; 4] = [
    Segment { value: TextureKind::Checker, label: key::checker(), tooltip: key::checker_tooltip() },
    Segment { value: TextureKind::Grid, label: key::grid(), tooltip: key::lines() },
    Segment { value: TextureKind::Conformal, label: key::polar(), tooltip: key::polar_tooltip() },
    Segment { value: TextureKind::Image, label: key::image(), tooltip: key::image_tooltip() },
];

/// Shows all groups.
pub fn show(ui: &mut Ui, model: &Model, player: &Player, image_name: Option<&str>, actions: &mut Actions) {
    if model.abilities().chooses_direction() {
        group_heading(ui, tr(key::map()));
        let direction = guarded(ui, Control::Method, |ui| segmented(ui, &DIRECTIONS, model.session().direction()));
        actions.extend(direction.map(|direction| Action::Session(Command::SetDirection(direction))));
    }
    for side in Side::BOTH {
        ui.push_id(("surface", side), |ui| surface_panel::show(ui, side, model, actions));
    }
    guarded(ui, Control::Colours, |ui| shown(ui, model, actions));
    guarded(ui, Control::Pattern, |ui| texture(ui, model, image_name, actions));
    guarded_by(ui, Touched::POINTS, |ui| play_panel::show(ui, model, player, actions));
    guarded(ui, Control::Method, |ui| method::show(ui, model, actions));
    guarded(ui, Control::Comparison, |ui| overlays::panel::show(ui, model, actions));
    for side in Side::BOTH {
        if let Some(settings) = model.outline_settings(side) {
            ui.push_id(side, |ui| {
                guarded(ui, Control::Outline, |ui| interpretation::show(ui, side, model, actions));
                guarded(ui, Control::Method, |ui| resolution(ui, side, settings, model, actions));
            });
        }
    }
    for side in Side::BOTH.into_iter().filter(|side| model.abilities().has_outline(*side)) {
        ui.push_id(("invariants", side), |ui| {
            guarded(ui, Control::Comparison, |ui| invariants_panel::show(ui, side, model, actions));
        });
    }
}

fn shown(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr(key::show()));
    if let Some(colouring) = segmented(ui, &COLOURINGS, session.colouring()) {
        actions.push(Action::Session(Command::SetColouring(colouring)));
    }
    let mut wireframe = session.wireframe();
    let mesh = ui.checkbox(&mut wireframe, tr(key::mesh()));
    if mesh.on_hover_text(tr(key::mesh_tooltip())).changed() {
        actions.push(Action::Session(Command::SetWireframe(wireframe)));
    }
}

fn texture(ui: &mut Ui, model: &Model, image_name: Option<&str>, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr(key::texture()));
    match segmented(ui, &TEXTURES, overlays::panel::family(session.texture())) {
        // Without an image there is no texture to show: open the dialog first.
        Some(TextureKind::Image) if image_name.is_none() => actions.push(Action::OpenImage),
        Some(texture) => actions.push(Action::Session(Command::SetTexture(texture))),
        None => {}
    }
    if session.texture() == TextureKind::Image {
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
    } else {
        let shown = overlays::panel::scale(session);
        if let Some(scale) = captioned_slider(ui, tr(key::scale()), &shown, session.texture_scale(), CELLS, true) {
            actions.push(Action::Session(Command::SetTextureScale(scale.round())));
        }
    }
    overlays::panel::pattern(ui, model, actions);
}

fn resolution(ui: &mut Ui, side: Side, old: PrepareSettings, model: &Model, actions: &mut Actions) {
    let there = model.domain(side).map_or(500, |domain| domain.samples().len());
    group_heading(ui, &say(&key::resolution_of(words::side(side))));
    let sampling = sampling(ui, old.sampling, there);
    let sizing = sizing(ui, old.sizing);
    let settings = PrepareSettings { sampling, sizing, ..old };
    if settings != old {
        actions.push(Action::Session(Command::SetSettings { side, settings }));
    }
}

fn sampling(ui: &mut Ui, old: Sampling, there: usize) -> Sampling {
    let (uniform, asked) = match old {
        Sampling::Uniform { count, .. } => (true, Some(count)),
        Sampling::Adaptive { target } => (false, target),
    };
    let mut new = old;
    let kinds = [
        Segment { value: false, label: key::adaptive(), tooltip: key::adaptive_tooltip() },
        Segment { value: true, label: key::uniform_paper(), tooltip: key::uniform_paper_tooltip() },
    ];
    let count = asked.unwrap_or(there as u32).clamp(*SAMPLES.start(), *SAMPLES.end());
    if let Some(to_uniform) = segmented(ui, &kinds, uniform) {
        new = if to_uniform {
            Sampling::Uniform { count, keep_corners: true }
        } else {
            Sampling::Adaptive { target: Some(count) }
        };
    }
    let range = f64::from(*SAMPLES.start())..=f64::from(*SAMPLES.end());
    let shown = if asked.is_some() { count.to_string() } else { say(&key::automatic(there)) };
    let moved =
        captioned_slider(ui, tr(key::samples()), &shown, f64::from(count), range, true).map(|m| m.round() as u32);
    match (&mut new, moved) {
        (Sampling::Uniform { count, .. }, Some(m)) => *count = m,
        (Sampling::Adaptive { target }, Some(m)) => *target = Some(m),
        _ => {}
    }
    match &mut new {
        Sampling::Uniform { keep_corners, .. } => {
            ui.checkbox(keep_corners, tr(key::keep_corners())).on_hover_text(tr(key::keep_corners_tooltip()));
        }
        Sampling::Adaptive { target } => {
            let mut automatic = target.is_none();
            let label = ui.checkbox(&mut automatic, tr(key::as_many_as_needed()));
            if label.on_hover_text(tr(key::adaptive_samples_tooltip())).changed() {
                *target = (!automatic).then_some(count);
            }
        }
    }
    new
}

fn sizing(ui: &mut Ui, old: Sizing) -> Sizing {
    let grade = match old {
        Sizing::Graded(grade) => Some(grade),
        Sizing::Uniform => None,
    };
    let kinds = [
        Segment { value: true, label: key::graded(), tooltip: key::graded_tooltip() },
        Segment { value: false, label: key::uniform_mesh(), tooltip: key::uniform_mesh_tooltip() },
    ];
    let mut new = old;
    if let Some(graded) = segmented(ui, &kinds, grade.is_some()) {
        new = if graded { Sizing::default() } else { Sizing::Uniform };
    }
    if let Sizing::Graded(grade) = new {
        let shown = say(&key::per_distance(format!("{grade:.2}")));
        if let Some(moved) = captioned_slider(ui, tr(key::growth()), &shown, grade, GROWTH, false) {
            new = Sizing::Graded((100.0 * moved).round() / 100.0);
        }
    }
    new
}

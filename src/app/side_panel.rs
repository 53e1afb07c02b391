//! The controls: direction of the map, what is shown, texture, resolution of both sides.
//!
//! Everything shown is what is *wanted*; a click becomes an [`Action`].

use super::action::{Action, Actions};
use super::language::{tr, tr_with};
use super::locks::{Control, Locks, guarded};
use super::method;
use super::model::Model;
use super::play_panel;
use super::playing::Player;
use super::theme::Palette;
use super::widgets::{Segment, captioned_slider, group_heading, segmented};
use super::{surface, teaching, words};
use crate::conformal::{Direction, PrepareSettings, Side};
use crate::mesh::Sizing;
use crate::outline::Sampling;
use crate::session::{CELLS, Colouring, Command, GROWTH, SAMPLES, TextureKind};
use egui::{RichText, Ui};

const DIRECTIONS: [Segment<Direction>; 2] = [
    Segment { value: Direction::Forward, label: "Forward", tooltip: "The source's mesh is mapped into the target" },
    Segment {
        value: Direction::Backward,
        label: "Backward",
        tooltip: "The target's mesh is mapped into the source and looks its texture up there",
    },
];

const COLOURINGS: [Segment<Colouring>; 3] = [
    Segment { value: Colouring::Texture, label: "Texture", tooltip: "The pattern that the map carries" },
    Segment {
        value: Colouring::Angle,
        label: "Angle",
        tooltip: "Angle distortion Q = σ₁/σ₂ of every triangle: 1 where angles are kept",
    },
    Segment {
        value: Colouring::Area,
        label: "Area",
        tooltip: "Area distortion log₂(σ₁σ₂) of every triangle, from source to target: +1 is twice the area, −1 half of it",
    },
];

const TEXTURES: [Segment<TextureKind>; 4] = [
    Segment { value: TextureKind::Checker, label: "Checker", tooltip: "Squares; angles of 90° stay angles of 90°" },
    Segment { value: TextureKind::Grid, label: "Grid", tooltip: "Lines" },
    Segment { value: TextureKind::Conformal, label: "Polar", tooltip: "Circles and rays about the interior point" },
    Segment { value: TextureKind::Image, label: "Image", tooltip: "Your own PNG or JPEG; drop one anywhere" },
];

/// Shows all groups.
pub fn show(ui: &mut Ui, model: &Model, player: &Player, image_name: Option<&str>, actions: &mut Actions) {
    let planar = model.surface().is_none();
    if planar {
        group_heading(ui, tr("Map"));
        let direction = guarded(ui, Control::Method, |ui| segmented(ui, &DIRECTIONS, model.session().direction));
        actions.extend(direction.map(|direction| Action::Session(Command::SetDirection(direction))));
    } else {
        surface::panel::show(ui, model, actions);
    }
    guarded(ui, Control::Colours, |ui| shown(ui, model, actions));
    guarded(ui, Control::Pattern, |ui| texture(ui, model, image_name, actions));
    let held = if Locks::of(ui.ctx()).holds(Control::Boundary) { Control::Boundary } else { Control::Interior };
    guarded(ui, held, |ui| play_panel::show(ui, model, player, actions));
    guarded(ui, Control::Method, |ui| method::show(ui, model, actions));
    guarded(ui, Control::Comparison, |ui| teaching::panel::show(ui, model, actions));
    for side in Side::BOTH.into_iter().filter(|side| planar || *side == Side::Source) {
        ui.push_id(side, |ui| guarded(ui, Control::Method, |ui| resolution(ui, side, model, actions)));
    }
}

fn shown(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr("Show"));
    if let Some(colouring) = segmented(ui, &COLOURINGS, session.colouring) {
        actions.push(Action::Session(Command::SetColouring(colouring)));
    }
    let mut wireframe = session.wireframe;
    let mesh = ui.checkbox(&mut wireframe, tr("Mesh"));
    if mesh.on_hover_text(tr("The edges of the mapped mesh, and of its image on the other side")).changed() {
        actions.push(Action::Session(Command::SetWireframe(wireframe)));
    }
}

fn texture(ui: &mut Ui, model: &Model, image_name: Option<&str>, actions: &mut Actions) {
    let session = model.session();
    group_heading(ui, tr("Texture"));
    match segmented(ui, &TEXTURES, teaching::panel::family(session.texture)) {
        // Without an image there is nothing to show: the dialog first.
        Some(TextureKind::Image) if image_name.is_none() => actions.push(Action::OpenImage),
        Some(texture) => actions.push(Action::Session(Command::SetTexture(texture))),
        None => {}
    }
    if session.texture == TextureKind::Image {
        ui.horizontal(|ui| {
            let palette = Palette::of(ui.visuals());
            if ui.button(tr("Choose…")).clicked() {
                actions.push(Action::OpenImage);
            }
            ui.add(egui::Label::new(RichText::new(image_name.unwrap_or_default()).color(palette.weak)).truncate());
        });
    } else {
        let shown = teaching::panel::scale(session);
        if let Some(scale) = captioned_slider(ui, tr("Scale"), &shown, session.texture_scale, CELLS, true) {
            actions.push(Action::Session(Command::SetTextureScale(scale.round())));
        }
    }
    teaching::panel::pattern(ui, model, actions);
}

fn resolution(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let old = model.side(side).wanted().settings;
    let there = model.domain(side).map_or(500, |domain| domain.samples.len());
    group_heading(ui, &tr_with("Resolution · {0}", &[&words::side(side)]));
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
        Segment {
            value: false,
            label: "Adaptive",
            tooltip: "Denser at corners, high curvature and in narrow channels: a smaller error for the same number",
        },
        Segment { value: true, label: "Uniform (paper)", tooltip: "Equally spaced in arc length, as in the paper" },
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
    let shown = if asked.is_some() { count.to_string() } else { tr_with("{0}, automatic", &[&there]) };
    let moved = captioned_slider(ui, tr("Samples"), &shown, f64::from(count), range, true).map(|m| m.round() as u32);
    match (&mut new, moved) {
        (Sampling::Uniform { count, .. }, Some(m)) => *count = m,
        (Sampling::Adaptive { target }, Some(m)) => *target = Some(m),
        _ => {}
    }
    match &mut new {
        Sampling::Uniform { keep_corners, .. } => {
            ui.checkbox(keep_corners, tr("Keep corners")).on_hover_text(tr("The outline's corners are samples too"));
        }
        Sampling::Adaptive { target } => {
            let mut automatic = target.is_none();
            let label = ui.checkbox(&mut automatic, tr("As many as the outline needs"));
            if label.on_hover_text(tr("Spacing from curvature, corners and channel width alone")).changed() {
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
        Segment {
            value: true,
            label: "Graded",
            tooltip: "Triangles grow with the distance from the boundary: 4–15 % of the vertices at nearly the same error",
        },
        Segment { value: false, label: "Uniform mesh", tooltip: "Triangles of one size, as in the paper" },
    ];
    let mut new = old;
    if let Some(graded) = segmented(ui, &kinds, grade.is_some()) {
        new = if graded { Sizing::default() } else { Sizing::Uniform };
    }
    if let Sizing::Graded(grade) = new {
        let shown = tr_with("{0} per distance", &[&format_args!("{grade:.2}")]);
        if let Some(moved) = captioned_slider(ui, tr("Growth"), &shown, grade, GROWTH, false) {
            new = Sizing::Graded((100.0 * moved).round() / 100.0);
        }
    }
    new
}

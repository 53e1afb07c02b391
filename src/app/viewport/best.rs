//! The best map in the pictures: the brush that paints the region of the source, and the landscape over x₁.
//!
//! While the brush is taken up, a drag over the source paints; while the landscape is shown, a click or a drag moves x₁
//! there. Scrolling and two fingers move the picture as always, and dots stay above both.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::{GRAB_RADIUS, HandleKind};
use crate::app::input::locks::{Control, Locks};
use crate::app::theme::Palette;
use crate::app::viewport::dots::paint_words_beside;
use crate::app::viewport::planar;
use crate::app::viewport::view::View;
use crate::conformal::{MeshedDomain, Side};
use crate::geometry::{DVec2, DVec3};
use crate::language::{key, say, significant};
use crate::model::Model;
use crate::model::best::Aim;
use crate::render::ColourMap;
use crate::session::Command;
use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{Color32, CursorIcon, PointerButton, Pos2, Rect, Response, Shape, Stroke, Ui, Vec2};

/// How much of the picture the landscape and the region let through.
const LANDSCAPE_OPACITY: f32 = 0.82;
const REGION_OPACITY: f32 = 0.45;
/// The colors of a landscape's ranks: dark where the criterion is least.
pub const LANDSCAPE_COLORS: ColourMap = ColourMap::Cividis;

/// The distance between dabs of a stroke that a fast pointer leaves, in points.
const STROKE_STEP: f32 = 4.0;

/// Whether a drag over this side paints.
pub fn paints(ui: &Ui, side: Side, model: &Model) -> bool {
    side == Side::Source && model.best().is_painting() && !Locks::of(ui.ctx()).holds(Control::Comparison)
}

/// Adds dabs where the pointer is pressed; `place` gives the place of the source under it. Returns whether it paints, so
/// that a drag means nothing else.
pub fn paint_region(
    ui: &Ui,
    (response, side): (&Response, Side),
    model: &Model,
    is_held: bool,
    place: impl Fn(Pos2) -> Option<DVec3>,
    actions: &mut Actions,
) -> bool {
    if !paints(ui, side, model) || is_held {
        return false;
    }
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    let is_down = response.is_pointer_button_down_on() && ui.input(|input| input.pointer.primary_down());
    let pointer = response.interact_pointer_pos().filter(|_| is_down);
    let region = pointer.and_then(|pointer| {
        // a fast stroke has no gaps
        let way = if response.dragged() { response.drag_delta() } else { Vec2::ZERO };
        let steps = (way.length() / STROKE_STEP).ceil().max(1.0) as u32;
        let places = (0..steps).map(|k| pointer - way * (k as f32 / steps as f32));
        model.region_with(places.filter_map(place))
    });
    actions.extend(region.map(|region| Action::Session(Command::SetRegion(region))));
    true
}

/// Moves x₁ to the pointer over the landscape; returns whether it does, so that a drag means nothing else.
pub fn follow_landscape(
    ui: &Ui,
    (response, side): (&Response, Side),
    (model, view): (&Model, &View),
    is_held: bool,
    actions: &mut Actions,
) -> bool {
    let is_shown = side == Side::Source && model.best().landscape().is_some() && model.pins().is_none();
    let is_locked = Locks::of(ui.ctx()).holds_handle(HandleKind::Interior);
    if !is_shown || is_locked || is_held || paints(ui, side, model) {
        return false;
    }
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    let is_pressed = response.dragged_by(PointerButton::Primary) || response.clicked();
    let pointer = response.interact_pointer_pos().filter(|_| is_pressed);
    let point = pointer.and_then(|pointer| model.interior_near(side, view.to_world(pointer)));
    actions.extend(point.map(|point| Action::Session(Command::MoveInterior { side, point: point.into() })));
    true
}

/// Draws landscape and region over a planar picture.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &View) {
    if side != Side::Source {
        return;
    }
    paint_landscape(ui, model, view);
    if model.best().aim() == Aim::Region
        && let Some(domain) = model.domain(side)
    {
        let corners = |t: usize| domain.mesh().triangles()[t].map(|v| domain.mesh().vertices()[v as usize]);
        let on_screen = |t: usize| Some(corners(t).map(|x| view.to_screen(x)));
        paint_triangles(ui, view.rect, model, domain.mesh().triangles().len(), on_screen);
        paint_brush(ui, model, view);
    }
}

/// The parts of triangles in the region, in one color; `on_screen` places a triangle.
pub fn paint_triangles(
    ui: &Ui,
    rect: Rect,
    model: &Model,
    count: usize,
    on_screen: impl Fn(usize) -> Option<[Pos2; 3]>,
) {
    let color = region_ink(ui);
    let mut mesh = Mesh::default();
    for part in model.best().painted(count) {
        let Some([a, b, c]) = on_screen(part.triangle) else { continue };
        let place = |weights: DVec3| {
            let [wa, wb, wc] = weights.as_vec3().to_array();
            Pos2::ZERO + wa * a.to_vec2() + wb * b.to_vec2() + wc * c.to_vec2()
        };
        let first = mesh.vertices.len() as u32;
        mesh.vertices.extend(part.corners.map(|corner| Vertex { pos: place(corner), uv: WHITE_UV, color }));
        mesh.indices.extend([first, first + 1, first + 2]);
    }
    ui.painter_at(rect).add(Shape::mesh(mesh));
}

/// The color of the region.
pub fn region_ink(ui: &Ui) -> Color32 {
    Palette::of(ui.visuals()).accent.gamma_multiply(REGION_OPACITY)
}

/// Whether a region is seen over the source.
pub fn shows_region(model: &Model) -> bool {
    model.best().aim() == Aim::Region && !model.session().region().is_empty()
}

/// The brush's circle under the pointer.
fn paint_brush(ui: &Ui, model: &Model, view: &View) {
    let Some((pointer, radius)) = ui.input(|input| input.pointer.hover_pos()).zip(model.brush_radius()) else { return };
    if paints(ui, Side::Source, model) && view.rect.contains(pointer) {
        let edge = view.to_screen(view.to_world(pointer) + DVec2::new(radius, 0.0));
        let painter = ui.painter_at(view.rect);
        for (width, ink) in [(3.0, Color32::from_black_alpha(120)), (1.5, Color32::WHITE)] {
            painter.circle_stroke(pointer, edge.distance(pointer), Stroke::new(width, ink));
        }
    }
}

fn paint_landscape(ui: &Ui, model: &Model, view: &View) {
    let Some(landscape) = model.best().landscape() else { return };
    let painter = ui.painter_at(view.rect);
    painter.add(Shape::mesh(colored(landscape.domain(), landscape.ranks(), view)));
    for level in landscape.levels() {
        for [from, to] in &level.line {
            let ends = [*from, *to].map(|x| view.to_screen(x));
            painter.line_segment(ends, Stroke::new(1.0, Color32::from_white_alpha(150)));
        }
    }
    if let Some(marks) = landscape.marks() {
        let at = view.to_screen(marks.lowest);
        for (width, ink) in [(4.0, Color32::from_black_alpha(150)), (2.0, Color32::WHITE)] {
            painter.line_segment([at - egui::vec2(7.0, 0.0), at + egui::vec2(7.0, 0.0)], Stroke::new(width, ink));
            painter.line_segment([at - egui::vec2(0.0, 7.0), at + egui::vec2(0.0, 7.0)], Stroke::new(width, ink));
        }
        let words = say(&key::lowest_of_landscape(significant(marks.least, 3)));
        paint_words_beside(ui, &painter, words, Rect::from_center_size(at, Vec2::splat(14.0)), &obstacles(model, view));
    }
}

/// The dots of the source, and where a dot that is held has its coordinates and one that waits has its hint.
fn obstacles(model: &Model, view: &View) -> Vec<Pos2> {
    let dots = planar::places(Side::Source, model, view).into_iter().map(|(_, place)| place);
    dots.flat_map(|dot| [-2.0, 0.0, 2.0].map(|steps| dot + Vec2::new(0.0, steps * GRAB_RADIUS))).collect()
}

/// The mesh with a color for each rank: dark where the criterion is least.
fn colored(domain: &MeshedDomain, ranks: &[f32], view: &View) -> Mesh {
    let color = |rank: f32| {
        let [r, g, b, _] = LANDSCAPE_COLORS.at(f64::from(rank)).map(|part| (255.0 * part) as u8);
        Color32::from_rgb(r, g, b).gamma_multiply(LANDSCAPE_OPACITY)
    };
    let vertices = domain.mesh().vertices().iter().zip(ranks);
    let vertices = vertices.map(|(&x, &rank)| Vertex { pos: view.to_screen(x), uv: WHITE_UV, color: color(rank) });
    Mesh {
        vertices: vertices.collect(),
        indices: domain.mesh().triangles().iter().flatten().copied().collect(),
        ..Mesh::default()
    }
}

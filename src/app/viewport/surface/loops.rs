//! The boundary loops of a surface with several: drawn over it, the outline solid, the others dashed, with the numbers of
//! the list beside the picture; a click on a loop makes it the outline.

use crate::app::input::action::{Action, Actions};
use crate::app::input::handles::HandleState;
use crate::app::input::locks::{Control, Locks};
use crate::app::theme::{Palette, bold, suits_fingers};
use crate::app::viewport::surface::OrbitView;
use crate::conformal::{MeshedSurface, Side};
use crate::geometry::DVec3;
use crate::language::{key, say};
use crate::model::Model;
use crate::model::boundary_loops::BoundaryLoop;
use crate::render::OrbitCamera;
use egui::{Align2, CursorIcon, Painter, Pos2, Response, Shape, Stroke, Ui};

/// The distance within which the pointer, or a finger, is on a loop, in points.
const REACH: [f32; 2] = [9.0, 22.0];
/// The widths of the lines of the outline and of the other loops, and the lengths of dashes and gaps, in points.
const WIDTHS: [f32; 2] = [3.5, 2.0];
const DASHES: [f32; 2] = [6.0, 4.0];
/// The radius of the disc with a loop's number, in points.
const BADGE: f32 = 9.0;
/// The strength of what the surface hides.
const HIDDEN: f32 = 0.25;
/// At most this many vertices of a side's loops are tested for being hidden in a frame, in about half a millisecond.
const TESTED: usize = 256;

/// Makes the loop that was clicked the outline, and explains the one under the pointer.
pub fn interact(
    ui: &Ui,
    response: &Response,
    (side, model): (Side, &Model),
    view: &OrbitView,
    handles: &HandleState,
    actions: &mut Actions,
) {
    let pointer = response.interact_pointer_pos().or_else(|| response.hover_pos());
    let is_free = handles.grip.is_none() && handles.hovered.is_none() && !Locks::of(ui.ctx()).holds(Control::Outline);
    let Some(pointer) = pointer.filter(|_| is_free) else { return };
    let loops = model.boundary_loops(side);
    let Some(under) = under(ui, &loops, view, pointer).filter(|under| !under.is_outline) else { return };
    ui.set_cursor_icon(CursorIcon::PointingHand);
    let number = u32::from(under.number) + 1;
    response.clone().on_hover_text_at_pointer(say(&key::loop_in_picture(number, loops.len())));
    if response.clicked() {
        actions.extend(model.choose_outline(side, under.number).map(Action::Session));
    }
}

/// The loop that is nearest to the pointer, if that is on it.
fn under<'a>(ui: &Ui, loops: &'a [BoundaryLoop], view: &OrbitView, pointer: Pos2) -> Option<&'a BoundaryLoop> {
    let distance = |each: &BoundaryLoop| {
        let places: Vec<Option<Pos2>> = each.places.iter().map(|&place| view.to_screen(place)).collect();
        let edges = places.iter().zip(places.iter().cycle().skip(1));
        let seen = edges.filter_map(|(a, b)| Some([(*a)?, (*b)?]));
        seen.map(|[a, b]| distance_to_segment(pointer, a, b)).fold(f32::INFINITY, f32::min)
    };
    let reach = REACH[usize::from(suits_fingers(ui))];
    let measured = loops.iter().map(|each| (distance(each), each)).filter(|(distance, _)| *distance <= reach);
    measured.min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, each)| each)
}

fn distance_to_segment(p: Pos2, a: Pos2, b: Pos2) -> f32 {
    let along = ((p - a).dot(b - a) / (b - a).length_sq().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    p.distance(a + along * (b - a))
}

/// Draws the loops, fainter where the surface hides them, and their numbers.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &OrbitView) {
    let loops = model.boundary_loops(side);
    let Some(surface) = model.surface(side).and_then(|(surface, _)| surface.surface()) else { return };
    let painter = ui.painter_at(view.rect);
    let vertices: usize = loops.iter().map(|each| each.places.len()).sum();
    for each in &loops {
        let parts = parts(each, surface, view, vertices.div_ceil(TESTED));
        paint_line(ui, &painter, each.is_outline, &parts);
    }
    for each in &loops {
        paint_number(ui, &painter, each, view);
    }
}

/// A loop on the screen, in parts that are hidden or are not.
fn parts(each: &BoundaryLoop, surface: &MeshedSurface, view: &OrbitView, step: usize) -> Vec<(bool, Vec<Pos2>)> {
    let eye = view.camera().map(OrbitCamera::eye);
    let hides = |place: DVec3| surface.tree_if_made().zip(eye).is_some_and(|(tree, eye)| tree.hides(eye, place));
    let mut parts: Vec<(bool, Vec<Pos2>)> = Vec::new();
    let mut hidden = false;
    for (k, &place) in each.places.iter().chain(each.places.first()).enumerate() {
        if k % step == 0 {
            hidden = hides(place);
        }
        let Some(at) = view.to_screen(place) else { continue };
        match parts.last_mut() {
            Some((of_part, points)) if *of_part == hidden => points.push(at),
            // the edge between two parts belongs to the first of them
            Some((_, points)) => {
                points.push(at);
                parts.push((hidden, vec![at]));
            }
            None => parts.push((hidden, vec![at])),
        }
    }
    parts
}

fn paint_line(ui: &Ui, painter: &Painter, is_outline: bool, parts: &[(bool, Vec<Pos2>)]) {
    let palette = Palette::of(ui.visuals());
    for (hidden, points) in parts {
        let strength = if *hidden { HIDDEN } else { 1.0 };
        let ink = |color: egui::Color32| color.gamma_multiply(strength);
        if is_outline {
            painter.line(points.clone(), Stroke::new(WIDTHS[0], ink(palette.accent)));
            continue;
        }
        // seen on every pattern: dashes on a ground of the picture's color
        painter.line(points.clone(), Stroke::new(WIDTHS[1] + 2.0, ink(palette.canvas)));
        painter.extend(Shape::dashed_line(points, Stroke::new(WIDTHS[1], ink(palette.accent)), DASHES[0], DASHES[1]));
    }
}

/// The places of the loops' numbers on the screen, in their order.
pub fn places_of_numbers(side: Side, model: &Model, view: &OrbitView) -> Vec<Pos2> {
    model.boundary_loops(side).iter().filter_map(|each| highest(each, view)).collect()
}

/// The highest place of a loop on the screen.
fn highest(each: &BoundaryLoop, view: &OrbitView) -> Option<Pos2> {
    let seen = each.places.iter().filter_map(|&place| view.to_screen(place));
    seen.min_by(|a, b| a.y.total_cmp(&b.y))
}

fn paint_number(ui: &Ui, painter: &Painter, each: &BoundaryLoop, view: &OrbitView) {
    let palette = Palette::of(ui.visuals());
    let Some(at) = highest(each, view) else { return };
    let (ground, ink) =
        if each.is_outline { (palette.accent, palette.on_accent) } else { (palette.raised, palette.text) };
    painter.circle(at, BADGE, ground, Stroke::new(1.5, palette.accent));
    painter.text(at, Align2::CENTER_CENTER, u32::from(each.number) + 1, bold(11.0), ink);
}

//! The boundary loops of a surface with several: drawn over it, the outline solid, the others dashed, with the numbers of
//! the list beside the picture; a click on a loop makes it the outline, where the surface does not hide it.

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
use crate::surface::SurfaceTree;
use egui::{Align2, CursorIcon, Painter, Pos2, Response, Shape, Stroke, Ui};
use std::sync::Arc;

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

/// Makes the loop that was clicked the outline, and explains the one under the pointer; neither while something is
/// dragged. The caller leaves out the frame in which a dot is let go.
pub fn interact(
    ui: &Ui,
    response: &Response,
    (side, model): (Side, &Model),
    view: &OrbitView,
    handles: &HandleState,
    actions: &mut Actions,
) {
    // a key that acts on the picture is no click at a place
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked());
    let pointer = clicked.or_else(|| response.hover_pos());
    let is_dragging = response.dragged() || response.drag_stopped() || handles.grip.is_some();
    let is_free = !is_dragging && handles.hovered.is_none() && !Locks::of(ui.ctx()).holds(Control::Outline);
    let Some(pointer) = pointer.filter(|_| is_free) else { return };
    let loops = model.boundary_loops(side);
    let Some((surface, _)) = model.surface(side).filter(|_| !loops.is_empty()) else { return };
    let Some(sight) = Sight::of(surface.surface(), view) else { return };
    let reach = REACH[usize::from(suits_fingers(ui))];
    let Some(under) = under(reach, &loops, &sight, pointer).filter(|under| !under.is_outline) else { return };
    ui.set_cursor_icon(CursorIcon::PointingHand);
    let number = u32::from(under.number) + 1;
    response.clone().on_hover_text_at_pointer(say(&key::loop_in_picture(number, loops.len())));
    if clicked.is_some() {
        actions.extend(model.choose_outline(side, under.number).map(Action::Session));
    }
}

/// A surface as it is seen.
struct Sight<'a> {
    /// Its triangles, once they are sorted.
    tree: Option<&'a SurfaceTree>,
    view: &'a OrbitView,
    eye: DVec3,
}

impl<'a> Sight<'a> {
    fn of(surface: Option<&'a Arc<MeshedSurface>>, view: &'a OrbitView) -> Option<Self> {
        Some(Self { tree: surface?.tree_if_made(), view, eye: view.camera().map(OrbitCamera::eye)? })
    }

    /// Whether the surface hides a place; not known, and so false, before its triangles are sorted.
    fn hides(&self, place: DVec3) -> bool {
        self.tree.is_some_and(|tree| tree.hides(self.eye, place))
    }
}

/// The loop that is nearest to the pointer, if the pointer is on it and the surface does not hide it there.
fn under<'a>(reach: f32, loops: &'a [BoundaryLoop], sight: &Sight<'_>, pointer: Pos2) -> Option<&'a BoundaryLoop> {
    let mut hits: Vec<(f32, DVec3, &BoundaryLoop)> = Vec::new();
    for each in loops {
        let places = each.places.iter().map(|&place| (place, sight.view.to_screen(place)));
        for ((a, at_a), (b, at_b)) in places.clone().zip(places.cycle().skip(1)) {
            let Some((along, distance)) = at_a.zip(at_b).map(|(a, b)| nearest_on_segment(pointer, a, b)) else {
                continue;
            };
            if distance <= reach {
                hits.push((distance, a.lerp(b, f64::from(along)), each));
            }
        }
    }
    hits.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
    hits.into_iter().take(TESTED).find(|(_, place, _)| !sight.hides(*place)).map(|(_, _, each)| each)
}

/// The point of a segment that is nearest to p, as a fraction of its length, and its distance.
fn nearest_on_segment(p: Pos2, a: Pos2, b: Pos2) -> (f32, f32) {
    let along = ((p - a).dot(b - a) / (b - a).length_sq().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
    (along, p.distance(a + along * (b - a)))
}

/// Draws the loops, fainter where the surface hides them, and their numbers.
pub fn paint(ui: &Ui, side: Side, model: &Model, view: &OrbitView) {
    let loops = model.boundary_loops(side);
    let Some((surface, _)) = model.surface(side).filter(|_| !loops.is_empty()) else { return };
    let Some(sight) = Sight::of(surface.surface(), view) else { return };
    let painter = ui.painter_at(view.rect);
    let vertices: usize = loops.iter().map(|each| each.places.len()).sum();
    for each in &loops {
        let parts = parts(each, &sight, vertices.div_ceil(TESTED));
        paint_line(ui, &painter, each.is_outline, &parts);
    }
    for each in &loops {
        paint_number(ui, &painter, each, &sight);
    }
}

/// A loop on the screen, in parts that are hidden or are not.
fn parts(each: &BoundaryLoop, sight: &Sight<'_>, step: usize) -> Vec<(bool, Vec<Pos2>)> {
    let mut parts: Vec<(bool, Vec<Pos2>)> = Vec::new();
    let mut hidden = false;
    for (k, &place) in each.places.iter().chain(each.places.first()).enumerate() {
        if k % step == 0 {
            hidden = sight.hides(place);
        }
        let Some(at) = sight.view.to_screen(place) else { continue };
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
    model.boundary_loops(side).iter().filter_map(|each| highest(each, view)).map(|(_, at)| at).collect()
}

/// The place of a loop that is highest on the screen, and where it is there.
fn highest(each: &BoundaryLoop, view: &OrbitView) -> Option<(DVec3, Pos2)> {
    let seen = each.places.iter().filter_map(|&place| Some((place, view.to_screen(place)?)));
    seen.min_by(|(_, a), (_, b)| a.y.total_cmp(&b.y))
}

fn paint_number(ui: &Ui, painter: &Painter, each: &BoundaryLoop, sight: &Sight<'_>) {
    let palette = Palette::of(ui.visuals());
    let Some((place, at)) = highest(each, sight.view) else { return };
    // as faint as its line, which is not clicked there either
    let strength = if sight.hides(place) { HIDDEN } else { 1.0 };
    let (ground, ink) =
        if each.is_outline { (palette.accent, palette.on_accent) } else { (palette.raised, palette.text) };
    let faint = |color: egui::Color32| color.gamma_multiply(strength);
    painter.circle(at, BADGE, faint(ground), Stroke::new(1.5, faint(palette.accent)));
    painter.text(at, Align2::CENTER_CENTER, u32::from(each.number) + 1, bold(11.0), faint(ink));
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::app::viewport::view::Margins;
    use crate::render::BoundingSphere;
    use crate::surface::{Surface, SurfaceMesh};
    use egui::{Rect, pos2, vec2};

    /// The vertices around a tube.
    const AROUND: u32 = 24;

    fn on_ring(k: u32, height: f64) -> DVec3 {
        let (y, x) = (std::f64::consts::TAU * f64::from(k) / f64::from(AROUND)).sin_cos();
        DVec3::new(x, y, height)
    }

    #[test]
    fn a_loop_is_chosen_where_it_is_seen_and_not_through_the_surface() {
        let ring = |height: f64| (0..AROUND).map(move |k| on_ring(k, height));
        let around = (0..AROUND).map(|k| (k, (k + 1) % AROUND));
        let triangles = around.flat_map(|(k, next)| [[k, next, AROUND + k], [next, AROUND + next, AROUND + k]]);
        let tube = Surface::new(ring(0.0).chain(ring(2.0)).collect(), triangles.collect());
        let mesh = SurfaceMesh::repaired(&tube).unwrap();
        let tree = SurfaceTree::new(mesh.mesh());
        let scene = BoundingSphere { center: DVec3::Z, radius: 1.5 };
        let mut view = OrbitView::default();
        view.place(Rect::from_min_size(pos2(100.0, 50.0), vec2(600.0, 500.0)), 1.0, Margins::NONE, scene);
        view.look(OrbitCamera::new(scene, DVec3::new(0.0, -1.0, 0.4), DVec3::Z, view.aspect()));
        let eye = view.camera().unwrap().eye();
        let lower = [BoundaryLoop { number: 1, is_outline: false, length: 6.3, places: ring(0.0).collect() }];
        let chosen = |tree, place| {
            let sight = Sight { tree, view: &view, eye };
            under(REACH[0], &lower, &sight, view.to_screen(place).unwrap()).is_some()
        };
        let [far, near] = [AROUND / 4, 3 * AROUND / 4].map(|k| on_ring(k, 0.0));
        assert!(chosen(Some(&tree), near), "in front");
        assert!(!chosen(Some(&tree), far), "behind the wall of the tube");
        assert!(chosen(None, far), "not known before the triangles are sorted");
        assert!(!chosen(Some(&tree), DVec3::Z), "beside it");
    }
}

//! The probe: a small circle with a cross about a draggable point of the source, and its image in the target.

use super::dots::paint_words;
use super::view::View;
use crate::app::input::handles::{GRAB_RADIUS, HandleState, ProbeGrip};
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::{key, number, say};
use crate::model::{Model, Probe, ProbeImage};
use egui::{Color32, CursorIcon, Painter, Pos2, Response, Shape, Stroke, Ui};
use std::f64::consts::TAU;

/// The ink of circle and cross, on a dark rim: seen on every pattern, and none of the dots' colors.
const INK: Color32 = Color32::from_rgb(255, 214, 10);
const RIM: Color32 = Color32::from_black_alpha(170);
/// The widths of rim and ink, in points.
const WIDTHS: [(f32, Color32); 2] = [(4.5, RIM), (2.5, INK)];
/// The sides of the mark of the right angle, as a share of the radius.
const CORNER: f64 = 0.28;
/// The points of the circle in the source.
const RING: usize = 64;

/// Grabs, drags and releases the probe; returns whether it is held. Dots that lie over it come first.
pub fn interact(
    ui: &Ui,
    response: &Response,
    side: Side,
    model: &Model,
    view: &View,
    handles: &mut HandleState,
) -> bool {
    let Some(probe) = handles.probe.filter(|_| side == Side::Source) else { return false };
    let (pressed, down, pointer) =
        ui.input(|input| (input.pointer.primary_pressed(), input.pointer.primary_down(), input.pointer.interact_pos()));
    let place = view.to_screen(probe.center);
    let reach = GRAB_RADIUS.max(place.distance(view.to_screen(probe.center + probe.radius * DVec2::X)));
    let is_over = |pointer: &Pos2| response.hovered() && pointer.distance(place) <= reach;
    let is_free = handles.grip.is_none() && handles.hovered.is_none();
    if let Some(pointer) = pointer.filter(is_over).filter(|_| is_free) {
        ui.set_cursor_icon(CursorIcon::Grab);
        if pressed {
            handles.probe_grip = Some(ProbeGrip { offset: place - pointer });
        }
    }
    if !down {
        handles.probe_grip = None;
    }
    if let (Some(grip), Some(pointer)) = (handles.probe_grip, pointer) {
        ui.set_cursor_icon(CursorIcon::Grabbing);
        handles.probe = model.probe_at(view.to_world(pointer + grip.offset)).or(handles.probe);
    }
    handles.probe_grip.is_some()
}

/// Draws the probe on the source and its image on the target, where size and turning are written.
pub fn paint(ui: &Ui, side: Side, view: &View, probe: Probe, image: &ProbeImage) {
    let painter = ui.painter_at(view.rect);
    let place = |point: DVec2| view.to_screen(point);
    match side {
        Side::Source => {
            let ring = (0..RING).map(|k| probe.center + probe.radius * DVec2::from_angle(TAU * k as f64 / RING as f64));
            let arms = [DVec2::X, DVec2::Y].map(|axis| [-1.0, 1.0].map(|end| probe.center + end * probe.radius * axis));
            let corner = corner(probe.center, CORNER * probe.radius * DVec2::X);
            draw(
                &painter,
                [ring.map(place).collect(), arms[0].map(place).into(), arms[1].map(place).into()],
                corner.map(place),
            );
        }
        Side::Target => {
            let [ring, along, across] =
                [&image.ring, &image.arms[0], &image.arms[1]].map(|points| points.iter().copied().map(place).collect());
            let corner = corner(image.center.image, CORNER * probe.radius * image.center.derivative);
            draw(&painter, [ring, along, across], corner.map(place));
            // a turning of −0.4° is written as 0
            let turning = number(image.center.turning().round() + 0.0, 0).replace('-', "−");
            let words = say(&key::probed(number(image.center.scale(), 2), turning));
            let center = place(image.center.image);
            let top = image.ring.iter().map(|&point| place(point).y).fold(center.y, f32::min);
            paint_words(ui, &painter, words, Pos2::new(center.x, top));
        }
    }
}

/// The mark of the right angle between a direction and the one to its left, at a point.
fn corner(at: DVec2, along: DVec2) -> [DVec2; 3] {
    let across = along.perp();
    [at + along, at + along + across, at + across]
}

/// A closed ring, two lines and the mark of their angle.
fn draw(painter: &Painter, [ring, along, across]: [Vec<Pos2>; 3], corner: [Pos2; 3]) {
    for (width, ink) in WIDTHS {
        let stroke = Stroke::new(width, ink);
        painter.add(Shape::closed_line(ring.clone(), stroke));
        let thin = Stroke::new(0.7 * width, ink);
        for line in [along.clone(), across.clone(), corner.to_vec()] {
            painter.add(Shape::line(line, thin));
        }
    }
}

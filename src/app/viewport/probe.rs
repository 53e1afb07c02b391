//! The probe: a small circle with a cross about a draggable point of the source, and its image in the target.

use super::dots::paint_words_beside;
use super::view::View;
use crate::app::input::handles::{GRAB_RADIUS, HandleState};
use crate::app::input::keyboard_navigation;
use crate::app::theme::Palette;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::{key, number, say};
use crate::model::{Model, Probe, ProbeImage};
use egui::{Color32, CursorIcon, Painter, Pos2, Rect, Response, Shape, Stroke, Ui};

/// The ink of circle and cross, on a dark rim: seen on every pattern, and none of the dots' colors.
const INK: Color32 = Color32::from_rgb(255, 214, 10);
const RIM: Color32 = Color32::from_black_alpha(170);
/// The widths of rim and ink, in points.
const WIDTHS: [(f32, Color32); 2] = [(4.5, RIM), (2.5, INK)];
/// The free space between the circle and the ring of the keyboard focus, in points.
const FOCUS_GAP: f32 = 5.0;

/// Whether the pointer is over the probe, and whether it holds it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Contact {
    pub is_over: bool,
    pub is_held: bool,
}

/// Grabs, drags and releases the probe, and moves it by the arrow keys while it has the keyboard focus. Dots that lie over it come first.
pub fn interact(
    ui: &Ui,
    response: &Response,
    side: Side,
    model: &Model,
    view: &View,
    handles: &mut HandleState,
) -> Contact {
    let Some(probe) = handles.probe.filter(|_| side == Side::Source) else { return Contact::default() };
    let (pressed, down, pointer) =
        ui.input(|input| (input.pointer.primary_pressed(), input.pointer.primary_down(), input.pointer.interact_pos()));
    let place = view.to_screen(probe.center);
    let reach = GRAB_RADIUS.max(place.distance(view.to_screen(probe.center + probe.radius * DVec2::X)));
    let is_free = response.hovered() && handles.grip.is_none() && handles.hovered.is_none();
    let over = pointer.filter(|pointer| is_free && pointer.distance(place) <= reach);
    if let Some(pointer) = over {
        ui.set_cursor_icon(CursorIcon::Grab);
        if pressed {
            handles.probe_grip = Some(place - pointer);
        }
    }
    if !down {
        handles.probe_grip = None;
    }
    if let (Some(offset), Some(pointer)) = (handles.probe_grip, pointer) {
        ui.set_cursor_icon(CursorIcon::Grabbing);
        handles.probe = model.probe_at(view.to_world(pointer + offset)).or(handles.probe);
    }
    if let Some(step) = keyboard_navigation::of_probe(ui, place, handles) {
        handles.probe = model.probe_at(view.to_world(place + step)).or(handles.probe);
    }
    let is_held = handles.probe_grip.is_some();
    Contact { is_over: is_held || over.is_some(), is_held }
}

/// Draws the probe on the source, with a ring around it if it has the keyboard focus.
pub fn paint(ui: &Ui, view: &View, probe: Probe, is_focused: bool) {
    let places =
        |points: &mut dyn Iterator<Item = DVec2>| -> Vec<Pos2> { points.map(|point| view.to_screen(point)).collect() };
    let arms = [DVec2::X, DVec2::Y].map(|axis| places(&mut probe.arm(axis)));
    let painter = ui.painter_at(view.rect);
    draw(&painter, &places(&mut probe.ring()), &arms, &places(&mut probe.corner().into_iter()));
    if is_focused {
        let center = view.to_screen(probe.center);
        let radius = center.distance(view.to_screen(probe.center + probe.radius * DVec2::X));
        painter.circle_stroke(center, radius + FOCUS_GAP, Stroke::new(2.0, Palette::of(ui.visuals()).accent_soft));
    }
}

/// Draws the probe's image on the target, with its size and turning in words beside it that cover none of the dots.
pub fn paint_image(ui: &Ui, view: &View, image: &ProbeImage, dots: &[Pos2]) {
    let painter = ui.painter_at(view.rect);
    let places = |points: &[DVec2]| points.iter().map(|&point| view.to_screen(point)).collect::<Vec<Pos2>>();
    let ring = places(&image.ring);
    draw(&painter, &ring, &image.arms.each_ref().map(|arm| places(arm)), &places(&image.corner));
    paint_words_beside(ui, &painter, words(image), Rect::from_points(&ring), dots);
}

/// |f′| and arg f′ at the center, in words.
pub fn words(image: &ProbeImage) -> String {
    // a turning of −0.4° is written as 0
    let turning = number(image.center.turning().round() + 0.0, 0).replace('-', "−");
    say(&key::probed(number(image.center.scale(), 2), turning))
}

/// A closed ring, two lines and the mark of their angle.
fn draw(painter: &Painter, ring: &[Pos2], arms: &[Vec<Pos2>; 2], corner: &[Pos2]) {
    for (width, ink) in WIDTHS {
        painter.add(Shape::closed_line(ring.to_vec(), Stroke::new(width, ink)));
        for line in [&arms[0], &arms[1], corner] {
            painter.add(Shape::line(line.to_vec(), Stroke::new(0.7 * width, ink)));
        }
    }
}

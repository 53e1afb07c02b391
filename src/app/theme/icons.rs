//! Buttons with a painted icon: the fonts have no such signs.

use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use egui::{Button, Pos2, Response, Role, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2};

/// An icon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Icon {
    /// An arrow that turns back to the left.
    Undo,
    /// An arrow that turns to the right.
    Redo,
    /// Three dots joined by two lines.
    Share,
    /// An arrow upwards.
    Up,
    /// An arrow downwards.
    Down,
    /// An arrow to the left.
    Back,
    /// An arrow that goes around in a circle.
    Again,
    /// A triangle to the right.
    Play,
    /// A square.
    Stop,
    /// A cross.
    End,
}

/// The width of an icon's button for a mouse, in points.
pub const ICON_WIDTH: f32 = 32.0;

/// A button with an icon; `name` is what those who hear the screen hear, the tooltip explains it.
pub fn icon_button(ui: &mut Ui, icon: Icon, enabled: bool, name: &str, tooltip: &str) -> Response {
    let size = vec2(control_height(ui, ICON_WIDTH), control_height(ui, ROW_HEIGHT));
    let button = ui.add_enabled(enabled, Button::new("").min_size(size));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    let palette = Palette::of(ui.visuals());
    let ink = if enabled { palette.text } else { palette.weak.gamma_multiply(0.5) };
    for line in lines(icon) {
        let line: Vec<Pos2> = line.into_iter().map(|point| button.rect.center() + point).collect();
        ui.painter().line(line, Stroke::new(1.6, ink));
    }
    if icon == Icon::Share {
        for point in SHARED {
            ui.painter().circle_filled(button.rect.center() + point, 2.4, ink);
        }
    }
    button.on_hover_text(tooltip).on_disabled_hover_text(tooltip)
}

const SHARED: [Vec2; 3] = [vec2(-4.5, 0.0), vec2(4.0, -4.5), vec2(4.0, 4.5)];

/// The strokes of an icon, relative to its center.
fn lines(icon: Icon) -> Vec<Vec<Vec2>> {
    let way = match icon {
        Icon::Undo => 1.0,
        Icon::Redo => -1.0,
        Icon::Share => return vec![vec![SHARED[1], SHARED[0], SHARED[2]]],
        Icon::Up => return arrow(vec2(0.0, -1.0)),
        Icon::Down => return arrow(vec2(0.0, 1.0)),
        Icon::Back => return arrow(vec2(-1.0, 0.0)),
        Icon::Again => return circle_arrow(),
        Icon::Play => return closed(&[vec2(-3.5, -5.0), vec2(5.0, 0.0), vec2(-3.5, 5.0)]),
        Icon::Stop => return closed(&[vec2(-4.0, -4.0), vec2(4.0, -4.0), vec2(4.0, 4.0), vec2(-4.0, 4.0)]),
        Icon::End => return [4.0, -4.0].map(|y| vec![vec2(-4.0, -y), vec2(4.0, y)]).into(),
    };
    let bow = (0..=8).map(|k| {
        let angle = std::f32::consts::PI * (k as f32 / 8.0 - 0.5);
        vec2(2.0 + 3.5 * angle.cos(), 1.5 + 3.5 * angle.sin())
    });
    let shaft = [pos2(-5.5, -2.0).to_vec2()].into_iter().chain(bow).chain([vec2(-2.0, 5.0)]);
    let head = [vec2(-2.5, -5.0), vec2(-5.5, -2.0), vec2(-2.5, 1.0)];
    [shaft.collect::<Vec<_>>(), head.to_vec()]
        .map(|line| line.into_iter().map(|point| vec2(way * point.x, point.y)).collect())
        .into()
}

/// An arrow in this direction, which has unit length.
fn arrow(way: Vec2) -> Vec<Vec<Vec2>> {
    let wing = |side: f32| 1.5 * way + side * way.rot90();
    vec![vec![-5.0 * way, 5.0 * way], vec![wing(-3.5), 5.0 * way, wing(3.5)]]
}

/// Most of a circle with an arrowhead at the end.
fn circle_arrow() -> Vec<Vec<Vec2>> {
    const END: i32 = 13;
    let toward = |k: i32| Vec2::angled(std::f32::consts::TAU * (k as f32 / 16.0));
    let end = 5.0 * toward(END);
    // the arc goes on a quarter turn further: the wings go back, the one inside farther from the arc
    let wings = [END + 9, END + 14].map(|k| end + 4.2 * toward(k));
    vec![(1..=END).map(|k| 5.0 * toward(k)).collect(), vec![wings[0], end, wings[1]]]
}

/// A polygon.
fn closed(corners: &[Vec2]) -> Vec<Vec<Vec2>> {
    vec![corners.iter().chain(corners.first()).copied().collect()]
}

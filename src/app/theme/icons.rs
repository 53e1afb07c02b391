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
        Icon::Up => return arrow(-1.0),
        Icon::Down => return arrow(1.0),
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

/// An arrow along the y axis.
fn arrow(way: f32) -> Vec<Vec<Vec2>> {
    let tip = vec2(0.0, 5.0 * way);
    vec![vec![vec2(0.0, -5.0 * way), tip], vec![vec2(-3.5, 1.5 * way), tip, vec2(3.5, 1.5 * way)]]
}

//! The drawing of a map projection: the region, tinted by the scale, the graticule, lines of equal scale with their values,
//! and the coast.

use crate::app::theme::Palette;
use crate::geometry::{Bounds, DVec2};
use crate::worker::{DrawnScale, FoundProjection, Land};
use egui::{Align2, Color32, CornerRadius, FontId, Mesh, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, pos2, vec2};

/// The margin around the map, in points.
const MARGIN: f32 = 10.0;
/// The size of the values, in points; lines shorter than so many of them have none.
const LABEL: f32 = 11.0;
const LABELED: f32 = 6.0;

/// The colors of a theme.
struct Inks {
    /// The land where the scale is least, and at the coast.
    land: [Color32; 2],
    graticule: Color32,
    /// Lines of equal scale: Okabe and Ito's vermilion, lighter or darker than the land.
    scale: Color32,
}

const DARK: Inks = Inks {
    land: [Color32::from_rgb(58, 82, 84), Color32::from_rgb(36, 46, 54)],
    graticule: Color32::from_rgb(110, 128, 144),
    scale: Color32::from_rgb(245, 150, 92),
};
const LIGHT: Inks = Inks {
    land: [Color32::from_rgb(222, 233, 222), Color32::from_rgb(246, 243, 234)],
    graticule: Color32::from_rgb(143, 163, 179),
    scale: Color32::from_rgb(181, 83, 42),
};

/// Draws the map as wide as there is room, at most `most` high.
pub fn show(ui: &mut Ui, found: &FoundProjection, most: f32) {
    let bounds = Bounds::of(found.outline.iter().copied());
    let width = ui.available_width();
    let inner = vec2(width, most) - vec2(2.0 * MARGIN, 2.0 * MARGIN);
    let scale = (f64::from(inner.x) / bounds.size().x).min(f64::from(inner.y) / bounds.size().y);
    let height = (scale * bounds.size().y) as f32 + 2.0 * MARGIN;
    let (rect, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let center = 0.5 * (bounds.min() + bounds.max());
    let place = |p: DVec2| {
        let from_center = scale * (p - center);
        rect.center() + vec2(from_center.x as f32, -from_center.y as f32)
    };
    let painter = ui.painter_at(rect);
    let palette = Palette::of(ui.visuals());
    let inks = if ui.visuals().dark_mode { &DARK } else { &LIGHT };
    painter.rect_filled(rect, CornerRadius::same(6), palette.canvas);
    land(&painter, &found.land, inks, &place);
    let line = |line: &[DVec2], stroke: Stroke| {
        painter.line(line.iter().map(|&p| place(p)).collect(), stroke);
    };
    for part in &found.graticule {
        line(part, Stroke::new(0.8, inks.graticule));
    }
    for part in found.scales.iter().flat_map(|scale| &scale.lines) {
        line(part, Stroke::new(1.3, inks.scale));
    }
    let coast: Vec<Pos2> = found.outline.iter().map(|&p| place(p)).collect();
    painter.add(Shape::closed_line(coast, Stroke::new(1.6, palette.text)));
    values(&painter, &found.scales, inks, palette.canvas, &place);
}

/// The land, lighter where the scale is less.
fn land(painter: &Painter, land: &Land, inks: &Inks, place: &dyn Fn(DVec2) -> Pos2) {
    let least = land.scales.iter().copied().fold(1.0, f32::min);
    let mut mesh = Mesh::default();
    for (&[x, y], &scale) in land.vertices.iter().zip(&land.scales) {
        let share = if least < 1.0 { ((scale - least) / (1.0 - least)).clamp(0.0, 1.0) } else { 1.0 };
        let ink = inks.land[0].lerp_to_gamma(inks.land[1], share);
        mesh.colored_vertex(place(DVec2::new(x.into(), y.into())), ink);
    }
    for &[a, b, c] in &land.triangles {
        mesh.add_triangle(a, b, c);
    }
    painter.add(Shape::mesh(mesh));
}

/// Writes the value of each scale at the top of its longest line, where there is room.
fn values(painter: &Painter, scales: &[DrawnScale], inks: &Inks, ground: Color32, place: &dyn Fn(DVec2) -> Pos2) {
    let mut written: Vec<Rect> = Vec::new();
    for DrawnScale { label, lines } in scales {
        let drawn = lines.iter().map(|line| line.iter().map(|&p| place(p)).collect::<Vec<_>>());
        let longest = drawn.max_by(|a, b| length(a).total_cmp(&length(b)));
        let Some(line) = longest.filter(|line| length(line) > LABELED * LABEL) else { continue };
        let Some(top) = line.into_iter().min_by(|a, b| a.y.total_cmp(&b.y)) else { continue };
        let text = crate::language::decimal(label);
        let galley = painter.layout_no_wrap(text, FontId::proportional(LABEL), inks.scale);
        let area = Align2::CENTER_CENTER.anchor_size(pos2(top.x, top.y), galley.size()).expand2(vec2(3.0, 0.5));
        if written.iter().any(|other| other.intersects(area)) {
            continue;
        }
        painter.rect_filled(area, CornerRadius::same(4), ground.gamma_multiply(0.8));
        painter.galley(area.min + vec2(3.0, 0.5), galley, inks.scale);
        written.push(area);
    }
}

fn length(line: &[Pos2]) -> f32 {
    line.windows(2).map(|ends| ends[0].distance(ends[1])).sum()
}

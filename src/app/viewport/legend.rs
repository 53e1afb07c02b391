//! The legend of triangle colors: a color bar with ticks, the histogram above it, and a mark at the mean. The legend of a
//! landscape, whose colors are ranks, has the bar with three values.

use crate::app::theme::text_metrics::text_width;
use crate::app::theme::{Palette, bold};
use crate::language::{key, say, tr};
use crate::model::pattern::colouring::ColourScale;
use crate::render::ColourMap;
use egui::{Align2, Color32, CornerRadius, FontId, Mesh, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

/// The size of the legend, in points.
#[derive(Debug, Clone, Copy)]
struct Size {
    width: f32,
    histogram: f32,
}

const DESK: Size = Size { width: 220.0, histogram: 30.0 };
const PHONE: Size = Size { width: 170.0, histogram: 18.0 };
/// The size in a low or narrow viewport, such as above the open sheet of a phone.
const TINY: Size = Size { width: 104.0, histogram: 2.0 };
/// On a phone, a viewport lower than this has room for [`TINY`] only.
const TINY_BELOW: f32 = 220.0;

/// The widths from which a viewport has room for [`DESK`] and [`PHONE`] beside the legend of the dots.
const DESK_FROM: f32 = 420.0;
const NARROW_FROM: f32 = 360.0;

/// The height of the bar.
const BAR: f32 = 9.0;
/// The font size of title and mean, and the least space between them.
const TITLE_TEXT: f32 = 11.5;
const TITLE_GAP: f32 = 6.0;
/// The font size of values at the bar.
const TICK_TEXT: f32 = 10.5;
/// The heights of the title above and the ticks below.
const TITLE: f32 = 17.0;
const TICKS: f32 = 15.0;
/// From the picture's right edge to the legend's background.
const BESIDE: f32 = 12.0;
/// From the picture's lower edge to the legend's background.
const BELOW: f32 = 10.0;
/// From the background's edge to its content.
const PADDING: f32 = 10.0;

/// The height that the legend takes at the lower edge of `area`; 0 for [`TINY`] on a phone, which overlaps the picture.
pub fn height(area: Rect, narrow: bool) -> f32 {
    if narrow && area.height() < TINY_BELOW {
        return 0.0;
    }
    TITLE + size_in(area, narrow).histogram + BAR + TICKS + PADDING + BELOW
}

/// The width that the legend takes at the right edge of `area`.
pub fn width(area: Rect, narrow: bool) -> f32 {
    size_in(area, narrow).width + 2.0 * PADDING + BESIDE
}

/// The largest size that fits. On a phone (`narrow`) the legend of the dots is elsewhere; otherwise it takes a part of
/// the width.
fn size_in(area: Rect, narrow: bool) -> Size {
    match area.width() {
        _ if narrow && area.height() < TINY_BELOW => TINY,
        width if narrow || (NARROW_FROM..DESK_FROM).contains(&width) => PHONE,
        width if width < NARROW_FROM => TINY,
        _ => DESK,
    }
}

/// Paints the legend into the lower right corner of `area`.
pub fn paint(ui: &Ui, area: Rect, scale: &ColourScale, narrow: bool) {
    let palette = Palette::of(ui.visuals());
    let size = size_in(area, narrow);
    let painter = ui.painter_at(area);
    let inner = ground(&painter, area, size, &palette);
    let bar = Rect::from_min_size(inner.min + vec2(0.0, TITLE + size.histogram), vec2(size.width, BAR));
    paint_title(ui, &painter, inner, scale, &palette);
    if size.histogram > 5.0 {
        paint_histogram(&painter, bar, size.histogram - 3.0, scale, &palette);
    }
    paint_bar(&painter, bar, scale.map);
    paint_ticks(&painter, bar, scale, &palette);
    paint_mean(&painter, bar, size.histogram, scale, &palette);
}

/// Paints the legend of a landscape into the lower right corner of `area`: the colors of ranks from 0 to 1, and the words
/// of the values with the ranks 0, ½ and 1.
pub fn paint_ranks(ui: &Ui, area: Rect, title: &str, map: ColourMap, values: &[String; 3], narrow: bool) {
    let palette = Palette::of(ui.visuals());
    let size = Size { histogram: 0.0, ..size_in(area, narrow) };
    let painter = ui.painter_at(area);
    let inner = ground(&painter, area, size, &palette);
    let bar = Rect::from_min_size(inner.min + vec2(0.0, TITLE), vec2(size.width, BAR));
    paint_words(ui, &painter, inner, title, inner.width(), &palette);
    paint_bar(&painter, bar, map);
    let places = [Align2::LEFT_TOP, Align2::CENTER_TOP, Align2::RIGHT_TOP].into_iter().zip([0.0, 0.5, 1.0]);
    for ((align, part), text) in places.zip(values) {
        let at = pos2(bar.left() + part * bar.width(), bar.bottom() + 3.0);
        painter.text(at, align, text, FontId::proportional(TICK_TEXT), palette.weak);
    }
}

/// Paints the background into the lower right corner of `area`; returns the content's place.
fn ground(painter: &Painter, area: Rect, size: Size, palette: &Palette) -> Rect {
    let whole = vec2(size.width, TITLE + size.histogram + BAR + TICKS);
    let corner = area.right_bottom() - vec2(BESIDE, BELOW) - 2.0 * vec2(PADDING, 0.5 * PADDING) - whole;
    let inner = Rect::from_min_size(corner + vec2(PADDING, 0.5 * PADDING), whole);
    let outer = inner.expand2(vec2(PADDING, 0.5 * PADDING));
    painter.rect_filled(outer, CornerRadius::same(8), palette.canvas.gamma_multiply(0.86));
    inner
}

/// The mean at the right, and left of it the title: whole if it fits, else its first word, else its symbols.
fn paint_title(ui: &Ui, painter: &Painter, inner: Rect, scale: &ColourScale, palette: &Palette) {
    let mut room = inner.width();
    if let Some(mean) = scale.mean() {
        let mean = say(&key::mean_of(mean));
        let font = FontId::proportional(TITLE_TEXT);
        room -= text_width(ui, &mean, font.clone()) + TITLE_GAP;
        painter.text(inner.right_top(), Align2::RIGHT_TOP, mean, font, palette.text);
    }
    paint_words(ui, painter, inner, tr(scale.title()), room, palette);
}

/// A title that fits into `room`: whole, else its first word, else the rest.
fn paint_words(ui: &Ui, painter: &Painter, inner: Rect, whole: &str, room: f32, palette: &Palette) {
    let font = bold(TITLE_TEXT);
    let parts = whole.split_once(' ').map_or([whole; 2], |(name, symbols)| [name, symbols]);
    let title = [whole].into_iter().chain(parts).find(|title| text_width(ui, title, font.clone()) <= room);
    if let Some(title) = title {
        painter.text(inner.left_top(), Align2::LEFT_TOP, title, font, palette.text);
    }
}

/// The histogram; heights are square roots of the shares, so that a bin with 1 % of the area is still visible.
fn paint_histogram(painter: &Painter, bar: Rect, height: f32, scale: &ColourScale, palette: &Palette) {
    let Some(histogram) = &scale.histogram else { return };
    let largest = histogram.shares.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let width = bar.width() / histogram.shares.len() as f32;
    for (k, share) in histogram.shares.iter().enumerate().filter(|(_, share)| **share > 0.0) {
        let rise = (height * (share / largest).sqrt() as f32).max(1.0);
        let left = bar.left() + k as f32 * width;
        let column = Rect::from_min_max(pos2(left, bar.top() - 2.0 - rise), pos2(left + width - 0.8, bar.top() - 2.0));
        painter.rect_filled(column, CornerRadius::ZERO, palette.weak.gamma_multiply(0.8));
    }
}

fn paint_bar(painter: &Painter, bar: Rect, map: ColourMap) {
    const STEPS: u32 = 64;
    let mut mesh = Mesh::default();
    for k in 0..=STEPS {
        let t = k as f32 / STEPS as f32;
        let [r, g, b, _] = map.at(f64::from(t)).map(|component| (255.0 * component).round() as u8);
        let x = bar.left() + t * bar.width();
        mesh.colored_vertex(pos2(x, bar.top()), Color32::from_rgb(r, g, b));
        mesh.colored_vertex(pos2(x, bar.bottom()), Color32::from_rgb(r, g, b));
        if k > 0 {
            let first = 2 * (k - 1);
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 3, first + 2);
        }
    }
    painter.add(Shape::mesh(mesh));
}

fn paint_ticks(painter: &Painter, bar: Rect, scale: &ColourScale, palette: &Palette) {
    let ticks = scale.ticks();
    let last = ticks.len() - 1;
    for (k, (value, text)) in ticks.into_iter().enumerate() {
        let x = bar.left() + scale.place(value) as f32 * bar.width();
        painter.line_segment([pos2(x, bar.bottom()), pos2(x, bar.bottom() + 3.0)], Stroke::new(1.0, palette.weak));
        if bar.width() < DESK.width && k % 2 == 1 {
            continue;
        }
        let align = match k {
            0 => Align2::LEFT_TOP,
            k if k == last => Align2::RIGHT_TOP,
            _ => Align2::CENTER_TOP,
        };
        painter.text(pos2(x, bar.bottom() + 3.0), align, text, FontId::proportional(TICK_TEXT), palette.weak);
    }
}

/// The mark of the mean: a line through histogram and bar with a small triangle on top.
fn paint_mean(painter: &Painter, bar: Rect, height: f32, scale: &ColourScale, palette: &Palette) {
    let Some(histogram) = &scale.histogram else { return };
    let x = bar.left() + scale.place(histogram.mean).clamp(0.0, 1.0) as f32 * bar.width();
    let top = bar.top() - height + 2.0;
    painter.line_segment([pos2(x, top), pos2(x, bar.bottom())], Stroke::new(1.2, palette.text));
    let tip = |dx: f32, dy: f32| Pos2::new(x + dx, top + dy);
    painter.add(Shape::convex_polygon(
        vec![tip(-3.5, -4.0), tip(3.5, -4.0), tip(0.0, 1.0)],
        palette.text,
        Stroke::NONE,
    ));
}

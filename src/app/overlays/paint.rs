//! Painting of the overlays over a viewport's mesh: ticks on the outline, paths of walks, bars along the boundary.

use crate::app::plots::Plots;
use crate::app::theme::Palette;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::language::{key, say, tr};
use crate::model::Model;
use crate::model::overlays::disk_comparison::{DiskComparison, Found};
use crate::model::overlays::overlay::Origin;
use crate::model::overlays::walks::{Bar, Walks};
use crate::outline::BoundarySamples;
use crate::session::DiskWay;
use egui::{Color32, CornerRadius, FontId, Painter, Pos2, Rect, Stroke, Ui, Vec2, vec2};

/// The length of a tick on either side of the outline, in points.
const TICK: f32 = 11.0;
/// The height of the bar of the largest harmonic measure, in points.
const BAR: f32 = 30.0;
/// The height limit of a bar: with few hits, one bin of the boundary may have many times its share.
const HIGHEST_BAR: f32 = 1.5 * BAR;

/// The growth of a tick with every further image at its place, the limit of its height (both in points), and the number
/// of images from which their count is written beside it.
const HEAP_STEP: f32 = 1.4;
const HIGHEST_HEAP: f32 = 70.0;
const COUNTED_HEAP: usize = 5;
/// Points nearer than this fraction of the length are at one place: a pixel of an outline 2000 pixels long.
const SAME_PLACE: f64 = 5e-4;

/// The shorter side of a viewport from which ticks and bars have their full size, and their least scale below that.
const FULL_SIZE: f32 = 440.0;
const SMALLEST: f32 = 0.45;

/// From the middle of the outline's stroke to the beginning of ticks and bars, in points.
const CLEARANCE: f32 = 2.0;
/// The extent of the ticks on the inside.
const INWARDS: [f32; 2] = [-CLEARANCE, -TICK];
/// From the ticks of one way through the disk to those of the next: a tick, its dots, and a gap.
const LANE: f32 = TICK + 9.0;

/// Paints the overlays of a side, where they are defined; nothing over a coarse draft, which they do not belong to.
pub fn show(ui: &Ui, side: Side, model: &Model, view: &View) {
    let (Some(disk), Some(steps)) = (model.disk_comparison(), model.walks()) else { return };
    let map = model.map().filter(|_| !model.is_draft());
    let Some((map, domain)) = map.and_then(|map| Some((map, map.domain(side)?))) else { return };
    let size = (view.rect.size().min_elem() / FULL_SIZE).clamp(SMALLEST, 1.0);
    let outline = Outline { samples: domain.samples(), view, size };
    let painter = ui.painter_at(view.rect);
    let dark = ui.visuals().dark_mode;
    if side == Side::Source {
        walks(&painter, &outline, steps, dark, Palette::of(ui.visuals()).text);
    }
    if side == map.direction().mapped_side() {
        equal_steps(&painter, &outline, disk, dark);
    } else {
        comparisons(&painter, &outline, disk, dark);
    }
}

/// The legend of a side's ticks and bars: colors and names.
pub fn legend(side: Side, model: &Model, dark: bool) -> Vec<(Color32, &'static str)> {
    let mut entries = Vec::new();
    let ways = model.disk_comparison().into_iter().flat_map(DiskComparison::all_found);
    let ways: Vec<DiskWay> = ways.map(|(way, _)| way).collect();
    if !ways.is_empty() {
        let is_mapped = model.map().is_some_and(|map| side == map.direction().mapped_side());
        let direct = if is_mapped { key::sixty_equal_steps() } else { key::their_images() };
        entries.push((Plots::map_ink(dark), tr(direct)));
        if !is_mapped {
            let entry = |way| (Plots::overlay_ink(Origin::Disk(way), dark), tr(Origin::Disk(way).short_name()));
            entries.extend(ways.into_iter().map(entry));
        }
    }
    if side == Side::Source && model.walks().is_some_and(|walks| walks.count() > 0) {
        entries.push((Plots::overlay_ink(Origin::Walks, dark), tr(Origin::Walks.short_name())));
    }
    entries
}

/// A side's boundary on the screen.
struct Outline<'a> {
    samples: &'a BoundarySamples,
    view: &'a View,
    /// The scale of ticks and bars: 1, less in a small viewport.
    size: f32,
}

impl Outline<'_> {
    /// The place at a fraction of arc length, and the outward unit normal there, on the screen.
    fn at(&self, fraction: f64) -> (Pos2, Vec2) {
        let point = self.samples.at_fraction(fraction);
        let edge = point.edge() as usize;
        let [a, b] = [edge, (edge + 1) % self.samples.len()].map(|k| self.samples.points()[k]);
        let along = (b - a).normalize_or_zero();
        // The outline is counter-clockwise: its outside is on the right. On the screen y points down.
        let out = Vec2::new(along.y as f32, along.x as f32);
        (self.view.to_screen(self.samples.position(point)), out)
    }

    /// A line along the normal, from `from` to `to` points outside the outline, times the scale.
    fn spoke(&self, painter: &Painter, fraction: f64, [from, to]: [f32; 2], mut stroke: Stroke) {
        let (place, out) = self.at(fraction);
        stroke.width *= self.size;
        painter.line_segment([place + from * self.size * out, place + to * self.size * out], stroke);
    }
}

/// Ticks on the inside of the mapped side, at equal steps of ω.
fn equal_steps(painter: &Painter, outline: &Outline, disk: &DiskComparison, dark: bool) {
    let Some((_, found)) = disk.all_found().next() else { return };
    for mark in &found.marks {
        outline.spoke(painter, mark.from, INWARDS, Stroke::new(2.0, Plots::map_ink(dark)));
    }
}

/// Ticks on the inside: the images of the mapped side's steps under riemap's map. Ticks on the outside, in a lane for
/// each way: their images through the disk.
fn comparisons(painter: &Painter, outline: &Outline, disk: &DiskComparison, dark: bool) {
    let lanes = disk.all_found().count();
    for (lane, (way, found)) in disk.all_found().enumerate() {
        let ink = Plots::overlay_ink(Origin::Disk(way), dark);
        let highest = if lane + 1 < lanes { LANE - 2.0 * CLEARANCE } else { HIGHEST_HEAP };
        images(painter, outline, found, Lane { ink, base: LANE * lane as f32, highest });
    }
    let Some((_, found)) = disk.all_found().next() else { return };
    for mark in &found.marks {
        outline.spoke(painter, mark.direct, INWARDS, Stroke::new(2.0, Plots::map_ink(dark)));
    }
}

/// The band outside the outline in which the ticks of one way through the disk are drawn.
#[derive(Clone, Copy)]
struct Lane {
    ink: Color32,
    /// Its distance from the outline, in points.
    base: f32,
    highest: f32,
}

fn images(painter: &Painter, outline: &Outline, found: &Found, Lane { ink, base, highest }: Lane) {
    for &image in &found.images {
        let (place, out) = outline.at(image);
        let center = place + outline.size * (base + TICK + 3.5) * out;
        painter.circle_filled(center, 1.3 * outline.size, ink.gamma_multiply(0.5));
    }
    for (fraction, count) in heaps(found) {
        let height = (TICK + HEAP_STEP * (count - 1) as f32).min(highest);
        outline.spoke(painter, fraction, [base + CLEARANCE, base + height], Stroke::new(2.0, ink));
        if count >= COUNTED_HEAP {
            let (place, out) = outline.at(fraction);
            let text = say(&key::of(count, found.marks.len()));
            label(painter, place + (outline.size * (base + height) + 14.0) * out, &text, ink);
        }
    }
}

/// A text on a filled background, moved into the viewport.
fn label(painter: &Painter, center: Pos2, text: &str, ink: Color32) {
    let galley = painter.layout_no_wrap(text.into(), FontId::proportional(12.0), Color32::WHITE);
    let room = painter.clip_rect().shrink2(0.5 * galley.size() + vec2(10.0, 8.0));
    let place = Rect::from_center_size(center.clamp(room.min, room.max), galley.size());
    painter.rect_filled(place.expand2(vec2(5.0, 2.0)), CornerRadius::same(5), ink.lerp_to_gamma(Color32::BLACK, 0.45));
    painter.galley(place.min, galley, Color32::WHITE);
}

/// The marks' images through the disk, grouped where they are closer than [`SAME_PLACE`]: place and count.
fn heaps(found: &Found) -> Vec<(f64, usize)> {
    let mut places: Vec<f64> = found.marks.iter().map(|mark| mark.through_disk).collect();
    places.sort_unstable_by(f64::total_cmp);
    places.chunk_by(|a, b| b - a < SAME_PLACE).map(|heap| (heap[heap.len() / 2], heap.len())).collect()
}

fn walks(painter: &Painter, outline: &Outline, walks: &Walks, dark: bool, text: Color32) {
    let ink = Plots::overlay_ink(Origin::Walks, dark);
    bars(painter, outline, &walks.bars(), ink, text);
    let recent = walks.recent();
    let count = recent.len();
    for (k, hit) in recent.enumerate() {
        let place = outline.view.to_screen(hit);
        // older hits are fainter
        let strength = 0.15 + 0.75 * (k + 1) as f32 / count as f32;
        painter.circle_filled(place, 2.2 * outline.size, ink.gamma_multiply(strength));
    }
    path(painter, outline, walks, ink, text);
}

/// A bar for the share of hits of each bin, and a cap at its limit, the bin's harmonic measure.
fn bars(painter: &Painter, outline: &Outline, bars: &[Bar], ink: Color32, text: Color32) {
    for bar in bars {
        let height = (BAR * bar.hits as f32).min(HIGHEST_BAR);
        if height > 0.5 {
            outline.spoke(painter, bar.at, [CLEARANCE, CLEARANCE + height], Stroke::new(4.0, ink.gamma_multiply(0.8)));
        }
    }
    for bar in bars.iter().filter(|bar| f64::from(BAR) * bar.expected > 1.0) {
        let (place, out) = outline.at(bar.at);
        let (middle, half) =
            (place + outline.size * (CLEARANCE + BAR * bar.expected as f32) * out, 3.5 * outline.size * out.rot90());
        painter.line_segment([middle - half, middle + half], Stroke::new(1.5 * outline.size, text));
    }
}

fn path(painter: &Painter, outline: &Outline, walks: &Walks, ink: Color32, text: Color32) {
    let (circles, hit) = walks.path();
    let view = outline.view;
    for circle in circles {
        let place = view.to_screen(circle.centre);
        let edge = view.to_screen(circle.centre + glam::DVec2::new(circle.radius, 0.0));
        let radius = place.distance(edge);
        // a light and a dark stroke: visible on every cell of a pattern
        painter.circle_stroke(place, radius, Stroke::new(2.5, Color32::from_black_alpha(60)));
        painter.circle_stroke(place, radius, Stroke::new(1.0, text.gamma_multiply(0.5)));
    }
    let mut places: Vec<Pos2> = circles.iter().map(|circle| view.to_screen(circle.centre)).collect();
    places.extend(hit.map(|hit| view.to_screen(hit)));
    for pair in places.windows(2) {
        painter.line_segment([pair[0], pair[1]], Stroke::new(4.0, Color32::from_black_alpha(120)));
    }
    for pair in places.windows(2) {
        painter.line_segment([pair[0], pair[1]], Stroke::new(2.0, ink));
    }
    for place in &places[1.min(places.len())..] {
        painter.circle_filled(*place, 2.5, ink);
    }
}

//! The coordinates u and v of a surface's layout, drawn over the outline in which the layout lies: the unit square with
//! its grid and numbered axes, and the seams: the outline and the holes of the surface.
//!
//! The coordinates are those that a saved surface gets ([`flattened`] with the settings of the export window), so that a
//! line at u = 0.2 goes through the texels with that coordinate.

use crate::app::theme::Palette;
use crate::app::theme::widgets::caption_font;
use crate::app::viewport::view::{Margins, View};
use crate::conformal::Side;
use crate::export::Placement;
use crate::geometry::DVec2;
use crate::language::number;
use crate::model::Model;
use crate::model::export::flattened;
use crate::model::export::request::Layout;
use egui::{Align2, Painter, Pos2, Rect, Shape, Stroke, Ui, vec2};

/// The lines of the grid in each direction beside the first.
const LINES: u32 = 10;
/// The least distance between two numbers at an axis, in points; else only the ends are numbered.
const BETWEEN_NUMBERS: f32 = 44.0;
/// From an axis to its numbers, in points.
const BESIDE_AXIS: f32 = 5.0;
/// The room of the numbers beside and below the grid, in points.
const NUMBER_ROOM: [f32; 2] = [38.0, 22.0];
/// The strengths of the grid's lines and of the square's edges, and their widths in points.
const GRID: (f32, f32) = (0.4, 1.0);
const EDGE: (f32, f32) = (0.9, 1.5);
/// The lengths of the dashes and gaps around a hole, in points.
const DASHES: [f32; 2] = [6.0, 4.0];

/// Whether the coordinates are shown, and where they lie.
#[derive(Debug, Default)]
pub struct UvGrid {
    /// Whether they are shown.
    pub is_shown: bool,
    /// The map and the settings that `placement` is of.
    of: Option<(u64, Layout)>,
    placement: Option<Placement>,
}

impl UvGrid {
    /// Follows the map at rest; while it moves, the last coordinates stay.
    pub fn update(&mut self, model: &Model, layout: Layout) {
        let wanted = (model.generation(), layout);
        if !self.is_shown || self.of == Some(wanted) || (self.placement.is_some() && !model.is_ready()) {
            return;
        }
        self.of = Some(wanted);
        self.placement = flattened(model, layout).map(|flattened| flattened.placement);
    }

    /// What a fitted view of a side shows: `extent`, its outline's lower left and upper right corner, and with it the unit
    /// square where that is drawn.
    pub fn seen(&self, model: &Model, side: Side, extent: Option<(DVec2, DVec2)>) -> Option<(DVec2, DVec2)> {
        let (low, high) = extent?;
        let placement = self.placement.filter(|_| self.is_shown && model.abilities().has_layout());
        let Some(placement) = placement.filter(|_| model.abilities().has_outline(side)) else { return extent };
        let corners = [DVec2::ZERO, DVec2::ONE].map(|corner| placement.position(corner));
        Some((low.min(corners[0]).min(corners[1]), high.max(corners[0]).max(corners[1])))
    }

    /// The margins of a fitted view that shows the unit square: with room for the numbers around it.
    pub fn margins(&self, model: &Model, side: Side, margins: Margins) -> Margins {
        let is_there = self.is_shown && self.placement.is_some() && model.abilities().has_layout();
        if !is_there || !model.abilities().has_outline(side) {
            return margins;
        }
        let bottom = margins.bottom + NUMBER_ROOM[1];
        Margins { sides: margins.sides.max(NUMBER_ROOM[0]), bottom, ..margins }
    }

    /// Paints the coordinates over the outline of the layout; nothing on the surface's side.
    pub fn paint(&self, ui: &Ui, side: Side, model: &Model, view: &View) {
        let Some(placement) = self.placement.filter(|_| self.is_shown && model.abilities().has_layout()) else {
            return;
        };
        let Some(map) = model.map().filter(|map| map.mapped_side() == side.other()) else { return };
        let painter = ui.painter_at(view.rect);
        let at = |u: f64, v: f64| view.to_screen(placement.position(DVec2::new(u, v)));
        grid(ui, &painter, at);
        for (place, align, text) in numbers(view.rect, at) {
            word(ui, &painter, place, align, text);
        }
        let Some(surface) = map.mapped().surface() else { return };
        for hole in surface.holes() {
            let places: Vec<DVec2> =
                hole.iter().chain(hole.first()).filter_map(|&v| map.images().get(v as usize).copied()).collect();
            seam(ui, &painter, &places.iter().map(|&place| view.to_screen(place)).collect::<Vec<_>>());
        }
    }
}

fn grid(ui: &Ui, painter: &Painter, at: impl Fn(f64, f64) -> Pos2) {
    let ink = Palette::of(ui.visuals()).text;
    for k in 0..=LINES {
        let part = f64::from(k) / f64::from(LINES);
        let (strength, width) = if k == 0 || k == LINES { EDGE } else { GRID };
        let stroke = Stroke::new(width, ink.gamma_multiply(strength));
        painter.line_segment([at(part, 0.0), at(part, 1.0)], stroke);
        painter.line_segment([at(0.0, part), at(1.0, part)], stroke);
    }
}

/// A number at an axis: the point that it is beside, on which side of that it lies, and its words.
type AxisNumber = (Pos2, Align2, String);

/// The numbers at the axes in `seen`, outside of the grid: every fifth of the way where there is room, else at the ends and
/// in the middle; the last one names its axis. The last of v is above the grid, since beside it there is less room.
fn numbers(seen: Rect, at: impl Fn(f64, f64) -> Pos2) -> Vec<AxisNumber> {
    let parts = if at(0.0, 0.0).distance(at(1.0, 0.0)) >= 5.0 * BETWEEN_NUMBERS { 5 } else { 2 };
    let part = |k: u32| f64::from(k) / f64::from(parts);
    let below = |k: u32| (at(part(k), 0.0) + vec2(0.0, BESIDE_AXIS), Align2::CENTER_TOP);
    let beside = |k: u32| match at(0.0, part(k)) {
        corner if k == parts => (corner - vec2(0.0, BESIDE_AXIS), Align2::CENTER_BOTTOM),
        place => (place - vec2(BESIDE_AXIS, 0.0), Align2::RIGHT_CENTER),
    };
    let axis = |name: &str, from: u32, place: &dyn Fn(u32) -> (Pos2, Align2)| -> Vec<AxisNumber> {
        let seen: Vec<u32> = (from..=parts).filter(|&k| seen.contains(place(k).0)).collect();
        let words = |k: u32| match number(part(k), 1) {
            text if seen.last() == Some(&k) => format!("{name} = {text}"),
            text => text,
        };
        seen.iter().map(|&k| (place(k).0, place(k).1, words(k))).collect()
    };
    [axis("u", 0, &below), axis("v", 1, &beside)].concat()
}

/// A word on a ground that keeps it readable over any pattern, moved into the viewport.
fn word(ui: &Ui, painter: &Painter, at: Pos2, align: Align2, text: String) {
    let palette = Palette::of(ui.visuals());
    let galley = painter.layout_no_wrap(text, caption_font(ui), palette.text);
    let area = align.anchor_size(at, galley.size()).expand2(vec2(3.0, 1.0));
    let clip = painter.clip_rect();
    let moved = (area.min.max(clip.min)).min(clip.max - area.size());
    let area = Rect::from_min_size(moved, area.size());
    painter.rect_filled(area, 4, palette.canvas.gamma_multiply(0.85));
    painter.galley(area.min + vec2(3.0, 1.0), galley, palette.text);
}

/// The edge of a hole.
fn seam(ui: &Ui, painter: &Painter, points: &[Pos2]) {
    let palette = Palette::of(ui.visuals());
    painter.line(points.to_vec(), Stroke::new(4.0, palette.canvas));
    painter.extend(Shape::dashed_line(points, Stroke::new(2.0, palette.accent), DASHES[0], DASHES[1]));
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::export::FileFormat;
    use crate::model::export::{FileRequest, file};
    use crate::model::scene::Offscreen;
    use crate::outline::Preset;
    use crate::session::{Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec};
    use crate::surface::SurfacePreset;

    #[test]
    fn the_grid_lies_where_the_saved_coordinates_say() {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
        let session = Session::with([
            Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Square) },
            Command::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) },
        ]);
        let model = Offscreen::new(&session, [None, None].into(), 1.0).unwrap().into_model();
        let placement = |layout: Layout| {
            let mut grid = UvGrid { is_shown: true, ..UvGrid::default() };
            grid.update(&model, layout);
            grid.placement.unwrap()
        };
        for layout in [true, false].map(|unit| Layout { unit, corners: false }) {
            let request = FileRequest { format: FileFormat::Obj, side: None, unit: layout.unit, corners: false };
            let saved = String::from_utf8(file(&model, request, None).unwrap().unwrap().bytes).unwrap();
            let coordinates = saved.lines().filter_map(|line| line.strip_prefix("vt ")).map(|line| {
                let mut numbers = line.split(' ').map(|number| number.parse().unwrap());
                DVec2::new(numbers.next().unwrap(), numbers.next().unwrap())
            });
            for (uv, place) in coordinates.zip(model.map().unwrap().texture_coordinates()) {
                let error = placement(layout).position(uv).distance(place.unwrap());
                assert!(error < 1e-12, "{layout:?}: {uv} lies {error:e} from {place:?}");
            }
        }
        // where the layout hits the outline's corners, the unit square is the outline
        let (low, high) = model.extent(Side::Source).unwrap();
        let whole = placement(Layout { unit: true, corners: true });
        let errors = [whole.position(DVec2::ZERO) - low, whole.position(DVec2::ONE) - high];
        assert!(errors.iter().all(|error| error.length() < 1e-9), "{errors:?}");
    }

    #[test]
    fn the_numbers_of_the_axes_lie_outside_of_the_grid() {
        let square = Rect::from_min_max(egui::pos2(40.0, 60.0), egui::pos2(340.0, 360.0));
        let at = |u: f64, v: f64| square.left_bottom() + 300.0 * vec2(u as f32, -v as f32);
        let numbers = numbers(Rect::from_min_max(Pos2::ZERO, egui::pos2(380.0, 420.0)), at);
        let named: Vec<&str> =
            numbers.iter().map(|(.., text)| text.as_str()).filter(|text| text.contains('=')).collect();
        assert_eq!(named, ["u = 1.0", "v = 1.0"]);
        for (place, align, text) in numbers {
            let area = align.anchor_size(place, vec2(44.0, 16.0));
            assert!(!area.intersects(square), "{text} at {area:?}");
        }
    }

    #[test]
    fn a_fitted_view_shows_the_whole_unit_square() {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
        let session = Session::with([Command::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) }]);
        let model = Offscreen::new(&session, [None, None].into(), 1.0).unwrap().into_model();
        let mut grid = UvGrid::default();
        let extent = model.extent(Side::Source);
        assert_eq!(grid.seen(&model, Side::Source, extent), extent, "not shown");
        grid.is_shown = true;
        grid.update(&model, Layout { unit: true, corners: false });
        let (low, high) = grid.seen(&model, Side::Source, extent).unwrap();
        let square = [DVec2::ZERO, DVec2::ONE].map(|corner| grid.placement.unwrap().position(corner));
        for corner in square.into_iter().chain(extent.map(|(low, high)| [low, high]).unwrap()) {
            assert!(corner.cmpge(low).all() && corner.cmple(high).all(), "{corner} from {low} to {high}");
        }
        // the gingerbread man is higher than wide, a square is not
        assert!((high - low).x > 1.05 * extent.map(|(low, high)| high - low).unwrap().x);
        assert_eq!(grid.seen(&model, Side::Target, None), None);
    }
}

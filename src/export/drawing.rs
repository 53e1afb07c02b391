//! A planar map as SVG: outlines, the lines of a pattern, mesh edges, and the points of the constraints.
//!
//! The domains lie side by side, each in its own group, whose elements have the classes `outline`, `unresolved`
//! (hatching), `mesh`, `lines`, `interior` and `boundary`, or `pin` with its number. The first closed path is the first domain's outline, so
//! that the drawing can be loaded as an outline.

use super::hatching::{hatching, spacing};
use super::polylines::Line;
use super::ruling::{FAMILIES, Ruling};
use crate::conformal::{ConformalMap, Constraints, Direction, MeshedDomain, PerSide, Side};
use crate::geometry::{Bounds, DVec2, DVec3};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// One domain of the drawing.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Panel<'a> {
    /// The positions of the vertices in the drawing.
    pub positions: &'a [DVec2],
    /// The coordinates of the vertices in which the lines of the pattern are defined.
    pub coordinates: &'a [DVec2],
    /// The triangles.
    pub triangles: &'a [[u32; 3]],
    /// The outline.
    pub boundary: &'a [DVec2],
    /// The parts that images do not cover, to be hatched.
    pub unresolved: &'a [Vec<DVec2>],
    /// The interior and the boundary point.
    pub handles: [DVec2; 2],
    /// The pins in their place, in the plane z = 0; empty: there are none.
    pub pins: &'a [DVec3],
}

/// The panels of source and target; the target has source coordinates. `None` if one of them is a surface.
pub fn panels<'a>(map: &'a ConformalMap, constraints: &Constraints) -> Option<PerSide<Panel<'a>>> {
    let [source, target] = [map.domain(Side::Source)?, map.domain(Side::Target)?];
    let handles = |side: Side, domain: &MeshedDomain| -> Option<[DVec2; 2]> {
        let anchor = map.side(side).at_fraction(constraints.anchors[side]);
        Some([constraints.points[side].in_plane()?, domain.samples().position(anchor)])
    };
    let (positions, coordinates) = match map.direction() {
        Direction::Forward => (map.images(), source.mesh().vertices()),
        Direction::Backward => (target.mesh().vertices(), map.images()),
    };
    Some(PerSide::new(
        Panel {
            positions: source.mesh().vertices(),
            coordinates: source.mesh().vertices(),
            triangles: source.mesh().triangles(),
            boundary: map.drawn_outline(Side::Source),
            unresolved: map.unresolved(Side::Source),
            handles: handles(Side::Source, source)?,
            pins: &[],
        },
        Panel {
            positions,
            coordinates,
            triangles: map.mapped().triangles(),
            boundary: map.drawn_outline(Side::Target),
            unresolved: map.unresolved(Side::Target),
            handles: handles(Side::Target, target)?,
            pins: &[],
        },
    ))
}

/// The planar parts of a map: both outlines; with one surface the outline and the surface's mesh as mapped into it;
/// between two surfaces both meshes as mapped into the unit disk. Empty before the map's first update.
pub fn parts<'a>(map: &'a ConformalMap, constraints: &Constraints) -> Vec<Part<'a>> {
    if map.images().is_empty() {
        return Vec::new();
    }
    if let Some(PerSide { source, target }) = panels(map, constraints) {
        return vec![
            Part { side: Side::Source, panel: source, wire: None },
            Part { side: Side::Target, panel: target, wire: None },
        ];
    }
    Side::BOTH.into_iter().filter_map(|side| part_with_surface(map, constraints, side)).collect()
}

fn part_with_surface<'a>(map: &'a ConformalMap, constraints: &Constraints, side: Side) -> Option<Part<'a>> {
    if let Some(places) = map.disk(side) {
        let triangles = map.side(side).triangles();
        let boundary = &places[..map.side(side).boundary_count()];
        let panel = Panel {
            positions: places,
            coordinates: places,
            triangles,
            boundary,
            unresolved: &[],
            handles: [DVec2::ZERO, DVec2::X],
            pins: &[],
        };
        return Some(Part { side, panel, wire: Some((places, triangles)) });
    }
    let domain = map.domain(side)?;
    let (vertices, triangles) = (domain.mesh().vertices(), domain.mesh().triangles());
    let anchor = domain.samples().position(map.side(side).at_fraction(constraints.anchors[side]));
    let panel = Panel {
        positions: vertices,
        coordinates: vertices,
        triangles,
        boundary: domain.samples().points(),
        unresolved: &[],
        handles: [constraints.points[side].in_plane()?, anchor],
        pins: &[],
    };
    Some(Part { side, panel, wire: Some((map.images(), map.mapped().triangles())) })
}

/// Side length of a panel in the drawing's units.
const PANEL: f64 = 480.0;
const MARGIN: f64 = 16.0;

/// The colors of the pattern's two families of lines, and of the outline.
pub(super) const LINE_COLORS: [&str; FAMILIES] = ["#b5532a", "#2a6f97"];
pub(super) const OUTLINE_COLOR: &str = "#1b1b1f";
const MESH_COLOR: &str = "#8b8f97";
/// The colors of the interior and the boundary point.
pub(super) const POINT_COLORS: [&str; 2] = ["#009e73", "#d63ca6"];

/// The radius of a pin: its number has two digits at most.
const PIN_RADIUS: u32 = 8;

/// A mesh whose edges are drawn: positions and triangles.
pub type Wire<'a> = (&'a [DVec2], &'a [[u32; 3]]);

/// A domain of the drawing with its settings.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Part<'a> {
    /// The domain.
    pub side: Side,
    /// Its mesh, outline and points as drawn.
    pub panel: Panel<'a>,
    /// The mesh whose edges are drawn, if any.
    pub wire: Option<Wire<'a>>,
}

/// An SVG document with the parts from left to right, and the lines of `ruling` if there is one.
pub fn svg(parts: &[Part<'_>], ruling: Option<Ruling>) -> String {
    let mut text = opening(parts.len());
    for (k, part) in parts.iter().enumerate() {
        part.draw(&mut text, Placement::in_panel(k, part.panel.bounds()), ruling);
    }
    text.push_str("</svg>\n");
    text
}

/// The first line of a document with this number of panels.
pub(super) fn opening(panels: usize) -> String {
    let width = PANEL * panels as f64;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {PANEL}\" fill=\"none\" \
         stroke-linejoin=\"round\" stroke-linecap=\"round\">\n"
    )
}

/// Points of an outline less apart than this, in units of the drawing, whose numbers have three decimals, are one.
const DISTINCT: f64 = 0.004;

/// The transformation from a domain to the drawing, where y points down.
#[derive(Clone, Copy)]
pub(super) struct Placement {
    middle: DVec2,
    scale: f64,
    corner: DVec2,
}

impl Placement {
    /// The one that fits a box, from its lower left to its upper right corner, into the panel that is number `k` from the
    /// left.
    pub fn in_panel(k: usize, (low, high): (DVec2, DVec2)) -> Self {
        let scale = (PANEL - 2.0 * MARGIN) / (high - low).max_element();
        Self { middle: 0.5 * (low + high), scale, corner: DVec2::new((k as f64 + 0.5) * PANEL, 0.5 * PANEL) }
    }

    pub fn of(self, p: DVec2) -> DVec2 {
        let q = (p - self.middle) * self.scale;
        self.corner + DVec2::new(q.x, -q.y)
    }

    /// The points of a closed line that differ in the drawing: a refined outline has some that its numbers do not tell
    /// apart, and whoever reads it as an outline would find them repeated.
    pub fn distinct(self, points: &[DVec2]) -> Vec<DVec2> {
        let least = DISTINCT / self.scale;
        let mut kept: Vec<DVec2> = Vec::with_capacity(points.len());
        for &p in points {
            if kept.last().is_none_or(|last| last.distance(p) >= least) {
                kept.push(p);
            }
        }
        while kept.len() > 3 && kept[0].distance(kept[kept.len() - 1]) < least {
            kept.pop();
        }
        kept
    }

    /// Appends the data of a path through `points`.
    pub fn path(self, text: &mut String, points: impl IntoIterator<Item = DVec2>, is_closed: bool) {
        for (k, p) in points.into_iter().enumerate() {
            let p = self.of(p);
            let _ = write!(text, "{}{:.3} {:.3}", if k == 0 { 'M' } else { 'L' }, p.x, p.y);
        }
        if is_closed {
            text.push('Z');
        }
    }
}

impl Panel<'_> {
    /// Lower left and upper right corner of the outline.
    pub fn bounds(&self) -> (DVec2, DVec2) {
        let [low, high] = Bounds::of(self.boundary.iter().copied()).corners();
        (low, high)
    }
}

impl Part<'_> {
    fn draw(&self, text: &mut String, placement: Placement, ruling: Option<Ruling>) {
        let Self { side, panel, wire } = self;
        text.push_str("<g class=\"domain\">\n");
        let _ =
            write!(text, "<path id=\"{side}\" class=\"outline\" stroke=\"{OUTLINE_COLOR}\" stroke-width=\"1.5\" d=\"");
        placement.path(text, placement.distinct(panel.boundary), true);
        text.push_str("\"/>\n");
        self.hatch(text, placement);
        if let Some(ruling) = ruling {
            for (family, colour) in LINE_COLORS.into_iter().enumerate() {
                let lines = ruling.lines(family, panel.positions, panel.coordinates, panel.triangles);
                draw_lines(text, placement, colour, &lines);
            }
        }
        if let Some((positions, triangles)) = wire {
            let _ = write!(text, "<path class=\"mesh\" stroke=\"{MESH_COLOR}\" stroke-width=\"0.3\" d=\"");
            for (a, b) in inner_edges(triangles) {
                placement.path(text, [a, b].map(|v| positions[v as usize]), false);
            }
            text.push_str("\"/>\n");
        }
        draw_dots(text, panel, placement);
        text.push_str("</g>\n");
    }
}

/// Draws the interior and the boundary point, or the pins with their numbers.
fn draw_dots(text: &mut String, panel: &Panel<'_>, placement: Placement) {
    let mut dot = |class: &str, colour: &str, place: DVec2, radius: u32| {
        let p = placement.of(place);
        let _ = writeln!(
            text,
            "<circle class=\"{class}\" cx=\"{:.3}\" cy=\"{:.3}\" r=\"{radius}\" fill=\"{colour}\" stroke=\"white\" \
             stroke-width=\"2\"/>",
            p.x, p.y
        );
        p
    };
    if panel.pins.is_empty() {
        for ((&place, colour), class) in panel.handles.iter().zip(POINT_COLORS).zip(["interior", "boundary"]) {
            dot(class, colour, place, 6);
        }
        return;
    }
    let places: Vec<DVec2> =
        panel.pins.iter().map(|pin| dot("pin", POINT_COLORS[1], pin.truncate(), PIN_RADIUS)).collect();
    for (p, number) in places.into_iter().zip(1..) {
        let _ = writeln!(
            text,
            "<text x=\"{:.3}\" y=\"{:.3}\" font-size=\"10\" font-family=\"sans-serif\" text-anchor=\"middle\" \
             fill=\"white\">{number}</text>",
            p.x,
            p.y + 3.5
        );
    }
}

impl Part<'_> {
    /// Hatches what images do not cover.
    fn hatch(&self, text: &mut String, placement: Placement) {
        let spacing = spacing(self.panel.boundary);
        for part in self.panel.unresolved {
            let _ = write!(text, "<path class=\"unresolved\" stroke=\"{OUTLINE_COLOR}\" stroke-width=\"0.8\" d=\"");
            let chord = [part.first(), part.last()].into_iter().flatten().copied();
            placement.path(text, chord, false);
            for segment in hatching(part, spacing) {
                placement.path(text, segment, false);
            }
            text.push_str("\"/>\n");
        }
    }
}

/// Writes each line as a path of its own, so that lines can be selected one by one.
fn draw_lines(text: &mut String, placement: Placement, colour: &str, lines: &[Line]) {
    let _ = writeln!(text, "<g class=\"lines\" stroke=\"{colour}\" stroke-width=\"0.8\">");
    for line in lines {
        text.push_str("<path d=\"");
        placement.path(text, line.points.iter().copied(), line.is_closed);
        text.push_str("\"/>\n");
    }
    text.push_str("</g>\n");
}

/// The edges shared by two triangles, each once; the remaining ones form the outline.
fn inner_edges(triangles: &[[u32; 3]]) -> impl Iterator<Item = (u32, u32)> {
    let directed = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let all: BTreeSet<_> = directed.collect();
    let inner: Vec<_> = all.iter().copied().filter(|&(a, b)| a < b && all.contains(&(b, a))).collect();
    inner.into_iter()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

//! A map as vector graphics: both outlines, and a line grid of the source in both.
//!
//! A grid line is a level set of a source coordinate; on a triangle it is a
//! straight segment (marching triangles). The same code draws the source, whose
//! coordinates are its own positions, and the target, forward or backward.

use crate::conformal::{ConformalMap, Constraints, Direction, PreparedDomain, Side};
use crate::geometry::{Bounds, DVec2};
use std::fmt::Write as _;

/// What one half of the drawing shows.
pub struct Panel<'a> {
    /// Where the vertices are drawn.
    pub positions: &'a [DVec2],
    /// Their source coordinates.
    pub coordinates: &'a [DVec2],
    /// The triangles.
    pub triangles: &'a [[u32; 3]],
    /// The outline.
    pub boundary: &'a [DVec2],
    /// The interior and the boundary handle.
    pub handles: [DVec2; 2],
}

/// Source and target as drawn: the target's surface carries source coordinates.
pub fn panels<'a>(map: &'a ConformalMap, constraints: &Constraints) -> [Panel<'a>; 2] {
    let [source, target] = Side::BOTH.map(|side| map.domain(side));
    let handles = |side: Side, domain: &PreparedDomain| {
        let anchor = domain.samples.at_fraction(constraints.anchor(side));
        [constraints.point(side), domain.samples.position(anchor)]
    };
    let (positions, coordinates) = match map.direction() {
        Direction::Forward => (map.images(), source.mesh.vertices.as_slice()),
        Direction::Backward => (target.mesh.vertices.as_slice(), map.images()),
    };
    [
        Panel {
            positions: &source.mesh.vertices,
            coordinates: &source.mesh.vertices,
            triangles: &source.mesh.triangles,
            boundary: &source.samples.points,
            handles: handles(Side::Source, source),
        },
        Panel {
            positions,
            coordinates,
            triangles: &map.mapped_mesh().triangles,
            boundary: &target.samples.points,
            handles: handles(Side::Target, target),
        },
    ]
}

/// Side length of a panel in the drawing's units.
const PANEL: f64 = 480.0;
const MARGIN: f64 = 16.0;

/// An SVG document with the two panels side by side and a grid of `cells` across the source's larger side.
pub fn svg(panels: &[Panel<'_>; 2], cells: f64) -> String {
    let (low, high) = panels[0].bounds();
    let spacing = (high - low).max_element() / cells;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {PANEL}\" fill=\"none\" stroke-linejoin=\"round\">\n",
        2.0 * PANEL
    );
    for (panel, left) in panels.iter().zip([0.0, PANEL]) {
        panel.draw(&mut text, left, spacing);
    }
    text.push_str("</svg>\n");
    text
}

impl Panel<'_> {
    /// Lower left and upper right corner of the outline.
    pub fn bounds(&self) -> (DVec2, DVec2) {
        let Bounds { min: low, max: high } = Bounds::of(self.boundary.iter().copied());
        (low, high)
    }

    fn draw(&self, text: &mut String, left: f64, spacing: f64) {
        let (low, high) = self.bounds();
        let scale = (PANEL - 2.0 * MARGIN) / (high - low).max_element();
        let middle = 0.5 * (low + high);
        let place = |p: DVec2| {
            let q = (p - middle) * scale;
            DVec2::new(left + 0.5 * PANEL + q.x, 0.5 * PANEL - q.y)
        };
        for (axis, colour) in ["#b5532a", "#2a6f97"].into_iter().enumerate() {
            let _ = write!(text, "<path stroke=\"{colour}\" stroke-width=\"0.8\" d=\"");
            self.level_sets(axis, spacing, &mut |a, b| {
                let (a, b) = (place(a), place(b));
                let _ = write!(text, "M{:.2} {:.2}L{:.2} {:.2}", a.x, a.y, b.x, b.y);
            });
            text.push_str("\"/>\n");
        }
        text.push_str("<path stroke=\"#1b1b1f\" stroke-width=\"1.5\" d=\"");
        for (k, &p) in self.boundary.iter().enumerate() {
            let p = place(p);
            let _ = write!(text, "{}{:.2} {:.2}", if k == 0 { 'M' } else { 'L' }, p.x, p.y);
        }
        text.push_str("Z\"/>\n");
        for (&p, colour) in self.handles.iter().zip(["#009e73", "#d63ca6"]) {
            let p = place(p);
            let _ = writeln!(
                text,
                "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"6\" fill=\"{colour}\" stroke=\"white\" stroke-width=\"2\"/>",
                p.x, p.y
            );
        }
    }

    /// Emits the segments on which coordinate `axis` is a multiple of `spacing`.
    fn level_sets(&self, axis: usize, spacing: f64, emit: &mut dyn FnMut(DVec2, DVec2)) {
        for triangle in self.triangles {
            let corners = triangle.map(|v| (self.coordinates[v as usize][axis] / spacing, self.positions[v as usize]));
            let low = corners.iter().map(|c| c.0).fold(f64::INFINITY, f64::min);
            let high = corners.iter().map(|c| c.0).fold(f64::NEG_INFINITY, f64::max);
            // a collapsed or huge image would draw every line through one triangle
            let levels = low.ceil() as i64..=high.floor() as i64;
            for level in levels.take(MAX_LEVELS) {
                segment(&corners, level as f64, emit);
            }
        }
    }
}

/// More lines than this through one triangle cannot be told apart.
const MAX_LEVELS: usize = 64;

/// The segment of a triangle on which the linear function through `corners` equals `level`.
fn segment(corners: &[(f64, DVec2); 3], level: f64, emit: &mut dyn FnMut(DVec2, DVec2)) {
    let mut ends = [DVec2::ZERO; 2];
    let mut count = 0;
    for i in 0..3 {
        let ((a, p), (b, q)) = (corners[i], corners[(i + 1) % 3]);
        if (a < level) != (b < level) && count < 2 {
            ends[count] = p.lerp(q, (level - a) / (b - a));
            count += 1;
        }
    }
    if count == 2 {
        emit(ends[0], ends[1]);
    }
}

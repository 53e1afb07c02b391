//! Orthogonal grids as files: a table of nodes, a drawing, a mesh of quadrilaterals, a structured grid.

use super::drawing::{LINE_COLORS, OUTLINE_COLOR, POINT_COLORS, Placement, opening};
use crate::conformal::{OrthogonalGrid, RectangleMap};
use crate::geometry::{Bounds, Curve, DVec2, Piece};
use std::fmt::Write as _;

/// The file format of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GridFormat {
    /// A table: rows `i,j,x,y` under a line with these names, i running fastest.
    Csv,
    /// Vector graphics: the outline, the lines, the corners.
    Svg,
    /// Wavefront: nodes, and the cells as quadrilaterals.
    Obj,
    /// The legacy format of the Visualization Toolkit, ASCII: a structured grid.
    Vtk,
}

impl GridFormat {
    /// All formats.
    pub const ALL: [Self; 4] = [Self::Csv, Self::Svg, Self::Obj, Self::Vtk];

    /// The file extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Svg => "svg",
            Self::Obj => "obj",
            Self::Vtk => "vtk",
        }
    }

    /// The format with this file extension, in upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }

    /// The file of a grid, which `map` has made for a quadrilateral on `curve`.
    pub fn text(self, grid: &OrthogonalGrid, map: &RectangleMap<'_>, curve: &Curve) -> String {
        match self {
            Self::Csv => csv(grid),
            Self::Svg => svg(grid, map, curve),
            Self::Obj => obj(grid),
            Self::Vtk => vtk(grid),
        }
    }
}

fn csv(grid: &OrthogonalGrid) -> String {
    let row_length = grid.cells().counts()[0] as usize + 1;
    let mut text = "i,j,x,y\n".to_owned();
    for (k, node) in grid.nodes().iter().enumerate() {
        let _ = writeln!(text, "{},{},{},{}", k % row_length, k / row_length, node.x, node.y);
    }
    text
}

fn obj(grid: &OrthogonalGrid) -> String {
    let [n, m] = grid.cells().counts();
    let mut text =
        format!("# riemap: an orthogonal grid of {n} x {m} cells; vertex 1 + i + {} j is node (i, j)\n", n + 1);
    for node in grid.nodes() {
        let _ = writeln!(text, "v {} {} 0", node.x, node.y);
    }
    for [a, b, c, d] in grid.quads().map(|quad| quad.map(|node| node + 1)) {
        let _ = writeln!(text, "f {a} {b} {c} {d}");
    }
    text
}

fn vtk(grid: &OrthogonalGrid) -> String {
    let [n, m] = grid.cells().counts();
    let mut text = format!(
        "# vtk DataFile Version 3.0\nriemap: an orthogonal grid\nASCII\nDATASET STRUCTURED_GRID\n\
         DIMENSIONS {} {} 1\nPOINTS {} double\n",
        n + 1,
        m + 1,
        grid.nodes().len()
    );
    for node in grid.nodes() {
        let _ = writeln!(text, "{} {} 0", node.x, node.y);
    }
    text
}

/// Steps in which a curved piece of the outline is drawn.
const STEPS: u32 = 256;

/// The outline's points.
fn drawn(curve: &Curve) -> Vec<DVec2> {
    let points = |piece: &Piece| {
        let steps = if piece.is_straight() { 1 } else { STEPS };
        let place = |k: u32| piece.jet(f64::from(k) / f64::from(steps)).position;
        (0..steps).map(place).collect::<Vec<DVec2>>()
    };
    curve.pieces().iter().flat_map(points).collect()
}

fn svg(grid: &OrthogonalGrid, map: &RectangleMap<'_>, curve: &Curve) -> String {
    let outline = drawn(curve);
    let [low, high] = Bounds::of(outline.iter().copied()).corners();
    let placement = Placement::in_panel(0, (low, high));
    let mut text = opening(1);
    let _ = write!(text, "<path class=\"outline\" stroke=\"{OUTLINE_COLOR}\" stroke-width=\"1.5\" d=\"");
    placement.path(&mut text, placement.distinct(&outline), true);
    text.push_str("\"/>\n");
    for (lines, color) in map.lines(grid.cells(), [1, 1]).into_iter().zip(LINE_COLORS) {
        let _ = writeln!(text, "<g class=\"lines\" stroke=\"{color}\" stroke-width=\"0.8\">");
        for line in lines {
            text.push_str("<path d=\"");
            placement.path(&mut text, line, false);
            text.push_str("\"/>\n");
        }
        text.push_str("</g>\n");
    }
    for corner in grid.corners() {
        let p = placement.of(corner);
        let _ = writeln!(
            text,
            "<circle class=\"corner\" cx=\"{:.3}\" cy=\"{:.3}\" r=\"3\" fill=\"{}\"/>",
            p.x, p.y, POINT_COLORS[1]
        );
    }
    text.push_str("</svg>\n");
    text
}

//! The figure of the ladder: a row for each outline; errors against unknowns, boundary points and milliseconds.

use super::super::figure::plot::{Axis, Curve, Legend, Plot};
use super::super::figure::svg::{Anchor, LABEL, Page, SMALL, Stroke, TITLE, colour};
use crate::figures::{LadderMethod, LadderRow, LadderShape};
use crate::geometry::DVec2;

const LEFT: f64 = 24.0;
/// Above the first row: title, notes and legend.
const HEAD: f64 = 118.0;
/// From one panel to the next, and a panel's frame.
const STEP: DVec2 = DVec2::new(400.0, 262.0);
const FRAME: DVec2 = DVec2::new(315.0, 180.0);
/// Errors below rounding are drawn at it.
const LEAST: f64 = 1e-16;

type Value = fn(&LadderRow) -> f64;

/// What errors are plotted against.
const AXES: [(&str, Value); 3] = [
    ("unknowns", |row| row.unknowns as f64),
    ("points on the boundary, m", |row| row.m as f64),
    ("milliseconds for an outline and a point", |row| row.prepare_ms + row.point_ms),
];

fn ink(method: LadderMethod) -> &'static str {
    match method {
        LadderMethod::Integral => colour::BLUE,
        LadderMethod::AdjointUniform => colour::ORANGE,
        LadderMethod::AdjointDefault => colour::GREEN,
        LadderMethod::Zipper => colour::VERMILLION,
    }
}

/// Draws the figure.
pub fn draw(rows: &[LadderRow], machine: &str) -> String {
    let shown = |shape: &LadderShape| rows.iter().any(|row| row.rung.shape == *shape);
    let shapes: Vec<LadderShape> = LadderShape::ALL.into_iter().filter(shown).collect();
    let size = DVec2::new(LEFT + STEP.x * AXES.len() as f64, HEAD + STEP.y * shapes.len() as f64);
    let mut page = Page::new(size.x, size.y);
    page.text(DVec2::new(LEFT, 30.0), Anchor::Start, TITLE, colour::INK, "Accuracy: largest errors on the boundary");
    page.text(DVec2::new(LEFT, 50.0), Anchor::Start, SMALL, colour::GREY, machine);
    legend(&mut page);
    for (k, &shape) in shapes.iter().enumerate() {
        for (column, axis) in AXES.into_iter().enumerate() {
            let corner = DVec2::new(LEFT + 56.0, HEAD) + STEP * DVec2::new(column as f64, k as f64);
            panel(rows, shape, axis, corner).draw(&mut page);
        }
    }
    page.finish()
}

/// One legend for all panels: colors are methods, dashes are images.
fn legend(page: &mut Page) {
    let mut x = LEFT;
    for method in LadderMethod::ALL {
        page.line([DVec2::new(x, 70.0), DVec2::new(x + 26.0, 70.0)], Stroke::solid(ink(method), 1.8));
        page.dot(DVec2::new(x + 13.0, 70.0), 3.5, ink(method));
        page.text(DVec2::new(x + 34.0, 74.0), Anchor::Start, LABEL, colour::INK, method.title());
        x += 64.0 + 6.9 * method.title().chars().count() as f64;
    }
    let note = "solid: harmonic measure, dashed: images";
    page.text(DVec2::new(x, 74.0), Anchor::Start, LABEL, colour::GREY, note);
}

fn panel(rows: &[LadderRow], shape: LadderShape, (label, x): (&str, Value), corner: DVec2) -> Plot {
    let rows: Vec<&LadderRow> = rows.iter().filter(|row| row.rung.shape == shape).collect();
    let curves: Vec<Curve> = LadderMethod::ALL.into_iter().flat_map(|method| curves(&rows, method, x)).collect();
    let points = || curves.iter().flat_map(|curve| curve.points.iter());
    Plot {
        corner,
        size: FRAME,
        title: shape.title().to_owned(),
        x: Axis::logarithmic(label, points().map(|p| p.x)),
        y: Axis::logarithmic("error", points().map(|p| p.y)),
        curves,
        legend: Legend::None,
    }
}

/// The errors of ω of one method, and those of the images.
fn curves(rows: &[&LadderRow], method: LadderMethod, x: Value) -> Vec<Curve> {
    let of_method = || rows.iter().filter(|row| row.rung.method == method);
    let curve = |points: Vec<DVec2>, dash: &'static str| Curve {
        name: String::new(),
        points,
        stroke: Stroke { colour: ink(method), width: 1.6, dash },
        dots: true,
    };
    let omega = of_method().map(|row| DVec2::new(x(row), row.omega.max.max(LEAST))).collect();
    let image = of_method().filter_map(|row| Some(DVec2::new(x(row), row.image?.max.max(LEAST)))).collect();
    vec![curve(image, "5 4"), curve(omega, "")]
}

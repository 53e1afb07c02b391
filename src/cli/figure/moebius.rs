//! Figure 7: a row for each m with the grid G₁, the reparameterization, f̃(G₁) and f̂(G₁) over G₂.

use super::Drawing;
use super::plot::{Axis, Curve, Legend, Plot, Window};
use super::svg::{Anchor, LABEL, Page, SMALL, Stroke, TITLE, colour};
use crate::cli::CliError;
use crate::figures::{Detail, Figure, GRID_CIRCLES, GRID_RAYS, MoebiusStudy, grid_point};
use crate::geometry::DVec2;
use std::f64::consts::TAU;

/// Points per cell of a grid line, and per edge of a mapped boundary.
const FINE: u32 = 8;
/// Samples of the exact curves.
const CURVE: u32 = 400;

/// Points of the polygon are moved inward by this part: if rounding put one outside, Cauchy's integral would be 0.
const INSET: f64 = 1e-6;

const DISK: f64 = 230.0;
const ROW: f64 = 290.0;
const TOP: f64 = 76.0;
/// Left ends of the columns.
const COLUMNS: [f64; 4] = [24.0, 345.0, 660.0, 920.0];

/// Draws the figure.
pub fn draw(detail: Detail) -> Result<Drawing, CliError> {
    let scenes = Figure::Moebius.scenes(detail);
    let studies = scenes.iter().map(MoebiusStudy::new).collect::<Result<Vec<_>, _>>()?;
    let mut page = Page::new(1180.0, TOP + ROW * studies.len() as f64);
    let title = "Figure 7: a Möbius map of the disk, exact (blue) and approximate (black)";
    page.text(DVec2::new(24.0, 30.0), Anchor::Start, TITLE, colour::INK, title);
    let names = ["", "", "G₁ by the harmonic extension", "G₁ by the Cauchy–Green extension"];
    for (name, left) in names.into_iter().zip(COLUMNS) {
        page.text(DVec2::new(left, 56.0), Anchor::Start, LABEL, colour::INK, name);
    }
    let mut findings = Vec::new();
    for (k, study) in studies.iter().enumerate() {
        let top = TOP + ROW * k as f64;
        let [harmonic, cauchy_green] = study.mean_grid_errors();
        draw_source(&mut page, study, top);
        draw_reparameterization(&mut page, study, top);
        draw_image(&mut page, study, COLUMNS[2], top, &|x| study.harmonic(x));
        draw_image(&mut page, study, COLUMNS[3], top, &|x| Some(study.cauchy_green(x)));
        for (left, error) in [(COLUMNS[2], harmonic), (COLUMNS[3], cauchy_green)] {
            let at = DVec2::new(left + 0.5 * DISK, top + DISK + 20.0);
            page.text(at, Anchor::Middle, SMALL, colour::GREY, &format!("mean error at the nodes {error:.1e}"));
        }
        let m = study.samples().len();
        findings.push(format!(
            "m = {m}: mean error at the nodes, harmonic {harmonic:.2e}, Cauchy–Green {cauchy_green:.2e}"
        ));
    }
    Ok(Drawing { svg: page.finish(), png: None, table: MoebiusStudy::table(&studies), findings })
}

fn disk_window(left: f64, top: f64) -> Window {
    // a little larger than the disk, since f̂ maps slightly outside of it
    let corners = [DVec2::splat(-1.03), DVec2::splat(1.03)];
    Window::fitting(&corners, DVec2::new(left, top), DVec2::splat(DISK))
}

/// The grid's circles and rays as polylines.
fn grid_lines() -> Vec<Vec<DVec2>> {
    let part = |k: u32| f64::from(k) / f64::from(FINE);
    let circle = |j: u32| (0..=GRID_RAYS * FINE).map(|k| grid_point(f64::from(j), part(k))).collect();
    let ray = |k: u32| (FINE..=(GRID_CIRCLES - 1) * FINE).map(|j| grid_point(part(j), f64::from(k))).collect();
    (1..GRID_CIRCLES).map(circle).chain((0..GRID_RAYS).map(ray)).collect()
}

fn draw_grid(page: &mut Page, window: Window, stroke: Stroke, map: &dyn Fn(DVec2) -> Option<DVec2>) {
    for line in grid_lines() {
        page.line(line.into_iter().filter_map(map).map(|p| window.place(p)), stroke);
    }
}

fn circle(window: Window) -> impl Iterator<Item = DVec2> {
    (0..=CURVE).map(move |k| window.place(DVec2::from_angle(TAU * f64::from(k) / f64::from(CURVE))))
}

fn draw_source(page: &mut Page, study: &MoebiusStudy, top: f64) {
    let window = disk_window(COLUMNS[0], top);
    let samples = study.samples();
    draw_grid(page, window, Stroke::solid(colour::INK, 0.7), &|x| Some(x));
    page.line(samples.iter().chain(samples.first()).map(|&p| window.place(p)), Stroke::solid(colour::INK, 1.2));
    for &p in samples {
        page.dot(window.place(p), 1.9, colour::INK);
    }
    page.dot(window.place(grid_point(0.0, 0.0)), 5.5, colour::GREEN);
    page.dot(window.place(DVec2::X), 5.5, colour::MAGENTA);
    let label = format!("grid G₁ about x₁, m = {}", samples.len());
    page.text(DVec2::new(COLUMNS[0] + 0.5 * DISK, top + DISK + 20.0), Anchor::Middle, SMALL, colour::GREY, &label);
}

fn draw_reparameterization(page: &mut Page, study: &MoebiusStudy, top: f64) {
    let m = study.samples().len();
    let at = |k: usize| DVec2::new(study.parameter(k), if k == m { TAU } else { study.reparameterisation(k) });
    let fine = (0..=CURVE).map(|k| TAU * f64::from(k) / f64::from(CURVE));
    let curve = |name: &str, points, stroke| Curve { name: name.to_owned(), points, stroke, dots: false };
    let exact = fine.map(|t| DVec2::new(t, MoebiusStudy::exact_reparameterization(t))).collect();
    Plot {
        corner: DVec2::new(COLUMNS[1], top + 12.0),
        size: DVec2::new(250.0, DISK - 30.0),
        title: "reparameterisation r".to_owned(),
        x: Axis::turn("arc length t from y₁"),
        y: Axis::turn("arc length r from y₂"),
        curves: vec![
            curve("exact", exact, Stroke::solid(colour::BLUE, 3.0)),
            curve("riemap", (0..=m).map(at).collect(), Stroke::solid(colour::INK, 1.2)),
        ],
        legend: Legend::BottomRight,
    }
    .draw(page);
}

fn draw_image(page: &mut Page, study: &MoebiusStudy, left: f64, top: f64, map: &dyn Fn(DVec2) -> Option<DVec2>) {
    let window = disk_window(left, top);
    draw_grid(page, window, Stroke::solid(colour::BLUE, 1.6), &|x| Some(MoebiusStudy::exact(x)));
    page.line(circle(window), Stroke::solid(colour::BLUE, 1.6));
    draw_grid(page, window, Stroke::solid(colour::INK, 0.7), map);
    page.line(
        mapped_boundary(study, map).map(|p| window.place(p)),
        Stroke { dash: "4 3", ..Stroke::solid(colour::INK, 1.2) },
    );
    for w in study.boundary_images() {
        page.dot(window.place(w), 1.9, colour::INK);
    }
    page.dot(window.place(MoebiusStudy::exact(grid_point(0.0, 0.0))), 5.5, colour::ORANGE);
    page.dot(window.place(DVec2::X), 5.5, colour::MAGENTA);
}

/// The image of the polygon's boundary, edge by edge.
fn mapped_boundary<'a>(
    study: &'a MoebiusStudy,
    map: &'a dyn Fn(DVec2) -> Option<DVec2>,
) -> impl Iterator<Item = DVec2> + 'a {
    let samples = study.samples();
    let m = samples.len();
    let points = (0..m).flat_map(move |k| {
        let [a, b] = [samples[k], samples[(k + 1) % m]];
        (0..FINE).map(move |i| (1.0 - INSET) * a.lerp(b, f64::from(i) / f64::from(FINE)))
    });
    points.chain(samples.first().map(|&p| (1.0 - INSET) * p)).filter_map(map)
}

//! Figure 6: a row for each m with mesh, Poisson kernel and harmonic measure.

use super::Drawing;
use super::plot::{Axis, Curve, Legend, Plot, Window};
use super::svg::{Anchor, LABEL, Page, Stroke, TITLE, colour};
use crate::cli::CliError;
use crate::figures::{Detail, DiskKernelStudy, Figure};
use crate::geometry::DVec2;
use crate::mesh::TriMesh;
use std::f64::consts::TAU;

/// Samples of the exact curves.
const FINE: usize = 400;

const ROW: f64 = 260.0;
const TOP: f64 = 50.0;

/// Draws the figure.
pub fn draw(detail: Detail) -> Result<Drawing, CliError> {
    let scenes = Figure::DiskKernel.scenes(detail);
    let studies = scenes.iter().map(DiskKernelStudy::new).collect::<Result<Vec<_>, _>>()?;
    let mut page = Page::new(1060.0, TOP + ROW * studies.len() as f64);
    let title = "Figure 6: Poisson kernel and harmonic measure at x = (0.6, 0.2) in the disk";
    page.text(DVec2::new(24.0, 30.0), Anchor::Start, TITLE, colour::INK, title);
    let mut findings = Vec::new();
    for (k, study) in studies.iter().enumerate() {
        let top = TOP + ROW * k as f64;
        draw_mesh(&mut page, study, top);
        draw_kernel(&mut page, study, top);
        draw_measure(&mut page, study, top);
        findings.push(format!("m = {}: largest error of ω̃ {:.2e}", study.kernel.len(), largest_error(study)));
    }
    Ok(Drawing { svg: page.finish(), png: None, table: DiskKernelStudy::table(&studies), findings })
}

fn largest_error(study: &DiskKernelStudy) -> f64 {
    let error = |k| (study.measure.at_vertex(k) - study.exact_measure(study.angle(k))).abs();
    (0..study.kernel.len()).map(error).fold(0.0, f64::max)
}

/// The edges of a mesh, each once.
pub fn edges(mesh: &TriMesh) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    let sides = mesh.triangles().iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let boundary = mesh.boundary_count();
    // an inner edge occurs in two triangles, in opposite directions; a boundary edge in one
    let once = sides.filter(move |[a, b]| a < b || (*a < boundary && *b < boundary));
    once.map(|side| side.map(|v| mesh.vertices()[v as usize]))
}

fn draw_mesh(page: &mut Page, study: &DiskKernelStudy, top: f64) {
    let window = Window::fitting(study.domain.samples().points(), DVec2::new(24.0, top + 24.0), DVec2::splat(186.0));
    let label = format!("m = {}, n = {}", study.kernel.len(), study.domain.mesh().interior_count());
    page.text(DVec2::new(24.0, top + 14.0), Anchor::Start, LABEL, colour::INK, &label);
    let place = |[a, b]: [DVec2; 2]| [window.place(a), window.place(b)];
    page.segments(edges(study.domain.mesh()).map(place), Stroke::solid(colour::GREY, 0.5));
    let samples = study.domain.samples().points();
    let outline = samples.iter().chain(samples.first()).map(|&p| window.place(p));
    page.line(outline, Stroke::solid(colour::INK, 1.2));
    page.dot(window.place(study.point), 5.5, colour::GREEN);
    page.dot(window.place(samples[0]), 5.5, colour::MAGENTA);
}

/// The exact curve and the approximation at the vertices, closed at 2π.
fn curves(study: &DiskKernelStudy, exact: &dyn Fn(f64) -> f64, value: &dyn Fn(usize) -> f64, end: f64) -> Vec<Curve> {
    let m = study.kernel.len();
    let at = |k: usize| DVec2::new(study.angle(k), if k == m { end } else { value(k) });
    let fine = (0..=FINE).map(|k| TAU * k as f64 / FINE as f64);
    vec![
        Curve {
            name: "exact".to_owned(),
            points: fine.map(|t| DVec2::new(t, exact(t))).collect(),
            stroke: Stroke::solid(colour::BLUE, 3.0),
            dots: false,
        },
        Curve {
            name: "riemap".to_owned(),
            points: (0..=m).map(at).collect(),
            stroke: Stroke::solid(colour::INK, 1.2),
            dots: false,
        },
    ]
}

fn draw_kernel(page: &mut Page, study: &DiskKernelStudy, top: f64) {
    let highest = study.kernel.iter().copied().fold(study.exact_kernel(0.321_75), f64::max);
    Plot {
        corner: DVec2::new(300.0, top + 24.0),
        size: DVec2::new(310.0, 186.0),
        title: "Poisson kernel P".to_owned(),
        x: Axis::turn("arc length t from y"),
        y: Axis::linear("P(t)", 0.0, 1.06 * highest),
        curves: curves(study, &|t| study.exact_kernel(t), &|k| study.kernel[k], study.kernel[0]),
        legend: Legend::TopRight,
    }
    .draw(page);
}

fn draw_measure(page: &mut Page, study: &DiskKernelStudy, top: f64) {
    Plot {
        corner: DVec2::new(700.0, top + 24.0),
        size: DVec2::new(310.0, 186.0),
        title: format!("harmonic measure ω, largest error {:.1e}", largest_error(study)),
        x: Axis::turn("arc length t from y"),
        y: Axis::linear("ω(t)", 0.0, 1.0),
        curves: curves(study, &|t| study.exact_measure(t), &|k| study.measure.at_vertex(k), 1.0),
        legend: Legend::TopLeft,
    }
    .draw(page);
}

//! Figures 12 and 15: four maps from the V-shape to the blob, and their convergence.

use super::plot::{Axis, Curve, Legend, Plot};
use super::raster::{ANCHOR, PANEL_PX, POINT, Raster, RasterPanel, STRAY};
use super::svg::{Anchor, LABEL, Page, SMALL, Stroke, TITLE, colour};
use super::{Drawing, pictures};
use crate::cli::{CliError, picture};
use crate::conformal::Side;
use crate::counted::counted;
use crate::figures::{
    BoundaryMap, ConvergenceRow, ConvergenceStudy, CrowdingStudy, Detail, Figure, FigureError, Method, SecondMap,
    fitted_order,
};
use crate::geometry::DVec2;

const PANEL: f64 = 236.0;
const LEFT: f64 = 24.0;

/// The stroke of a method, the same in all plots.
fn stroke(method: Method) -> Stroke {
    match method {
        Method::Exact => Stroke::solid(colour::BLUE, 4.0),
        Method::HarmonicMeasure => Stroke::solid(colour::INK, 1.6),
        Method::FreshZipper => Stroke { colour: colour::GREEN, width: 1.8, dash: "5 4" },
        Method::PrecomputedZipper => Stroke::solid(colour::VERMILLION, 1.6),
    }
}

/// Draws Figure 12.
pub fn figure_12(detail: Detail) -> Result<Drawing, CliError> {
    let scenes = Figure::Crowding.scenes(detail);
    let scene = scenes.first().ok_or_else(|| CliError::from(FigureError::Outline))?;
    let study = CrowdingStudy::new(scene)?;
    let images: Vec<Vec<DVec2>> = study.maps.iter().map(|map| study.extended(map)).collect::<Result<_, _>>()?;
    let strays: Vec<DVec2> = images.iter().map(|images| study.image_of_point(images)).collect();
    let row = rasterise(&study, scene, &images, &strays)?;
    let png = picture::encode(&row)?;
    let mut page = Page::new(2.0 * LEFT + 5.0 * PANEL, 720.0);
    let title = "Figure 12: from the V-shape to the blob, directly and through the disk";
    page.text(DVec2::new(LEFT, 30.0), Anchor::Start, TITLE, colour::INK, title);
    page.picture(DVec2::new(LEFT, 66.0), DVec2::new(5.0 * PANEL, PANEL), &png);
    label_panels(&mut page, &study, &strays);
    reparameterizations(&study).draw(&mut page);
    errors(&study).draw(&mut page);
    let findings = study.maps[1..].iter().zip(&strays[1..]).map(|(map, &stray)| finding(&study, map, stray));
    let findings = findings.collect();
    Ok(Drawing { svg: page.finish(), png: Some(png), table: study.table(), findings })
}

fn finding(study: &CrowdingStudy, map: &BoundaryMap, stray: DVec2) -> String {
    let (max, mean) = map.max_and_mean_error();
    let off = stray.distance(study.points.target);
    let (title, collapsed, all) = (map.method.title(), map.collapsed, map.images.len());
    let lost = counted!(collapsed, "1 of {all} samples collapses", "{collapsed} of {all} samples collapse");
    format!("{title}: error max {max:.2e}, mean {mean:.2e}; the image of x₁ is {off:.1e} from x₂; {lost} in the disk")
}

/// The panels: the V, then the blob under each map.
fn rasterise(
    study: &CrowdingStudy,
    scene: &crate::figures::Scene,
    images: &[Vec<DVec2>],
    strays: &[DVec2],
) -> Result<image::RgbaImage, CliError> {
    let [source, target] = study.domains.as_ref().into_array();
    let style = pictures::style(&scene.session, source.samples().points(), study.points.source);
    let panel = |positions, boundary, marks| RasterPanel {
        positions,
        coordinates: source.mesh().vertices(),
        triangles: source.mesh().triangles(),
        boundary,
        marks,
        style,
    };
    let points = study.points;
    let marks = vec![(points.source, POINT), (source.samples().points()[0], ANCHOR)];
    let mut panels = vec![panel(source.mesh().vertices(), source.samples().points(), marks)];
    for (positions, &stray) in images.iter().zip(strays) {
        let marks = vec![(points.target, POINT), (target.samples().points()[0], ANCHOR), (stray, STRAY)];
        let shown = if stray.distance(points.target) < VISIBLE { 2 } else { 3 };
        panels.push(panel(positions, target.samples().points(), marks.into_iter().take(shown).collect()));
    }
    Raster::new()?.row(&panels, None)
}

/// Within this distance of x₂ the image of x₁ is hidden by its dot: 3 pixels, of a blob whose extent is 8.
const VISIBLE: f64 = 8.0 * 3.0 / PANEL_PX as f64;

fn label_panels(page: &mut Page, study: &CrowdingStudy, strays: &[DVec2]) {
    let m = study.map.side(Side::Source).boundary_count();
    let mut label = |k: usize, name: &str, note: &str| {
        let at = DVec2::new(LEFT + PANEL * (k as f64 + 0.5), 58.0);
        page.text(at, Anchor::Middle, LABEL, colour::INK, name);
        page.text(at + DVec2::new(0.0, PANEL + 26.0), Anchor::Middle, SMALL, colour::GREY, note);
    };
    label(0, &format!("V-shape, m₁ = {m}"), "x₁ green, y₁ magenta");
    for (k, (map, stray)) in study.maps.iter().zip(strays).enumerate() {
        let off = stray.distance(study.points.target);
        let note = match map.method {
            Method::Exact => "boundary by the closed forms".to_owned(),
            _ if off > VISIBLE => {
                let (moved, all) = (moved(map), map.images.len());
                let left = counted!(moved, "1 of {all} samples leaves y₂", "{moved} of {all} samples leave y₂");
                format!("{left}; x₁ → yellow")
            }
            _ => format!("mean error {:.1e}; x₁ is {off:.0e} off", map.max_and_mean_error().1),
        };
        label(k + 1, map.method.title(), &note);
    }
}

/// The number of samples whose images differ visibly from y₂.
fn moved(map: &BoundaryMap) -> usize {
    let end = map.images.first().copied().unwrap_or_default();
    map.images.iter().filter(|w| w.distance(end) > VISIBLE).count()
}

/// The plot of r over t; the exact curve is the widest, so that it shows under the others.
fn reparameterizations(study: &CrowdingStudy) -> Plot {
    let t = study.arc_lengths();
    let length = study.maps[0].reparameterisation.iter().copied().fold(0.0, f64::max);
    let curve = |map: &BoundaryMap| Curve {
        name: map.method.title().to_owned(),
        points: t.iter().zip(&map.reparameterisation).map(|(&t, &r)| DVec2::new(t, r)).collect(),
        stroke: stroke(map.method),
        dots: false,
    };
    Plot {
        corner: DVec2::new(LEFT + 60.0, 370.0),
        size: DVec2::new(480.0, 280.0),
        title: "reparameterisation: where the V's samples go".to_owned(),
        x: Axis::linear("arc length t on the V from y₁", 0.0, t.last().copied().unwrap_or(1.0)),
        y: Axis::linear("arc length r on the blob from y₂", 0.0, length),
        curves: study.maps.iter().map(curve).collect(),
        legend: Legend::TopLeft,
    }
}

/// The plot of |f − f̃| over t, without errors below rounding.
fn errors(study: &CrowdingStudy) -> Plot {
    const LEAST: f64 = 1e-6;
    let t = study.arc_lengths();
    let curve = |map: &BoundaryMap| Curve {
        name: map.method.title().to_owned(),
        points: t.iter().zip(&map.errors).map(|(&t, &e)| DVec2::new(t, e.max(LEAST))).collect(),
        stroke: Stroke { width: 1.1, dash: "", ..stroke(map.method) },
        dots: false,
    };
    let worst = study.maps.iter().flat_map(|map| map.errors.iter().copied()).fold(LEAST, f64::max);
    Plot {
        corner: DVec2::new(LEFT + 670.0, 370.0),
        size: DVec2::new(480.0, 280.0),
        title: "distance from the exact image".to_owned(),
        x: Axis::linear("arc length t on the V from y₁", 0.0, t.last().copied().unwrap_or(1.0)),
        y: Axis::logarithmic("|f − f̃|", [LEAST, worst]),
        curves: study.maps[1..].iter().map(curve).collect(),
        legend: Legend::None,
    }
}

/// Draws Figure 15.
pub fn figure_15(detail: Detail) -> Result<Drawing, CliError> {
    let study = ConvergenceStudy::new(detail)?;
    let mut rows = Vec::new();
    for &m in &study.resolutions {
        rows.extend(study.rows(m)?);
    }
    let mut page = Page::new(1100.0, 480.0);
    let title = "Figure 15: error of the V-shape's boundary map, V-shape → blob";
    page.text(DVec2::new(LEFT, 30.0), Anchor::Start, TITLE, colour::INK, title);
    convergence(&study, &rows, "largest error, max |f − f̃|", 0.0, |row| row.max).draw(&mut page);
    convergence(&study, &rows, "mean error, mean |f − f̃|", 545.0, |row| row.mean).draw(&mut page);
    let findings = series(&study).map(|(method, second, name)| {
        let order = |value: fn(&ConvergenceRow) -> f64| order(&rows, method, second, value);
        format!("{name}: fitted order {} (max), {} (mean)", order(|r| r.max), order(|r| r.mean))
    });
    Ok(Drawing { svg: page.finish(), png: None, table: ConvergenceStudy::table(&rows), findings: findings.to_vec() })
}

/// The four error curves with their names.
fn series(study: &ConvergenceStudy) -> [(Method, SecondMap, String); 4] {
    let sampled = format!("m₂ = {}", study.target_samples());
    let name = |method: &str, second: &str| format!("{method}, {second}");
    [
        (Method::HarmonicMeasure, SecondMap::Exact, name("riemap", "exact second map")),
        (Method::FreshZipper, SecondMap::Exact, name("Zipper", "exact second map")),
        (Method::HarmonicMeasure, SecondMap::Sampled, name("riemap", &sampled)),
        (Method::FreshZipper, SecondMap::Sampled, name("Zipper", &sampled)),
    ]
}

fn of(rows: &[ConvergenceRow], method: Method, second: SecondMap) -> impl Iterator<Item = &ConvergenceRow> {
    rows.iter().filter(move |row| row.method == method && row.second == second)
}

fn order(rows: &[ConvergenceRow], method: Method, second: SecondMap, value: fn(&ConvergenceRow) -> f64) -> String {
    let points: Vec<(u32, f64)> = of(rows, method, second).map(|row| (row.m, value(row))).collect();
    fitted_order(&points).map_or_else(|| "–".to_owned(), |order| format!("{order:.2}"))
}

fn convergence(
    study: &ConvergenceStudy,
    rows: &[ConvergenceRow],
    title: &str,
    left: f64,
    value: fn(&ConvergenceRow) -> f64,
) -> Plot {
    let curve = |(method, second, name): (Method, SecondMap, String)| Curve {
        // against the sampled blob the error levels off, so that it has no order
        name: match second {
            SecondMap::Exact => format!("{name}: order {}", order(rows, method, second, value)),
            SecondMap::Sampled => name,
        },
        points: of(rows, method, second).map(|row| DVec2::new(f64::from(row.m), value(row))).collect(),
        stroke: Stroke {
            colour: if method == Method::FreshZipper { colour::VERMILLION } else { colour::BLUE },
            width: 1.8,
            dash: if second == SecondMap::Sampled { "6 4" } else { "" },
        },
        dots: true,
    };
    Plot {
        corner: DVec2::new(LEFT + 60.0 + left, 80.0),
        size: DVec2::new(430.0, 330.0),
        title: title.to_owned(),
        x: Axis::logarithmic_at("boundary samples m of the V", &study.resolutions),
        y: Axis::logarithmic("distance", rows.iter().map(value)),
        curves: series(study).map(curve).into_iter().collect(),
        legend: Legend::BottomLeft,
    }
}

//! Figures 8, 9 and 10: textured or coloured meshes with labels.

use super::Drawing;
use super::raster::{ANCHOR, POINT, Raster, RasterPanel};
use super::svg::{Anchor, LABEL, Page, SMALL, TITLE, colour};
use crate::cli::contours::{Panel, panels};
use crate::cli::{CliError, picture};
use crate::conformal::{ConformalMap, Constraints, Quality, Side};
use crate::figures::{Cell, Detail, Figure, FigureError, Scene, Table, prepare_spec};
use crate::geometry::DVec2;
use crate::render::{Pattern, TextureStyle};
use crate::session::{Session, TextureKind};

const PANEL: f64 = 236.0;
const LEFT: f64 = 24.0;

/// The session's texture on the source with this outline.
pub fn style(session: &Session, outline: &[DVec2], pole: DVec2) -> TextureStyle {
    let low = outline.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
    let high = outline.iter().fold(DVec2::NEG_INFINITY, |high, &p| high.max(p));
    let pattern = match session.texture {
        TextureKind::Checker | TextureKind::Image => Pattern::Checker,
        TextureKind::Grid => Pattern::Grid,
        TextureKind::Polar => Pattern::Polar,
    };
    TextureStyle { pattern, cells: session.texture_scale, bounds: (low, high), pole, dark: false }
}

/// The map of a scene, complete.
fn map_of(scene: &Scene) -> Result<(ConformalMap, Constraints), FigureError> {
    let domains = [prepare_spec(&scene.session.source)?, prepare_spec(&scene.session.target)?];
    let constraints = scene.session.constraints([domains[0].pole, domains[1].pole]);
    let [source, target] = domains;
    let map = ConformalMap::new(source, target, &constraints, scene.session.direction.into())?;
    Ok((map, constraints))
}

fn textured<'a>(panel: &Panel<'a>, style: TextureStyle) -> RasterPanel<'a> {
    RasterPanel {
        positions: panel.positions,
        coordinates: panel.coordinates,
        triangles: panel.triangles,
        boundary: panel.boundary,
        marks: panel.handles.iter().copied().zip([POINT, ANCHOR]).collect(),
        style,
    }
}

/// Draws Figure 10.
pub fn reshaping(detail: Detail) -> Result<Drawing, CliError> {
    let scenes = Figure::Reshaping.scenes(detail);
    let maps = scenes.iter().map(map_of).collect::<Result<Vec<_>, _>>()?;
    let mut raster = Vec::new();
    for (scene, (map, constraints)) in scenes.iter().zip(&maps) {
        let [source, target] = panels(map, constraints);
        let style = style(&scene.session, source.boundary, constraints.source_point);
        if raster.is_empty() {
            raster.push(textured(&source, style));
        }
        raster.push(textured(&target, style));
    }
    let png = picture::encode(&Raster::new()?.row(&raster, None)?)?;
    let mut page = Page::new(2.0 * LEFT + PANEL * raster.len() as f64, 350.0);
    page.text(
        DVec2::new(LEFT, 30.0),
        Anchor::Start,
        TITLE,
        colour::INK,
        &format!("Figure 10: {}", Figure::Reshaping.title()),
    );
    page.picture(DVec2::new(LEFT, 66.0), DVec2::new(PANEL * raster.len() as f64, PANEL), &png);
    let mut table = Table::new(&PANEL_COLUMNS);
    label(&mut page, 0, "Gingerbread man", "x₁ green, y₁ magenta");
    for (k, (scene, (map, _))) in scenes.iter().zip(&maps).enumerate() {
        let quality = map.quality();
        label(&mut page, k + 1, &scene.label, &format!("Q_avg = {:.4}", quality.q_mean));
        table.rows.push(row(scene, map, quality));
    }
    Ok(Drawing { svg: page.finish(), png: Some(png), table, findings: Vec::new() })
}

const PANEL_COLUMNS: [&str; 9] =
    ["scene", "m1", "triangles1", "m2", "triangles2", "q_mean", "q_max", "flipped", "collapsed"];

fn row(scene: &Scene, map: &ConformalMap, quality: Quality) -> Vec<Cell> {
    let mut row = vec![scene.label.replace(',', "").as_str().into()];
    for side in Side::BOTH {
        let mesh = &map.domain(side).mesh;
        row.extend([mesh.boundary_count.into(), mesh.triangles.len().into()]);
    }
    row.extend([quality.q_mean.into(), quality.q_max.into(), quality.flipped.into(), quality.collapsed.into()]);
    row
}

fn label(page: &mut Page, k: usize, name: &str, note: &str) {
    let at = DVec2::new(LEFT + PANEL * (k as f64 + 0.5), 58.0);
    page.text(at, Anchor::Middle, LABEL, colour::INK, name);
    page.text(at + DVec2::new(0.0, PANEL + 26.0), Anchor::Middle, SMALL, colour::GREY, note);
}

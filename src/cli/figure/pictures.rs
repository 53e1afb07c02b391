//! Figures 8 and 10 (textured meshes with labels), and the parts that Figure 9 shares with them.

use super::Drawing;
use super::raster::{ANCHOR, POINT, Raster, RasterPanel, stacked};
use super::svg::{Anchor, LABEL, Page, SMALL, TITLE, colour};
use crate::cli::{CliError, picture};
use crate::conformal::{ConformalMap, Constraints, MeshedDomain, PerSide, Quality, Side, TriangleDistortion};
use crate::export::{Panel, panels};
use crate::figures::{Cell, Detail, Figure, FigureError, Scene, Table, planar, prepare_spec};
use crate::geometry::{Bounds, DVec2};
use crate::render::{Pattern, TextureStyle};
use crate::session::{DomainSpec, Session, TextureKind};
use image::RgbaImage;
use std::sync::Arc;

/// Side length of a panel on the page.
pub const PANEL: f64 = 236.0;
pub const LEFT: f64 = 24.0;
const TOP: f64 = 66.0;
/// Distance from row to row: a panel and the note under it.
const ROW: f64 = PANEL + 56.0;

/// The session's texture on a source with this outline.
pub fn style(session: &Session, outline: &[DVec2], pole: DVec2) -> TextureStyle {
    let [low, high] = Bounds::of(outline.iter().copied()).corners();
    let pattern = match session.texture() {
        TextureKind::Checker | TextureKind::Image => Pattern::Checker,
        TextureKind::Grid => Pattern::Grid,
        // no figure uses a pattern that would need disk coordinates
        TextureKind::Polar | TextureKind::Conformal | TextureKind::Tiling => Pattern::Polar,
    };
    let cells = session.texture_scale();
    // the paper's cells are those of the source, whatever their size on the target
    TextureStyle { pattern, cells, octaves: false, bounds: (low, high), pole, dark: false }
}

/// The map of a scene, fully computed, with its distortion.
pub struct Shown {
    pub label: String,
    pub session: Session,
    pub map: ConformalMap,
    pub constraints: Constraints,
    pub domains: PerSide<Arc<MeshedDomain>>,
    pub triangles: Vec<TriangleDistortion>,
}

/// The maps of a figure; each domain is prepared only once.
pub fn maps(figure: Figure, detail: Detail) -> Result<Vec<Shown>, FigureError> {
    let mut prepared: Vec<(DomainSpec, Arc<_>)> = Vec::new();
    let mut domain = |spec: &DomainSpec| -> Result<Arc<_>, FigureError> {
        if let Some((_, domain)) = prepared.iter().find(|(known, _)| known == spec) {
            return Ok(Arc::clone(domain));
        }
        prepared.push((spec.clone(), prepare_spec(spec)?));
        Ok(Arc::clone(&prepared[prepared.len() - 1].1))
    };
    let shown = |Scene { label, session }: Scene| {
        let (source, target) = (domain(session.domain(Side::Source))?, domain(session.domain(Side::Target))?);
        let domains = PerSide::new(planar(&source)?, planar(&target)?);
        let constraints = session.constraints(domains.as_ref().map(|domain| domain.default_point()));
        let mut map = ConformalMap::new(source, target, &constraints, session.map_settings())?;
        map.refine_exactly();
        let triangles = map.distortions();
        Ok(Shown { label: label.to_string(), session, map, constraints, domains, triangles })
    };
    figure.scenes(detail).into_iter().map(shown).collect()
}

impl Shown {
    /// The panels of source and target with the texture.
    fn textured(&self) -> Result<[RasterPanel<'_>; 2], FigureError> {
        let panels = panels(&self.map, &self.constraints).ok_or(FigureError::NoDomain)?;
        let style = style(&self.session, panels.source.boundary, panels.source.handles[0]);
        Ok(panels.into_array().map(|panel| textured(&panel, style)))
    }

    /// The mean of Q without the flattened triangles, and their share of the area, as text.
    pub fn note(&self) -> String {
        match resolved_mean(&self.triangles) {
            (mean, 0.0) => format!("Q_avg = {mean:.4}"),
            (mean, share) => format!("Q_avg = {mean:.4}, {:.2} % flattened", 100.0 * share),
        }
    }

    /// The row of the table.
    pub fn row(&self) -> Vec<Cell> {
        let mut row = vec![self.label.replace(',', "").as_str().into()];
        for side in Side::BOTH {
            let side = self.map.side(side);
            row.extend([side.boundary_count().into(), side.triangles().len().into()]);
        }
        let Quality { q_mean, q_max, flipped, collapsed, .. } = Quality::summary(&self.triangles);
        let (resolved, share) = resolved_mean(&self.triangles);
        row.extend([q_mean, resolved, share, q_max].map(Cell::from));
        row.extend([flipped, collapsed].map(Cell::from));
        row
    }
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

/// Triangles with a larger Q count as flattened: where crowding is finer than the samples, a whole part of the domain
/// is mapped to one edge of the other outline, with Q from 10² to 10⁹. The coarsest resolved corners have Q = 5.
const FLATTENED: f64 = 10.0;

/// The area-weighted mean of Q without flattened triangles, and the share of the area in flattened and collapsed
/// triangles.
fn resolved_mean(triangles: &[TriangleDistortion]) -> (f64, f64) {
    let (mut weighted, mut resolved, mut total) = (0.0, 0.0, 0.0);
    for triangle in triangles {
        total += triangle.area;
        if !triangle.collapsed && triangle.q <= FLATTENED {
            weighted += triangle.area * triangle.q;
            resolved += triangle.area;
        }
    }
    if resolved == total { (weighted / resolved, 0.0) } else { (weighted / resolved, 1.0 - resolved / total) }
}

/// The columns of the tables of Figures 8, 9 and 10.
const COLUMNS: [&str; 11] = [
    "scene",
    "m1",
    "triangles1",
    "m2",
    "triangles2",
    "q_mean",
    "q_mean_resolved",
    "flattened_share",
    "q_max",
    "flipped",
    "collapsed",
];

/// A table of the maps.
pub fn table(maps: &[Shown]) -> Table {
    let mut table = Table::new(&COLUMNS);
    table.rows.extend(maps.iter().map(Shown::row));
    table
}

/// A page of labeled rows of pictures, and the same pictures without labels as PNG.
pub struct Sheet {
    pub page: Page,
    pub png: Vec<u8>,
}

impl Sheet {
    /// A sheet with these rows and `extra` free pixels below them.
    pub fn new(title: &str, rows: &[RgbaImage], columns: usize, extra: f64) -> Result<Self, CliError> {
        let width = PANEL * columns as f64;
        let mut page = Page::new(2.0 * LEFT + width, TOP + ROW * rows.len() as f64 + extra);
        page.text(DVec2::new(LEFT, 30.0), Anchor::Start, TITLE, colour::INK, title);
        for (k, row) in rows.iter().enumerate() {
            let corner = DVec2::new(LEFT, TOP + ROW * k as f64);
            page.picture(corner, DVec2::new(width, PANEL), &picture::encode(row)?);
        }
        Ok(Self { page, png: picture::encode(&stacked(rows))? })
    }

    /// Writes a name above a panel and a note below it.
    pub fn label(&mut self, row: usize, column: usize, name: &str, note: &str) {
        let at = DVec2::new(LEFT + PANEL * (column as f64 + 0.5), TOP - 8.0 + ROW * row as f64);
        self.page.text(at, Anchor::Middle, LABEL, colour::INK, name);
        self.page.text(at + DVec2::new(0.0, PANEL + 25.0), Anchor::Middle, SMALL, colour::GREY, note);
    }

    /// The y coordinate of the last row's lower end.
    pub fn bottom(rows: usize) -> f64 {
        TOP + ROW * rows as f64
    }

    /// The finished drawing with its table.
    pub fn finish(self, maps: &[Shown]) -> Drawing {
        let finding = |shown: &Shown| format!("{}: {}", shown.label, shown.note());
        let findings = maps.iter().map(finding).collect();
        Drawing { svg: self.page.finish(), png: Some(self.png), table: table(maps), findings }
    }
}

fn heading(figure: Figure) -> String {
    format!("Figure {}: {}", figure.number(), figure.title())
}

/// Draws Figure 10: the source and its images.
pub fn reshaping(detail: Detail) -> Result<Drawing, CliError> {
    let maps = maps(Figure::Reshaping, detail)?;
    let panels = source_and_images(&maps)?;
    let row = Raster::new()?.row(&panels, None)?;
    let mut sheet = Sheet::new(&heading(Figure::Reshaping), &[row], panels.len(), 0.0)?;
    sheet.label(0, 0, "Gingerbread man", "x₁ green, y₁ magenta");
    for (k, shown) in maps.iter().enumerate() {
        sheet.label(0, k + 1, &shown.label, &shown.note());
    }
    Ok(sheet.finish(&maps))
}

/// The first map's source, then every map's target.
fn source_and_images(maps: &[Shown]) -> Result<Vec<RasterPanel<'_>>, FigureError> {
    let mut panels = Vec::new();
    for shown in maps {
        let [source, target] = shown.textured()?;
        if panels.is_empty() {
            panels.push(source);
        }
        panels.push(target);
    }
    Ok(panels)
}

/// Draws Figure 8: for both resolutions the source and its four images.
pub fn options(detail: Detail) -> Result<Drawing, CliError> {
    const WAYS: usize = 4;
    let maps = maps(Figure::Options, detail)?;
    let raster = Raster::new()?;
    let rows: Vec<_> =
        maps.chunks(WAYS).map(|maps| raster.row(&source_and_images(maps)?, None)).collect::<Result<_, CliError>>()?;
    let mut sheet = Sheet::new(&heading(Figure::Options), &rows, WAYS + 1, 0.0)?;
    for (row, maps) in maps.chunks(WAYS).enumerate() {
        let [m1, m2] = Side::BOTH.map(|side| maps[0].map.side(side).boundary_count());
        sheet.label(row, 0, &format!("m₁ = {m1}, m₂ = {m2}"), "x₁ green, y₁ magenta");
        for (k, shown) in maps.iter().enumerate() {
            sheet.label(row, k + 1, &shown.label, &shown.note());
        }
    }
    Ok(sheet.finish(&maps))
}

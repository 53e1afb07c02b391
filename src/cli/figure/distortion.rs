//! Figure 9: every triangle and its image, colored by Q, for increasing m₁.

use super::Drawing;
use super::pictures::{LEFT, PANEL, Sheet, Shown, maps};
use super::raster::{Raster, RasterPanel};
use super::svg::{Anchor, LABEL, Page, SMALL, colour};
use crate::cli::CliError;
use crate::cli::output::triangles;
use crate::conformal::{Side, TriangleDistortion};
use crate::figures::{Detail, Figure};
use crate::geometry::DVec2;
use crate::render::{ColourMap, Pattern, TextureStyle, flipped_colour};
use image::{Rgba, RgbaImage};

/// Upper end of the color scale of Q, as in the app: at Q = 1.5 an angle of 90° appears as 67°.
const TOP_Q: f64 = 1.5;

/// Colors in the texture: the color map, then one for collapsed and one for flipped triangles.
const COLOURS: u32 = 256;
const FLIPPED: u32 = COLOURS - 1;
const COLLAPSED: u32 = COLOURS - 2;
/// The index of the color map's last color.
const LAST: u32 = COLOURS - 3;
/// Collapsed triangles: their images are points up to rounding.
const COLLAPSED_COLOR: [f32; 4] = [0.78, 0.78, 0.78, 1.0];

/// Draws the figure.
pub fn draw(detail: Detail) -> Result<Drawing, CliError> {
    let maps = maps(Figure::Distortion, detail)?;
    let raster = Raster::new()?;
    let palette = palette();
    let mut rows = Vec::new();
    for side in Side::BOTH {
        let meshes: Vec<Colored> = maps.iter().map(|shown| Colored::new(shown, side)).collect();
        let panels: Vec<RasterPanel<'_>> = meshes.iter().map(Colored::panel).collect();
        rows.push(raster.row(&panels, Some(&palette))?);
    }
    let title = format!("Figure 9: {}, Q = σ₁/σ₂", Figure::Distortion.title());
    let mut sheet = Sheet::new(&title, &rows, maps.len(), 60.0)?;
    for (k, shown) in maps.iter().enumerate() {
        let count = shown.map.side(Side::Source).triangles().len();
        sheet.label(0, k, &shown.label, &triangles(count));
        sheet.label(1, k, "", &shown.note());
    }
    legend(&mut sheet.page, Sheet::bottom(rows.len()), maps.len(), TOP_Q);
    Ok(sheet.finish(&maps))
}

/// Draws the color scale from Q = 1 to `top_q`, with ticks.
pub fn legend(page: &mut Page, top: f64, columns: usize, top_q: f64) {
    const STEPS: u32 = 100;
    let width = 0.5 * PANEL * columns as f64;
    let left = LEFT + 0.5 * width;
    for k in 0..STEPS {
        let part = f64::from(k) / f64::from(STEPS);
        let corner = DVec2::new(left + part * width, top);
        // each rectangle reaches to the right end and is covered by the next, so that no seams show
        page.fill(corner, DVec2::new((1.0 - part) * width, 14.0), &rgb(ColourMap::Cividis.at(part)));
    }
    for k in 0..=5 {
        let part = f64::from(k) / 5.0;
        let (q, x) = (1.0 + part * (top_q - 1.0), left + part * width);
        let name = if k == 5 { format!("≥ {}", tick(q)) } else { tick(q) };
        page.text(DVec2::new(x, top + 30.0), Anchor::Middle, SMALL, colour::INK, &name);
    }
    page.text(DVec2::new(left - 14.0, top + 12.0), Anchor::End, LABEL, colour::INK, "Q");
    let others = [(flipped_colour(), "flipped"), (COLLAPSED_COLOR, "collapsed to a point")];
    for (k, (colour, name)) in others.into_iter().enumerate() {
        let corner = DVec2::new(left + width + 34.0, top - 8.0 + 22.0 * k as f64);
        page.fill(corner, DVec2::splat(14.0), &rgb(colour));
        page.text(corner + DVec2::new(20.0, 11.5), Anchor::Start, SMALL, colour::INK, name);
    }
}

/// A tick's label: two decimals, or one if the second is 0.
fn tick(q: f64) -> String {
    let text = format!("{q:.2}");
    text.strip_suffix('0').map(str::to_owned).unwrap_or(text)
}

fn rgb(colour: [f32; 4]) -> String {
    let [r, g, b, _] = colour.map(|c| (255.0 * c).round());
    format!("rgb({r},{g},{b})")
}

/// A texture whose columns are the colors.
pub fn palette() -> RgbaImage {
    let bytes = |colour: [f32; 4]| Rgba(colour.map(|c| (255.0 * c).round() as u8));
    // square, so that it is not stretched
    RgbaImage::from_fn(COLOURS, COLOURS, |x, _| match x {
        FLIPPED => bytes(flipped_colour()),
        COLLAPSED => bytes(COLLAPSED_COLOR),
        _ => bytes(ColourMap::Cividis.at(f64::from(x) / f64::from(LAST))),
    })
}

/// The texture coordinate of a triangle's color, in the middle of its column.
fn place(triangle: &TriangleDistortion, top_q: f64) -> DVec2 {
    let column = match triangle {
        TriangleDistortion { flipped: true, .. } => FLIPPED,
        TriangleDistortion { collapsed: true, .. } => COLLAPSED,
        _ => (f64::from(LAST) * ((triangle.q - 1.0) / (top_q - 1.0)).clamp(0.0, 1.0)).round() as u32,
    };
    DVec2::new((f64::from(column) + 0.5) / f64::from(COLOURS), 0.5)
}

/// A mesh whose triangles do not share corners, so that each has a single color.
pub struct Colored<'a> {
    positions: Vec<DVec2>,
    coordinates: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    boundary: &'a [DVec2],
}

impl<'a> Colored<'a> {
    /// The mapped mesh (the source's) or its image in the target, by `side`.
    fn new(shown: &'a Shown, side: Side) -> Self {
        let mesh = shown.domains[shown.map.mapped_side()].mesh();
        let vertices = if side == Side::Source { mesh.vertices() } else { shown.map.images() };
        let boundary = &shown.domains[side].samples().points();
        Self::of(vertices, mesh.triangles(), &shown.triangles, boundary, TOP_Q)
    }

    /// A mesh and the distortion of each triangle; distortions from `top_q` on have the last color.
    pub fn of(
        vertices: &[DVec2],
        triangles: &[[u32; 3]],
        distortions: &[TriangleDistortion],
        boundary: &'a [DVec2],
        top_q: f64,
    ) -> Self {
        let count = triangles.len() as u32;
        Self {
            positions: triangles.as_flattened().iter().map(|&v| vertices[v as usize]).collect(),
            coordinates: distortions.iter().flat_map(|t| [place(t, top_q); 3]).collect(),
            triangles: (0..count).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
            boundary,
        }
    }

    /// The mesh as a panel, textured with [`palette`].
    pub fn panel(&self) -> RasterPanel<'_> {
        let style = TextureStyle {
            pattern: Pattern::Image,
            cells: 1.0,
            octaves: false,
            bounds: (DVec2::ZERO, DVec2::ONE),
            pole: DVec2::ZERO,
            dark: false,
        };
        let Self { positions, coordinates, triangles, boundary } = self;
        RasterPanel { positions, coordinates, triangles, boundary, marks: Vec::new(), style }
    }
}

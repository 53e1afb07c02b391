//! Figures 14, 16 and 17: planar domains above, the surface with their texture or colored by Q below.

use super::Drawing;
use super::distortion::{Colored, legend, palette};
use super::pictures::{Sheet, style};
use super::raster::{Raster, RasterPanel};
use crate::cli::CliError;
use crate::cli::flatten_arguments::{preset, read};
use crate::cli::output::{edges_flipped, triangles};
use crate::cli::surface_picture::{camera, places, planar_places};
use crate::conformal::{Quality, Side, TriangleDistortion};
use crate::figures::{Detail, Figure, FigureError, SurfaceStudy};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use crate::offscreen::compose::{HANDLE_COLORS, surface_handles};
use crate::render::{
    CellCode, CellStyle, ColourMap, Handle, OrbitCamera, SceneSurface, StrokeStyle, SurfaceGeometry, SurfaceHandle,
};
use crate::session::{Colouring, SurfaceShape};
use crate::surface::SurfacePreset;

/// Radius of a handle, and the number of panel pixels per point, by which strokes are scaled.
const HANDLE_PX: f32 = 8.0;
const PIXELS_PER_POINT: f32 = 1.2;

/// Upper end of the color scale of Q. On riemap's head and on the paper's cow the means are 1.05 to 1.06, the
/// largest values 1.24 to 1.40.
const TOP_Q: f64 = 1.25;

/// Height of the legend of Q.
const LEGEND: f64 = 60.0;

/// Draws one of these figures, with the surface called `name` instead of its own.
pub fn draw(figure: Figure, detail: Detail, name: Option<&str>) -> Result<Drawing, CliError> {
    let given = name.map(read).transpose()?;
    let studies = SurfaceStudy::all(figure, detail, given.as_ref().map(|read| &read.surface))
        .map_err(|error| about(name, &error))?;
    let shown_preset = name.map_or_else(|| own_preset(&studies), preset);
    let shown: Vec<Shown<'_>> = studies.iter().map(|study| Shown::new(study, shown_preset)).collect();
    let raster = Raster::new()?;
    let rows = [planar_row(&raster, &shown)?, raster.surfaces(&shown.iter().map(Shown::surface).collect::<Vec<_>>())?];
    let is_colored = shown.iter().any(Shown::is_colored);
    let title = format!("Figure {}: {}", figure.number(), figure.title());
    let mut sheet = Sheet::new(&title, &rows, shown.len(), if is_colored { LEGEND } else { 0.0 })?;
    for (k, shown) in shown.iter().enumerate() {
        sheet.label(0, k, &shown.study.label, if k == 0 { "x green, y magenta" } else { "" });
        sheet.label(1, k, "", &shown.note());
    }
    if is_colored {
        legend(&mut sheet.page, Sheet::bottom(rows.len()), shown.len(), TOP_Q);
    }
    let findings = findings(name, &shown);
    Ok(Drawing { svg: sheet.page.finish(), png: Some(sheet.png), table: SurfaceStudy::table(&studies), findings })
}

fn about(name: Option<&str>, error: &FigureError) -> CliError {
    CliError::Input(name.map_or_else(|| error.to_string(), |name| format!("{name}: {error}")))
}

fn own_preset(studies: &[SurfaceStudy]) -> Option<SurfacePreset> {
    match studies.first()?.session.surface(Side::Target)?.spec.shape {
        SurfaceShape::Preset { preset, .. } => Some(preset),
        SurfaceShape::File { .. } => None,
    }
}

fn findings(name: Option<&str>, shown: &[Shown<'_>]) -> Vec<String> {
    let surface = shown.first().map(|shown| {
        let (surface, _) = &shown.study.surface;
        let mesh = surface.mesh();
        let name = name.map_or_else(String::new, |name| format!(" ({name})"));
        let (m, triangles) = (mesh.boundary_count(), triangles(mesh.triangles().len()));
        format!("surface{name}: m = {m}, {triangles}, {} to be Delaunay", edges_flipped(surface.flips().flips))
    });
    let maps = shown.iter().map(|shown| {
        let Quality { q_max, flipped, collapsed, .. } = shown.quality();
        format!(
            "{}: {}, largest Q {q_max:.2}, {flipped} flipped, {collapsed} collapsed",
            shown.study.label,
            shown.note()
        )
    });
    surface.into_iter().chain(maps).collect()
}

/// A study prepared for drawing.
struct Shown<'a> {
    study: &'a SurfaceStudy,
    triangles: Vec<TriangleDistortion>,
    codes: Vec<CellCode>,
    camera: OrbitCamera,
    handles: [SurfaceHandle; 2],
}

impl<'a> Shown<'a> {
    fn new(study: &'a SurfaceStudy, preset: Option<SurfacePreset>) -> Self {
        let (surface, point) = &study.surface;
        let mut triangles = Vec::new();
        study.map.advance_distortions(&mut triangles, Deadline::NEVER);
        let camera = camera(preset, surface, 1.0);
        let handles = surface_handles(
            surface,
            places(surface, *point, study.map.measure(Side::Target).anchor()),
            &camera,
            HANDLE_PX,
        );
        let codes = triangles.iter().map(code).collect();
        Self { study, triangles, codes, camera, handles }
    }

    /// Whether it is colored by Q instead of textured.
    fn is_colored(&self) -> bool {
        self.study.session.colouring() == Colouring::Angle
    }

    fn quality(&self) -> Quality {
        Quality::summary(&self.triangles)
    }

    fn note(&self) -> String {
        format!("Q_avg = {:.4}", self.quality().q_mean)
    }

    fn surface(&self) -> SceneSurface<'_> {
        let mesh = self.study.surface.0.mesh();
        let cells =
            CellStyle { map: Some(ColourMap::Cividis), wire: None, marks: true, pixels_per_point: PIXELS_PER_POINT };
        SceneSurface {
            geometry: SurfaceGeometry {
                positions: mesh.vertices(),
                triangles: mesh.triangles(),
                boundary_count: mesh.boundary_count(),
            },
            texture_coordinates: self.study.map.images(),
            codes: if self.is_colored() { &self.codes } else { &[] },
            cells: Some(cells).filter(|_| self.is_colored()),
            camera: self.camera,
            style: style(&self.study.session, self.outline(), self.study.source.1),
            stroke: Some(StrokeStyle::themed(false, PIXELS_PER_POINT)),
            handles: &self.handles,
        }
    }

    fn outline(&self) -> &'a [DVec2] {
        self.study.source.0.samples().points()
    }

    /// The panel of the textured domain.
    fn textured(&self) -> RasterPanel<'_> {
        let mesh = self.study.source.0.mesh();
        RasterPanel {
            positions: mesh.vertices(),
            coordinates: mesh.vertices(),
            triangles: mesh.triangles(),
            boundary: self.outline(),
            marks: self.marks(),
            style: style(&self.study.session, self.outline(), self.study.source.1),
        }
    }

    /// The surface's triangles in the plane, colored by Q.
    fn colored(&self) -> Colored<'a> {
        let map = &self.study.map;
        Colored::of(map.images(), self.study.map.mapped().triangles(), &self.triangles, self.outline(), TOP_Q)
    }

    fn marks(&self) -> Vec<(DVec2, [f32; 4])> {
        let places =
            planar_places(&self.study.source.0, self.study.source.1, self.study.map.measure(Side::Source).anchor());
        let handle = |k: usize| Handle { position: places[k], colour: HANDLE_COLORS[k], radius_px: HANDLE_PX };
        let handles = [0, 1].map(handle);
        handles.map(|handle| (handle.position, handle.colour)).to_vec()
    }
}

fn planar_row(raster: &Raster, shown: &[Shown<'_>]) -> Result<image::RgbaImage, CliError> {
    if !shown.iter().any(Shown::is_colored) {
        return raster.row(&shown.iter().map(Shown::textured).collect::<Vec<_>>(), None);
    }
    let meshes: Vec<Colored<'_>> = shown.iter().map(Shown::colored).collect();
    let panels = meshes.iter().zip(shown).map(|(mesh, shown)| RasterPanel { marks: shown.marks(), ..mesh.panel() });
    raster.row(&panels.collect::<Vec<_>>(), Some(&palette()))
}

/// The color of a triangle on the surface, the same as in the plane.
fn code(triangle: &TriangleDistortion) -> CellCode {
    match triangle {
        TriangleDistortion { flipped: true, .. } => CellCode::FLIPPED,
        TriangleDistortion { collapsed: true, .. } => CellCode::COLLAPSED,
        _ => CellCode::at((triangle.q - 1.0) / (TOP_Q - 1.0)),
    }
}

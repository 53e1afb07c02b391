//! Pictures put together: domains and surfaces side by side, with their outlines and dots, as a scene.

use crate::conformal::MeshedSurface;
use crate::export::{Panel, hatched};
use crate::geometry::{DVec2, DVec3};
use crate::render::{
    CellCode, CellStyle, Handle, MeshGeometry, OrbitCamera, SceneCells, SceneDescription, ScenePicture, SceneSurface,
    SceneViewport, StrokeStyle, SurfaceGeometry, SurfaceHandle, TextureStyle,
};
use image::RgbaImage;

/// Okabe–Ito green for x, magenta for y.
pub const HANDLE_COLORS: [[f32; 4]; 2] = [[0.0, 0.62, 0.45, 1.0], [0.84, 0.235, 0.65, 1.0]];

/// The boundary's stroke on a surface relative to the outline's.
const LOOP_TO_OUTLINE: f32 = 1.4;

/// Behind a picture that goes with the dark theme, the app's ground, or with the light one.
pub const fn background(dark: bool) -> [f32; 4] {
    if dark { [0.05, 0.067, 0.09, 1.0] } else { [1.0; 4] }
}

/// How panels are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    /// The texture, and the theme.
    pub style: TextureStyle,
    /// The ground, sRGB-encoded with straight alpha.
    pub background: [f32; 4],
    /// The image of [`crate::render::Pattern::Image`].
    pub image: Option<&'a RgbaImage>,
    /// The outlines; `None`: the theme's stroke.
    pub stroke: Option<StrokeStyle>,
    /// The radius of the dots; `None`: no dots.
    pub radius_px: Option<f32>,
}

/// What a picture shows of one side.
#[derive(Debug, Clone, Copy)]
pub enum ScenePart<'a> {
    /// A domain in the plane.
    Plane(PlanarPart<'a>),
    /// A surface in space.
    Space(SurfacePart<'a>),
}

/// A domain in the plane.
#[derive(Debug, Clone, Copy)]
pub struct PlanarPart<'a> {
    /// Mesh, outline and points.
    pub panel: Panel<'a>,
    /// The colors of the triangles and the edges, drawn over the mesh.
    pub cells: Option<SceneCells<'a>>,
}

/// A surface in space.
#[derive(Debug, Clone, Copy)]
pub struct SurfacePart<'a> {
    /// The surface.
    pub surface: &'a MeshedSurface,
    /// The triangles that are painted.
    pub triangles: &'a [[u32; 3]],
    /// The texture coordinates of its vertices.
    pub coordinates: &'a [DVec2],
    /// The camera.
    pub camera: OrbitCamera,
    /// The interior and the boundary point.
    pub handles: [DVec3; 2],
    /// The pins in their place; empty: there are none.
    pub pins: &'a [DVec3],
    /// The codes of its triangles, and how they are shown.
    pub cells: Option<(&'a [CellCode], CellStyle)>,
}

/// What is drawn over a part: of an outline its line and the dots `plane`, of a surface the dots `space`.
#[derive(Default)]
struct Marks {
    /// The outline, and the hatching of what images do not cover.
    line: Vec<DVec2>,
    plane: Vec<Handle>,
    space: Vec<SurfaceHandle>,
}

/// Passes to `draw` the scene of `size` pixels with the parts from left to right.
pub fn compose<R>(
    parts: &[ScenePart<'_>],
    look: &Look<'_>,
    size: [u32; 2],
    draw: impl FnOnce(&SceneDescription) -> R,
) -> R {
    let marks: Vec<_> = parts.iter().map(|part| part.marks(look.radius_px)).collect();
    let pictures: Vec<ScenePicture<'_>> =
        parts.iter().zip(&marks).map(|(part, marks)| part.picture(marks, look)).collect();
    // free space around what is drawn
    let margin_px = 0.06 * size[1] as f32;
    draw(&SceneDescription { pictures: &pictures, background: look.background, image: look.image, margin_px })
}

impl<'a> ScenePart<'a> {
    fn marks(&self, radius_px: Option<f32>) -> Marks {
        match self {
            Self::Plane(PlanarPart { panel, .. }) => Marks {
                line: hatched(panel.boundary, panel.unresolved),
                plane: radius_px.map(|radius| handles(panel, radius)).unwrap_or_default(),
                ..Marks::default()
            },
            Self::Space(part) => {
                let dot = |place, colour, radius| surface_handle(part.surface, place, &part.camera, (colour, radius));
                let dots = |radius| {
                    let colored = dots(part.handles, part.pins.iter().copied());
                    colored.into_iter().map(|(place, colour)| dot(place, colour, radius)).collect()
                };
                Marks { space: radius_px.map(dots).unwrap_or_default(), ..Marks::default() }
            }
        }
    }

    fn picture(&self, marks: &'a Marks, look: &Look<'a>) -> ScenePicture<'a> {
        match self {
            Self::Plane(part) => viewport(part, marks, look).into(),
            Self::Space(part) => in_space(part, &marks.space, look).into(),
        }
    }
}

fn handles(panel: &Panel<'_>, radius_px: f32) -> Vec<Handle> {
    let dots = dots(panel.handles, panel.pins.iter().map(|pin| pin.truncate()));
    dots.into_iter().map(|(position, colour)| Handle { position, colour, radius_px }).collect()
}

/// The dots of a side with their colors: the interior and the boundary point, or the pins.
fn dots<P>(points: [P; 2], pins: impl Iterator<Item = P>) -> Vec<(P, [f32; 4])> {
    let pins: Vec<_> = pins.map(|pin| (pin, HANDLE_COLORS[1])).collect();
    if pins.is_empty() { points.into_iter().zip(HANDLE_COLORS).collect() } else { pins }
}

fn viewport<'a>(part: &PlanarPart<'a>, marks: &'a Marks, look: &Look<'a>) -> SceneViewport<'a> {
    let Panel { positions, coordinates, triangles, .. } = part.panel;
    SceneViewport {
        geometry: MeshGeometry { positions, texture_coordinates: coordinates, triangles },
        boundary: &marks.line,
        boundary_style: look.stroke,
        camera: None,
        style: look.style,
        cells: part.cells,
        handles: &marks.plane,
    }
}

fn in_space<'a>(part: &SurfacePart<'a>, handles: &'a [SurfaceHandle], look: &Look<'a>) -> SceneSurface<'a> {
    let mesh = part.surface.mesh();
    let (codes, cells) = part.cells.unzip();
    SceneSurface {
        geometry: SurfaceGeometry {
            positions: mesh.vertices(),
            triangles: part.triangles,
            boundary_count: mesh.boundary_count(),
        },
        texture_coordinates: part.coordinates,
        codes: codes.unwrap_or_default(),
        cells,
        camera: part.camera,
        style: look.style,
        stroke: look.stroke.map(|stroke| StrokeStyle { width_px: LOOP_TO_OUTLINE * stroke.width_px, ..stroke }),
        handles,
    }
}

/// The dots on a surface, at `places`, fainter where it hides them.
pub fn surface_handles(
    surface: &MeshedSurface,
    places: [DVec3; 2],
    camera: &OrbitCamera,
    radius_px: f32,
) -> [SurfaceHandle; 2] {
    [0, 1].map(|k| surface_handle(surface, places[k], camera, (HANDLE_COLORS[k], radius_px)))
}

/// A dot on a surface, fainter where it is hidden, of this color and radius.
fn surface_handle(
    surface: &MeshedSurface,
    position: DVec3,
    camera: &OrbitCamera,
    (colour, radius_px): ([f32; 4], f32),
) -> SurfaceHandle {
    SurfaceHandle { position, hidden: surface.tree().hides(camera.eye(), position), colour, radius_px }
}

//! A parameterized surface as a picture: the textured surface, and right of it the plane, with the same texture
//! and the surface's edges as they lie there.

use super::CliError;
use super::contours::Panel;
use super::flatten_arguments::preset;
use super::picture::{HANDLE_COLOURS, Look, background, encode, failed, handles, margin_px, viewport};
use crate::conformal::{PreparedDomain, PreparedSurface, SurfaceConstraints, SurfaceMap};
use crate::geometry::{DVec2, DVec3};
use crate::render::{
    BoundingSphere, CellCode, CellStyle, OrbitCamera, Pattern, SceneCells, SceneDescription, SceneSurface, StrokeStyle,
    SurfaceGeometry, SurfaceHandle, TextureStyle, headless_device, render_surface_with,
};
use crate::surface::SurfacePreset;
use image::RgbaImage;

/// Squares of the checkerboard across the outline's larger side.
const CELLS: f64 = 16.0;

/// Free space around surface and outline, as a part of a half's smaller side.
const MARGIN: f64 = 0.06;

/// The boundary's stroke on the surface relative to the outline's.
const LOOP_TO_OUTLINE: f32 = 1.4;

/// The half of a picture that shows a surface.
pub struct SurfacePanel<'a> {
    /// The surface.
    pub surface: &'a PreparedSurface,
    /// Where each vertex looks the texture up.
    pub coordinates: &'a [DVec2],
    /// The eye.
    pub camera: OrbitCamera,
    /// The interior and the boundary handle.
    pub handles: [DVec3; 2],
    /// The codes of its triangles, and how they are shown.
    pub cells: Option<(&'a [CellCode], CellStyle)>,
    /// Whether it is right of the plane.
    pub right: bool,
}

/// A PNG of `size` pixels. A preset, by its name, is seen from its own side.
pub fn png(
    name: &str,
    map: &SurfaceMap,
    constraints: &SurfaceConstraints,
    size: [u32; 2],
) -> Result<Vec<u8>, CliError> {
    let (surface, source) = (map.surface(), map.source());
    let plane = Panel {
        positions: &source.mesh.vertices,
        coordinates: &source.mesh.vertices,
        triangles: &source.mesh.triangles,
        boundary: &source.samples.points,
        handles: planar_places(source, constraints),
    };
    let pole = constraints.source_point;
    let style = TextureStyle { pattern: Pattern::Checker, cells: CELLS, bounds: plane.bounds(), pole, dark: true };
    // strokes and handles grow with the picture
    let scale = size[1].min(size[0]) as f32 / 900.0;
    let wire =
        CellStyle { map: None, wire: Some(StrokeStyle::wire(false, scale)), marks: false, pixels_per_point: scale };
    let triangles = &surface.surface.mesh.triangles;
    let layout = SceneCells { positions: map.images(), triangles, codes: &[], style: wire };
    let look = Look {
        style,
        cells: [Some(layout), None],
        stroke: Some(StrokeStyle::themed(true, scale.max(0.6))),
        radius_px: 9.0 * scale.max(0.4),
    };
    let solid = SurfacePanel {
        surface,
        coordinates: map.images(),
        camera: camera(preset(name), surface, 0.5 * f64::from(size[0]) / f64::from(size[1])),
        handles: places(surface, constraints),
        cells: None,
        right: false,
    };
    encode(&draw(&plane, &solid, &look, size)?)
}

/// A surface beside the plane in an image of `size` pixels; of the look's cells the first are the plane's.
pub fn draw(
    plane: &Panel<'_>,
    solid: &SurfacePanel<'_>,
    look: &Look<'_>,
    size: [u32; 2],
) -> Result<RgbaImage, CliError> {
    let on_surface = surface_handles(solid.surface, solid.handles, &solid.camera, look.radius_px);
    let mesh = &solid.surface.surface.mesh;
    let (codes, cells) = solid.cells.unzip();
    let surface = SceneSurface {
        right: solid.right,
        geometry: SurfaceGeometry {
            positions: &mesh.vertices,
            triangles: &mesh.triangles,
            boundary_count: mesh.boundary_count,
        },
        texture_coordinates: solid.coordinates,
        codes: codes.unwrap_or_default(),
        cells,
        camera: solid.camera,
        style: look.style,
        stroke: look.stroke.map(|stroke| StrokeStyle { width_px: LOOP_TO_OUTLINE * stroke.width_px, ..stroke }),
        handles: &on_surface,
    };
    let in_plane = handles(plane, look.radius_px);
    let scene = SceneDescription {
        viewports: &[viewport(plane, &in_plane, look, look.cells[0])],
        background: background(look.style.dark),
        image: None,
        margin_px: margin_px(size),
    };
    let (device, queue, _) = headless_device().map_err(|error| failed(&error))?;
    render_surface_with(&device, &queue, &surface, &scene, size).map_err(|error| failed(&error))
}

/// Sees all of a surface, a preset from its own side.
pub fn camera(preset: Option<SurfacePreset>, surface: &PreparedSurface, aspect: f64) -> OrbitCamera {
    let mesh = &surface.surface.mesh;
    let mut camera = match preset.map(SurfacePreset::view) {
        Some([towards_eye, up]) => OrbitCamera::new(BoundingSphere::of(&mesh.vertices), towards_eye, up, aspect),
        None => OrbitCamera::before(&mesh.vertices, &mesh.triangles, aspect),
    };
    camera.frame(&mesh.vertices, aspect, MARGIN);
    camera
}

/// The handles on the surface, at `places`, fainter where it hides them.
pub fn surface_handles(
    surface: &PreparedSurface,
    places: [DVec3; 2],
    camera: &OrbitCamera,
    radius_px: f32,
) -> [SurfaceHandle; 2] {
    [0, 1].map(|k| {
        let position = places[k];
        let hidden = surface.tree().hides(camera.eye(), position);
        SurfaceHandle { position, hidden, colour: HANDLE_COLOURS[k], radius_px }
    })
}

/// Where the two points are on the surface.
pub fn places(surface: &PreparedSurface, constraints: &SurfaceConstraints) -> [DVec3; 2] {
    let anchor = surface.at_fraction(constraints.surface_anchor);
    [surface.position(constraints.surface_point), surface.boundary_position(anchor)]
}

/// Where the two points are in the plane.
pub fn planar_places(source: &PreparedDomain, constraints: &SurfaceConstraints) -> [DVec2; 2] {
    let anchor = source.samples.position(source.samples.at_fraction(constraints.source_anchor));
    [constraints.source_point, anchor]
}

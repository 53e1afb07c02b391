//! A parameterized surface as a picture: the textured surface, and right of it the plane, with the same texture
//! and the surface's edges as they lie there.

use super::CliError;
use super::flatten_arguments::preset;
use super::picture::{BACKGROUND, HANDLE_COLOURS, encode};
use crate::conformal::{PreparedDomain, PreparedSurface, SurfaceConstraints, SurfaceMap};
use crate::geometry::DVec3;
use crate::render::{
    BoundingSphere, Handle, MeshGeometry, OrbitCamera, Pattern, SceneDescription, SceneSurface, SceneViewport,
    SceneWire, StrokeStyle, SurfaceGeometry, SurfaceHandle, TextureStyle, headless_device, render_surface_with,
};
use crate::surface::SurfacePreset;

/// Squares of the checkerboard across the outline's larger side.
const CELLS: f64 = 16.0;

/// Free space around surface and outline, as a part of a half's smaller side.
const MARGIN: f64 = 0.06;

/// The boundary's stroke on the surface relative to the outline's.
const LOOP_TO_OUTLINE: f32 = 1.4;

/// A PNG of `size` pixels. A preset, by its name, is seen from its own side.
pub fn png(
    name: &str,
    map: &SurfaceMap,
    constraints: &SurfaceConstraints,
    size: [u32; 2],
) -> Result<Vec<u8>, CliError> {
    let (surface, source) = (map.surface(), map.source());
    let bounds = source_bounds(source);
    let pole = constraints.source_point;
    let style = TextureStyle { pattern: Pattern::Checker, cells: CELLS, bounds, pole, dark: true };
    // strokes and handles grow with the picture
    let scale = size[1].min(size[0]) as f32 / 900.0;
    let radius_px = 9.0 * scale.max(0.4);
    let stroke = StrokeStyle::themed(true, scale.max(0.6));
    let camera = camera(preset(name), surface, 0.5 * f64::from(size[0]) / f64::from(size[1]));
    let on_surface = surface_handles(surface, constraints, &camera, radius_px);
    let mesh = &surface.surface.mesh;
    let left = SceneSurface {
        geometry: SurfaceGeometry {
            positions: &mesh.vertices,
            triangles: &mesh.triangles,
            boundary_count: mesh.boundary_count,
        },
        texture_coordinates: map.images(),
        codes: &[],
        cells: None,
        camera,
        style,
        stroke: Some(StrokeStyle { width_px: LOOP_TO_OUTLINE * stroke.width_px, ..stroke }),
        handles: &on_surface,
    };
    let in_plane = planar_handles(source, constraints, radius_px);
    let vertices = &source.mesh.vertices;
    let triangles = &source.mesh.triangles;
    let right = SceneViewport {
        geometry: MeshGeometry { positions: vertices, texture_coordinates: vertices, triangles },
        boundary: &source.samples.points,
        boundary_style: Some(stroke),
        camera: None,
        style,
        wire: Some(SceneWire {
            positions: map.images(),
            triangles: &mesh.triangles,
            style: StrokeStyle::wire(false, scale),
            pixels_per_point: scale,
        }),
        handles: &in_plane,
    };
    let margin_px = MARGIN as f32 * size[1].min(size[0] / 2) as f32;
    let scene = SceneDescription { viewports: &[right], background: BACKGROUND, image: None, margin_px };
    let failed = |error: crate::render::RenderError| CliError::Input(error.to_string());
    let (device, queue, _) = headless_device().map_err(failed)?;
    encode(&render_surface_with(&device, &queue, &left, &scene, size).map_err(failed)?)
}

fn source_bounds(source: &PreparedDomain) -> (crate::geometry::DVec2, crate::geometry::DVec2) {
    let bounds = crate::geometry::Bounds::of(source.samples.points.iter().copied());
    (bounds.min, bounds.max)
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

/// The two points on the surface.
pub fn surface_handles(
    surface: &PreparedSurface,
    constraints: &SurfaceConstraints,
    camera: &OrbitCamera,
    radius_px: f32,
) -> [SurfaceHandle; 2] {
    let mesh = &surface.surface.mesh;
    let anchor = surface.at_fraction(constraints.surface_anchor);
    let (k, m) = (anchor.edge as usize, mesh.boundary_count as usize);
    let on_loop = mesh.vertices[k].lerp(mesh.vertices[(k + 1) % m], anchor.fraction);
    let handle = |(position, colour): (DVec3, [f32; 4])| {
        let hidden = surface.tree().hides(camera.eye(), position);
        SurfaceHandle { position, hidden, colour, radius_px }
    };
    let [interior, boundary] = HANDLE_COLOURS;
    [(surface.position(constraints.surface_point), interior), (on_loop, boundary)].map(handle)
}

/// The two points in the plane.
pub fn planar_handles(source: &PreparedDomain, constraints: &SurfaceConstraints, radius_px: f32) -> [Handle; 2] {
    let anchor = source.samples.position(source.samples.at_fraction(constraints.source_anchor));
    let [interior, boundary] = HANDLE_COLOURS;
    [(constraints.source_point, interior), (anchor, boundary)].map(|(position, colour)| Handle {
        position,
        colour,
        radius_px,
    })
}

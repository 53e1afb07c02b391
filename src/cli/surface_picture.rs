//! A parameterized surface as a picture: the textured surface, and right of it the plane, with the same texture
//! and the surface's edges as they lie there.

use super::CliError;
use super::flatten_arguments::preset;
use super::picture::{encode, failed};
use crate::app::still::compose::{Look, PlanarPart, SurfacePart, background, compose};
use crate::conformal::{PreparedDomain, PreparedSurface, SurfaceConstraints, SurfaceMap};
use crate::export::Panel;
use crate::geometry::{DVec2, DVec3};
use crate::render::{BoundingSphere, CellStyle, OrbitCamera, Pattern, SceneCells, StrokeStyle, Studio, TextureStyle};
use crate::surface::SurfacePreset;

/// Squares of the checkerboard across the outline's larger side.
const CELLS: f64 = 16.0;

/// Free space around surface and outline, as a part of a half's smaller side.
const MARGIN: f64 = 0.06;

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
        background: background(true),
        image: None,
        stroke: Some(StrokeStyle::themed(true, scale.max(0.6))),
        radius_px: 9.0 * scale.max(0.4),
    };
    let solid = SurfacePart {
        surface,
        coordinates: map.images(),
        camera: camera(preset(name), surface, 0.5 * f64::from(size[0]) / f64::from(size[1])),
        handles: places(surface, constraints),
        cells: None,
        right: false,
    };
    let planar = [PlanarPart { panel: plane, cells: Some(layout) }];
    let picture = compose(&planar, Some(&solid), &look, size, |surface, scene| {
        Studio::new()?.shoot(|renderer, device, queue| renderer.draw(device, queue, surface, scene, size))
    });
    encode(&picture.map_err(|error| failed(&error))?)
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

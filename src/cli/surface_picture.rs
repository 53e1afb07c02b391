//! Pictures of maps of surfaces: the textured surface beside the plane, which shows the same texture and the surface's
//! edges; or two surfaces with a texture of the disk.

use super::CliError;
use super::flatten_arguments::preset;
use super::picture::{encode, failed};
use crate::conformal::{ConformalMap, Constraints, CornerCuts, MeshedDomain, MeshedSurface, PerSide, Side};
use crate::export::Panel;
use crate::geometry::{DVec2, DVec3};
use crate::mesh::BarycentricPoint;
use crate::offscreen::compose::{Look, PlanarPart, ScenePart, SurfacePart, background, compose};
use crate::outline::BoundaryPoint;
use crate::render::{BoundingSphere, CellStyle, OrbitCamera, Pattern, SceneCells, StrokeStyle, Studio, TextureStyle};
use crate::surface::SurfacePreset;
use image::RgbaImage;

/// Squares of the checkerboard across the outline's larger side.
const CELLS: f64 = 16.0;

/// Free space around surface and outline, as a part of a half's smaller side.
const MARGIN: f64 = 0.06;

/// The constraints of a map, and the places of the pins that are shown instead; none without pins.
pub type Given<'a> = (&'a Constraints, PerSide<&'a [DVec3]>);

/// Draws the map of a surface into the plane as PNG, with the layout of `cuts` if there are any; the surface is on the
/// right if `right`. A preset, identified by its name, is seen from its own direction.
pub fn png(
    name: &str,
    map: &ConformalMap,
    cuts: Option<&CornerCuts>,
    (constraints, pins): Given<'_>,
    right: bool,
    size: [u32; 2],
) -> Result<Vec<u8>, CliError> {
    let (side, anchors) = (map.mapped_side(), PerSide::from_fn(|side| map.measure(side).anchor()));
    let (points, plane) = (constraints.points, side.other());
    let (Some(surface), Some(x2), Some(domain), Some(x1)) =
        (map.mapped().surface(), points[side].on_surface(), map.domain(plane), points[plane].in_plane())
    else {
        return Err(no_plane());
    };
    let panel = Panel {
        positions: domain.mesh().vertices(),
        coordinates: domain.mesh().vertices(),
        triangles: domain.mesh().triangles(),
        boundary: domain.samples().points(),
        unresolved: &[],
        handles: planar_places(domain, x1, anchors[plane]),
        pins: pins[plane],
    };
    let style = checker(panel.bounds(), x1);
    // strokes and handles scale with the picture
    let scale = size[1].min(size[0]) as f32 / 900.0;
    let wire =
        CellStyle { map: None, wire: Some(StrokeStyle::wire(false, scale)), marks: false, pixels_per_point: scale };
    let uncut = (map.images(), surface.mesh().triangles());
    let (positions, triangles) = cuts.map_or(uncut, |cuts| (cuts.images(), cuts.triangles()));
    let layout = SceneCells { positions, triangles, codes: &[], style: wire };
    let solid = SurfacePart {
        surface,
        triangles: surface.mesh().triangles(),
        coordinates: map.images(),
        camera: camera(preset(name), surface, 0.5 * f64::from(size[0]) / f64::from(size[1])),
        handles: places(surface, x2, anchors[side]),
        pins: pins[side],
        cells: None,
    };
    let flat = ScenePart::Plane(PlanarPart { panel, cells: Some(layout) });
    let solid = ScenePart::Space(solid);
    let parts = if right { [flat, solid] } else { [solid, flat] };
    encode(&drawn(&parts, &look(style, scale), size)?)
}

/// Draws the map between two surfaces side by side as PNG. The texture is defined on the disk, so that corresponding
/// points have the same color.
pub fn png_of_two(
    names: PerSide<&str>,
    map: &ConformalMap,
    (constraints, pins): Given<'_>,
    size: [u32; 2],
) -> Result<Vec<u8>, CliError> {
    let aspect = 0.5 * f64::from(size[0]) / f64::from(size[1]);
    let style = checker(TextureStyle::DISK, DVec2::ZERO);
    let part = |side: Side| {
        let (surface, point) = (map.side(side).surface()?, constraints.points[side].on_surface()?);
        Some(ScenePart::Space(SurfacePart {
            surface,
            triangles: surface.mesh().triangles(),
            coordinates: map.disk(side)?,
            camera: camera(preset(names[side]), surface, aspect),
            handles: places(surface, point, map.measure(side).anchor()),
            pins: pins[side],
            cells: None,
        }))
    };
    let parts = PerSide::from_fn(part).both().ok_or_else(no_plane)?.into_array();
    let scale = size[1].min(size[0] / 2) as f32 / 900.0;
    encode(&drawn(&parts, &look(style, scale), size)?)
}

fn no_plane() -> CliError {
    CliError::Input(String::from("the map has no picture of this kind"))
}

fn checker(bounds: (DVec2, DVec2), pole: DVec2) -> TextureStyle {
    TextureStyle { pattern: Pattern::Checker, cells: CELLS, octaves: true, bounds, pole, dark: true }
}

fn look<'a>(style: TextureStyle, scale: f32) -> Look<'a> {
    let stroke = Some(StrokeStyle::themed(true, scale.max(0.6)));
    Look { style, background: background(true), image: None, stroke, radius_px: Some(9.0 * scale.max(0.4)) }
}

fn drawn(parts: &[ScenePart<'_>], look: &Look<'_>, size: [u32; 2]) -> Result<RgbaImage, CliError> {
    let picture = compose(parts, look, size, |scene| {
        Studio::new()?.shoot(|renderer, device, queue| renderer.draw(device, queue, scene, size))
    });
    picture.map_err(|error| failed(&error))
}

/// A camera that shows the whole surface, for a preset from its own direction.
pub fn camera(preset: Option<SurfacePreset>, surface: &MeshedSurface, aspect: f64) -> OrbitCamera {
    let mesh = surface.mesh();
    let mut camera = match preset.map(SurfacePreset::view) {
        Some([towards_eye, up]) => OrbitCamera::new(BoundingSphere::of(mesh.vertices()), towards_eye, up, aspect),
        None => OrbitCamera::before(mesh.vertices(), mesh.triangles(), aspect),
    };
    camera.frame(mesh.vertices(), aspect, MARGIN);
    camera
}

/// The positions of the two points on the surface.
pub fn places(surface: &MeshedSurface, point: BarycentricPoint, anchor: BoundaryPoint) -> [DVec3; 2] {
    [surface.position(point), surface.boundary_position(anchor)]
}

/// The positions of the two points in the plane.
pub fn planar_places(domain: &MeshedDomain, point: DVec2, anchor: BoundaryPoint) -> [DVec2; 2] {
    [point, domain.samples().position(anchor)]
}

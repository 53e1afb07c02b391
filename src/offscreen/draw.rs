//! An offscreen picture of a session, drawn by wgpu.

use super::compose::{Look, PlanarPart, ScenePart, SurfacePart, background, compose};
use crate::conformal::{PerSide, Side};
use crate::model::scene::{Offscreen, OffscreenCells, OffscreenSurface, Shot};
use crate::render::{Graphics, OrbitCamera, RenderError, SceneCells, SceneRenderer, StrokeStyle, Target};
use image::RgbaImage;

/// Outer radius of the app's dots, in points.
const DOT_RADIUS: f32 = 10.0;

impl Offscreen {
    /// Draws it with `renderer`; `image` is the texture of a session that has one, `cameras` see the surfaces: from
    /// where they are seen at first, where there is none.
    ///
    /// Errors: what the renderer says; there is always something to draw.
    pub fn draw(
        &self,
        renderer: &mut SceneRenderer,
        (device, queue): Graphics<'_>,
        shot: &Shot,
        image: Option<&RgbaImage>,
        cameras: PerSide<Option<OrbitCamera>>,
    ) -> Result<Target, RenderError> {
        let nothing = || RenderError::ViewportCount { count: 0, limit: shot.size[0] };
        let scale = shot.pixels_per_point();
        let look = Look {
            style: self.style(image.is_some(), shot.dark).ok_or_else(nothing)?,
            background: ground(shot),
            image,
            stroke: Some(StrokeStyle::themed(shot.dark, scale)),
            radius_px: shot.dots.then_some(DOT_RADIUS * scale),
        };
        let shown = Side::BOTH.into_iter().filter(|&side| shot.shows(side));
        let parts: Option<Vec<_>> = shown.map(|side| self.part(side, cameras[side], shot)).collect();
        compose(&parts.ok_or_else(nothing)?, &look, shot.size, |scene| renderer.draw(device, queue, scene, shot.size))
    }

    /// What stands on a side.
    fn part(&self, side: Side, camera: Option<OrbitCamera>, shot: &Shot) -> Option<ScenePart<'_>> {
        let Some(surface) = self.surface(side) else {
            let cells = self.cells(side).and_then(in_the_plane);
            return Some(ScenePart::Plane(PlanarPart { panel: self.panel(side)?, cells }));
        };
        let OffscreenSurface { surface, triangles, coordinates, points, pins } = surface;
        let camera = camera.or_else(|| self.camera(side, shot.aspect()))?;
        let cells = self.cells(side).map(|cells| (cells.codes, cells.style));
        Some(ScenePart::Space(SurfacePart { surface, triangles, coordinates, camera, handles: points, pins, cells }))
    }
}

fn in_the_plane(cells: OffscreenCells<'_>) -> Option<SceneCells<'_>> {
    let OffscreenCells { positions, triangles, codes, style } = cells;
    Some(SceneCells { positions: positions?, triangles, codes, style })
}

fn ground(shot: &Shot) -> [f32; 4] {
    let [r, g, b, alpha] = background(shot.dark);
    [r, g, b, if shot.transparent { 0.0 } else { alpha }]
}

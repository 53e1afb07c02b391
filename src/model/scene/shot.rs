//! A still as a picture.

use crate::conformal::{PerSide, Side};
use crate::model::export::panel;
use crate::model::scene::compose::{Look, PlanarPart, ScenePart, SurfacePart, background, compose};
use crate::model::scene::{Offscreen, OffscreenCells, OffscreenSurface};
use crate::render::{Graphics, OrbitCamera, RenderError, SceneCells, SceneRenderer, StrokeStyle, Target};
use image::RgbaImage;

/// A picture this high has the strokes and dots of a screen with one pixel to the point.
const HEIGHT_OF_POINTS: f32 = 900.0;
/// Outer radius of the app's dots, in points.
const DOT_RADIUS: f32 = 10.0;

/// What a picture is to be like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// In pixels.
    pub size: [u32; 2],
    /// Strokes for a dark ground, or for a light one.
    pub dark: bool,
    /// Without the ground.
    pub transparent: bool,
    /// One of the sides; `None`: both, side by side.
    pub side: Option<Side>,
}

impl Shot {
    /// How large a point is in it, in pixels.
    pub fn pixels_per_point(&self) -> f32 {
        self.size[0].min(self.size[1]) as f32 / HEIGHT_OF_POINTS
    }

    fn shows(&self, side: Side) -> bool {
        self.side.is_none_or(|only| only == side)
    }

    /// Width over height of one side in it.
    pub fn aspect(&self) -> f64 {
        let columns = if self.side.is_some() { 1.0 } else { 2.0 };
        f64::from(self.size[0]) / columns / f64::from(self.size[1])
    }

    fn background(&self) -> [f32; 4] {
        let [r, g, b, alpha] = background(self.dark);
        [r, g, b, if self.transparent { 0.0 } else { alpha }]
    }
}

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
            background: shot.background(),
            image,
            stroke: Some(StrokeStyle::themed(shot.dark, scale)),
            radius_px: DOT_RADIUS * scale,
        };
        let shown = Side::BOTH.into_iter().filter(|&side| shot.shows(side));
        let parts: Option<Vec<_>> = shown.map(|side| self.part(side, cameras[side], shot)).collect();
        compose(&parts.ok_or_else(nothing)?, &look, shot.size, |scene| renderer.draw(device, queue, scene, shot.size))
    }

    /// What stands on a side.
    fn part(&self, side: Side, camera: Option<OrbitCamera>, shot: &Shot) -> Option<ScenePart<'_>> {
        let Some(surface) = self.surface(side) else {
            let cells = self.cells(side).and_then(in_the_plane);
            return Some(ScenePart::Plane(PlanarPart { panel: panel(&self.model, side)?, cells }));
        };
        let OffscreenSurface { surface, coordinates, points } = surface;
        let camera = camera.or_else(|| self.camera(side, shot.aspect()))?;
        let cells = self.cells(side).map(|cells| (cells.codes, cells.style));
        Some(ScenePart::Space(SurfacePart { surface, coordinates, camera, handles: points, cells }))
    }
}

fn in_the_plane(cells: OffscreenCells<'_>) -> Option<SceneCells<'_>> {
    let OffscreenCells { positions, triangles, codes, style } = cells;
    Some(SceneCells { positions: positions?, triangles, codes, style })
}

//! A surface among the pictures of a scene.

use super::{
    CellCode, CellStyle, Graphics, MeshFault, OrbitCamera, Pace, RenderError, SpaceFrame, StrokeStyle, SurfaceGeometry,
    SurfaceHandle, TextureStyle, ViewportRenderer,
};
use glam::DVec2;

/// The surface of a scene.
#[derive(Clone, Debug)]
pub struct SceneSurface<'a> {
    /// The surface.
    pub geometry: SurfaceGeometry<'a>,
    /// The texture coordinates of each vertex: its image in the plane.
    pub texture_coordinates: &'a [DVec2],
    /// The codes of the triangles; empty for 0 everywhere.
    pub codes: &'a [CellCode],
    /// Colors, edges and marks of the triangles.
    pub cells: Option<CellStyle>,
    /// The eye.
    pub camera: OrbitCamera,
    /// The texture.
    pub style: TextureStyle,
    /// The boundary's stroke; `None` for the theme's.
    pub stroke: Option<StrokeStyle>,
    /// Discs on top.
    pub handles: &'a [SurfaceHandle],
}

impl SceneSurface<'_> {
    /// Checks the geometry and the lengths of the arrays.
    pub(super) fn check(&self) -> Result<(), RenderError> {
        let wrong = |fault| RenderError::Surface { fault };
        self.geometry.check().map_err(wrong)?;
        let (vertices, coordinates) = (self.geometry.positions.len(), self.texture_coordinates.len());
        if vertices != coordinates {
            return Err(wrong(MeshFault::Coordinates { positions: vertices, coordinates }));
        }
        let (triangles, codes) = (self.geometry.triangles.len(), self.codes.len());
        if codes != 0 && codes != triangles {
            return Err(wrong(MeshFault::Codes { triangles, codes }));
        }
        Ok(())
    }

    /// Uploads the surface to a viewport and records its rendering.
    pub(super) fn prepare(
        &self,
        (device, queue): Graphics<'_>,
        (renderer, viewport): (&mut ViewportRenderer, usize),
        encoder: &mut wgpu::CommandEncoder,
        size_px: [u32; 2],
        background: [f32; 4],
    ) -> Result<(), RenderError> {
        let uploaded = renderer.set_surface(device, queue, viewport, &self.geometry)
            && renderer.set_surface_coordinates(queue, viewport, self.texture_coordinates)
            && (self.codes.is_empty() || renderer.set_surface_codes(queue, viewport, &mut self.codes.to_vec()));
        if !uploaded {
            let fault = MeshFault::TooLarge { triangles: self.geometry.triangles.len() };
            return Err(RenderError::Surface { fault });
        }
        let stroke = self.stroke.unwrap_or_else(|| StrokeStyle::themed(self.style.dark, 1.0));
        renderer.set_surface_handles(viewport, self.handles);
        let (camera, style, cells) = (self.camera, self.style, self.cells);
        let frame = SpaceFrame { size_px, camera, style, cells, stroke, background };
        renderer.prepare_surface(device, queue, encoder, viewport, &frame, Pace::Full);
        Ok(())
    }
}

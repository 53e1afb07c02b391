//! The surface on the GPU: what is uploaded, and the callback by which it is drawn inside egui's pass.

use super::SurfaceSide;
use crate::app::model::{Changes, Model};
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::render::{
    CellStyle, OrbitCamera, StrokeStyle, SurfaceFrame, SurfaceGeometry, TextureStyle, ViewportRenderer,
};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};

/// Uploads what has changed of the surface, while one is shown; whether it fits on the device.
pub fn upload(state: &RenderState, renderer: &mut ViewportRenderer, model: &Model, changes: Changes) -> bool {
    let Some((side, _)) = model.surface() else { return true };
    let mut fits = true;
    if changes.meshes
        && let Some(surface) = side.surface()
    {
        let mesh = &surface.surface.mesh;
        let geometry = SurfaceGeometry {
            positions: &mesh.vertices,
            triangles: &mesh.triangles,
            boundary_count: mesh.boundary_count,
        };
        fits = renderer.set_surface(&state.device, &state.queue, &geometry);
    }
    if (changes.meshes || changes.images)
        && let Some(coordinates) = coordinates(side, model)
    {
        renderer.set_surface_coordinates(&state.queue, coordinates);
    }
    fits
}

/// Where the surface's vertices look the pattern up.
pub fn coordinates<'a>(side: &'a SurfaceSide, model: &'a Model) -> Option<&'a [DVec2]> {
    match model.pattern_home() {
        Some(_) => Some(side.map()?.images()),
        None => Some(model.shown_grid().of(Side::Target)),
    }
}

/// Draws the surface inside egui's pass.
pub struct SurfaceCallback {
    /// The viewport's size in physical pixels.
    pub size_px: [u32; 2],
    /// The eye.
    pub camera: OrbitCamera,
    /// How it is textured.
    pub style: TextureStyle,
    /// The colours of its triangles, edges and marks.
    pub cells: Option<CellStyle>,
    /// The boundary loop's stroke.
    pub stroke: StrokeStyle,
    /// The ground, sRGB-encoded.
    pub background: [f32; 4],
}

impl CallbackTrait for SurfaceCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(renderer) = resources.get_mut::<ViewportRenderer>() {
            let frame = SurfaceFrame {
                size_px: self.size_px,
                camera: &self.camera,
                style: &self.style,
                cells: self.cells,
                stroke: self.stroke,
                handles: &[],
                background: self.background,
            };
            renderer.prepare_surface(device, queue, encoder, &frame);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(renderer) = resources.get::<ViewportRenderer>() {
            renderer.paint_surface(pass);
        }
    }
}

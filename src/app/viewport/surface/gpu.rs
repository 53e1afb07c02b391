//! The surface on the GPU: what is uploaded, and the callback by which it is drawn inside egui's pass.

use crate::model::pattern::surface_coordinates;
use crate::model::{Changes, Model};
use crate::render::{Pace, REFINED_AFTER, SpaceFrame, SurfaceGeometry, ViewportRenderer};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};

/// Uploads what has changed of the surface, while one is shown; whether it fits on the device.
pub fn upload(state: &RenderState, renderer: &mut ViewportRenderer, model: &Model, changes: Changes) -> bool {
    let Some(side) = model.side_of_surface() else { return true };
    let mut fits = true;
    if changes.meshes
        && let Some(surface) = model.surface_side(side).surface()
    {
        let mesh = surface.mesh();
        let geometry = SurfaceGeometry {
            positions: mesh.vertices(),
            triangles: mesh.triangles(),
            boundary_count: mesh.boundary_count(),
        };
        fits = renderer.set_surface(&state.device, &state.queue, &geometry);
    }
    if (changes.meshes || changes.images)
        && let Some(coordinates) = surface_coordinates(model, side)
    {
        renderer.set_surface_coordinates(&state.queue, coordinates);
    }
    fits
}

/// Draws the surface inside egui's pass.
pub struct SurfaceCallback {
    /// What it shows beside what was uploaded.
    pub frame: SpaceFrame,
    /// How soon in full.
    pub pace: Pace,
    /// Where another frame is asked for while the picture is coarse.
    pub context: egui::Context,
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
            renderer.prepare_surface(device, queue, encoder, &self.frame, self.pace);
            if renderer.is_surface_coarse() {
                self.context.request_repaint_after_secs(REFINED_AFTER as f32);
            }
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

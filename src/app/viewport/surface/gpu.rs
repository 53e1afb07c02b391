//! The surfaces on the GPU: what is uploaded of them.

use crate::app::viewport::gpu::VIEWPORTS;
use crate::conformal::Side;
use crate::model::pattern::surface_coordinates;
use crate::model::{Changes, Model};
use crate::render::{SurfaceGeometry, ViewportRenderer};
use egui_wgpu::RenderState;

/// Uploads what has changed of a side's surface, while one is shown; whether it fits on the device.
pub fn upload(
    state: &RenderState,
    renderer: &mut ViewportRenderer,
    model: &Model,
    side: Side,
    changes: Changes,
) -> bool {
    let Some(surface) = model.shown_surface(side) else { return true };
    let (viewport, mut fits) = (VIEWPORTS[side], true);
    if changes.meshes {
        let mesh = surface.mesh();
        let geometry = SurfaceGeometry {
            positions: mesh.vertices(),
            triangles: model.painted(side, surface),
            boundary_count: mesh.boundary_count(),
        };
        fits = renderer.set_surface(&state.device, &state.queue, viewport, &geometry);
    }
    if (changes.meshes || changes.images)
        && let Some(coordinates) = surface_coordinates(model, side)
    {
        renderer.set_surface_coordinates(&state.queue, viewport, coordinates);
    }
    fits
}

//! Draws a surface off screen ahead of time, while the app is idle.
//!
//! Pipelines are created with the first surface, and software adapters compile them at the first draw: together that
//! takes longer than a frame.

use super::{OrbitCamera, Pace, Pattern, SpaceFrame, StrokeStyle, SurfaceGeometry, TextureStyle, ViewportRenderer};
use glam::{DVec2, DVec3};

impl ViewportRenderer {
    /// Draws one triangle with all pipelines of surfaces, unless a surface has been drawn already.
    pub fn rehearse_surface(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) {
        if self.has_surface() {
            return;
        }
        let (positions, triangles) = ([DVec3::ZERO, DVec3::X, DVec3::Y], [[0, 1, 2]]);
        let geometry = SurfaceGeometry { positions: &positions, triangles: &triangles, boundary_count: 3 };
        self.set_surface(device, queue, 0, &geometry);
        self.set_surface_coordinates(queue, 0, &positions.map(DVec3::truncate));
        let frame = SpaceFrame {
            size_px: [64, 64],
            camera: OrbitCamera::before(&positions, &triangles, 1.0),
            style: TextureStyle {
                pattern: Pattern::default(),
                cells: 4.0,
                octaves: true,
                bounds: (DVec2::ZERO, DVec2::ONE),
                pole: DVec2::ZERO,
                dark: true,
            },
            cells: None,
            stroke: StrokeStyle::themed(true, 1.0),
            background: [0.0; 4],
        };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.prepare_surface(device, queue, &mut encoder, 0, &frame, Pace::Full);
        queue.submit([encoder.finish()]);
    }
}

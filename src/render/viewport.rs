//! The renderer behind the viewports: uploads, off-screen rendering, the blit.

use super::{Camera, Handle, ImageError, StrokeStyle, TextureStyle};
use glam::DVec2;

/// Geometry of one viewport.
#[derive(Clone, Copy, Debug)]
pub struct MeshGeometry<'a> {
    /// Where each vertex is drawn, in the viewport's world.
    pub positions: &'a [DVec2],
    /// Where each vertex looks the texture up, in source coordinates.
    pub texture_coordinates: &'a [DVec2],
    /// Vertex indices of the triangles.
    pub triangles: &'a [[u32; 3]],
}

/// Pipelines, and buffers and targets of every viewport.
#[derive(Debug)]
pub struct ViewportRenderer {}

impl ViewportRenderer {
    /// Pipelines for a target of `target_format` and empty viewports.
    pub fn new(
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _target_format: wgpu::TextureFormat,
        _viewports: usize,
    ) -> Self {
        Self {}
    }
    /// Replaces a viewport's mesh; call it when the topology changes.
    pub fn set_mesh(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _viewport: usize,
        _geometry: &MeshGeometry,
    ) -> bool {
        true
    }
    /// Moves the vertices of the mesh; false (and nothing changes) when the count differs.
    pub fn set_positions(&mut self, _queue: &wgpu::Queue, _viewport: usize, _positions: &[DVec2]) -> bool {
        true
    }
    /// New texture coordinates for the mesh; false (and nothing changes) when the count differs.
    pub fn set_texture_coordinates(&mut self, _queue: &wgpu::Queue, _viewport: usize, _coordinates: &[DVec2]) -> bool {
        true
    }
    /// Replaces the closed outline stroke; an empty slice removes it.
    pub fn set_boundary(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _viewport: usize,
        _points: &[DVec2],
    ) -> bool {
        true
    }
    /// Colour and width of the outline stroke; `None`: the theme's at a device pixel ratio of 1.
    pub fn set_boundary_style(&mut self, _viewport: usize, _style: Option<StrokeStyle>) {}
    /// Replaces the discs drawn over the outline.
    pub fn set_handles(&mut self, _device: &wgpu::Device, _queue: &wgpu::Queue, _viewport: usize, _handles: &[Handle]) {
    }
    /// Replaces the image of `Pattern::Image`.
    pub fn set_image(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _rgba: &[u8],
        _width: u32,
        _height: u32,
    ) -> Result<(), ImageError> {
        Ok(())
    }
    /// Renders a viewport into its own target; `background` is sRGB-encoded with straight alpha.
    #[allow(
        clippy::too_many_arguments,
        reason = "one call per viewport and frame; each argument is a thing of its own"
    )]
    pub fn prepare(
        &mut self,
        _device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _encoder: &mut wgpu::CommandEncoder,
        _viewport: usize,
        _size_px: [u32; 2],
        _camera: &Camera,
        _style: &TextureStyle,
        _background: [f32; 4],
    ) {
    }
    /// Draws what `prepare` rendered over the whole viewport rectangle of `render_pass`.
    pub fn paint(&self, _render_pass: &mut wgpu::RenderPass<'static>, _viewport: usize) {}
}

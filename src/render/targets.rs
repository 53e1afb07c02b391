//! The textures into which a viewport is rendered before it is shown: a multisampled picture,
//! the resolved picture, and the stroke's coverage.

use super::blit_pass::BlitPass;
use super::gpu;
use super::stroke_pass::{COVERAGE_FORMAT, StrokePass};

/// The off-screen targets of one viewport, of one size.
#[derive(Debug)]
pub struct Targets {
    /// The size, clamped to the device's limits.
    pub size_px: [u32; 2],
    /// `None` if the device does not multisample.
    pub multisampled: Option<wgpu::TextureView>,
    pub picture: wgpu::TextureView,
    pub picture_group: wgpu::BindGroup,
    pub coverage: wgpu::TextureView,
    pub coverage_group: wgpu::BindGroup,
}

/// `size_px` with at least one pixel and at most the device's limit per side.
pub fn clamped_size(device: &wgpu::Device, size_px: [u32; 2]) -> [u32; 2] {
    let limit = device.limits().max_texture_dimension_2d;
    size_px.map(|side| side.clamp(1, limit))
}

impl Targets {
    /// Targets of a [`clamped_size`].
    pub fn new(device: &wgpu::Device, blit: &BlitPass, stroke: &StrokePass, size_px: [u32; 2], samples: u32) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let sampled = attachment | wgpu::TextureUsages::TEXTURE_BINDING;
        let multisampled =
            (samples > 1).then(|| view(device, "multisampled", size_px, gpu::PICTURE_FORMAT, samples, attachment));
        let picture = view(device, "picture", size_px, gpu::PICTURE_FORMAT, 1, sampled);
        let picture_group = blit.group(device, &picture);
        let coverage = view(device, "coverage", size_px, COVERAGE_FORMAT, 1, sampled);
        let coverage_group = gpu::texture_group(device, &stroke.coverage_layout, &coverage, None);
        Self { size_px, multisampled, picture, picture_group, coverage, coverage_group }
    }

    /// The picture as the attachment of the mesh pass: cleared, then resolved.
    pub fn mesh_attachment(&self, background: wgpu::Color) -> wgpu::RenderPassColorAttachment<'_> {
        resolved(self.multisampled.as_ref(), &self.picture, background)
    }
}

/// The off-screen targets of a surface in space, of one size.
#[derive(Debug)]
pub struct SurfaceTargets {
    /// The size, clamped to the device's limits.
    pub size_px: [u32; 2],
    multisampled: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
    pub picture: wgpu::TextureView,
    pub picture_group: wgpu::BindGroup,
}

impl SurfaceTargets {
    /// Targets of a [`clamped_size`].
    pub fn new(device: &wgpu::Device, blit: &BlitPass, size_px: [u32; 2], samples: u32) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let sampled = attachment | wgpu::TextureUsages::TEXTURE_BINDING;
        let multisampled =
            (samples > 1).then(|| view(device, "multisampled", size_px, gpu::PICTURE_FORMAT, samples, attachment));
        let depth = view(device, "depth", size_px, gpu::DEPTH_FORMAT, samples, attachment);
        let picture = view(device, "picture", size_px, gpu::PICTURE_FORMAT, 1, sampled);
        let picture_group = blit.group(device, &picture);
        Self { size_px, multisampled, depth, picture, picture_group }
    }

    /// Begins the pass of the surface, with the background color and cleared depth.
    pub fn begin<'encoder>(
        &self,
        encoder: &'encoder mut wgpu::CommandEncoder,
        background: wgpu::Color,
    ) -> wgpu::RenderPass<'encoder> {
        let depth_ops = wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("surface"),
            color_attachments: &[Some(resolved(self.multisampled.as_ref(), &self.picture, background))],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(depth_ops),
                stencil_ops: None,
            }),
            ..Default::default()
        })
    }
}

/// A picture as an attachment that is cleared, and resolved where there are several samples.
fn resolved<'a>(
    multisampled: Option<&'a wgpu::TextureView>,
    picture: &'a wgpu::TextureView,
    background: wgpu::Color,
) -> wgpu::RenderPassColorAttachment<'a> {
    let load = wgpu::LoadOp::Clear(background);
    match multisampled {
        Some(samples) => wgpu::RenderPassColorAttachment {
            view: samples,
            depth_slice: None,
            resolve_target: Some(picture),
            ops: wgpu::Operations { load, store: wgpu::StoreOp::Discard },
        },
        None => attachment(picture, load),
    }
}

/// An attachment that is stored and not resolved.
pub fn attachment(view: &wgpu::TextureView, load: wgpu::LoadOp<wgpu::Color>) -> wgpu::RenderPassColorAttachment<'_> {
    let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
    wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops }
}

fn view(
    device: &wgpu::Device,
    label: &str,
    size_px: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: size_px[0], height: size_px[1], depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

//! Copies a finished picture into the caller's pass (`shaders/blit.wgsl`).
//!
//! egui's target holds sRGB-encoded bytes in a format whose hardware does not
//! encode, so the shader encodes; on an sRGB format the hardware does.

use super::gpu::{self, PipelineSpec};

/// Pipeline and sampler.
#[derive(Debug)]
pub struct BlitPass {
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    pipeline: wgpu::RenderPipeline,
}

impl BlitPass {
    /// A blit into passes of one color target of `format`, without depth and
    /// multisampling, as egui's.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let layout = gpu::texture_layout(device, "blit", true);
        let shader = gpu::shader(device, "blit", include_str!("../../shaders/blit.wgsl"));
        let spec = PipelineSpec {
            label: "blit",
            shader: &shader,
            fragment: if format.is_srgb() { "fs_linear" } else { "fs_encoded" },
            groups: &[&layout],
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            format,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            samples: 1,
        };
        let pipeline = gpu::pipeline(device, &spec);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("blit"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        Self { layout, sampler, pipeline }
    }

    /// The bind group for drawing `picture`.
    pub fn group(&self, device: &wgpu::Device, picture: &wgpu::TextureView) -> wgpu::BindGroup {
        gpu::texture_group(device, &self.layout, picture, Some(&self.sampler))
    }

    /// Fills the pass's viewport rectangle.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, picture: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, picture, &[]);
        pass.draw(0..3, 0..1);
    }
}

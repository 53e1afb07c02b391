//! Handles as discs with a white ring (`shaders/disc.wgsl`).
//!
//! egui draws the app's handles; images made without a window need this pass.

use super::gpu::{self, GrowingBuffer, PipelineSpec, Uniform};
use super::style::linear_color;
use super::{Camera, Handle, placement};
use glam::DVec2;

/// `View` of `shaders/disc.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct DiscUniform {
    placement: [f32; 4],
    size: [f32; 4],
}

/// One instance.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Disc {
    center: [f32; 2],
    radius: f32,
    colour: [f32; 4],
}

/// The pipeline.
#[derive(Debug)]
pub struct DiscPass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

/// One viewport's handles.
#[derive(Debug)]
pub struct DiscBuffers {
    uniform: Uniform,
    discs: GrowingBuffer,
    count: u32,
    origin: DVec2,
}

impl DiscPass {
    /// A pipeline into an unsampled `PICTURE_FORMAT`.
    pub fn new(device: &wgpu::Device) -> Self {
        let layout = gpu::uniform_layout(device, "disc");
        let shader = gpu::shader(device, "disc", include_str!("../../shaders/disc.wgsl"));
        let attributes = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32, 2 => Float32x4];
        let instances = wgpu::VertexBufferLayout {
            array_stride: size_of::<Disc>() as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &attributes,
        };
        let spec = PipelineSpec {
            label: "disc",
            shader: &shader,
            fragment: "fs_main",
            groups: &[&layout],
            buffers: &[Some(instances)],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            format: gpu::PICTURE_FORMAT,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            samples: 1,
        };
        let pipeline = gpu::pipeline(device, &spec);
        Self { layout, pipeline }
    }

    /// Buffers without handles.
    pub fn buffers(&self, device: &wgpu::Device) -> DiscBuffers {
        DiscBuffers {
            uniform: Uniform::new(device, &self.layout, size_of::<DiscUniform>()),
            discs: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            count: 0,
            origin: DVec2::ZERO,
        }
    }

    /// Draws the handles, the last on top.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, handles: &DiscBuffers) {
        let Some(discs) = handles.discs.get() else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &handles.uniform.group, &[]);
        pass.set_vertex_buffer(0, discs.slice(..));
        pass.draw(0..4, 0..handles.count);
    }
}

impl DiscBuffers {
    /// Replaces the handles.
    pub fn set(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, handles: &[Handle]) {
        self.count = 0;
        let Some(first) = handles.first() else { return };
        self.origin = first.position;
        let discs: Vec<Disc> = handles
            .iter()
            .map(|handle| Disc {
                center: (handle.position - self.origin).as_vec2().to_array(),
                radius: handle.radius_px,
                colour: linear_color(handle.colour),
            })
            .collect();
        if self.discs.write(device, queue, &discs) {
            self.count = discs.len() as u32;
        }
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Writes the uniform block of a frame; radii are multiplied by `scale`.
    pub fn write_frame(&self, queue: &wgpu::Queue, camera: &Camera, size_px: [u32; 2], scale: f32) {
        let placement = placement::to_pixels(camera, self.origin, size_px);
        let size = [size_px[0] as f32, size_px[1] as f32, scale, 0.0];
        self.uniform.write(queue, &DiscUniform { placement, size });
    }
}

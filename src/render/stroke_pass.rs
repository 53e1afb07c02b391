//! The outline's stroke: constant width on the screen, exactly antialiased.
//!
//! Two passes, `shaders/stroke.wgsl` and `shaders/stroke_composite.wgsl`: the
//! coverage of the union of all segments goes into an 8-bit target with
//! "maximum" blending, then the color is laid over the picture once. So joins
//! are round and many segments within a pixel do not thicken the line, for any
//! number of points. Strokes thinner than a pixel become fainter instead.

use super::gpu::{self, GrowingBuffer, PipelineSpec, Uniform};
use super::style::linear_color;
use super::{Camera, StrokeStyle, placement};
use glam::DVec2;

/// Format of the coverage target.
pub const COVERAGE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// `Stroke` of `shaders/stroke.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct StrokeUniform {
    placement: [f32; 4],
    size: [f32; 4],
}

/// The two pipelines.
#[derive(Debug)]
pub struct StrokePass {
    layout: wgpu::BindGroupLayout,
    /// The layout of the coverage texture, for the composite.
    pub coverage_layout: wgpu::BindGroupLayout,
    cover: wgpu::RenderPipeline,
    composite: wgpu::RenderPipeline,
}

/// One viewport's closed outline.
#[derive(Debug)]
pub struct StrokeBuffers {
    stroke: Uniform,
    colour: Uniform,
    /// The points, with the first one repeated at the end.
    points: GrowingBuffer,
    segment_count: u32,
    origin: DVec2,
}

const MAXIMUM: wgpu::BlendComponent = wgpu::BlendComponent {
    src_factor: wgpu::BlendFactor::One,
    dst_factor: wgpu::BlendFactor::One,
    operation: wgpu::BlendOperation::Max,
};

impl StrokePass {
    /// Pipelines that end in an unsampled `PICTURE_FORMAT`.
    pub fn new(device: &wgpu::Device) -> Self {
        let layout = gpu::uniform_layout(device, "stroke");
        let coverage_layout = gpu::texture_layout(device, "stroke coverage", false);
        let cover = Self::cover_pipeline(device, &layout);
        let shader = gpu::shader(device, "stroke composite", include_str!("../../shaders/stroke_composite.wgsl"));
        let spec = PipelineSpec {
            label: "stroke composite",
            shader: &shader,
            fragment: "fs_main",
            groups: &[&layout, &coverage_layout],
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            format: gpu::PICTURE_FORMAT,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            samples: 1,
        };
        let composite = gpu::pipeline(device, &spec);
        Self { layout, coverage_layout, cover, composite }
    }

    fn cover_pipeline(device: &wgpu::Device, layout: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
        let shader = gpu::shader(device, "stroke", include_str!("../../shaders/stroke.wgsl"));
        // Both ends of a segment from the same buffer, bound a second time one
        // point further on.
        let start = wgpu::vertex_attr_array![0 => Float32x2];
        let end = wgpu::vertex_attr_array![1 => Float32x2];
        let per_segment = |attributes| {
            Some(wgpu::VertexBufferLayout { array_stride: 8, step_mode: wgpu::VertexStepMode::Instance, attributes })
        };
        let spec = PipelineSpec {
            label: "stroke coverage",
            shader: &shader,
            fragment: "fs_main",
            groups: &[layout],
            buffers: &[per_segment(&start[..]), per_segment(&end[..])],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            format: COVERAGE_FORMAT,
            blend: Some(wgpu::BlendState { color: MAXIMUM, alpha: MAXIMUM }),
            samples: 1,
        };
        gpu::pipeline(device, &spec)
    }

    /// Buffers without an outline.
    pub fn buffers(&self, device: &wgpu::Device) -> StrokeBuffers {
        StrokeBuffers {
            stroke: Uniform::new(device, &self.layout, size_of::<StrokeUniform>()),
            colour: Uniform::new(device, &self.layout, size_of::<[f32; 4]>()),
            points: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            segment_count: 0,
            origin: DVec2::ZERO,
        }
    }

    /// Draws the coverage of `stroke` into a cleared `COVERAGE_FORMAT` target.
    pub fn cover(&self, pass: &mut wgpu::RenderPass, stroke: &StrokeBuffers) {
        let Some(points) = stroke.points.get() else { return };
        pass.set_pipeline(&self.cover);
        pass.set_bind_group(0, &stroke.stroke.group, &[]);
        pass.set_vertex_buffer(0, points.slice(..));
        pass.set_vertex_buffer(1, points.slice(8..));
        pass.draw(0..4, 0..stroke.segment_count);
    }

    /// Lays the covered stroke over the picture.
    pub fn composite(&self, pass: &mut wgpu::RenderPass, stroke: &StrokeBuffers, coverage: &wgpu::BindGroup) {
        pass.set_pipeline(&self.composite);
        pass.set_bind_group(0, &stroke.colour.group, &[]);
        pass.set_bind_group(1, coverage, &[]);
        pass.draw(0..3, 0..1);
    }
}

impl StrokeBuffers {
    /// Replaces the closed outline; fewer than two points remove it. False when
    /// the device has no buffer of this size (the outline is removed).
    pub fn set(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        staging: &mut Vec<[f32; 2]>,
        points: &[DVec2],
    ) -> bool {
        self.segment_count = 0;
        if points.len() < 2 {
            return true;
        }
        self.origin = gpu::stage_points(staging, points);
        staging.push(staging[0]);
        let written = self.points.write(device, queue, staging);
        if written {
            self.segment_count = points.len() as u32;
        }
        written
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.segment_count == 0
    }

    /// Writes the uniform blocks of a frame.
    pub fn write_frame(&self, queue: &wgpu::Queue, camera: &Camera, size_px: [u32; 2], style: &StrokeStyle) {
        let width = style.width_px.max(0.0);
        // A line thinner than a pixel is drawn one pixel wide and fainter.
        let strength = width.min(1.0);
        let size = [size_px[0] as f32, size_px[1] as f32, 0.5 * width.max(1.0), 0.0];
        let placement = placement::to_pixels(camera, self.origin, size_px);
        self.stroke.write(queue, &StrokeUniform { placement, size });
        let [r, g, b, a] = linear_color(style.colour);
        self.colour.write(queue, &[r, g, b, a * strength]);
    }
}

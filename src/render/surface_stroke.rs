//! The boundary loop of a surface in space, of constant width on the screen (`shaders/surface_stroke.wgsl`).
//!
//! The stroke is drawn with the surface, into the same samples and depth: the surface hides it where it is
//! in front, and it is antialiased by 4 samples only. Strokes thinner than a pixel keep their width.

use super::eye_uniform::EyeUniform;
use super::gpu::{self, Depth, GrowingBuffer, PipelineSpec, Uniform};
use super::space_vertices::LocalFrame;
use super::style::linear_color;
use super::{OrbitCamera, StrokeStyle};
use glam::DVec3;

/// How much nearer to the eye the stroke is drawn, in its widths: on a surface inclined by up to 70°
/// the half of the stroke that lies on the surface is visible.
const LIFT: f64 = 1.5;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct StrokeUniform {
    eye: EyeUniform,
    colour: [f32; 4],
    size: [f32; 4],
}

/// The pipeline.
#[derive(Debug)]
pub struct SurfaceStrokePass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

/// One closed loop.
#[derive(Debug)]
pub struct SurfaceStrokeBuffers {
    uniform: Uniform,
    /// The points, with the first one repeated at the end.
    points: GrowingBuffer,
    segment_count: u32,
}

const STRIDE: u64 = size_of::<[f32; 3]>() as u64;

impl SurfaceStrokePass {
    /// A pipeline that draws into `PICTURE_FORMAT` and [`gpu::DEPTH_FORMAT`] with `samples` samples.
    pub fn new(device: &wgpu::Device, samples: u32) -> Self {
        let layout = gpu::uniform_layout(device, "surface stroke");
        let source =
            concat!(include_str!("../../shaders/space.wgsl"), include_str!("../../shaders/surface_stroke.wgsl"));
        let shader = gpu::shader(device, "surface stroke", source);
        let start = wgpu::vertex_attr_array![0 => Float32x3];
        let end = wgpu::vertex_attr_array![1 => Float32x3];
        let buffers = [&start, &end].map(|attributes| {
            Some(wgpu::VertexBufferLayout {
                array_stride: STRIDE,
                step_mode: wgpu::VertexStepMode::Instance,
                attributes,
            })
        });
        let spec = PipelineSpec {
            label: "surface stroke",
            shader: &shader,
            fragment: "fs_main",
            groups: &[&layout],
            buffers: &buffers,
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            format: gpu::PICTURE_FORMAT,
            blend: Some(if samples > 1 { COVERED } else { wgpu::BlendState::ALPHA_BLENDING }),
            samples,
        };
        let depth = Depth { vertex: "vs_main", written: false, alpha_to_coverage: samples > 1 };
        Self { pipeline: gpu::pipeline_with_depth(device, &spec, &depth), layout }
    }

    /// Buffers without a loop.
    pub fn buffers(&self, device: &wgpu::Device) -> SurfaceStrokeBuffers {
        SurfaceStrokeBuffers {
            uniform: Uniform::new(device, &self.layout, size_of::<StrokeUniform>()),
            points: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            segment_count: 0,
        }
    }

    /// Draws the loop over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, stroke: &SurfaceStrokeBuffers) {
        let Some(points) = stroke.points.get().filter(|_| stroke.segment_count > 0) else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &stroke.uniform.group, &[]);
        pass.set_vertex_buffer(0, points.slice(..));
        pass.set_vertex_buffer(1, points.slice(STRIDE..));
        pass.draw(0..4, 0..stroke.segment_count);
    }
}

/// A covered sample takes the full color, and becomes opaque where only the background was.
const COVERED: wgpu::BlendState = wgpu::BlendState {
    color: wgpu::BlendComponent::REPLACE,
    alpha: wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::One,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Max,
    },
};

impl SurfaceStrokeBuffers {
    /// Replaces the closed loop; fewer than two points remove it. False, with the loop removed, if the device
    /// has no buffer of this size.
    pub fn set(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, points: &[DVec3], frame: LocalFrame) -> bool {
        self.segment_count = 0;
        if points.len() < 2 {
            return true;
        }
        let closed = points.iter().chain(points.first()).map(|&p| frame.place(p));
        let written = self.points.write(device, queue, &closed.collect::<Vec<_>>());
        if written {
            self.segment_count = points.len() as u32;
        }
        written
    }

    /// Writes the uniform block of a frame.
    pub fn write_frame(
        &self,
        queue: &wgpu::Queue,
        camera: &OrbitCamera,
        frame: LocalFrame,
        size_px: [u32; 2],
        style: &StrokeStyle,
    ) {
        let width = style.width_px.max(1.0);
        let eye = EyeUniform::new(camera, frame, size_px, LIFT * f64::from(width), 1.0);
        let size = [size_px[0] as f32, size_px[1] as f32, 0.5 * width, 0.0];
        self.uniform.write(queue, &StrokeUniform { eye, colour: linear_color(style.colour), size });
    }
}

//! The Cauchy–Green extension on the GPU, equations (7) and (15): the pipelines of
//! `shaders/cauchy_green.wgsl`.
//!
//! A contour and the points inside it are uploaded once; a frame uploads the values at
//! the contour's vertices and evaluates f̂ at all points, in f32, into a buffer from which
//! `ViewportRenderer` copies: no value is read back before it is drawn. Γ is not stored.
//!
//! The images differ from those of [`Contour::evaluate`](crate::conformal::Contour::evaluate)
//! by at most [`CauchyGreenPass::ERROR`] of the values' extent, also next to the boundary and on
//! its vertices. Constants are exact to the f32 of the result. Points outside are not supported.

use super::cauchy_green_buffers::CauchyGreenBuffers;
use super::gpu;
use glam::DVec2;

/// Invocations of a workgroup; `WORKGROUP` of `shaders/cauchy_green.wgsl`.
const WORKGROUP: u32 = 64;

/// The storage buffers that the shader binds.
const STORAGE_BUFFERS: u32 = 4;

/// Pipelines for any number of contours.
#[derive(Debug)]
pub struct CauchyGreenPass {
    layout: wgpu::BindGroupLayout,
    evaluate: wgpu::ComputePipeline,
    nearest: wgpu::ComputePipeline,
}

impl CauchyGreenPass {
    /// The bound on the error of an image, relative to the extent of the values. f32 holds a
    /// value to 3e-8, of which Σ|γ| ≤ 8 come together; the terms and their sums add as much.
    /// Measured on lavapipe, on the boundary and down to 1e-8 of the extent beside it: up to
    /// 3.1e-7 for smooth values, 7.8e-7 for values that jump from vertex to vertex (V-shape,
    /// m = 1000). The rest is for other adapters, whose divisions may be coarser.
    pub const ERROR: f64 = 2e-6;

    /// `None` if the device has no compute shaders of this size, as with WebGL2.
    pub fn new(device: &wgpu::Device) -> Option<Self> {
        if !is_supported(&device.limits()) {
            return None;
        }
        let shader = gpu::shader(device, "Cauchy–Green", include_str!("../../shaders/cauchy_green.wgsl"));
        let layout = layout(device);
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("Cauchy–Green"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let [evaluate, nearest] = ["cs_evaluate", "cs_nearest"].map(|entry_point| {
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(entry_point),
                layout: Some(&pipeline_layout),
                module: &shader,
                entry_point: Some(entry_point),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            })
        });
        Some(Self { layout, evaluate, nearest })
    }

    /// Uploads a closed polygon (simple, counter-clockwise) and the points at which f̂ will
    /// be evaluated, each inside it or one of its vertices. `None` if they do not fit on the device, or
    /// there are none.
    pub fn buffers(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        contour: &[DVec2],
        points: &[DVec2],
    ) -> Option<CauchyGreenBuffers> {
        let workgroups = (points.len() as u64).div_ceil(u64::from(WORKGROUP));
        if workgroups > u64::from(device.limits().max_compute_workgroups_per_dimension) {
            return None;
        }
        let buffers = CauchyGreenBuffers::new(device, queue, &self.layout, contour, points)?;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("contour") });
        dispatch(&mut encoder, &self.nearest, &buffers);
        queue.submit([encoder.finish()]);
        Some(buffers)
    }

    /// Records the evaluation of f̂ at all points for the `values` at the contour's vertices.
    /// Call it once per submission. False, with nothing recorded, if their number is not the contour's.
    pub fn evaluate(
        &self,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        buffers: &mut CauchyGreenBuffers,
        values: impl IntoIterator<Item = DVec2>,
    ) -> bool {
        let fits = buffers.set_values(queue, values);
        if fits {
            dispatch(encoder, &self.evaluate, buffers);
        }
        fits
    }
}

/// Whether a device with these limits runs the shader. Without compute shaders they are 0.
fn is_supported(limits: &wgpu::Limits) -> bool {
    limits.max_storage_buffers_per_shader_stage >= STORAGE_BUFFERS
        && limits.max_compute_invocations_per_workgroup >= WORKGROUP
        && limits.max_compute_workgroup_size_x >= WORKGROUP
        && limits.max_compute_workgroup_storage_size >= WORKGROUP * (16 + 8)
}

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let storage = |read_only| wgpu::BufferBindingType::Storage { read_only };
    let kinds = [wgpu::BufferBindingType::Uniform, storage(true), storage(false), storage(true), storage(false)];
    let entries = [0, 1, 2, 3, 4].map(|binding| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty: kinds[binding as usize],
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    });
    let label = Some("Cauchy–Green");
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &entries })
}

fn dispatch(encoder: &mut wgpu::CommandEncoder, pipeline: &wgpu::ComputePipeline, buffers: &CauchyGreenBuffers) {
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(pipeline);
    pass.set_bind_group(0, buffers.group(), &[]);
    pass.dispatch_workgroups(buffers.point_count().div_ceil(WORKGROUP), 1, 1);
}

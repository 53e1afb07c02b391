//! The textured mesh: buffers, uniform block and the five pattern pipelines of
//! `shaders/mesh.wgsl`.
//!
//! Vertex positions and texture coordinates live in two buffers, since each
//! frame of a drag changes only one of them, and the local scale between them in a third. They are kept in f64 too, from
//! which the scale is computed; images that the GPU computes leave it as it is.

use super::gpu::{self, GrowingBuffer, PipelineSpec, Uniform};
use super::local_scale::{LocalScale, double_area};
use super::pattern_uniform::{PATTERN_FRAGMENTS, PatternUniform, pattern_index};
use super::{Camera, MeshGeometry, Pattern, TextureStyle, placement};
use glam::DVec2;

/// `View` of `shaders/mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct MeshUniform {
    placement: [f32; 4],
    pattern: PatternUniform,
}

/// The pipelines, one per pattern.
#[derive(Debug)]
pub struct MeshPass {
    layout: wgpu::BindGroupLayout,
    pipelines: [wgpu::RenderPipeline; PATTERN_FRAGMENTS.len()],
}

/// One viewport's mesh.
#[derive(Debug)]
pub struct MeshBuffers {
    uniform: Uniform,
    positions: GrowingBuffer,
    texture_coordinates: GrowingBuffer,
    scales: GrowingBuffer,
    indices: GrowingBuffer,
    points: [Vec<DVec2>; 2],
    scale: LocalScale,
    vertex_count: usize,
    index_count: u32,
    position_origin: DVec2,
    texture_origin: DVec2,
}

/// The settings with which a frame shows the mesh.
pub struct MeshFrame<'a> {
    pub camera: &'a Camera,
    pub size_px: [u32; 2],
    pub style: &'a TextureStyle,
    /// Width over height of the texture image.
    pub image_aspect: f64,
    pub line_px: f32,
}

impl MeshPass {
    /// Pipelines that draw into `PICTURE_FORMAT` with `samples` samples.
    pub fn new(device: &wgpu::Device, image_layout: &wgpu::BindGroupLayout, samples: u32) -> Self {
        let layout = gpu::uniform_layout(device, "mesh");
        let shader = gpu::shader(
            device,
            "mesh",
            concat!(
                include_str!("../../shaders/pattern.wgsl"),
                include_str!("../../shaders/tiling.wgsl"),
                include_str!("../../shaders/mesh.wgsl")
            ),
        );
        let position = wgpu::vertex_attr_array![0 => Float32x2];
        let texture_coordinate = wgpu::vertex_attr_array![1 => Float32x2];
        let scale = wgpu::vertex_attr_array![2 => Float32x2];
        let buffers = [(&position[..], 8), (&texture_coordinate[..], 8), (&scale[..], 8)]
            .map(|buffer| Some(attributes_of(buffer)));
        let pipelines = PATTERN_FRAGMENTS.map(|fragment| {
            let spec = PipelineSpec {
                label: fragment,
                shader: &shader,
                fragment,
                groups: &[&layout, image_layout],
                buffers: &buffers,
                topology: wgpu::PrimitiveTopology::TriangleList,
                format: gpu::PICTURE_FORMAT,
                blend: None,
                samples,
            };
            gpu::pipeline(device, &spec)
        });
        Self { layout, pipelines }
    }

    /// Empty buffers for a viewport.
    pub fn buffers(&self, device: &wgpu::Device) -> MeshBuffers {
        MeshBuffers {
            uniform: Uniform::new(device, &self.layout, size_of::<MeshUniform>()),
            positions: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            texture_coordinates: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            scales: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            indices: GrowingBuffer::new(wgpu::BufferUsages::INDEX),
            points: [const { Vec::new() }; 2],
            scale: LocalScale::default(),
            vertex_count: 0,
            index_count: 0,
            position_origin: DVec2::ZERO,
            texture_origin: DVec2::ZERO,
        }
    }

    /// Draws `mesh`, whose uniform block was written for this frame.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, mesh: &MeshBuffers, pattern: Pattern, image: &wgpu::BindGroup) {
        let (Some(positions), Some(coordinates), Some(scales), Some(indices)) =
            (mesh.positions.get(), mesh.texture_coordinates.get(), mesh.scales.get(), mesh.indices.get())
        else {
            return;
        };
        pass.set_pipeline(&self.pipelines[pattern_index(pattern)]);
        pass.set_bind_group(0, &mesh.uniform.group, &[]);
        pass.set_bind_group(1, image, &[]);
        pass.set_vertex_buffer(0, positions.slice(..));
        pass.set_vertex_buffer(1, coordinates.slice(..));
        pass.set_vertex_buffer(2, scales.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..mesh.index_count, 0, 0..1);
    }
}

/// A buffer of attributes by vertex, of this many bytes each.
pub(super) fn attributes_of(
    (attributes, array_stride): (&[wgpu::VertexAttribute], u64),
) -> wgpu::VertexBufferLayout<'_> {
    wgpu::VertexBufferLayout { array_stride, step_mode: wgpu::VertexStepMode::Vertex, attributes }
}

impl MeshBuffers {
    /// Replaces everything. False, with the old mesh kept, if `geometry` is
    /// inconsistent ([`MeshGeometry::check`]); false, with no mesh left, if
    /// the device has no buffers of this size.
    pub fn set(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        staging: &mut Vec<[f32; 2]>,
        geometry: &MeshGeometry,
    ) -> bool {
        if let Err(reason) = geometry.check() {
            log::error!("a mesh was not uploaded: {reason}");
            return false;
        }
        self.index_count = 0;
        self.vertex_count = geometry.positions.len();
        self.points = [geometry.positions.to_vec(), geometry.texture_coordinates.to_vec()];
        self.scale.set(self.vertex_count, geometry.triangles);
        if geometry.triangles.is_empty() {
            return true;
        }
        self.position_origin = gpu::stage_points(staging, geometry.positions);
        let positions = self.positions.write(device, queue, staging);
        self.texture_origin = gpu::stage_points(staging, geometry.texture_coordinates);
        let coordinates = self.texture_coordinates.write(device, queue, staging);
        let scales = self.scales.write(device, queue, compute(&mut self.scale, &self.points));
        let complete = positions && coordinates && scales && self.indices.write(device, queue, geometry.triangles);
        if complete {
            self.index_count = 3 * geometry.triangles.len() as u32;
        }
        complete
    }

    /// Moves the vertices; false when the count is not the mesh's.
    pub fn set_positions(&mut self, queue: &wgpu::Queue, staging: &mut Vec<[f32; 2]>, points: &[DVec2]) -> bool {
        if points.len() != self.vertex_count {
            return false;
        }
        self.position_origin = gpu::stage_points(staging, points);
        self.positions.overwrite(queue, staging);
        self.move_points(queue, 0, points);
        true
    }

    /// Replaces the texture coordinates; false when the count is not the mesh's.
    pub fn set_texture_coordinates(
        &mut self,
        queue: &wgpu::Queue,
        staging: &mut Vec<[f32; 2]>,
        points: &[DVec2],
    ) -> bool {
        if points.len() != self.vertex_count {
            return false;
        }
        self.texture_origin = gpu::stage_points(staging, points);
        self.texture_coordinates.overwrite(queue, staging);
        self.move_points(queue, 1, points);
        true
    }

    /// Replaces the positions (0) or the texture coordinates (1) that the local scale is computed from.
    fn move_points(&mut self, queue: &wgpu::Queue, which: usize, points: &[DVec2]) {
        self.points[which].clone_from_slice(points);
        self.scales.overwrite(queue, compute(&mut self.scale, &self.points));
    }

    /// As [`Self::set_positions`], from a buffer of f32 pairs relative to `origin`.
    pub fn copy_positions(&mut self, encoder: &mut wgpu::CommandEncoder, points: &wgpu::Buffer, origin: DVec2) -> bool {
        let copied = copy_points(encoder, points, &self.positions, self.vertex_count);
        if copied {
            self.position_origin = origin;
        }
        copied
    }

    /// As [`Self::set_texture_coordinates`], from a buffer of f32 pairs relative to `origin`.
    pub fn copy_texture_coordinates(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        points: &wgpu::Buffer,
        origin: DVec2,
    ) -> bool {
        let copied = copy_points(encoder, points, &self.texture_coordinates, self.vertex_count);
        if copied {
            self.texture_origin = origin;
        }
        copied
    }

    /// Writes the uniform block of a frame.
    pub fn write_frame(&self, queue: &wgpu::Queue, frame: &MeshFrame) {
        let MeshFrame { camera, size_px, style, image_aspect, line_px } = *frame;
        let pattern = PatternUniform::new(style, self.texture_origin, image_aspect, line_px);
        let pattern = pattern.in_octaves(style, size_px, camera.units_per_pixel);
        let placement = placement::to_clip(camera, self.position_origin, size_px);
        self.uniform.write(queue, &MeshUniform { placement, pattern });
    }
}

/// The local scale of these positions and texture coordinates.
fn compute<'a>(scale: &'a mut LocalScale, [positions, coordinates]: &[Vec<DVec2>; 2]) -> &'a [[f32; 2]] {
    scale.compute(|corners| double_area(coordinates, corners), |corners| double_area(positions, corners))
}

/// Copies the pairs; false if the sizes do not fit.
fn copy_points(encoder: &mut wgpu::CommandEncoder, from: &wgpu::Buffer, to: &GrowingBuffer, count: usize) -> bool {
    let size = 8 * count as u64;
    let Some(to) = to.get().filter(|to| from.size() == size && to.size() >= size) else { return false };
    encoder.copy_buffer_to_buffer(from, 0, to, 0, size);
    true
}

//! The mapped mesh triangle by triangle: buffers, textures and the two pipelines
//! of `shaders/cells.wgsl`.
//!
//! Every corner of a triangle is a vertex of its own and fetches its position
//! and its triangle's code from textures, so that a frame of a drag uploads 8
//! bytes per vertex and one per triangle, and colors are constant on triangles
//! with WebGPU and WebGL2 alike.

use super::cell_lookup::{Lookup, palette_groups};
use super::color_map::flipped_colour;
use super::gpu::{self, GrowingBuffer, PipelineSpec, Uniform};
use super::style::linear_color;
use super::{Camera, CellCode, CellStyle, ColourMap, placement};
use glam::DVec2;

/// Heights of cells, in points: edges of lower cells than the first vanish, those of higher cells than the second
/// have full strength. Lines 2 points apart merge into a tint; a wide fade is seen, since the two triangles at an edge
/// have different heights.
const EDGES_VANISH: f32 = 2.0;
const EDGES_SHOW: f32 = 3.5;

/// `Edges` of `shaders/cell_parts.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct EdgeUniform {
    wire: [f32; 4],
    mark: [f32; 4],
    size: [f32; 4],
}

impl EdgeUniform {
    /// The edges and marks of a style.
    pub fn new(style: &CellStyle) -> Self {
        let (colour, width) = style.wire.map_or(([0.0; 4], 1.0), |wire| (wire.colour, wire.width_px.max(0.0)));
        let [r, g, b, a] = linear_color(colour);
        let scale = style.pixels_per_point;
        Self {
            // A line thinner than a pixel is drawn one pixel wide and fainter.
            wire: [r, g, b, a * width.min(1.0)],
            mark: linear_color(flipped_colour()),
            size: [0.5 * width.max(1.0), EDGES_VANISH * scale, EDGES_SHOW * scale, 0.0],
        }
    }
}

/// `View` of `shaders/cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CellUniform {
    placement: [f32; 4],
    edges: EdgeUniform,
}

/// The pipelines and the palettes.
#[derive(Debug)]
pub struct CellPass {
    uniform_layout: wgpu::BindGroupLayout,
    lookup_layout: wgpu::BindGroupLayout,
    colour: wgpu::RenderPipeline,
    overlay: wgpu::RenderPipeline,
    palettes: [wgpu::BindGroup; 2],
}

/// One viewport's triangles.
#[derive(Debug)]
pub struct CellBuffers {
    uniform: Uniform,
    /// The vertex at every corner.
    corners: GrowingBuffer,
    lookup: Option<Lookup>,
    vertex_count: usize,
    triangle_count: usize,
    origin: DVec2,
}

impl CellPass {
    /// Pipelines that draw into `PICTURE_FORMAT` with `samples` samples.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, samples: u32) -> Self {
        let uniform_layout = gpu::uniform_layout(device, "cells");
        let lookup_layout = Lookup::layout(device);
        let (palette_layout, palettes) = palette_groups(device, queue);
        let shader = gpu::shader(
            device,
            "cells",
            concat!(include_str!("../../shaders/cell_parts.wgsl"), include_str!("../../shaders/cells.wgsl")),
        );
        let vertex = wgpu::vertex_attr_array![0 => Uint32];
        let corners =
            wgpu::VertexBufferLayout { array_stride: 4, step_mode: wgpu::VertexStepMode::Vertex, attributes: &vertex };
        let pipeline = |fragment, blend| {
            let spec = PipelineSpec {
                label: fragment,
                shader: &shader,
                fragment,
                groups: &[&uniform_layout, &lookup_layout, &palette_layout],
                buffers: &[Some(corners.clone())],
                topology: wgpu::PrimitiveTopology::TriangleList,
                format: gpu::PICTURE_FORMAT,
                blend,
                samples,
            };
            gpu::pipeline(device, &spec)
        };
        let colour = pipeline("fs_colour", None);
        let overlay = pipeline("fs_overlay", Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING));
        Self { uniform_layout, lookup_layout, colour, overlay, palettes }
    }

    /// Buffers without triangles.
    pub fn buffers(&self, device: &wgpu::Device) -> CellBuffers {
        CellBuffers {
            uniform: Uniform::new(device, &self.uniform_layout, size_of::<CellUniform>()),
            corners: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            lookup: None,
            vertex_count: 0,
            triangle_count: 0,
            origin: DVec2::ZERO,
        }
    }

    /// Replaces a viewport's triangles, all vertices of which must exist; all of
    /// them have code 0. False, with none left, if they do not fit on the device.
    pub fn set(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        cells: &mut CellBuffers,
        staging: &mut Vec<[f32; 2]>,
        positions: &[DVec2],
        triangles: &[[u32; 3]],
    ) -> bool {
        (cells.vertex_count, cells.triangle_count) = (positions.len(), 0);
        if triangles.is_empty() {
            return true;
        }
        let counts = [positions.len(), triangles.len()];
        let format = wgpu::TextureFormat::Rg32Float;
        let complete = Lookup::provide(&mut cells.lookup, device, &self.lookup_layout, format, counts)
            && cells.corners.write(device, queue, triangles);
        if !complete {
            return false;
        }
        cells.triangle_count = triangles.len();
        cells.set_positions(queue, staging, positions)
    }

    /// Draws all triangles in the colors of `map`.
    pub fn draw_colors(&self, pass: &mut wgpu::RenderPass, cells: &CellBuffers, map: ColourMap) {
        self.draw(pass, cells, &self.colour, map);
    }

    /// Draws edges and marks over the picture.
    pub fn draw_overlay(&self, pass: &mut wgpu::RenderPass, cells: &CellBuffers) {
        self.draw(pass, cells, &self.overlay, ColourMap::Cividis);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass, cells: &CellBuffers, pipeline: &wgpu::RenderPipeline, map: ColourMap) {
        let (Some(corners), Some(lookup)) = (cells.corners.get(), &cells.lookup) else { return };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &cells.uniform.group, &[]);
        pass.set_bind_group(1, &lookup.group, &[]);
        pass.set_bind_group(2, &self.palettes[map as usize], &[]);
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.draw(0..3 * cells.triangle_count as u32, 0..1);
    }
}

impl CellBuffers {
    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.triangle_count == 0
    }

    /// Moves the vertices; false when the count is not the mesh's.
    pub fn set_positions(&mut self, queue: &wgpu::Queue, staging: &mut Vec<[f32; 2]>, points: &[DVec2]) -> bool {
        let Some(lookup) = self.lookup.as_ref().filter(|_| points.len() == self.vertex_count) else { return false };
        self.origin = gpu::stage_points(staging, points);
        lookup.write_positions(queue, staging);
        true
    }

    /// Recolors the triangles; false when the count is not the mesh's.
    pub fn set_codes(&self, queue: &wgpu::Queue, codes: &mut Vec<CellCode>) -> bool {
        let Some(lookup) = self.lookup.as_ref().filter(|_| codes.len() == self.triangle_count) else { return false };
        lookup.write_codes(queue, codes);
        true
    }

    /// Writes the uniform block of a frame.
    pub fn write_frame(&self, queue: &wgpu::Queue, camera: &Camera, size_px: [u32; 2], style: &CellStyle) {
        let placement = placement::to_clip(camera, self.origin, size_px);
        self.uniform.write(queue, &CellUniform { placement, edges: EdgeUniform::new(style) });
    }
}

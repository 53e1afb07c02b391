//! The mapped mesh triangle by triangle: buffers, textures and the two pipelines
//! of `shaders/cells.wgsl`.
//!
//! Every corner of a triangle is a vertex of its own and fetches its position
//! and its triangle's code from textures, so that a frame of a drag uploads 8
//! bytes per vertex and one per triangle, and colours are constant on triangles
//! with WebGPU and WebGL2 alike. Rows of textures are [`ROW`] texels long:
//! WebGL2 guarantees no more, which allows for 4 million triangles.

use super::colour_map::flipped_colour;
use super::gpu::{self, GrowingBuffer, PipelineSpec, Uniform};
use super::style::linear_colour;
use super::{Camera, CellCode, CellStyle, ColourMap, placement};
use glam::DVec2;

/// Texels per row; `ROW` of `shaders/cells.wgsl`.
const ROW: u32 = 2048;

/// Edges of cells lower than the first vanish, of those higher than the second are
/// drawn in full strength, in points: lines 3 points apart merge into a tint.
const EDGES_VANISH: f32 = 2.5;
const EDGES_SHOW: f32 = 6.0;

/// `Cells` of `shaders/cells.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct CellUniform {
    placement: [f32; 4],
    wire: [f32; 4],
    mark: [f32; 4],
    size: [f32; 4],
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

/// Positions by vertex and codes by triangle.
#[derive(Debug)]
struct Lookup {
    positions: wgpu::Texture,
    codes: wgpu::Texture,
    group: wgpu::BindGroup,
}

impl CellPass {
    /// Pipelines that draw into `PICTURE_FORMAT` with `samples` samples.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, samples: u32) -> Self {
        let uniform_layout = gpu::uniform_layout(device, "cells");
        let lookup_layout = lookup_layout(device);
        let palette_layout = gpu::texture_layout(device, "palette", false);
        let shader = gpu::shader(device, "cells", include_str!("../../shaders/cells.wgsl"));
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
        let palettes =
            [ColourMap::Cividis, ColourMap::Diverging].map(|map| palette_group(device, queue, &palette_layout, map));
        Self { uniform_layout, lookup_layout, colour, overlay, palettes }
    }

    /// No triangles.
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

    /// Replaces a viewport's triangles, of which each vertex has to exist; all of
    /// them have code 0. False, and none are left, where they do not fit on the device.
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
        let limit = device.limits().max_texture_dimension_2d;
        if triangles.is_empty() || positions.len().max(triangles.len()).div_ceil(ROW as usize) > limit as usize {
            return triangles.is_empty();
        }
        if !cells.corners.write(device, queue, triangles) {
            return false;
        }
        cells.provide_lookup(device, &self.lookup_layout, positions.len(), triangles.len());
        cells.triangle_count = triangles.len();
        cells.set_positions(queue, staging, positions)
    }

    /// Draws all triangles in the colours of `map`.
    pub fn draw_colours(&self, pass: &mut wgpu::RenderPass, cells: &CellBuffers, map: ColourMap) {
        self.draw(pass, cells, &self.colour, map);
    }

    /// Draws edges and marks over what is there.
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
        staging.resize(staging.len().next_multiple_of(ROW as usize), [0.0; 2]);
        write_rows(queue, &lookup.positions, staging);
        true
    }

    /// Recolours the triangles; false when the count is not the mesh's.
    pub fn set_codes(&self, queue: &wgpu::Queue, codes: &mut Vec<CellCode>) -> bool {
        let Some(lookup) = self.lookup.as_ref().filter(|_| codes.len() == self.triangle_count) else { return false };
        codes.resize(codes.len().next_multiple_of(ROW as usize), CellCode::COLLAPSED);
        write_rows(queue, &lookup.codes, codes);
        codes.truncate(self.triangle_count);
        true
    }

    /// Textures with room for so many vertices and triangles.
    fn provide_lookup(
        &mut self,
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        vertices: usize,
        triangles: usize,
    ) {
        let rows = |count: usize| count.div_ceil(ROW as usize) as u32;
        let large_enough =
            |lookup: &Lookup| lookup.positions.height() >= rows(vertices) && lookup.codes.height() >= rows(triangles);
        if self.lookup.as_ref().is_some_and(large_enough) {
            return;
        }
        let positions = lookup_texture(device, wgpu::TextureFormat::Rg32Float, rows(vertices));
        let codes = lookup_texture(device, wgpu::TextureFormat::R8Uint, rows(triangles));
        let [a, b] = [&positions, &codes].map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()));
        let entry =
            |binding, view| wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) };
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("cells"),
            layout,
            entries: &[entry(0, &a), entry(1, &b)],
        });
        self.lookup = Some(Lookup { positions, codes, group });
    }

    /// Writes the uniform block of a frame.
    pub fn write_frame(&self, queue: &wgpu::Queue, camera: &Camera, size_px: [u32; 2], style: &CellStyle) {
        let (colour, width) = style.wire.map_or(([0.0; 4], 1.0), |wire| (wire.colour, wire.width_px.max(0.0)));
        let [r, g, b, a] = linear_colour(colour);
        // Below a pixel the line keeps its width and loses strength.
        let wire = [r, g, b, a * width.min(1.0)];
        let scale = style.pixels_per_point;
        let size = [0.5 * width.max(1.0), EDGES_VANISH * scale, EDGES_SHOW * scale, 0.0];
        let placement = placement::to_clip(camera, self.origin, size_px);
        self.uniform.write(queue, &CellUniform { placement, wire, mark: linear_colour(flipped_colour()), size });
    }
}

/// Fills the first rows of `texture` with whole rows of `texels`.
fn write_rows<T: bytemuck::Pod>(queue: &wgpu::Queue, texture: &wgpu::Texture, texels: &[T]) {
    let bytes_per_row = Some(ROW * size_of::<T>() as u32);
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None };
    let size = wgpu::Extent3d { width: ROW, height: texels.len() as u32 / ROW, depth_or_array_layers: 1 };
    queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(texels), layout, size);
}

fn lookup_texture(device: &wgpu::Device, format: wgpu::TextureFormat, rows: u32) -> wgpu::Texture {
    texture(device, format, [ROW, rows])
}

fn texture(device: &wgpu::Device, format: wgpu::TextureFormat, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("cells"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

/// Positions and codes, for the vertex stage.
fn lookup_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entry = |binding, sample_type| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("cells"),
        entries: &[
            entry(0, wgpu::TextureSampleType::Float { filterable: false }),
            entry(1, wgpu::TextureSampleType::Uint),
        ],
    })
}

fn palette_group(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    layout: &wgpu::BindGroupLayout,
    map: ColourMap,
) -> wgpu::BindGroup {
    let colours = map.palette();
    let texture = texture(device, wgpu::TextureFormat::Rgba8UnormSrgb, [colours.len() as u32, 1]);
    let row = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * 256), rows_per_image: None };
    queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(&colours), row, texture.size());
    gpu::texture_group(device, layout, &texture.create_view(&wgpu::TextureViewDescriptor::default()), None)
}

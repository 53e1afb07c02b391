//! A surface in space: its buffers, the pipelines of its texture (`shaders/surface.wgsl`) and of its triangles
//! (`shaders/surface_cells.wgsl`), with depth.
//!
//! Positions and normals are uploaded once, texture coordinates in each frame of a drag. For colors and edges of
//! triangles every corner is a separate vertex, as in [`super::cell_pass`].

use super::cell_lookup::{Lookup, palette_groups};
use super::cell_pass::EdgeUniform;
use super::eye_uniform::EyeUniform;
use super::gpu::{self, Depth, GrowingBuffer, PipelineSpec, Uniform};
use super::local_scale::{LocalScale, double_area};
use super::mesh_pass::attributes_of;
use super::pattern_uniform::{PATTERN_FRAGMENTS, PatternUniform, pattern_index};
use super::space_vertices::{self, LocalFrame, SpaceVertex};
use super::{CellCode, CellStyle, ColourMap, OrbitCamera, Pattern, SurfaceGeometry, TextureStyle};
use glam::{DVec2, DVec3};

/// Edges are drawn nearer to the eye than their triangles, by the length of this many pixels.
const EDGE_LIFT_PX: f64 = 0.75;

/// The light's part of a texture's color, and of a triangle's color, which must remain readable.
const LIGHT: f32 = 1.0;
const LIGHT_ON_CELLS: f32 = 0.5;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SurfaceUniform {
    eye: EyeUniform,
    pattern: PatternUniform,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct SurfaceCellUniform {
    eye: EyeUniform,
    edges: EdgeUniform,
}

/// The pipelines and the palettes.
#[derive(Debug)]
pub struct SurfacePass {
    layout: wgpu::BindGroupLayout,
    lookup_layout: wgpu::BindGroupLayout,
    textured: [wgpu::RenderPipeline; PATTERN_FRAGMENTS.len()],
    colour: wgpu::RenderPipeline,
    overlay: wgpu::RenderPipeline,
    palettes: [wgpu::BindGroup; 2],
}

/// One surface.
#[derive(Debug)]
pub struct SurfaceBuffers {
    uniform: Uniform,
    cell_uniform: Uniform,
    vertices: GrowingBuffer,
    coordinates: GrowingBuffer,
    scales: GrowingBuffer,
    /// The places in the local frame, for the local scale.
    places: Vec<DVec3>,
    scale: LocalScale,
    indices: GrowingBuffer,
    /// The vertex at every corner of the cells: the indices again, since WebGL cannot bind an index buffer as vertices.
    corners: GrowingBuffer,
    lookup: Option<Lookup>,
    vertex_count: usize,
    triangle_count: usize,
    pub frame: LocalFrame,
    coordinate_origin: DVec2,
}

/// The settings with which a frame shows the surface.
pub struct SurfaceView<'a> {
    pub camera: &'a OrbitCamera,
    pub size_px: [u32; 2],
    pub style: &'a TextureStyle,
    /// Width over height of the texture image.
    pub image_aspect: f64,
    pub line_px: f32,
    pub cells: Option<&'a CellStyle>,
}

impl SurfacePass {
    /// Pipelines that draw into `PICTURE_FORMAT` and [`gpu::DEPTH_FORMAT`] with `samples` samples.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue, image_layout: &wgpu::BindGroupLayout, samples: u32) -> Self {
        let layout = gpu::uniform_layout(device, "surface");
        let lookup_layout = Lookup::layout(device);
        let (palette_layout, palettes) = palette_groups(device, queue);
        let textured = textured_pipelines(device, &[&layout, image_layout], samples);
        let groups = [&layout, &lookup_layout, &palette_layout];
        let [colour, overlay] = cell_pipelines(device, &groups, samples);
        Self { layout, lookup_layout, textured, colour, overlay, palettes }
    }

    /// Buffers without a surface.
    pub fn buffers(&self, device: &wgpu::Device) -> SurfaceBuffers {
        SurfaceBuffers {
            uniform: Uniform::new(device, &self.layout, size_of::<SurfaceUniform>()),
            cell_uniform: Uniform::new(device, &self.layout, size_of::<SurfaceCellUniform>()),
            vertices: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            coordinates: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            scales: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            places: Vec::new(),
            scale: LocalScale::default(),
            indices: GrowingBuffer::new(wgpu::BufferUsages::INDEX),
            corners: GrowingBuffer::new(wgpu::BufferUsages::VERTEX),
            lookup: None,
            vertex_count: 0,
            triangle_count: 0,
            frame: LocalFrame::default(),
            coordinate_origin: DVec2::ZERO,
        }
    }

    /// Replaces the surface, whose geometry must be consistent; false, with none left, if the device cannot hold it.
    pub fn set(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        surface: &mut SurfaceBuffers,
        staging: &mut Vec<SpaceVertex>,
        geometry: &SurfaceGeometry,
    ) -> bool {
        let SurfaceGeometry { positions, triangles, .. } = *geometry;
        (surface.vertex_count, surface.triangle_count) = (positions.len(), 0);
        surface.scale.set(positions.len(), triangles);
        if triangles.is_empty() {
            return true;
        }
        surface.frame = space_vertices::stage(staging, positions, triangles);
        surface.places = positions.iter().map(|p| (*p - surface.frame.origin) / surface.frame.unit).collect();
        let blank = vec![[0.0_f32; 2]; positions.len()];
        let complete = surface.vertices.write(device, queue, staging)
            && surface.scales.write(device, queue, &blank)
            && surface.coordinates.write(device, queue, &blank)
            && surface.indices.write(device, queue, triangles)
            && surface.corners.write(device, queue, triangles)
            && Lookup::provide(
                &mut surface.lookup,
                device,
                &self.lookup_layout,
                wgpu::TextureFormat::Rgba32Float,
                [positions.len(), triangles.len()],
            );
        if complete && let Some(lookup) = &surface.lookup {
            lookup.write_positions(queue, staging);
            surface.triangle_count = triangles.len();
        }
        complete
    }

    /// Draws the surface in a pattern.
    pub fn draw_texture(
        &self,
        pass: &mut wgpu::RenderPass,
        surface: &SurfaceBuffers,
        pattern: Pattern,
        image: &wgpu::BindGroup,
    ) {
        let (Some(vertices), Some(coordinates), Some(scales), Some(indices)) =
            (surface.vertices.get(), surface.coordinates.get(), surface.scales.get(), surface.indices.get())
        else {
            return;
        };
        pass.set_pipeline(&self.textured[pattern_index(pattern)]);
        pass.set_bind_group(0, &surface.uniform.group, &[]);
        pass.set_bind_group(1, image, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_vertex_buffer(1, coordinates.slice(..));
        pass.set_vertex_buffer(2, scales.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..3 * surface.triangle_count as u32, 0, 0..1);
    }

    /// Draws all triangles in the colors of `map`.
    pub fn draw_colors(&self, pass: &mut wgpu::RenderPass, surface: &SurfaceBuffers, map: ColourMap) {
        self.draw_cells(pass, surface, &self.colour, map);
    }

    /// Draws edges and marks over the picture.
    pub fn draw_overlay(&self, pass: &mut wgpu::RenderPass, surface: &SurfaceBuffers) {
        self.draw_cells(pass, surface, &self.overlay, ColourMap::Cividis);
    }

    fn draw_cells(
        &self,
        pass: &mut wgpu::RenderPass,
        surface: &SurfaceBuffers,
        pipeline: &wgpu::RenderPipeline,
        map: ColourMap,
    ) {
        let (Some(corners), Some(lookup)) = (surface.corners.get(), &surface.lookup) else { return };
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &surface.cell_uniform.group, &[]);
        pass.set_bind_group(1, &lookup.group, &[]);
        pass.set_bind_group(2, &self.palettes[map as usize], &[]);
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.draw(0..3 * surface.triangle_count as u32, 0..1);
    }
}

impl SurfaceBuffers {
    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.triangle_count == 0
    }

    /// Replaces the texture coordinates; false when the count is not the surface's.
    pub fn set_coordinates(&mut self, queue: &wgpu::Queue, staging: &mut Vec<[f32; 2]>, points: &[DVec2]) -> bool {
        if points.len() != self.vertex_count {
            return false;
        }
        self.coordinate_origin = gpu::stage_points(staging, points);
        self.coordinates.overwrite(queue, staging);
        let places = &self.places;
        let drawn = |[a, b, c]: [usize; 3]| (places[b] - places[a]).cross(places[c] - places[a]).length();
        self.scales.overwrite(queue, self.scale.compute(|corners| double_area(points, corners), drawn));
        true
    }

    /// Recolors the triangles; false when the count is not the surface's.
    pub fn set_codes(&self, queue: &wgpu::Queue, codes: &mut Vec<CellCode>) -> bool {
        let Some(lookup) = self.lookup.as_ref().filter(|_| codes.len() == self.triangle_count) else { return false };
        lookup.write_codes(queue, codes);
        true
    }

    /// Writes the uniform blocks of a frame.
    pub fn write_frame(&self, queue: &wgpu::Queue, view: &SurfaceView) {
        let eye = |light| EyeUniform::new(view.camera, self.frame, view.size_px, EDGE_LIFT_PX, light);
        let SurfaceView { style, size_px, image_aspect, line_px, .. } = *view;
        let pattern = PatternUniform::new(style, self.coordinate_origin, image_aspect, line_px);
        // lengths and distances in the frame's unit
        let pattern = pattern.in_octaves(style, size_px, view.camera.units_per_pixel_at_one(size_px));
        self.uniform.write(queue, &SurfaceUniform { eye: eye(LIGHT), pattern });
        if let Some(style) = view.cells {
            self.cell_uniform
                .write(queue, &SurfaceCellUniform { eye: eye(LIGHT_ON_CELLS), edges: EdgeUniform::new(style) });
        }
    }
}

fn textured_pipelines(
    device: &wgpu::Device,
    groups: &[&wgpu::BindGroupLayout],
    samples: u32,
) -> [wgpu::RenderPipeline; PATTERN_FRAGMENTS.len()] {
    let source = concat!(
        include_str!("../../shaders/space.wgsl"),
        include_str!("../../shaders/pattern.wgsl"),
        include_str!("../../shaders/tiling.wgsl"),
        include_str!("../../shaders/surface.wgsl")
    );
    let shader = gpu::shader(device, "surface", source);
    let vertex = wgpu::vertex_attr_array![0 => Float32x4];
    let coordinate = wgpu::vertex_attr_array![1 => Float32x2];
    let scale = wgpu::vertex_attr_array![2 => Float32x2];
    let buffers = [(&vertex[..], 16), (&coordinate[..], 8), (&scale[..], 8)].map(|buffer| Some(attributes_of(buffer)));
    PATTERN_FRAGMENTS.map(|fragment| {
        let spec = PipelineSpec {
            label: fragment,
            shader: &shader,
            fragment,
            groups,
            buffers: &buffers,
            topology: wgpu::PrimitiveTopology::TriangleList,
            format: gpu::PICTURE_FORMAT,
            blend: None,
            samples,
        };
        gpu::pipeline_with_depth(device, &spec, &Depth { vertex: "vs_main", written: true, alpha_to_coverage: false })
    })
}

/// The pipelines of colors, and of edges and marks.
fn cell_pipelines(device: &wgpu::Device, groups: &[&wgpu::BindGroupLayout], samples: u32) -> [wgpu::RenderPipeline; 2] {
    let source = concat!(
        include_str!("../../shaders/space.wgsl"),
        include_str!("../../shaders/cell_parts.wgsl"),
        include_str!("../../shaders/surface_cells.wgsl")
    );
    let shader = gpu::shader(device, "surface cells", source);
    let vertex = wgpu::vertex_attr_array![0 => Uint32];
    let corners =
        wgpu::VertexBufferLayout { array_stride: 4, step_mode: wgpu::VertexStepMode::Vertex, attributes: &vertex };
    let over = Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
    [("vs_main", "fs_colour", None), ("vs_overlay", "fs_overlay", over)].map(|(vertex, fragment, blend)| {
        let spec = PipelineSpec {
            label: fragment,
            shader: &shader,
            fragment,
            groups,
            buffers: &[Some(corners.clone())],
            topology: wgpu::PrimitiveTopology::TriangleList,
            format: gpu::PICTURE_FORMAT,
            blend,
            samples,
        };
        gpu::pipeline_with_depth(device, &spec, &Depth { vertex, written: blend.is_none(), alpha_to_coverage: false })
    })
}

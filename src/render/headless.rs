//! Rendering scenes into images without a window, natively.
//!
//! The scene goes through the same `prepare` and `paint` as on screen, into a
//! target like egui's, and is read back row by row. Works on any adapter,
//! software ones included; the pixels of two adapters may differ by rounding.

use super::targets::attachment;
use super::{
    Camera, CellCode, CellStyle, Handle, MeshGeometry, RenderError, SceneSurface, StrokeStyle, TextureStyle,
    ViewportRenderer,
};
use glam::DVec2;
use image::RgbaImage;

/// Like egui's target: sRGB-encoded bytes, encoded by the shader.
const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// One of the pictures of a scene.
#[derive(Clone, Debug)]
pub struct SceneViewport<'a> {
    /// The textured mesh.
    pub geometry: MeshGeometry<'a>,
    /// The closed outline; may be empty.
    pub boundary: &'a [DVec2],
    /// Its stroke; `None`: the theme's.
    pub boundary_style: Option<StrokeStyle>,
    /// `None`: fit the positions with [`SceneDescription::margin_px`].
    pub camera: Option<Camera>,
    /// The texture.
    pub style: TextureStyle,
    /// Colours and edges of triangles, over the texture.
    pub cells: Option<SceneCells<'a>>,
    /// Discs on top.
    pub handles: &'a [Handle],
}

/// A mesh that is shown triangle by triangle.
#[derive(Clone, Copy, Debug)]
pub struct SceneCells<'a> {
    /// Where each vertex is drawn.
    pub positions: &'a [DVec2],
    /// Vertex indices.
    pub triangles: &'a [[u32; 3]],
    /// The codes of the triangles; empty: 0 for all.
    pub codes: &'a [CellCode],
    /// How.
    pub style: CellStyle,
}

/// Viewports side by side, of equal width, on one background.
#[derive(Clone, Debug)]
pub struct SceneDescription<'a> {
    /// From left to right.
    pub viewports: &'a [SceneViewport<'a>],
    /// sRGB-encoded, straight alpha.
    pub background: [f32; 4],
    /// The image of `Pattern::Image`.
    pub image: Option<&'a RgbaImage>,
    /// Free space around a fitted mesh.
    pub margin_px: f32,
}

/// A device on any adapter, hardware preferred, software accepted.
///
/// It is asked for no more than WebGL2 has, but for the adapter's largest
/// textures, so what renders here also renders in a browser; and for compute
/// shaders as WebGPU has them, where the adapter does.
pub fn headless_device() -> Result<(wgpu::Device, wgpu::Queue, wgpu::AdapterInfo), RenderError> {
    // OpenGL only where nothing else is: without a display, its libraries complain on stderr
    let adapter = adapter_on(wgpu::Backends::PRIMARY)
        .or_else(|_| adapter_on(wgpu::Backends::all()))
        .map_err(|error| RenderError::NoAdapter { cause: error.to_string() })?;
    let info = adapter.get_info();
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("headless"),
        required_limits: limits(&adapter),
        ..wgpu::DeviceDescriptor::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
        .map_err(|error| RenderError::NoDevice { adapter: info.name.clone(), cause: error.to_string() })?;
    Ok((device, queue, info))
}

fn limits(adapter: &wgpu::Adapter) -> wgpu::Limits {
    let webgl = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
    if !adapter.get_downlevel_capabilities().flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS) {
        return webgl;
    }
    let compute = wgpu::Limits::downlevel_defaults();
    wgpu::Limits {
        max_storage_buffers_per_shader_stage: compute.max_storage_buffers_per_shader_stage,
        max_storage_buffer_binding_size: compute.max_storage_buffer_binding_size,
        max_compute_workgroup_storage_size: compute.max_compute_workgroup_storage_size,
        max_compute_invocations_per_workgroup: compute.max_compute_invocations_per_workgroup,
        max_compute_workgroup_size_x: compute.max_compute_workgroup_size_x,
        max_compute_workgroup_size_y: compute.max_compute_workgroup_size_y,
        max_compute_workgroup_size_z: compute.max_compute_workgroup_size_z,
        max_compute_workgroups_per_dimension: compute.max_compute_workgroups_per_dimension,
        ..webgl
    }
}

/// An adapter on one of `backends`, or on those that `WGPU_BACKEND` names.
fn adapter_on(backends: wgpu::Backends) -> Result<wgpu::Adapter, wgpu::RequestAdapterError> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..wgpu::RequestAdapterOptions::default()
    };
    pollster::block_on(wgpu::Instance::new(descriptor.with_env()).request_adapter(&options))
}

/// [`render_scene_with`] on a device of its own.
pub fn render_scene(scene: &SceneDescription, size: [u32; 2]) -> Result<RgbaImage, RenderError> {
    let (device, queue, _) = headless_device()?;
    render_scene_with(&device, &queue, scene, size)
}

/// Renders `scene` into an sRGB image of `size` pixels with straight alpha.
///
/// Viewport k takes the columns from ⌊k·w/n⌋ to ⌊(k+1)·w/n⌋.
pub fn render_scene_with(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<RgbaImage, RenderError> {
    render(device, queue, None, scene, size)
}

/// [`render_scene_with`], with a surface beside the viewports, of which there may be none, as wide as each of them.
pub fn render_surface_with(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    surface: &SceneSurface,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<RgbaImage, RenderError> {
    surface.check()?;
    render(device, queue, Some(surface), scene, size)
}

fn render(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    surface: Option<&SceneSurface>,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<RgbaImage, RenderError> {
    check(device, surface.is_some(), scene, size)?;
    let scope = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let image = draw(device, queue, surface, scene, size).and_then(|target| read_back(device, queue, &target));
    match pollster::block_on(scope.pop()) {
        Some(error) => Err(RenderError::Device(error.to_string())),
        None => image,
    }
}

fn check(
    device: &wgpu::Device,
    with_surface: bool,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<(), RenderError> {
    let [width, height] = size;
    let limit = device.limits().max_texture_dimension_2d;
    if width.min(height) == 0 || width.max(height) > limit {
        return Err(RenderError::Size { width, height, limit });
    }
    let count = usize::from(with_surface) + scene.viewports.len();
    if count == 0 || count > width as usize {
        return Err(RenderError::ViewportCount { count, limit: width });
    }
    for (viewport, part) in scene.viewports.iter().enumerate() {
        part.geometry.check().map_err(|reason| RenderError::Geometry { viewport, reason })?;
    }
    Ok(())
}

/// How a picture is divided from left to right.
#[derive(Clone, Copy, Debug)]
struct Columns {
    count: usize,
    /// The one that a surface has.
    surface: Option<usize>,
}

impl Columns {
    fn new(surface: Option<&SceneSurface>, scene: &SceneDescription) -> Self {
        let planar = scene.viewports.len();
        let place = surface.map(|surface| if surface.right { planar } else { 0 });
        Self { count: planar + usize::from(surface.is_some()), surface: place }
    }

    /// The left edge of column `k` in a picture of this width.
    fn edge(self, k: usize, width: u32) -> u32 {
        (k as u64 * u64::from(width) / self.count as u64) as u32
    }

    fn of_viewport(self, k: usize) -> usize {
        k + usize::from(self.surface == Some(0))
    }
}

fn draw(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    surface: Option<&SceneSurface>,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<wgpu::Texture, RenderError> {
    let columns = Columns::new(surface, scene);
    let mut renderer = ViewportRenderer::new(device, queue, TARGET_FORMAT, scene.viewports.len());
    if let Some(image) = scene.image {
        renderer.set_image(device, queue, image.as_raw(), image.width(), image.height())?;
    }
    let target = target_texture(device, size);
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("scene") });
    let size_of = |k| [columns.edge(k + 1, size[0]) - columns.edge(k, size[0]), size[1]];
    if let (Some(surface), Some(column)) = (surface, columns.surface) {
        surface.prepare(device, queue, &mut renderer, &mut encoder, size_of(column), scene.background)?;
    }
    for (k, part) in scene.viewports.iter().enumerate() {
        upload(device, queue, &mut renderer, k, part)?;
        let size_px = size_of(columns.of_viewport(k));
        let camera = part.camera.unwrap_or_else(|| fitted(part.geometry.positions, size_px, scene.margin_px));
        renderer.prepare(device, queue, &mut encoder, k, size_px, &camera, &part.style, scene.background);
    }
    paint(&mut encoder, &renderer, columns, &target);
    queue.submit([encoder.finish()]);
    Ok(target)
}

fn upload(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    renderer: &mut ViewportRenderer,
    viewport: usize,
    part: &SceneViewport,
) -> Result<(), RenderError> {
    let cells = part.cells.as_ref();
    let uploaded = renderer.set_mesh(device, queue, viewport, &part.geometry)
        && renderer.set_boundary(device, queue, viewport, part.boundary)
        && cells.is_none_or(|cells| {
            renderer.set_cells(device, queue, viewport, cells.positions, cells.triangles)
                && (cells.codes.is_empty() || renderer.set_cell_codes(queue, viewport, &mut cells.codes.to_vec()))
        });
    if !uploaded {
        let reason = format!("{} triangles do not fit on the graphics device", part.geometry.triangles.len());
        return Err(RenderError::Geometry { viewport, reason });
    }
    renderer.set_cell_style(viewport, cells.map(|cells| cells.style));
    renderer.set_boundary_style(viewport, part.boundary_style);
    renderer.set_handles(device, queue, viewport, part.handles);
    Ok(())
}

fn fitted(positions: &[DVec2], size_px: [u32; 2], margin_px: f32) -> Camera {
    let (low, high) =
        positions.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    let bounds = if low.is_finite() && high.is_finite() { (low, high) } else { (DVec2::ZERO, DVec2::ONE) };
    Camera::fit(bounds, size_px.map(|side| side as f32), margin_px)
}

fn paint(encoder: &mut wgpu::CommandEncoder, renderer: &ViewportRenderer, columns: Columns, target: &wgpu::Texture) {
    let view = target.create_view(&wgpu::TextureViewDescriptor::default());
    let clear = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);
    let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("scene"),
        color_attachments: &[Some(attachment(&view, clear))],
        ..Default::default()
    });
    let mut pass = pass.forget_lifetime();
    for k in 0..columns.count {
        let [left, right] = [k, k + 1].map(|k| columns.edge(k, target.width()));
        pass.set_viewport(left as f32, 0.0, (right - left) as f32, target.height() as f32, 0.0, 1.0);
        if columns.surface == Some(k) {
            renderer.paint_surface(&mut pass);
        } else {
            renderer.paint(&mut pass, k - columns.of_viewport(0));
        }
    }
}

fn target_texture(device: &wgpu::Device, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("scene"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: TARGET_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The pixels of an 8-bit RGBA `texture`; rows are padded to the copy alignment
/// on their way and trimmed here.
fn read_back(device: &wgpu::Device, queue: &wgpu::Queue, texture: &wgpu::Texture) -> Result<RgbaImage, RenderError> {
    let (width, height) = (texture.width(), texture.height());
    let row = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size: u64::from(row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("readback") });
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
    let destination = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), destination, texture.size());
    queue.submit([encoder.finish()]);
    let padded = mapped_bytes(device, &buffer)?;
    let mut pixels = Vec::with_capacity(4 * width as usize * height as usize);
    for line in padded.chunks_exact(row as usize) {
        pixels.extend(line[..4 * width as usize].chunks_exact(4).flat_map(straight));
    }
    let missing = || RenderError::Readback(format!("fewer bytes than {width} × {height} pixels"));
    RgbaImage::from_raw(width, height, pixels).ok_or_else(missing)
}

fn mapped_bytes(device: &wgpu::Device, buffer: &wgpu::Buffer) -> Result<Vec<u8>, RenderError> {
    let readback = |cause: String| RenderError::Readback(cause);
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver outlives the poll below, or nobody waits for the answer.
        let _ = sender.send(result);
    });
    device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| readback(error.to_string()))?;
    receiver.recv().map_err(|error| readback(error.to_string()))?.map_err(|error| readback(error.to_string()))?;
    let view = buffer.get_mapped_range(..).map_err(|error| readback(error.to_string()))?;
    Ok(view.to_vec())
}

/// Undoes the premultiplication of an encoded pixel.
fn straight(pixel: &[u8]) -> [u8; 4] {
    let alpha = u32::from(pixel[3]);
    let channel = |value: u8| (u32::from(value) * 255 + alpha / 2).checked_div(alpha).unwrap_or(0).min(255) as u8;
    [channel(pixel[0]), channel(pixel[1]), channel(pixel[2]), pixel[3]]
}

//! The shared device, the test square, and comparisons whose messages show the difference.

use glam::DVec2;
use image::RgbaImage;
use riemap::render::{
    Camera, Detail, MeshGeometry, Pace, Pattern, PlanarFrame, SceneDescription, ScenePicture, SceneViewport,
    TextureStyle, ViewportRenderer, headless_device, render_scene_with,
};
use std::sync::OnceLock;

pub type Gpu = (wgpu::Device, wgpu::Queue, wgpu::AdapterInfo);

pub const BACKGROUND: [f32; 4] = [0.043, 0.063, 0.082, 1.0];
pub const GREEN: [f32; 4] = [0.17, 0.70, 0.45, 1.0];
pub const MAGENTA: [f32; 4] = [0.84, 0.24, 0.62, 1.0];

/// The shared device.
pub fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();
    match GPU.get_or_init(|| headless_device().map_err(|error| error.to_string())) {
        Ok(gpu) => gpu,
        Err(error) => panic!("an adapter is needed, in software too (`cargo xtask test` installs one): {error}"),
    }
}

pub fn bytes(colour: [f32; 4]) -> [u8; 4] {
    colour.map(|component| (255.0 * component).round() as u8)
}

pub fn assert_pixel(image: &RgbaImage, [x, y]: [u32; 2], expected: [u8; 4], tolerance: u8, what: &str) {
    let actual = image.get_pixel(x, y).0;
    let worst = actual.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    assert!(worst <= tolerance, "{what} at ({x}, {y}): {actual:?} should be {expected:?} within {tolerance}");
}

/// The texture of a source in [−1, 1]².
pub fn style(pattern: Pattern, cells: f64) -> TextureStyle {
    TextureStyle { pattern, cells, octaves: false, bounds: (-DVec2::ONE, DVec2::ONE), pole: DVec2::ZERO, dark: true }
}

/// The square [−1, 1]², whose positions are its texture coordinates.
pub const SQUARE: [DVec2; 4] =
    [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0)];
pub const SQUARE_TRIANGLES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

pub fn square(style: TextureStyle) -> SceneViewport<'static> {
    SceneViewport {
        geometry: MeshGeometry { positions: &SQUARE, texture_coordinates: &SQUARE, triangles: &SQUARE_TRIANGLES },
        boundary: &[],
        boundary_style: None,
        camera: Some(Camera { center: DVec2::ZERO, units_per_pixel: 2.0 / 80.0 }),
        style,
        cells: None,
        handles: &[],
    }
}

pub fn render(gpu: &Gpu, viewports: &[SceneViewport], image: Option<&RgbaImage>, size: [u32; 2]) -> RgbaImage {
    let pictures: Vec<_> = viewports.iter().cloned().map(ScenePicture::from).collect();
    let scene = SceneDescription { pictures: &pictures, background: BACKGROUND, image, margin_px: 16.0 };
    render_scene_with(&gpu.0, &gpu.1, &scene, size).unwrap()
}

/// The width and height of a frame of the live renderer: 16 pixels per unit.
const SIZE: u32 = 64;

/// A change of the uploaded data, with its name; returns whether it was accepted.
pub type Change<'a> = (&'a str, Box<dyn FnMut(&mut ViewportRenderer) -> bool + 'a>);

/// A frame of the live renderer centered at the origin.
pub fn live_frame(style: &TextureStyle) -> PlanarFrame {
    let camera = Camera { center: DVec2::ZERO, units_per_pixel: 4.0 / f64::from(SIZE) };
    PlanarFrame { size_px: [SIZE, SIZE], camera, style: *style, background: BACKGROUND }
}

/// Prepares and paints viewport 0 into a target of `format`; returns the target's pixels.
pub fn painted(
    gpu: &Gpu,
    renderer: &mut ViewportRenderer,
    format: wgpu::TextureFormat,
    style: &TextureStyle,
) -> RgbaImage {
    painted_at(gpu, renderer, format, &live_frame(style), Pace::Full)
}

/// As [`painted`] with any frame of [`live_frame`]'s size, at any pace.
pub fn painted_at(
    gpu: &Gpu,
    renderer: &mut ViewportRenderer,
    format: wgpu::TextureFormat,
    frame: &PlanarFrame,
    pace: Pace,
) -> RgbaImage {
    let (device, queue, _) = gpu;
    let prepare = |renderer: &mut ViewportRenderer, encoder: &mut wgpu::CommandEncoder| {
        renderer.prepare(device, queue, encoder, 0, frame, pace)
    };
    one_frame(gpu, renderer, format, prepare, |renderer, pass| renderer.paint(pass, 0)).1
}

/// Paints one frame into a target of `format`; returns what `prepare` recorded, and the target's pixels.
pub fn one_frame(
    gpu: &Gpu,
    renderer: &mut ViewportRenderer,
    format: wgpu::TextureFormat,
    prepare: impl FnOnce(&mut ViewportRenderer, &mut wgpu::CommandEncoder) -> Option<Detail>,
    paint: impl FnOnce(&ViewportRenderer, &mut wgpu::RenderPass<'static>),
) -> (Option<Detail>, RgbaImage) {
    let (device, queue, _) = gpu;
    let size = wgpu::Extent3d { width: SIZE, height: SIZE, depth_or_array_layers: 1 };
    let target = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let detail = prepare(renderer, &mut encoder);
    let view = target.create_view(&wgpu::TextureViewDescriptor::default());
    let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations::default(),
        })],
        ..Default::default()
    });
    paint(renderer, &mut pass.forget_lifetime());
    let row = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE), rows_per_image: None };
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(4 * SIZE * SIZE),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let destination = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout: row };
    encoder.copy_texture_to_buffer(target.as_image_copy(), destination, size);
    queue.submit([encoder.finish()]);
    buffer.map_async(wgpu::MapMode::Read, .., |result| result.unwrap());
    device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    (detail, RgbaImage::from_raw(SIZE, SIZE, buffer.get_mapped_range(..).unwrap().to_vec()).unwrap())
}

/// The linear intensity of an sRGB-encoded byte.
pub fn linear(encoded: u8) -> f64 {
    let value = f64::from(encoded) / 255.0;
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

//! Scenes: planar meshes and surfaces side by side, drawn into a texture of any size.
//!
//! A scene uses the same `prepare` and `paint` as the screen, with a target like egui's.

use super::targets::attachment;
use super::{
    Camera, CellCode, CellStyle, Graphics, Handle, MeshFault, MeshGeometry, Pace, PlanarFrame, RenderError,
    SceneSurface, StrokeStyle, TextureStyle, ViewportRenderer, sample_count,
};
use glam::DVec2;
use image::RgbaImage;

/// The format of egui's target: sRGB-encoded bytes, encoded by the shader.
const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// One viewport of a scene.
#[derive(Clone, Debug)]
pub enum ScenePicture<'a> {
    /// A mesh in the plane.
    Plane(SceneViewport<'a>),
    /// A surface in space.
    Space(SceneSurface<'a>),
}

impl<'a> From<SceneViewport<'a>> for ScenePicture<'a> {
    fn from(viewport: SceneViewport<'a>) -> Self {
        Self::Plane(viewport)
    }
}

impl<'a> From<SceneSurface<'a>> for ScenePicture<'a> {
    fn from(surface: SceneSurface<'a>) -> Self {
        Self::Space(surface)
    }
}

/// A mesh in the plane.
#[derive(Clone, Debug)]
pub struct SceneViewport<'a> {
    /// The textured mesh.
    pub geometry: MeshGeometry<'a>,
    /// The closed outline; may be empty.
    pub boundary: &'a [DVec2],
    /// The outline's stroke; `None` for the theme's.
    pub boundary_style: Option<StrokeStyle>,
    /// `None` fits the positions and the outline with [`SceneDescription::margin_px`].
    pub camera: Option<Camera>,
    /// The texture.
    pub style: TextureStyle,
    /// Colors and edges of triangles, over the texture.
    pub cells: Option<SceneCells<'a>>,
    /// Discs on top.
    pub handles: &'a [Handle],
}

/// A mesh shown triangle by triangle.
#[derive(Clone, Copy, Debug)]
pub struct SceneCells<'a> {
    /// The position at which each vertex is drawn.
    pub positions: &'a [DVec2],
    /// Vertex indices.
    pub triangles: &'a [[u32; 3]],
    /// The codes of the triangles; empty for 0 everywhere.
    pub codes: &'a [CellCode],
    /// The colors and edges.
    pub style: CellStyle,
}

/// Pictures side by side, of equal width, on one background.
#[derive(Clone, Debug)]
pub struct SceneDescription<'a> {
    /// From left to right.
    pub pictures: &'a [ScenePicture<'a>],
    /// sRGB-encoded, straight alpha.
    pub background: [f32; 4],
    /// The image of `Pattern::Image`.
    pub image: Option<&'a RgbaImage>,
    /// Free space around a fitted mesh.
    pub margin_px: f32,
}

/// Draws scenes in sequence; pipelines, buffers and targets are reused.
#[derive(Debug)]
pub struct SceneRenderer {
    renderer: ViewportRenderer,
    /// The number of pictures.
    viewports: usize,
    target: Option<wgpu::Texture>,
}

impl SceneRenderer {
    /// A renderer for scenes with any number of pictures.
    pub fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let viewports = 2;
        Self { renderer: renderer(device, queue, viewports), viewports, target: None }
    }

    /// Draws `scene` into a texture of `size` pixels: sRGB-encoded, alpha premultiplied. [`super::Readback`] reads its
    /// pixels.
    ///
    /// Of n pictures, number k takes the columns from ⌊k·w/n⌋ to ⌊(k+1)·w/n⌋.
    pub fn draw(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        scene: &SceneDescription,
        size: [u32; 2],
    ) -> Result<wgpu::Texture, RenderError> {
        check(device, scene, size)?;
        let count = scene.pictures.len();
        if count > self.viewports {
            self.viewports = count;
            self.renderer = renderer(device, queue, self.viewports);
        }
        if let Some(image) = scene.image {
            self.renderer.set_image(device, queue, image.as_raw(), image.width(), image.height())?;
        }
        let renderer = &mut self.renderer;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("scene") });
        for (k, picture) in scene.pictures.iter().enumerate() {
            let size_px = [edge(k + 1, count, size[0]) - edge(k, count, size[0]), size[1]];
            let (graphics, viewport) = ((device, queue), (&mut *renderer, k));
            match picture {
                ScenePicture::Plane(part) => part.prepare(graphics, viewport, &mut encoder, size_px, scene)?,
                ScenePicture::Space(part) => {
                    part.prepare(graphics, viewport, &mut encoder, size_px, scene.background)?;
                }
            }
        }
        let is_there = |target: &&wgpu::Texture| [target.width(), target.height()] == size;
        let target = self.target.as_ref().filter(is_there).cloned().unwrap_or_else(|| target_texture(device, size));
        paint(&mut encoder, renderer, scene.pictures, &target);
        queue.submit([encoder.finish()]);
        self.target = Some(target.clone());
        Ok(target)
    }
}

fn renderer(device: &wgpu::Device, queue: &wgpu::Queue, viewports: usize) -> ViewportRenderer {
    ViewportRenderer::new(device, queue, TARGET_FORMAT, viewports, sample_count(device))
}

fn check(device: &wgpu::Device, scene: &SceneDescription, size: [u32; 2]) -> Result<(), RenderError> {
    let [width, height] = size;
    let limit = device.limits().max_texture_dimension_2d;
    if width.min(height) == 0 || width.max(height) > limit {
        return Err(RenderError::Size { width, height, limit });
    }
    let count = scene.pictures.len();
    if count == 0 || count > width as usize {
        return Err(RenderError::ViewportCount { count, limit: width });
    }
    for (viewport, picture) in scene.pictures.iter().enumerate() {
        match picture {
            ScenePicture::Plane(part) => {
                part.geometry.check().map_err(|fault| RenderError::Geometry { viewport, fault })?;
            }
            ScenePicture::Space(part) => part.check()?,
        }
    }
    Ok(())
}

/// The left edge of picture `k` of `count` in a scene of this width.
fn edge(k: usize, count: usize, width: u32) -> u32 {
    (k as u64 * u64::from(width) / count as u64) as u32
}

impl SceneViewport<'_> {
    /// Uploads the picture's contents to a viewport and records their rendering.
    fn prepare(
        &self,
        (device, queue): Graphics<'_>,
        (renderer, viewport): (&mut ViewportRenderer, usize),
        encoder: &mut wgpu::CommandEncoder,
        size_px: [u32; 2],
        scene: &SceneDescription,
    ) -> Result<(), RenderError> {
        upload(device, queue, renderer, viewport, self)?;
        let camera = self.camera.unwrap_or_else(|| self.fitted(size_px, scene.margin_px));
        let frame = PlanarFrame { size_px, camera, style: self.style, background: scene.background };
        renderer.prepare(device, queue, encoder, viewport, &frame, Pace::Full);
        Ok(())
    }

    /// The camera that shows all of the mesh and of the outline, which images may not reach everywhere.
    fn fitted(&self, size_px: [u32; 2], margin_px: f32) -> Camera {
        let points = self.geometry.positions.iter().chain(self.boundary);
        let (low, high) =
            points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
        let bounds = if low.is_finite() && high.is_finite() { (low, high) } else { (DVec2::ZERO, DVec2::ONE) };
        Camera::fit(bounds, size_px.map(|side| side as f32), margin_px)
    }
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
        let fault = MeshFault::TooLarge { triangles: part.geometry.triangles.len() };
        return Err(RenderError::Geometry { viewport, fault });
    }
    renderer.set_cell_style(viewport, cells.map(|cells| cells.style));
    renderer.set_boundary_style(viewport, part.boundary_style);
    renderer.set_handles(device, queue, viewport, part.handles);
    Ok(())
}

fn paint(
    encoder: &mut wgpu::CommandEncoder,
    renderer: &ViewportRenderer,
    pictures: &[ScenePicture],
    target: &wgpu::Texture,
) {
    let view = target.create_view(&wgpu::TextureViewDescriptor::default());
    let clear = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);
    let pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("scene"),
        color_attachments: &[Some(attachment(&view, clear))],
        ..Default::default()
    });
    let mut pass = pass.forget_lifetime();
    for (k, picture) in pictures.iter().enumerate() {
        let [left, right] = [k, k + 1].map(|k| edge(k, pictures.len(), target.width()));
        pass.set_viewport(left as f32, 0.0, (right - left) as f32, target.height() as f32, 0.0, 1.0);
        match picture {
            ScenePicture::Plane(_) => renderer.paint(&mut pass, k),
            ScenePicture::Space(_) => renderer.paint_surface(&mut pass, k),
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

//! Rendering scenes into images without a window.

use super::{Camera, Handle, MeshGeometry, RenderError, StrokeStyle, TextureStyle};
use glam::DVec2;

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
    /// Discs on top.
    pub handles: &'a [Handle],
}

/// Viewports side by side, of equal width, on one background.
#[derive(Clone, Debug)]
pub struct SceneDescription<'a> {
    /// From left to right.
    pub viewports: &'a [SceneViewport<'a>],
    /// sRGB-encoded, straight alpha.
    pub background: [f32; 4],
    /// The image of `Pattern::Image`.
    pub image: Option<&'a image::RgbaImage>,
    /// Free space around a fitted mesh.
    pub margin_px: f32,
}

/// A device on any adapter, hardware preferred, software accepted.
pub fn headless_device() -> Result<(wgpu::Device, wgpu::Queue, wgpu::AdapterInfo), RenderError> {
    Err(RenderError::NoAdapter { cause: String::from("pending") })
}

/// [`render_scene_with`] on a device of its own.
pub fn render_scene(scene: &SceneDescription, size: [u32; 2]) -> Result<image::RgbaImage, RenderError> {
    let (device, queue, _) = headless_device()?;
    render_scene_with(&device, &queue, scene, size)
}

/// Renders `scene` into an image of `size` pixels (straight alpha).
pub fn render_scene_with(
    _device: &wgpu::Device,
    _queue: &wgpu::Queue,
    _scene: &SceneDescription,
    _size: [u32; 2],
) -> Result<image::RgbaImage, RenderError> {
    Err(RenderError::NoAdapter { cause: String::from("pending") })
}

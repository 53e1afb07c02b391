//! Rows of textured meshes and surfaces, drawn by wgpu on a white background.

use crate::cli::CliError;
use crate::geometry::{Bounds, DVec2};
use crate::render::{
    Camera, Handle, MeshGeometry, SceneDescription, ScenePicture, SceneSurface, SceneViewport, TextureStyle,
    headless_device, render_scene_with,
};
use image::RgbaImage;

/// Side of a square panel in pixels.
pub const PANEL_PX: u32 = 480;

/// Free space around a panel's content, as a part of the panel's side.
const MARGIN: f64 = 0.04;

/// Okabe–Ito colors: green for x, magenta for y, yellow for the image of x₁ where it differs from x₂.
pub const POINT: [f32; 4] = [0.0, 0.62, 0.45, 1.0];
pub const ANCHOR: [f32; 4] = [0.84, 0.235, 0.65, 1.0];
pub const STRAY: [f32; 4] = [0.941, 0.894, 0.259, 1.0];

/// A textured mesh to draw.
pub struct RasterPanel<'a> {
    /// The positions of the vertices.
    pub positions: &'a [DVec2],
    /// Their texture coordinates.
    pub coordinates: &'a [DVec2],
    /// The triangles.
    pub triangles: &'a [[u32; 3]],
    /// The outline; the panel is fitted to it.
    pub boundary: &'a [DVec2],
    /// The marked points and their colors.
    pub marks: Vec<(DVec2, [f32; 4])>,
    /// The texture.
    pub style: TextureStyle,
}

/// A graphics device for drawing panels.
pub struct Raster {
    device: wgpu::Device,
    queue: wgpu::Queue,
}

impl Raster {
    /// Opens a device on any adapter.
    pub fn new() -> Result<Self, CliError> {
        let (device, queue, _) = headless_device().map_err(|error| CliError::Input(error.to_string()))?;
        Ok(Self { device, queue })
    }

    /// Draws the panels side by side; `image` is the texture of `Pattern::Image`.
    pub fn row(&self, panels: &[RasterPanel<'_>], image: Option<&RgbaImage>) -> Result<RgbaImage, CliError> {
        let handles: Vec<Vec<Handle>> = panels.iter().map(RasterPanel::handles).collect();
        let pictures: Vec<_> =
            panels.iter().zip(&handles).map(|(panel, handles)| panel.viewport(handles).into()).collect();
        self.pictures(&pictures, image)
    }

    /// Draws surfaces side by side.
    pub fn surfaces(&self, surfaces: &[SceneSurface<'_>]) -> Result<RgbaImage, CliError> {
        self.pictures(&surfaces.iter().cloned().map(ScenePicture::from).collect::<Vec<_>>(), None)
    }

    fn pictures(&self, pictures: &[ScenePicture<'_>], image: Option<&RgbaImage>) -> Result<RgbaImage, CliError> {
        let scene = SceneDescription { pictures, background: [1.0; 4], image, margin_px: 0.0 };
        let size = [PANEL_PX * pictures.len() as u32, PANEL_PX];
        render_scene_with(&self.device, &self.queue, &scene, size).map_err(|error| CliError::Input(error.to_string()))
    }
}

impl RasterPanel<'_> {
    fn handles(&self) -> Vec<Handle> {
        let handle = |&(position, colour)| Handle { position, colour, radius_px: 7.0 };
        self.marks.iter().map(handle).collect()
    }

    fn viewport<'a>(&'a self, handles: &'a [Handle]) -> SceneViewport<'a> {
        SceneViewport {
            geometry: MeshGeometry {
                positions: self.positions,
                texture_coordinates: self.coordinates,
                triangles: self.triangles,
            },
            boundary: self.boundary,
            boundary_style: None,
            camera: Some(self.camera()),
            style: self.style,
            cells: None,
            handles,
        }
    }

    fn camera(&self) -> Camera {
        let [low, high] = Bounds::of(self.boundary.iter().copied()).corners();
        let units_per_pixel = (high - low).max_element() / (f64::from(PANEL_PX) * (1.0 - 2.0 * MARGIN));
        Camera { center: 0.5 * (low + high), units_per_pixel }
    }
}

/// The rows stacked from top to bottom.
pub fn stacked(rows: &[RgbaImage]) -> RgbaImage {
    let width = rows.iter().map(RgbaImage::width).max().unwrap_or(1);
    let height = rows.iter().map(RgbaImage::height).sum::<u32>().max(1);
    let mut sheet = RgbaImage::from_pixel(width, height, image::Rgba([255; 4]));
    let mut top = 0;
    for row in rows {
        image::imageops::replace(&mut sheet, row, 0, i64::from(top));
        top += row.height();
    }
    sheet
}

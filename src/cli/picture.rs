//! The map as a picture: source and target side by side, drawn by wgpu on any adapter.

use super::CliError;
use super::contours::Panel;
use crate::render::{
    Handle, MeshGeometry, Pattern, RenderError, SceneCells, SceneDescription, SceneViewport, StrokeStyle, TextureStyle,
    render_scene,
};
use image::RgbaImage;
use std::io::Cursor;

/// Behind the pictures: the app's dark ground.
const BACKGROUND: [f32; 4] = [0.05, 0.067, 0.09, 1.0];
/// Okabe–Ito green for x, magenta for y.
pub const HANDLE_COLOURS: [[f32; 4]; 2] = [[0.0, 0.62, 0.45, 1.0], [0.84, 0.235, 0.65, 1.0]];

/// Behind a picture that goes with the dark or the light theme.
pub const fn background(dark: bool) -> [f32; 4] {
    if dark { BACKGROUND } else { [1.0; 4] }
}

/// How panels are drawn.
#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    /// The texture, and the theme.
    pub style: TextureStyle,
    /// Colours and edges over it, for each panel.
    pub cells: [Option<SceneCells<'a>>; 2],
    /// The outlines; `None`: the theme's stroke.
    pub stroke: Option<StrokeStyle>,
    /// The radius of the dots.
    pub radius_px: f32,
}

/// The two panels as a PNG of `size` pixels, with a checkerboard of `cells` across the source.
pub fn png(panels: &[Panel<'_>; 2], cells: f64, size: [u32; 2]) -> Result<Vec<u8>, CliError> {
    let style = TextureStyle {
        pattern: Pattern::Checker,
        cells,
        bounds: panels[0].bounds(),
        pole: panels[0].handles[0],
        dark: true,
    };
    let radius_px = 0.011 * size[0].min(2 * size[1]) as f32;
    encode(&draw(panels, &Look { style, cells: [None; 2], stroke: None, radius_px }, size)?)
}

/// The two panels in an image of `size` pixels.
pub fn draw(panels: &[Panel<'_>; 2], look: &Look<'_>, size: [u32; 2]) -> Result<RgbaImage, CliError> {
    let handles = panels.each_ref().map(|panel| handles(panel, look.radius_px));
    let viewports = [0, 1].map(|k| viewport(&panels[k], &handles[k], look, look.cells[k]));
    let margin_px = margin_px(size);
    let scene =
        SceneDescription { viewports: &viewports, background: background(look.style.dark), image: None, margin_px };
    render_scene(&scene, size).map_err(|error| failed(&error))
}

/// Free space around what is drawn.
pub fn margin_px(size: [u32; 2]) -> f32 {
    0.06 * size[1] as f32
}

/// What the renderer says.
pub fn failed(error: &RenderError) -> CliError {
    CliError::Input(error.to_string())
}

/// An image as a PNG file.
pub fn encode(picture: &RgbaImage) -> Result<Vec<u8>, CliError> {
    let mut bytes = Cursor::new(Vec::new());
    picture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .map_err(|error| CliError::Input(format!("cannot encode the picture: {error}")))?;
    Ok(bytes.into_inner())
}

/// The dots of a panel.
pub fn handles(panel: &Panel<'_>, radius_px: f32) -> [Handle; 2] {
    [0, 1].map(|k| Handle { position: panel.handles[k], colour: HANDLE_COLOURS[k], radius_px })
}

/// A panel as the renderer takes it.
pub fn viewport<'a>(
    panel: &Panel<'a>,
    handles: &'a [Handle],
    look: &Look<'a>,
    cells: Option<SceneCells<'a>>,
) -> SceneViewport<'a> {
    SceneViewport {
        geometry: MeshGeometry {
            positions: panel.positions,
            texture_coordinates: panel.coordinates,
            triangles: panel.triangles,
        },
        boundary: panel.boundary,
        boundary_style: look.stroke,
        camera: None,
        style: look.style,
        cells,
        handles,
    }
}

//! The map as a picture: source and target side by side, drawn by wgpu on any adapter.

use super::CliError;
use super::contours::Panel;
use crate::render::{Handle, MeshGeometry, Pattern, SceneDescription, SceneViewport, TextureStyle, render_scene};
use std::io::Cursor;

/// Behind the pictures: the app's dark ground.
pub const BACKGROUND: [f32; 4] = [0.05, 0.067, 0.09, 1.0];
/// Okabe–Ito green for x, magenta for y.
pub const HANDLE_COLOURS: [[f32; 4]; 2] = [[0.0, 0.62, 0.45, 1.0], [0.84, 0.235, 0.65, 1.0]];

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
    let handles = panels.each_ref().map(|panel| {
        let both = panel.handles.iter().zip(HANDLE_COLOURS);
        both.map(|(&position, colour)| Handle { position, colour, radius_px }).collect::<Vec<_>>()
    });
    let viewports = [viewport(&panels[0], &handles[0], style), viewport(&panels[1], &handles[1], style)];
    let margin_px = 0.06 * size[1] as f32;
    let scene = SceneDescription { viewports: &viewports, background: BACKGROUND, image: None, margin_px };
    let picture = render_scene(&scene, size).map_err(|error| CliError::Input(error.to_string()))?;
    encode(&picture)
}

/// An image as a PNG file.
pub fn encode(picture: &image::RgbaImage) -> Result<Vec<u8>, CliError> {
    let mut bytes = Cursor::new(Vec::new());
    picture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .map_err(|error| CliError::Input(format!("cannot encode the picture: {error}")))?;
    Ok(bytes.into_inner())
}

fn viewport<'a>(panel: &Panel<'a>, handles: &'a [Handle], style: TextureStyle) -> SceneViewport<'a> {
    SceneViewport {
        geometry: MeshGeometry {
            positions: panel.positions,
            texture_coordinates: panel.coordinates,
            triangles: panel.triangles,
        },
        boundary: panel.boundary,
        boundary_style: None,
        camera: None,
        style,
        wire: None,
        handles,
    }
}

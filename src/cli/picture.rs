//! A picture of the map: source and target side by side, drawn by wgpu on any adapter.

use super::CliError;
use crate::export::Panel;
use crate::offscreen::compose::{Look, PlanarPart, ScenePart, background, compose};
use crate::render::{Pattern, RenderError, Studio, TextureStyle};
use image::RgbaImage;
use std::io::Cursor;

/// The two panels as a PNG of `size` pixels, with a checkerboard of `cells` across the source.
pub fn png(panels: &[Panel<'_>; 2], cells: f64, size: [u32; 2]) -> Result<Vec<u8>, CliError> {
    let style = TextureStyle {
        pattern: Pattern::Checker,
        cells,
        octaves: true,
        bounds: panels[0].bounds(),
        pole: panels[0].handles[0],
        dark: true,
    };
    let radius_px = Some(0.011 * size[0].min(2 * size[1]) as f32);
    let look = Look { style, background: background(true), image: None, stroke: None, radius_px };
    let parts = panels.map(|panel| ScenePart::Plane(PlanarPart { panel, cells: None }));
    let picture = compose(&parts, &look, size, |scene| {
        Studio::new()?.shoot(|renderer, device, queue| renderer.draw(device, queue, scene, size))
    });
    encode(&picture.map_err(|error| failed(&error))?)
}

/// An error of the renderer.
pub fn failed(error: &RenderError) -> CliError {
    CliError::Input(error.to_string())
}

/// Encodes an image as PNG.
pub fn encode(picture: &RgbaImage) -> Result<Vec<u8>, CliError> {
    let mut bytes = Cursor::new(Vec::new());
    picture
        .write_to(&mut bytes, image::ImageFormat::Png)
        .map_err(|error| CliError::Input(format!("cannot encode the picture: {error}")))?;
    Ok(bytes.into_inner())
}

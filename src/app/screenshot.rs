//! A picture of the viewports as they are on the screen, as PNG.

use crate::platform::{self, Mailbox};
use egui::{ColorImage, Context, Rect};
use image::{ImageFormat, RgbaImage};
use std::io::Cursor;

/// The file's name.
const NAME: &str = "riemap.png";

/// Saves the next frame's picture, cut to `area` (in points).
pub fn save(context: &Context, area: Rect, mailbox: Mailbox) {
    let pixels_per_point = context.pixels_per_point();
    context.request_screenshot(move |picture| match encode(&picture.region(&area, Some(pixels_per_point))) {
        Ok(bytes) => platform::save_file(NAME, bytes, mailbox),
        Err(reason) => mailbox.post(platform::Event::NotSaved { name: String::from(NAME), reason }),
    });
}

fn encode(picture: &ColorImage) -> Result<Vec<u8>, String> {
    let [width, height] = picture.size.map(|side| side as u32);
    let opaque = picture.pixels.iter().flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b(), 255]).collect();
    let buffer = RgbaImage::from_raw(width, height, opaque).ok_or("its size does not fit")?;
    let mut bytes = Cursor::new(Vec::new());
    buffer.write_to(&mut bytes, ImageFormat::Png).map_err(|error| error.to_string())?;
    Ok(bytes.into_inner())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use egui::Color32;

    #[test]
    fn a_picture_survives_its_file() {
        let picture = ColorImage::new([2, 1], vec![Color32::RED, Color32::from_rgb(1, 2, 3)]);
        let back = image::load_from_memory(&encode(&picture).unwrap()).unwrap().into_rgba8();
        assert_eq!(back.as_raw(), &[255, 0, 0, 255, 1, 2, 3, 255]);
    }
}

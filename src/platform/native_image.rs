//! Images on the desktop, decoded by the crate `image` on a thread.

use super::{Event, Mailbox};
use crate::language::{Message, key};
use crate::model::files::FilePurpose;
use image::imageops::thumbnail;
use image::{ImageBuffer, Rgba, RgbaImage};
use std::sync::Arc;
use std::thread;

/// Decodes a PNG or JPEG, scaled down until no side is longer than `max_side`, and posts it to `mailbox`.
pub fn decode_image(purpose: FilePurpose, name: String, file: Arc<Vec<u8>>, max_side: u32, mailbox: Mailbox) {
    thread::spawn(move || {
        let pixels = decode(&file, max_side);
        mailbox.post(Event::Image { purpose, name, file, pixels });
    });
}

fn decode(bytes: &[u8], max_side: u32) -> Result<RgbaImage, Message> {
    let decoded = image::load_from_memory(bytes).map_err(|error| key::no_image(error.to_string()))?.into_rgba8();
    let largest = decoded.width().max(decoded.height());
    if largest <= max_side {
        return Ok(decoded);
    }
    let scale = f64::from(max_side) / f64::from(largest);
    let [width, height] = [decoded.width(), decoded.height()].map(|side| ((f64::from(side) * scale) as u32).max(1));
    Ok(smaller(&decoded, width, height))
}

/// Averages colors weighted by opacity, so that invisible pixels do not contribute.
fn smaller(picture: &RgbaImage, width: u32, height: u32) -> RgbaImage {
    if picture.pixels().all(|pixel| pixel.0[3] == 255) {
        return thumbnail(picture, width, height);
    }
    let weighted = ImageBuffer::from_fn(picture.width(), picture.height(), |x, y| {
        let [red, green, blue, alpha] = picture.get_pixel(x, y).0.map(u16::from);
        Rgba([red * alpha, green * alpha, blue * alpha, 255 * alpha])
    });
    let small = thumbnail(&weighted, width, height);
    RgbaImage::from_fn(width, height, |x, y| {
        let [red, green, blue, weight] = small.get_pixel(x, y).0.map(u32::from);
        let mean = |sum: u32| (255 * sum + weight / 2).checked_div(weight).unwrap_or(0).min(255) as u8;
        Rgba([mean(red), mean(green), mean(blue), ((weight + 127) / 255) as u8])
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn png(width: u32, height: u32) -> Vec<u8> {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let picture = RgbaImage::from_pixel(width, height, Rgba([1, 2, 3, 255]));
        picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn an_image_is_decoded_as_it_is() {
        let decoded = decode(&png(3, 2), 4096).unwrap();
        assert_eq!((decoded.dimensions(), decoded.get_pixel(2, 1).0), ((3, 2), [1, 2, 3, 255]));
    }

    #[test]
    fn an_image_that_the_device_cannot_hold_is_made_smaller_in_proportion() {
        assert_eq!(decode(&png(64, 16), 32).unwrap().dimensions(), (32, 8));
    }

    #[test]
    fn half_transparent_pixels_keep_their_straight_colors() {
        let seen = Rgba([200, 100, 50, 128]);
        let picture = RgbaImage::from_fn(64, 32, |x, _| if x % 2 == 0 { seen } else { Rgba([0; 4]) });
        let mut bytes = std::io::Cursor::new(Vec::new());
        picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
        let bytes = bytes.into_inner();
        assert_eq!(decode(&bytes, 64).unwrap(), picture);
        let small = decode(&bytes, 32).unwrap();
        assert!(small.pixels().all(|pixel| pixel.0 == [200, 100, 50, 64]), "{:?}", small.get_pixel(3, 3));
    }

    #[test]
    fn bytes_that_are_no_image_are_refused() {
        assert!(decode(b"text", 32).unwrap_err().english().contains("no PNG or JPEG"));
    }

    #[test]
    fn a_decoded_image_is_posted_to_the_mailbox() {
        let (mailbox, events) = Mailbox::new();
        decode_image(FilePurpose::Image, String::from("a.png"), Arc::new(png(3, 2)), 32, mailbox);
        let event = events.recv_timeout(std::time::Duration::from_secs(30)).unwrap();
        assert!(matches!(event, Event::Image { name, pixels: Ok(_), .. } if name == "a.png"));
    }
}

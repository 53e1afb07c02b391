//! An animation has the requested pictures and duration, in either format.

use super::*;
use image::codecs::gif::GifDecoder;
use image::codecs::png::PngDecoder;
use image::{AnimationDecoder, Frame, Rgba};
use std::io::Cursor;

const SIZE: [u32; 2] = [40, 24];

/// A square that moves over a color gradient with the alpha `ground`.
fn picture(k: u32, ground: u8) -> RgbaImage {
    RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| {
        if (k..k + 6).contains(&x) && (8..14).contains(&y) {
            Rgba([250, 240, 220, 255])
        } else {
            Rgba([(5 * x) as u8, (9 * y) as u8, 90, ground])
        }
    })
}

fn film(format: FilmFormat, frames: u32, seconds: f64, ground: u8) -> (Vec<u8>, Vec<Frame>) {
    let mut film = Film::new(FilmSettings { format, size: SIZE, frames, seconds }).unwrap();
    for k in 0..frames {
        film.push(&picture(3 * k, ground)).unwrap();
        assert_eq!(film.count(), k + 1);
    }
    let bytes = film.finish().unwrap();
    let decoded = match format {
        FilmFormat::Png => PngDecoder::new(Cursor::new(&bytes)).unwrap().apng().unwrap().into_frames().collect_frames(),
        FilmFormat::Gif => GifDecoder::new(Cursor::new(&bytes)).unwrap().into_frames().collect_frames(),
    };
    (bytes, decoded.unwrap())
}

#[test]
fn an_animated_png_keeps_every_pixel() {
    for ground in [255, 0, 77] {
        let (_, frames) = film(FilmFormat::Png, 5, 1.0, ground);
        assert_eq!(frames.len(), 5);
        for (k, frame) in frames.iter().enumerate() {
            assert_eq!(frame.buffer(), &picture(3 * k as u32, ground), "frame {k}");
            assert_eq!(frame.delay().numer_denom_ms(), (200, 1));
        }
    }
}

#[test]
fn a_gif_has_nearly_the_colors_and_other_frames_each_time() {
    let (_, frames) = film(FilmFormat::Gif, 7, 1.0, 255);
    assert_eq!(frames.len(), 7);
    for (k, frame) in frames.iter().enumerate() {
        let wanted = picture(3 * k as u32, 255);
        let differences = frame.buffer().as_raw().iter().zip(wanted.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)));
        let mean = differences.sum::<f64>() / wanted.as_raw().len() as f64;
        // nearly every pixel has its own color: four pixels share one of the palette's
        assert!(mean < 6.0, "frame {k}: {mean}");
        assert!(k == 0 || frame.buffer() != frames[k - 1].buffer(), "frame {k} is that before");
    }
    let total: u32 = frames.iter().map(|frame| frame.delay().numer_denom_ms().0).sum();
    assert_eq!(total, 1000, "seven frames of a second");
}

#[test]
fn what_is_transparent_in_a_gif_stays_so_in_every_frame() {
    let (_, frames) = film(FilmFormat::Gif, 4, 1.0, 0);
    for frame in &frames {
        assert_eq!(frame.buffer().get_pixel(39, 23).0[3], 0);
        let opaque = frame.buffer().pixels().filter(|pixel| pixel.0[3] == 255).count();
        assert_eq!(opaque, 36, "the square alone: nothing is left of the frame before");
    }
}

#[test]
fn colors_that_come_later_get_a_palette_of_their_own() {
    let mut film = Film::new(FilmSettings { format: FilmFormat::Gif, size: SIZE, frames: 2, seconds: 1.0 }).unwrap();
    let grey =
        RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| Rgba([x + y, x + y, x + y, 85].map(|value| (3 * value) as u8)));
    let red = RgbaImage::from_fn(SIZE[0], SIZE[1], |x, y| Rgba([200, (3 * x) as u8, (3 * y) as u8, 255]));
    film.push(&grey).unwrap();
    film.push(&red).unwrap();
    let bytes = film.finish().unwrap();
    let frames = GifDecoder::new(Cursor::new(&bytes)).unwrap().into_frames().collect_frames().unwrap();
    let [r, g, b, _] = frames[1].buffer().get_pixel(30, 5).0;
    assert!(r.abs_diff(200) < 30 && g.abs_diff(90) < 30 && b.abs_diff(15) < 30, "{r} {g} {b}");
}

#[test]
fn animations_that_cannot_be_are_refused() {
    let settings = FilmSettings { format: FilmFormat::Gif, size: SIZE, frames: 10, seconds: 1.0 };
    let refused = |settings: FilmSettings| settings.check().unwrap_err().to_string();
    assert!(refused(FilmSettings { frames: 1, ..settings }).contains("from 2"));
    assert!(refused(FilmSettings { seconds: f64::NAN, ..settings }).contains("NaN"));
    assert!(refused(FilmSettings { frames: 100, ..settings }).contains("at most 50"));
    assert!(refused(FilmSettings { size: [70_000, 10], ..settings }).contains("70000"));
    let mut film = Film::new(settings).unwrap();
    assert!(matches!(film.push(&RgbaImage::new(3, 3)), Err(FilmError::Picture { width: 3, height: 3 })));
}

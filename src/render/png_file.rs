//! Encodes a picture as a PNG file some rows at a time, so that a large one blocks no frame.

use super::FilmError;
use super::film::SharedBytes;
use image::RgbaImage;
use std::io::Write as _;

/// Bytes of pixels compressed in one call: 10 to 20 ms.
const GO: usize = 1 << 20;

/// A PNG file being encoded.
pub struct PngFile {
    picture: RgbaImage,
    written: usize,
    stream: Option<png::StreamWriter<'static, SharedBytes>>,
    bytes: SharedBytes,
}

impl PngFile {
    /// Begins the file of a picture with straight alpha.
    pub fn begin(picture: RgbaImage) -> Result<Self, FilmError> {
        let bytes = SharedBytes::default();
        let mut encoder = png::Encoder::new(bytes.clone(), picture.width(), picture.height());
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        let stream =
            encoder.write_header().and_then(png::Writer::into_stream_writer).map_err(|error| failed(&error))?;
        Ok(Self { picture, written: 0, stream: Some(stream), bytes })
    }

    /// The part that has been written, from 0 to 1.
    pub fn progress(&self) -> f32 {
        self.written as f32 / self.picture.as_raw().len().max(1) as f32
    }

    /// Writes more rows; returns the file when it is complete.
    pub fn advance(&mut self) -> Result<Option<Vec<u8>>, FilmError> {
        let Some(mut stream) = self.stream.take() else { return Ok(None) };
        let pixels = self.picture.as_raw();
        let end = (self.written + GO).min(pixels.len());
        stream.write_all(&pixels[self.written..end]).map_err(|error| failed(&error))?;
        self.written = end;
        if end < pixels.len() {
            self.stream = Some(stream);
            return Ok(None);
        }
        stream.finish().map_err(|error| failed(&error))?;
        Ok(Some(self.bytes.take()))
    }
}

fn failed(error: &dyn std::error::Error) -> FilmError {
    FilmError::Encoder(error.to_string())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use image::Rgba;

    #[test]
    fn a_picture_comes_back_from_a_file_that_was_written_in_parts() {
        let picture = RgbaImage::from_fn(700, 800, |x, y| Rgba([x as u8, y as u8, (x * y) as u8, (x + y) as u8]));
        let mut file = PngFile::begin(picture.clone()).unwrap();
        let mut parts = 1;
        let bytes = loop {
            match file.advance().unwrap() {
                Some(bytes) => break bytes,
                None => parts += 1,
            }
        };
        assert!(parts > 2 && file.progress() == 1.0, "{parts} parts");
        assert_eq!(image::load_from_memory(&bytes).unwrap().into_rgba8(), picture);
    }
}

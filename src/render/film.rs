//! Encodes a sequence of pictures as an animated PNG or GIF.
//!
//! A PNG keeps every color. A GIF has 256 colors a frame, and pixels are either opaque or transparent: its palette
//! is learned from the first frame, and again when a later frame's colors no longer fit it, because a separate
//! palette for every frame would flicker.

use super::palette::Palette;
use crate::counted::counted;
use gif::{DisposalMethod, Repeat};
use image::RgbaImage;
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

/// Kinds of animations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilmFormat {
    /// Animated PNG: lossless.
    Png,
    /// GIF: 256 colors, shown everywhere.
    Gif,
}

impl FilmFormat {
    /// All formats.
    pub const ALL: [Self; 2] = [Self::Png, Self::Gif];

    /// The file extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Gif => "gif",
        }
    }

    /// The format with this file extension, in upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

/// The settings of an animation. It repeats endlessly.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FilmSettings {
    /// The file format.
    pub format: FilmFormat,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Number of frames.
    pub frames: u32,
    /// Duration of all frames together, in seconds.
    pub seconds: f64,
}

/// The largest number of frames; they take about an hour.
pub const MOST_FRAMES: u32 = 1000;
/// The accepted durations, in seconds.
pub const SECONDS: std::ops::RangeInclusive<f64> = 0.1..=600.0;
/// Browsers slow a GIF down to a tenth of its speed if its frames are shorter than this (in hundredths of a second).
const SHORTEST_GIF_FRAME: f64 = 2.0;

/// The longest file: a buffer that doubles once more still fits into 32-bit addresses.
pub(super) const MOST_BYTES: usize = 512 << 20;

/// Why an animation cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FilmError {
    /// No frames, or more than [`MOST_FRAMES`].
    #[error("{}", counted!(
        *frames,
        "1 frame: an animation has from 2 to {MOST_FRAMES}",
        "{frames} frames: an animation has from 2 to {MOST_FRAMES}"
    ))]
    Frames {
        /// Requested number of frames.
        frames: u32,
    },
    /// The duration is too short or too long.
    #[error("{seconds} s: an animation takes from {} to {} s", SECONDS.start(), SECONDS.end())]
    Seconds {
        /// Requested duration in seconds.
        seconds: f64,
    },
    /// The frame rate is too high for a GIF.
    #[error("{rate:.0} frames per second: a GIF has at most 50")]
    Rate {
        /// Requested rate.
        rate: f64,
    },
    /// A side is too long for the 16 bits of a GIF.
    #[error("{width} × {height} pixels do not fit into a GIF")]
    Size {
        /// Requested width.
        width: u32,
        /// Requested height.
        height: u32,
    },
    /// The file would be longer than a browser's memory allows.
    #[error("{}", counted!(
        *pictures,
        "the animation is longer than {} MiB after 1 picture: make it smaller or shorter",
        "the animation is longer than {} MiB after {pictures} pictures: make it smaller or shorter",
        MOST_BYTES >> 20
    ))]
    Long {
        /// Number of pictures so far.
        pictures: u32,
    },
    /// A picture has another size than the animation.
    #[error("a picture of {width} × {height} pixels among others of another size")]
    Picture {
        /// Width of the picture.
        width: u32,
        /// Height of the picture.
        height: u32,
    },
    /// The encoder's message.
    #[error("the animation cannot be encoded: {0}")]
    Encoder(String),
}

/// An animation being encoded.
pub struct Film {
    settings: FilmSettings,
    encoder: Encoder,
    count: u32,
}

enum Encoder {
    Png { writer: Box<png::Writer<SharedBytes>>, bytes: SharedBytes },
    Gif { encoder: Box<gif::Encoder<Vec<u8>>>, palette: Option<Palette> },
}

impl FilmSettings {
    /// Checks that such an animation can be made.
    pub fn check(&self) -> Result<(), FilmError> {
        let Self { format, size: [width, height], frames, seconds } = *self;
        if !(2..=MOST_FRAMES).contains(&frames) {
            return Err(FilmError::Frames { frames });
        }
        if !SECONDS.contains(&seconds) {
            return Err(FilmError::Seconds { seconds });
        }
        if format == FilmFormat::Gif && 100.0 * seconds / f64::from(frames) < SHORTEST_GIF_FRAME - 1e-9 {
            return Err(FilmError::Rate { rate: f64::from(frames) / seconds });
        }
        if format == FilmFormat::Gif && width.max(height) > u32::from(u16::MAX) {
            return Err(FilmError::Size { width, height });
        }
        Ok(())
    }

    /// The delay of frame `k` in parts of a second: rounded so that all delays together give the requested duration.
    fn delay(&self, k: u32, parts: f64) -> u16 {
        let until = |k: u32| (f64::from(k) * self.seconds * parts / f64::from(self.frames)).round();
        (until(k + 1) - until(k)) as u16
    }
}

impl Film {
    /// An animation without pictures yet.
    pub fn new(settings: FilmSettings) -> Result<Self, FilmError> {
        settings.check()?;
        let encoder = match settings.format {
            FilmFormat::Png => begin_png(&settings).map_err(|error| encoder_error(&error))?,
            FilmFormat::Gif => begin_gif(&settings).map_err(|error| encoder_error(&error))?,
        };
        Ok(Self { settings, encoder, count: 0 })
    }

    /// The file format.
    pub fn format(&self) -> FilmFormat {
        self.settings.format
    }

    /// Number of pictures so far.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Appends a picture with straight alpha.
    pub fn push(&mut self, picture: &RgbaImage) -> Result<(), FilmError> {
        let (width, height) = picture.dimensions();
        if [width, height] != self.settings.size {
            return Err(FilmError::Picture { width, height });
        }
        let k = self.count;
        match &mut self.encoder {
            Encoder::Png { writer, .. } => {
                // a delay has 16 bits
                let parts = if self.settings.seconds / f64::from(self.settings.frames) < 65.0 { 1000 } else { 100 };
                let delay = self.settings.delay(k, f64::from(parts));
                let timed = writer.set_frame_delay(delay, parts);
                timed
                    .and_then(|()| writer.write_image_data(picture.as_raw()))
                    .map_err(|error| encoder_error(&error))?;
            }
            Encoder::Gif { encoder, palette } => {
                let frame = gif_frame(picture, palette, self.settings.delay(k, 100.0));
                encoder.write_frame(&frame).map_err(|error| encoder_error(&error))?;
            }
        }
        self.count += 1;
        if self.length() > MOST_BYTES {
            return Err(FilmError::Long { pictures: self.count });
        }
        Ok(())
    }

    fn length(&self) -> usize {
        match &self.encoder {
            Encoder::Png { bytes, .. } => bytes.len(),
            Encoder::Gif { encoder, .. } => encoder.get_ref().len(),
        }
    }

    /// The finished file, after all pictures have been added.
    pub fn finish(self) -> Result<Vec<u8>, FilmError> {
        match self.encoder {
            Encoder::Png { writer, bytes } => {
                writer.finish().map_err(|error| encoder_error(&error))?;
                Ok(bytes.take())
            }
            Encoder::Gif { encoder, .. } => encoder.into_inner().map_err(|error| encoder_error(&error)),
        }
    }
}

fn begin_png(settings: &FilmSettings) -> Result<Encoder, png::EncodingError> {
    let bytes = SharedBytes::default();
    let mut encoder = png::Encoder::new(bytes.clone(), settings.size[0], settings.size[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_animated(settings.frames, 0)?;
    encoder.set_blend_op(png::BlendOp::Source)?;
    Ok(Encoder::Png { writer: Box::new(encoder.write_header()?), bytes })
}

fn begin_gif(settings: &FilmSettings) -> Result<Encoder, gif::EncodingError> {
    let [width, height] = settings.size.map(|side| side as u16);
    let mut encoder = gif::Encoder::new(Vec::new(), width, height, &[])?;
    encoder.set_repeat(Repeat::Infinite)?;
    Ok(Encoder::Gif { encoder: Box::new(encoder), palette: None })
}

fn gif_frame(picture: &RgbaImage, palette: &mut Option<Palette>, delay: u16) -> gif::Frame<'static> {
    let pixels = picture.as_raw();
    let fitting = palette.take().filter(|palette| palette.fits(pixels));
    let palette = palette.insert(fitting.unwrap_or_else(|| Palette::learned(pixels)));
    let indices = palette.indices(pixels);
    let transparent = indices.contains(&Palette::TRANSPARENT).then_some(Palette::TRANSPARENT);
    gif::Frame {
        width: picture.width() as u16,
        height: picture.height() as u16,
        delay,
        // behind transparent pixels the page is visible, not the previous frame
        dispose: if transparent.is_some() { DisposalMethod::Background } else { DisposalMethod::Keep },
        transparent,
        palette: Some(palette.colours().to_vec()),
        buffer: indices.into(),
        ..gif::Frame::default()
    }
}

fn encoder_error(error: &dyn std::error::Error) -> FilmError {
    FilmError::Encoder(error.to_string())
}

/// A buffer shared with the PNG encoder, which does not return its writer.
#[derive(Debug, Clone, Default)]
pub(super) struct SharedBytes(Arc<Mutex<Vec<u8>>>);

impl SharedBytes {
    fn len(&self) -> usize {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).len()
    }

    pub(super) fn take(&self) -> Vec<u8> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Write for SharedBytes {
    fn write(&mut self, part: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(part);
        Ok(part.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

//! Pictures one after the other as an animated PNG or GIF.
//!
//! A PNG keeps every colour. A GIF has 256 colours a frame, and pixels that are opaque or not: its palette
//! is learned from the first frame and learned anew when a frame's colours have left it, because a palette of its
//! own for every frame would flicker.

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
    /// GIF: 256 colours, shown everywhere.
    Gif,
}

impl FilmFormat {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Png, Self::Gif];

    /// The extension of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Gif => "gif",
        }
    }

    /// By a file's extension, in either case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.extension().eq_ignore_ascii_case(extension))
    }
}

/// What an animation is to be like. It goes on for ever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmSettings {
    /// How it is written.
    pub format: FilmFormat,
    /// In pixels.
    pub size: [u32; 2],
    /// How many pictures there are.
    pub frames: u32,
    /// How long all of them take.
    pub seconds: f64,
}

/// The most frames; an hour of work.
pub const MOST_FRAMES: u32 = 1000;
/// How long an animation may last, in seconds.
pub const SECONDS: std::ops::RangeInclusive<f64> = 0.1..=600.0;
/// Browsers show a GIF whose frames are shorter than this (in hundredths of a second) at a tenth of its speed.
const SHORTEST_GIF_FRAME: f64 = 2.0;

/// The longest file: one that grows once more still fits into 32 bits of addresses.
pub(super) const MOST_BYTES: usize = 512 << 20;

/// Why there is no animation.
#[derive(Debug, thiserror::Error)]
pub enum FilmError {
    /// No frames, or more than can be waited for.
    #[error("{}", counted!(
        *frames,
        "1 frame: an animation has from 2 to {MOST_FRAMES}",
        "{frames} frames: an animation has from 2 to {MOST_FRAMES}"
    ))]
    Frames {
        /// How many were asked for.
        frames: u32,
    },
    /// Too short, or too long.
    #[error("{seconds} s: an animation takes from {} to {} s", SECONDS.start(), SECONDS.end())]
    Seconds {
        /// What was asked for.
        seconds: f64,
    },
    /// Faster than a GIF can be.
    #[error("{rate:.0} frames per second: a GIF has at most 50")]
    Rate {
        /// What was asked for.
        rate: f64,
    },
    /// A GIF's sides have 16 bits.
    #[error("{width} × {height} pixels do not fit into a GIF")]
    Size {
        /// Asked for.
        width: u32,
        /// Asked for.
        height: u32,
    },
    /// A longer file does not grow further in the memory of a browser.
    #[error("{}", counted!(
        *pictures,
        "the animation is longer than {} MiB after 1 picture: make it smaller or shorter",
        "the animation is longer than {} MiB after {pictures} pictures: make it smaller or shorter",
        MOST_BYTES >> 20
    ))]
    Long {
        /// How many there are.
        pictures: u32,
    },
    /// A picture of another size.
    #[error("a picture of {width} × {height} pixels among others of another size")]
    Picture {
        /// Of the picture.
        width: u32,
        /// Of the picture.
        height: u32,
    },
    /// What the encoder says.
    #[error("the animation cannot be encoded: {0}")]
    Encoder(String),
}

/// An animation that is being made.
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
    /// Whether there is such an animation.
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

    /// How long frame `k` is shown, in whole parts of a second: rounded so that all together take as long as asked for.
    fn delay(&self, k: u32, parts: f64) -> u16 {
        let until = |k: u32| (f64::from(k) * self.seconds * parts / f64::from(self.frames)).round();
        (until(k + 1) - until(k)) as u16
    }
}

impl Film {
    /// Without any pictures yet.
    pub fn new(settings: FilmSettings) -> Result<Self, FilmError> {
        settings.check()?;
        let encoder = match settings.format {
            FilmFormat::Png => begin_png(&settings).map_err(|error| encoder_error(&error))?,
            FilmFormat::Gif => begin_gif(&settings).map_err(|error| encoder_error(&error))?,
        };
        Ok(Self { settings, encoder, count: 0 })
    }

    /// How it is written.
    pub fn format(&self) -> FilmFormat {
        self.settings.format
    }

    /// How many pictures it has.
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

    /// The file, when all pictures are there.
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
        // what shines through a frame is the page, not the frame before
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

/// What the PNG encoder writes to and does not give back.
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

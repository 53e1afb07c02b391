//! Reduces pictures to 256 colors.

use color_quant::NeuQuant;

/// The number of pixels from which the colors are learned, spread over the picture: takes 20 ms.
const LEARNED_FROM: usize = 20_000;
/// A prime that is no divisor of the usual widths: else all samples would lie in a few columns.
const STEP_PRIME: usize = 7;
/// Bits of each channel in the table from colors to indices: 0.5 MB.
const BITS: u32 = 6;
/// Colors are learned again if the error exceeds this times the error at learning, ...
const WORSE: f64 = 2.0;
/// ... and this (mean square of a channel's difference), below which errors are invisible.
const UNSEEN: f64 = 12.0;
/// A table entry that has not been computed yet.
const UNKNOWN: u16 = u16::MAX;

/// A palette with a table of nearest colors.
pub struct Palette {
    learned: NeuQuant,
    colours: Vec<u8>,
    /// Palette indices by the upper bits of red, green, blue.
    nearest: Vec<u16>,
    /// The mean square of a channel's difference in the picture from which the palette was learned.
    error: f64,
}

impl Palette {
    /// The index of pixels that are more transparent than not; its color is black.
    pub const TRANSPARENT: u8 = 255;

    /// Learns a palette from `pixels`, which are RGBA.
    pub fn learned(pixels: &[u8]) -> Self {
        let sample: Vec<u8> = sampled(pixels).flat_map(|[r, g, b]| [r, g, b, 255]).collect();
        // at least one pixel is needed, even if none is opaque
        let sample = if sample.is_empty() { vec![0, 0, 0, 255] } else { sample };
        let learned = NeuQuant::new(1, usize::from(Self::TRANSPARENT), &sample);
        let mut colours = learned.color_map_rgb();
        colours.resize(3 * 256, 0);
        let mut palette = Self { learned, colours, nearest: vec![UNKNOWN; 1 << (3 * BITS)], error: 0.0 };
        palette.error = palette.mean_error(pixels);
        palette
    }

    /// Red, green, blue of all colors in sequence.
    pub fn colours(&self) -> &[u8] {
        &self.colours
    }

    /// Whether the palette represents `pixels` about as well as those from which it was learned.
    pub fn fits(&self, pixels: &[u8]) -> bool {
        self.mean_error(pixels) <= (WORSE * self.error).max(UNSEEN)
    }

    /// The palette index of every pixel.
    pub fn indices(&mut self, pixels: &[u8]) -> Vec<u8> {
        pixels.chunks_exact(4).map(|pixel| self.index(pixel)).collect()
    }

    fn index(&mut self, pixel: &[u8]) -> u8 {
        if pixel[3] < 128 {
            return Self::TRANSPARENT;
        }
        let upper = |value: u8| usize::from(value >> (8 - BITS));
        let key = (upper(pixel[0]) << (2 * BITS)) | (upper(pixel[1]) << BITS) | upper(pixel[2]);
        if self.nearest[key] == UNKNOWN {
            self.nearest[key] = self.learned.index_of(&[pixel[0], pixel[1], pixel[2], 255]) as u16;
        }
        self.nearest[key] as u8
    }

    fn mean_error(&self, pixels: &[u8]) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for [r, g, b] in sampled(pixels) {
            let nearest = 3 * self.learned.index_of(&[r, g, b, 255]);
            let channels = [r, g, b].into_iter().zip(&self.colours[nearest..nearest + 3]);
            sum += channels.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum::<f64>();
            count += 3.0;
        }
        if count > 0.0 { sum / count } else { 0.0 }
    }
}

/// Opaque pixels sampled over the whole picture.
fn sampled(pixels: &[u8]) -> impl Iterator<Item = [u8; 3]> + '_ {
    // not a divisor of round widths, or all samples would lie in a few columns
    let step = (pixels.len() / 4).div_ceil(LEARNED_FROM).max(1);
    let step = if step == 1 { 1 } else { step.next_multiple_of(STEP_PRIME) };
    let opaque = |pixel: &&[u8]| pixel[3] >= 128;
    pixels.chunks_exact(4).step_by(step).filter(opaque).map(|pixel| [pixel[0], pixel[1], pixel[2]])
}

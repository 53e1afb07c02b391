//! The settings of an offscreen picture: size, background, sides.

use crate::conformal::Side;

/// A picture whose shorter side has this many pixels has strokes and dots of one pixel per point, as on a screen.
const HEIGHT_OF_POINTS: f32 = 900.0;

/// The settings of an offscreen picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// Width and height, in pixels.
    pub size: [u32; 2],
    /// Whether strokes are light, for a dark background.
    pub dark: bool,
    /// Whether the background is transparent.
    pub transparent: bool,
    /// Whether the interior and boundary points are drawn as dots.
    pub dots: bool,
    /// The side shown; `None`: both, next to each other.
    pub side: Option<Side>,
}

impl Shot {
    /// The scale of strokes and dots: pixels per point.
    pub fn pixels_per_point(&self) -> f32 {
        self.size[0].min(self.size[1]) as f32 / HEIGHT_OF_POINTS
    }

    /// Whether the picture shows a side.
    pub fn shows(&self, side: Side) -> bool {
        self.side.is_none_or(|only| only == side)
    }

    /// The aspect ratio, width over height, of one side's part of the picture.
    pub fn aspect(&self) -> f64 {
        let columns = if self.side.is_some() { 1.0 } else { 2.0 };
        f64::from(self.size[0]) / columns / f64::from(self.size[1])
    }
}

//! What an offscreen picture is to be like: its size, its ground, its sides.

use crate::conformal::Side;

/// A picture this high has the strokes and dots of a screen with one pixel to the point.
const HEIGHT_OF_POINTS: f32 = 900.0;

/// What a picture is to be like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// In pixels.
    pub size: [u32; 2],
    /// Strokes for a dark ground, or for a light one.
    pub dark: bool,
    /// Without the ground.
    pub transparent: bool,
    /// One of the sides; `None`: both, side by side.
    pub side: Option<Side>,
}

impl Shot {
    /// How large a point is in it, in pixels.
    pub fn pixels_per_point(&self) -> f32 {
        self.size[0].min(self.size[1]) as f32 / HEIGHT_OF_POINTS
    }

    /// Whether a side is in the picture.
    pub fn shows(&self, side: Side) -> bool {
        self.side.is_none_or(|only| only == side)
    }

    /// Width over height of one side in it.
    pub fn aspect(&self) -> f64 {
        let columns = if self.side.is_some() { 1.0 } else { 2.0 };
        f64::from(self.size[0]) / columns / f64::from(self.size[1])
    }
}

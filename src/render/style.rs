//! How things look: texture patterns, strokes, handles and the calm palette.
//!
//! All colours are sRGB-encoded with straight alpha, components in 0..=1, as in
//! a hex triple divided by 255.

use glam::DVec2;

/// What is drawn on the source domain and carried along by the map.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pattern {
    /// Squares, cream and the vertical hue change in turn.
    #[default]
    Checker,
    /// Thin lines on the vertical hue change, every fourth one stronger.
    Grid,
    /// Circles and rays about [`TextureStyle::pole`].
    Polar,
    /// The image given to `ViewportRenderer::set_image`.
    Image,
}

/// The texture of a viewport, described in the source domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureStyle {
    /// Which pattern.
    pub pattern: Pattern,
    /// Cells across the larger extent of `bounds`, positive.
    pub cells: f64,
    /// Lower left and upper right corner of the source domain.
    pub bounds: (DVec2, DVec2),
    /// The centre of the polar grid: x₁.
    pub pole: DVec2,
    /// Whether the surrounding theme is dark; decides the default stroke colour.
    pub dark: bool,
}

/// A boundary stroke of constant width on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokeStyle {
    /// sRGB-encoded, straight alpha.
    pub colour: [f32; 4],
    /// Full width in physical pixels.
    pub width_px: f32,
}

impl StrokeStyle {
    /// The stroke of the dark or light theme at a device pixel ratio of
    /// `pixels_per_point`: 1.75 points wide.
    pub fn themed(dark: bool, pixels_per_point: f32) -> Self {
        let colour = if dark { [0.93, 0.945, 0.96, 1.0] } else { [0.14, 0.17, 0.21, 1.0] };
        Self { colour, width_px: 1.75 * pixels_per_point }
    }
}

/// A coloured disc with a white ring: a point that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// Where, in the world of its viewport.
    pub position: DVec2,
    /// sRGB-encoded, straight alpha.
    pub colour: [f32; 4],
    /// Outer radius in physical pixels, ring included.
    pub radius_px: f32,
}

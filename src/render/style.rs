//! Visual style: texture patterns, strokes, handles and the palette.
//!
//! All colors are sRGB-encoded with straight alpha, components in 0..=1, as in
//! a hex triple divided by 255.

use super::ColourMap;
use crate::geometry::PicturePlacement;
use crate::tiling::TilingPattern;
use glam::DVec2;

/// Control points, from top to bottom, of the quadratic Bézier curve that the
/// hue follows over the source's height: warm orange, mauve-gray, blue.
pub(super) const HUE: [[f32; 4]; 3] = [[0.80, 0.43, 0.22, 1.0], [0.47, 0.39, 0.46, 1.0], [0.18, 0.42, 0.58, 1.0]];

/// The light cells of the checkerboard, the lines of the grids.
pub(super) const PAPER: [f32; 4] = [0.96, 0.93, 0.86, 1.0];

/// The linear components of an sRGB-encoded color; alpha stays.
pub(super) fn linear_color([r, g, b, a]: [f32; 4]) -> [f32; 4] {
    [linear(r), linear(g), linear(b), a]
}

fn linear(encoded: f32) -> f32 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// The pattern drawn on one domain and transported by the map.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Pattern {
    /// Squares, alternately cream and in the vertical hue change.
    #[default]
    Checker,
    /// Thin lines on the vertical hue change, every fourth one stronger.
    Grid,
    /// Circles and rays about [`TextureStyle::pole`].
    Polar,
    /// The polar grid in the unit disk, where the texture coordinates lie: 3 times [`TextureStyle::cells`]
    /// rays (a multiple of 4) at equal steps of the angle, and circles at the same steps of −ln of
    /// the radius, so that a conformal map shows all cells as squares. Its bounds are [`TextureStyle::DISK`].
    Conformal,
    /// The image given to `ViewportRenderer::set_image`: it covers the bounds, and what is longer is cropped.
    Image,
    /// That image at a place in the bounds, on paper.
    Placed(PicturePlacement),
    /// A hyperbolic tiling of the unit disk, where the texture coordinates lie; its bounds are [`TextureStyle::DISK`].
    /// Where tiles are not resolved, by the picture, by f32 or by the mesh, it fades to its mean color.
    Tiling {
        /// The tiling and its style.
        pattern: TilingPattern,
        /// Where the image lies in the square around the central tile; for `TilingStyle::Picture`.
        picture: PicturePlacement,
    },
}

/// The texture of a viewport, described in the domain to which it belongs: usually the source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureStyle {
    /// The pattern.
    pub pattern: Pattern,
    /// Cells across the larger extent of `bounds`, positive.
    pub cells: f64,
    /// Whether cells are divided and joined by powers of two where the map or the camera shows them larger or smaller
    /// than a picture of the whole of `bounds` would, so that they keep a visible size. Not for images.
    pub octaves: bool,
    /// Lower left and upper right corner of that domain.
    pub bounds: (DVec2, DVec2),
    /// The center of the polar grid: that domain's interior point.
    pub pole: DVec2,
    /// Whether the surrounding theme is dark; decides the default stroke color.
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
    /// `pixels_per_point`: 1.75 points wide, and 2 where it is dark on light,
    /// which blends to a thinner look.
    pub fn themed(dark: bool, pixels_per_point: f32) -> Self {
        let (colour, width) = if dark { ([0.93, 0.945, 0.96, 1.0], 1.75) } else { ([0.14, 0.17, 0.21, 1.0], 2.0) };
        Self { colour, width_px: width * pixels_per_point }
    }

    /// The mesh's edges: thin, and faint enough not to hide what they are drawn over,
    /// light over dark colors or dark over light ones, which blend to a thinner look.
    pub fn wire(light: bool, pixels_per_point: f32) -> Self {
        let colour = if light { [1.0, 1.0, 1.0, 0.38] } else { [0.03, 0.05, 0.08, 0.75] };
        Self { colour, width_px: pixels_per_point }
    }
}

/// How the mapped mesh is shown triangle by triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellStyle {
    /// The color map that replaces the texture; `None` keeps the texture.
    pub map: Option<ColourMap>,
    /// The edges; they fade where cells are lower than a few points.
    pub wire: Option<StrokeStyle>,
    /// Whether flipped triangles are marked over everything else.
    pub marks: bool,
    /// The device pixel ratio.
    pub pixels_per_point: f32,
}

/// A colored disc with a white ring: a point that can be dragged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    /// The position, in the world of its viewport.
    pub position: DVec2,
    /// sRGB-encoded, straight alpha.
    pub colour: [f32; 4],
    /// Outer radius in physical pixels, ring included.
    pub radius_px: f32,
}

impl TextureStyle {
    /// The bounds of [`Pattern::Conformal`] and [`Pattern::Tiling`].
    pub const DISK: (DVec2, DVec2) = (DVec2::NEG_ONE, DVec2::ONE);

    /// The color of the hue change at height `y` of the source, sRGB-encoded.
    ///
    /// Quadratic Bézier in the height above the lower bound over the whole
    /// height, clamped to 0..=1.
    pub fn hue_at(&self, y: f64) -> [f32; 4] {
        let (low, high) = (self.bounds.0.y, self.bounds.1.y);
        let t = ((y - low) / (high - low)).clamp(0.0, 1.0) as f32;
        let [top, middle, bottom] = HUE;
        std::array::from_fn(|i| {
            let (below, above) = (bottom[i] + t * (middle[i] - bottom[i]), middle[i] + t * (top[i] - middle[i]));
            below + t * (above - below)
        })
    }

    /// The number of rays of [`Pattern::Conformal`]; as in `shaders/pattern.wgsl`.
    pub fn conformal_rays(&self) -> u32 {
        4 * (0.75 * self.cells).round().max(1.0) as u32
    }

    /// The palette's light color, sRGB-encoded.
    pub const fn paper() -> [f32; 4] {
        PAPER
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hue_is_orange_above_and_blue_below() {
        let style = TextureStyle {
            pattern: Pattern::Checker,
            cells: 8.0,
            octaves: false,
            bounds: (DVec2::new(0.0, -1.0), DVec2::new(1.0, 3.0)),
            pole: DVec2::ZERO,
            dark: true,
        };
        assert_eq!(style.hue_at(3.0), HUE[0]);
        assert_eq!(style.hue_at(-1.0), HUE[2]);
        let [r, _, b, _] = style.hue_at(2.0);
        assert!(r > b, "red {r} should exceed blue {b} in the upper part");
    }

    #[test]
    fn linear_components_meet_the_definition_of_srgb() {
        // Value from IEC 61966-2-1: encoded 0.5 is linear 0.21404.
        let [r, g, b, a] = linear_color([0.0, 0.5, 1.0, 0.25]);
        assert!(r == 0.0 && (g - 0.214_041).abs() < 1e-5 && (b - 1.0).abs() < 1e-6 && a == 0.25, "{r} {g} {b} {a}");
    }
}

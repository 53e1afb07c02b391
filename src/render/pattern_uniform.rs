//! The uniform block of a pattern for `shaders/pattern.wgsl`, for meshes in the plane and in space.

use super::style::{HUE, PAPER};
use super::{Camera, Pattern, TextureStyle};
use crate::geometry::PictureFrame;
use crate::tiling::{Tiling, TilingPattern, TilingStyle};
use glam::DVec2;
use std::f64::consts::PI;

/// The fragment entry points, in the order of [`pattern_index`].
pub const PATTERN_FRAGMENTS: [&str; 6] = ["fs_checker", "fs_grid", "fs_polar", "fs_image", "fs_conformal", "fs_tiling"];

/// The index of a pattern's pipeline.
pub fn pattern_index(pattern: Pattern) -> usize {
    match pattern {
        Pattern::Checker => 0,
        Pattern::Grid => 1,
        Pattern::Polar => 2,
        Pattern::Image | Pattern::Placed(_) => 3,
        Pattern::Conformal => 4,
        Pattern::Tiling { .. } => 5,
    }
}

/// `Pattern` of `shaders/pattern.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct PatternUniform {
    lookup: [f32; 4],
    source: [f32; 4],
    image: [f32; 4],
    /// The image's middle, its angle, and 1 where there is paper around it.
    placed: [f32; 4],
    hue: [[f32; 4]; 3],
    paper: [f32; 4],
    /// p, the center and the radius of the circle with the first edge, the style.
    tiling: [f32; 4],
    /// sin π/p, cos π/p, the inradius, and 1 where two colors suffice.
    tile: [f32; 4],
}

impl PatternUniform {
    /// For texture coordinates relative to `origin`, an image with this ratio of width to height, and thin lines
    /// of `line_px` pixels. Without octaves: see [`Self::in_octaves`].
    pub fn new(style: &TextureStyle, origin: DVec2, image_aspect: f64, line_px: f32) -> Self {
        let (low, high) = style.bounds;
        let (middle, extent) = (0.5 * (low + high), (high - low).max(DVec2::splat(f64::MIN_POSITIVE)));
        let lookup = (origin - middle).as_vec2();
        let pole = (style.pole - middle).as_vec2();
        let cells_per_unit = (style.cells / extent.max_element()) as f32;
        let frame = match style.pattern {
            Pattern::Placed(placement) => Some(placement.frame(style.bounds, image_aspect)),
            Pattern::Tiling { pattern, picture } => Some(picture.frame(tile_bounds(pattern.tiling), image_aspect)),
            _ => None,
        };
        let (covered, placed) = if let Some(PictureFrame { middle: at, size, turn }) = frame {
            (size, [(at.x - middle.x) as f32, (at.y - middle.y) as f32, turn as f32, 1.0])
        } else {
            // its aspect kept: the longer side is cropped
            let covered = [extent.x.max(extent.y * image_aspect), extent.y.max(extent.x / image_aspect)];
            (DVec2::from_array(covered), [0.0; 4])
        };
        let [tiling, tile] = tiling_numbers(style.pattern);
        Self {
            lookup: [lookup.x, lookup.y, cells_per_unit, line_px],
            source: [(-0.5 * extent.y) as f32, (1.0 / extent.y) as f32, pole.x, pole.y],
            image: [(1.0 / covered.x) as f32, (1.0 / covered.y) as f32, 0.0, 0.0],
            placed,
            hue: HUE,
            paper: PAPER,
            tiling,
            tile,
        }
    }

    /// The same with octaves, if the style has them, in a picture of `size_px` of which a pixel is as long as this many
    /// units of the drawn mesh.
    pub fn in_octaves(mut self, style: &TextureStyle, size_px: [u32; 2], units_per_pixel: f64) -> Self {
        if style.octaves {
            self.image[2] = 1.0;
            self.image[3] = (units_per_pixel / ordinary_scale(style, size_px)).log2() as f32;
        }
        self
    }
}

/// The square around the central tile, in which a picture is placed.
fn tile_bounds(tiling: Tiling) -> (DVec2, DVec2) {
    let reach = (0.5 * tiling.circumradius()).tanh();
    (DVec2::splat(-reach), DVec2::splat(reach))
}

/// `tiling` and `tile` of `shaders/tiling.wgsl`.
fn tiling_numbers(pattern: Pattern) -> [[f32; 4]; 2] {
    let Pattern::Tiling { pattern: TilingPattern { tiling, style }, .. } = pattern else { return [[0.0; 4]; 2] };
    let style = match style {
        TilingStyle::Tiles => 0.0,
        TilingStyle::Edges => 1.0,
        TilingStyle::Triangles => 2.0,
        TilingStyle::Picture => 3.0,
    };
    let p = f64::from(tiling.p());
    let [center, radius] = tiling.edge_circle();
    let (sine, cosine) = (PI / p).sin_cos();
    let colors = if tiling.is_two_colorable() { 1.0 } else { 0.0 };
    [[p, center, radius, style], [sine, cosine, tiling.inradius(), colors]].map(|row| row.map(|number| number as f32))
}

/// The part of a picture's sides that the whole domain takes in it, with margins and what lies over the picture: 0.78
/// to 0.9 of the width or of the height in the app's windows.
const FILLED: f64 = 0.85;

/// Units of the domain per pixel in a picture of all of it.
fn ordinary_scale(style: &TextureStyle, size_px: [u32; 2]) -> f64 {
    Camera::fit(style.bounds, size_px.map(|side| side as f32), 0.0).units_per_pixel / FILLED
}

//! Thumbnails of maps, rendered on the CPU: the actual map at a coarse resolution, with its pattern.
//!
//! Source and target are side by side. Triangles are rasterized with a depth buffer at three times the
//! resolution, which is then averaged. Patterns have octaves, as on the screen: `shaders/pattern.wgsl`.

use crate::conformal::{PrepareSettings, Side};
use crate::geometry::{Bounds, DVec2, DVec3};
use crate::mesh::Sizing;
use crate::model::scene::{Offscreen, OffscreenSurface, SurfaceFiles};
use crate::outline::Sampling;
use crate::render::{LocalScale, MeshGeometry, Pattern, TextureStyle, double_area};
use crate::session::{Command, Comparison, Session, SurfaceShape, SurfaceSpec};
use crate::tiling::{TilingPattern, TilingStyle, depth};
use egui::{Color32, ColorImage};

/// Width and height of a thumbnail, in points.
pub const SIZE: [usize; 2] = [176, 84];
/// Pixels per point: sharp on a screen with two.
const DENSITY: usize = 2;
/// Samples per pixel along each axis.
const FINE: usize = 3;

/// Boundary samples, enough for thumbnails of 80 points: with 120, the turkey's feathers had corners.
const SAMPLES: u32 = 280;
const GROWTH: f64 = 0.3;
/// Boundary vertices of a preset surface.
const SURFACE_BOUNDARY: u32 = 120;
/// Cells of the pattern across the domain: fewer than on the screen, to be visible at this size.
const CELLS: f64 = 8.0;
/// The part of a half's smaller side that is filled.
const FILLED: f64 = 0.94;

/// The width of the stroke along edges, in samples: half a point.
const EDGE: usize = DENSITY * FINE / 2;
/// Its color: seen on a light and on a dark ground.
const INK: [f32; 4] = [0.42, 0.44, 0.48, 1.0];

/// The brightness of a triangle that is seen edge-on; one that faces the eye has brightness 1.
const DARKEST: f64 = 0.45;

/// A thumbnail of a session's map on a transparent background; `None` if the session has no map.
pub fn of(session: &Session) -> Option<ColorImage> {
    let offscreen = Offscreen::new(&coarse(session.clone()), SurfaceFiles::default(), 1.0).ok()?;
    let style = offscreen.style(false, true)?;
    let mut canvas = Canvas::new([SIZE[0] * DENSITY * FINE, SIZE[1] * DENSITY * FINE]);
    for (half, side) in Side::BOTH.into_iter().enumerate() {
        match offscreen.surface(side) {
            Some(surface) => canvas.solid(&surface, half, offscreen.camera(side, 1.0)?.backward(), &style),
            None => canvas.plane(&offscreen.geometry(side)?, half, &style),
        }
    }
    canvas.stroke_edges();
    Some(canvas.averaged())
}

fn coarse(session: Session) -> Session {
    let mut commands = vec![Command::SetComparison(Comparison::Off), Command::SetTextureScale(CELLS)];
    for side in Side::BOTH {
        let settings = PrepareSettings {
            sampling: Sampling::Adaptive { target: Some(SAMPLES) },
            sizing: Sizing::Graded(GROWTH),
            ..session.domain(side).settings
        };
        commands.push(Command::SetSettings { side, settings });
        let spec = session.surface(side).map(|surface| &surface.spec);
        if let Some(spec @ SurfaceSpec { shape: SurfaceShape::Preset { preset, .. }, .. }) = spec {
            let shape = SurfaceShape::Preset { preset: *preset, boundary: SURFACE_BOUNDARY };
            commands.push(Command::RefineSurface { side, surface: SurfaceSpec { shape, ..spec.clone() } });
        }
    }
    session.and(commands)
}

struct Canvas {
    size: [usize; 2],
    pixels: Vec<[f32; 4]>,
    depths: Vec<f64>,
}

impl Canvas {
    fn new(size: [usize; 2]) -> Self {
        let count = size[0] * size[1];
        Self { size, pixels: vec![[0.0; 4]; count], depths: vec![f64::NEG_INFINITY; count] }
    }

    /// The affine map from a domain's coordinates to the left (0) or right (1) half of the canvas, y down.
    fn fit(&self, points: &[DVec2], half: usize) -> impl Fn(DVec2) -> DVec2 + use<> {
        let [min, max] = Bounds::of(points.iter().copied()).corners();
        let scale = self.pixels_per_unit([min, max]);
        let room = self.half_size();
        let center = DVec2::new((0.5 + half as f64) * room.x, 0.5 * room.y);
        move |p| center + scale * (p - 0.5 * (min + max)) * DVec2::new(1.0, -1.0)
    }

    fn half_size(&self) -> DVec2 {
        DVec2::new(0.5 * self.size[0] as f64, self.size[1] as f64)
    }

    /// Of a picture of all of this box in a half.
    fn pixels_per_unit(&self, [min, max]: [DVec2; 2]) -> f64 {
        FILLED * (self.half_size() / (max - min)).min_element()
    }

    /// The octave of each vertex: log₂ of the texture's units per pixel over those in a picture of its whole domain.
    fn octaves(
        &self,
        (coordinates, triangles): (&[DVec2], &[[u32; 3]]),
        double_area_in_pixels: impl Fn([usize; 3]) -> f64,
        style: &TextureStyle,
    ) -> Vec<f64> {
        let mut scale = LocalScale::default();
        scale.set(coordinates.len(), triangles);
        let scales = scale.compute(|corners| double_area(coordinates, corners), double_area_in_pixels);
        let whole = self.pixels_per_unit(style.bounds.into()).log2();
        scales.iter().map(|[scale, _]| f64::from(*scale) + whole).collect()
    }

    fn plane(&mut self, mesh: &MeshGeometry<'_>, half: usize, style: &TextureStyle) {
        let place = self.fit(mesh.positions, half);
        let points: Vec<DVec2> = mesh.positions.iter().map(|&p| place(p)).collect();
        let textured = (mesh.texture_coordinates, mesh.triangles);
        let octaves = self.octaves(textured, |corners| double_area(&points, corners), style);
        for corners in mesh.triangles {
            let corners = corners.map(|v| v as usize);
            let texture = corners.map(|v| mesh.texture_coordinates[v].extend(octaves[v]));
            self.triangle(corners.map(|v| points[v].extend(0.0)), texture, 1.0, style);
        }
    }

    /// Draws the surface into a half, in parallel projection along `towards_eye`, lit from there.
    fn solid(&mut self, solid: &OffscreenSurface<'_>, half: usize, towards_eye: DVec3, style: &TextureStyle) {
        let mesh = solid.surface.mesh();
        let right = DVec3::Z.cross(towards_eye).try_normalize().unwrap_or(DVec3::X);
        let up = towards_eye.cross(right);
        let flat = |p: &DVec3| DVec2::new(p.dot(right), p.dot(up));
        let flattened: Vec<DVec2> = mesh.vertices().iter().map(flat).collect();
        let place = self.fit(&flattened, half);
        let scale = (place(DVec2::X) - place(DVec2::ZERO)).length();
        let spatial = |corners: [usize; 3]| {
            let [a, b, c] = corners.map(|v| mesh.vertices()[v]);
            scale * scale * (b - a).cross(c - a).length()
        };
        let octaves = self.octaves((solid.coordinates, solid.triangles), spatial, style);
        for corners in solid.triangles {
            let corners = corners.map(|v| v as usize);
            let [a, b, c] = corners.map(|v| mesh.vertices()[v]);
            let facing = (b - a).cross(c - a).normalize_or_zero().dot(towards_eye).abs();
            let points = [a, b, c].map(|p| place(flat(&p)).extend(p.dot(towards_eye)));
            let light = (DARKEST + (1.0 - DARKEST) * facing) as f32;
            let texture = corners.map(|v| solid.coordinates[v].extend(octaves[v]));
            self.triangle(points, texture, light, style);
        }
    }

    /// Fills a triangle; z is the depth, larger is nearer, and in the texture the octave. A degenerate or infinite triangle
    /// is skipped.
    fn triangle(&mut self, [a, b, c]: [DVec3; 3], texture: [DVec3; 3], light: f32, style: &TextureStyle) {
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        if area == 0.0 || !area.is_finite() {
            return;
        }
        let low = a.min(b).min(c).max(DVec3::ZERO);
        let high = a.max(b).max(c);
        let range = |from: f64, to: f64, end: usize| (from.floor() as usize)..(to.ceil().max(0.0) as usize).min(end);
        for y in range(low.y, high.y, self.size[1]) {
            for x in range(low.x, high.x, self.size[0]) {
                let p = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let towards = |q: DVec3, r: DVec3| (q.truncate() - p).perp_dot(r.truncate() - p) / area;
                let weights = [towards(b, c), towards(c, a), towards(a, b)];
                if weights.iter().any(|weight| *weight < -1e-9) {
                    continue;
                }
                let depth = weights[0] * a.z + weights[1] * b.z + weights[2] * c.z;
                let at = y * self.size[0] + x;
                if depth >= self.depths[at] {
                    self.depths[at] = depth;
                    let [u, v, w] = weights;
                    let [r, g, b] = colour(u * texture[0] + v * texture[1] + w * texture[2], style);
                    self.pixels[at] = [light * r, light * g, light * b, 1.0];
                }
            }
        }
    }

    /// Strokes the edge of what is covered, inside: light cells would not be told from a light ground.
    fn stroke_edges(&mut self) {
        let [width, height] = self.size;
        let is_covered = |x: usize, y: usize| self.depths[y * width + x] > f64::NEG_INFINITY;
        let is_edge = |k: &usize| {
            let (x, y) = (k % width, k / width);
            let inside = x >= EDGE && y >= EDGE && x + EDGE < width && y + EDGE < height;
            let around = || [(x - EDGE, y), (x + EDGE, y), (x, y - EDGE), (x, y + EDGE)];
            is_covered(x, y) && !(inside && around().into_iter().all(|(x, y)| is_covered(x, y)))
        };
        let edges: Vec<usize> = (0..width * height).filter(is_edge).collect();
        for k in edges {
            self.pixels[k] = INK;
        }
    }

    fn averaged(&self) -> ColorImage {
        let [width, height] = [SIZE[0] * DENSITY, SIZE[1] * DENSITY];
        let mean = |k: usize| {
            let (x, y) = (FINE * (k % width), FINE * (k / width));
            let mut sum = [0.0; 4];
            for at in (0..FINE * FINE).map(|k| (y + k / FINE) * self.size[0] + x + k % FINE) {
                (0..4).for_each(|c| sum[c] += self.pixels[at][c]);
            }
            // alpha is the coverage of the pixel, so the colors are already premultiplied
            let [r, g, b, a] = sum.map(|channel| (channel / (FINE * FINE) as f32 * 255.0).round() as u8);
            Color32::from_rgba_premultiplied(r, g, b, a)
        };
        ColorImage::new([width, height], (0..width * height).map(mean).collect())
    }
}

/// The colors of the patterns, as on the screen: the gradient's ends at top and bottom, and the light color.
const TOP: [f32; 3] = [0.80, 0.43, 0.22];
const BOTTOM: [f32; 3] = [0.18, 0.42, 0.58];
const PAPER: [f32; 3] = [0.96, 0.93, 0.86];
/// Half the width of a line, in cells.
const LINE: f64 = 0.07;
/// The width of a line along the edge of a tile, in inradii.
const TILE_LINE: f64 = 0.12;

/// Octaves further from the plain pattern than these are not seen at this size.
const OCTAVES: std::ops::RangeInclusive<f64> = -12.0..=3.0;
/// The part of an octave over which it fades into the next one; as in `shaders/pattern.wgsl`.
const FADE: [f64; 2] = [0.4, 0.6];

/// The pattern's color at a texture coordinate (xy) of an octave (z).
fn colour(p: DVec3, style: &TextureStyle) -> [f32; 3] {
    // their cells shrink by themselves
    let is_in_disk = matches!(style.pattern, Pattern::Conformal | Pattern::Tiling { .. });
    let octave = if is_in_disk { 0.0 } else { p.z.clamp(*OCTAVES.start(), *OCTAVES.end()) };
    let share = ((octave - octave.floor() - FADE[0]) / (FADE[1] - FADE[0])).clamp(0.0, 1.0);
    let at =
        |octave: f64| plain_colour(p.truncate(), &TextureStyle { cells: style.cells * (-octave).exp2(), ..*style });
    if share == 0.0 {
        return at(octave.floor());
    }
    let (finer, coarser) = (at(octave.floor()), at(octave.floor() + 1.0));
    std::array::from_fn(|k| finer[k] + share as f32 * (coarser[k] - finer[k]))
}

/// Whether a tiling shows the light color at a point of the disk, and the height at which the others are colored.
fn tile_shade(p: DVec2, TilingPattern { tiling, style }: TilingPattern) -> (bool, f64) {
    let Some(folded) = tiling.fold(p) else { return (false, 0.0) };
    let on_edge = folded.distances[2] < TILE_LINE * tiling.inradius();
    let height = |point| 1.0 - depth(point);
    let of_tile = height(folded.tile.center());
    match style {
        TilingStyle::Tiles if tiling.is_two_colorable() => (folded.tile.half_turns % 2 == 1, of_tile),
        TilingStyle::Triangles => (folded.is_mirrored, height(p)),
        TilingStyle::Edges => (on_edge, height(p)),
        TilingStyle::Tiles | TilingStyle::Picture => (on_edge, of_tile),
    }
}

/// The color of the pattern without octaves.
fn plain_colour(p: DVec2, style: &TextureStyle) -> [f32; 3] {
    let (low, high) = style.bounds;
    let cell = (high - low).max_element() / style.cells;
    let on_line = |coordinate: f64| (coordinate - coordinate.round()).abs() < LINE;
    let (paper, height) = match style.pattern {
        Pattern::Conformal | Pattern::Polar => {
            let g = p - style.pole;
            let per_radian = 0.5 * (1.5 * style.cells).round() * 4.0 / std::f64::consts::TAU;
            let radius =
                if style.pattern == Pattern::Conformal { -per_radian * g.length().ln() } else { g.length() / cell };
            (on_line(radius) || on_line(per_radian * g.to_angle()), 1.0 - g.length() / (high - low).max_element())
        }
        Pattern::Grid => (on_line(p.x / cell) || on_line(p.y / cell), (p.y - low.y) / (high.y - low.y)),
        Pattern::Tiling { pattern, .. } => tile_shade(p, pattern),
        Pattern::Checker | Pattern::Image | Pattern::Placed(_) => {
            let cells = ((p - 0.5 * (low + high)) / cell).floor();
            ((cells.x + cells.y).rem_euclid(2.0) == 0.0, (p.y - low.y) / (high.y - low.y))
        }
    };
    if paper {
        return PAPER;
    }
    let t = height.clamp(0.0, 1.0) as f32;
    std::array::from_fn(|k| t * TOP[k] + (1.0 - t) * BOTTOM[k])
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::session::OutlineSpec;

    #[test]
    fn a_disk_covers_its_share_of_the_picture_and_the_corners_stay_transparent() {
        let shapes = [(Side::Source, Preset::Disk), (Side::Target, Preset::Square)];
        let set = |(side, preset)| Command::SetOutline { side, outline: OutlineSpec::Preset(preset) };
        let session = Session::with(shapes.map(set));
        let picture = of(&session).unwrap();
        let [width, height] = picture.size;
        assert_eq!([width, height], [352, 168]);
        let covered = |from: usize, to: usize| {
            let row = |y: usize| (from..to).map(move |x| (x, y));
            let opacity = |(x, y): (usize, usize)| f64::from(picture.pixels[y * width + x].a()) / 255.0;
            (0..height).flat_map(row).map(opacity).sum::<f64>() / (0.94 * height as f64).powi(2)
        };
        // 120 samples: the polygon has 0.9995 of the disk's area
        assert!((covered(0, width / 2) - 0.25 * std::f64::consts::PI).abs() < 2e-3, "{}", covered(0, width / 2));
        assert!((covered(width / 2, width) - 1.0).abs() < 1e-2, "{}", covered(width / 2, width));
        assert_eq!(picture.pixels[0], Color32::TRANSPARENT);
    }
}

//! What the renderer draws, on whatever adapter there is (lavapipe in CI):
//! first numbers at probe pixels, then small pictures against committed ones.
//!
//! Without an adapter the tests fail under `CI=true` and are skipped, with a
//! message, otherwise. `UPDATE_SNAPSHOTS=1` rewrites the pictures.

#![cfg(all(feature = "app", not(target_arch = "wasm32")))]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs, reason = "tests")]

use glam::DVec2;
use image::RgbaImage;
use riemap::render::{
    Camera, Handle, MeshGeometry, Pattern, RenderError, SceneDescription, SceneViewport, StrokeStyle, TextureStyle,
    headless_device, render_scene_with,
};
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::OnceLock;

type Gpu = (wgpu::Device, wgpu::Queue, wgpu::AdapterInfo);

const BACKGROUND: [f32; 4] = [0.043, 0.063, 0.082, 1.0];
const GREEN: [f32; 4] = [0.17, 0.70, 0.45, 1.0];
const MAGENTA: [f32; 4] = [0.84, 0.24, 0.62, 1.0];

/// The shared device, or `None` (said aloud) where there is no adapter.
fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();
    match GPU.get_or_init(|| headless_device().map_err(|error| error.to_string())) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var("CI").is_ok_and(|ci| ci == "true") => panic!("in CI an adapter is needed: {error}"),
        Err(error) => {
            eprintln!("SKIPPED: {error}");
            None
        }
    }
}

fn bytes(colour: [f32; 4]) -> [u8; 4] {
    colour.map(|component| (255.0 * component).round() as u8)
}

fn assert_pixel(image: &RgbaImage, [x, y]: [u32; 2], expected: [u8; 4], tolerance: u8, what: &str) {
    let actual = image.get_pixel(x, y).0;
    let worst = actual.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    assert!(worst <= tolerance, "{what} at ({x}, {y}): {actual:?} should be {expected:?} within {tolerance}");
}

fn style(pattern: Pattern, cells: f64) -> TextureStyle {
    TextureStyle { pattern, cells, bounds: (-DVec2::ONE, DVec2::ONE), pole: DVec2::ZERO, dark: true }
}

/// The square [−1, 1]², textured by itself.
const SQUARE: [DVec2; 4] = [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0)];
const SQUARE_TRIANGLES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn square(style: TextureStyle) -> SceneViewport<'static> {
    SceneViewport {
        geometry: MeshGeometry { positions: &SQUARE, texture_coordinates: &SQUARE, triangles: &SQUARE_TRIANGLES },
        boundary: &[],
        boundary_style: None,
        camera: Some(Camera { center: DVec2::ZERO, units_per_pixel: 2.0 / 80.0 }),
        style,
        handles: &[],
    }
}

fn render(gpu: &Gpu, viewports: &[SceneViewport], image: Option<&RgbaImage>, size: [u32; 2]) -> RgbaImage {
    let scene = SceneDescription { viewports, background: BACKGROUND, image, margin_px: 16.0 };
    render_scene_with(&gpu.0, &gpu.1, &scene, size).unwrap()
}

#[test]
fn checker_has_its_exact_colours_inside_and_the_background_outside() {
    let Some(gpu) = gpu() else { return };
    // Four cells of 20 pixels; the square covers the pixels 10..90.
    let style = style(Pattern::Checker, 4.0);
    let image = render(gpu, &[square(style)], None, [100, 100]);
    let paper = bytes(TextureStyle::paper());
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let pixel = [20 + 20 * i, 20 + 20 * j];
        let height = 1.0 - (f64::from(pixel[1]) + 0.5 - 10.0) / 40.0;
        let expected = if (i + j) % 2 == 1 { paper } else { bytes(style.hue_at(height)) };
        assert_pixel(&image, pixel, expected, 2, "checker cell");
    }
    for pixel in [[5, 50], [95, 50], [50, 5], [50, 95], [0, 0], [99, 99]] {
        assert_pixel(&image, pixel, bytes(BACKGROUND), 1, "background");
    }
}

#[test]
fn cells_below_a_pixel_fade_to_their_mean_without_moire() {
    let Some(gpu) = gpu() else { return };
    let style = style(Pattern::Checker, 300.0);
    let image = render(gpu, &[square(style)], None, [100, 100]);
    for y in 12..88 {
        let row: Vec<_> = (12..88).map(|x| image.get_pixel(x, y).0).collect();
        let spread = (0..3).map(|c| row.iter().map(|p| p[c]).max().unwrap() - row.iter().map(|p| p[c]).min().unwrap());
        assert!(spread.clone().max().unwrap() <= 1, "row {y} varies by {:?}", spread.collect::<Vec<_>>());
    }
}

#[test]
fn a_flat_colour_arrives_as_asked() {
    let Some(gpu) = gpu() else { return };
    for level in 0..=16_u8 {
        let colour = image::Rgba([level * 15, 255 - level * 15, 128 ^ level, 255]);
        let flat = RgbaImage::from_pixel(4, 4, colour);
        let image = render(gpu, &[square(style(Pattern::Image, 1.0))], Some(&flat), [100, 100]);
        assert_pixel(&image, [50, 50], colour.0, 1, "image colour");
    }
}

#[test]
fn a_transparent_background_stays_transparent() {
    let Some(gpu) = gpu() else { return };
    let asked = [0.8, 0.4, 0.2, 0.5];
    let viewports = [square(style(Pattern::Checker, 4.0))];
    let scene = SceneDescription { viewports: &viewports, background: asked, image: None, margin_px: 0.0 };
    let image = render_scene_with(&gpu.0, &gpu.1, &scene, [100, 100]).unwrap();
    // Premultiplying by one half costs one more bit.
    assert_pixel(&image, [3, 3], bytes(asked), 3, "background");
    assert_eq!(image.get_pixel(50, 50).0[3], 255);
}

#[test]
fn a_row_that_is_not_aligned_for_copies_comes_back_straight() {
    let Some(gpu) = gpu() else { return };
    let viewports = [square(style(Pattern::Checker, 1.0)), square(style(Pattern::Checker, 1.0))];
    let image = render(gpu, &viewports, None, [201, 97]);
    assert_eq!(image.dimensions(), (201, 97));
    // Columns 0..100 and 100..201; the squares' edges are 80 pixels apart.
    for y in [2, 48, 94] {
        assert_pixel(&image, [5, y], bytes(BACKGROUND), 1, "left of the first square");
        assert_pixel(&image, [100, y], bytes(BACKGROUND), 1, "between the squares");
        assert_pixel(&image, [198, y], bytes(BACKGROUND), 1, "right of the second square");
    }
}

/// Ink of a horizontal cut through the left edge of the square, in pixels.
fn stroke_width(gpu: &Gpu, units_per_pixel: f64, points: &[DVec2], width_px: f32) -> f64 {
    let white = StrokeStyle { colour: [1.0; 4], width_px };
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.geometry.triangles = &[];
    viewport.boundary = points;
    viewport.boundary_style = Some(white);
    viewport.camera = Some(Camera { center: DVec2::new(-1.0, 0.05), units_per_pixel });
    let scene =
        SceneDescription { viewports: &[viewport], background: [0.0, 0.0, 0.0, 1.0], image: None, margin_px: 0.0 };
    let image = render_scene_with(&gpu.0, &gpu.1, &scene, [40, 40]).unwrap();
    (0..40).map(|x| linear(image.get_pixel(x, 20).0[0])).sum()
}

fn linear(encoded: u8) -> f64 {
    let value = f64::from(encoded) / 255.0;
    if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
}

#[test]
fn the_stroke_keeps_its_width_under_zoom_and_with_any_number_of_points() {
    let Some(gpu) = gpu() else { return };
    let fine: Vec<DVec2> =
        (0..4).flat_map(|k| (0..500).map(move |i| SQUARE[k].lerp(SQUARE[(k + 1) % 4], f64::from(i) / 500.0))).collect();
    for width in [0.6, 1.0, 1.75, 3.5, 5.0] {
        for units_per_pixel in [1e-5, 0.001, 0.02] {
            for points in [&SQUARE[..], &fine[..]] {
                let actual = stroke_width(gpu, units_per_pixel, points, width);
                let error = (actual - f64::from(width)).abs();
                // 8 bits of coverage and of colour at either side.
                assert!(error < 0.02, "{} points, scale {units_per_pixel}: {actual} for {width}", points.len());
            }
        }
    }
}

#[test]
fn precision_survives_a_far_origin_and_a_deep_zoom() {
    let Some(gpu) = gpu() else { return };
    let shift = DVec2::new(4.0e6, -7.0e6);
    let positions = SQUARE.map(|p| p + shift);
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.geometry = MeshGeometry { positions: &positions, texture_coordinates: &positions, ..viewport.geometry };
    viewport.style.bounds = (positions[0], positions[2]);
    viewport.camera = Some(Camera { center: shift, units_per_pixel: 2.0 / 80.0 });
    let far = render(gpu, &[viewport.clone()], None, [100, 100]);
    let near = render(gpu, &[square(style(Pattern::Checker, 4.0))], None, [100, 100]);
    assert_eq!(far.as_raw(), near.as_raw(), "a shift of {shift} changes the picture");
    // 10⁵ times larger, the corner at (1, 1) is still within a pixel of its place.
    viewport.camera = Some(Camera { center: positions[2], units_per_pixel: 2.0 / 8.0e6 });
    let deep = render(gpu, &[viewport], None, [100, 100]);
    assert_pixel(&deep, [48, 52], bytes(TextureStyle::paper()), 2, "just inside the corner");
    assert_pixel(&deep, [51, 48], bytes(BACKGROUND), 1, "just outside the corner");
}

#[test]
fn a_handle_is_a_coloured_disc_in_a_white_ring() {
    let Some(gpu) = gpu() else { return };
    let handles = [Handle { position: DVec2::new(0.5, 0.5), colour: GREEN, radius_px: 9.0 }];
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.handles = &handles;
    let image = render(gpu, &[viewport], None, [100, 100]);
    assert_pixel(&image, [70, 30], bytes(GREEN), 2, "centre");
    assert_pixel(&image, [77, 30], [255; 4], 2, "ring");
}

#[test]
fn impossible_scenes_are_refused_with_the_reason() {
    let Some((device, queue, _)) = gpu() else { return };
    let scene = |viewports| SceneDescription { viewports, background: BACKGROUND, image: None, margin_px: 0.0 };
    let good = [square(style(Pattern::Checker, 4.0))];
    assert!(matches!(render_scene_with(device, queue, &scene(&good), [0, 10]), Err(RenderError::Size { .. })));
    assert!(matches!(render_scene_with(device, queue, &scene(&good), [10, 1 << 30]), Err(RenderError::Size { .. })));
    assert!(matches!(
        render_scene_with(device, queue, &scene(&[]), [10, 10]),
        Err(RenderError::ViewportCount { count: 0, .. })
    ));
    let mut bad = good.clone();
    bad[0].geometry.triangles = &[[0, 1, 4]];
    let error = render_scene_with(device, queue, &scene(&bad), [10, 10]).unwrap_err();
    assert!(error.to_string().contains("triangle 0 [0, 1, 4]"), "{error}");
}

/// Rings and sectors of the unit disk.
struct Disk {
    points: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    boundary: Vec<DVec2>,
}

fn disk(rings: u32, sectors: u32) -> Disk {
    let at = |ring: u32, sector: u32| {
        f64::from(ring) / f64::from(rings) * DVec2::from_angle(TAU * f64::from(sector) / f64::from(sectors))
    };
    let mut points = vec![DVec2::ZERO];
    points.extend((1..=rings).flat_map(|ring| (0..sectors).map(move |sector| at(ring, sector))));
    let index = |ring: u32, sector: u32| if ring == 0 { 0 } else { 1 + (ring - 1) * sectors + sector % sectors };
    let cell = |ring, sector| {
        let (a, b) = (index(ring, sector), index(ring, sector + 1));
        let (c, d) = (index(ring + 1, sector + 1), index(ring + 1, sector));
        [[a, d, c], [a, c, b]]
    };
    let triangles =
        (0..rings).flat_map(|ring| (0..sectors).flat_map(move |sector| cell(ring, sector))).filter(|t| t[0] != t[2]);
    let boundary = (0..sectors).map(|sector| at(rings, sector)).collect();
    Disk { points, triangles: triangles.collect(), boundary }
}

/// z ↦ e^{iα} (z − a) / (1 − ā z): the disk onto itself, a to the centre.
fn moebius(z: DVec2, a: DVec2, turn: f64) -> DVec2 {
    let (p, q) = (z - a, DVec2::new(1.0 - a.dot(z), -(a.x * z.y - a.y * z.x)));
    DVec2::new(p.dot(q), p.y * q.x - p.x * q.y).rotate(DVec2::from_angle(turn)) / q.length_squared()
}

fn test_card() -> RgbaImage {
    RgbaImage::from_fn(96, 64, |x, y| {
        let bright = if (x / 8 + y / 8) % 2 == 0 { 40 } else { 0 };
        image::Rgba([(2 * x) as u8 + bright, (3 * y) as u8 + bright, 150, 255])
    })
}

/// The disk as it is, and under a Möbius map, with boundary and handles.
fn disk_pair(gpu: &Gpu, pattern: Pattern) -> RgbaImage {
    let disk = disk(40, 128);
    let a = DVec2::new(0.45, 0.3);
    let mapped: Vec<DVec2> = disk.points.iter().map(|&z| moebius(z, a, 0.4)).collect();
    let mut style = style(pattern, 12.0);
    style.pole = a;
    let handles = |interior, boundary| {
        [
            Handle { position: interior, colour: GREEN, radius_px: 6.0 },
            Handle { position: boundary, colour: MAGENTA, radius_px: 6.0 },
        ]
    };
    let (before, after) = (handles(a, DVec2::Y), handles(DVec2::ZERO, moebius(DVec2::Y, a, 0.4)));
    let viewport = |positions, handles| SceneViewport {
        geometry: MeshGeometry { positions, texture_coordinates: &disk.points, triangles: &disk.triangles },
        boundary: &disk.boundary,
        boundary_style: None,
        camera: None,
        style,
        handles,
    };
    let card = test_card();
    render(gpu, &[viewport(&disk.points, &before), viewport(&mapped, &after)], Some(&card), [256, 128])
}

/// Mean absolute difference of the channels and the share of pixels that differ
/// by more than 8 of 255 somewhere. Software adapters of different versions
/// disagree in rounding and at edges of triangles; a pattern that is shifted by a
/// quarter of a pixel gives more than this.
fn compare(name: &str, actual: &RgbaImage) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/images").join(format!("{name}.png"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some_and(|value| value == "1") {
        actual.save(&path).unwrap();
        return;
    }
    let expected = image::open(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())).to_rgba8();
    assert_eq!(actual.dimensions(), expected.dimensions(), "{name}");
    let pixels = f64::from(actual.width() * actual.height());
    let differences = actual.as_raw().iter().zip(expected.as_raw()).map(|(a, b)| f64::from(a.abs_diff(*b)));
    let mean = differences.sum::<f64>() / (4.0 * pixels);
    let differing =
        actual.pixels().zip(expected.pixels()).filter(|(a, b)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 8));
    let share = differing.count() as f64 / pixels;
    if mean > 0.15 || share > 0.003 {
        let kept = std::env::temp_dir().join(format!("riemap-{name}.png"));
        actual.save(&kept).unwrap();
        panic!("{name}: mean difference {mean:.3}, {:.2} % of pixels differ; see {}", 100.0 * share, kept.display());
    }
}

#[test]
fn pictures_of_the_disk_under_a_moebius_map_are_as_committed() {
    let Some(gpu) = gpu() else { return };
    for (name, pattern) in [
        ("disk-checker", Pattern::Checker),
        ("disk-grid", Pattern::Grid),
        ("disk-polar", Pattern::Polar),
        ("disk-image", Pattern::Image),
    ] {
        compare(name, &disk_pair(gpu, pattern));
    }
}

#[test]
fn the_moebius_map_of_these_tests_keeps_the_circle_and_centres_its_point() {
    let a = DVec2::new(0.45, 0.3);
    assert!(moebius(a, a, 0.4).length() < 1e-15);
    for k in 0..7 {
        let radius = moebius(DVec2::from_angle(f64::from(k)), a, 0.4).length();
        assert!((radius - 1.0).abs() < 1e-14, "the circle goes to radius {radius}");
    }
}

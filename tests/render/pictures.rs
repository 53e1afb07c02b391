//! A disk built by hand and a Möbius map of it, in every pattern, compared with committed PNGs.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::conformal::TriangleDistortion;
use riemap::geometry::PicturePlacement;
use riemap::render::{
    CellCode, CellStyle, ColourMap, Handle, MeshGeometry, Pattern, SceneViewport, StrokeStyle, ViewportRenderer,
    sample_count,
};
use riemap::tiling::{Tiling, TilingPattern, TilingStyle};
use std::f64::consts::TAU;
use std::path::Path;

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

/// z ↦ e^{iα} (z − a) / (1 − ā z): the disk to itself, a to the center.
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

/// The disk and its image under a Möbius map, with boundary and handles.
fn disk_pair(gpu: &Gpu, pattern: Pattern, octaves: bool) -> RgbaImage {
    let disk = disk(40, 128);
    let a = DVec2::new(0.45, 0.3);
    let mapped: Vec<DVec2> = disk.points.iter().map(|&z| moebius(z, a, 0.4)).collect();
    let mut style = style(pattern, 12.0);
    style.pole = a;
    style.octaves = octaves;
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
        cells: None,
        handles,
    };
    let card = test_card();
    render(gpu, &[viewport(&disk.points, &before), viewport(&mapped, &after)], Some(&card), [256, 128])
}

/// Asserts bounds on the mean absolute difference of the channels, and on the share of pixels that differ
/// by more than 8 of 255 in some channel. Software adapters of different versions
/// disagree in rounding and at edges of triangles; shifting a pattern by a
/// quarter of a pixel exceeds the bounds.
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
    let gpu = gpu();
    for (name, pattern) in [
        ("disk-checker", Pattern::Checker),
        ("disk-grid", Pattern::Grid),
        ("disk-polar", Pattern::Polar),
        ("disk-conformal", Pattern::Conformal),
        ("disk-image", Pattern::Image),
    ] {
        compare(name, &disk_pair(gpu, pattern, false));
    }
}

#[test]
fn pictures_of_the_disk_in_octaves_are_as_committed() {
    let gpu = gpu();
    for (name, pattern) in [
        ("octaves-checker", Pattern::Checker),
        ("octaves-grid", Pattern::Grid),
        ("octaves-polar", Pattern::Polar),
        ("octaves-conformal", Pattern::Conformal),
    ] {
        compare(name, &disk_pair(gpu, pattern, true));
    }
}

#[test]
fn pictures_of_tilings_under_a_moebius_map_are_as_committed() {
    let gpu = gpu();
    for (name, (p, q), style) in [
        ("disk-tiles", (7, 3), TilingStyle::Tiles),
        ("disk-mirrors", (4, 6), TilingStyle::Triangles),
        ("disk-picture-tiles", (5, 4), TilingStyle::Picture),
    ] {
        let pattern = TilingPattern { tiling: Tiling::new(p, q).unwrap(), style };
        let picture = PicturePlacement { size: 1.4, ..PicturePlacement::default() };
        compare(name, &disk_pair(gpu, Pattern::Tiling { pattern, picture }, false));
    }
}

/// The disk under a Möbius map, its triangles colored by their area distortion within ±3, one
/// marked as flipped.
fn distorted_disk(gpu: &Gpu) -> RgbaImage {
    let (device, queue, _) = gpu;
    let disk = disk(8, 32);
    let mapped: Vec<DVec2> = disk.points.iter().map(|&z| moebius(z, DVec2::new(0.45, 0.3), 0.4)).collect();
    let area_log2 = |triangle: &[u32; 3]| {
        let corners = |points: &[DVec2]| triangle.map(|v| points[v as usize]);
        TriangleDistortion::of(corners(&disk.points), corners(&mapped), 0.0).area_log2
    };
    let mut codes: Vec<_> = disk.triangles.iter().map(|t| CellCode::at((area_log2(t) + 3.0) / 6.0)).collect();
    codes[77] = CellCode::FLIPPED;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let mut renderer = ViewportRenderer::new(device, queue, format, 1, sample_count(device));
    let larger: Vec<DVec2> = mapped.iter().map(|&z| 1.8 * z).collect();
    assert!(renderer.set_cells(device, queue, 0, &larger, &disk.triangles));
    assert!(renderer.set_cell_codes(queue, 0, &mut codes));
    let wire = Some(StrokeStyle::wire(false, 1.0));
    let map = Some(ColourMap::Diverging);
    renderer.set_cell_style(0, Some(CellStyle { map, wire, marks: true, pixels_per_point: 1.0 }));
    painted(gpu, &mut renderer, format, &style(Pattern::Image, 1.0))
}

#[test]
fn the_picture_of_the_disk_in_the_colours_of_its_area_distortion_is_as_committed() {
    let gpu = gpu();
    compare("disk-area", &distorted_disk(gpu));
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

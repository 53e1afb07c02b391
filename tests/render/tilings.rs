//! Hyperbolic tilings: the shader folds as the core does, and shows nothing that is not resolved.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::geometry::PicturePlacement;
use riemap::render::{Camera, MeshGeometry, Pattern, TextureStyle};
use riemap::tiling::{Folded, Tiling, TilingPattern, TilingStyle, depth};

/// Pixels per unit, and across.
const SCALE: f64 = 150.0;
const SIZE: u32 = 300;

fn tiling_style(p: u8, q: u8, style: TilingStyle) -> TextureStyle {
    let pattern = TilingPattern { tiling: Tiling::new(p, q).unwrap(), style };
    super::support::style(Pattern::Tiling { pattern, picture: PicturePlacement::default() }, 8.0)
}

/// The square [−1, 1]² in n² cells.
fn grid(n: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let at = |k: u32| 2.0 * f64::from(k) / f64::from(n) - 1.0;
    let points = (0..=n).flat_map(|y| (0..=n).map(move |x| DVec2::new(at(x), at(y))));
    let corners = (0..n).flat_map(|y| (0..n).map(move |x| y * (n + 1) + x));
    let triangles = corners.flat_map(|a| [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]);
    (points.collect(), triangles.collect())
}

/// The tiling over the square, in a mesh of so many cells along each side.
fn drawn(gpu: &Gpu, style: TextureStyle, cells: u32, image: Option<&RgbaImage>) -> RgbaImage {
    let (points, triangles) = grid(cells);
    let mut viewport = square(style);
    viewport.geometry = MeshGeometry { positions: &points, texture_coordinates: &points, triangles: &triangles };
    viewport.camera = Some(Camera { center: DVec2::ZERO, units_per_pixel: 1.0 / SCALE });
    render(gpu, &[viewport], image, [SIZE, SIZE])
}

/// The point of the disk at the middle of a pixel.
fn place(x: u32, y: u32) -> DVec2 {
    let half = 0.5 * f64::from(SIZE);
    DVec2::new(f64::from(x) + 0.5 - half, half - f64::from(y) - 0.5) / SCALE
}

/// Compares the pixels that lie inside of triangles of the reflections with colors by the core's fold.
fn agree(gpu: &Gpu, style: TextureStyle, color: impl Fn(DVec2, &Folded) -> [f32; 4]) {
    let Pattern::Tiling { pattern, .. } = style.pattern else { unreachable!() };
    let image = drawn(gpu, style, 160, None);
    let (mut compared, mut turns) = (0, 0);
    for (x, y) in image.enumerate_pixels().map(|(x, y, _)| (x, y)) {
        let point = place(x, y);
        // a pixel's width in the metric, and where tiles begin to fade
        let width = 2.0 / SCALE / (1.0 - point.length_squared());
        if point.length() > 0.99 || width > 0.13 * pattern.tiling.inradius() {
            continue;
        }
        let folded = pattern.tiling.fold(point).unwrap();
        if folded.distances.iter().all(|distance| *distance > 1.6 * width) {
            assert_pixel(&image, [x, y], bytes(color(point, &folded)), 3, "tile");
            compared += 1;
            turns = turns.max(folded.tile.half_turns);
        }
    }
    println!("{} {:?}: {compared} pixels, up to {turns} half-turns", pattern.tiling, pattern.style);
    assert!(compared > 12_000 && turns >= 2, "{compared} pixels, {turns} turns");
}

#[test]
fn the_shader_folds_as_the_core_does() {
    let gpu = gpu();
    for (p, q) in [(4, 6), (7, 3), (3, 8), (5, 4)] {
        let tiles = tiling_style(p, q, TilingStyle::Tiles);
        let colored = Tiling::new(p, q).unwrap().is_two_colorable();
        agree(gpu, tiles, |_, folded| match folded.tile.half_turns % 2 {
            1 if colored => TextureStyle::paper(),
            _ => tiles.hue_at(1.0 - 2.0 * depth(folded.tile.center())),
        });
        let triangles = tiling_style(p, q, TilingStyle::Triangles);
        agree(gpu, triangles, |point, folded| {
            let hue = triangles.hue_at(1.0 - 2.0 * depth(point));
            if folded.is_mirrored { TextureStyle::paper() } else { hue }
        });
        let edges = tiling_style(p, q, TilingStyle::Edges);
        agree(gpu, edges, |point, _| edges.hue_at(1.0 - 2.0 * depth(point)));
    }
}

#[test]
fn edges_are_drawn_where_tiles_meet() {
    let gpu = gpu();
    let style = tiling_style(7, 3, TilingStyle::Edges);
    let image = drawn(gpu, style, 160, None);
    let tiling = Tiling::new(7, 3).unwrap();
    for tile in tiling.tiles(0.3, 10) {
        for edge in 0..7 {
            for at in [-0.6, 0.0, 0.5] {
                let at = SCALE * tile.along_edge(tiling, edge, at) + 0.5 * f64::from(SIZE);
                let [x, y] = [at.x as u32, SIZE - 1 - at.y as u32];
                let [r, g, b, _] = image.get_pixel(x, y).0;
                // at least half of a pixel through which an edge passes
                assert!(g > 150 && r > 150 && b > 130, "({x}, {y}): {r} {g} {b}");
            }
        }
    }
}

/// Beyond the circle, next to it, and where triangles of the mesh are larger than tiles, there is one calm color.
#[test]
fn what_is_not_resolved_is_not_drawn() {
    let gpu = gpu();
    let spread = |image: &RgbaImage, range: std::ops::Range<f64>| {
        let inside = image.enumerate_pixels().filter(|(x, y, _)| range.contains(&place(*x, *y).length()));
        let greens: Vec<u8> = inside.map(|(.., pixel)| pixel.0[1]).collect();
        greens.iter().max().unwrap() - greens.iter().min().unwrap()
    };
    let style = tiling_style(4, 6, TilingStyle::Tiles);
    let fine = drawn(gpu, style, 160, None);
    assert!(spread(&fine, 0.9..0.95) > 80, "tiles are seen");
    assert!(spread(&fine, 0.9995..1.4) <= 1, "{}", spread(&fine, 0.9995..1.4));
    // edges of 0.25 to 0.35 hide what is nearer to the circle than 0.02
    let coarse = drawn(gpu, style, 8, None);
    assert!(spread(&coarse, 0.986..1.0) <= 2, "{}", spread(&coarse, 0.986..1.0));
    assert!(spread(&coarse, 0.7..0.8) > 80, "tiles are seen");
}

/// The lower half of the picture is towards the disk's center in all tiles but the central one, where it is below.
#[test]
fn a_picture_stands_upright_on_its_side_towards_the_center() {
    let gpu = gpu();
    let (upper, lower) = ([220, 60, 40, 255], [40, 90, 220, 255]);
    let card = RgbaImage::from_fn(64, 64, |_, y| image::Rgba(if y < 32 { upper } else { lower }));
    let image = drawn(gpu, tiling_style(7, 3, TilingStyle::Picture), 160, Some(&card));
    let tiling = Tiling::new(7, 3).unwrap();
    let pixel = |place: DVec2| {
        let at = SCALE * place + 0.5 * f64::from(SIZE);
        [at.x as u32, SIZE - 1 - at.y as u32]
    };
    assert_pixel(&image, pixel(DVec2::new(0.02, 0.1)), upper, 2, "central tile, above");
    assert_pixel(&image, pixel(DVec2::new(0.02, -0.1)), lower, 2, "central tile, below");
    for tile in tiling.tiles(0.2, 8).iter().skip(1) {
        let center = tile.center();
        let out = 0.05 * center.normalize();
        assert_pixel(&image, pixel(center + out), upper, 3, "outwards");
        assert_pixel(&image, pixel(center - out), lower, 3, "inwards");
    }
}

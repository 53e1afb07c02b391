//! Triangles with individual colors, with edges and marks.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::render::{
    CellCode, CellStyle, ColourMap, MeshGeometry, Pattern, StrokeStyle, TextureStyle, ViewportRenderer, flipped_colour,
    sample_count,
};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Centers of the triangles of [`SQUARE_TRIANGLES`]: below and above the diagonal.
const CENTRES: [[u32; 2]; 2] = [[37, 42], [26, 21]];

fn shown(map: Option<ColourMap>) -> CellStyle {
    CellStyle { map, wire: None, marks: false, pixels_per_point: 1.0 }
}

/// A renderer with the textured square, and its two triangles colored by `codes`.
fn renderer(gpu: &Gpu, codes: [CellCode; 2], style: CellStyle) -> ViewportRenderer {
    let (device, queue, _) = gpu;
    let mut renderer = ViewportRenderer::new(device, queue, FORMAT, 1, sample_count(device));
    let texture = MeshGeometry { positions: &SQUARE, texture_coordinates: &SQUARE, triangles: &SQUARE_TRIANGLES };
    assert!(renderer.set_mesh(device, queue, 0, &texture));
    assert!(renderer.set_cells(device, queue, 0, &SQUARE, &SQUARE_TRIANGLES));
    assert!(renderer.set_cell_codes(queue, 0, &mut codes.to_vec()));
    renderer.set_cell_style(0, Some(style));
    renderer
}

fn picture(gpu: &Gpu, renderer: &mut ViewportRenderer) -> RgbaImage {
    // without an image the texture is one pixel in the color of paper
    painted(gpu, renderer, FORMAT, &style(Pattern::Image, 1.0))
}

#[test]
fn every_triangle_has_the_colour_of_its_value() {
    let gpu = gpu();
    for map in [ColourMap::Cividis, ColourMap::Diverging] {
        for values in [[0.0, 1.0], [0.25, 0.5], [0.9, 0.1]] {
            let image = picture(gpu, &mut renderer(gpu, values.map(CellCode::at), shown(Some(map))));
            for (pixel, value) in CENTRES.into_iter().zip(values) {
                // 254 codes, and the conversion of 8 bits from linear to encoded
                assert_pixel(&image, pixel, bytes(map.at(value)), 2, "triangle");
            }
            assert_pixel(&image, [4, 4], bytes(BACKGROUND), 1, "background");
        }
    }
}

#[test]
fn colours_do_not_depend_on_which_corner_comes_first() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let codes = [CellCode::at(0.2), CellCode::at(0.8)];
    let mut renderer = renderer(gpu, codes, shown(Some(ColourMap::Cividis)));
    for triangles in [[[1, 2, 0], [2, 3, 0]], [[2, 0, 1], [3, 0, 2]], [[0, 2, 1], [3, 2, 0]]] {
        assert!(renderer.set_cells(device, queue, 0, &SQUARE, &triangles));
        assert!(renderer.set_cell_codes(queue, 0, &mut codes.to_vec()));
        let image = picture(gpu, &mut renderer);
        assert_pixel(&image, CENTRES[0], bytes(ColourMap::Cividis.at(0.2)), 2, "below the diagonal");
        assert_pixel(&image, CENTRES[1], bytes(ColourMap::Cividis.at(0.8)), 2, "above the diagonal");
    }
}

#[test]
fn flipped_triangles_are_marked_over_the_texture_too() {
    let gpu = gpu();
    let codes = [CellCode::FLIPPED, CellCode::at(0.0)];
    for map in [None, Some(ColourMap::Cividis), Some(ColourMap::Diverging)] {
        let style = CellStyle { marks: true, ..shown(map) };
        let image = picture(gpu, &mut renderer(gpu, codes, style));
        assert_pixel(&image, CENTRES[0], bytes(flipped_colour()), 1, "flipped");
        let expected = map.map_or(TextureStyle::paper(), |map| map.at(0.0));
        assert_pixel(&image, CENTRES[1], bytes(expected), 2, "not flipped");
    }
}

#[test]
fn edges_have_their_width_and_their_colour() {
    let gpu = gpu();
    let black = StrokeStyle { colour: [0.0, 0.0, 0.0, 1.0], width_px: 3.0 };
    let style = CellStyle { wire: Some(black), ..shown(Some(ColourMap::Diverging)) };
    let image = picture(gpu, &mut renderer(gpu, [CellCode::at(0.5); 2], style));
    // the diagonal passes through the pixels (k, 63 − k); with a width of three pixels it covers √2 · 3 of a row
    for row in [24, 30, 38] {
        let paper = f64::from(bytes(ColourMap::Diverging.at(0.5))[0]);
        let ink: f64 = (20..44).map(|x| 1.0 - linear(image.get_pixel(x, row).0[0]) / linear(paper as u8)).sum();
        // coverage is a distance clamped at each pixel, so that the ends of a slanted cut are off by a few hundredths
        assert!((ink - 3.0 * 2_f64.sqrt()).abs() < 0.15, "row {row}: {ink} pixels of ink");
    }
    assert_pixel(&image, CENTRES[0], bytes(ColourMap::Diverging.at(0.5)), 2, "inside");
}

#[test]
fn edges_of_cells_of_a_few_pixels_fade_away() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let black = StrokeStyle { colour: [0.0, 0.0, 0.0, 1.0], width_px: 1.0 };
    let style = CellStyle { wire: Some(black), ..shown(Some(ColourMap::Diverging)) };
    let darkest = |rows: u32| {
        let (points, triangles) = lattice(rows);
        let mut renderer = ViewportRenderer::new(device, queue, FORMAT, 1, sample_count(device));
        assert!(renderer.set_cells(device, queue, 0, &points, &triangles));
        assert!(renderer.set_cell_codes(queue, 0, &mut vec![CellCode::at(0.5); triangles.len()]));
        renderer.set_cell_style(0, Some(style));
        let image = picture(gpu, &mut renderer);
        (20..44).flat_map(|x| (20..44).map(move |y| (x, y))).map(|(x, y)| image.get_pixel(x, y).0[0]).min().unwrap()
    };
    // the square is 32 pixels wide: cells of 8 pixels, and of one pixel, with more triangles than a row of texels
    assert!(darkest(4) < 120, "edges of large cells are missing: {}", darkest(4));
    assert!(darkest(40) > 240, "small cells turn dark: {}", darkest(40));
}

/// The square divided into `rows`² squares of two triangles each.
fn lattice(rows: u32) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let at = |k: u32| 2.0 * f64::from(k) / f64::from(rows) - 1.0;
    let points = (0..=rows).flat_map(|j| (0..=rows).map(move |i| DVec2::new(at(i), at(j)))).collect();
    let corner = |i: u32, j: u32| j * (rows + 1) + i;
    let cell = |i, j| {
        let (a, b, c, d) = (corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        [[a, b, c], [a, c, d]]
    };
    (points, (0..rows).flat_map(|j| (0..rows).flat_map(move |i| cell(i, j))).collect())
}

#[test]
fn moved_cells_move_their_colours() {
    let gpu = gpu();
    let codes = [CellCode::at(1.0); 2];
    let mut renderer = renderer(gpu, codes, shown(Some(ColourMap::Cividis)));
    assert!(renderer.set_cell_positions(&gpu.1, 0, &SQUARE.map(|p| 0.5 * p + DVec2::new(1.25, 1.25))));
    let image = picture(gpu, &mut renderer);
    assert_pixel(&image, [32, 32], bytes(BACKGROUND), 1, "where they were");
    assert_pixel(&image, [50, 10], bytes(ColourMap::Cividis.at(1.0)), 1, "where they are");
}

#[test]
fn cells_that_do_not_fit_are_refused() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let mut renderer = renderer(gpu, [CellCode::at(0.3); 2], shown(Some(ColourMap::Cividis)));
    assert!(!renderer.set_cells(device, queue, 0, &SQUARE, &[[0, 1, 4]]));
    assert!(!renderer.set_cells(device, queue, 1, &SQUARE, &SQUARE_TRIANGLES));
    assert!(!renderer.set_cell_positions(queue, 0, &SQUARE[..3]));
    assert!(!renderer.set_cell_codes(queue, 0, &mut vec![CellCode::at(0.9)]));
    let image = picture(gpu, &mut renderer);
    assert_pixel(&image, CENTRES[0], bytes(ColourMap::Cividis.at(0.3)), 2, "the first cells");
}

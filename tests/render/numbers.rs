//! Colors, widths and rejected inputs, as numbers.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::geometry::PicturePlacement;
use riemap::render::{
    Camera, Handle, MeshGeometry, Pattern, RenderError, SceneDescription, StrokeStyle, TextureStyle, render_scene_with,
};
use std::f64::consts::FRAC_PI_2;

#[test]
fn checker_has_its_exact_colours_inside_and_the_background_outside() {
    let gpu = gpu();
    // four cells of 20 pixels; the square covers the pixels 10..90
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
    let gpu = gpu();
    let style = style(Pattern::Checker, 300.0);
    let image = render(gpu, &[square(style)], None, [100, 100]);
    for y in 12..88 {
        let row: Vec<_> = (12..88).map(|x| image.get_pixel(x, y).0).collect();
        let spread = (0..3).map(|c| row.iter().map(|p| p[c]).max().unwrap() - row.iter().map(|p| p[c]).min().unwrap());
        assert!(spread.clone().max().unwrap() <= 1, "row {y} varies by {:?}", spread.collect::<Vec<_>>());
    }
}

/// Hue and paper mixed in linear light, as in the lines of a grid.
fn lined(hue: [f32; 4], share: f64) -> [u8; 4] {
    let mix = |hue: u8, paper: u8| (1.0 - share) * linear(hue) + share * linear(paper);
    let (hue, paper) = (bytes(hue), bytes(TextureStyle::paper()));
    let encode = |value: f64| {
        let encoded = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        (255.0 * encoded).round() as u8
    };
    [0, 1, 2, 3].map(|c| if c == 3 { 255 } else { encode(mix(hue[c], paper[c])) })
}

/// 24 rays, and circles at the radii e^{−2πk/24}, of which every fourth is strong; 320 pixels per unit.
#[test]
fn the_conformal_grid_has_its_circles_where_green_s_function_has_its_steps() {
    let gpu = gpu();
    let mut viewport = square(style(Pattern::Conformal, 8.0));
    viewport.camera = Some(Camera { center: DVec2::ZERO, units_per_pixel: 1.0 / 320.0 });
    let image = render(gpu, &[viewport.clone()], None, [640, 640]);
    let step = std::f64::consts::TAU / 24.0;
    let mut seen = [0; 4];
    for (x, y, pixel) in image.enumerate_pixels() {
        let place = DVec2::new(f64::from(x) - 319.5, 319.5 - f64::from(y));
        let radius = place.length() / 320.0;
        let [depth, turns] = [-radius.ln() / step, place.to_angle() / step];
        if !(0.6..6.4).contains(&depth) || (turns - turns.floor() - 0.5).abs() > 0.25 {
            continue;
        }
        let from_circle = (depth - depth.round()).abs() * step * place.length();
        let share = match depth.round() as u32 % 4 {
            _ if from_circle > 3.0 => 0.0,
            // a strong line is 2.1 pixels wide, a thin one 1.2
            0 if from_circle < 0.4 => 1.0,
            1..4 if from_circle < 0.08 => 0.62,
            _ => continue,
        };
        seen[(3.0 * share) as usize] += 1;
        assert_pixel(&image, [x, y], lined(viewport.style.hue_at(1.0 - 2.0 * radius), share), 3, "grid");
        assert_eq!(pixel.0[3], 255);
    }
    assert!(seen[0] > 10_000 && seen[1] > 100 && seen[3] > 100, "{seen:?}");
    // the first ray goes to 1, the anchor
    for x in [500, 540, 600] {
        assert_pixel(&image, [x, 320], bytes(TextureStyle::paper()), 2, "ray");
    }
}

/// In a crowded part all vertices have the coordinates of the same boundary point.
#[test]
fn where_a_domain_crowds_the_conformal_grid_has_the_boundary_s_colour() {
    let gpu = gpu();
    for angle in [0.0, 0.1, 2.0] {
        let mut viewport = square(style(Pattern::Conformal, 8.0));
        let coordinates = [0.0, 1e-15, -1e-12, 3e-9].map(|shift| DVec2::from_angle(angle + shift));
        viewport.geometry.texture_coordinates = &coordinates;
        let image = render(gpu, &[viewport.clone()], None, [100, 100]);
        assert_pixel(&image, [50, 50], bytes(viewport.style.hue_at(-1.0)), 2, "crowded");
    }
}

#[test]
fn a_flat_colour_arrives_as_asked() {
    let gpu = gpu();
    for level in 0..=16_u8 {
        let colour = image::Rgba([level * 15, 255 - level * 15, 128 ^ level, 255]);
        let flat = RgbaImage::from_pixel(4, 4, colour);
        let image = render(gpu, &[square(style(Pattern::Image, 1.0))], Some(&flat), [100, 100]);
        assert_pixel(&image, [50, 50], colour.0, 1, "image colour");
    }
}

#[test]
fn a_placed_image_lies_on_paper_where_it_is_put() {
    let gpu = gpu();
    let (left, right) = ([200, 60, 50, 255], [40, 90, 220, 255]);
    let halves = RgbaImage::from_fn(8, 4, |x, _| image::Rgba(if x < 4 { left } else { right }));
    // 1 wide and 0.5 high, upright after a quarter turn, with its middle at (0.5, 0)
    let placement = PicturePlacement { middle: DVec2::new(0.25, 0.0), size: 0.5, turn: FRAC_PI_2 };
    let image = render(gpu, &[square(style(Pattern::Placed(placement), 1.0))], Some(&halves), [100, 100]);
    for (pixel, colour) in [([70, 62], left), ([62, 66], left), ([70, 38], right), ([78, 34], right)] {
        assert_pixel(&image, pixel, colour, 1, "the left half is below");
    }
    for pixel in [[57, 50], [83, 50], [70, 27], [70, 73], [20, 20]] {
        assert_pixel(&image, pixel, bytes(TextureStyle::paper()), 2, "paper");
    }
    // the whole of it at first: as wide as the square, half as high
    let whole = style(Pattern::Placed(PicturePlacement::default()), 1.0);
    let image = render(gpu, &[square(whole)], Some(&halves), [100, 100]);
    for (pixel, colour) in [([11, 50], left), ([89, 50], right), ([30, 31], left), ([70, 69], right)] {
        assert_pixel(&image, pixel, colour, 1, "whole");
    }
    for pixel in [[30, 27], [70, 73]] {
        assert_pixel(&image, pixel, bytes(TextureStyle::paper()), 2, "above and below");
    }
}

#[test]
fn a_transparent_background_stays_transparent() {
    let gpu = gpu();
    let asked = [0.8, 0.4, 0.2, 0.5];
    let pictures = [square(style(Pattern::Checker, 4.0)).into()];
    let scene = SceneDescription { pictures: &pictures, background: asked, image: None, margin_px: 0.0 };
    let image = render_scene_with(&gpu.0, &gpu.1, &scene, [100, 100]).unwrap();
    // premultiplying by one half costs one more bit
    assert_pixel(&image, [3, 3], bytes(asked), 3, "background");
    assert_eq!(image.get_pixel(50, 50).0[3], 255);
}

#[test]
fn half_covered_pixels_on_a_transparent_ground_have_straight_colours() {
    let gpu = gpu();
    let flat = image::Rgba([200, 100, 50, 255]);
    let mut viewport = square(style(Pattern::Image, 1.0));
    // moved by half a pixel: the edges pass through the middles of the pixels 10 and 90
    let units_per_pixel = 2.0 / 80.0;
    viewport.camera = Some(Camera { center: DVec2::splat(0.5 * units_per_pixel), units_per_pixel });
    let image = RgbaImage::from_pixel(4, 4, flat);
    // an invisible background must not leave traces of its color either
    let background = [0.1, 0.9, 0.9, 0.0];
    let pictures = [viewport.into()];
    let scene = SceneDescription { pictures: &pictures, background, image: Some(&image), margin_px: 0.0 };
    let picture = render_scene_with(&gpu.0, &gpu.1, &scene, [100, 100]).unwrap();
    let mut half = 0;
    for (x, y, pixel) in picture.enumerate_pixels().filter(|(.., pixel)| (40..=215).contains(&pixel.0[3])) {
        half += 1;
        let mut expected = flat.0;
        expected[3] = pixel.0[3];
        // two roundings, divided by a share of at least one sixth
        assert_pixel(&picture, [x, y], expected, 8, "edge");
    }
    assert!(half > 250, "only {half} pixels along the edges");
}

#[test]
fn a_row_that_is_not_aligned_for_copies_comes_back_straight() {
    let gpu = gpu();
    let viewports = [square(style(Pattern::Checker, 1.0)), square(style(Pattern::Checker, 1.0))];
    let image = render(gpu, &viewports, None, [201, 97]);
    assert_eq!(image.dimensions(), (201, 97));
    // columns 0..100 and 100..201; the squares' edges are 80 pixels apart
    for y in [2, 48, 94] {
        assert_pixel(&image, [5, y], bytes(BACKGROUND), 1, "left of the first square");
        assert_pixel(&image, [100, y], bytes(BACKGROUND), 1, "between the squares");
        assert_pixel(&image, [198, y], bytes(BACKGROUND), 1, "right of the second square");
    }
}

/// The coverage along a horizontal line through the left edge of the square, in pixels.
fn stroke_width(gpu: &Gpu, units_per_pixel: f64, points: &[DVec2], width_px: f32) -> f64 {
    let white = StrokeStyle { colour: [1.0; 4], width_px };
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.geometry.triangles = &[];
    viewport.boundary = points;
    viewport.boundary_style = Some(white);
    viewport.camera = Some(Camera { center: DVec2::new(-1.0, 0.05), units_per_pixel });
    let scene = SceneDescription {
        pictures: &[viewport.into()],
        background: [0.0, 0.0, 0.0, 1.0],
        image: None,
        margin_px: 0.0,
    };
    let image = render_scene_with(&gpu.0, &gpu.1, &scene, [40, 40]).unwrap();
    (0..40).map(|x| linear(image.get_pixel(x, 20).0[0])).sum()
}

#[test]
fn the_stroke_keeps_its_width_under_zoom_and_with_any_number_of_points() {
    let gpu = gpu();
    let fine: Vec<DVec2> =
        (0..4).flat_map(|k| (0..500).map(move |i| SQUARE[k].lerp(SQUARE[(k + 1) % 4], f64::from(i) / 500.0))).collect();
    for width in [0.6, 1.0, 1.75, 3.5, 5.0] {
        for units_per_pixel in [1e-5, 0.001, 0.02] {
            for points in [&SQUARE[..], &fine[..]] {
                let actual = stroke_width(gpu, units_per_pixel, points, width);
                let error = (actual - f64::from(width)).abs();
                // 8 bits of coverage and of color on either side
                assert!(error < 0.02, "{} points, scale {units_per_pixel}: {actual} for {width}", points.len());
            }
        }
    }
}

#[test]
fn precision_survives_a_far_origin_and_a_deep_zoom() {
    let gpu = gpu();
    let shift = DVec2::new(4.0e6, -7.0e6);
    let positions = SQUARE.map(|p| p + shift);
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.geometry = MeshGeometry { positions: &positions, texture_coordinates: &positions, ..viewport.geometry };
    viewport.style.bounds = (positions[0], positions[2]);
    viewport.camera = Some(Camera { center: shift, units_per_pixel: 2.0 / 80.0 });
    let far = render(gpu, &[viewport.clone()], None, [100, 100]);
    let near = render(gpu, &[square(style(Pattern::Checker, 4.0))], None, [100, 100]);
    assert_eq!(far.as_raw(), near.as_raw(), "a shift of {shift} changes the picture");
    // 10⁵ times larger, the corner at (1, 1) is still drawn within a pixel of its position
    viewport.camera = Some(Camera { center: positions[2], units_per_pixel: 2.0 / 8.0e6 });
    let deep = render(gpu, &[viewport], None, [100, 100]);
    assert_pixel(&deep, [48, 52], bytes(TextureStyle::paper()), 2, "just inside the corner");
    assert_pixel(&deep, [51, 48], bytes(BACKGROUND), 1, "just outside the corner");
}

#[test]
fn a_handle_is_a_coloured_disc_in_a_white_ring() {
    let gpu = gpu();
    let handles = [Handle { position: DVec2::new(0.5, 0.5), colour: GREEN, radius_px: 9.0 }];
    let mut viewport = square(style(Pattern::Checker, 4.0));
    viewport.handles = &handles;
    let image = render(gpu, &[viewport], None, [100, 100]);
    assert_pixel(&image, [70, 30], bytes(GREEN), 2, "centre");
    assert_pixel(&image, [77, 30], [255; 4], 2, "ring");
}

#[test]
fn impossible_scenes_are_refused_with_the_reason() {
    let (device, queue, _) = gpu();
    let scene = |pictures| SceneDescription { pictures, background: BACKGROUND, image: None, margin_px: 0.0 };
    let good = [square(style(Pattern::Checker, 4.0)).into()];
    assert!(matches!(render_scene_with(device, queue, &scene(&good), [0, 10]), Err(RenderError::Size { .. })));
    assert!(matches!(render_scene_with(device, queue, &scene(&good), [10, 1 << 30]), Err(RenderError::Size { .. })));
    assert!(matches!(
        render_scene_with(device, queue, &scene(&[]), [10, 10]),
        Err(RenderError::ViewportCount { count: 0, .. })
    ));
    let mut bad = square(style(Pattern::Checker, 4.0));
    bad.geometry.triangles = &[[0, 1, 4]];
    let error = render_scene_with(device, queue, &scene(&[bad.into()]), [10, 10]).unwrap_err();
    assert!(error.to_string().contains("triangle 0 [0, 1, 4]"), "{error}");
}

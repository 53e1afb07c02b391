//! Patterns in octaves: cells keep a visible size on the screen whatever the map and the camera do.

use super::support::*;
use glam::{DVec2, DVec3};
use image::RgbaImage;
use riemap::render::{
    BoundingSphere, Camera, MeshGeometry, OrbitCamera, Pattern, SceneDescription, ScenePicture, SceneSurface,
    SceneViewport, SurfaceGeometry, TextureStyle, render_scene_with,
};

const SIZE: u32 = 200;
const CELLS: f64 = 10.0;

/// Units per pixel at which a picture of the square [−1, 1]² shows the plain pattern: the square fills 0.85 of it.
const ORDINARY: f64 = 2.0 / (0.85 * SIZE as f64);

fn octaves(pattern: Pattern) -> TextureStyle {
    TextureStyle { octaves: true, ..style(pattern, CELLS) }
}

/// The square, drawn `stretch` times as large as its texture, at this scale.
fn shown(gpu: &Gpu, style: TextureStyle, stretch: f64, units_per_pixel: f64) -> RgbaImage {
    shown_around(gpu, style, DVec2::new(0.013, 0.021), stretch, units_per_pixel)
}

/// The same with the point of the texture at `center` in the middle.
fn shown_around(gpu: &Gpu, style: TextureStyle, center: DVec2, stretch: f64, units_per_pixel: f64) -> RgbaImage {
    let positions = SQUARE.map(|p| stretch * p);
    let camera = Camera { center: stretch * center, units_per_pixel };
    let geometry = MeshGeometry { positions: &positions, ..square(style).geometry };
    render(gpu, &[SceneViewport { geometry, camera: Some(camera), ..square(style) }], None, [SIZE, SIZE])
}

/// How often the brightness passes the middle between the paper's and the hues' along the middle row.
fn changes(image: &RgbaImage) -> usize {
    let light: Vec<bool> = (0..image.width()).map(|x| image.get_pixel(x, image.height() / 2).0[1] > 170).collect();
    light.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn largest_difference(a: &RgbaImage, b: &RgbaImage) -> u8 {
    a.as_raw().iter().zip(b.as_raw()).map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

#[test]
fn at_the_scale_of_the_whole_domain_the_pattern_is_the_plain_one() {
    let gpu = gpu();
    for pattern in [Pattern::Checker, Pattern::Grid, Pattern::Polar] {
        // a quarter of an octave either way, too
        for factor in [0.84, 1.0, 1.18] {
            let [plain, divided] =
                [style(pattern, CELLS), octaves(pattern)].map(|style| shown(gpu, style, 1.0, factor * ORDINARY));
            assert!(largest_difference(&plain, &divided) <= 1, "{pattern:?} at {factor}");
        }
    }
}

#[test]
fn cells_are_as_large_on_the_screen_at_every_scale() {
    let gpu = gpu();
    // 8.5 cells of a tenth of the square in a row
    let expected = changes(&shown(gpu, style(Pattern::Checker, CELLS), 1.0, 0.5 * ORDINARY)) * 2;
    assert!((8..=12).contains(&expected), "{expected}");
    for octave in 0..=11 {
        let scale = 0.5_f64.powi(octave);
        let zoomed = shown(gpu, octaves(Pattern::Checker), 1.0, scale * ORDINARY * 0.8);
        assert!(changes(&zoomed).abs_diff(expected) <= 3, "zoomed by 2^{octave}: {}", changes(&zoomed));
        let magnified = shown(gpu, octaves(Pattern::Checker), 1.0 / scale, ORDINARY * 0.8);
        assert!(changes(&magnified).abs_diff(expected) <= 3, "|f'| = 2^{octave}: {}", changes(&magnified));
    }
    let plain = shown(gpu, style(Pattern::Checker, CELLS), 64.0, ORDINARY);
    assert!(changes(&plain) <= 1, "without octaves it is one or two cells");
}

#[test]
fn cells_of_a_compressed_part_are_joined() {
    let gpu = gpu();
    // a sixteenth of the size: 12 pixels, plain cells of 1.1
    let small = shown(gpu, octaves(Pattern::Checker), 1.0 / 16.0, ORDINARY);
    let (light, dark) = (0..SIZE)
        .flat_map(|y| (0..SIZE).map(move |x| [x, y]))
        .map(|[x, y]| small.get_pixel(x, y).0[1])
        .filter(|&green| green != bytes(BACKGROUND)[1])
        .fold((0, 255), |(light, dark): (u8, u8), green| (light.max(green), dark.min(green)));
    assert!(light > 225 && dark < 140, "{light} {dark}: cells are told apart");
}

#[test]
fn half_way_between_two_octaves_the_picture_is_the_mean_of_both() {
    let gpu = gpu();
    let half = std::f64::consts::FRAC_1_SQRT_2 * ORDINARY;
    let between = shown(gpu, octaves(Pattern::Checker), 1.0, half);
    let both = [CELLS, 2.0 * CELLS].map(|cells| shown(gpu, style(Pattern::Checker, cells), 1.0, half));
    for (x, y) in (10..SIZE - 10).step_by(7).flat_map(|x| (10..SIZE - 10).step_by(7).map(move |y| (x, y))) {
        let mean = both.iter().map(|image| linear(image.get_pixel(x, y).0[0])).sum::<f64>() / 2.0;
        let found = linear(between.get_pixel(x, y).0[0]);
        assert!((found - mean).abs() < 0.012, "at ({x}, {y}): {found} instead of {mean}");
    }
}

/// The width in pixels of the vertical line in the middle, in the row where the least is covered.
fn line_width(image: &RgbaImage) -> f64 {
    let row = |y: u32| {
        let window = (SIZE / 2 - 7..SIZE / 2 + 7).map(|x| linear(image.get_pixel(x, y).0[1]));
        let (ground, paper) = (window.clone().fold(1.0, f64::min), linear(bytes(TextureStyle::paper())[1]));
        window.map(|light| (light - ground) / (paper - ground)).sum::<f64>()
    };
    (SIZE / 2 - 20..SIZE / 2 + 20).map(row).fold(f64::INFINITY, f64::min)
}

#[test]
fn lines_of_the_grid_keep_their_width_at_every_scale() {
    let gpu = gpu();
    let width = |scale: f64| {
        let center = DVec2::new(0.0, 0.05) * scale;
        line_width(&shown_around(gpu, octaves(Pattern::Grid), center, 1.0, scale * ORDINARY))
    };
    let ordinary = width(1.0);
    assert!((1.5..3.0).contains(&ordinary), "{ordinary}");
    for step in 1..=20 {
        let zoomed = width(0.5_f64.powf(0.5 * f64::from(step)));
        assert!(
            (zoomed - ordinary).abs() < 0.1,
            "zoomed by 2^{}: {zoomed} instead of {ordinary}",
            0.5 * f64::from(step)
        );
    }
}

/// The square in space, `distance` from the eye and turned by `tilt` radians about the vertical axis.
fn in_space(gpu: &Gpu, style: TextureStyle, distance: f64, tilt: f64) -> RgbaImage {
    let positions = SQUARE.map(|p| p.extend(0.0));
    let towards_eye = DVec3::new(tilt.sin(), 0.0, tilt.cos());
    let scene = BoundingSphere { center: DVec3::ZERO, radius: 1.6 };
    let mut camera = OrbitCamera::new(scene, towards_eye, DVec3::Y, 1.0);
    (camera.target, camera.distance) = (DVec3::new(0.013, 0.021, 0.0), distance);
    let part = SceneSurface {
        geometry: SurfaceGeometry { positions: &positions, triangles: &SQUARE_TRIANGLES, boundary_count: 4 },
        texture_coordinates: &SQUARE,
        codes: &[],
        cells: None,
        camera,
        style,
        stroke: None,
        handles: &[],
    };
    let pictures = [ScenePicture::Space(part)];
    let scene = SceneDescription { pictures: &pictures, background: BACKGROUND, image: None, margin_px: 0.0 };
    render_scene_with(&gpu.0, &gpu.1, &scene, [SIZE, SIZE]).unwrap()
}

#[test]
fn on_a_surface_cells_keep_their_size_however_near_the_eye_is() {
    let gpu = gpu();
    let at = |distance: f64| changes(&in_space(gpu, octaves(Pattern::Checker), distance, 0.0));
    let expected = at(3.2);
    assert!((6..=16).contains(&expected), "{expected}");
    for distance in [1.6, 0.8, 0.4, 0.2] {
        assert!(at(distance).abs_diff(expected) <= 3, "at {distance}: {} instead of {expected}", at(distance));
    }
}

#[test]
fn a_surface_that_turns_away_keeps_its_octave() {
    let gpu = gpu();
    // 60°: cells are half as wide and as high as before
    let [before, turned] = [0.0, 1.047].map(|tilt| in_space(gpu, octaves(Pattern::Checker), 4.8, tilt));
    let column = |image: &RgbaImage| changes(&image::imageops::rotate90(image));
    assert!(column(&turned).abs_diff(column(&before)) <= 1, "{} {}", column(&turned), column(&before));
}

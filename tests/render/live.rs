//! The renderer as used by the app: frame after frame into a given pass.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::render::{
    Camera, CellCode, CellStyle, Detail, Handle, MeshGeometry, Pace, Pattern, PlanarFrame, REFINED_AFTER, StrokeStyle,
    ViewportRenderer, sample_count,
};

/// [`painted`] with the texture image.
fn frame(gpu: &Gpu, renderer: &mut ViewportRenderer, format: wgpu::TextureFormat) -> RgbaImage {
    painted(gpu, renderer, format, &style(Pattern::Image, 1.0))
}

/// A renderer with the square in viewport 0 and a flat image of `colour`.
fn renderer(gpu: &Gpu, format: wgpu::TextureFormat, colour: [u8; 4]) -> ViewportRenderer {
    let (device, queue, _) = gpu;
    let mut renderer = ViewportRenderer::new(device, queue, format, 1, sample_count(device));
    renderer.set_image(device, queue, &colour.repeat(6), 3, 2).unwrap();
    assert!(renderer.set_mesh(device, queue, 0, &square(style(Pattern::Image, 1.0)).geometry));
    renderer
}

#[test]
fn colours_are_the_same_in_targets_that_encode_and_that_do_not() {
    let gpu = gpu();
    let colour = [200, 107, 57, 255];
    for format in [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb] {
        let image = frame(gpu, &mut renderer(gpu, format, colour), format);
        assert_pixel(&image, [32, 32], colour, 1, "image colour");
        assert_pixel(&image, [4, 4], bytes(BACKGROUND), 1, "background");
    }
}

#[test]
fn moved_vertices_move_the_picture() {
    let gpu = gpu();
    let (format, colour) = (wgpu::TextureFormat::Rgba8Unorm, [10, 180, 90, 255]);
    let mut renderer = renderer(gpu, format, colour);
    assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "before");
    assert!(renderer.set_positions(&gpu.1, 0, &SQUARE.map(|p| 0.5 * p + DVec2::new(1.25, 1.25))));
    let image = frame(gpu, &mut renderer, format);
    assert_pixel(&image, [32, 32], bytes(BACKGROUND), 1, "after, where it was");
    assert_pixel(&image, [52, 12], colour, 1, "after, where it is");
}

#[test]
fn moved_texture_coordinates_move_the_texture() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let (left, right) = ([250, 20, 20, 255], [20, 20, 250, 255]);
    let mut renderer = renderer(gpu, format, left);
    let halves = [left.repeat(8), right.repeat(8)].concat().repeat(16);
    renderer.set_image(device, queue, &halves, 16, 16).unwrap();
    // the left half of the source on the whole square, then the right half
    for (shift, colour) in [(-0.75, left), (0.75, right)] {
        let coordinates = SQUARE.map(|p| 0.1 * p + DVec2::new(shift, 0.0));
        assert!(renderer.set_texture_coordinates(queue, 0, &coordinates));
        assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "centre");
    }
}

#[test]
fn data_that_does_not_fit_is_refused_and_changes_nothing() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let (format, colour) = (wgpu::TextureFormat::Rgba8Unorm, [10, 180, 90, 255]);
    let mut renderer = renderer(gpu, format, colour);
    assert!(!renderer.set_positions(queue, 0, &SQUARE[..3]));
    assert!(!renderer.set_texture_coordinates(queue, 0, &SQUARE[..3]));
    assert!(!renderer.set_positions(queue, 1, &SQUARE));
    let triangles = [[0, 1, 7]];
    let bad = MeshGeometry { positions: &SQUARE, texture_coordinates: &SQUARE, triangles: &triangles };
    assert!(!renderer.set_mesh(device, queue, 0, &bad));
    assert!(renderer.set_image(device, queue, &[0; 5], 1, 1).is_err());
    assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "the first mesh and image");
}

#[test]
fn an_image_beyond_the_largest_texture_is_scaled_down() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let mut renderer = renderer(gpu, format, [0, 0, 0, 255]);
    let (width, colour) = (device.limits().max_texture_dimension_2d + 100, [200, 107, 57, 255]);
    renderer.set_image(device, queue, &colour.repeat(2 * width as usize), width, 2).unwrap();
    assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "the scaled image");
}

/// Records and paints the next frame; returns its detail if anything was recorded.
fn recorded(gpu: &Gpu, renderer: &mut ViewportRenderer, frame: &PlanarFrame, pace: Pace) -> Option<Detail> {
    let (device, queue, _) = gpu;
    let prepare = |renderer: &mut ViewportRenderer, encoder: &mut wgpu::CommandEncoder| {
        renderer.prepare(device, queue, encoder, 0, frame, pace)
    };
    one_frame(gpu, renderer, wgpu::TextureFormat::Rgba8Unorm, prepare, |renderer, pass| renderer.paint(pass, 0)).0
}

#[test]
fn an_unchanged_picture_is_not_recorded_and_every_change_is() {
    let gpu = gpu();
    let (device, queue, _) = gpu;
    let mut renderer = renderer(gpu, wgpu::TextureFormat::Rgba8Unorm, [10, 180, 90, 255]);
    let mut codes = vec![CellCode::FLIPPED; 2];
    let frame = live_frame(&style(Pattern::Checker, 4.0));
    let cells = CellStyle { map: None, wire: None, marks: true, pixels_per_point: 1.0 };
    let handle = Handle { position: DVec2::ZERO, colour: GREEN, radius_px: 4.0 };
    let geometry = square(frame.style).geometry;
    let mut changes: Vec<Change> = vec![
        ("set_mesh", Box::new(|r| r.set_mesh(device, queue, 0, &geometry))),
        ("set_positions", Box::new(|r| r.set_positions(queue, 0, &SQUARE))),
        ("set_texture_coordinates", Box::new(|r| r.set_texture_coordinates(queue, 0, &SQUARE))),
        ("set_cells", Box::new(|r| r.set_cells(device, queue, 0, &SQUARE, &SQUARE_TRIANGLES))),
        ("set_cell_positions", Box::new(|r| r.set_cell_positions(queue, 0, &SQUARE))),
        ("set_cell_codes", Box::new(|r| r.set_cell_codes(queue, 0, &mut codes))),
        ("set_cell_style", Box::new(|r| (r.set_cell_style(0, Some(cells)), true).1)),
        ("set_boundary", Box::new(|r| r.set_boundary(device, queue, 0, &SQUARE))),
        ("set_boundary_style", Box::new(|r| (r.set_boundary_style(0, Some(StrokeStyle::themed(true, 2.0))), true).1)),
        ("set_handles", Box::new(|r| (r.set_handles(device, queue, 0, &[handle]), true).1)),
        ("set_image", Box::new(|r| r.set_image(device, queue, &[0; 16], 2, 2).is_ok())),
    ];
    assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), Some(Detail::Full), "the first");
    for (name, change) in &mut changes {
        assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), None, "before {name}");
        assert!(change(&mut renderer), "{name}");
        assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), Some(Detail::Full), "{name}");
    }
    renderer.set_cell_style(0, Some(cells));
    assert_eq!(recorded(gpu, &mut renderer, &frame, Pace::Full), None, "the same style once more");
    let mut dropped = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    assert!(renderer.set_positions(queue, 0, &SQUARE));
    renderer.prepare(device, queue, &mut dropped, 0, &frame, Pace::Full);
    drop(dropped); // as when the window currently has no surface
    assert!(recorded(gpu, &mut renderer, &frame, Pace::Full).is_some(), "what was never painted");
    let moved = Camera { center: DVec2::X, ..frame.camera };
    assert!(recorded(gpu, &mut renderer, &PlanarFrame { camera: moved, ..frame }, Pace::Full).is_some(), "camera");
    let larger = PlanarFrame { size_px: [65, 64], ..frame };
    assert!(recorded(gpu, &mut renderer, &larger, Pace::Full).is_some(), "size");
}

#[test]
fn a_coarse_picture_shows_the_same_and_becomes_full_at_rest() {
    let gpu = gpu();
    let (format, colour) = (wgpu::TextureFormat::Rgba8Unorm, [10, 180, 90, 255]);
    let mut renderer = renderer(gpu, format, colour);
    assert!(renderer.set_boundary(&gpu.0, &gpu.1, 0, &SQUARE));
    let frame = live_frame(&style(Pattern::Image, 1.0));
    let full = painted_at(gpu, &mut renderer, format, &frame, Pace::Full);
    renderer.set_handles(&gpu.0, &gpu.1, 0, &[]);
    let at = |now| Pace::CoarseFirst { now };
    let coarse = painted_at(gpu, &mut renderer, format, &frame, at(5.0));
    assert!(renderer.is_coarse(0));
    for place in [[32, 32], [4, 4], [32, 60], [24, 40]] {
        assert_pixel(&coarse, place, full.get_pixel(place[0], place[1]).0, 1, "coarse");
    }
    // the square's edges are 16 pixels from the picture's
    let from_outline = |at: u32| at.abs_diff(16).min(at.abs_diff(48));
    let differ = |x, y| full.get_pixel(x, y) != coarse.get_pixel(x, y);
    let differing: Vec<_> = (0..64).flat_map(|y| (0..64).map(move |x| (x, y))).filter(|&(x, y)| differ(x, y)).collect();
    assert!(!differing.is_empty());
    assert!(differing.iter().all(|&(x, y)| from_outline(x).min(from_outline(y)) <= 4), "only the outline is softer");
    assert_eq!(recorded(gpu, &mut renderer, &frame, at(5.0 + 2.0 * REFINED_AFTER)), Some(Detail::Full));
    assert!(!renderer.is_coarse(0));
    let refined = painted_at(gpu, &mut renderer, format, &frame, at(6.0));
    assert_eq!(refined, full);
}

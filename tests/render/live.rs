//! The renderer as the app drives it: frame after frame into a pass of its own.

use super::support::*;
use glam::DVec2;
use image::RgbaImage;
use riemap::render::{MeshGeometry, Pattern, ViewportRenderer};

/// [`painted`] with the texture image.
fn frame(gpu: &Gpu, renderer: &mut ViewportRenderer, format: wgpu::TextureFormat) -> RgbaImage {
    painted(gpu, renderer, format, &style(Pattern::Image, 1.0))
}

/// A renderer with the square in viewport 0 and a flat image of `colour`.
fn renderer(gpu: &Gpu, format: wgpu::TextureFormat, colour: [u8; 4]) -> ViewportRenderer {
    let (device, queue, _) = gpu;
    let mut renderer = ViewportRenderer::new(device, queue, format, 1);
    renderer.set_image(device, queue, &colour.repeat(6), 3, 2).unwrap();
    assert!(renderer.set_mesh(device, queue, 0, &square(style(Pattern::Image, 1.0)).geometry));
    renderer
}

#[test]
fn colours_are_the_same_in_targets_that_encode_and_that_do_not() {
    let Some(gpu) = gpu() else { return };
    let colour = [200, 107, 57, 255];
    for format in [wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureFormat::Rgba8UnormSrgb] {
        let image = frame(gpu, &mut renderer(gpu, format, colour), format);
        assert_pixel(&image, [32, 32], colour, 1, "image colour");
        assert_pixel(&image, [4, 4], bytes(BACKGROUND), 1, "background");
    }
}

#[test]
fn moved_vertices_move_the_picture() {
    let Some(gpu) = gpu() else { return };
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
    let Some(gpu) = gpu() else { return };
    let (device, queue, _) = gpu;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let (left, right) = ([250, 20, 20, 255], [20, 20, 250, 255]);
    let mut renderer = renderer(gpu, format, left);
    let halves = [left.repeat(8), right.repeat(8)].concat().repeat(16);
    renderer.set_image(device, queue, &halves, 16, 16).unwrap();
    // The left half of the source over the whole square, then the right half.
    for (shift, colour) in [(-0.75, left), (0.75, right)] {
        let coordinates = SQUARE.map(|p| 0.1 * p + DVec2::new(shift, 0.0));
        assert!(renderer.set_texture_coordinates(queue, 0, &coordinates));
        assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "centre");
    }
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let Some(gpu) = gpu() else { return };
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
    let Some(gpu) = gpu() else { return };
    let (device, queue, _) = gpu;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let mut renderer = renderer(gpu, format, [0, 0, 0, 255]);
    let (width, colour) = (device.limits().max_texture_dimension_2d + 100, [200, 107, 57, 255]);
    renderer.set_image(device, queue, &colour.repeat(2 * width as usize), width, 2).unwrap();
    assert_pixel(&frame(gpu, &mut renderer, format), [32, 32], colour, 1, "the scaled image");
}

//! Maps geometry relative to an origin to clip coordinates or pixels.
//!
//! The large numbers cancel in f64, here; the shader only scales and shifts.

use super::Camera;
use glam::DVec2;

/// `(scale x, scale y, offset x, offset y)` from positions relative to `origin`
/// to pixels, y down.
pub fn to_pixels(camera: &Camera, origin: DVec2, size_px: [u32; 2]) -> [f32; 4] {
    let scale = 1.0 / camera.units_per_pixel;
    let shift = (origin - camera.center) * scale;
    let half = 0.5 * DVec2::new(f64::from(size_px[0]), f64::from(size_px[1]));
    [scale as f32, -scale as f32, (half.x + shift.x) as f32, (half.y - shift.y) as f32]
}

/// The same to clip coordinates, y up.
pub fn to_clip(camera: &Camera, origin: DVec2, size_px: [u32; 2]) -> [f32; 4] {
    let half = 0.5 * DVec2::new(f64::from(size_px[0]), f64::from(size_px[1]));
    let scale = DVec2::ONE / (camera.units_per_pixel * half);
    let shift = (origin - camera.center) * scale;
    [scale.x as f32, scale.y as f32, shift.x as f32, shift.y as f32]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_and_clip_coordinates_agree_with_the_camera() {
        let camera = Camera { center: DVec2::new(1.5, -2.0), units_per_pixel: 0.01 };
        let (origin, p, size) = (DVec2::new(1.0, -1.0), DVec2::new(1.75, -2.5), [300, 200]);
        let expected = camera.to_screen(p, [300.0, 200.0]);
        let relative = (p - origin).as_vec2();
        let [sx, sy, ox, oy] = to_pixels(&camera, origin, size);
        let pixel = [relative.x * sx + ox, relative.y * sy + oy];
        let [sx, sy, ox, oy] = to_clip(&camera, origin, size);
        let clip = [relative.x * sx + ox, relative.y * sy + oy];
        for axis in 0..2 {
            // f32 at a few hundred pixels.
            assert!((pixel[axis] - expected[axis]).abs() < 1e-3, "{pixel:?} against {expected:?}");
        }
        assert!((150.0 * (1.0 + clip[0]) - expected[0]).abs() < 1e-3, "{clip:?}");
        assert!((100.0 * (1.0 - clip[1]) - expected[1]).abs() < 1e-3, "{clip:?}");
    }
}

//! The plane seen through a viewport: a center and a scale, no rotation.
//!
//! World coordinates have y up, pixels have y down and are physical; pixel
//! (0, 0) is the viewport's upper left corner, not the center of a pixel.
//! `to_world ∘ to_screen` is the identity up to the rounding of the f32 pixels.

use glam::DVec2;

/// World → screen: `center` is in the middle of the viewport.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The world point in the middle of the viewport.
    pub center: DVec2,
    /// World units per physical pixel, positive.
    pub units_per_pixel: f64,
}

impl Camera {
    /// The camera that shows `bounds` (lower left, upper right corner) as large
    /// as `size_px` allows with a free margin of `margin_px` on every side.
    ///
    /// At least one pixel is left for the content however large the margin is.
    /// Bounds without extent are shown at one unit per pixel.
    pub fn fit(bounds: (DVec2, DVec2), size_px: [f32; 2], margin_px: f32) -> Self {
        let extent = bounds.1 - bounds.0;
        let room = |size: f32| f64::from(size - 2.0 * margin_px).max(1.0);
        let needed = (extent.x / room(size_px[0])).max(extent.y / room(size_px[1]));
        let units_per_pixel = if needed.is_finite() && needed > 0.0 { needed } else { 1.0 };
        Self { center: 0.5 * (bounds.0 + bounds.1), units_per_pixel }
    }

    /// The pixel position of the world point `p` in a viewport of `size_px`.
    pub fn to_screen(&self, p: DVec2, size_px: [f32; 2]) -> [f32; 2] {
        let d = (p - self.center) / self.units_per_pixel;
        [(0.5 * f64::from(size_px[0]) + d.x) as f32, (0.5 * f64::from(size_px[1]) - d.y) as f32]
    }

    /// The world point under the pixel position `px` of a viewport of `size_px`.
    pub fn to_world(&self, px: [f32; 2], size_px: [f32; 2]) -> DVec2 {
        let x = f64::from(px[0]) - 0.5 * f64::from(size_px[0]);
        let y = 0.5 * f64::from(size_px[1]) - f64::from(px[1]);
        self.center + self.units_per_pixel * DVec2::new(x, y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_comes_back_from_the_screen() {
        let size = [640.0, 480.0];
        let camera = Camera { center: DVec2::new(3.0, -7.5), units_per_pixel: 0.013 };
        for p in [DVec2::new(0.0, 0.0), DVec2::new(4.1, -6.0), DVec2::new(-2.5, 11.0)] {
            let back = camera.to_world(camera.to_screen(p, size), size);
            // f32 pixels up to 2000 are rounded by 6e-5 at most.
            assert!(back.distance(p) < 1e-4 * camera.units_per_pixel, "{p} came back as {back}");
        }
    }

    #[test]
    fn fit_touches_the_margin_on_the_longer_side_and_y_points_up() {
        let bounds = (DVec2::new(-1.0, 0.0), DVec2::new(3.0, 1.0));
        let size = [200.0, 100.0];
        let camera = Camera::fit(bounds, size, 10.0);
        assert_eq!(camera.to_screen(bounds.0, size)[0], 10.0);
        assert_eq!(camera.to_screen(bounds.1, size)[0], 190.0);
        assert!(camera.to_screen(bounds.1, size)[1] < camera.to_screen(bounds.0, size)[1]);
        assert_eq!(camera.to_screen(camera.center, size), [100.0, 50.0]);
    }

    #[test]
    fn fit_of_a_single_point_or_of_no_room_stays_finite() {
        let p = DVec2::new(2.0, 2.0);
        assert_eq!(Camera::fit((p, p), [10.0, 10.0], 0.0).units_per_pixel, 1.0);
        let cramped = Camera::fit((DVec2::ZERO, DVec2::ONE), [10.0, 10.0], 50.0);
        assert_eq!(cramped.units_per_pixel, 1.0);
    }
}

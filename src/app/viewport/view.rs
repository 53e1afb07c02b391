//! The camera of a planar viewport: the part of the plane that is shown, panned, zoomed or fitted.
//!
//! Rectangles, places and displacements are in points on the screen; [`View::camera`] and
//! [`View::size_px`] are in physical pixels, for the renderer.

use crate::geometry::DVec2;
use crate::render::Camera;
use egui::{Pos2, Rect, Vec2, vec2};

/// Free space around a fitted outline or surface, in points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Left and right.
    pub sides: f32,
    /// Above, for title and buttons.
    pub top: f32,
    /// Below, for the legend.
    pub bottom: f32,
}

impl Margins {
    /// No free space.
    #[cfg(test)]
    pub const NONE: Self = Self { sides: 0.0, top: 0.0, bottom: 0.0 };

    /// The part of `rect` between the margins; at least a point wide and high.
    pub fn within(self, rect: Rect) -> Rect {
        let Self { sides, top, bottom } = self;
        let size = vec2((rect.width() - 2.0 * sides).max(1.0), (rect.height() - top - bottom).max(1.0));
        Rect::from_min_size(rect.min + vec2(sides, top), size)
    }
}

/// The margins on a desktop, with room for a legend.
pub const DESK_MARGINS: Margins = Margins { sides: 30.0, top: 58.0, bottom: 46.0 };
/// The margins on a phone.
pub const PHONE_MARGINS: Margins = Margins { sides: 20.0, top: 58.0, bottom: 38.0 };

/// The largest zoom factor relative to the fitted view: rounding to f32 becomes visible at about 10⁵.
const MAX_ZOOM: f64 = 2e4;
/// The smallest zoom factor relative to the fitted view.
const MIN_ZOOM: f64 = 0.1;

/// The camera and its place on the screen.
#[derive(Debug, Clone)]
pub struct View {
    /// The viewport's rectangle on the screen, aligned with physical pixels.
    pub rect: Rect,
    pixels_per_point: f32,
    camera: Camera,
    fitted_units_per_pixel: f64,
    follows_outline: bool,
}

impl Default for View {
    fn default() -> Self {
        Self {
            rect: Rect::from_min_size(Pos2::ZERO, vec2(1.0, 1.0)),
            pixels_per_point: 1.0,
            camera: Camera { center: DVec2::ZERO, units_per_pixel: 1.0 },
            fitted_units_per_pixel: 1.0,
            follows_outline: true,
        }
    }
}

impl View {
    /// Moves the view to `rect` and, unless it was panned or zoomed, fits `bounds` into it.
    pub fn place(&mut self, rect: Rect, pixels_per_point: f32, margins: Margins, bounds: Option<(DVec2, DVec2)>) {
        let snap = |v: f32| (v * pixels_per_point).round() / pixels_per_point;
        let corner = |p: Pos2| Pos2::new(snap(p.x), snap(p.y));
        let old = self.pixels_per_point;
        self.rect = Rect::from_min_max(corner(rect.min), corner(rect.max));
        self.pixels_per_point = pixels_per_point;
        self.camera.units_per_pixel *= f64::from(old / pixels_per_point);
        if let Some(bounds) = bounds {
            let fitted = self.fitted(bounds, margins);
            self.fitted_units_per_pixel = fitted.units_per_pixel;
            if self.follows_outline {
                self.camera = fitted;
            }
        }
    }

    /// Fits the outline at every following [`Self::place`].
    pub fn fit(&mut self) {
        self.follows_outline = true;
    }

    /// Keeps the camera where it is when the outline changes.
    pub fn stay(&mut self) {
        self.follows_outline = false;
    }

    /// Whether the camera follows the outline.
    pub fn is_fitted(&self) -> bool {
        self.follows_outline
    }

    /// The camera in physical pixels, for the renderer.
    pub fn camera(&self) -> Camera {
        self.camera
    }

    /// The size in physical pixels.
    pub fn size_px(&self) -> [u32; 2] {
        self.size().map(|side| side.round().max(1.0) as u32)
    }

    /// The decimals of coordinates that a physical pixel resolves.
    pub fn decimals(&self) -> usize {
        (-self.camera.units_per_pixel.log10()).ceil().clamp(0.0, 12.0) as usize
    }

    /// The place of a point of the plane on the screen.
    pub fn to_screen(&self, point: DVec2) -> Pos2 {
        let [x, y] = self.camera.to_screen(point, self.size());
        self.rect.min + vec2(x, y) / self.pixels_per_point
    }

    /// The point of the plane at a place on the screen.
    pub fn to_world(&self, place: Pos2) -> DVec2 {
        let d = (place - self.rect.min) * self.pixels_per_point;
        self.camera.to_world([d.x, d.y], self.size())
    }

    /// Moves the picture by `delta` on the screen and stops following the outline.
    pub fn pan(&mut self, delta: Vec2) {
        if delta != Vec2::ZERO {
            let d = delta * self.pixels_per_point;
            self.camera.center -= self.camera.units_per_pixel * DVec2::new(f64::from(d.x), -f64::from(d.y));
            self.follows_outline = false;
        }
    }

    /// Enlarges the picture by `factor` about `place`, within the limits of the zoom, and stops following the outline.
    /// A factor that is not positive and finite is ignored.
    pub fn zoom(&mut self, factor: f32, place: Pos2) {
        if factor != 1.0 && factor.is_finite() && factor > 0.0 {
            let fixed = self.to_world(place);
            let fitted = self.fitted_units_per_pixel;
            let wanted = self.camera.units_per_pixel / f64::from(factor);
            self.camera.units_per_pixel = wanted.clamp(fitted / MAX_ZOOM, fitted / MIN_ZOOM);
            self.camera.center += fixed - self.to_world(place);
            self.follows_outline = false;
        }
    }

    fn size(&self) -> [f32; 2] {
        [self.rect.width() * self.pixels_per_point, self.rect.height() * self.pixels_per_point]
    }

    fn fitted(&self, bounds: (DVec2, DVec2), margins: Margins) -> Camera {
        let [sides, top, bottom] =
            [margins.sides, margins.top, margins.bottom].map(|margin| margin * self.pixels_per_point);
        fit(bounds, self.size(), Margins { sides, top, bottom })
    }
}

/// The camera that fits `bounds` between the margins of a viewport of this size; margins and size in the same unit.
fn fit(bounds: (DVec2, DVec2), [width, height]: [f32; 2], Margins { sides, top, bottom }: Margins) -> Camera {
    let free = [(width - 2.0 * sides).max(1.0), (height - top - bottom).max(1.0)];
    let mut camera = Camera::fit(bounds, free, 0.0);
    camera.center.y += 0.5 * f64::from(top - bottom) * camera.units_per_pixel;
    camera
}

/// The free height of `rect` below `bounds` fitted into it.
pub fn free_below(rect: Rect, bounds: (DVec2, DVec2), margins: Margins) -> f32 {
    let size = rect.size().into();
    rect.height() - fit(bounds, size, margins).to_screen(bounds.0, size)[1]
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    fn view() -> View {
        let mut view = View::default();
        let rect = Rect::from_min_size(pos2(250.0, 46.0), vec2(560.0, 600.0));
        view.place(rect, 2.0, DESK_MARGINS, Some((DVec2::new(-1.0, -1.0), DVec2::new(1.0, 1.0))));
        view
    }

    #[test]
    fn a_fitted_outline_lies_between_the_margins() {
        let view = view();
        let (low, high) = (view.to_screen(DVec2::new(-1.0, -1.0)), view.to_screen(DVec2::new(1.0, 1.0)));
        assert!(
            high.y >= view.rect.top() + DESK_MARGINS.top - 0.01
                && low.y <= view.rect.bottom() - DESK_MARGINS.bottom + 0.01
        );
        assert!(
            low.x >= view.rect.left() + DESK_MARGINS.sides - 0.01
                && high.x <= view.rect.right() - DESK_MARGINS.sides + 0.01
        );
    }

    #[test]
    fn screen_and_world_are_inverse() {
        let view = view();
        let place = pos2(300.5, 222.25);
        // f32 pixels up to 2000 are rounded by 6e-5 at most.
        assert!(view.to_screen(view.to_world(place)).distance(place) < 1e-3);
    }

    #[test]
    fn zooming_keeps_the_place_under_the_pointer() {
        let mut view = view();
        let place = pos2(400.0, 200.0);
        let before = view.to_world(place);
        view.zoom(3.0, place);
        assert!(view.to_world(place).distance(before) < 1e-6);
        assert!(!view.is_fitted());
    }

    #[test]
    fn panning_moves_the_picture_with_the_pointer() {
        let mut view = view();
        let at = view.to_screen(DVec2::ZERO);
        view.pan(vec2(12.0, -7.0));
        assert!(view.to_screen(DVec2::ZERO).distance(at + vec2(12.0, -7.0)) < 1e-3);
    }

    #[test]
    fn zoom_is_bounded_and_fit_brings_everything_back() {
        let mut view = view();
        let fitted = view.camera();
        for _ in 0..100 {
            view.zoom(10.0, pos2(400.0, 200.0));
        }
        assert!(view.camera().units_per_pixel >= fitted.units_per_pixel / MAX_ZOOM * 0.999);
        view.fit();
        view.place(view.rect, 2.0, DESK_MARGINS, Some((DVec2::new(-1.0, -1.0), DVec2::new(1.0, 1.0))));
        assert_eq!(view.camera(), fitted);
    }
}

//! How the surface is seen: an eye that goes around it, in points of its viewport.

use crate::app::viewport::view::Margins;
use crate::geometry::{DVec2, DVec3};
use crate::render::{BoundingSphere, OrbitCamera};
use egui::{Pos2, Rect, Vec2};

/// How long a turn goes on after it was let go: its speed falls by e in this time, in seconds.
const INERTIA_SECONDS: f32 = 0.18;
/// Points per second below which it stands.
const STANDS_BELOW: f32 = 15.0;

/// The state of the surface's viewport.
#[derive(Debug, Clone)]
pub struct OrbitView {
    /// Its place on the screen.
    pub rect: Rect,
    pixels_per_point: f32,
    camera: Option<OrbitCamera>,
    is_fitted: bool,
    /// The turn that goes on, in points per second.
    spin: Vec2,
}

impl Default for OrbitView {
    fn default() -> Self {
        let rect = Rect::from_min_size(Pos2::ZERO, Vec2::splat(1.0));
        Self { rect, pixels_per_point: 1.0, camera: None, is_fitted: true, spin: Vec2::ZERO }
    }
}

impl OrbitView {
    /// Puts the view at `rect`; unless it was moved or zoomed, it shows all of `scene` between the margins.
    pub fn place(&mut self, rect: Rect, pixels_per_point: f32, margins: Margins, scene: BoundingSphere) {
        (self.rect, self.pixels_per_point) = (rect, pixels_per_point);
        let size = self.size();
        if let Some(camera) = self.camera.as_mut().filter(|_| self.is_fitted) {
            let free = margins.within(rect);
            // the sphere as in a viewport that is as wide as the free part's shorter side, moved to its middle
            camera.fit(scene, f64::from(free.size().min_elem() / rect.height()));
            camera.pan(wide(free.center() - rect.center()), size);
        }
    }

    /// Looks at another surface.
    pub fn look(&mut self, camera: OrbitCamera) {
        self.camera = Some(camera);
        (self.is_fitted, self.spin) = (true, Vec2::ZERO);
    }

    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.rect.width() / self.rect.height())
    }

    /// Shows the whole surface from now on, from the same side.
    pub fn fit(&mut self) {
        (self.is_fitted, self.spin) = (true, Vec2::ZERO);
    }

    /// Whether it shows the whole surface.
    pub fn is_fitted(&self) -> bool {
        self.is_fitted
    }

    /// What the renderer needs; `None` before there was a surface.
    pub fn camera(&self) -> Option<&OrbitCamera> {
        self.camera.as_ref()
    }

    /// The size in physical pixels.
    pub fn size_px(&self) -> [u32; 2] {
        [self.rect.width(), self.rect.height()].map(|side| (side * self.pixels_per_point).round().max(1.0) as u32)
    }

    /// Where a point in space is on the screen; `None` behind the eye.
    pub fn to_screen(&self, point: DVec3) -> Option<Pos2> {
        let place = self.camera.as_ref()?.to_screen(point, self.size())?;
        Some(self.rect.min + Vec2::new(place.x as f32, place.y as f32))
    }

    /// The eye and the direction to what is seen at a place on the screen.
    pub fn ray(&self, place: Pos2) -> Option<(DVec3, DVec3)> {
        Some(self.camera.as_ref()?.ray(self.within(place), self.size()))
    }

    /// Turns by a drag of `delta` points.
    pub fn turn(&mut self, delta: Vec2) {
        if let Some(camera) = &mut self.camera {
            camera.orbit(wide(delta));
        }
    }

    /// Lets a turn go on by itself, at `speed` points per second; zero stops it.
    pub fn let_spin(&mut self, speed: Vec2) {
        self.spin = if speed.is_finite() && speed.length() >= STANDS_BELOW { speed } else { Vec2::ZERO };
    }

    /// Goes on with the turn for `seconds`; whether it still does.
    pub fn spin(&mut self, seconds: f32) -> bool {
        if self.spin == Vec2::ZERO {
            return false;
        }
        self.turn(self.spin * seconds);
        self.let_spin(self.spin * (-seconds / INERTIA_SECONDS).exp());
        true
    }

    /// Moves the picture by `delta` points.
    pub fn pan(&mut self, delta: Vec2) {
        let size = self.size();
        if let Some(camera) = self.camera.as_mut().filter(|_| delta != Vec2::ZERO) {
            camera.pan(wide(delta), size);
            self.is_fitted = false;
        }
    }

    /// Comes nearer by `factor`; what is at `place` stays there.
    pub fn zoom(&mut self, factor: f32, place: Pos2) {
        let (about, size) = (self.within(place), self.size());
        let sound = factor != 1.0 && factor.is_finite() && factor > 0.0;
        if let Some(camera) = self.camera.as_mut().filter(|_| sound) {
            camera.zoom(f64::from(factor), about, size);
            self.is_fitted = false;
        }
    }

    fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.rect.width()), f64::from(self.rect.height()))
    }

    fn within(&self, place: Pos2) -> DVec2 {
        wide(place - self.rect.min)
    }
}

fn wide(delta: Vec2) -> DVec2 {
    DVec2::new(f64::from(delta.x), f64::from(delta.y))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use egui::{pos2, vec2};

    const SCENE: BoundingSphere = BoundingSphere { center: DVec3::new(1.0, 2.0, 3.0), radius: 2.0 };

    fn view() -> OrbitView {
        let mut view = OrbitView::default();
        view.place(Rect::from_min_size(pos2(700.0, 50.0), vec2(600.0, 500.0)), 2.0, Margins::NONE, SCENE);
        view.look(OrbitCamera::new(SCENE, DVec3::new(0.0, -1.0, 0.5), DVec3::Z, view.aspect()));
        view
    }

    #[test]
    fn a_fitted_surface_lies_between_the_margins() {
        let margins = Margins { sides: 20.0, top: 73.0, bottom: 91.0 };
        for size in [vec2(600.0, 500.0), vec2(360.0, 330.0), vec2(200.0, 500.0)] {
            let mut view = view();
            view.place(Rect::from_min_size(pos2(700.0, 50.0), size), 2.0, margins, SCENE);
            let free = margins.within(view.rect);
            let rim = |k: i32| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 64.0).sin_cos();
                let camera = view.camera().unwrap();
                view.to_screen(SCENE.center + SCENE.radius * (camera.rotation * DVec3::new(cos, sin, 0.0))).unwrap()
            };
            let seen = Rect::from_points(&(0..64).map(rim).collect::<Vec<_>>());
            assert!(free.expand(0.5).contains_rect(seen), "{seen} in {free}");
            assert!(seen.size().min_elem() > 0.9 * free.size().min_elem(), "{seen} fills {free}");
        }
    }

    #[test]
    fn the_surfaces_middle_is_in_the_middle_and_a_ray_there_hits_it() {
        let view = view();
        let middle = view.to_screen(SCENE.center).unwrap();
        assert!(middle.distance(view.rect.center()) < 1e-3, "{middle}");
        let (eye, direction) = view.ray(middle).unwrap();
        assert!((SCENE.center - eye).normalize().dot(direction) > 1.0 - 1e-9);
        assert_eq!(view.size_px(), [1200, 1000]);
    }

    #[test]
    fn what_was_zoomed_or_moved_stays_so_until_it_is_fitted() {
        let mut view = view();
        view.zoom(2.0, pos2(900.0, 200.0));
        let moved = *view.camera().unwrap();
        view.place(view.rect, 2.0, Margins::NONE, SCENE);
        assert!(!view.is_fitted() && *view.camera().unwrap() == moved);
        view.fit();
        view.place(view.rect, 2.0, Margins::NONE, SCENE);
        assert_eq!(view.camera().unwrap().target, SCENE.center);
    }

    #[test]
    fn a_turn_goes_on_and_comes_to_rest() {
        let mut view = view();
        let before = *view.camera().unwrap();
        view.let_spin(vec2(400.0, 0.0));
        let steps = (0..200).take_while(|_| view.spin(0.016)).count();
        assert!((10..100).contains(&steps), "{steps} frames");
        assert!(*view.camera().unwrap() != before && !view.spin(0.016));
    }
}

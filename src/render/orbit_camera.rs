//! The camera for surfaces: perspective, orbiting a target like a virtual trackball.
//!
//! Rotations are about the axes of the screen, not of the world: there is no pole at which the view jumps, and no
//! fixed up direction. Screen positions are pixels (or points: any unit, as long as sizes have the same) from the
//! viewport's upper left corner, y down. `to_screen` after `ray` is the identity up to rounding.

use glam::{DMat4, DQuat, DVec2, DVec3, DVec4};

/// A sphere around a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundingSphere {
    /// The middle of the bounding box.
    pub center: DVec3,
    /// The radius, positive.
    pub radius: f64,
}

impl BoundingSphere {
    /// The sphere around the middle of the points' bounding box; around the origin if there are none. Cost O(n).
    pub fn of(points: &[DVec3]) -> Self {
        let (low, high) =
            points.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
        let middle = low.midpoint(high);
        let center = if middle.is_finite() { middle } else { DVec3::ZERO };
        let radius = points.iter().map(|p| p.distance_squared(center)).fold(0.0, f64::max).sqrt();
        Self { center, radius: if radius > 0.0 && radius.is_finite() { radius } else { 1.0 } }
    }
}

/// A camera that looks at a target point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitCamera {
    /// The point in the middle of the viewport.
    pub target: DVec3,
    /// The distance from the eye to the target, positive.
    pub distance: f64,
    /// The rotation from the eye's axes (x right, y up, z towards the eye) to the world's.
    pub rotation: DQuat,
    /// The vertical field of view, in radians.
    pub field_of_view: f64,
    /// The sphere that must lie between the near and the far plane.
    scene: BoundingSphere,
}

/// Narrow enough not to distort shapes, wide enough to make depth visible.
const FIELD_OF_VIEW: f64 = 28.0 * std::f64::consts::PI / 180.0;

/// Radians per point: half a turn takes about 400 points.
const TURN_PER_POINT: f64 = 0.008;

/// The bounds of the distance, in radii of the scene.
const NEAREST: f64 = 0.02;
const FARTHEST: f64 = 50.0;

/// The near plane of an eye inside the scene, as a part of its distance to the target.
const NEAR_WITHIN: f64 = 0.05;

/// If the mean normal's y component exceeds this in magnitude, the front faces y, and z is taken as up.
const UPRIGHT: f64 = 0.85;

/// The tangents of the angles of the default view from the front's normal: 24° to the right, 16° up.
const ASIDE: f64 = 0.45;
const ABOVE: f64 = 0.28;

impl OrbitCamera {
    /// Looks at the scene from the direction `towards_eye`, with `up` as far up as possible.
    ///
    /// Directions that are zero or parallel are replaced by others.
    pub fn new(scene: BoundingSphere, towards_eye: DVec3, up: DVec3, aspect: f64) -> Self {
        let back = towards_eye.try_normalize().unwrap_or(DVec3::Z);
        let right = up.cross(back).try_normalize().unwrap_or_else(|| back.any_orthonormal_vector());
        let rotation = DQuat::from_mat3(&glam::DMat3::from_cols(right, back.cross(right), back)).normalize();
        let mut camera = Self { target: scene.center, distance: 1.0, rotation, field_of_view: FIELD_OF_VIEW, scene };
        camera.fit(scene, aspect);
        camera
    }

    /// The default view of a surface: at its front, from a little to the right and above, with y up,
    /// or z up if the front faces y. The front's direction is the mean normal, weighted by area: away from the loop.
    pub fn before(positions: &[DVec3], triangles: &[[u32; 3]], aspect: f64) -> Self {
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            (b - a).cross(c - a)
        };
        let sum = triangles.iter().map(area).sum::<DVec3>();
        // scaled first to a length whose square neither overflows nor underflows
        let front = (sum / sum.abs().max_element()).try_normalize().unwrap_or(DVec3::Z);
        let up = if front.y.abs() < UPRIGHT { DVec3::Y } else { DVec3::Z };
        let right = up.cross(front).normalize_or_zero();
        let towards_eye = front + ASIDE * right + ABOVE * front.cross(right);
        Self::new(BoundingSphere::of(positions), towards_eye, up, aspect)
    }

    /// Shows all of `scene`, from the same side, in a viewport of this width over height.
    pub fn fit(&mut self, scene: BoundingSphere, aspect: f64) {
        let half = 0.5 * self.field_of_view;
        // the narrower of the two half angles touches the sphere
        let narrow = if aspect < 1.0 { (half.tan() * aspect).atan() } else { half };
        self.scene = scene;
        self.target = scene.center;
        self.distance = scene.radius / narrow.sin();
    }

    /// Translates the camera, keeping its direction, so that `points` are centered in the viewport and just fit inside
    /// its margin, which is a part of its smaller side. Cost O(n).
    pub fn frame(&mut self, points: &[DVec3], aspect: f64, margin: f64) {
        let half = (0.5 * self.field_of_view).tan();
        let room = DVec2::new(half * aspect, half) - margin * half * aspect.min(1.0) * 2.0;
        let inverse = self.rotation.inverse();
        // the planes through the viewport's sides that touch the points, each by the offset of its apex
        let sides = |point: DVec3| {
            let seen = inverse * (point - self.target);
            let flat = seen.truncate();
            [flat + seen.z * room, -flat + seen.z * room]
        };
        let start = [DVec2::NEG_INFINITY; 2];
        let [high, low] = points.iter().map(|&p| sides(p)).fold(start, |[a, b], [c, d]| [a.max(c), b.max(d)]);
        let distance = (0.5 * (high + low) / room).max_element();
        let shift = 0.5 * (high - low);
        if distance.is_finite() && shift.is_finite() && distance > 0.0 && room.min_element() > 0.0 {
            self.target += self.rotation * shift.extend(0.0);
            self.distance = distance;
        }
    }

    /// Rotates the view as if a ball were rolled under the pointer, which moved by `delta` points.
    pub fn orbit(&mut self, delta: DVec2) {
        let angle = TURN_PER_POINT * delta.length();
        let axis = DVec3::new(-delta.y, -delta.x, 0.0).try_normalize();
        if let Some(axis) = axis {
            self.rotation = (self.rotation * DQuat::from_axis_angle(axis, angle)).normalize();
        }
    }

    /// Moves the picture by `delta`: the target's plane follows the pointer.
    pub fn pan(&mut self, delta: DVec2, size: DVec2) {
        let step = self.units_per_pixel(size) * DVec3::new(-delta.x, delta.y, 0.0);
        self.target += self.rotation * step;
    }

    /// Moves nearer by `factor` (farther below 1), keeping the point of the target's plane at `about` fixed.
    pub fn zoom(&mut self, factor: f64, about: DVec2, size: DVec2) {
        let distance = (self.distance / factor).clamp(NEAREST * self.scene.radius, FARTHEST * self.scene.radius);
        if !distance.is_finite() {
            return;
        }
        let from_middle = (about - 0.5 * size) * DVec2::new(1.0, -1.0) * self.units_per_pixel(size);
        let fixed = self.target + self.rotation * from_middle.extend(0.0);
        self.target = fixed + (self.target - fixed) * (distance / self.distance);
        self.distance = distance;
    }

    /// The position of the eye.
    pub fn eye(&self) -> DVec3 {
        self.target + self.distance * self.backward()
    }

    /// The direction from the target to the eye, of unit length.
    pub fn backward(&self) -> DVec3 {
        self.rotation * DVec3::Z
    }

    /// The world length of a pixel in the target's plane.
    pub fn units_per_pixel(&self, size: DVec2) -> f64 {
        2.0 * self.distance * (0.5 * self.field_of_view).tan() / size.y
    }

    /// The length of a pixel at distance 1 from the eye, in any unit of length.
    pub(super) fn units_per_pixel_at_one(&self, size_px: [u32; 2]) -> f64 {
        2.0 * (0.5 * self.field_of_view).tan() / f64::from(size_px[1])
    }

    /// World → clip coordinates: depth from 0 (near) to 1 (far), with the scene between them.
    pub fn view_projection(&self, aspect: f64) -> DMat4 {
        let (near, far) = self.depths();
        let view = DMat4::from_rotation_translation(self.rotation, self.eye()).inverse();
        let height = 1.0 / (0.5 * self.field_of_view).tan();
        let depth = far / (near - far);
        let projection = DMat4::from_cols(
            DVec4::new(height / aspect, 0.0, 0.0, 0.0),
            DVec4::new(0.0, height, 0.0, 0.0),
            DVec4::new(0.0, 0.0, depth, -1.0),
            DVec4::new(0.0, 0.0, near * depth, 0.0),
        );
        projection * view
    }

    /// The distances of the near and the far plane.
    pub(super) fn depths(&self) -> (f64, f64) {
        let depth = (self.eye() - self.scene.center).dot(self.backward());
        // slightly more than the sphere, so that points on it are drawn
        let radius = 1.01 * self.scene.radius;
        let near = (depth - radius).max(NEAR_WITHIN * self.distance);
        (near, (depth + radius).max(2.0 * near))
    }

    /// The screen position of `p` in a viewport of `size`; `None` at or behind the eye.
    pub fn to_screen(&self, p: DVec3, size: DVec2) -> Option<DVec2> {
        let seen = self.rotation.inverse() * (p - self.eye());
        if seen.z >= 0.0 {
            return None;
        }
        let pixels = 0.5 * size.y / ((0.5 * self.field_of_view).tan() * -seen.z);
        Some(0.5 * size + pixels * DVec2::new(seen.x, -seen.y))
    }

    /// The eye, and the unit direction towards position `place` of a viewport of `size`.
    pub fn ray(&self, place: DVec2, size: DVec2) -> (DVec3, DVec3) {
        let across = (place - 0.5 * size) * DVec2::new(1.0, -1.0) * self.units_per_pixel(size);
        (self.eye(), (self.rotation * across.extend(-self.distance)).normalize())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    const SIZE: DVec2 = DVec2::new(640.0, 480.0);
    const SCENE: BoundingSphere = BoundingSphere { center: DVec3::new(10.0, -3.0, 2.0), radius: 2.5 };

    fn camera() -> OrbitCamera {
        OrbitCamera::new(SCENE, DVec3::new(1.0, -2.0, 0.7), DVec3::Z, SIZE.x / SIZE.y)
    }

    #[test]
    fn the_sphere_of_points_is_around_the_middle_of_their_box() {
        let sphere = BoundingSphere::of(&[DVec3::ZERO, DVec3::new(4.0, 0.0, 0.0), DVec3::new(2.0, 3.0, 0.0)]);
        assert_eq!(sphere, BoundingSphere { center: DVec3::new(2.0, 1.5, 0.0), radius: 2.5 });
        assert_eq!(BoundingSphere::of(&[]).radius, 1.0);
    }

    #[test]
    fn up_is_up_and_the_target_in_the_middle() {
        let camera = camera();
        let middle = camera.to_screen(SCENE.center, SIZE).unwrap();
        assert!(middle.distance(0.5 * SIZE) < 1e-9);
        let above = camera.to_screen(SCENE.center + DVec3::Z, SIZE).unwrap();
        assert!((above.x - middle.x).abs() < 1e-9 && above.y < middle.y, "{above}");
        assert_eq!(camera.to_screen(camera.eye() + camera.backward(), SIZE), None);
        // looking along `up` is valid too
        let along = OrbitCamera::new(SCENE, DVec3::Z, DVec3::Z, 1.0);
        assert!(along.rotation.is_normalized() && (along.backward() - DVec3::Z).length() < 1e-15);
    }

    #[test]
    fn an_unknown_surface_is_seen_from_its_front_with_y_up() {
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(DVec3::from_array);
        let front = OrbitCamera::before(&triangle, &[[0, 1, 2]], 1.0);
        assert!(front.backward().z > 0.8 && front.backward().y > 0.0, "{}", front.backward());
        assert!((front.rotation * DVec3::Y).y > 0.8);
        let back = OrbitCamera::before(&triangle, &[[0, 2, 1]], 1.0);
        assert!(back.backward().z < -0.8 && back.backward().y > 0.0, "{}", back.backward());
        assert!(OrbitCamera::before(&[], &[], 1.0).rotation.is_normalized());
    }

    #[test]
    fn what_is_on_a_ray_is_seen_at_its_pixel() {
        let mut camera = camera();
        camera.orbit(DVec2::new(130.0, -77.0));
        camera.pan(DVec2::new(31.0, 12.0), SIZE);
        camera.zoom(1.7, DVec2::new(100.0, 400.0), SIZE);
        for place in [DVec2::ZERO, DVec2::new(320.0, 240.0), DVec2::new(600.5, 17.25), SIZE] {
            let (origin, direction) = camera.ray(place, SIZE);
            for distance in [0.1, 3.0, 1e4] {
                let back = camera.to_screen(origin + distance * direction, SIZE).unwrap();
                assert!(back.distance(place) < 1e-7, "{place} came back as {back}");
            }
        }
    }

    #[test]
    fn the_matrix_and_the_screen_agree_and_depth_is_from_0_to_1() {
        let mut camera = camera();
        camera.orbit(DVec2::new(-240.0, 90.0));
        let matrix = camera.view_projection(SIZE.x / SIZE.y);
        let mut previous = None;
        for step in 0..=20 {
            let p = SCENE.center + SCENE.radius * (1.0 - 0.1 * f64::from(step)) * camera.backward();
            let clip = matrix * p.extend(1.0);
            let ndc = clip.truncate() / clip.w;
            let pixel = (0.5 + 0.5 * DVec2::new(ndc.x, -ndc.y)) * SIZE;
            assert!(pixel.distance(camera.to_screen(p, SIZE).unwrap()) < 1e-8);
            assert!((0.0..=1.0).contains(&ndc.z) && previous.is_none_or(|nearer| nearer < ndc.z), "{}", ndc.z);
            previous = Some(ndc.z);
        }
    }

    #[test]
    fn fit_shows_the_whole_sphere_and_no_more_than_needed() {
        for aspect in [0.4, 1.0, 1.9] {
            let size = DVec2::new(500.0 * aspect, 500.0);
            let mut camera = camera();
            camera.orbit(DVec2::new(50.0, 20.0));
            camera.fit(SCENE, aspect);
            let mut nearest_edge = f64::INFINITY;
            for k in 0..4000 {
                // Fibonacci's points of the sphere
                let (z, turn) = (1.0 - (f64::from(k) + 0.5) / 2000.0, 2.399_963 * f64::from(k));
                let flat = (1.0 - z * z).sqrt();
                let p = SCENE.center + SCENE.radius * DVec3::new(flat * turn.cos(), flat * turn.sin(), z);
                let at = camera.to_screen(p, size).unwrap();
                nearest_edge = nearest_edge.min(at.min_element()).min((size - at).min_element());
            }
            // 4000 points leave caps of 0.03 of the radius
            assert!((-1e-9..2.0).contains(&nearest_edge), "aspect {aspect}: {nearest_edge}");
        }
    }

    #[test]
    fn framed_points_touch_the_margin_and_are_in_the_middle() {
        let points: Vec<_> =
            (0..50).map(|k| SCENE.center + DVec3::new(f64::from(k).sin(), 0.3, f64::from(k).cos())).collect();
        for aspect in [0.5, 1.6] {
            let size = DVec2::new(400.0 * aspect, 400.0);
            let mut camera = camera();
            camera.frame(&points, aspect, 0.1);
            let seen: Vec<_> = points.iter().map(|&p| camera.to_screen(p, size).unwrap()).collect();
            let (low, high) =
                seen.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
            let margin = 0.1 * size.min_element();
            let [free_low, free_high] = [low - margin, size - margin - high];
            assert!(free_low.min_element() > -1e-9 && free_high.min_element() > -1e-9, "{low} {high}");
            // one side of each pair would touch, were it not for the other direction
            let touches = free_low.min(free_high).min_element();
            assert!(touches < 1e-9, "{low} {high} in {size}");
        }
        let mut camera = camera();
        let before = camera;
        camera.frame(&[], 1.0, 0.1);
        assert_eq!(camera, before);
    }

    #[test]
    fn panning_and_zooming_keep_what_is_under_the_pointer() {
        let mut camera = camera();
        let place = DVec2::new(150.0, 90.0);
        let (origin, direction) = camera.ray(place, SIZE);
        // in the target's plane
        let held = origin + direction * (camera.distance / -direction.dot(camera.backward()));
        camera.pan(DVec2::new(40.0, -25.0), SIZE);
        let moved = camera.to_screen(held, SIZE).unwrap();
        assert!(moved.distance(place + DVec2::new(40.0, -25.0)) < 1e-9, "{moved}");
        camera.zoom(2.5, moved, SIZE);
        assert!(camera.to_screen(held, SIZE).unwrap().distance(moved) < 1e-9);
        let before = camera;
        camera.zoom(f64::NAN, moved, SIZE);
        assert_eq!(camera, before);
    }

    #[test]
    fn a_turn_keeps_distance_and_target_and_is_undone_by_its_opposite() {
        let mut camera = camera();
        let before = camera;
        let front = SCENE.center + camera.backward();
        camera.orbit(DVec2::new(30.0, 0.0));
        let at = camera.to_screen(front, SIZE).unwrap();
        assert!(at.x > 0.5 * SIZE.x && (at.y - 0.5 * SIZE.y).abs() < 1e-9, "the front follows the pointer: {at}");
        camera.orbit(DVec2::new(-30.0, 0.0));
        assert!(camera.eye().distance(before.eye()) < 1e-12);
        for _ in 0..1000 {
            camera.orbit(DVec2::new(7.0, 11.0));
        }
        assert!((camera.eye().distance(camera.target) - before.distance).abs() < 1e-9);
    }
}

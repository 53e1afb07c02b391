//! The map at the point under the pointer: image, scale and turning.
//!
//! With the boundary integral on both sides they are those of Cauchy's integral ([`SlicedInterior`]), which is prepared
//! in slices once per map and side, when it is first asked for. Else, and until then, they are those of the triangle
//! that holds the point: the image is linear on it, the derivative is the part of the linear map that keeps angles.

use crate::conformal::{ConformalMap, PerSide, Side, SlicedInterior};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use crate::model::Model;

/// The time per frame for the preparation, in ms.
const SLICE_MS: f64 = 4.0;

/// Cauchy's integrals of the map that is shown.
#[derive(Debug, Default)]
pub struct Pointer {
    /// The [`crate::model::shown::ShownMap::map_generation`] that they belong to.
    generation: u64,
    interiors: PerSide<Option<SlicedInterior>>,
}

/// The map at a point of a side: f at one of the source, f⁻¹ at one of the target.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct PointedImage {
    /// The side of the point.
    pub side: Side,
    /// The point.
    pub point: DVec2,
    /// Its image on the other side.
    pub image: DVec2,
    /// The derivative, as re + i im.
    pub derivative: DVec2,
    /// Estimates of the errors; `None` for values of the mesh.
    pub errors: Option<PointedErrors>,
}

/// Estimates of the errors at a point.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct PointedErrors {
    /// Of the image.
    pub image: f64,
    /// Of the derivative: at most that of the image over the distance from the boundary, by Cauchy's estimate.
    pub derivative: f64,
}

impl PointedImage {
    /// |f′|.
    pub fn scale(&self) -> f64 {
        self.derivative.length()
    }

    /// arg f′ in degrees, in (−180, 180].
    pub fn turning(&self) -> f64 {
        self.derivative.y.atan2(self.derivative.x).to_degrees()
    }
}

impl Model {
    /// Prepares the map from a side for [`Self::pointed`], for at most one slice of a frame; returns whether that is
    /// complete, or not possible.
    pub fn prepare_pointer(&mut self, side: Side) -> bool {
        let is_pending = self.is_pending();
        let shown = &mut self.shown;
        let Some(map) = shown.map.as_ref().filter(|_| !is_pending) else { return true };
        if shown.pointer.generation != shown.map_generation {
            shown.pointer = Pointer { generation: shown.map_generation, ..Pointer::default() };
        }
        let slot = &mut shown.pointer.interiors[side];
        if slot.is_none() {
            *slot = map.begin_interior(side);
        }
        slot.as_mut().is_none_or(|interior| interior.advance(map, Deadline::in_ms(SLICE_MS)))
    }

    /// The map at a point of a side; `None` outside, and where a side is a surface.
    pub fn pointed(&self, side: Side, point: DVec2) -> Option<PointedImage> {
        self.pointed_by_integral(side, point).or_else(|| self.pointed_in_mesh(side, point))
    }

    fn pointed_by_integral(&self, side: Side, point: DVec2) -> Option<PointedImage> {
        let is_current = self.shown.pointer.generation == self.shown.map_generation && !self.is_draft();
        let interior = self.shown.pointer.interiors[side].as_ref().filter(|_| is_current)?;
        let exact = interior.evaluate(point)?;
        let samples = self.shown.map.as_ref().and_then(|map: &ConformalMap| map.domain(side))?.samples();
        let away = samples.position(samples.nearest(point)).distance(point);
        let slope = exact.error / away + f64::EPSILON * exact.derivative.length();
        let errors = Some(PointedErrors { image: exact.error, derivative: slope });
        Some(PointedImage { side, point, image: exact.value, derivative: exact.derivative, errors })
    }

    /// By the first triangle of the mapped mesh that holds the point. O(triangles).
    pub(super) fn pointed_in_mesh(&self, side: Side, point: DVec2) -> Option<PointedImage> {
        let (image, derivative) = self.carrying_triangles(side)?.find_map(|triangle| triangle.carry(point))?;
        Some(PointedImage { side, point, image, derivative, errors: None })
    }

    /// The images of points that lie together, by the first triangle that holds each; `None` outside of the mesh.
    /// O(triangles + points · triangles at these points).
    pub(super) fn images_in_mesh(&self, side: Side, points: &[DVec2]) -> Vec<Option<DVec2>> {
        let mut images = vec![None; points.len()];
        let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let near = |triangle: &CarryingTriangle| triangle.overlaps(low, high);
        for triangle in self.carrying_triangles(side).into_iter().flatten().filter(near) {
            for (image, &point) in images.iter_mut().zip(points).filter(|(image, _)| image.is_none()) {
                *image = triangle.carry(point).map(|(image, _)| image);
            }
        }
        images
    }

    fn carrying_triangles(&self, side: Side) -> Option<impl Iterator<Item = CarryingTriangle>> {
        let shown = self.shown()?;
        let (from, onto) = (shown.places(side)?, shown.places(side.other())?);
        let of = |corners: &[u32; 3]| CarryingTriangle {
            from: corners.map(|v| from[v as usize]),
            onto: corners.map(|v| onto[v as usize]),
        };
        Some(shown.triangles.iter().map(of))
    }
}

/// A triangle and its image.
struct CarryingTriangle {
    from: [DVec2; 3],
    onto: [DVec2; 3],
}

impl CarryingTriangle {
    /// Whether its box meets that from `low` to `high`.
    fn overlaps(&self, low: DVec2, high: DVec2) -> bool {
        let [a, b, c] = self.from;
        a.min(b).min(c).cmple(high).all() && a.max(b).max(c).cmpge(low).all()
    }

    /// The image of a point and the part of the linear map that keeps angles; `None` outside.
    fn carry(&self, point: DVec2) -> Option<(DVec2, DVec2)> {
        let [a, b, c] = self.from;
        let (u, v) = (b - a, c - a);
        let area = u.perp_dot(v);
        let (s, t) = ((point - a).perp_dot(v) / area, u.perp_dot(point - a) / area);
        if !(area > 0.0 && s >= 0.0 && t >= 0.0 && s + t <= 1.0) {
            return None;
        }
        let [p, q, r] = self.onto;
        let (along, across) = (q - p, r - p);
        // ∂f/∂x and ∂f/∂y
        let (x, y) = ((v.y * along - u.y * across) / area, (u.x * across - v.x * along) / area);
        Some((p + s * along + t * across, 0.5 * DVec2::new(x.x + y.y, x.y - y.x)))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::KernelMode;
    use crate::model::scene::Offscreen;
    use crate::outline::Preset;
    use crate::session::{Command, OutlineSpec, Session};
    use web_time::Instant;

    fn session([source, target]: [Preset; 2], kernel: KernelMode) -> Session {
        let mut session = Session::with([
            Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(source) },
            Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(target) },
        ]);
        for side in Side::BOTH {
            let settings = session.domain(side).settings.with_kernel(kernel);
            session.apply(Command::SetSettings { side, settings });
        }
        session
    }

    fn model(session: &Session) -> Model {
        Offscreen::new(session, PerSide::default(), 1.0).unwrap().into_model()
    }

    #[test]
    fn from_disk_to_disk_it_is_the_moebius_map_to_ten_digits_and_the_mesh_has_two() {
        let a = DVec2::new(0.4, -0.3);
        let mut session = session([Preset::Disk; 2], KernelMode::Integral);
        session.apply(Command::MoveInterior { side: Side::Source, point: a.into() });
        session.apply(Command::MoveInterior { side: Side::Target, point: DVec2::ZERO.into() });
        let mut model = model(&session);
        let z = DVec2::new(-0.2, 0.55);
        let size = |z: DVec2| {
            let (below, above) = (DVec2::new(1.0 - a.dot(z), a.y * z.x - a.x * z.y).length(), (z - a).length());
            (above / below, (1.0 - a.length_squared()) / (below * below))
        };
        let rough = model.pointed(Side::Source, z).unwrap();
        assert!(rough.errors.is_none() && (rough.scale() / size(z).1 - 1.0).abs() < 0.1, "{rough:?}");
        while !model.prepare_pointer(Side::Source) {}
        while !model.prepare_pointer(Side::Target) {}
        let exact = model.pointed(Side::Source, z).unwrap();
        assert!((exact.image.length() - size(z).0).abs() < 1e-10, "{exact:?}");
        assert!((exact.scale() - size(z).1).abs() < 1e-10, "{exact:?}");
        assert!(exact.errors.unwrap().image < 1e-9 && exact.image.distance(rough.image) < 0.02);
        let back = model.pointed(Side::Target, exact.image).unwrap();
        assert!(back.image.distance(z) < 1e-10 && (back.scale() * exact.scale() - 1.0).abs() < 1e-9, "{back:?}");
        assert!((back.turning() + exact.turning()).abs() < 1e-7);
        assert_eq!(model.pointed(Side::Source, DVec2::new(2.0, 0.0)), None);
    }

    #[test]
    fn finite_elements_are_interpolated_in_the_mesh() {
        let mut model = model(&session([Preset::Disk, Preset::Blob], KernelMode::Adjoint));
        assert!(model.prepare_pointer(Side::Source));
        let x = model.interior(Side::Source).unwrap();
        let there = model.pointed(Side::Source, x).unwrap();
        assert!(there.errors.is_none() && there.image.distance(model.interior(Side::Target).unwrap()) < 0.02);
        let back = model.pointed(Side::Target, there.image).unwrap();
        assert!(back.image.distance(x) < 1e-9, "{back:?}");
    }

    #[test]
    #[ignore = "prints times, 55 to 420 ms; V-shape and blob take longest"]
    fn the_preparation_takes_milliseconds() {
        for presets in [
            [Preset::Disk, Preset::Blob],
            [Preset::VShape, Preset::Blob],
            [Preset::MapleLeaf, Preset::Hand],
            [Preset::Gingerbread, Preset::Heart],
        ] {
            let mut model = model(&session(presets, KernelMode::Integral));
            for side in Side::BOTH {
                let (start, mut slices) = (Instant::now(), 1);
                while !model.prepare_pointer(side) {
                    slices += 1;
                }
                let prepared = start.elapsed().as_secs_f64() * 1e3;
                let (x, start) = (model.interior(side).unwrap() + DVec2::new(1e-3, 0.0), Instant::now());
                let pointed = model.pointed(side, x).unwrap();
                let once = start.elapsed().as_secs_f64() * 1e3;
                println!(
                    "{presets:?} from {side}: {prepared:.1} ms in {slices} slices, then {once:.3} ms; {pointed:?}"
                );
            }
        }
    }
}

//! A small circle with a cross about a point of the source, and its image.
//!
//! f(p + r e^{iφ}) = f(p) + r f′(p) e^{iφ} + O(r²): the images of the diameters cross at a right angle, and the image of
//! the circle is a circle up to a part that vanishes with its radius r. All that is drawn are images of points of the
//! circle and the cross themselves, by Cauchy's integral where that is prepared, else by the mapped mesh's triangles.

use super::pointer::PointedImage;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::Model;
use std::f64::consts::TAU;

/// The radius as a share of the larger extent of the source: a circle that is clearly one, and still small.
const RADIUS: f64 = 0.05;
/// The largest radius as a share of the distance from the boundary: by Koebe's distortion theorem the image's radii may
/// differ by the factor ((1 + s)/(1 − s))², at this share 2.8, at 0.6 already 16.
const MOST_OF_DISTANCE: f64 = 0.25;
/// The points of the circle, and of each diameter.
const RING: usize = 96;
const ARM: usize = 17;
/// The sides of the mark of the right angle, as a share of the radius.
const CORNER: f64 = 0.28;
/// The distance of a new probe from x₁, as a share of the larger extent: the dot does not cover it.
const BESIDE: f64 = 0.2;
/// The directions in which a place for a new probe is looked for.
const DIRECTIONS: usize = 16;

/// A circle in the source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probe {
    /// The center.
    pub center: DVec2,
    /// The radius.
    pub radius: f64,
}

/// The image of a [`Probe`].
#[derive(Debug, Clone, PartialEq)]
pub struct ProbeImage {
    /// The circle that it is the image of.
    pub probe: Probe,
    /// The [`Model::generation`] of the map.
    generation: u64,
    /// Whether Cauchy's integral was asked for.
    is_exact: bool,
    /// The map at the center.
    pub center: PointedImage,
    /// The images of points of the circle, in order.
    pub ring: Vec<DVec2>,
    /// The images of points of the horizontal and of the vertical diameter, from the left and from below.
    pub arms: [Vec<DVec2>; 2],
    /// The images of the mark of the right angle between both.
    pub corner: Vec<DVec2>,
}

impl Probe {
    /// Points of the circle, counter-clockwise from the right.
    pub fn ring(self) -> impl Iterator<Item = DVec2> {
        let at = move |k: usize| self.center + self.radius * DVec2::from_angle(TAU * k as f64 / RING as f64);
        (0..RING).map(at)
    }

    /// Points of the diameter along a unit vector.
    pub fn arm(self, direction: DVec2) -> impl Iterator<Item = DVec2> {
        let at = move |k: usize| self.center + self.radius * (2.0 * k as f64 / (ARM - 1) as f64 - 1.0) * direction;
        (0..ARM).map(at)
    }

    /// The mark of the right angle: its ends lie on the two radii to the right and upwards.
    pub fn corner(self) -> [DVec2; 3] {
        [DVec2::X, DVec2::ONE, DVec2::Y].map(|at| self.center + CORNER * self.radius * at)
    }
}

impl Model {
    /// The circle about a point of the source, or about the nearest one inside; smaller next to the boundary. `None` on
    /// a surface.
    pub fn probe_at(&self, center: DVec2) -> Option<Probe> {
        let domain = self.domain(Side::Source)?;
        let samples = domain.samples();
        let center = self.interior_near(Side::Source, center)?;
        let away = samples.position(samples.nearest(center)).distance(center);
        let radius = (RADIUS * self.source_size()?).min(MOST_OF_DISTANCE * away);
        Some(Probe { center, radius })
    }

    /// A circle beside x₁: of those in some directions the one that is farthest from the boundary.
    pub fn new_probe(&self) -> Option<Probe> {
        let (x, distance) = (self.interior(Side::Source)?, BESIDE * self.source_size()?);
        let samples = self.domain(Side::Source)?.samples();
        let at = |k: usize| x + distance * DVec2::from_angle(TAU * (k as f64 + 0.5) / DIRECTIONS as f64);
        let away = |point: DVec2| samples.position(samples.nearest(point)).distance(point);
        let inside = (0..DIRECTIONS).map(at).filter(|&point| self.pointed(Side::Source, point).is_some());
        self.probe_at(inside.max_by(|&a, &b| away(a).total_cmp(&away(b))).unwrap_or(x))
    }

    /// Whether this is the image of the circle under the map on the screen; with `is_exact`, the one by Cauchy's
    /// integral where that is possible.
    pub fn is_probe_current(&self, image: &ProbeImage, probe: Probe, is_exact: bool) -> bool {
        image.probe == probe && image.generation == self.generation() && (image.is_exact || !is_exact)
    }

    /// The image of the circle, by Cauchy's integral if it `is_exact` and possible; points that the mapped mesh does not
    /// hold are left out. `None` if the center is one.
    pub fn probe_image(&self, probe: Probe, is_exact: bool) -> Option<ProbeImage> {
        let pointed = |point| {
            if is_exact { self.pointed(Side::Source, point) } else { self.pointed_in_mesh(Side::Source, point) }
        };
        let center = pointed(probe.center)?;
        let images = |points: &mut dyn Iterator<Item = DVec2>| {
            let points: Vec<DVec2> = points.collect();
            let images = match center.errors {
                Some(_) => points.iter().map(|&point| Some(pointed(point)?.image)).collect(),
                None => self.images_in_mesh(Side::Source, &points),
            };
            images.into_iter().flatten().collect()
        };
        let ring = images(&mut probe.ring());
        let arms = [DVec2::X, DVec2::Y].map(|direction| images(&mut probe.arm(direction)));
        let corner = images(&mut probe.corner().into_iter());
        Some(ProbeImage { probe, generation: self.generation(), is_exact, center, ring, arms, corner })
    }

    fn source_size(&self) -> Option<f64> {
        let (low, high) = self.extent(Side::Source)?;
        Some((high - low).max_element())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{KernelMode, PerSide};
    use crate::model::scene::Offscreen;
    use crate::outline::Preset;
    use crate::session::{Command, OutlineSpec, Session};

    fn model(kernel: KernelMode) -> Model {
        let preset = |side| Command::SetOutline { side, outline: OutlineSpec::Preset(Preset::Disk) };
        let mut session = Session::with(Side::BOTH.map(preset));
        session.apply(Command::MoveInterior { side: Side::Source, point: DVec2::new(0.4, -0.3).into() });
        session.apply(Command::MoveInterior { side: Side::Target, point: DVec2::ZERO.into() });
        for side in Side::BOTH {
            let settings = session.domain(side).settings.with_kernel(kernel);
            session.apply(Command::SetSettings { side, settings });
        }
        Offscreen::new(&session, PerSide::default(), 1.0).unwrap().into_model()
    }

    /// The least and the largest distance of the circle's image from the center of the circle through three points of
    /// it.
    fn radii(image: &ProbeImage) -> [f64; 2] {
        let [a, b, c] = [0, RING / 3, 2 * RING / 3].map(|k| image.ring[k]);
        let (b, c) = (b - a, c - a);
        let center = a + (b.length_squared() * c - c.length_squared() * b).perp() / (-2.0 * b.perp_dot(c));
        let radii = image.ring.iter().map(|point| point.distance(center));
        radii.fold([f64::INFINITY, 0.0], |[least, most], radius| [least.min(radius), most.max(radius)])
    }

    #[test]
    fn a_moebius_map_keeps_circles_and_the_mesh_almost_does() {
        let mut model = model(KernelMode::Integral);
        let probe = model.probe_at(DVec2::new(-0.2, 0.5)).unwrap();
        let rough = model.probe_image(probe, false).unwrap();
        while !model.prepare_pointer(Side::Source) {}
        let exact = model.probe_image(probe, true).unwrap();
        assert_eq!((exact.ring.len(), rough.ring.len()), (RING, RING));
        let [least, most] = radii(&exact);
        assert!(most / least < 1.0 + 1e-9, "{least} … {most}");
        let [least, most] = radii(&rough);
        assert!(most / least < 1.1, "{least} … {most}");
        let size = exact.center.scale() * probe.radius;
        assert!((most / size - 1.0).abs() < 0.1, "{most}, but r |f'| is {size}");
    }

    #[test]
    fn the_diameters_cross_at_a_right_angle_at_the_image_of_the_center() {
        let mut model = model(KernelMode::Integral);
        let probe = model.new_probe().unwrap();
        while !model.prepare_pointer(Side::Source) {}
        let image = model.probe_image(probe, true).unwrap();
        let middle = ARM / 2;
        let [along, across] = [0, 1].map(|k| {
            assert!(image.arms[k][middle].distance(image.center.image) < 1e-12);
            image.arms[k][middle + 1] - image.arms[k][middle - 1]
        });
        // central differences: an error of (r/8)²
        assert!((along.angle_to(across).to_degrees() - 90.0).abs() < 0.05, "{along} {across}");
        assert!((along.to_angle().to_degrees() - image.center.turning()).abs() < 0.05);
    }

    #[test]
    fn next_to_the_boundary_the_circle_stays_inside_and_outside_it_is_drawn_back() {
        let model = model(KernelMode::Adjoint);
        for radius in [0.97, 0.999, 1.5] {
            let probe = model.probe_at(radius * DVec2::new(0.6, 0.8)).unwrap();
            assert!(probe.center.length() + probe.radius < 1.0 && probe.radius > 0.0, "{probe:?}");
        }
        let probe = model.new_probe().unwrap();
        let x = model.interior(Side::Source).unwrap();
        assert!(probe.center.distance(x) > 2.0 * probe.radius, "the dot does not cover it");
    }
}

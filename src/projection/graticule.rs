//! Meridians and parallels inside a region, and lattices of longitudes and latitudes, with their images.

use super::Projection;
use super::sphere::{lon_lat, on_sphere};
use crate::geometry::DVec2;
use crate::mesh::TriangleId;

/// Steps of a graticule in degrees: those of atlases.
const STEPS: [f64; 16] =
    [30.0, 15.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005];

/// The largest number of meridians around the whole sphere.
const MOST_MERIDIANS: f64 = 36.0;

/// About so many lines cross the region in each direction.
const LINES: f64 = 7.0;

/// Points of a line over the extent of the region.
const FINE: f64 = 250.0;

/// Bisections of the step in which a line crosses the boundary.
const BISECTIONS: u32 = 30;

/// Points of a lattice in a step of the graticule.
const LATTICE: f64 = 10.0;

/// The graticule of a region.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Graticule {
    /// The steps of longitude and latitude in degrees.
    pub steps: DVec2,
    /// The images of the parts of meridians inside of the region.
    pub meridians: Vec<Vec<DVec2>>,
    /// The images of the parts of parallels.
    pub parallels: Vec<Vec<DVec2>>,
}

/// A point of a lattice of longitudes and latitudes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LatticePoint {
    /// Longitude and latitude in degrees.
    pub lon_lat: DVec2,
    /// The image.
    pub image: DVec2,
}

/// The box of longitudes and latitudes around a region.
#[derive(Debug, Clone, Copy)]
struct Range {
    /// The longitude relative to which longitudes are counted.
    middle: f64,
    low: DVec2,
    high: DVec2,
    /// The angular radius of the region about its center, in degrees.
    radius: f64,
}

impl Range {
    fn of(projection: &Projection) -> Self {
        let region = projection.region();
        let center = region.frame().center();
        let middle = lon_lat(center).x;
        let offset = |p: &DVec2| DVec2::new((p.x - middle + 180.0).rem_euclid(360.0) - 180.0, p.y);
        let bounds = crate::geometry::Bounds::of(region.lon_lat().iter().map(offset));
        let (mut low, mut high) = (bounds.min(), bounds.max());
        for pole in [-90.0, 90.0] {
            if region.contains(on_sphere(DVec2::new(0.0, pole))) {
                (low.x, high.x) = (-180.0, 180.0);
                (low.y, high.y) = (low.y.min(pole), high.y.max(pole));
            }
        }
        let farthest = region.lon_lat().iter().map(|&p| on_sphere(p).dot(center)).fold(1.0, f64::min);
        Self { middle, low, high, radius: farthest.clamp(-1.0, 1.0).acos().to_degrees() }
    }

    /// The steps of longitude and latitude; no meridians closer to a pole than one step of latitude.
    fn steps(&self) -> DVec2 {
        let nearest = |wanted: f64| STEPS.into_iter().find(|&step| step <= wanted).unwrap_or(STEPS[STEPS.len() - 1]);
        let wanted = 2.0 * self.radius / LINES;
        let parallel = nearest(wanted);
        let widest = if self.low.y < 0.0 && self.high.y > 0.0 { 0.0 } else { self.low.y.abs().min(self.high.y.abs()) };
        let middle = 0.5 * (widest + self.low.y.abs().max(self.high.y.abs()));
        let meridian = nearest((wanted / middle.to_radians().cos().max(0.05)).clamp(parallel, 30.0));
        // a small region around a pole has all longitudes
        let least = (self.high.x - self.low.x) / MOST_MERIDIANS;
        let coarsest = STEPS.into_iter().rev().find(|&step| step >= least).unwrap_or(STEPS[0]);
        DVec2::new(meridian.max(coarsest), parallel)
    }

    /// Multiples of `step` in [low, high].
    fn multiples(step: f64, low: f64, high: f64) -> impl Iterator<Item = f64> {
        let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
        (first..=last).map(move |k| k as f64 * step)
    }

    /// The multiples of `step` among the longitudes of the region, each once.
    fn longitudes(&self, step: f64) -> impl Iterator<Item = f64> + use<> {
        let (low, high) = (self.middle + self.low.x, self.middle + self.high.x);
        Self::multiples(step, low, high.min(low + 360.0 - 1e-9 * step))
    }
}

/// A step along a line: parameter, and the place in degrees.
type Line<'a> = &'a dyn Fn(f64) -> DVec2;

impl Projection {
    /// Meridians and parallels at steps that suit the region.
    pub fn graticule(&self) -> Graticule {
        let range = Range::of(self);
        let steps = range.steps();
        let fine = 2.0 * range.radius / FINE;
        let end = 90.0 - steps.y;
        let mut meridians = Vec::new();
        for longitude in range.longitudes(steps.x) {
            let is_long = (longitude / 90.0).fract() == 0.0;
            let (low, high) = if is_long { (-90.0, 90.0) } else { (-end, end) };
            let ends = [range.low.y.max(low), range.high.y.min(high)];
            meridians.extend(self.parts(&|t| DVec2::new(longitude, t), ends, fine));
        }
        let mut parallels = Vec::new();
        for latitude in Range::multiples(steps.y, range.low.y, range.high.y).filter(|latitude| latitude.abs() < 90.0) {
            let ends = [range.middle + range.low.x, range.middle + range.high.x];
            let step = (fine / latitude.to_radians().cos()).min(5.0);
            parallels.extend(self.parts(&|t| DVec2::new(t, latitude), ends, step));
        }
        Graticule { steps, meridians, parallels }
    }

    /// The points inside of the region whose longitudes and latitudes are multiples of a tenth of the graticule's steps,
    /// by latitude, then by longitude. Longitudes are in (−180, 180].
    pub fn lattice(&self) -> Vec<LatticePoint> {
        let range = Range::of(self);
        let steps = range.steps() / LATTICE;
        let mut points = Vec::new();
        let mut hint = None;
        for latitude in Range::multiples(steps.y, range.low.y, range.high.y).filter(|latitude| latitude.abs() < 90.0) {
            for longitude in range.longitudes(steps.x) {
                let longitude = if longitude > 180.0 { longitude - 360.0 } else { longitude };
                let longitude = if longitude <= -180.0 { longitude + 360.0 } else { longitude };
                let place = DVec2::new(longitude, latitude);
                if let Some(image) = self.drawn(place, &mut hint) {
                    points.push(LatticePoint { lon_lat: place, image });
                }
            }
        }
        points
    }

    /// The image of a point that lies inside.
    fn drawn(&self, place: DVec2, hint: &mut Option<TriangleId>) -> Option<DVec2> {
        let z = self.region.frame().to_plane(on_sphere(place));
        if self.region.signed_distance(z) <= 0.0 {
            return None;
        }
        let (image, triangle) = self.image_in_plane(z, *hint)?;
        *hint = Some(triangle);
        Some(image)
    }

    /// The images of the parts of a line inside of the region, up to the boundary.
    fn parts(&self, line: Line<'_>, [from, to]: [f64; 2], step: f64) -> Vec<Vec<DVec2>> {
        let count = ((to - from) / step).ceil().max(1.0) as u32;
        let at = |k: u32| from + (to - from) * f64::from(k) / f64::from(count);
        let is_inside = |t: f64| self.region.contains(on_sphere(line(t)));
        let mut parts: Vec<Vec<DVec2>> = Vec::new();
        let mut hint = None;
        let mut was_inside = false;
        for k in 0..=count {
            let t = at(k);
            let inside = is_inside(t);
            if k > 0 && inside != was_inside {
                let crossing = crossing(&is_inside, if inside { [t, at(k - 1)] } else { [at(k - 1), t] });
                if inside {
                    parts.push(Vec::new());
                }
                let place = self.drawn(line(crossing), &mut hint);
                parts.iter_mut().last().into_iter().for_each(|part| part.extend(place));
            } else if inside && k == 0 {
                parts.push(Vec::new());
            }
            if inside && let Some(part) = parts.last_mut() {
                part.extend(self.drawn(line(t), &mut hint));
            }
            was_inside = inside;
        }
        parts.retain(|part| part.len() > 1);
        parts
    }
}

/// The last parameter inside, between one inside and one outside.
fn crossing(is_inside: &dyn Fn(f64) -> bool, [mut inside, mut outside]: [f64; 2]) -> f64 {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        if is_inside(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}

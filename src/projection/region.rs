//! A region of the sphere: its boundary on the sphere and in stereographic coordinates about its own center.
//!
//! Edges are straight in longitude and latitude; they are divided until the chords in the plane are off by less than
//! [`CHORD`] of the region's extent. The center is the direction of the region's centroid ∫ p dA = ½ ∮ p × dp; where this
//! vanishes, or its antipode is in the region or next to it, the antipode of the point farthest outside.

use super::error::{Contact, ProjectionError};
use super::ring::{self, Edge, Place};
use super::seam::joined;
use super::sphere::{Stereographic, lon_lat, on_sphere};
use crate::geometry::{DVec2, DVec3, EdgeTree, NearestPoint, PolygonError, SimplePolygon};
use std::f64::consts::PI;

/// The largest deviation of a chord from its edge, in extents of the region.
const CHORD: f64 = 1e-6;

/// The least angular distance in degrees of some point outside from the boundary. At 1° the coordinates reach 115 and
/// the scale of the stereographic projection varies by a factor of 13,000.
pub const LEAST_CLEARANCE: f64 = 1.0;

/// The least 1 + p·c of boundary points p and the center c: 4° from the antipode.
const LEAST_DENOMINATOR: f64 = 2.4e-3;

/// The length in degrees of the longest steps by which the center is found.
const COARSE: f64 = 1.0;

/// The length in degrees up to which the deviation in the middle of an edge stands for all of it.
const LONGEST: f64 = 5.0;

/// The largest length of a chord, in extents of the region: the mesh is as fine along straight edges.
const LONGEST_CHORD: f64 = 0.04;

/// The deepest bisection of an edge.
const DEEPEST: u32 = 14;

/// The number of directions that are tried for a point outside.
const DIRECTIONS: u32 = 2000;

/// What became of the rings of a file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Selection {
    /// The rings that the region is made of, counted from 1: one, or several that a cut along the antimeridian divided.
    pub rings: Vec<usize>,
    /// The number of other regions, which were left out.
    pub left_out: usize,
    /// The number of holes of the region that were filled: boundaries that appeared where its parts were joined.
    pub holes: usize,
    /// The share of the region in the area of all regions, each with its holes.
    pub share: f64,
}

/// A region of the sphere without holes, in stereographic coordinates.
#[derive(Debug, Clone)]
pub struct Region {
    edges: Vec<Edge>,
    frame: Stereographic,
    /// Longitude in (−180, 180] and latitude of the boundary points.
    lon_lat: Vec<DVec2>,
    polygon: SimplePolygon,
    tree: EdgeTree<Vec<DVec2>>,
    selection: Selection,
    area: f64,
}

impl Region {
    /// The largest of the regions that these rings of longitude and latitude in degrees bound, each without the last
    /// point that repeats the first. Holes are filled.
    pub fn new(rings: &[Vec<DVec2>]) -> Result<Self, ProjectionError> {
        let edges = rings.iter().zip(1..).map(|(points, number)| ring::ring(points, number));
        let rings = joined(edges.collect::<Result<_, _>>()?);
        let (largest, area, selection) = select(rings).ok_or(ProjectionError::NoBoundary)?;
        let frame = frame(&largest)?;
        Self::in_frame(largest, frame, selection, area)
    }

    /// The same region in stereographic coordinates about another center, whose antipode is outside.
    pub(super) fn about(self, center: DVec3) -> Result<Self, ProjectionError> {
        Self::in_frame(self.edges, Stereographic::about(center), self.selection, self.area)
    }

    fn in_frame(
        edges: Vec<Edge>,
        frame: Stereographic,
        selection: Selection,
        area: f64,
    ) -> Result<Self, ProjectionError> {
        let (lon_lat, places) = divided(&edges, frame);
        let plane: Vec<DVec2> = lon_lat.iter().map(|&p| frame.to_plane(on_sphere(p))).collect();
        let polygon = SimplePolygon::try_from(plane).map_err(|error| refused(error, frame, &places))?;
        if polygon.was_clockwise() {
            return Err(ProjectionError::NoBoundary);
        }
        let tree = EdgeTree::new(polygon.vertices().to_vec());
        Ok(Self { edges, frame, lon_lat, polygon, tree, selection, area })
    }

    /// The stereographic coordinates.
    pub fn frame(&self) -> Stereographic {
        self.frame
    }

    /// The boundary in stereographic coordinates, counter-clockwise.
    pub fn polygon(&self) -> &SimplePolygon {
        &self.polygon
    }

    /// Longitude in (−180°, 180°] and latitude of the boundary's points, in the polygon's order.
    pub fn lon_lat(&self) -> &[DVec2] {
        &self.lon_lat
    }

    /// The rings that were taken.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// The area on the unit sphere, holes filled.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The distance of a point of the plane from the boundary, positive inside.
    pub fn signed_distance(&self, z: DVec2) -> f64 {
        self.tree.signed_distance(z)
    }

    /// The boundary's point nearest to a point of the plane.
    pub fn nearest_point(&self, z: DVec2) -> NearestPoint {
        self.tree.nearest_point(z)
    }

    /// Whether a point of the sphere lies inside.
    pub fn contains(&self, p: DVec3) -> bool {
        let z = self.frame.to_plane(p);
        z.is_finite() && self.tree.signed_distance(z) > 0.0
    }
}

/// The outer boundary of the largest region, holes filled.
fn select(rings: Vec<Vec<Edge>>) -> Option<(Vec<Edge>, f64, Selection)> {
    let mut regions: Vec<Joined> = Vec::new();
    for ring in rings {
        let mut numbers: Vec<usize> = ring.iter().map(|edge| edge.place.ring).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let joined = Joined { area: ring::area(&ring), outer: ring, numbers, holes: 0 };
        // boundaries with parts of one ring of the file are those of one region
        let is_same = |other: &mut Joined| other.numbers.iter().any(|n| joined.numbers.contains(n));
        let same: Vec<Joined> = regions.extract_if(.., is_same).collect();
        let joined = same.into_iter().fold(joined, Joined::with);
        regions.push(joined);
    }
    let total: f64 = regions.iter().map(|region| region.area).sum();
    let left_out = regions.len().checked_sub(1)?;
    let Joined { outer, area, numbers, holes } =
        regions.into_iter().reduce(|a, b| if b.area > a.area { b } else { a })?;
    (area > 0.0).then_some((outer, area, Selection { rings: numbers, left_out, holes, share: area / total }))
}

/// A region whose parts were joined: its outer boundary, with everything else on the left of which its holes lie.
struct Joined {
    outer: Vec<Edge>,
    /// The area on the left of the outer boundary.
    area: f64,
    /// The rings of the file, ascending.
    numbers: Vec<usize>,
    holes: usize,
}

impl Joined {
    /// One region with both boundaries. On the left of a hole's lies all but the hole, which is more than what the outer
    /// boundary encloses.
    fn with(self, other: Self) -> Self {
        let holes = self.holes + other.holes + 1;
        let mut numbers = [self.numbers, other.numbers].concat();
        numbers.sort_unstable();
        numbers.dedup();
        let (outer, area) = if other.area < self.area { (other.outer, other.area) } else { (self.outer, self.area) };
        Self { outer, area, numbers, holes }
    }
}

/// Stereographic coordinates in which infinity is outside, and not next to the boundary.
fn frame(edges: &[Edge]) -> Result<Stereographic, ProjectionError> {
    let points: Vec<DVec3> = edges.iter().flat_map(|edge| coarse(edge, COARSE)).map(|(edge, t)| edge.at(t)).collect();
    let n = points.len();
    let origin = points[0];
    let terms = (0..n).map(|k| (points[k] - origin).cross(points[(k + 1) % n] - origin));
    // relative to one point, since small regions would lose their digits
    let centroid = terms.sum::<DVec3>();
    if let Some(center) = centroid.try_normalize()
        && is_outside_at_infinity(&points, center)
        && points.iter().all(|p| 1.0 + p.dot(center) > LEAST_DENOMINATOR)
    {
        return Ok(Stereographic::about(center));
    }
    let clearance = |q: DVec3| points.iter().map(|p| p.dot(q)).fold(-1.0, f64::max).clamp(-1.0, 1.0).acos();
    let outside = directions().filter(|&q| is_outside_at_infinity(&points, -q)).map(|q| (q, clearance(q)));
    let (q, distance) = outside.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((DVec3::Z, 0.0));
    if distance.to_degrees() < LEAST_CLEARANCE {
        return Err(ProjectionError::NearlyWholeSphere { clearance: distance.to_degrees() });
    }
    Ok(Stereographic::about(-q))
}

/// Whether the antipode of `center` lies to the right of the closed chain: its image in the plane is counter-clockwise.
fn is_outside_at_infinity(points: &[DVec3], center: DVec3) -> bool {
    let frame = Stereographic::about(center);
    let plane: Vec<DVec2> = points.iter().map(|&p| frame.to_plane(p)).collect();
    let n = plane.len();
    let twice: f64 = (0..n).map(|k| (plane[k] - plane[0]).perp_dot(plane[(k + 1) % n] - plane[0])).sum();
    twice > 0.0
}

/// Directions that cover the sphere evenly (Fibonacci's lattice).
fn directions() -> impl Iterator<Item = DVec3> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    (0..DIRECTIONS).map(move |k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(DIRECTIONS);
        let (radius, angle) = ((1.0 - z * z).sqrt(), golden * f64::from(k));
        DVec3::new(radius * angle.cos(), radius * angle.sin(), z)
    })
}

/// Equal steps of at most `length` degrees along an edge.
fn coarse(edge: &Edge, length: f64) -> impl Iterator<Item = (&Edge, f64)> {
    let steps = (edge.step.abs().max_element() / length).ceil().max(1.0);
    (0..steps as u32).map(move |k| (edge, f64::from(k) / steps))
}

/// The boundary's points with the edges that they are on.
fn divided(edges: &[Edge], frame: Stereographic) -> (Vec<DVec2>, Vec<Place>) {
    let ends = edges.iter().map(|edge| frame.to_plane(edge.at(0.0)));
    let extent = ends.map(DVec2::length).fold(0.0, f64::max).min(1.0);
    let mut shares = Vec::new();
    for edge in edges {
        let starts: Vec<f64> = coarse(edge, LONGEST).map(|(_, t)| t).collect();
        for (k, &start) in starts.iter().enumerate() {
            let end = starts.get(k + 1).copied().unwrap_or(1.0);
            bisect(edge, frame, [start, end], extent, DEEPEST, &mut |t| shares.push((edge, t)));
        }
    }
    let is_normal = |p: DVec2| -180.0 < p.x && p.x <= 180.0;
    let normal = |p: DVec2| if is_normal(p) { p } else { DVec2::new(180.0 - (180.0 - p.x).rem_euclid(360.0), p.y) };
    let points = shares.iter().map(|(edge, t)| normal(edge.lon_lat(*t))).collect();
    (points, shares.iter().map(|(edge, _)| edge.place).collect())
}

/// Emits shares of an edge from `from` on, without `to`, such that chords are short, and edges off by little: by
/// [`LONGEST_CHORD`] and [`CHORD`] of `extent`.
fn bisect(edge: &Edge, frame: Stereographic, [from, to]: [f64; 2], extent: f64, depth: u32, emit: &mut dyn FnMut(f64)) {
    let middle = 0.5 * (from + to);
    let [a, m, b] = [from, middle, to].map(|t| frame.to_plane(edge.at(t)));
    let scale = extent * (1.0 + m.length_squared());
    let is_straight = m.distance(a.midpoint(b)) <= CHORD * scale;
    let is_short = a.distance(b) <= LONGEST_CHORD * scale;
    if depth == 0 || is_straight && is_short {
        return emit(from);
    }
    bisect(edge, frame, [from, middle], extent, depth - 1, emit);
    bisect(edge, frame, [middle, to], extent, depth - 1, emit);
}

/// The polygon's error with its place on the sphere and in the file.
fn refused(error: PolygonError, frame: Stereographic, places: &[Place]) -> ProjectionError {
    let at = |z: DVec2| lon_lat(frame.to_sphere(z));
    let not_simple = |contact: Contact, z: DVec2, [first, second]: [usize; 2]| ProjectionError::NotSimple {
        contact,
        at: at(z),
        first: places[first],
        second: places[second],
    };
    match error {
        PolygonError::EdgesCross { first, second, at } => not_simple(Contact::Crosses, at, [first, second]),
        PolygonError::EdgesTouch { first, second, at } | PolygonError::RepeatedPoint { first, second, at } => {
            not_simple(Contact::Touches, at, [first, second])
        }
        PolygonError::FoldsBack { index, at } => {
            let before = (index + places.len() - 1) % places.len();
            not_simple(Contact::Touches, at, [before, index])
        }
        other => ProjectionError::Polygon(other),
    }
}
